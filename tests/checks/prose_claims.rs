//! Claims that the words around displays make, beside a claims file that declares no more than coordinates, constants and L.

use onshell::Code;
use onshell::check::{Document, Equation, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::document;

/// A bead on a hoop that turns.
const HOOP: &str = r"A bead of mass $m$ slides on a hoop of radius $a$, which turns about its vertical diameter.

$$ L = \frac12 m a^2\left(\dot\theta^2 + \omega^2\sin^2\theta\right) + m g a\cos\theta \tag{1} $$

There is an equilibrium at $\theta_0$ with

$$ \cos\theta_0 = \frac{g}{a\omega^2} \tag{2} $$

The frequency of small oscillations about it is

$$ \Omega^2 = \omega^2\sin^2\theta_0 \tag{3} $$

or

$$ \Omega = \sqrt{\omega^2 - \frac{g^2}{a^2\omega^2}} \tag{4} $$
";

/// A particle in a bowl, and its circular motion.
const BOWL: &str = r"$$ L = \frac12 m\left(\left(1 + \frac{r^2}{a^2}\right)\dot r^2 + r^2\dot\phi^2\right) - \frac{m g r^2}{2 a} \tag{1} $$

The angular momentum is

$$ \ell = \frac{\partial L}{\partial\dot\phi} = m r^2\dot\phi \tag{2} $$

The particle can move on a horizontal circle of radius $r_0$ if

$$ \ell^2 = \frac{m^2 g r_0^4}{a} \tag{3} $$

It goes round with the angular velocity

$$ \Omega = \frac{\ell}{m r_0^2} = \sqrt{\frac ga} \tag{4} $$

The radius oscillates about $r_0$ with the frequency

$$ \nu = \sqrt{\frac{4 g a}{a^2 + r_0^2}} \tag{5} $$
";

/// Two coupled oscillators, and an ion in a magnetic field: their frequencies.
const PAIR: &str = r"$$ L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2) - \frac12 c(x - y)^2 \tag{1} $$

The secular equation is

$$ (k + c - m\omega^2)^2 = c^2 \tag{2} $$

The roots of the secular equation are

$$ \omega_1^2 = \frac km, \qquad \omega_2^2 = \frac{k + 2c}{m} \tag{3} $$
";

const ION: &str = r"$$ L = \frac12 m(\dot x^2 + \dot y^2 + \dot z^2) + \frac12 m \beta(x\dot y - y\dot x) - \frac12 m k\left(z^2 - \frac12(x^2 + y^2)\right) \tag{1} $$

The secular equation of the motion in the plane is

$$ \left(\omega^2 + \frac12 k\right)^2 - \beta^2\omega^2 = 0 \tag{2} $$

The positive roots of the secular equation are

$$ \omega_\pm = \frac12\beta \pm \sqrt{\frac14\beta^2 - \frac12 k} \tag{3} $$

They are real if the field is strong, and satisfy

$$ \omega_+^2 + \omega_-^2 + k = \beta^2 \tag{4} $$
";

const PENDULUM: &str = r"$$ L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta \tag{1} $$

So

$$ K = \dot\theta^2 - \frac{2g}{l}\cos\theta \tag{2} $$

is a constant of the motion. The period of small oscillations is

$$ T = 2\pi\sqrt{\frac lg} \tag{3} $$
";

pub(crate) fn claims(coordinates: &Json, constants: &str) -> Json {
    json!({ "coordinates": coordinates, "constants": { constants: "> 0" }, "means": { "L": "Lagrangian" } })
}

pub(crate) fn checked(claims: &Json, notes: &str) -> Document {
    document(claims, notes, &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn of<'d>(document: &'d Document, id: &str) -> &'d Equation {
    document.equations.iter().find(|equation| equation.id == id).expect("the display is there")
}

/// All displays pass, and each slip is refuted in its display, with an edit that makes all displays pass.
pub(crate) fn passes_and_finds(claims: &Json, notes: &str, slips: &[(&str, &str, &str)]) {
    let found = checked(claims, notes);
    let wrong: Vec<_> = found.equations.iter().filter(|equation| !equation.ok).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    for (id, right, slip) in slips {
        assert_eq!(notes.matches(right).count(), 1, "{right}");
        let found = checked(claims, &notes.replace(right, slip));
        let equation = of(&found, id);
        assert_eq!(equation.finding.verdict, Verdict::Refuted, "{slip}: {:?}", equation.finding);
        let mends = |repair: &onshell::check::Repair| {
            let mut text = found.source.text.clone();
            text.replace_range(repair.span.range(), &repair.replacement);
            checked(claims, &text).equations.iter().all(|equation| equation.ok)
        };
        assert!(equation.repairs.iter().any(mends), "{slip}: {:#?}", equation.repairs);
    }
}

#[test]
fn a_place_of_rest_with_a_name_and_the_frequency_there() {
    let claims = claims(&json!({ r"\theta": "angle" }), r"m, g, a, \omega");
    let slips = [
        ("2", r"\cos\theta_0 = \frac{g}{a\omega^2}", r"\cos\theta_0 = \frac{g}{a\omega}"),
        ("3", r"\omega^2\sin^2\theta_0", r"\omega^2\sin\theta_0"),
        ("4", r"\omega^2 - \frac{g^2}", r"\omega^2 + \frac{g^2}"),
    ];
    passes_and_finds(&claims, HOOP, &slips);
}

#[test]
fn a_steady_motion_and_the_oscillations_about_it() {
    let claims = claims(&json!({ "r": "> 0", r"\phi": "angle" }), "m, g, a");
    let slips = [
        ("3", r"\frac{m^2 g r_0^4}{a}", r"\frac{m^2 g r_0^3}{a}"),
        ("4", r"\sqrt{\frac ga}", r"\sqrt{\frac{2g}a}"),
        ("5", r"\frac{4 g a}", r"\frac{3 g a}"),
    ];
    passes_and_finds(&claims, BOWL, &slips[..1]);
    passes_and_finds(&claims, BOWL, &slips[2..]);
}

#[test]
fn secular_equations_and_their_roots() {
    let slips =
        [("2", r"(k + c - m\omega^2)^2", r"(k - c - m\omega^2)^2"), ("3", r"\frac{k + 2c}{m}", r"\frac{k + c}{m}")];
    passes_and_finds(&claims(&json!({ "x, y": "any" }), "m, k, c"), PAIR, &slips);
    // A root that is real in a strong field only is a frequency there.
    let found = checked(&claims(&json!({ "x, y, z": "any" }), r"m, \beta, k"), ION);
    assert!(found.inferred.iter().any(|line| line.contains("(3) say")), "{:?}", found.inferred);
    // Forces that turn couple x and y; z has a determinant of its own.
    let slips = [("2", r"\omega^2 + \frac12 k\right)^2", r"\omega^2 - \frac12 k\right)^2")];
    passes_and_finds(&claims(&json!({ "x, y, z": "any" }), r"m, \beta, k"), ION, &slips);
}

#[test]
fn constants_of_the_motion_and_periods() {
    let claims = claims(&json!({ r"\theta": "angle" }), "m, g, l");
    let slips = [("2", r"\frac{2g}{l}\cos", r"\frac{g}{l}\cos"), ("3", r"2\pi\sqrt{\frac lg}", r"2\pi\sqrt{\frac gl}")];
    passes_and_finds(&claims, PENDULUM, &slips);
}

#[test]
fn words_that_mean_something_else_make_nothing_wrong() {
    let claims = claims(&json!({ r"\theta": "angle" }), r"m, g, a, \omega");
    // The frequency of the drive is no frequency of small oscillations, and no edit makes it one.
    let notes = HOOP.replace(
        "The frequency of small oscillations about it is",
        "The frequency of small oscillations of the motor is",
    );
    let notes = notes.replace(r"\Omega^2 = \omega^2\sin^2\theta_0", r"\Omega^2 = 7\omega^4 + 5\cos^3\theta_0");
    let notes = notes.split("\nor\n").next().unwrap_or_default().to_owned();
    let found = checked(&claims, &notes);
    assert_ne!(of(&found, "3").finding.verdict, Verdict::Refuted, "{:?}", of(&found, "3").finding);
    // Without the words a name that nobody declares stays a fault, as a slip of the pen may be.
    let notes = HOOP.replace("There is an equilibrium at $\\theta_0$ with", "We have");
    let found = checked(&claims, &notes);
    assert_eq!(of(&found, "2").finding.code, Code::UndeclaredName);
}

#[test]
fn a_definition_that_nothing_tests_passes_and_is_no_proof() {
    let claims = claims(&json!({ r"\theta": "angle" }), "m, g, l");
    let notes = r"$$ L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta \tag{1} $$

$$ S = m g l \sin\theta \tag{2} $$
";
    let found = checked(&claims, notes);
    let last = of(&found, "2");
    assert!(last.ok && last.finding.code == Code::DefinitionUnused, "{last:?}");
    assert_eq!(last.finding.verdict, Verdict::Undecided);
    let report = onshell::check::Report::new(vec![found]);
    assert_eq!((report.exit_code(), report.strict_exit_code()), (0, 2));
}

#[test]
fn a_motion_from_rest_has_the_energy_that_it_begins_with() {
    let notes = |factor: &str| {
        format!(
            "$$ L = \\frac12 m l^2\\dot\\theta^2 + m g l\\cos\\theta \\tag{{1}} $$\n\n\
             The pendulum is released from rest at $\\theta = \\theta_0$. Then\n\n\
             $$ \\dot\\theta^2 = \\frac{{{factor} g}}{{l}}(\\cos\\theta - \\cos\\theta_0) \\tag{{2}} $$\n"
        )
    };
    let mut claims = claims(&json!({ r"\theta": "angle" }), "m, g, l");
    claims["constants"][r"\theta_0"] = json!("(0, \\pi)");
    let verdict = |notes: &str| of(&checked(&claims, notes), "2").finding.verdict;
    assert_eq!(verdict(&notes("2")), Verdict::Verified);
    assert_eq!(verdict(&notes("3")), Verdict::Refuted);
    // Without the words it is no identity.
    assert_eq!(verdict(&notes("2").replace("is released from rest at", "passes")), Verdict::Refuted);
}

#[test]
fn what_words_may_mean_otherwise_is_not_refuted() {
    let verdict = |claims: &Json, notes: &str| of(&checked(claims, notes), "2").finding.verdict;
    // The motor works on the bead, so its energy is not conserved; one sign makes another quantity of it that is.
    let hoop = |words: &str| {
        format!(
            "$$ L = \\frac12 m a^2(\\dot\\theta^2 + \\omega^2\\sin^2\\theta) + m g a\\cos\\theta \\tag{{1}} $$\n\n{words}\n\n\
             $$ E = \\frac12 m a^2(\\dot\\theta^2 + \\omega^2\\sin^2\\theta) - m g a\\cos\\theta \\tag{{2}} $$\n"
        )
    };
    let of_angle = |constants: &str| claims(&json!({ r"\theta": "angle" }), constants);
    let driven = of_angle(r"m, g, a, \omega");
    assert_ne!(verdict(&driven, &hoop("The energy of the bead is")), Verdict::Refuted);
    assert_eq!(verdict(&driven, &hoop("There is a conserved quantity,")), Verdict::Refuted);
    // The angle is counted from the top, where nothing oscillates.
    let pendulum = |potential: &str| {
        format!(
            "$$ L = \\frac12 m l^2\\dot\\theta^2 {potential} m g l\\cos\\theta \\tag{{1}} $$\n\n\
             The frequency of small oscillations about the lowest position is\n\n\
             $$ \\omega^2 = \\frac gl \\tag{{2}} $$\n"
        )
    };
    assert_ne!(verdict(&of_angle("m, g, l"), &pendulum("-")), Verdict::Refuted);
    assert_eq!(verdict(&of_angle("m, g, l"), &pendulum("+")), Verdict::Certified);
    // A constant may be left out of an effective potential.
    let top = "$$ L = \\frac12 A(\\dot\\theta^2 + \\sin^2\\theta\\,\\dot\\phi^2) + \\frac12 C(\\dot\\psi + \\cos\\theta\\,\\dot\\phi)^2 \
               - m g l\\cos\\theta \\tag{1} $$\n\n$$ U_{\\text{eff}}(\\theta) = \\frac{(p_\\phi - p_\\psi\\cos\\theta)^2}{2 A\\sin^2\\theta} \
               + m g l\\cos\\theta \\tag{2} $$\n";
    let of_top = claims(&json!({ r"\theta": "(0, \\pi)", r"\phi, \psi": "angle" }), "A, C, m, g, l");
    assert_ne!(verdict(&of_top, top), Verdict::Refuted);
}

#[test]
fn solutions_that_are_sought_are_no_roots_of_the_secular_equation() {
    let sought =
        PAIR.replace("The secular equation is", r"If we seek solutions that oscillate, the secular equation is");
    let slips =
        [("2", r"(k + c - m\omega^2)^2", r"(k - c - m\omega^2)^2"), ("3", r"\frac{k + 2c}{m}", r"\frac{k + c}{m}")];
    passes_and_finds(&claims(&json!({ "x, y": "any" }), "m, k, c"), &sought, &slips);
    // The twins: words for the roots of the equation, after which no secular equation is expected.
    for roots in ["The solutions of this secular equation obey", "The secular equation has the roots"] {
        let found = checked(
            &claims(&json!({ "x, y": "any" }), r"m, k, c, \omega"),
            &PAIR.replace("The secular equation is", roots),
        );
        assert!(!found.inferred.iter().any(|line| line.contains("(2) is the secular equation")), "{roots}");
    }
}

#[test]
fn there_is_the_place_of_the_sentence_before() {
    let notes = r"$$ L = \frac12 m a^2\dot\theta^2 + m a^2 \left(\beta - \alpha\right)\cos\theta \tag{1} $$

For small $\alpha$ the lowest point is stable. For a large one the highest point, $\theta = \pi$, is stable. There the frequency
$\nu$ of small oscillations is given by

$$ \nu^2 = \alpha - \beta \tag{2} $$
";
    let slips = [("2", r"\nu^2 = \alpha - \beta", r"\nu^2 = \alpha + \beta")];
    passes_and_finds(&claims(&json!({ r"\theta": "angle" }), r"m, a, \alpha, \beta"), notes, &slips);
    // The twin: words that refer to nothing are about the lowest point.
    let found =
        checked(&claims(&json!({ r"\theta": "angle" }), r"m, a, \alpha, \beta"), &notes.replace("There the", "The"));
    assert!(!found.inferred.iter().any(|line| line.contains(r"about \theta = \pi")), "{:?}", found.inferred);
}
