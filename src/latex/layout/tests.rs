//! Braceless arguments, and what is open and never closed.

use super::super::lexer::tokens;
use super::{Layout, layout};

fn faults(text: &str) -> usize {
    format!("{:?}", layout(&tokens(text), text.len())).matches("Fault(Fault").count()
}

#[test]
fn braceless_arguments_take_one_token() {
    let items = layout(&tokens("\\frac12m"), 8);
    assert_eq!(items.len(), 2);
    assert!(matches!(&items[0].layout, Layout::Fraction(a, b)
        if a.layout == Layout::Number("1".into()) && b.layout == Layout::Number("2".into())));
}

#[test]
fn what_is_open_must_be_closed() {
    assert_eq!(faults("\\left(a+b\\right)"), 0);
    for text in ["(a+b", "a)", "{a", "\\left(a", "\\frac1", "|a", "\\begin{pmatrix}a", "x^", "x^1^2"] {
        assert!(faults(text) > 0, "{text}");
    }
}

#[test]
fn nesting_without_braces_is_nesting() {
    assert_eq!(faults(&format!("{}x", "\\sqrt".repeat(100_000))), 1);
    assert_eq!(faults("\\sqrt\\dot x"), 0);
}

#[test]
fn a_hundred_thousand_braces_are_one_fault() {
    assert_eq!(faults(&"{".repeat(100_000)), 1);
    assert_eq!(faults(&"(".repeat(100_000)), 1);
}

#[test]
fn a_prime_after_a_thin_space_belongs_to_what_stands_before_it() {
    let primes = |text: &str| match &layout(&tokens(text), text.len())[0].layout {
        Layout::Scripts { primes, .. } => *primes,
        _ => 0,
    };
    assert_eq!((primes("\\vec v\\,'"), primes("\\vec v\\,''"), primes("v_1\\,'")), (1, 2, 1));
    assert_eq!(primes("\\vec v\\,a'"), 0);
}
