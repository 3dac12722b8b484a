//! Numbers of many digits, and states at which doubles lose theirs: no pair that differs passes, and no equal pair fails.

use onshell::check::Finding;
use onshell::check::Verdict::{Certified, Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::equation;

fn claims() -> Json {
    json!({ "constants": { "a, b": "> 0", "x, y": "any" } })
}

fn of(latex: &str) -> Finding {
    equation(&claims(), &[latex], json!({})).finding
}

#[test]
fn a_number_near_a_multiple_of_pi_is_not_that_multiple() {
    for (right, wrong) in [
        (r"2 \cdot 170131365.5\pi = 340262731\pi", r"1068966896 = 340262731\pi"),
        (r"\frac{1352\pi}{66} x = \frac{676\pi}{33} x", r"64.3550495099 x = \frac{676\pi}{33} x"),
        (r"\sin(x + \pi) = -\sin x", r"\sin(x + 3.141592653589793) = -\sin x"),
        (r"\cos(2\pi + x) = \cos x", r"\cos(6.283185307179586 + x) = \cos x"),
    ] {
        assert!(of(right).verdict.holds(), "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
}

#[test]
fn every_printed_digit_counts() {
    for (right, wrong) in [
        (r"e^{1.00 x} = e^x", r"e^{1.0000000000000001 x} = e^x"),
        (r"1.0000000000000000000 x = x", r"1.0000000000000000000000000001 x = x"),
        (HUNDRED_ONES, HUNDRED_ONES_AND_A_TWO),
        (r"\ln(a^{2.0}) = 2 \ln a", r"\ln(a^{2.00000000000000000001}) = 2 \ln a"),
        (r"\arctan(0.1 x) = \arctan\frac{x}{10}", r"\arctan(0.10000000000000000000000001 x) = \arctan\frac{x}{10}"),
        (r"\sin(2.5 x) = \sin\frac{5x}{2}", r"\sin(2.5000000000000000000000000000000001 x) = \sin\frac{5x}{2}"),
    ] {
        assert!(matches!(of(right).verdict, Certified | Verified), "{right}: {:?}", of(right));
        assert!(!of(wrong).verdict.holds(), "{wrong}: {:?}", of(wrong));
    }
}

#[test]
fn underflow_refutes_nothing() {
    for (right, wrong) in [
        (r"\sqrt{x^{100}} = |x|^{50}", r"\sqrt{x^{100}} = |x|^{49}"),
        (r"\sqrt{a^{400}} = a^{200}", r"\sqrt{a^{400}} = a^{201}"),
        (r"|x^{41}| = |x|^{41}", r"|x^{41}| = |x|^{40}"),
    ] {
        assert!(of(right).verdict.holds(), "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
}

#[test]
fn what_agrees_to_hundreds_of_digits_may_still_differ() {
    // tanh 15627 is below 1 by 10⁻¹³⁵⁷³, and no number of digits that is tried shows it.
    for (right, wrong) in [
        (r"\tanh(1000 + x^2) = \frac{\sinh(1000 + x^2)}{\cosh(1000 + x^2)}", r"\tanh(1000 + x^2) = 1"),
        (r"\tanh(15627) x = x \tanh(15627)", r"\tanh(15627) x = 1.000001 x \tanh(15627 \cdot 1.000001)"),
        (r"1 + e^{-40} x = 1 + x e^{-40}", r"1 + e^{-5000 - x^2} = 1"),
        (r"\coth(2000) x = x \coth(2000)", r"\coth(2000) x = x"),
    ] {
        assert!(!matches!(of(right).verdict, Refuted), "{right}: {:?}", of(right));
        assert!(!of(wrong).verdict.holds(), "{wrong}: {:?}", of(wrong));
    }
    // What doubles lose and more digits show is still refuted.
    assert_eq!(of(r"\tanh(100) x = x").verdict, Refuted);
}

/// Numbers that differ in the last of their hundred digits.
const HUNDRED_ONES: &str = r"\sin(0.1111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111 x) = \sin(0.11111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111110 x)";
const HUNDRED_ONES_AND_A_TWO: &str = r"\sin(0.1111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111 x) = \sin(0.1111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111111112 x)";
