//! Notes without a claims file: what a display is judged by. The other side of an arrow, formulas in sentences, single
//! statements of a display.

use serde_json::Value;

use crate::support::{self, Desk};

/// The verdicts on the displays of a page.
fn verdicts(name: &str, notes: &str) -> Vec<String> {
    support::verdicts(&format!("premises-{name}"), notes)
}

#[test]
fn what_stands_after_an_arrow_is_judged_by_what_stands_before_it() {
    let balance = |arrow: &str, speed: &str| {
        format!(
            "The forces balance,\n$$ m g = \\frac12 \\rho C A v^2 {arrow} v = \\sqrt{{\\frac{{{speed}}}{{\\rho C A}}}}. $$\n"
        )
    };
    for arrow in [
        r"\quad\Rightarrow\quad",
        r"\implies",
        r"\qquad\text{so}\qquad",
        r"\quad\text{ thus }\quad",
        r"\quad\mbox{hence}\quad",
        r"\\ \therefore\;",
        r"\iff",
    ] {
        let right = verdicts("arrow", &balance(arrow, "2 m g"));
        assert_eq!(right.len(), 2, "{arrow}");
        assert!(right.iter().all(|verdict| verdict != "refuted"), "{arrow}: {right:?}");
        assert_eq!(verdicts("arrow-slip", &balance(arrow, "m g"))[1], "refuted", "{arrow}");
    }
    // Beside the statement nothing says that the one follows from the other.
    assert_eq!(verdicts("beside", &balance(r",\qquad", "m g")).len(), 1);
}

#[test]
fn the_number_of_a_display_is_that_of_its_conclusion() {
    let desk = Desk::new("premises-number");
    desk.write("notes.md", "A gas:\n$$ p V = N k T \\implies p = \\frac{N k V}{T} \\tag{4} $$\n");
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).expect("a report");
    let found = &report["documents"][0]["equations"];
    assert_eq!((&found[0]["id"], &found[1]["id"]), (&Value::from("L2"), &Value::from("4")));
    assert_eq!(found[1]["verdict"], "refuted");
    assert_eq!(found[1]["repairs"][0]["replacement"], "T}{V");
}

#[test]
fn a_formula_in_a_sentence_is_a_premise_of_the_next_display() {
    let otto = |said: &str, result: &str| {
        format!(
            "$$ Q = C(T_3 - T_2) $$\n$$ P = C(T_4 - T_1) $$\n\n{said}\n\n\
             $$ \\eta = 1 - \\frac{{T_4 - T_1}}{{T_3 - T_2}} = {result}. $$\n"
        )
    };
    let said = "Both adiabats have the same ratio, $T_3 - T_2 = (T_4 - T_1) r^{\\gamma - 1}$. Then";
    assert_eq!(verdicts("otto", &otto(said, r"1 - r^{1 - \gamma}"))[2], "verified");
    assert_eq!(verdicts("otto-slip", &otto(said, r"1 - r^{\gamma - 1}"))[2], "refuted");
    // Without it nothing speaks against the result.
    assert_eq!(verdicts("otto-alone", &otto("Then", r"1 - r^{\gamma - 1}"))[2], "assumed");
}

#[test]
fn a_name_that_a_sentence_gives_another_formula_makes_no_slip() {
    let page = |said: &str| {
        format!(
            "$$ \\beta = \\frac{{v}}{{c}} $$\n$$ \\gamma = \\frac{{1}}{{\\sqrt{{1 - \\beta^2}}}} $$\n\n\
             $$ x = \\gamma(y - v t) + u $$\n\n{said}\n\n$$ \\gamma^2 m^2 c^4\\left(1 - \\frac{{u^2}}{{c^2}}\\right) = m^2 c^4 $$\n"
        )
    };
    let again = r"From here on $\gamma = (1 - u^2/c^2)^{-1/2}$ belongs to the particle. Squared, this gives";
    assert!(!verdicts("again", &page(again)).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("same", &page("Squared, this gives"))[3], "refuted");
}

#[test]
fn a_condition_at_the_end_of_a_chain_is_no_claim() {
    // The curve has two statements. With the place of the peak for a letter, "= 0" would follow from them.
    let peak = |end: &str| {
        format!(
            "$$ A = \\frac{{F}}{{\\sqrt{{(q^2 - p^2)^2 + b^2 p^2}}}}, \\qquad \\tan\\delta = \\frac{{b p}}{{q^2 - p^2}} \\tag{{2}} $$\n\n\
             Where is the root in (2) smallest? Differentiate:\n\n\
             $$ \\frac{{d}}{{dp}}\\left[(q^2 - p^2)^2 + b^2 p^2\\right] = {end} , $$\n\n$$ p_r^2 = q^2 - \\frac{{b^2}}{{2}} . $$\n"
        )
    };
    let right = verdicts("peak", &peak(r"-4 p(q^2 - p^2) + 2 b^2 p = 0"));
    assert!(!right.contains(&"refuted".to_owned()), "{right:?}");
    assert_eq!(verdicts("peak-slip", &peak(r"4 p(q^2 - p^2) + 2 b^2 p"))[1], "refuted");
}

