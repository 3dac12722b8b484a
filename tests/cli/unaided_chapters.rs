//! Notes without a claims file that treat several systems, as chapters of textbooks do: each example has its own Lagrangian and
//! coordinates, and uses letters of another one again.

use crate::chapters::{
    BLOCKS, ENVIRONMENTS, HEADINGS, METHOD, NOTATION, PARAGRAPHS, SAME_LETTERS, SECTIONS, SPOKEN, UNMARKED,
};
use crate::support::Desk;

/// The verdict of each display of notes, in a file with this name.
fn verdicts(name: &str, file: &str, notes: &str) -> Vec<String> {
    let desk = Desk::new(&format!("unaided-chapters-{name}"));
    desk.write(file, notes);
    let report = desk.onshell(&["check", file, "--format", "json"]).json();
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    equations.iter().map(|equation| equation["verdict"].as_str().expect("a verdict").to_owned()).collect()
}

/// Checks that the displays of true notes have these verdicts, d for definition, c for certified, v for verified and a for assumed, and that
/// each slip makes the display at its place wrong, and no other one.
fn check(name: &str, file: &str, notes: &str, expected: &str, slips: &[(usize, &str, &str)]) {
    let letters = |found: &[String]| -> String { found.iter().filter_map(|verdict| verdict.chars().next()).collect() };
    assert_eq!(letters(&verdicts(name, file, notes)), expected, "{name}");
    for (at, right, wrong) in slips {
        assert_eq!(notes.matches(right).count(), 1, "“{right}” in {name}");
        let found = verdicts(&format!("{name}-slip"), file, &notes.replace(right, wrong));
        let places: Vec<usize> = (0..found.len()).filter(|at| found[*at] == "refuted").collect();
        assert_eq!(places, [*at], "“{wrong}” in {name}: {found:?}");
    }
}

#[test]
fn each_section_with_a_lagrangian_is_checked_as_a_page_of_its_own() {
    let slips = [
        (2, r"m \ddot x = -k x", r"m \ddot x = k x"),
        (7, "-m g l \\sin\\theta\n", "m g l \\sin\\theta\n"),
        (8, r"-\frac{g}{l} \sin", r"\frac{g}{l} \sin"),
        (10, r"\cos\theta - \frac{g}{R}", r"\cos\theta + \frac{g}{R}"),
        (12, r"p_\theta = m r^2", r"p_\theta = m r"),
        (15, r"{m_1 + m_2} g", r"{m_1 + m_2} 2 g"),
    ];
    check("headings", "notes.md", HEADINGS, "ddcddddccdcdccdc", &slips);
    let slips = [
        (4, r"= m l^2 \dot", r"= 2 m l^2 \dot"),
        (5, r"+ m g l \sin", r"- m g l \sin"),
        (8, r"\frac23 g", r"\frac32 g"),
    ];
    check("sections", "notes.tex", SECTIONS, "ddddccdcc", &slips);
}

#[test]
fn a_lagrangian_of_other_coordinates_is_that_of_another_system() {
    let slips = [
        (1, r"\dot\phi^2 - g", r"\dot\phi^2 + g"),
        (5, r"\frac57 g \sin", r"\frac57 g \cos"),
        (7, "= k (x_2 - x_1)", "= k (x_1 - x_2)"),
    ];
    check("paragraphs", "notes.md", PARAGRAPHS, "dcdddcdc", &slips);
    let slips = [(3, r"-m g a \sin", r"m g a \sin"), (5, r"= -\kappa", r"= \kappa")];
    check("same-letters", "notes.md", SAME_LETTERS, "dcdcdc", &slips);
}

#[test]
fn an_example_is_a_system() {
    let slips = [(4, "+ 2 g a x", "- 2 g a x"), (6, "-k x + e E\n", "-k x - e E\n")];
    check("environments", "notes.tex", ENVIRONMENTS, "dcdccdc", &slips);
    let slips = [(7, r"- m l \dot\theta^2 \sin", r"+ m l \dot\theta^2 \sin"), (8, r"+ g \sin", r"- g \sin")];
    check("blocks", "notes.md", BLOCKS, "ddcddddcc", &slips);
    let slips = [(1, r"+ \frac{k}{r^2} .", r"- \frac{k}{r^2} ."), (3, "+ k r .", "- k r .")];
    check("spoken", "notes.md", SPOKEN, "dcdcdvdv", &slips);
}

/// What stands before all systems holds in each; what one example defines is unknown in the next.
#[test]
fn general_definitions_are_carried_over_and_those_of_an_example_are_not() {
    check("notation", "notes.md", NOTATION, "ddcddca", &[(5, r"\omega_0^2 z - g", r"\omega_0^2 z + g")]);
    let slips = [(3, r"= g \sin\alpha", r"= -g \sin\alpha"), (6, r"- \frac{g}{l}", r"+ \frac{g}{l}")];
    check("method", "notes.md", METHOD, "dddcddc", &slips);
}

