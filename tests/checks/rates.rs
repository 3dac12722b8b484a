//! Limits and small quantities: a coefficient that is off by little is off.

use onshell::check::Verdict;
use onshell::check::Verdict::{Refuted, Undecided, Verified};
use serde_json::{Value as Json, json};

use crate::support::verdict;

fn claims() -> Json {
    json!({ "constants": { "x": "any", "a": "> 0" } })
}

fn to_order(latex: &str, order: u32) -> Verdict {
    verdict(&claims(), &[latex], json!({ "small": "x", "order": order }))
}

fn towards(latex: &str, limit: &str) -> Verdict {
    verdict(&claims(), &[latex], json!({ "limit": limit }))
}

#[test]
fn a_coefficient_that_is_off_by_little_is_off() {
    for (order, right, wrong) in [
        (3, r"\sin x \approx x - \frac{x^3}{6}", r"\sin x \approx x - \frac{x^3}{6.00001}"),
        (2, r"\cos x \approx 1 - \frac{x^2}{2}", r"\cos x \approx 1 - \frac{x^2}{2.00000000000000000001}"),
        (2, r"e^x \approx 1 + x + 0.5 x^2", r"e^x \approx 1 + x + 0.5000000001 x^2"),
        (
            2,
            r"\sqrt{a + x} \approx \sqrt a + \frac{x}{2\sqrt a} - \frac{x^2}{8 a \sqrt a}",
            r"\sqrt{a + x} \approx \sqrt a + \frac{x}{2\sqrt a} - \frac{x^2}{8.0000001 a \sqrt a}",
        ),
        (1, r"\frac{1}{1 + x} \approx 1 - x", r"\frac{1}{1 + x} \approx 1 - 1.00000000000001 x"),
    ] {
        assert_eq!(to_order(right, order), Verified, "{right}");
        assert_eq!(to_order(wrong, order), Refuted, "{wrong}");
    }
}

#[test]
fn a_limit_that_is_off_by_little_is_off() {
    for (limit, right, wrong) in [
        (r"x \to 0", r"\frac{\sin x}{x} \approx 1", r"\frac{\sin x}{x} \approx 1.0000000000001"),
        (r"x \to \infty", r"\sqrt{x^2 + x} - x \approx \frac12", r"\sqrt{x^2 + x} - x \approx 0.50000000000001"),
        (r"a \to \infty", r"(1 + \frac{1}{a})^a \approx \exp(1)", r"(1 + \frac{1}{a})^a \approx 2.718281828459045"),
        (r"a \to \infty", r"\tanh a \approx 1", r"\tanh a \approx 1.000000000000001"),
    ] {
        let found = towards(right, limit);
        assert!(matches!(found, Verified | Undecided), "{right}: {found:?}");
        assert_eq!(towards(wrong, limit), Refuted, "{wrong}");
    }
    assert_eq!(towards(r"\frac{\sin x}{x} \approx 1", r"x \to 0"), Verified);
}

#[test]
fn a_limit_that_is_reached_slowly_is_not_refuted() {
    for latex in [r"\frac{\ln(2a)}{\ln a} \approx 1", r"\frac{\ln(a + 7)}{\ln(3a)} \approx 1"] {
        assert_ne!(towards(latex, r"a \to \infty"), Refuted, "{latex}");
    }
    assert_eq!(towards(r"\frac{\ln(2a)}{\ln a} \approx 2", r"a \to \infty"), Refuted);
}
