//! What must hold before a claim can be tested at all. Where it does not, nothing is decided: a true statement is not refuted,
//! and a false one does not pass.

use onshell::check::Verdict;
use serde_json::{Value as Json, json};

use crate::support::{equation, outcome};

/// The verdict on the last display under a claim of its own.
fn verdict(claims: &Json, displays: &[&str], claim: Json) -> Verdict {
    outcome(&equation(claims, displays, claim).finding)
}

/// Coordinates x and y, and a Lagrangian in the notes.
fn plane() -> Json {
    json!({
        "coordinates": { "x, y": "any" },
        "constants": { r"m, k, a, \Omega, \omega": "> 0" },
        "means": { "L": "Lagrangian" },
    })
}

#[test]
fn forces_that_are_linear_in_the_velocities_leave_the_secular_equation_open() {
    let turning = r"L = \frac12 m(\dot x^2 + \dot y^2) + m\Omega(x\dot y - y\dot x) - \frac12 k(x^2 + y^2)";
    let claim = || json!({ "secular equation for": r"\omega" });
    // True with the term in Ω, and false.
    for printed in [r"(k - m\omega^2)^2 = 4 m^2\Omega^2\omega^2", r"(k - m\omega^2)^2 = 0"] {
        assert_eq!(verdict(&plane(), &[turning, printed], claim()), Verdict::Undecided, "{printed}");
    }
    // The same terms as a total derivative turn nothing.
    let still = r"L = \frac12 m(\dot x^2 + \dot y^2) + m\Omega(x\dot y + y\dot x) - \frac12 k(x^2 + y^2)";
    assert_eq!(verdict(&plane(), &[still, r"(k - m\omega^2)^2 = 0"], claim()), Verdict::Verified);
    assert_eq!(verdict(&plane(), &[still, r"(k - m\omega^2)^2 = m^2\Omega^4"], claim()), Verdict::Refuted);
}

#[test]
fn the_coordinates_of_normal_frequencies_are_measured_from_the_place_of_rest() {
    let claim = || json!({ "secular equation for": r"\omega" });
    let shifted = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac14 k(x - a)^4 - \frac12 k y^2";
    let printed = r"(3 k a^2 - m\omega^2)(k - m\omega^2) = 0";
    assert_eq!(verdict(&plane(), &[shifted, printed], claim()), Verdict::Undecided);
    let at_rest = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k x^2 - k x^4 - \frac12 k y^2";
    assert_eq!(verdict(&plane(), &[at_rest, r"(k - m\omega^2)^2 = 0"], claim()), Verdict::Verified);
}

#[test]
fn other_combinations_of_the_equations_of_motion_are_not_called_another_motion() {
    let spring = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2)";
    let claim = || json!({ "same motion as": "L" });
    assert_eq!(verdict(&plane(), &[spring, r"F = m\dot x\dot y - k x y"], claim()), Verdict::Undecided);
    assert_eq!(verdict(&plane(), &[spring, r"F = m\dot x\dot y + k x y"], claim()), Verdict::Refuted);
}

#[test]
fn a_formula_that_stands_for_a_name_has_no_known_derivative() {
    let claims = json!({
        "constants": { "a": "> 0" },
        "formulas as names": { r"\langle E(a) \rangle": "constant" },
    });
    for printed in [
        r"\frac{d}{da} \langle E(a) \rangle = 0",
        r"\frac{d}{da} \left(a \langle E(a) \rangle\right) = \langle E(a) \rangle",
        r"\frac{\partial}{\partial a} \left(a \langle E(a) \rangle\right) = \langle E(a) \rangle",
    ] {
        assert_eq!(verdict(&claims, &[printed], json!({})), Verdict::Unreadable, "{printed}");
    }
    let linear = r"2 \langle E(a) \rangle + a = a + \langle E(a) \rangle + \langle E(a) \rangle";
    assert_eq!(verdict(&claims, &[linear], json!({})), Verdict::Verified);
}