/// A section without a Lagrangian, beside others with one, may be about another system; a step of the treatment is not.
#[test]
fn what_may_be_about_another_system_is_taken_for_granted() {
    check("unmarked", "notes.md", UNMARKED, "dcdca", &[(3, r"= -\frac{g}{l}", r"= \frac{g}{l}")]);
    let two = SPOKEN_POTENTIALS.replace("TURNS", r"\alpha n r_m^{n+2} = \frac{l^2}{\mu}");
    assert!(!verdicts("turning", "notes.md", &two).contains(&"refuted".to_owned()));
    let labels = "Spring:\n\n$$ \\omega = \\sqrt{\\frac{k}{m}} $$\n\nPendulum:\n\n$$ \\omega = \\sqrt{\\frac{g}{L}} $$\n\n\
                  $$ \\frac{k}{m} = \\frac{g}{L} $$\n";
    assert_eq!(verdicts("labels", "notes.md", labels), ["definition", "definition", "assumed"]);
}

const SPOKEN_POTENTIALS: &str = r"First example. The effective potential is

$$ U(r) = \frac{l^2}{2\mu r^2} - \frac{\alpha}{r^n} $$

$$ U'(r) = -\frac{l^2}{\mu r^3} + \frac{\alpha n}{r^{n+1}} = 0 $$

at

$$ r_m = \left(\frac{l^2}{n\alpha \mu}\right)^{\frac{1}{2-n}} $$

Second example. The effective potential is

$$ U(r) = \frac{l^2}{2\mu r^2} + \alpha r^n $$

A circular orbit needs

$$ U'(r_m) = -\frac{l^2}{\mu r_m^3} + \alpha n r_m^{n-1} = 0 $$

that is

$$ TURNS $$
";

/// The Euler–Lagrange equation in q is not about a Lagrangian without q, whatever its signs are; nor is what uses its momentum.
#[test]
fn a_general_law_is_introduced_and_not_certified_by_zeros() {
    let pendulum = r"$$ L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta $$";
    for law in [
        r"$$ \frac{d}{dt}\frac{\partial L}{\partial \dot q} - \frac{\partial L}{\partial q} = 0 $$",
        r"$$ \frac{d}{dt}\frac{\partial L}{\partial \dot q_i} + 3 \frac{\partial L}{\partial q_i} = 0 $$",
    ] {
        let motion = r"$$ l \ddot\theta = -g \sin\theta $$";
        let after = verdicts("law-after", "notes.md", &[pendulum, law, motion].join("\n\n"));
        assert_eq!(after, ["definition", "definition", "certified"], "{law}");
        let before = verdicts("law-before", "notes.md", &[law, pendulum, motion].join("\n\n"));
        assert_eq!(before, ["definition", "definition", "certified"], "{law}");
    }
    let momentum = [pendulum, r"$$ p = \frac{\partial L}{\partial \dot q} $$", r"$$ 2 p = -3 p $$"].join("\n\n");
    assert!(!["certified", "verified", "refuted"].contains(&verdicts("momentum", "notes.md", &momentum)[2].as_str()));
}

/// L with its arguments is L, and `L = T - V` may stand before T and V.
#[test]
fn a_lagrangian_with_arguments_is_the_same() {
    let notes = |derivative: &str| {
        let displays = [
            r"\mathcal{L}(q, \dot q, t) = T - V",
            r"T = \frac12 m L^2 \dot\theta^2",
            r"V = m g L (1 - \cos\theta)",
            r"\mathcal{L}(\theta, \dot\theta) = \frac12 m L^2 \dot\theta^2 - m g L (1 - \cos\theta)",
            derivative,
        ];
        displays.map(|latex| format!("$$ {latex} $$\n\n")).concat()
    };
    let last = |name: &str, derivative: &str| verdicts(name, "notes.md", &notes(derivative)).pop().unwrap_or_default();
    assert_eq!(last("arguments", r"\frac{\partial \mathcal{L}}{\partial \theta} = -m g L \sin\theta"), "certified");
    assert_eq!(last("arguments-slip", r"\frac{\partial \mathcal{L}}{\partial \theta} = m g L \sin\theta"), "refuted");
}

/// An acceleration a in a Lagrangian is constant, though the solution is ẍ = a.
#[test]
fn a_constant_of_a_lagrangian_may_be_equal_to_an_acceleration() {
    let notes = |force: &str| {
        format!(
            "The Lagrangian is\n\n$$ \\mathcal{{L}} = \\frac12 m (\\dot x + v_0 - a t)^2 $$\n\n\
             $$ \\frac{{d}}{{dt}}\\left(\\frac{{\\partial \\mathcal{{L}}}}{{\\partial \\dot x}}\\right) = {force} $$\n\n\
             $$ \\frac{{d^2 x}}{{dt^2}} = a $$\n"
        )
    };
    assert_eq!(verdicts("bus", "notes.md", &notes(r"m (\ddot x - a)")), ["definition", "certified", "certified"]);
    assert_eq!(verdicts("bus-slip", "notes.md", &notes(r"m (\ddot x + a)"))[1], "refuted");
}
