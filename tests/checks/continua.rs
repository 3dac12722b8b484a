//! Bodies whose mass is spread: integrals over them, densities as limits, sums that become integrals.

use onshell::check::Verdict::{self, Refuted, Undecided, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, error, numbered, outcome, verdict, with};

/// A uniform body made of these solids, the region B, with the mass per volume ρ.
fn solid(made_of: Json) -> Json {
    json!({
        "constants": { "R, a, b, c": "> 0", r"\vec d": "any" },
        "axes": { r"\hat x, \hat y, \hat z": "fixed" },
        "continua": { "B": { "mass per volume": r"\rho(\vec r)", "uniform": true, "made of": made_of } },
    })
}

/// The same with a mass per area σ.
fn sheet(made_of: Json) -> Json {
    let continuum = json!({ "B": { "mass per area": r"\sigma(\vec r)", "uniform": true, "made of": made_of } });
    with(&solid(json!([{ "ball": "R" }])), "continua", continuum)
}

/// ∫ f dm over ∫ dm.
fn mean(f: &str) -> String {
    format!(r"\frac{{\int_B \rho(\vec r) {f} \, d^3r}}{{\int_B \rho(\vec r) \, d^3r}}")
}

fn mean_over_sheet(f: &str) -> String {
    format!(r"\frac{{\int_B \sigma(\vec r) {f} \, d^2r}}{{\int_B \sigma(\vec r) \, d^2r}}")
}

fn of(claims: &Json, mean: &str, value: &str) -> Verdict {
    verdict(claims, &[&format!("{mean} = {value}")], json!({}))
}

#[test]
fn the_centers_of_simple_bodies() {
    for body in [json!([{ "ball": "R" }]), json!([{ "box": "a, b, c" }])] {
        assert_eq!(of(&solid(body.clone()), &mean(r"\vec r"), r"\vec 0"), Verified, "{body}");
        assert_eq!(of(&solid(body.clone()), &mean(r"\vec r"), r"R \hat z"), Refuted, "{body}");
    }
    let moved = solid(json!([{ "ball": "R", "at": r"\vec d" }]));
    assert_eq!(of(&moved, &mean(r"\vec r"), r"\vec d"), Verified);
    assert_eq!(of(&moved, &mean(r"\vec r"), r"2 \vec d"), Refuted);
    assert_eq!(of(&moved, &mean(r"\vec r"), r"\vec 0"), Refuted);
}

#[test]
fn moments_of_inertia_per_mass() {
    let ball = solid(json!([{ "ball": "R" }]));
    let distance = r"|\vec r \times \hat z|^2";
    assert_eq!(of(&ball, &mean(distance), r"\frac25 R^2"), Verified);
    assert_eq!(of(&ball, &mean(distance), r"\frac23 R^2"), Refuted);
    assert_eq!(of(&ball, &mean(distance), r"\frac25 R"), Refuted);
    let brick = solid(json!([{ "box": "a, b, c" }]));
    assert_eq!(of(&brick, &mean(distance), r"\frac{a^2 + b^2}{12}"), Verified);
    assert_eq!(of(&brick, &mean(distance), r"\frac{a^2 + c^2}{12}"), Refuted);
    let shell = sheet(json!([{ "shell": "R" }]));
    assert_eq!(of(&shell, &mean_over_sheet(distance), r"\frac23 R^2"), Verified);
    assert_eq!(of(&shell, &mean_over_sheet(distance), r"\frac25 R^2"), Refuted);
    let disc = sheet(json!([{ "disc": "R" }]));
    assert_eq!(of(&disc, &mean_over_sheet(distance), r"\frac12 R^2"), Verified);
    assert_eq!(of(&disc, &mean_over_sheet(r"|\vec r \times \hat x|^2"), r"\frac14 R^2"), Verified);
    assert_eq!(of(&disc, &mean_over_sheet(r"|\vec r \times \hat x|^2"), r"\frac12 R^2"), Refuted);
    let lamina = sheet(json!([{ "lamina": "a, b" }]));
    assert_eq!(of(&lamina, &mean_over_sheet(distance), r"\frac{a^2 + b^2}{12}"), Verified);
    assert_eq!(of(&lamina, &mean_over_sheet(distance), r"\frac{a^2}{12}"), Refuted);
}