#[test]
fn what_stands_between_bars_is_negative() {
    let ellipse = |axis: &str| {
        format!(
            "$$ p = \\frac{{M^2}}{{m\\alpha}}, \\qquad e = \\sqrt{{1 + \\frac{{2EM^2}}{{m\\alpha^2}}}} $$\n\nThe orbit is an ellipse with\n\n\
             $$ a = \\frac{{p}}{{1 - e^2}} = {axis} $$\n"
        )
    };
    assert_ne!(verdicts("bars", &ellipse(r"\frac{\alpha}{2|E|}"))[1], "refuted");
    assert_eq!(verdicts("bars-slip", &ellipse(r"\frac{\alpha}{|E|}"))[1], "refuted");
}

#[test]
fn one_relation_between_many_symbols_is_enough_for_a_slip() {
    let momenta = |square: &str| {
        format!(
            "$$ p = b\\cos\\theta + a\\cos\\phi \\tag{{1}} $$\n\n$$ 0 = b\\sin\\theta - a\\sin\\phi \\tag{{2}} $$\n\n\
             Now square and add.\n\n$$ {square} $$\n"
        )
    };
    let right = verdicts("squared", &momenta(r"a^2 = p^2 + b^2 - 2pb\cos\theta"));
    assert!(matches!(right[2].as_str(), "verified" | "certified"), "{right:?}");
    assert_eq!(verdicts("squared-slip", &momenta(r"a^2 = p^2 + b^2 + 2pb\cos\theta"))[2], "refuted");
    // Another relation of the same names that is no slip away.
    assert_eq!(verdicts("squared-other", &momenta(r"a^2 = p b \cos\theta"))[2], "assumed");
}

#[test]
fn an_equation_for_a_new_name_is_no_slip_for_another_one() {
    let page = r"$$ \omega_s = \sqrt{\frac{k}{m}}, \qquad \omega_f = \sqrt{\frac{k + 2\kappa}{m}} $$

Try $x_1 = Ae^{i\omega t}$. A solution needs a vanishing determinant,

$$ (k + \kappa - m\omega^2)^2 - \kappa^2 = 0 \quad\Longrightarrow\quad k + \kappa - m\omega^2 = \pm\kappa $$
";
    let found = verdicts("secular", page);
    assert!(!found.contains(&"refuted".to_owned()), "{found:?}");
}

#[test]
fn a_chain_is_not_corrected_with_the_name_that_it_introduces() {
    let action = |value: &str| {
        format!(
            "$$ J = \\frac{{1}}{{2\\pi}}\\oint p\\,dq = \\frac{{P}}{{\\pi}}\\int_0^{{2\\pi}}\\cos^2 Q\\,dQ = {value} $$\n"
        )
    };
    assert_eq!(verdicts("action", &action("P"))[0], "assumed");
    assert_eq!(verdicts("action-slip", &action(r"\frac{P}{2}"))[0], "refuted");
}

#[test]
fn beside_a_lagrangian_relations_between_constants_are_judged_as_elsewhere() {
    let orbit = |axis: &str| {
        format!(
            "The Lagrangian is\n\n$$ L = \\frac{{m}}{{2}}(\\dot r^2 + r^2\\dot\\varphi^2) + \\frac{{k}}{{r}} $$\n\nThe apsides are\n\n\
             $$ r_1 = \\frac{{p}}{{1 + e}}, \\qquad r_2 = \\frac{{p}}{{1 - e}} $$\n\nHence\n\n$$ 2a = r_1 + r_2 = {axis} $$\n"
        )
    };
    let right = verdicts("axis", &orbit(r"\frac{2p}{1 - e^2}"));
    assert!(!right.contains(&"refuted".to_owned()), "{right:?}");
    assert_eq!(verdicts("axis-slip", &orbit(r"\frac{p}{1 - e^2}"))[2], "refuted");
}

