//! Inequalities at their edges: where two sides are equal no random state ever is.

use onshell::check::Verdict::{self, Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::{assuming, numbers, verdict, with};

/// Numbers of which y and z may have either sign as well.
fn signed() -> Json {
    with(&numbers(), "constants", json!({ "a, b, c": "> 0", "x, y, z": "any" }))
}

fn exactly(latex: &str, conditions: Json) -> Verdict {
    verdict(&signed(), &[latex], json!({ "true exactly when": conditions }))
}

fn holds(latex: &str, assume: &[&str]) -> Verdict {
    verdict(&signed(), &[latex], assuming(assume))
}

#[test]
fn the_edge_belongs_to_one_side_or_the_other() {
    assert_eq!(exactly("a^2 > b^2", json!("a > b")), Verified);
    assert_eq!(exactly("a^2 > b^2", json!(r"a \geq b")), Refuted);
    assert_eq!(exactly(r"a^2 \geq b^2", json!(r"a \geq b")), Verified);
    assert_eq!(exactly(r"a^2 \geq b^2", json!("a > b")), Refuted);
    // An edge where no number equals another.
    assert_eq!(exactly("x y z > a b c", json!("a b c < x y z")), Verified);
    assert_eq!(exactly("x y z > a b c", json!(r"a b c \leq x y z")), Refuted);
}

#[test]
fn an_edge_that_is_slightly_off_is_found() {
    for slightly in ["a > 1.001 b", "a > b + 10^{-4}", "1.00001 a > b"] {
        assert_eq!(exactly("a^2 > b^2", json!(slightly)), Refuted, "{slightly}");
    }
    assert_eq!(exactly("x^2 > a", json!({ "any of": [[r"x > \sqrt{a}"], [r"x < -\sqrt{a}"]] })), Verified);
    assert_eq!(exactly("x^2 > a", json!({ "any of": [[r"x > \sqrt{a}"], [r"x \leq -\sqrt{a}"]] })), Refuted);
    assert_eq!(exactly("x^2 > a", json!({ "any of": [[r"x > \sqrt{a}"], [r"x < -1.0001\sqrt{a}"]] })), Refuted);
}

#[test]
fn an_equality_among_the_alternatives_is_met() {
    assert_eq!(exactly(r"a \geq b + c", json!({ "any of": ["a > b + c", "a = b + c"] })), Verified);
    assert_eq!(exactly("a - c > b", json!({ "any of": ["a > b + c", "a = b + c"] })), Refuted);
    assert_eq!(exactly(r"x \neq y + z", json!({ "any of": ["x > y + z", "x < y + z"] })), Verified);
    assert_eq!(exactly(r"x \neq y + z", json!("x > y + z")), Refuted);
}

#[test]
fn an_inequality_is_tried_at_its_own_edge() {
    assert_eq!(holds("a^2 > b^2", &["a > b"]), Verified);
    assert_eq!(holds("a^2 > 1.001 b^2", &["a > b"]), Refuted);
    assert_eq!(holds(r"a^2 \geq b^2", &["a > b"]), Verified);
    assert_eq!(holds(r"a + \frac{1}{a} \geq 2", &[]), Verified);
    assert_eq!(holds(r"a + \frac{1}{a} \geq 2.001", &[]), Refuted);
    assert_eq!(holds("x^2 - 2xy + 1.001 y^2 + a > 0", &[]), Verified);
    assert_eq!(holds(r"x^2 - 2xy + 0.999 y^2 \geq 0", &[]), Refuted);
}

#[test]
fn what_is_equal_to_rounding_alone_is_no_edge() {
    // √(a² + b²) and a are one number to a double where b is tiny, and b is never 0.
    assert_eq!(holds(r"\sqrt{a^2 + b^2} > a", &[]), Verified);
    assert_eq!(holds(r"\sqrt{a^2 + x^2} > a", &[]), Refuted);
}

#[test]
fn an_excluded_end_of_a_range_is_no_state() {
    // At γ = 1 the two laws say T = S, and nothing of the volumes.
    let of = |range: &str| {
        let claims = json!({ "constants": { "T, S, A, B, C, D": "> 0", r"\gamma": range } });
        let laws = [r"T A^{\gamma - 1} = S B^{\gamma - 1}", r"T C^{\gamma - 1} = S D^{\gamma - 1}"];
        verdict(&claims, &[r"\frac{A}{C} = \frac{B}{D}"], json!({ "assume": laws }))
    };
    assert_ne!(of("(1, 3)"), Refuted);
    assert_eq!(of("[1, 3]"), Refuted);
}

#[test]
fn an_interval_may_have_no_end() {
    let of = |range: &str, latex: &str| verdict(&json!({ "constants": { "a": range } }), &[latex], json!({}));
    for range in [r"(1, \infty)", r"[1, \infty)"] {
        assert_eq!(of(range, r"a^2 \geq a"), Verified, "{range}");
        assert_eq!(of(range, r"a^2 < a"), Refuted, "{range}");
    }
    assert_eq!(of(r"(-\infty, 0)", "a < a^2"), Verified);
    assert_eq!(of(r"(-\infty, \infty)", r"a^2 \geq a"), Refuted);
}
