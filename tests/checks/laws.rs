//! Laws and hypotheses that leave too little: one state alone, or none.

use onshell::check::Verdict::{self, Law, Refuted, Undecided, Verified};
use onshell::check::{Document, Equation};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{assuming, document, equation, numbered, numbers, outcome, verdict, with};

/// Two displays are laws; the third is claimed.
fn two_laws() -> Json {
    json!({
        "constants": { "m, k": "> 0" },
        "varies with time": { "x, y": "any", r"\vec u, \vec w": "any" },
        "laws": { "the first": "1", "the second": "2" },
    })
}

fn check(displays: [&str; 3], claim: Json) -> Document {
    let claims = with(&two_laws(), "equations", json!({ "3": claim }));
    document(&claims, &numbered(&displays), &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"))
}

fn verdicts(displays: [&str; 3]) -> Vec<Verdict> {
    check(displays, json!({})).equations.iter().map(|equation| outcome(&equation.finding)).collect()
}

fn message(equation: &Equation) -> &str {
    &equation.finding.message
}

#[test]
fn laws_that_leave_one_state_alone_are_named_and_prove_nothing() {
    for claim in ["x^2 = 0", "x y = 0", "x = 5y", "m x = k y^2"] {
        let found = check(["x + y = 0", "x - y = 0", claim], json!({}));
        for equation in &found.equations {
            assert_eq!(equation.finding.verdict, Undecided, "{claim}: {}", message(equation));
        }
        assert!(message(&found.equations[0]).contains("allow only one value of x"), "{}", message(&found.equations[0]));
        assert!(message(&found.equations[2]).contains("one value"), "{}", message(&found.equations[2]));
    }
    // Two laws that leave a choice.
    assert_eq!(verdicts(["x + y = 0", r"m \ddot x = -k x", r"m \ddot y = -k y"]), [Law, Law, Verified]);
    assert_eq!(verdicts(["x + y = 0", r"m \ddot x = -k x", r"m \ddot y = k y"]), [Law, Law, Refuted]);
}

#[test]
fn laws_of_vectors_that_leave_one_state_alone() {
    let opposite = r"\vec u + \vec w = \vec 0";
    assert_eq!(verdicts([opposite, r"\vec u - \vec w = \vec 0", r"\vec u \times \vec w = 3 \vec u"])[2], Undecided);
    assert_eq!(verdicts([opposite, r"\vec w = m \dot{\vec u}", r"\vec u = -m \dot{\vec u}"])[2], Verified);
    assert_eq!(verdicts([opposite, r"\vec w = m \dot{\vec u}", r"\vec u = m \dot{\vec u}"])[2], Refuted);
}

#[test]
fn laws_that_contradict_each_other_are_no_pass() {
    for (first, second) in [("x + y = m", "x + y = 2m"), (r"\dot x = k", r"\dot x = 2k")] {
        let found = check([first, second, r"\dot x^2 = 7 \dot x"], json!({}));
        assert!(found.equations.iter().all(|equation| !equation.ok), "{:?}", found.equations);
        assert!(
            message(&found.equations[0]).contains("no sampled state satisfies the laws"),
            "{}",
            message(&found.equations[0])
        );
    }
    // Each of two motions of one thing would stop it for good.
    let stopped = [r"m \ddot x = -k x", r"m \ddot x = -2k x", r"x \dot x = 0"];
    assert_eq!(verdicts(stopped), [Undecided; 3]);
    assert_eq!(
        verdicts([r"m \ddot x = -k x", r"m \ddot y = -2k y", r"k x \ddot y = 2 k \ddot x y"]),
        [Law, Law, Verified]
    );
}

#[test]
fn a_law_and_a_hypothesis_that_leave_one_state_alone() {
    let claims = json!({
        "varies with time": { "x, y": "any" },
        "laws": { "the constraint": "1" },
    });
    let second = |latex: &str, assume: &[&str]| verdict(&claims, &["x + y = 0", latex], assuming(assume));
    assert_eq!(second("x y^2 = 0", &["x = y"]), Undecided);
    assert_eq!(second("x = 0", &["x = y"]), Undecided);
    assert_eq!(second("x y^2 = 0", &[]), Refuted);
    assert_eq!(second("x y = -y^2", &[]), Verified);
}

#[test]
fn nothing_is_conserved_where_nothing_moves() {
    let conserved = |second: &str| {
        let displays = [r"m \ddot x = -k x", second, r"m \dot x^2 + k x^2 = k x^2 + m \dot x^2"];
        let found = check(displays, json!({ "conserved": true }));
        let whole = found.equations[2].parts.iter().find(|part| part.reading.contains("constant")).cloned();
        outcome(&whole.unwrap_or_else(|| panic!("{:?}", found.equations[2])).finding)
    };
    assert_eq!(conserved(r"m \ddot x = -2k x"), Undecided);
    assert_eq!(conserved(r"m \ddot y = -2k y"), Verified);
}

#[test]
fn hypotheses_that_together_fix_a_number_test_its_value_and_nothing_else() {
    let lines = |latex: &str, sum: &str| {
        equation(&with(&numbers(), "constants", json!({ "x, y": "any" })), &[latex], assuming(&[sum, "x - y = 1"]))
    };
    let found = lines("x^2 = 4", "x + y = 3");
    assert_eq!(found.finding.verdict, Undecided);
    assert!(message(&found).contains("allow only one value of x"), "{}", message(&found));
    // A system of equations that is solved for x.
    assert_eq!(outcome(&lines("x = 2", "x + y = 3").finding), Verified);
    assert_eq!(lines("x = 3", "x + y = 3").finding.verdict, Refuted);
}

#[test]
fn a_value_that_a_hypothesis_says_outright_is_the_authors_wish() {
    let angle = json!({ "constants": { r"\alpha": "(0, \\pi)", "a, b": "> 0" } });
    let at = |latex: &str, assume: &str| verdict(&angle, &[latex], assuming(&[assume]));
    for upright in [r"\alpha = \frac{\pi}{2}", r"\alpha = \pi - \alpha"] {
        assert_eq!(at(r"a \sin\alpha = a", upright), Verified, "{upright}");
        assert_eq!(at(r"a \sin\alpha = b", upright), Refuted, "{upright}");
    }
}

#[test]
fn sides_that_vanish_under_a_hypothesis_tell_no_factor() {
    let pendulum = crate::support::pendulum();
    let at_rest = |latex: &str| verdict(&pendulum, &[latex], assuming(&[r"\dot\theta = 0"]));
    assert_eq!(at_rest(r"T = 5m \dot\theta"), Undecided);
    assert_eq!(at_rest("T = 0"), Verified);
    assert_eq!(at_rest("E = U + T"), Verified);
    assert_eq!(at_rest("E = T"), Refuted);
}

#[test]
fn a_hypothesis_is_met_in_every_way_in_which_it_can_be() {
    let claims = with(&numbers(), "constants", json!({ "a, b": "> 0", "x, y, z": "any" }));
    let given = |latex: &str, assume: &str| verdict(&claims, &[latex], assuming(&[assume]));
    for (wrong, assume) in [
        ("y z = 0", "x y = 0"),
        ("x z = 0", "x y = 0"),
        ("y z = a z", "x y = a x"),
        ("y z = b z", "(x - a)(y - b) = 0"),
        ("x z = a z", "(x - a)(y - b) = 0"),
        ("y z = x z", "x^2 = y^2"),
    ] {
        assert_eq!(given(wrong, assume), Refuted, "{wrong} given {assume}");
    }
    assert_eq!(given("y^2 z = a y z", "y = a"), Verified);
    assert_eq!(given("y^2 z = x^2 z", "x^2 = y^2"), Verified);
    assert_eq!(given("x y z = b z x + a z y + a b z", "(x - a)(y - b) = 0"), Refuted);
    assert_eq!(given("x y z = b z x + a z y - a b z", "(x - a)(y - b) = 0"), Verified);
}

#[test]
fn what_is_constant_at_an_instant_is_not_conserved() {
    let pendulum = crate::support::pendulum();
    let conserved = |what: &str, assume: Json| {
        let claim = with(&assume, "conserved", json!(what));
        let found = equation(&pendulum, &["E = T + U"], claim);
        let part = found.parts.iter().find(|part| part.reading.contains("constant")).cloned();
        outcome(&part.unwrap_or_else(|| panic!("{found:?}")).finding)
    };
    // At the lowest point the kinetic energy is at its largest, and its rate zero.
    assert_ne!(conserved("T", json!({ "assume": r"\theta = 0" })), Verified);
    assert_eq!(conserved("E", json!({ "assume": "m = l" })), Verified);
    assert_eq!(conserved("T", json!({ "assume": "m = l" })), Refuted);
}

#[test]
fn a_definition_that_only_a_law_uses_is_held_by_what_follows_from_the_law() {
    let claims = json!({
        "constants": { "m, b, k": "> 0" },
        "varies with time": { "x": "any" },
        "laws": { "Newton": "2" },
        "equations": { "1": {}, "3": {} },
    });
    let law = r"\ddot x + 2 \gamma \dot x + \frac{k}{m} x = 0";
    let of = |definition: &str, power: &str| {
        let found = document(&claims, &numbered(&[definition, law, power]), &Registry::standard(), None);
        found.unwrap_or_else(|error| panic!("{error}")).equations
    };
    let power = r"m \dot x \ddot x + k x \dot x = - b \dot x^2";
    let found = of(r"\gamma = \frac{b}{2m}", power);
    assert!(found.iter().all(|equation| equation.ok), "{found:?}");
    assert!(message(&found[0]).contains("would contradict (3)"), "{}", message(&found[0]));
    // The twins: the definition is wrong; and what follows from the law does not say what γ is.
    assert!(!of(r"\gamma = \frac{b}{m}", power)[2].ok);
    let loose = of(r"\gamma = \frac{b}{2m}", r"\frac{d}{dt} x^2 = 2 x \dot x");
    assert_eq!(loose[0].finding.verdict, Undecided, "{}", message(&loose[0]));
}

#[test]
fn what_a_display_of_laws_says_of_a_name_is_checked_as_a_definition() {
    let claims = |law: &str| {
        json!({
            "constants": { "m, k": "> 0" },
            "varies with time": { "x": "any" },
            "laws": { "Newton": law },
        })
    };
    let of = |law: &str, momentum: &str| {
        let first = format!(r"\dot p = - k x , \quad {momentum}");
        let displays = [first.as_str(), r"\ddot x = - \frac{k}{m} x", r"p \dot p = - k m x \dot x"];
        let found = document(&claims(law), &numbered(&displays), &Registry::standard(), None);
        found.unwrap_or_else(|error| panic!("{error}")).equations
    };
    let found = of("1", r"p = m \dot x");
    assert!(found.iter().all(|equation| equation.ok) && found[0].finding.verdict == Law, "{found:?}");
    // The twins: a slip in it; and what is called a law by itself, and is none.
    assert!(of("1", r"p = 2 m \dot x").iter().any(|equation| !equation.ok));
    let called = of("1 part 2", r"p = m \dot x");
    assert!(called[0].parts[1].finding.message.contains("this is not a law"), "{called:?}");
}

#[test]
fn laws_that_determine_each_other_do_not_exhaust_the_stack() {
    // Each rate needs the two others, one derivative lower. A thread of a test has 2 MB.
    let claims = json!({
        "varies with time": { "x, y, z": "any" },
        "constants": { "a, b, c": "> 0" },
        "laws": { "Euler's equations": "1" },
    });
    let law = r"a \dot x = (b - c) y z, \quad b \dot y = (c - a) z x, \quad c \dot z = (a - b) x y";
    let energy = r"\frac{d^3}{dt^3} (a x^2 + b y^2 + c z^2) = 0";
    let found = document(&claims, &numbered(&[law, energy]), &Registry::standard(), None).expect("the claims fit");
    let verdicts: Vec<Verdict> = found.equations.iter().map(|equation| equation.finding.verdict).collect();
    assert_eq!(verdicts, [Verdict::Law, Verdict::Certified]);
}
