//! What textbooks print beside a Lagrangian: orbits, functions of a distance, quantities that nothing else uses.

use serde_json::{Value, json};

use crate::printed_lagrangian::{are, verdicts};
use crate::support::Desk;

fn central() -> Value {
    json!({
        "coordinates": { "r": "> 0", "\\theta": "angle" },
        "constants": { "m, k": "> 0" },
        "functions": { "V": "of r" },
        "means": { "L": "Lagrangian", "E": "energy" },
    })
}

const CENTRAL: (&str, &str) = (r"L = \frac12 m(\dot r^2+r^2\dot\theta^2) - V(r)", "definition");

#[test]
fn a_derivative_by_an_angle_runs_along_the_orbit() {
    are(
        "orbit",
        &central(),
        &[
            CENTRAL,
            (r"\ell = m r^2\dot\theta = \text{const}", "passes"),
            (r"F(r) = -V'(r)", "definition"),
            (r"u = \frac1r", "definition"),
            (r"\frac{du}{d\theta} = -\frac{m}{\ell}\dot r", "passes"),
            (r"\frac{d^2u}{d\theta^2} + u = -\frac{m}{\ell^2u^2} F(1/u)", "passes"),
            (r"\frac{dr}{d\theta} = \frac{m r^2}{\ell}\dot r", "passes"),
            (r"\frac{du}{d\theta} = \frac{m}{\ell}\dot r", "refuted"),
            (r"\frac{d^2u}{d\theta^2} - u = -\frac{m}{\ell^2u^2} F(1/u)", "refuted"),
            (r"\frac{d^2u}{d\theta^2} + u = -\frac{m}{\ell^2u^2} F(u)", "refuted"),
            // Of an energy the partial derivative may be meant.
            (r"\frac{dV}{d\theta} = 0", "unreadable"),
        ],
    );
}

#[test]
fn primes_hold_the_momentum_fixed() {
    are(
        "effective",
        &central(),
        &[
            CENTRAL,
            (r"\ell = m r^2\dot\theta", "definition"),
            (r"W(r) = \frac{\ell^2}{2 m r^2} + V(r)", "definition"),
            (r"m\ddot r = -W'(r)", "passes"),
            (r"W''(r) = \frac{3\ell^2}{m r^4} + V''(r)", "passes"),
            (r"E = \frac12 m\dot r^2 + W(r)", "passes"),
            (r"m\ddot r = W'(r)", "refuted"),
            (r"W''(r) = \frac{\ell^2}{m r^4} + V''(r)", "refuted"),
        ],
    );
}

#[test]
fn a_momentum_by_another_name_stays_fixed_too() {
    let claims = json!({
        "coordinates": { "\\theta": "(0, \\pi)", "\\phi": "angle" },
        "constants": { "m, g, l": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    are(
        "spherical",
        &claims,
        &[
            (r"L = \frac12 m l^2(\dot\theta^2 + \sin^2\theta\,\dot\phi^2) + m g l\cos\theta", "definition"),
            (r"p_\phi = m l^2\sin^2\theta\,\dot\phi = \text{const} \equiv M_z", "passes"),
            (r"W = \frac{M_z^2}{2 m l^2\sin^2\theta} - m g l\cos\theta", "definition"),
            (r"m l^2\ddot\theta = -\frac{\partial W}{\partial\theta}", "passes"),
            (r"m l^2\ddot\theta = \frac{\partial W}{\partial\theta}", "refuted"),
        ],
    );
}

#[test]
fn a_function_of_a_distance_that_a_display_defines() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { "m": "> 0" },
        "functions": { "U": "of r" },
        "means": { "L": "Lagrangian" },
    });
    are(
        "distance",
        &claims,
        &[
            (r"r = \sqrt{x^2 + y^2}", "definition"),
            (r"L = \frac12 m(\dot x^2 + \dot y^2) - U(r)", "definition"),
            (r"m\ddot x = -U'(r)\frac{x}{r}", "passes"),
            (r"M = m(x\dot y - y\dot x) = \text{const}", "passes"),
            (r"m\ddot x = -U'(r)\frac{y}{r}", "refuted"),
            (r"m\ddot y = -U(r)\frac{y}{r}", "refuted"),
        ],
    );
}

#[test]
fn a_function_of_a_name_that_nothing_defines_is_an_error() {
    let desk = Desk::new("nowhere");
    desk.write("notes.md", "$$ L = \\frac12 m\\dot x^2 - U(s) \\tag{1} $$\n");
    let claims = json!({
        "notes": "notes.md",
        "coordinates": { "x": "any" },
        "constants": { "m": "> 0" },
        "functions": { "U": "of s" },
        "means": { "L": "Lagrangian" },
    });
    desk.write("notes.json", claims.to_string());
    let run = desk.onshell(&["check", "notes.md"]);
    assert!(run.err.contains("s is not declared"), "{}", run.err);
}

#[test]
fn quantities_that_nothing_uses_are_compared_with_those_of_the_lagrangian() {
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = (r"L = \frac12 m\dot x^2 - \frac12 k x^2", "definition");
    let found = |claims: &Value, name: &str, latex: &str, wrong: &str| {
        are(name, claims, &[lagrangian, (latex, "definition")]);
        are(&format!("{name} with a slip"), claims, &[lagrangian, (wrong, "undecided")]);
    };
    found(&claims, "kinetic", r"T = \frac12 m\dot x^2", r"T = \frac13 m\dot x^2");
    found(&claims, "potential", r"V = \frac12 k x^2", r"V = k x^2");
    found(&claims, "momentum", r"P = m\dot x", r"P = m x");
    found(&claims, "energy", r"E = \frac12 m\dot x^2 + \frac12 k x^2", r"E = \frac12 m\dot x^2 - \frac13 k x^2");
}

