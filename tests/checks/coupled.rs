//! Laws of motion that give several accelerations together: a cart with a pole, a planar arm, two coupled circuits.

use onshell::check::Verdict::{Law, Refuted, Undecided, Verified};
use onshell::check::{Document, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, outcome, with};

fn cart_and_pole() -> Json {
    json!({
        "constants": { "M, m, l, g": "> 0" },
        "varies with time": { "x": "any", r"\theta": "angle" },
        "laws": { "cart": "1", "pole": "2" },
    })
}

const CART: &str = r"(M + m) \ddot x + m l \ddot\theta \cos\theta - m l \dot\theta^2 \sin\theta = 0";
const POLE: &str = r"\ddot x \cos\theta + l \ddot\theta = g \sin\theta";

fn checked(claims: &Json, displays: &[&str]) -> Document {
    document(claims, &numbered(displays), &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"))
}

fn verdicts(claims: &Json, displays: &[&str]) -> Vec<Verdict> {
    checked(claims, displays).equations.iter().map(|equation| outcome(&equation.finding)).collect()
}

#[test]
fn accelerations_that_two_laws_give_together() {
    let solved = |numerator: &str| {
        let solution = format!(r"\ddot x = \frac{{m \sin\theta ({numerator})}}{{M + m \sin^2\theta}}");
        verdicts(&cart_and_pole(), &[CART, POLE, &solution])
    };
    assert_eq!(solved(r"l \dot\theta^2 - g \cos\theta"), [Law, Law, Verified]);
    for wrong in [r"l \dot\theta^2 + g \cos\theta", r"l \dot\theta - g \cos\theta", r"l \dot\theta^2 - g \sin\theta"] {
        assert_eq!(solved(wrong), [Law, Law, Refuted], "{wrong}");
    }
}

#[test]
fn what_two_laws_conserve_together() {
    let momentum = |latex: &str| verdicts(&cart_and_pole(), &[CART, POLE, latex])[2];
    assert_eq!(momentum(r"\frac{d}{dt} \left((M + m) \dot x + m l \dot\theta \cos\theta\right) = 0"), Verified);
    assert_eq!(momentum(r"\frac{d}{dt} \left((M + m) \dot x - m l \dot\theta \cos\theta\right) = 0"), Refuted);
}

#[test]
fn laws_that_give_no_acceleration_together_prove_nothing() {
    // The second is twice the first, but for a force.
    let circuits = json!({
        "constants": { "k, b": "> 0" },
        "varies with time": { "x, y": "any" },
        "laws": { "the first": "1", "the second": "2" },
    });
    let singular = [r"\ddot x + \ddot y = -k x", r"2 \ddot x + 2 \ddot y = -2 k x + b", r"\ddot x = 7 \ddot y"];
    assert!(verdicts(&circuits, &singular).iter().all(|verdict| *verdict == Undecided));
    let regular = [r"\ddot x + \ddot y = -k x", r"2 \ddot x + \ddot y = b", r"\ddot x = k x + b"];
    assert_eq!(verdicts(&circuits, &regular), [Law, Law, Verified]);
    let wrong = [regular[0], regular[1], r"\ddot x = k x - b"];
    assert_eq!(verdicts(&circuits, &wrong), [Law, Law, Refuted]);
}

/// Torques may be anything: what a law says of one is no matter of solving.
#[test]
fn torques_that_laws_say_outright() {
    let arm = json!({
        "constants": { "m, l, b": "> 0" },
        "varies with time": { r"\theta_1, \theta_2": "angle", r"\tau_1, \tau_2": "any" },
        "laws": { "shoulder": "1", "elbow": "2" },
    });
    let shoulder = r"\tau_1 = 2 m l^2 \ddot\theta_1 + b \cos(\theta_1 - \theta_2) \ddot\theta_2 + b \sin(\theta_1 - \theta_2) \dot\theta_2^2";
    let elbow = r"\tau_2 = m l^2 \ddot\theta_2 + b \cos(\theta_1 - \theta_2) \ddot\theta_1 - b \sin(\theta_1 - \theta_2) \dot\theta_1^2";
    let energy = r"T = m l^2 \dot\theta_1^2 + \frac12 m l^2 \dot\theta_2^2 + b \cos(\theta_1 - \theta_2) \dot\theta_1 \dot\theta_2";
    let arm = with(&arm, "define", json!({ "T": energy.trim_start_matches("T = ") }));
    let work = |power: &str| checked(&arm, &[shoulder, elbow, power]).equations[2].finding.verdict;
    assert_eq!(work(r"\dot T = \tau_1 \dot\theta_1 + \tau_2 \dot\theta_2"), Verdict::Certified);
    assert_eq!(work(r"\dot T = \tau_1 \dot\theta_1 - \tau_2 \dot\theta_2"), Refuted);
}

/// Six laws of the first order of which each contains all names: their series are found term by term, not one within the other.
#[test]
fn many_laws_that_determine_each_other_take_no_time() {
    let names = ["a", "b", "c", "f", "g", "h"];
    let all = names.join(" + ");
    let claims = json!({
        "constants": { "k": "> 0" },
        "varies with time": { names.join(", "): "any" },
        "laws": { "1": "1", "2": "2", "3": "3", "4": "4", "5": "5", "6": "6" },
    });
    let laws: Vec<String> = names.iter().map(|name| format!(r"\dot {name} = k({all}) - 6 k {name}")).collect();
    let found = |latex: &str| {
        let mut displays: Vec<&str> = laws.iter().map(String::as_str).collect();
        displays.push(latex);
        verdicts(&claims, &displays)[6]
    };
    assert_eq!(found(&format!(r"\frac{{d^3}}{{dt^3}}({all}) = 0")), Verified);
    assert_eq!(found(r"\ddot a - \ddot b = 36 k^2(a - b)"), Verified);
    assert_eq!(found(r"\ddot a - \ddot b = 6 k^2(a - b)"), Refuted);
}
