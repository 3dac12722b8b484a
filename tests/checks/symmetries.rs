//! Claims about a Lagrangian of the notes: the charge of a symmetry, positions of rest, their stability.

use onshell::check::Verdict::{self, Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::verdict;

/// A verdict under a claim of its own, after the Lagrangian.
fn claimed(claims: &Json, lagrangian: &str, latex: &str, claim: Json) -> Verdict {
    verdict(claims, &[lagrangian, latex], claim)
}

/// A particle in the plane.
fn plane() -> Json {
    json!({
        "coordinates": { "x, y": "any" },
        "constants": { r"m, k, c, B, g": "> 0" },
        "means": { "L": "Lagrangian" },
    })
}

#[test]
fn the_charge_of_a_symmetry_that_is_given() {
    let central = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac14 k(x^2 + y^2)^2";
    let falling = r"L = \frac12 m(\dot x^2 + \dot y^2) - m g y";
    let turn = json!({ "symmetry": { "x": "-y", "y": "x" } });
    let (later, boost) =
        (json!({ "symmetry": { "x": r"\dot x", "y": r"\dot y" } }), json!({ "symmetry": { "y": "t" } }));
    for (lagrangian, right, wrong, claim) in [
        (central, r"Q = m(x\dot y - y\dot x)", r"Q = m(x\dot y + y\dot x)", &turn),
        (central, r"Q = m(x\dot y - y\dot x) + 3 k", r"Q = 2m(x\dot y - y\dot x)", &turn),
        (
            central,
            r"Q = \frac12 m(\dot x^2 + \dot y^2) + \frac14 k(x^2 + y^2)^2",
            r"Q = \frac12 m(\dot x^2 + \dot y^2) - \frac14 k(x^2 + y^2)^2",
            &later,
        ),
        // Of a boost, L changes by a total derivative.
        (falling, r"Q = m\dot y t - m y + \frac12 m g t^2", r"Q = m\dot y t - m y", &boost),
    ] {
        assert_eq!(claimed(&plane(), lagrangian, right, claim.clone()), Verified, "{right}");
        assert_eq!(claimed(&plane(), lagrangian, wrong, claim.clone()), Refuted, "{wrong}");
    }
    // The twin: the same formula is no charge where the change is no symmetry.
    let oblong = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k x^2";
    assert_eq!(claimed(&plane(), oblong, r"Q = m(x\dot y - y\dot x)", turn), Refuted);
}

#[test]
fn a_position_of_rest_and_whether_it_is_stable() {
    let claim = |kind: Json, assume: &[&str]| match assume {
        [] => json!({ "equilibrium": kind }),
        assume => json!({ "equilibrium": kind, "assume": assume }),
    };
    let well = r"L = \frac12 m\dot x^2 + \frac12 m\dot y^2 - \frac12 (k - c) x^2 - \frac12 k y^2 - m g y";
    let found = |latex: &str, kind: Json, assume: &[&str]| claimed(&plane(), well, latex, claim(kind, assume));
    let rest = r"x = 0, \quad y = -\frac{m g}{k}";
    assert_eq!(found(rest, json!(true), &[]), Verified);
    assert_eq!(found(r"x = 0, \quad y = \frac{m g}{k}", json!(true), &[]), Refuted);
    assert_eq!(found("x = 0", json!(true), &[]), Refuted, "y may be anywhere");
    assert_eq!(found(rest, json!("stable"), &["k > c"]), Verified);
    assert_eq!(found(rest, json!("stable"), &[]), Refuted, "where k < c it is none");
    assert_eq!(found(rest, json!("unstable"), &["k < c"]), Verified);
    assert_eq!(found(rest, json!("unstable"), &["k > c"]), Refuted);
    assert_eq!(found("k = c", json!(true), &[]), Verdict::Undecided, "no coordinate");
}

#[test]
fn what_second_derivatives_do_not_decide_is_not_called_stable() {
    let found =
        |lagrangian: &str, kind: &str| claimed(&plane(), lagrangian, "x = y = 0", json!({ "equilibrium": kind }));
    let flat = r"L = \frac12 m(\dot x^2 + \dot y^2) - k x^4 - \frac12 k y^2";
    let turned = r"L = \frac12 m(\dot x^2 + \dot y^2) + \frac12 B(x\dot y - y\dot x) + \frac12 k(x^2 + y^2)";
    for lagrangian in [flat, turned] {
        assert_eq!(found(lagrangian, "stable"), Verdict::Undecided, "{lagrangian}");
        assert_eq!(found(lagrangian, "unstable"), Verdict::Undecided, "{lagrangian}");
    }
    let saddle = r"L = \frac12 m(\dot x^2 + \dot y^2) - k x y";
    assert_eq!(found(saddle, "unstable"), Verified);
    assert_eq!(found(saddle, "stable"), Refuted);
}

#[test]
fn a_named_position_of_rest() {
    let claims = json!({
        "coordinates": { r"\theta": "angle" },
        "constants": { "m, a, g, k": "> 0", r"\alpha": r"(0, \pi/2)" },
        "means": { "L": "Lagrangian" },
    });
    let twisted = r"L = \frac12 m a^2\dot\theta^2 + m g a\cos\theta + k\theta";
    let claim = json!({ "equilibrium": "stable", "at": { r"\theta": r"\alpha" } });
    assert_eq!(claimed(&claims, twisted, r"\sin\alpha = \frac{k}{m g a}", claim.clone()), Verified);
    assert_eq!(claimed(&claims, twisted, r"\cos\alpha = \frac{k}{m g a}", claim), Refuted);
}

/// Three beads on a string, or two: names for their frequencies, and one for the unknown of the secular equation.
fn beads() -> Json {
    json!({
        "coordinates": { "x, y, z": "any" },
        "constants": { r"m, k, \omega": "> 0" },
        "means": { "L": "Lagrangian", r"\omega_a, \omega_b, \omega_c": "normal frequency" },
    })
}

const BEADS: &str = r"L = \frac12 m(\dot x^2 + \dot y^2 + \dot z^2) - \frac12 k x^2 - \frac12 k(x - y)^2 - \frac12 k(y - z)^2 - \frac12 k z^2";

#[test]
fn each_of_several_normal_frequencies() {
    let found = |latex: &str| claimed(&beads(), BEADS, latex, json!({}));
    let all = |last: &str| {
        format!(
            r"\omega_a^2 = \frac{{2k}}{{m}}, \quad \omega_b^2 = \frac{{(2 - \sqrt2) k}}{{m}}, \quad \omega_c^2 = \frac{{{last}}}{{m}}"
        )
    };
    assert_eq!(found(&all(r"(2 + \sqrt2) k")), Verified);
    assert_eq!(found(&all(r"(2 + \sqrt3) k")), Refuted);
    assert_eq!(found(&all(r"(2 - \sqrt2) k")), Refuted, "the same one twice");
    assert_eq!(found(r"\omega_a = \sqrt{\frac{2k}{m}}"), Verified);
    assert_eq!(found(r"\omega_a = \frac{2k}{m}"), Refuted);
}

#[test]
fn a_double_root_may_have_two_names() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian", r"\omega_1, \omega_2": "normal frequency" },
    });
    let round = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2)";
    let both = r"\omega_1^2 = \frac km, \quad \omega_2^2 = \frac km";
    assert_eq!(claimed(&claims, round, both, json!({})), Verified);
}

#[test]
fn a_secular_equation_has_all_roots() {
    let found = |latex: &str| claimed(&beads(), BEADS, latex, json!({ "secular equation for": r"\omega" }));
    let product = r"(2k - m\omega^2)\left((2k - m\omega^2)^2 - 2k^2\right) = 0";
    let rows = r"\begin{vmatrix} 2k - m\omega^2 & -k & 0 \\ -k & 2k - m\omega^2 & -k \\ 0 & -k & 2k - m\omega^2 \end{vmatrix} = 0";
    assert_eq!(found(product), Verified);
    assert_eq!(found(rows), Verified);
    assert_eq!(found(&product.replace("- 2k^2", "- k^2")), Refuted);
    assert_eq!(found(&rows.replacen("-k", "0", 1)), Refuted);
    // One root of three is not the equation, and what holds for every frequency is none.
    assert_eq!(found(r"2k - m\omega^2 = 0"), Refuted);
    assert_eq!(found(r"(k + \omega)^2 = k^2 + 2k\omega + \omega^2"), Verdict::Undecided);
    assert_eq!(found("k = 2 m"), Verdict::Undecided);
}