#[test]
fn words_count_in_other_languages_too() {
    let page = |words: &str| format!("$$ m a = F - k v $$\n\n{words}\n\n$$ F = m a - k v $$\n");
    for (name, words) in [("de", "Daraus folgt"), ("fr", "On obtient donc"), ("es", "Por lo tanto"), ("en", "Hence")] {
        // Each of the two contradicts the other one.
        assert_eq!(verdicts(name, &page(words))[1], "undecided", "{words}");
    }
    for (name, words) in [
        ("de-if", "Wenn die Reibung antreibt, gilt"),
        ("fr-if", "Si au contraire le frottement entraîne le corps"),
        ("es-if", "Cuando el rozamiento empuja"),
        ("en-if", "If the friction drives the body"),
    ] {
        assert_eq!(verdicts(name, &page(words))[1], "assumed", "{words}");
    }
}

#[test]
fn a_lost_dot_spoils_the_dimensions() {
    let axes = |rate: &str| {
        format!(
            "In turning axes\n\n$$ \\ddot x - 2\\omega\\dot y - \\omega^2 x = f $$\n\n$$ \\ddot y + 2\\omega {rate} - \\omega^2 y = g $$\n\n\
             $$ u = \\dot x - \\omega y $$\n\n$$ v = \\dot y + \\omega x $$\n\n\
             $$ w^2 = (\\dot x - \\omega y)^2 + (\\dot y + \\omega x)^2 $$\n"
        )
    };
    assert_eq!(verdicts("dot", &axes(r"\dot x"))[1], "assumed");
    assert_eq!(verdicts("dot-slip", &axes("x"))[1], "refuted");
    // A constant that has other units in another solution is no lost dot on the time.
    let damped = r"The equation is

$$ \ddot x + 2\kappa\dot x + \omega_0^2 x = 0 $$

For strong damping

$$ x = c_1 e^{-\kappa_1 t} + c_2 e^{-\kappa_2 t} $$

$$ \dot x = -\kappa_1 c_1 e^{-\kappa_1 t} - \kappa_2 c_2 e^{-\kappa_2 t} $$

For critical damping $\kappa = \omega_0$ the general solution is

$$ x = c_1 e^{-\kappa t} + c_2 t e^{-\kappa t} $$
";
    assert!(!verdicts("critical", damped).contains(&"refuted".to_owned()));
}

#[test]
fn planck_s_two_constants_are_one() {
    let levels =
        |factor: u32| format!("$$ E = \\frac{{n^2\\pi^2\\hbar^2}}{{2mL^2}} = \\frac{{n^2h^2}}{{{factor}mL^2}} $$\n");
    let right = verdicts("planck", &levels(8));
    assert!(matches!(right[0].as_str(), "verified" | "certified"), "{right:?}");
    assert_eq!(verdicts("planck-slip", &levels(4))[0], "refuted");
}

#[test]
fn a_correction_that_prints_another_relation_is_no_slip() {
    // γ is printed without its formula, and every relation becomes an identity with a factor of it.
    assert_eq!(verdicts("lorentz", "$$ \\gamma(1 - \\beta^2) = \\frac{1}{\\gamma} $$\n")[0], "assumed");
    // A root of an equation with ± goes with one of its signs.
    let widths = "$$ \\omega L - \\frac{1}{\\omega C} = \\pm R $$\n\nwith the solutions\n\n\
                  $$ \\omega_\\pm = \\pm\\frac{R}{2L} + \\sqrt{\\frac{R^2}{4L^2} + \\frac{1}{LC}} $$\n";
    assert!(!verdicts("widths", widths).contains(&"refuted".to_owned()));
    // Authors leave the sign of dρ open.
    let sphere = |value: &str| {
        format!(
            "$$ d\\sigma = 2\\pi\\rho\\,d\\rho = 2\\pi\\rho\\left|\\frac{{d\\rho}}{{d\\chi}}\\right| d\\chi $$\n\nFor a sphere\n\n\
             $$ \\rho = R\\cos\\frac{{\\chi}}{{2}} $$\n\nhence\n\n$$ d\\sigma = {value} $$\n"
        )
    };
    assert_eq!(verdicts("sphere", &sphere(r"\frac12\pi R^2\sin\chi\,d\chi"))[2], "assumed");
}

#[test]
fn a_step_of_a_chain_is_judged_beside_an_unknown_derivative() {
    let slope = |number: u32| {
        format!(
            "$$ \\frac{{d^2 B}}{{dz^2}} = -3\\left[\\frac{{1}}{{(a^2+z^2)^{{5/2}}}} - \\frac{{{number}z^2}}{{(a^2+z^2)^{{7/2}}}}\\right] \
             = 3\\,\\frac{{4z^2-a^2}}{{(a^2+z^2)^{{7/2}}}} $$\n"
        )
    };
    assert_ne!(verdicts("slope", &slope(5))[0], "refuted");
    assert_eq!(verdicts("slope-slip", &slope(3))[0], "refuted");
}

