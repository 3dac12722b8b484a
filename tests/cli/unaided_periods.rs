//! Notes without a claims file that print a period beside a frequency, and a name at the end of a chain.

use crate::support::{Desk, verdicts};
use crate::unaided::page;

fn found(name: &str, displays: &[&str]) -> Vec<String> {
    verdicts(&format!("unaided-periods-{name}"), &page(displays))
}

const FREQUENCY: &str = r"\omega_0 = \sqrt{\frac{k}{m}}";
const SOLUTION: &str = r"x(t) = A\cos\omega_0 t";
const MOTION: &str = r"m\ddot x = -k x";

/// The solution tests the frequency, so the slip is in the period.
#[test]
fn a_period_is_that_of_the_frequency_beside_it() {
    let right = found("right", &[MOTION, SOLUTION, FREQUENCY, r"T_0 = 2\pi\sqrt{\frac{m}{k}}"]);
    assert!(!right.contains(&"refuted".to_owned()), "{right:?}");
    for wrong in [r"T_0 = 2\pi\sqrt{\frac{k}{m}}", r"T_0 = 2\pi\sqrt{\frac{m}{k^2}}"] {
        let verdicts = found("slip", &[MOTION, SOLUTION, FREQUENCY, wrong]);
        assert_eq!((verdicts[2] == "refuted", verdicts[3].as_str()), (false, "refuted"), "{wrong}: {verdicts:?}");
    }
    let frequency = r"f = \frac{1}{2\pi}\sqrt{\frac{m}{k}}";
    let verdicts = found("frequency", &[MOTION, r"x(t) = A\cos\omega t", r"\omega = \sqrt{\frac{k}{m}}", frequency]);
    assert_eq!(verdicts[3], "refuted");
}

/// Alone beside each other one of the two is wrong. In one display that display is.
#[test]
fn without_other_displays_nobody_knows_which_is_wrong() {
    let apart = found("apart", &[FREQUENCY, r"T_0 = 2\pi\sqrt{\frac{k}{m}}"]);
    assert_eq!(apart, ["undecided", "undecided"]);
    let both = format!(r"{FREQUENCY}, \qquad T_0 = 2\pi\sqrt{{\frac{{k}}{{m}}}}");
    assert_eq!(found("both", &[&both]), ["refuted"]);
}

/// A tension, a period of something else, and what no likely slip turns into the period are no slips.
#[test]
fn other_quantities_with_the_letter_of_a_period_are_not_compared() {
    for other in [r"T_0 = m g", r"T_1 = 2\pi\sqrt{\frac{k}{m}}", r"T_0 = 2\pi\sqrt{\frac{\ell}{g}}"] {
        let verdicts = found("other", &[FREQUENCY, other]);
        assert!(verdicts.iter().all(|verdict| verdict == "definition"), "{other}: {verdicts:?}");
    }
}

/// `p = ∂L/∂q̇ = … = ℓ`: the displays that use ℓ are judged with the formula before it.
#[test]
fn a_name_at_the_end_of_a_chain_is_a_name_for_its_formula() {
    const LAGRANGIAN: &str = r"L = \frac12 m(\dot r^2 + r^2\dot\varphi^2) + \frac{k}{r}";
    const MOMENTUM: &str =
        r"p_\varphi = \frac{\partial L}{\partial\dot\varphi} = m r^2\dot\varphi = \ell = \text{const}";
    let radial = |power: &str| format!(r"m\ddot r = \frac{{\ell^2}}{{m r^{power}}} - \frac{{k}}{{r^2}}");
    let right = found("chain", &[LAGRANGIAN, MOMENTUM, &radial("3")]);
    assert_eq!(right[2], "certified", "{right:?}");
    let wrong = found("chain-slip", &[LAGRANGIAN, MOMENTUM, &radial("2")]);
    assert_eq!(wrong[2], "refuted", "{wrong:?}");
    // A rate gets a value here, and no name.
    let verdicts = found("value", &[r"v = \dot x = v_0", r"x = v_0 t"]);
    assert!(!verdicts.contains(&"refuted".to_owned()), "{verdicts:?}");
}

/// Of a chain only the equality is wrong whose sides differ by a number.
#[test]
fn a_chain_is_wrong_where_its_sides_differ() {
    let notes = page(&[
        r"L = \frac12 m(\dot r^2 + r^2\dot\varphi^2) - V(r)",
        r"p_\varphi = m r^2\dot\varphi = \ell = \text{const}",
        r"\frac{dA}{dt} = \frac12 r^2\dot\varphi = \frac{\ell}{m}",
    ]);
    let desk = Desk::new("unaided-periods-area");
    desk.write("notes.md", &notes);
    let report = desk.onshell(&["check", "notes.md", "--format", "json"]).json();
    let area = &report["documents"][0]["equations"][2];
    assert_eq!(area["verdict"], "refuted");
    let start = area["span"]["start"].as_u64().expect("a place") as usize;
    assert!(notes[start..].starts_with(r"\frac12 r^2"), "{}", &notes[start..]);
}
