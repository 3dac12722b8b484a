//! What is offered for a wrong display that is more than an equation: one that defines names, or teaches units.

use onshell::check::{Equation, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, numbers, pendulum, with};

/// The first of some displays, all of which are claimed.
fn first(claims: &Json, displays: &[&str]) -> Equation {
    let equations: serde_json::Map<String, Json> = (1..=displays.len()).map(|n| (n.to_string(), json!({}))).collect();
    let claims = with(claims, "equations", json!(equations));
    let found = document(&claims, &numbered(displays), &Registry::standard(), None);
    found.unwrap_or_else(|error| panic!("{displays:?}: {error}")).equations.remove(0)
}

/// The first of some displays with each of the edits that are offered for it.
fn mended(claims: &Json, displays: &[&str]) -> Vec<String> {
    let wrong = first(claims, displays);
    assert!(!wrong.ok, "{displays:?}: {}", wrong.finding.message);
    let start = "$$\n".len();
    let text = |repair: &onshell::check::Repair| {
        let (before, after) = displays[0].split_at(repair.span.start - start);
        format!("{before}{}{}", repair.replacement, &after[repair.span.end - repair.span.start..])
    };
    wrong.repairs.iter().map(text).collect()
}

#[test]
fn a_wrong_definition_is_mended_where_it_stands() {
    let square = "s^2 = a^2 + 2 a b + b^2";
    assert_eq!(mended(&numbers(), &["s = a - b = b + a", square])[0], "s = a + b = b + a");
    // The twin: what stands on the name tells which of the two members is wrong.
    let square = "s^2 = a^2 - 2 a b + b^2";
    let all = mended(&numbers(), &["s = a - b = b + a", square]);
    assert!(!all.is_empty() && !all.contains(&"s = a + b = b + a".to_owned()), "{all:?}");
}

#[test]
fn a_name_may_be_used_before_the_display_says_what_it_is() {
    let displays = ["q = \\frac{a}{S} = \\frac{a}{a + b} \\, , \\quad S = a + 2 b", "q (a + b) = a", "S^2 - S a = S b"];
    let bare = |text: &str| text.replace(' ', "");
    assert_eq!(bare(&mended(&numbers(), &displays)[0]), bare(&displays[0].replace("a + 2 b", "a + b")));
}

#[test]
fn no_unit_is_learnt_from_what_is_wrong() {
    let claims = with(&pendulum(), "units", json!({ "m": "kg", "l": "m" }));
    let lost = r"m l^2 \ddot\theta = - m g \sin\theta";
    let all = mended(&claims, &[lost]);
    assert!(all.iter().any(|text| first(&claims, &[text]).finding.verdict == Verdict::Certified), "{all:?}");
    // The twin: a unit that is declared holds.
    let claims = with(&pendulum(), "units", json!({ "m": "kg", "l": "m", "g": "m^2/s^2" }));
    assert_eq!(mended(&claims, &[lost]), Vec::<String>::new());
}

#[test]
fn nothing_is_mended_to_an_equation_that_says_nothing() {
    let moving = json!({ "varies with time": { "x": "any" }, "constants": { "a, b, c, g": "> 0" } });
    for wrong in [
        "a + b = a",
        "ab = a",
        "a b c = a b",
        "x = 2x",
        "g = 0",
        r"\dot x = 0",
        r"x = \cos(a) x",
        r"\cos(a + b) = \cos a",
    ] {
        assert_eq!(mended(&moving, &[wrong]), Vec::<String>::new(), "{wrong}");
    }
    assert_eq!(mended(&pendulum(), &[r"\dot\theta = 0"]), Vec::<String>::new());
    // An energy is no slip for an angle; a term that was lost is one.
    let all = mended(&pendulum(), &[r"\ddot\theta = 0"]);
    assert!(!all.is_empty() && all.iter().all(|text| text.contains(r"\ddot\theta")), "{all:?}");
    // What is near to something is not near to 0, nor is 0 to itself.
    let near = |latex: &str| {
        let claims = with(&moving, "equations", json!({ "1": { "limit": r"x \to 0" } }));
        let found = document(&claims, &numbered(&[latex]), &Registry::standard(), None);
        let equation = found.unwrap_or_else(|error| panic!("{latex}: {error}")).equations.remove(0);
        (equation.ok, equation.repairs.into_iter().map(|repair| repair.replacement).collect::<Vec<_>>())
    };
    assert_eq!(near(r"\sqrt{\sin^2 x} \approx x"), (false, Vec::new()));
    let (ok, near) = near(r"\sin(a x) \approx b x");
    assert!(!ok && near.contains(&"a".to_owned()), "{near:?}");
    // The twins: where something is done in an identity, a slip in it is mended.
    for (wrong, right) in [
        ("(a + b)^2 = a^2 + ab + b^2", "(a + b)^2 = a^2 + 2ab + b^2"),
        (r"\sin^2 x = 1 + \cos^2 x", r"\sin^2 x = 1 - \cos^2 x"),
        ("a (b + c) = ab + bc", "a (b + c) = ab + ac"),
        ("a + a + b = 3a + b", "a + a + b = 2a + b"),
        ("a - b + c = c - b - a", "a - b + c = c - b + a"),
    ] {
        let bare = |text: &str| text.replace(r"\,", "").replace(' ', "");
        let all = mended(&moving, &[wrong]);
        assert!(all.iter().any(|text| bare(text) == bare(right)), "{wrong}: {all:?}");
    }
}