#[test]
fn what_may_not_hold_is_no_premise() {
    let last = |name: &str, displays: &[&str]| {
        let notes: String = displays.iter().map(|display| format!("$$ {display} $$\n\n")).collect();
        verdicts(name, &notes).pop().unwrap_or_default()
    };
    let follows = |verdict: String| ["certified", "verified"].contains(&verdict.as_str());
    let conclusion = "x + y = 9";
    // One of two values, one of two statements, and a value at a place alone.
    for first in [r"x = 3 \pm 2", r"x = 5 \quad\text{or}\quad x = -2", r"x = 5 \quad\text{at}\quad z = 1"] {
        assert!(!follows(last("may-hold", &[first, "y = 4", conclusion])), "{first}");
    }
    for first in ["x = 3 + 2", "x = 5", r"x = 5, \quad z = 1"] {
        assert!(follows(last("holds", &[first, "y = 4", conclusion])), "{first}");
    }
    // A matrix of an eigenvalue equation is no number.
    assert!(!follows(last("matrix", &[r"A\mathbf{v} = \lambda\mathbf{v}", r"A = \lambda"])));
    assert!(follows(last("number", &[r"a x = \lambda x", r"a = \lambda"])));
}

#[test]
fn words_of_solving_announce_what_follows() {
    let lens = |words: &str, sign: &str| {
        format!(
            "A lens of focal length $f$, with the distances $g$ and $b$:\n\n$$ \\frac1f = \\frac1g + \\frac1b $$\n\n\
             {words},\n\n$$ b = \\frac{{f g}}{{g {sign} f}} $$\n"
        )
    };
    for words in ["Solved for the image distance", "Aufgelöst nach der Bildweite", "also"] {
        let last = |sign: &str| verdicts("lens", &lens(words, sign)).pop().unwrap_or_default();
        assert!(["certified", "verified"].contains(&last("-").as_str()), "{words}");
        assert!(["refuted", "undecided"].contains(&last("+").as_str()), "{words}: {}", last("+"));
    }
    // Other words leave it open: another lens may be meant.
    assert_eq!(verdicts("lens-other", &lens("For another lens", "+")).pop().unwrap_or_default(), "assumed");
}

#[test]
fn a_matrix_that_a_formula_gives_is_computed() {
    let square = |entry: &str| {
        format!(
            "$$ A = \\begin{{pmatrix}} 2 & -1 \\\\ -1 & 3 \\end{{pmatrix}} $$\n\nThe square of $A$ is\n\n\
             $$ A^2 = \\begin{{pmatrix}} 5 & {entry} \\\\ -5 & 10 \\end{{pmatrix}} $$\n"
        )
    };
    assert_eq!(verdicts("square", &square("-5"))[1], "certified");
    assert_eq!(verdicts("square-slip", &square("5"))[1], "refuted");
    // No single edit makes a product of it: it may be another matrix.
    assert_ne!(verdicts("square-other", &square("77").replace("10", "31"))[1], "refuted");
}

#[test]
fn beside_a_lagrangian_words_say_what_a_name_is() {
    let notes = |energy: &str, frequency: &str| {
        format!(
            "A pendulum of mass $m$ and length $l$.\n\n$$ L = \\frac12 m l^2\\dot\\theta^2 + m g l\\cos\\theta $$\n\n\
             The energy is conserved,\n\n$$ E = \\frac12 m {energy}\\dot\\theta^2 - m g l\\cos\\theta $$\n\n\
             The frequency of small oscillations is\n\n$$ \\omega^2 = {frequency} $$\n"
        )
    };
    let found = |energy: &str, frequency: &str| verdicts("words", &notes(energy, frequency));
    let right = found("l^2", "\\frac gl");
    assert!(right.iter().skip(1).all(|verdict| ["certified", "verified"].contains(&verdict.as_str())), "{right:?}");
    assert_eq!(found("l", "\\frac gl")[1], "refuted");
    assert_eq!(found("l^2", "\\frac{g}{2l}")[2], "refuted");
    // From the top the sign is another one; the words mean the place below.
    let from_above = notes("l^2", "\\frac gl").replace("m g l\\cos\\theta", "(-m g l\\cos\\theta)");
    assert_ne!(verdicts("words-above", &from_above)[2], "refuted");
    // Another quantity altogether is no slip.
    assert_ne!(found("l^2", "\\frac{3 k}{7 M} + \\Omega^2")[2], "refuted");
}
