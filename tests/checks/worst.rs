//! Inequalities at their worst: where several numbers are at their ends together, or an expression has its extreme.

use onshell::check::Finding;
use onshell::check::Verdict::{Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation};

fn claims() -> Json {
    json!({ "constants": {
        "a, b, c": "> 0", "x, y, z": "any", "u, v": "(0, 1)", "w": "[0, 1]", "r": "[1, 2]",
        r"\theta, \phi": "angle", r"\alpha, \beta": r"(0, \pi)",
    } })
}

fn under(latex: &str, hypotheses: &[&str]) -> Finding {
    equation(&claims(), &[latex], assuming(hypotheses)).finding
}

/// What is true passes, and what is a little more than true has a counterexample that shows it.
fn the_bound_is(true_one: &str, false_one: &str, hypotheses: &[&str]) {
    let (holds, fails) = (under(true_one, hypotheses), under(false_one, hypotheses));
    assert_eq!(holds.verdict, Verified, "{true_one}: {holds:?}");
    assert_eq!(fails.verdict, Refuted, "{false_one}: {fails:?}");
    assert!(fails.counterexample.is_some(), "{false_one}: {fails:?}");
}

#[test]
fn at_a_corner_of_the_ranges() {
    for (right, wrong) in [
        ("u + v < 2", "u + v < 1.9"),
        ("u + v < 2", "u + v < 1.9999"),
        ("u v < 1", "u v < 0.95"),
        (r"w + r \leq 3", r"w + r \leq 2.99"),
        // These ranges contain their ends.
        (r"w + r \leq 3", "w + r < 3"),
        (r"a w \leq a", "a w < a"),
    ] {
        the_bound_is(right, wrong, &[]);
    }
}

#[test]
fn at_a_corner_of_the_hypotheses() {
    the_bound_is("a + b < 2", "a + b < 1.99", &["a < 1", "b < 1"]);
    the_bound_is("a + b + c < 3", "a + b + c < 2.99", &["a < 1", "b < 1", "c < 1"]);
    the_bound_is(r"a b < \frac14", "a b < 0.2499", &["a + b < 1"]);
    the_bound_is("a^2 + b^2 < 1", "a^2 + b^2 < 0.99", &["a + b < 1"]);
    the_bound_is(r"a b \leq 0.25", "a b < 0.25", &["a + b = 1"]);
    the_bound_is(r"x + y \leq \sqrt2", r"x + y \leq 1.414", &["x^2 + y^2 = 1"]);
    the_bound_is(r"x y z \leq 0.193", r"x y z \leq 0.19", &["x^2 + y^2 + z^2 = 1"]);
}

#[test]
fn at_an_extreme_inside_of_the_ranges() {
    for (right, wrong) in [
        (r"(a - 1)^2 \geq 0", "(a - 1)^2 > 0"),
        (r"(x - 7)^2 \geq 0", "(x - 7)^2 > 0"),
        ("(x - 50)^2 + 0.01 > 0", "(x - 50)^2 > 0"),
        ("x^2 + y^2 > 2x + 2y - 2.001", "x^2 + y^2 > 2x + 2y - 1.999"),
        (r"x^2 + y^2 + z^2 \geq 2x + 4y - 6z - 14", r"x^2 + y^2 + z^2 > 2x + 4y - 6z - 14"),
        (r"(x - y - 1)^2 + (x + y - 3)^2 \geq 0", "(x - y - 1)^2 + (x + y - 3)^2 > 0"),
        (r"|x - 1| + |y - 2| \geq 0", "|x - 1| + |y - 2| > 0"),
        (r"(x - 1)^2 + (y - 2)^2 + (z + 3)^2 \geq 0", "(x - 1)^2 + (y - 2)^2 + (z + 3)^2 > 0"),
        (r"u (1 - u) v (1 - v) \leq \frac{1}{16}", r"u (1 - u) v (1 - v) < \frac{1}{16}"),
        (r"u (1 - u) v (1 - v) < 0.0626", r"u (1 - u) v (1 - v) < 0.0624"),
        (r"x^2 - 2x + 1.001 \neq 0", r"x^2 - 2x + 1 \neq 0"),
    ] {
        the_bound_is(right, wrong, &[]);
    }
}

#[test]
fn where_all_like_numbers_are_equal() {
    for (right, wrong) in [
        (r"a^2 + b^2 + c^2 \geq ab + bc + ca", "a^2 + b^2 + c^2 > ab + bc + ca"),
        (r"a^2 + b^2 + c^2 \geq ab + bc + ca", r"a^2 + b^2 + c^2 \geq 1.001 (ab + bc + ca)"),
        (r"\frac{a + b + c}{3} \geq \sqrt[3]{abc}", r"\frac{a + b + c}{3} > \sqrt[3]{abc}"),
        (r"a^3 + b^3 + c^3 \geq 3abc", "a^3 + b^3 + c^3 > 3abc"),
        (
            r"\frac{a}{b + c} + \frac{b}{c + a} + \frac{c}{a + b} \geq \frac32",
            r"\frac{a}{b + c} + \frac{b}{c + a} + \frac{c}{a + b} \geq 1.501",
        ),
    ] {
        the_bound_is(right, wrong, &[]);
    }
}

#[test]
fn at_angles_that_are_special_together() {
    for (right, wrong) in [
        (r"\sin\theta \sin\phi \leq 1", r"\sin\theta \sin\phi < 1"),
        (r"\sin\theta + \cos\phi \leq 2", r"\sin\theta + \cos\phi \leq 1.999"),
        (r"\sin\alpha + \sin\beta \leq 2", r"\sin\alpha + \sin\beta < 2"),
        (r"\sin\theta + \cos\theta \leq \sqrt2", r"\sin\theta + \cos\theta < 1.41421"),
        (r"\cos(\theta - \phi) \leq 1", r"\cos(\theta - \phi) < 1"),
    ] {
        the_bound_is(right, wrong, &[]);
    }
}

/// A dip of 10⁻⁴ in three numbers, and what says that nothing is proved.
#[test]
fn a_narrow_dip_is_found_and_a_proof_is_named() {
    the_bound_is(
        "(x - y)^2 + (y - z)^2 + (z - 1.1)^2 + 10^{-8} > 0",
        "(x - y)^2 + (y - z)^2 + (z - 1.1)^2 - 10^{-8} > 0",
        &[],
    );
    for (latex, is_proved) in [
        ("(w - 0.5)^2 + 10^{-6} > 0", true),
        (r"\cos x \leq 1", true),
        (r"r^2 + w > 0.99", true),
        (r"e^x \geq 1 + x", false),
    ] {
        let found = under(latex, &[]);
        assert_eq!(found.verdict, Verified, "{latex}: {found:?}");
        let words = if is_proved { "proved for all values in the ranges" } else { "this is not a proof" };
        assert!(found.message.contains(words), "{latex}: {found:?}");
    }
}