#[test]
fn a_rod_has_length_only() {
    let rod = json!({ "B": { "mass per length": r"\lambda(\vec r)", "uniform": true, "made of": [{ "rod": "a" }] } });
    let rod = with(&solid(json!([{ "ball": "R" }])), "continua", rod);
    let square = r"\frac{\int_B \lambda(\vec r) |\vec r|^2 \, dr}{\int_B \lambda(\vec r) \, dr}";
    assert_eq!(of(&rod, square, r"\frac{1}{12} a^2"), Verified);
    assert_eq!(of(&rod, square, r"\frac13 a^2"), Refuted);
    // An end of it in the origin.
    assert_eq!(of(&rod, &square.replace("d^3", "d"), r"\frac{1}{12} a"), Refuted);
    let of_an_area = r"\int_B \lambda(\vec r) \, d^2 r = a";
    assert_eq!(verdict(&rod, &[of_an_area], json!({})), Unreadable);
}

#[test]
fn what_is_hollow_is_cut_out() {
    let bubble = |hollow: bool| {
        let inner = json!({ "ball": r"\frac12 R", "at": r"\frac12 R \hat z" });
        let inner = if hollow { with(&inner, "hollow", json!(true)) } else { inner };
        solid(json!([{ "ball": "R" }, inner]))
    };
    assert_eq!(of(&bubble(true), &mean(r"\vec r"), r"-\frac{1}{14} R \hat z"), Verified);
    assert_eq!(of(&bubble(true), &mean(r"\vec r"), r"\frac{1}{14} R \hat z"), Refuted);
    // Put in a second time, it pulls the other way: R/2 · 1/8 over 9/8.
    assert_eq!(of(&bubble(false), &mean(r"\vec r"), r"\frac{1}{18} R \hat z"), Verified);
    assert_eq!(of(&bubble(false), &mean(r"\vec r"), r"-\frac{1}{14} R \hat z"), Refuted);
}

#[test]
fn parts_of_a_body_are_weighed() {
    let masses = |value: &str| {
        let two = solid(json!([{ "ball": "R" }, { "box": "R, R, R", "at": r"3 R \hat x" }]));
        let (volume, moment) = (r"\frac43 \pi + 1", "3");
        assert_eq!(of(&two, &mean(r"\cdot 1"), "1"), Verified);
        of(&two, &mean(r"\vec r"), &value.replace("M", volume).replace("S", moment))
    };
    assert_eq!(masses(r"\frac{S}{M} R \hat x"), Verified);
    assert_eq!(masses(r"\frac{S}{2} R \hat x"), Refuted);
}

/// A region V with any density, which may be cut into particles.
fn continuum() -> Json {
    json!({
        "indices": { "i": "1..n" },
        "varies with time": { r"\vec r_i": "any" },
        "constants": { "m_i": "> 0" },
        "continua": {
            "V": { "mass per volume": r"\rho(\vec r)", "particles": r"m_i at \vec r_i" },
            "A": { "mass per area": r"\sigma(\vec r)", "particles": r"m_i at \vec r_i" },
        },
    })
}

#[test]
fn a_density_is_the_limit_of_mass_over_volume() {
    let density = |latex: &str| verdict(&continuum(), &[latex], json!({}));
    let limit = |mass: &str, size: &str| {
        format!(r"\rho(\vec r) = \lim_{{V(\vec r) \to 0}} \frac{{\sum_{{\vec r_i \in V(\vec r)}} {mass}}}{{{size}}}")
    };
    assert_eq!(density(&limit("m_i", r"V(\vec r)")), Verified);
    assert_eq!(density(&limit("2 m_i", r"V(\vec r)")), Refuted);
    assert_eq!(density(&limit("m_i^2", r"V(\vec r)")), Refuted);
    assert_eq!(density(&limit("1", r"V(\vec r)")), Refuted);
    assert_eq!(density(&limit(r"m_i \vec r_i", r"V(\vec r)")), Unreadable);
    let area = r"\sigma(\vec r) = \lim_{A(\vec r) \to 0} \frac{\sum_{\vec r_i \in A(\vec r)} m_i}{A(\vec r)}";
    assert_eq!(density(area), Verified);
    assert_eq!(density(&area.replace("} m_i", r"} 3 m_i")), Refuted);
}

#[test]
fn sums_over_particles_become_integrals() {
    let sum = r"S = \sum_i m_i |\vec r_i|^2";
    let integral = |latex: &str| verdict(&continuum(), &[sum, latex], json!({ "continuum limit of": "1" }));
    assert_eq!(integral(r"S = \int_V \rho(\vec r) |\vec r|^2 \, d^3r"), Verified);
    assert_eq!(integral(r"S = 2 \int_V \rho(\vec r) |\vec r|^2 \, d^3r"), Refuted);
    assert_eq!(integral(r"S = \int_V \rho(\vec r)^2 |\vec r|^2 \, d^3r"), Refuted);
    assert_eq!(integral(r"S = \int_V \rho(\vec r) |\vec r|^3 \, d^3r"), Refuted);
    assert_eq!(integral(r"S = \int_V |\vec r|^2 \, d^3r"), Refuted);
    assert_eq!(integral(r"S = \int_A \sigma(\vec r) |\vec r|^2 \, d^2r"), Verified);
    assert_eq!(integral(r"S = \int_A \sigma(\vec r) |\vec r|^2 \, d^3r"), Unreadable);
}

