//! What is left of one formula without the other.

use onshell::derive::{Class, Letter, difference};
use onshell::formula::{Symbols, text};
use onshell::latex::{Macros, read_formula};
use onshell::scalar::{DualNum, Graph, Symbol};

/// The difference of two functions of M, R, θ and φ, in words.
fn left_over(f: impl Fn([Symbol; 4]) -> [Symbol; 2]) -> onshell::Result<String> {
    let mut symbols = Symbols::open();
    let names = [
        ("M", Class::Parameter),
        ("R", Class::Parameter),
        ("\\theta", Class::Coordinate),
        ("\\phi", Class::Coordinate),
    ];
    let letters: Vec<Letter> = names
        .map(|(name, class)| Letter { expr: read_formula(name, &mut symbols, &Macros::default()).unwrap(), class })
        .into();
    let (graph, [printed, derived]) = Graph::record(|| f(std::array::from_fn(Symbol::input)))?;
    Ok(text::formula(&difference(&graph, printed, derived, &letters)?, &symbols))
}

#[test]
fn a_flipped_sign_leaves_twice_the_term() {
    let left = left_over(|[m, r, x, y]| [m * x + m * r * x.sin() + y, y - m * r * x.sin() + m * x]);
    assert_eq!(left.unwrap(), "2·M·R·sin(θ)");
}

#[test]
fn equal_formulas_leave_nothing() {
    for left in [
        left_over(|[m, _, x, _]| [m * x.sin().powi(2), m - m * x.cos().powi(2)]),
        left_over(|[m, _, x, y]| [m * (x - y).cos(), m * (x.cos() * y.cos() + x.sin() * y.sin())]),
        left_over(|[m, _, x, _]| [m * (x * 2.0).sin(), m * x.sin() * x.cos() * 2.0]),
        left_over(|[m, r, x, _]| [(m * m - r * r) / ((m - r) * x), (m + r) / x]),
        left_over(|[m, r, ..]| [(m + r).sqrt() * (m + r).sqrt(), m + r]),
        left_over(|[m, r, ..]| [(m + r).recip() + (m - r).recip(), m * 2.0 / (m * m - r * r)]),
        left_over(|[m, _, x, y]| [m * (x + y).exp(), m * x.exp() * y.exp()]),
        left_over(|[_, _, x, _]| [x.cosh().powi(2) - x.sinh().powi(2), x / x]),
        left_over(|[m, ..]| {
            [(m * std::f64::consts::PI).sin() * 0.0 + std::f64::consts::FRAC_PI_2, (m * 0.0 + 1.0).asin()]
        }),
    ] {
        assert_eq!(left.unwrap(), "0");
    }
    // the twins
    for left in [
        left_over(|[m, _, x, _]| [m * x.sin().powi(2), m - m * x.cos()]),
        left_over(|[m, _, x, y]| [m * (x + y).cos(), m * (x.cos() * y.cos() + x.sin() * y.sin())]),
        left_over(|[m, r, ..]| [(m * m).sqrt(), r]),
        left_over(|[_, _, x, _]| [x.cosh().powi(2) + x.sinh().powi(2), x / x]),
    ] {
        assert_ne!(left.unwrap(), "0");
    }
}

#[test]
fn what_cannot_be_written_is_refused() {
    for (left, word) in [
        (left_over(|[m, r, ..]| [m.atan2(r), r]), "atan2"),
        (left_over(|[m, r, ..]| [m * f64::INFINITY, r]), "no exact form"),
        (left_over(|[m, r, ..]| [m.powi(1_000_000) * (m + r).powi(1_000_000), r]), "exponent is too large"),
        (left_over(|[m, r, ..]| [m / (r - r * 1.0 + (m.sin().powi(2) + m.cos().powi(2) - 1.0)), r]), "identically 0"),
        (
            left_over(|[m, r, x, y]| [(m + r + x + y + m.sin() + r.sin() + x.sin() + y.sin()).powi(16).powi(3), r]),
            "too many terms",
        ),
    ] {
        let error = left.expect_err(word);
        assert!(error.message().contains(word), "{error}");
    }
}
