//! Motions that start from rest, also in a place where they would stay.

use onshell::check::Verdict;
use serde_json::{Value as Json, json};

use crate::prose_claims::{checked, claims, of};

/// A pendulum that stands on its head, with a display about the motion from there.
fn on_its_head(formula: &str) -> String {
    format!(
        "$$ L = \\frac12 m l^2 \\dot\\theta^2 - m g l \\cos\\theta \\tag{{1}} $$\n\n\
         If it starts from rest at $\\theta = 0$, then\n\n\
         $$ {formula} \\tag{{2}} $$\n"
    )
}

fn verdict(claims: &Json, notes: &str) -> Verdict {
    of(&checked(claims, notes), "2").finding.verdict
}

#[test]
fn a_motion_from_an_equilibrium_has_its_energy() {
    let claims = claims(&json!({ r"\theta": "angle" }), "m, g, l");
    let right = [
        r"\dot\theta^2 = \frac{2 g}{l} (1 - \cos\theta)",
        r"m g \cos\theta - m l \dot\theta^2 = m g (3 \cos\theta - 2)",
    ];
    for formula in right {
        assert_eq!(verdict(&claims, &on_its_head(formula)), Verdict::Verified, "{formula}");
    }
    // All of these hold where the pendulum stands still.
    let wrong = [
        r"\ddot\theta = \frac{2 g}{l} \sin\theta",
        r"\dot\theta^2 = \frac{g}{l} (1 - \cos\theta)",
        r"\dot\theta^2 = \frac{2 g}{l} \sin^2\theta",
        r"m g \cos\theta - m l \dot\theta^2 = m g (2 \cos\theta - 1)",
    ];
    for formula in wrong {
        assert_eq!(verdict(&claims, &on_its_head(formula)), Verdict::Refuted, "{formula}");
    }
}

#[test]
fn a_claim_of_a_start_in_an_equilibrium_decides_nothing_alone() {
    let mut claims = claims(&json!({ r"\theta": "angle" }), "m, g, l");
    claims["equations"] = json!({ "2": { "assume": [r"\theta(0) = 0", r"\dot\theta(0) = 0"] } });
    let notes = |formula: &str| on_its_head(formula).replace("If it starts from rest at $\\theta = 0$, then", "Then");
    assert_eq!(verdict(&claims, &notes(r"\dot\theta^2 = \frac{2 g}{l} (1 - \cos\theta)")), Verdict::Verified);
    assert_eq!(verdict(&claims, &notes(r"\dot\theta^2 = \frac{g}{l} (1 - \cos\theta)")), Verdict::Undecided);
    assert_eq!(verdict(&claims, &notes(r"\ddot\theta = \frac{2 g}{l} \sin\theta")), Verdict::Undecided);
}

#[test]
fn a_coordinate_that_rests_beside_another_says_nothing_either() {
    let claims = claims(&json!({ "x": "any", "y": "any" }), r"m, \omega, a");
    let notes = |formula: &str| {
        format!(
            "$$ L = \\frac12 m (\\dot x^2 + \\dot y^2) - \\frac12 m \\omega^2 (x^2 + y^2) \\tag{{1}} $$\n\n\
             If it starts from rest at $x = a$, $y = 0$, then\n\n\
             $$ {formula} \\tag{{2}} $$\n"
        )
    };
    assert!(verdict(&claims, &notes(r"\ddot y = -\omega^2 y")).passes());
    assert!(verdict(&claims, &notes(r"\dot x^2 = \omega^2 (a^2 - x^2)")).passes());
    for formula in [r"\ddot y = -2 \omega^2 y", r"\ddot x = -\omega^2 x + y^3"] {
        assert_eq!(verdict(&claims, &notes(formula)), Verdict::Refuted, "{formula}");
    }
}

#[test]
fn a_term_of_a_high_power_is_not_lost_at_the_start() {
    let claims = claims(&json!({ "x": "any" }), r"m, g, \kappa");
    let notes = |formula: &str| {
        format!(
            "$$ L = \\frac12 m \\dot x^2 - m g x - m \\kappa x^5 \\tag{{1}} $$\n\n\
             If it starts from rest at $x = 0$, then\n\n\
             $$ {formula} \\tag{{2}} $$\n"
        )
    };
    assert!(verdict(&claims, &notes(r"\dot x^2 = -2 g x - 2 \kappa x^5")).passes());
    assert_eq!(verdict(&claims, &notes(r"\dot x^2 = -2 g x")), Verdict::Refuted);
    assert_eq!(verdict(&claims, &notes(r"x(t) = -\frac12 g t^2")), Verdict::Refuted);
}