#[test]
fn a_limit_of_something_else_is_refuted() {
    let sums = [r"M = \sum_i m_i", r"Q = \sum_i m_i |\vec r_i|^2"];
    let claims = |of: &str, latex: &str| {
        let claims = with(&continuum(), "equations", json!({ "3": { "continuum limit of": of } }));
        let found = document(&claims, &numbered(&[sums[0], sums[1], latex]), &Registry::standard(), Some("3"));
        outcome(&found.unwrap_or_else(|error| panic!("{latex}: {error}")).equations[0].finding)
    };
    assert_eq!(claims("1", r"M = \int_V \rho(\vec r) \, d^3r"), Verified);
    assert_eq!(claims("1", r"M = \int_V \rho(\vec r) |\vec r|^2 \, d^3r"), Refuted);
    assert_eq!(claims("2", r"Q = \int_V \rho(\vec r) |\vec r|^2 \, d^3r"), Verified);
    // The address must be that of the sum which the name stands for.
    assert_eq!(claims("2", r"M = \int_V \rho(\vec r) \, d^3r"), Undecided);
    assert_eq!(claims("1", r"Q = \int_V \rho(\vec r) |\vec r|^2 \, d^3r"), Undecided);
}

#[test]
fn an_integral_that_the_rule_is_not_exact_for_is_refused() {
    let ball = solid(json!([{ "ball": "R" }]));
    assert_eq!(of(&ball, &mean(r"|\vec r|^4"), r"\frac37 R^4"), Verified);
    assert_eq!(of(&ball, &mean(r"|\vec r|^4"), r"\frac35 R^4"), Refuted);
    // No polynomial: whatever it is said to be.
    assert_eq!(of(&ball, &mean(r"\sqrt{R^2 + |\vec r \times \hat z|^2}"), r"\frac34 R"), Unreadable);
    assert_eq!(of(&ball, &mean(r"\frac{1}{R + |\vec r|}"), r"\frac{3}{R}(\frac12 - 1 + \ln 2)"), Unreadable);
}

#[test]
fn bodies_that_are_none_are_refused() {
    for body in [
        json!([]),
        json!([{ "ball": "R, R" }]),
        json!([{ "shell": "R" }]),
        json!([{ "cone": "R" }]),
        json!([{ "ball": "R", "box": "a, b, c" }]),
    ] {
        let found = error(&solid(body.clone()), &["a = a"], json!({}));
        assert!(found.starts_with("claims.json:"), "{body}: {found}");
    }
}

#[test]
fn how_the_matter_moves_at_a_place_is_not_known() {
    let mut ball =
        with(&solid(json!([{ "ball": "R" }])), "define", json!({ "z": r"\vec r \cdot \hat z", "u": r"\dot z" }));
    ball = with(&ball, "varies with time", json!({ r"\omega": "any" }));
    let about_the_axis = |height: &str| format!(r"(|\vec r|^2 - {height})");
    assert_eq!(of(&ball, &mean(&about_the_axis("z^2")), r"\frac25 R^2"), Verified);
    for moving in [r"\dot z^2", r"\dot{\vec r}^2", "u^2", r"\frac{dz}{dt}"] {
        assert_eq!(of(&ball, &mean(&about_the_axis(moving)), r"\frac35 R^2"), Unreadable, "{moving}");
    }
    // What does not depend on the place may move, and so may the whole.
    let turning = mean(r"\dot\omega |\vec r \times \hat z|^2");
    assert_eq!(of(&ball, &turning, r"\frac25 R^2 \dot\omega"), Verified);
    assert_eq!(of(&ball, &turning, r"\frac35 R^2 \dot\omega"), Refuted);
    let energy = format!(r"\frac{{d}}{{dt}} ({})", mean(r"\omega^2 |\vec r \times \hat z|^2"));
    assert_eq!(of(&ball, &energy, r"\frac45 R^2 \omega \dot\omega"), Verified);
    assert_eq!(of(&ball, &energy, r"\frac25 R^2 \omega \dot\omega"), Refuted);
}
