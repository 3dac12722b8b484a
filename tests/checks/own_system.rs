//! A stranger's system: a Lagrangian defined here, registered, and notes checked against it.

use onshell::check::Verdict::{Refuted, Undecided, Verified};
use onshell::mechanics::{Lagrangian, State};
use onshell::scalar::Number;
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, outcome, verdict};

/// A bead on a hoop of radius a that turns about its vertical diameter at the rate Ω; θ from the bottom.
struct BeadOnAHoop;

impl Lagrangian<1, 4> for BeadOnAHoop {
    fn name(&self) -> &str {
        "bead_on_a_hoop"
    }
    fn coordinates(&self) -> [&str; 1] {
        [r"\theta"]
    }
    fn parameters(&self) -> [&str; 4] {
        ["m", "a", "g", r"\Omega"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 4>) -> D {
        let [mass, radius, g, turning] = at.parameters;
        let (sine, cosine) = at.q[0].sin_cos();
        let (along, around) = (radius * at.v[0], radius * sine * turning);
        mass * (along * along + around * around) * 0.5 + mass * g * radius * cosine
    }
}

/// Only the sum of its coordinates has a mass.
struct TwoForOne;

impl Lagrangian<2, 1> for TwoForOne {
    fn name(&self) -> &str {
        "two_for_one"
    }
    fn coordinates(&self) -> [&str; 2] {
        ["x", "y"]
    }
    fn parameters(&self) -> [&str; 1] {
        ["m"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 2, 1>) -> D {
        let together = at.v[0] + at.v[1];
        at.parameters[0] * together * together * 0.5 - at.q[0] * at.q[1]
    }
}

fn registry() -> Registry {
    let mut registry = Registry::standard();
    registry.add(BeadOnAHoop).add(TwoForOne);
    registry
}

fn hoop() -> Json {
    json!({
        "system": "bead_on_a_hoop",
        "coordinates": { r"\theta": "(0, \\pi)" },
        "constants": { r"m, a, g, \Omega": "> 0" },
        "means": { "L": "Lagrangian", "h": "energy" },
        "equations": {
            "3": { "conserved": true },
            "4": { "throughout": r"\dot\theta = 0" },
        },
    })
}

const NOTES: [&str; 4] = [
    r"L = \frac12 m a^2 (\dot\theta^2 + \Omega^2 \sin^2\theta) + m g a \cos\theta",
    r"a \ddot\theta = a \Omega^2 \sin\theta \cos\theta - g \sin\theta",
    r"h = \frac12 m a^2 \dot\theta^2 - \frac12 m a^2 \Omega^2 \sin^2\theta - m g a \cos\theta",
    r"\cos\theta = \frac{g}{a \Omega^2}",
];

#[test]
fn notes_about_a_system_of_ones_own_are_checked() {
    let found = document(&hoop(), &numbered(&NOTES), &registry(), None).unwrap();
    let verdicts: Vec<_> = found.equations.iter().map(|equation| outcome(&equation.finding)).collect();
    assert_eq!(verdicts, [Verified; 4], "{:#?}", found.equations);
    assert!(found.inferred.iter().any(|line| line.contains("bead_on_a_hoop")), "{:?}", found.inferred);
}

#[test]
fn typos_in_them_are_refuted() {
    for (place, printed, slip) in [
        (1, r"\sin^2\theta", r"\sin\theta"),
        (1, r"+ m g a", r"- m g a"),
        (1, r"\frac12", r"\frac13"),
        (2, r"- g", r"+ g"),
        (2, r"\Omega^2", r"\Omega"),
        (2, r"\cos\theta - g", r"- g"),
        (3, r"- \frac12 m a^2 \Omega^2", r"+ \frac12 m a^2 \Omega^2"),
        (4, r"\Omega^2", r"\Omega"),
        (4, r"\cos", r"\sin"),
    ] {
        let typo = NOTES[place - 1].replacen(printed, slip, 1);
        let mut notes = NOTES;
        notes[place - 1] = &typo;
        let id = place.to_string();
        let found = document(&hoop(), &numbered(&notes), &registry(), Some(&id)).unwrap();
        assert_eq!(found.equations[0].finding.verdict, Refuted, "{typo}: {}", found.equations[0].finding.message);
        assert!(found.equations[0].finding.counterexample.is_some());
    }
}

#[test]
fn a_system_that_nobody_registered_is_an_error() {
    let error = document(&hoop(), &numbered(&NOTES), &Registry::standard(), None).map(|_| ()).unwrap_err();
    assert!(error.to_string().starts_with("claims.json:") && error.message().contains("bead_on_a_hoop"), "{error}");
}

#[test]
fn a_parameter_that_no_symbol_stands_for_is_an_error() {
    let mut claims = hoop();
    claims["constants"] = json!({ r"m, b, g, \Omega": "> 0" });
    let error = document(&claims, &numbered(&NOTES), &registry(), None).map(|_| ()).unwrap_err();
    assert!(error.to_string().starts_with("claims.json:") && error.message().contains("parameter a"), "{error}");
    // The twin: said to be b, it is b.
    claims["system"] = json!({ "name": "bead_on_a_hoop", "read": { "a": "b" } });
    let notes =
        NOTES.map(|latex| latex.replace(" a", " b").replacen(r"{a ", r"{b ", 1).replacen(r"a \dd", r"b \dd", 1));
    let found = document(&claims, &numbered(&notes.each_ref().map(String::as_str)), &registry(), None).unwrap();
    assert!(found.equations.iter().all(|equation| equation.ok), "{:#?}", found.equations);
}

#[test]
fn a_singular_mass_matrix_is_told_with_its_condition_number() {
    let claims = json!({
        "system": "two_for_one",
        "coordinates": { "x, y": "any" },
        "constants": { "m": "> 0" },
    });
    let found = document(&claims, &numbered(&[r"m \ddot x = -y"]), &registry(), None).unwrap();
    let finding = &found.equations[0].finding;
    assert_eq!(finding.verdict, Undecided);
    assert!(finding.message.contains("mass matrix") && finding.message.contains("condition"), "{}", finding.message);
    // What needs no accelerations is checked all the same.
    let found = document(&claims, &numbered(&[r"p_x = m (\dot x + \dot y)"]), &registry(), None).unwrap();
    assert_eq!(outcome(&found.equations[0].finding), Verified);
    let wrong = document(&claims, &numbered(&[r"p_x = m (\dot x - \dot y)"]), &registry(), None).unwrap();
    assert!(matches!(wrong.equations[0].finding.verdict, Refuted | Undecided));
}

/// A particle near the speed of light on a spring, with its own Lagrangian in the notes.
fn fast() -> Json {
    json!({
        "coordinates": { "x": "any" },
        "constants": { "m, c, k": "> 0" },
        "means": { "L": "Lagrangian" },
    })
}

const FAST: [&str; 4] = [
    r"L(x, \dot x) = -m c^2 \sqrt{1 - \frac{\dot x^2}{c^2}} - \frac12 k x^2",
    r"H(x, p) = \sqrt{m^2 c^4 + p^2 c^2} + \frac12 k x^2",
    r"\dot x = \frac{p}{\sqrt{m^2 + p^2/c^2}}",
    r"\frac{d}{dt} H(x, p) = 0",
];

#[test]
fn a_state_without_a_lagrangian_says_nothing_of_the_system() {
    let found = document(&fast(), &numbered(&FAST), &Registry::standard(), None).unwrap();
    assert!(found.equations.iter().all(|equation| equation.ok), "{:#?}", found.equations);
    for (place, printed, slip) in [(2, "m^2 c^4", "m^2 c^2"), (3, "m^2 + p", "m^2 - p"), (3, "p^2/c^2", "p/c^2")] {
        let typo = FAST[place - 1].replacen(printed, slip, 1);
        let mut notes = FAST;
        notes[place - 1] = &typo;
        let found = document(&fast(), &numbered(&notes), &Registry::standard(), Some(&place.to_string())).unwrap();
        assert_eq!(found.equations[0].finding.verdict, Refuted, "{typo}: {}", found.equations[0].finding.message);
    }
}

#[test]
fn a_list_in_parentheses_is_what_a_name_depends_on() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let notes = [
        r"V = \frac12 k x^2 y^2",
        r"L = \frac12 m (\dot x^2 + \dot y^2) - V(x, y)",
        r"H(x, y, p_x, p_y) = \frac{p_x^2 + p_y^2}{2m} + V",
        r"m \ddot x = -k x y^2",
    ];
    let found = |notes: &[&str]| document(&claims, &numbered(notes), &Registry::standard(), None);
    let right = found(&notes).unwrap();
    assert!(right.equations.iter().all(|equation| equation.ok), "{:#?}", right.equations);
    let wrong = found(&[notes[0], notes[1], &notes[2].replace("+ V", "- V"), notes[3]]).unwrap();
    assert_eq!(wrong.equations[2].finding.verdict, Refuted);
    // With other arguments, or in another order, it may be another value.
    for arguments in ["(y, x)", "(x, m)", "(x, x)"] {
        let other = found(&[notes[0], &notes[1].replace("(x, y)", arguments), notes[2], notes[3]]);
        assert!(other.is_err(), "{arguments}");
    }
}

#[test]
fn a_name_from_its_own_formula_is_its_argument() {
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let found = |potential: &str| {
        let lagrangian = format!(r"L = \frac12 m \dot x^2 - {potential}");
        let notes = [r"V = \frac12 k x^2", &lagrangian, r"m \ddot x = -k x"];
        document(&claims, &numbered(&notes), &Registry::standard(), None)
    };
    assert!(found("V(x)").unwrap().equations.iter().all(|equation| equation.ok));
    // What V does not contain may be a factor.
    assert!(found("V(m)").is_err() && found(r"k(x)").is_err());
}

#[test]
fn beside_the_solution_for_one_coordinate_another_may_be_constant() {
    let claims = json!({
        "coordinates": { "r": "> 0", r"\theta": "angle" },
        "constants": { r"m, k, g, \ell": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let spring = r"L = \frac12 m(\dot r^2 + r^2\dot\theta^2) + m g r\cos\theta - \frac12 k(r - \ell)^2";
    let moves = |place: &str, angle: &str| {
        format!(r"r(t) = \ell {place} + A\cos\left(\sqrt{{\frac km}}\,t\right), \qquad \theta(t) = {angle}")
    };
    let of = |place, angle| verdict(&claims, &[spring, &moves(place, angle)], json!({}));
    assert!(of(r"+ \frac{m g}{k}", "0").passes());
    assert_eq!(of("", "0"), Refuted);
    assert_eq!(of(r"+ \frac{m g}{k}", r"\frac{\pi}{2}"), Refuted);
    // Nothing moves in it, so it is no solution: it is a value, and does not follow.
    assert_eq!(verdict(&claims, &[spring, r"\theta = 0"], json!({})), Refuted);
}
