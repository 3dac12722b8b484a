//! Forces beside the Lagrangian that vary freely with the time.

use onshell::check::Verdict::{self, Refuted, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, error, numbered, outcome, verdict, with};

/// A pendulum whose base is pushed by a motor, with friction.
fn cart() -> Json {
    json!({
        "coordinates": { "x": "any", r"\theta": "angle" },
        "constants": { r"M, m, l, g, b": "> 0", "V, a": "any", r"\theta_0": "(0, \\pi/2)" },
        "varies with time": { "u": "any" },
        "means": { "L": "Lagrangian" },
        "forces": { "x": r"u - b\dot x" },
    })
}

const LAGRANGIAN: &str =
    r"L = \frac12 (M + m)\dot x^2 + m l\dot x\dot\theta\cos\theta + \frac12 m l^2\dot\theta^2 + m g l\cos\theta";

fn said(latex: &str, claim: Json) -> Verdict {
    verdict(&cart(), &[LAGRANGIAN, latex], claim)
}

#[test]
fn a_force_may_vary_freely_with_the_time() {
    let momentum = r"(M + m)\dot x + m l\dot\theta\cos\theta";
    let rate = |order: &str, force: &str| {
        said(&format!(r"\frac{{d{order}}}{{dt{order}}}\left[{momentum}\right] = {force}"), json!({}))
    };
    for (order, right, wrong) in [("", r"u - b\dot x", r"u + b\dot x"), ("^2", r"\dot u - b\ddot x", r"u - b\ddot x")] {
        assert_eq!(rate(order, right), Verified, "{right}");
        assert_eq!(rate(order, wrong), Refuted, "{wrong}");
    }
    assert_eq!(said(r"l\ddot\theta + \ddot x\cos\theta + g\sin\theta = 0", json!({})), Verified);
    assert_eq!(said(r"l\ddot\theta + \ddot x\cos\theta - g\sin\theta = 0", json!({})), Refuted);
}

#[test]
fn a_force_follows_from_a_motion_that_is_given() {
    let steady = || json!({ "throughout": [r"\theta = -\theta_0", r"\ddot x = a"] });
    assert_eq!(said(r"\tan\theta_0 = \frac ag", steady()), Verified);
    assert_eq!(said(r"\tan\theta_0 = \frac ga", steady()), Refuted);
    assert_eq!(said(r"u = (M + m)a + b\dot x", steady()), Verified);
    assert_eq!(said(r"u = M a + b\dot x", steady()), Refuted);
}

#[test]
fn a_force_with_a_range_is_rejected_with_a_way_out() {
    let positive = with(&cart(), "varies with time", json!({ "u": "> 0" }));
    let message = error(&positive, &[LAGRANGIAN], json!({}));
    assert!(message.contains("a force contains u, which varies with time and has a range"), "{message}");
    let mut declared = with(&cart(), "functions", json!({ "u": "of t" }));
    declared["assume"] = json!(["u > 0"]);
    declared["varies with time"] = json!({});
    assert_eq!(
        verdict(&declared, &[LAGRANGIAN, r"M\ddot x + m\frac{d^2}{dt^2}(x + l\sin\theta) + b\dot x = |u|"], json!({})),
        Verified
    );
}

#[test]
fn names_in_a_force_are_no_constants_of_a_solution() {
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { r"m, k, c, F, \omega": "> 0" },
        "means": { "L": "Lagrangian" },
        "forces": { "x": r"F\cos\omega t - c\dot x" },
    });
    let lagrangian = r"L = \frac12 m\dot x^2 - \frac12 k x^2";
    let solution = r"x = \frac{F}{k - m\omega^2}\cos\omega t";
    let undamped = |law: &str, claim: Json| {
        let mut claims = claims.clone();
        claims["equations"] = json!({ "2": claim, "3": { "assume": "c = 0" } });
        let displays = numbered(&[lagrangian, law, solution]);
        let found = document(&claims, &displays, &Registry::standard(), None).expect("the claims fit");
        found.equations.iter().map(|equation| outcome(&equation.finding)).collect::<Vec<_>>()
    };
    let right = r"m\ddot x + c\dot x + k x = F\cos\omega t";
    assert_eq!(undamped(right, json!({}))[1..], [Verified, Verified]);
    // A slip in the equation is one of the equation: it does not rest on the solution without friction.
    for slip in [r"m\ddot x + c\dot x = F\cos\omega t", r"m\ddot x + c\dot x + k x = 2F\cos\omega t"] {
        assert_eq!(undamped(slip, json!({}))[1..], [Refuted, Verified], "{slip}");
    }
}
