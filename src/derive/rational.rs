//! Exact coefficients: rational numbers with checked arithmetic.
//!
//! A coefficient of more than 128 bits is an error, never a wrong number.

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedMul, One, Signed};

use crate::scalar::rational::{self, ExactConstant};
use crate::{Error, Result};

/// A rational number in lowest terms.
pub(super) type Exact = Ratio<i128>;

/// The largest numerator or denominator of a fraction that is typeset as one; others are typeset as decimals.
const SIMPLE: i128 = 1_000_000;

fn too_large() -> Error {
    Error::new("a coefficient is too large for exact arithmetic with 128 bits")
        .help("write constants with fewer digits")
}

/// a + b.
pub(super) fn plus(a: Exact, b: Exact) -> Result<Exact> {
    a.checked_add(&b).ok_or_else(too_large)
}

/// a · b.
pub(super) fn times(a: Exact, b: Exact) -> Result<Exact> {
    a.checked_mul(&b).ok_or_else(too_large)
}

/// The square root, if it is rational.
pub(super) fn root(a: Exact) -> Option<Exact> {
    let whole = |n: i128| {
        let near = (n as f64).sqrt() as i128;
        (near.saturating_sub(1)..=near.saturating_add(1)).find(|r| i128::checked_mul(*r, *r) == Some(n))
    };
    (!a.is_negative()).then_some(())?;
    Some(Ratio::new(whole(*a.numer())?, whole(*a.denom())?))
}

/// The greatest common divisor of two rational numbers.
pub(super) fn common(a: Exact, b: Exact) -> Exact {
    fn gcd(a: i128, b: i128) -> i128 {
        if b == 0 { a } else { gcd(b, a % b) }
    }
    let least = |a: i128, b: i128| (a / gcd(a, b)).checked_mul(b);
    match least(*a.denom(), *b.denom()) {
        Some(denominator) => Ratio::new(gcd(a.numer().abs(), b.numer().abs()), denominator),
        None => Exact::one(),
    }
}

/// Whether a number is typeset as a fraction.
pub(super) fn is_simple(a: Exact) -> bool {
    a.numer().abs() <= SIMPLE && *a.denom() <= SIMPLE
}

/// The exact constant that an `f64` was written for: a rational number, and whether it is to be
/// multiplied by π.
pub(super) fn read(x: f64) -> Result<(Exact, bool)> {
    let exact = |ratio: rational::Ratio| Ratio::new(ratio.numerator.into(), ratio.denominator.into());
    match rational::exact_constant(x) {
        Some(ExactConstant::Ratio(ratio)) => Ok((exact(ratio), false)),
        Some(ExactConstant::MultipleOfPi(ratio)) => Ok((exact(ratio), true)),
        None => Err(Error::new(format!("the constant {x} has no exact form and cannot be typeset"))
            .help("use an integer, a fraction, a decimal or a multiple of π")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_are_read_as_what_was_written() {
        let read = |x| read(x).map(|(value, pi)| (*value.numer(), *value.denom(), pi)).unwrap();
        assert_eq!(read(0.5), (1, 2, false));
        assert_eq!(read(-1.0 / 3.0), (-1, 3, false));
        assert_eq!(read(9.81), (981, 100, false));
        assert_eq!(read(0.1), (1, 10, false));
        assert_eq!(read(0.0), (0, 1, false));
        assert_eq!(read(std::f64::consts::PI), (1, 1, true));
        assert_eq!(read(-std::f64::consts::FRAC_PI_2), (-1, 2, true));
        // must-fail cases: near is not equal, and the root of 2 is no multiple of π
        assert_ne!(read(0.333_333), (1, 3, false));
        assert_ne!(read(3.125), (1, 1, true));
        assert!(!read(std::f64::consts::SQRT_2).2);
        for x in [std::f64::consts::SQRT_2, 0.1 + 0.2, 6.674e-11, 299_792_458.0] {
            let (numerator, denominator, _) = read(x);
            assert_eq!(numerator as f64 / denominator as f64, x);
        }
    }

    #[test]
    fn what_has_no_exact_value_is_refused() {
        for x in [f64::NAN, f64::INFINITY, 1e300] {
            assert!(read(x).is_err(), "{x}");
        }
        assert!(times(Ratio::from_integer(i128::MAX), Ratio::from_integer(2)).is_err());
        assert!(plus(Ratio::from_integer(i128::MAX), Exact::one()).is_err());
    }

    #[test]
    fn roots_and_common_divisors() {
        assert_eq!(root(Ratio::new(9, 4)), Some(Ratio::new(3, 2)));
        assert_eq!((root(Ratio::new(1, 2)), root(Ratio::new(-4, 1))), (None, None));
        assert_eq!(common(Ratio::new(1, 2), Ratio::new(3, 4)), Ratio::new(1, 4));
        assert_eq!(common(Ratio::new(-6, 1), Ratio::new(4, 1)), Ratio::new(2, 1));
    }
}
