//! Where doubles end: numbers too large for them and too small, and sides that they cannot tell apart.

use onshell::check::Finding;
use onshell::check::Verdict::{Certified, Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::{equation, with};

fn claims() -> Json {
    json!({ "constants": { "a, b": "> 0", "x, y": "any", "s": "(-1000, 1000)", "d": "(400, 900)" } })
}

fn of(latex: &str) -> Finding {
    equation(&claims(), &[latex], json!({})).finding
}

#[test]
fn overflow_is_no_counterexample_and_no_end_of_a_formula() {
    for (right, wrong) in [
        ("e^x > 0", "e^x > 1"),
        (r"e^x \geq 1 + x", r"e^x \geq 1.01 + x"),
        (r"\cosh x \geq 1", r"\cosh x \geq 1.001"),
        (r"e^{x^2} \geq 1 + x^2", "e^{x^2} > 1 + x^2"),
        ("e^{-x^2} > 0", r"e^{-x^2} > 10^{-3}"),
        ("e^{-a} < 1", "e^{-a} < 0.9"),
        ("e^a > 1 + a + \\frac{a^2}{2}", "e^a > 1 + a + \\frac{a^2}{1.9}"),
        ("e^{a + b} > e^a", "e^{a + b} > 1.1 e^a"),
        ("e^{e^x} > 1", "e^{e^x} > 2.7"),
        (r"\sinh x < \cosh x", r"\sinh x < 0.99 \cosh x"),
    ] {
        assert_eq!(of(right).verdict, Verified, "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
}

#[test]
fn what_is_approached_is_not_reached() {
    for (right, wrong) in [
        (r"\tanh x < 1", r"\tanh x < 0.9999"),
        (r"\arctan(e^x) > 0", r"\arctan(e^x) > 0.01"),
        (r"1 + e^{-a} > 1", r"1 + e^{-a} > 1.01"),
    ] {
        assert_eq!(of(right).verdict, Verified, "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
    // Reached at 0 alone, and at all negative numbers.
    assert_eq!(of(r"\tanh^2 x > 0").verdict, Refuted);
    assert_eq!(of("x + |x| > 0").verdict, Refuted);
}

#[test]
fn an_equality_is_tested_where_its_numbers_are_finite() {
    for (right, wrong) in [
        ("e^s e^{-s} = 1", "e^s e^{-s} = 1 + 10^{-3} s^2"),
        (r"\cosh^2 s - \sinh^2 s = 1", r"\cosh^2 s + \sinh^2 s = 1"),
        ("e^{d} e^{-d} = 1", "e^{d} e^{-d} = 2"),
    ] {
        assert_eq!(of(right).verdict, Certified, "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
    // Both sides are 0 to a double.
    let far = with(&claims(), "constants", json!({ "d": "(800, 900)" }));
    assert!(!equation(&far, &["e^{-d} = 2 e^{-d}"], json!({})).finding.verdict.passes());
}