#[test]
fn letters_that_are_numbers_elsewhere_are_names_where_a_display_defines_them() {
    let circuit = json!({
        "coordinates": { "q": "any" },
        "constants": { "\\Lambda, C": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    are(
        "current",
        &circuit,
        &[
            (r"L = \frac12\Lambda\dot q^2 - \frac{q^2}{2C}", "definition"),
            (r"i = \dot q", "definition"),
            (r"\Lambda\frac{di}{dt} + \frac{q}{C} = 0", "passes"),
            (r"\Lambda\frac{di}{dt} - \frac{q}{C} = 0", "refuted"),
        ],
    );
    // With a symbol e, the exponential would be its power.
    let free = json!({
        "coordinates": { "x": "any" },
        "constants": { "m": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    are(
        "eccentricity",
        &free,
        &[
            (r"L = \frac12 m\dot x^2", "definition"),
            (r"e = m\dot x", "definition"),
            (r"\dot e = 0", "passes"),
            (r"e = \text{const}", "passes"),
            (r"\frac{d}{dt} e^{m} = 0", "unreadable"),
        ],
    );
}

#[test]
fn a_hyperbolic_argument_goes_on_to_the_time() {
    let chain = json!({
        "coordinates": { "x": "> 0" },
        "constants": { "M, g, l, x_0": "> 0" },
        "means": { "L": "Lagrangian", "E": "energy" },
    });
    are(
        "chain",
        &chain,
        &[
            (r"L = \frac12 M\dot x^2 + \frac{M g x^2}{2 l}", "definition"),
            (r"\alpha = \sqrt{g/l}", "definition"),
            (r"x(t) = x_0\cosh\alpha t", "passes"),
            (r"\dot x(t) = x_0\alpha\sinh\alpha t", "passes"),
            (r"\dot x(t) = x_0\alpha\cosh\alpha t", "refuted"),
        ],
    );
}

#[test]
fn what_holds_without_its_hypotheses_needs_none() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "means": { "L": "Lagrangian" },
        "equations": { "3": { "assume": ["x = 0", "y = 1"] }, "4": { "assume": ["x = 0", "y = 1"] } },
    });
    are(
        "saddle",
        &claims,
        &[
            (r"L = \frac12(\dot x^2 + \dot y^2) - V(x, y)", "definition"),
            (r"V(x, y) = \frac12(x^2 + y^2) + x^2y - \frac13y^3", "definition"),
            (r"\frac{\partial V}{\partial x} = 2xy + x = 0", "passes"),
            (r"\frac{\partial V}{\partial x} = 3xy + x = 0", "undecided"),
        ],
    );
}

#[test]
fn a_hypothesis_about_the_energy_says_more_than_the_claim_repeats() {
    let claims = json!({
        "coordinates": { "\\theta": "angle" },
        "constants": { "m, g, l": "> 0", "\\theta_0": "angle" },
        "means": { "L": "Lagrangian", "E": "energy" },
        "equations": {
            "2": { "assume": "E = -m g l\\cos\\theta_0" },
            "3": { "assume": "E = -m g l\\cos\\theta_0" },
        },
    });
    let found = verdicts(
        "from rest",
        claims,
        &[
            r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta",
            r"\frac12 l\dot\theta^2 = g(\cos\theta - \cos\theta_0)",
            r"\frac12 l\dot\theta^2 = g(\cos\theta + \cos\theta_0)",
        ],
    );
    assert!(["certified", "verified"].contains(&found[1].as_str()), "{found:?}");
    assert_eq!(found[2], "refuted", "{found:?}");
}

#[test]
fn a_lost_partial_is_put_back() {
    for (wrong, edit) in [
        (r"\frac{dL}{\partial\dot r} = m\dot r", r"\frac{\partial L}{\partial\dot r} = m\dot r"),
        (r"\frac{L}{\partial\dot r} = m\dot r", r"\frac{\partial L}{\partial\dot r} = m\dot r"),
        (r"\frac{\partial L}{\dot r} = m\dot r", r"\frac{\partial L}{\partial \dot r} = m\dot r"),
    ] {
        let desk = Desk::new("partial");
        let notes = format!("$$ {} \\tag{{1}} $$\n\n$$ {wrong} \\tag{{2}} $$\n", CENTRAL.0);
        desk.write("notes.md", &notes);
        let mut claims = central();
        claims["notes"] = json!("notes.md");
        desk.write("notes.json", claims.to_string());
        let report = desk.onshell(&["check", "notes.md", "--format", "json"]).json();
        let first = &report["documents"][0]["equations"][1]["repairs"][0];
        let place = |key: &str| first[key].as_u64().unwrap_or_else(|| panic!("{wrong}: {report:#}")) as usize;
        let text = first["replacement"].as_str().expect("a text");
        let mended = format!("{}{text}{}", &notes[..place("start")], &notes[place("end")..]);
        assert!(mended.contains(edit), "{wrong}: {mended}");
    }
}
