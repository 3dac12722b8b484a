//! Rational reconstruction: the exact constant that an `f64` was written for. It is a short decimal, the simplest
//! fraction that rounds to it, or a simple multiple of π.
//!
//! 1/3 has no exact `f64`, and a traced formula that contains its rounding means the fraction. The normal form of derived
//! formulas reads its constants by this rule, in order to show them. What decides a verdict does not: a printed number is
//! the decimal that is printed, and of an `f64` in a Lagrangian only a short decimal is taken for exact.

use std::f64::consts::PI;

/// A fraction in lowest terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Ratio {
    /// The numerator.
    pub numerator: i64,
    /// The denominator, not 0.
    pub denominator: u64,
}

/// The exact constant that an `f64` was written for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ExactConstant {
    /// A fraction.
    Ratio(Ratio),
    /// A fraction of π.
    MultipleOfPi(Ratio),
}

/// The largest denominator of a part of π: three hundred and sixty parts of a turn, and a margin.
const PARTS_OF_PI: u64 = 720;

impl Ratio {
    /// A whole number.
    pub const fn whole(numerator: i64) -> Self {
        Ratio { numerator, denominator: 1 }
    }

    /// A fraction, in lowest terms; `None` where it does not fit, or the denominator is 0.
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs()) as i128;
        let sign = denominator.signum();
        let (numerator, denominator) = (sign * numerator / divisor, sign * denominator / divisor);
        Some(Ratio { numerator: numerator.try_into().ok()?, denominator: denominator.try_into().ok()? })
    }

    /// The fraction that decimal digits write: `2`, `0.25`, `1e-3`; `None` where it does not fit, or they write none.
    ///
    /// ```
    /// use onshell::scalar::Ratio;
    /// assert_eq!(Ratio::from_decimal("0.25"), Ratio::new(1, 4));
    /// assert_eq!(Ratio::from_decimal("1.0000000000000000000001"), None);
    /// ```
    pub fn from_decimal(digits: &str) -> Option<Self> {
        let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        if whole.is_empty() && part.is_empty() {
            return None;
        }
        let mut numerator = 0_i128;
        for digit in whole.chars().chain(part.chars()) {
            numerator = numerator.checked_mul(10)?.checked_add(digit.to_digit(10)?.into())?;
        }
        let places = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(part.len()).ok()?)?;
        let power = 10_i128.checked_pow(places.unsigned_abs())?;
        if places < 0 { Ratio::new(numerator, power) } else { Ratio::new(numerator.checked_mul(power)?, 1) }
    }

    /// The quotient, where it fits and the divisor is not 0.
    pub fn over(self, other: Ratio) -> Option<Ratio> {
        self.times(other.inverse()?)
    }

    /// Whether it is a whole number.
    pub fn is_whole(self) -> bool {
        self.denominator == 1
    }

    /// The product, where it fits.
    pub fn times(self, other: Ratio) -> Option<Ratio> {
        Ratio::new(
            i128::from(self.numerator) * i128::from(other.numerator),
            i128::from(self.denominator) * i128::from(other.denominator),
        )
    }

    /// The sum, where it fits.
    pub fn plus(self, other: Ratio) -> Option<Ratio> {
        let across = |a: Ratio, b: Ratio| i128::from(a.numerator).checked_mul(i128::from(b.denominator));
        let numerator = across(self, other)?.checked_add(across(other, self)?)?;
        Ratio::new(numerator, i128::from(self.denominator) * i128::from(other.denominator))
    }

    /// The opposite, where it fits.
    pub fn negated(self) -> Option<Ratio> {
        Some(Ratio { numerator: self.numerator.checked_neg()?, ..self })
    }

    /// The reciprocal, where there is one that fits.
    pub fn inverse(self) -> Option<Ratio> {
        Ratio::new(i128::from(self.denominator), i128::from(self.numerator))
    }

    /// The nearest `f64`.
    pub fn value(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

/// The exact constant that an `f64` was written for, to be shown. `None` for a number that is not finite, or too large
/// or small.
pub fn exact_constant(x: f64) -> Option<ExactConstant> {
    if let Some(decimal) = short_decimal(x) {
        return Some(ExactConstant::Ratio(decimal));
    }
    let part = simplest_rational(x / PI).filter(|part| part.denominator <= PARTS_OF_PI && part.numerator != 0);
    // π times a fraction may be off by a rounding
    let of_pi = part.or_else(|| near(x / PI)).filter(|part| (part.value() * PI - x).abs() <= x.abs() * f64::EPSILON);
    of_pi.map(ExactConstant::MultipleOfPi).or_else(|| simplest_rational(x).map(ExactConstant::Ratio))
}

/// The fraction with a denominator that a part of π may have, if one lies within a rounding.
fn near(x: f64) -> Option<Ratio> {
    let next = |x: f64, by: i64| f64::from_bits(x.to_bits().wrapping_add_signed(by));
    [-1, 1]
        .into_iter()
        .filter_map(|by| simplest_rational(next(x, by)))
        .find(|part| part.denominator <= PARTS_OF_PI && part.numerator != 0)
}

/// A decimal of at most this many significant digits is taken literally. A longer one may be a rounded fraction.
const SHORT_DECIMAL_DIGITS: usize = 12;

/// The decimal that is the shortest to round to `x`, if it is short: what an author of a Lagrangian in Rust wrote.
pub fn short_decimal(x: f64) -> Option<Ratio> {
    if x == 0.0 {
        return Some(Ratio::whole(0));
    }
    if !x.is_finite() {
        return None;
    }
    let text = format!("{x:e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let places = exponent.parse::<i32>().ok()? - (digits.len() as i32 - 1);
    if digits.len() > SHORT_DECIMAL_DIGITS || places.abs() > 18 {
        return None;
    }
    let (size, power) = (digits.parse::<i128>().ok()?, 10_i128.pow(places.unsigned_abs()));
    let size = if x < 0.0 { -size } else { size };
    if places < 0 { Ratio::new(size, power) } else { Ratio::new(size.checked_mul(power)?, 1) }
}

/// The decimal that an `f64` was written as, where that is short; else the fraction with the smallest denominator among
/// those that round to it.
pub fn simplest_rational(x: f64) -> Option<Ratio> {
    if x == 0.0 {
        return Some(Ratio::whole(0));
    }
    if !(1e-15..1e18).contains(&x.abs()) {
        return None;
    }
    if let Some(decimal) = short_decimal(x) {
        return Some(decimal);
    }
    let is_near = |n: u128, d: u128| d != 0 && n as f64 / d as f64 == x.abs();
    // x is a whole number of 2⁻ˢ: its continued fraction is exact
    let shift = (52 - (x.abs().log2().floor() as i32)).clamp(0, 112) as u32;
    let (mut a, mut b) = ((x.abs() * 2f64.powi(shift as i32)) as u128, 1_u128 << shift);
    let (mut before, mut last) = ((0_u128, 1_u128), (1_u128, 0_u128));
    while b != 0 {
        let quotient = a / b;
        let at = |t: u128| {
            Some((t.checked_mul(last.0)?.checked_add(before.0)?, t.checked_mul(last.1)?.checked_add(before.1)?))
        };
        let convergent = at(quotient)?;
        if is_near(convergent.0, convergent.1) {
            // of the fractions on the way to it the first that rounds to x
            let (mut low, mut high) = (0, quotient);
            while low < high {
                let middle = low + (high - low) / 2;
                let (n, d) = at(middle)?;
                if is_near(n, d) { high = middle } else { low = middle + 1 }
            }
            let (n, d) = at(low)?;
            let sign = if x < 0.0 { -1 } else { 1 };
            return Ratio::new(sign * i128::try_from(n).ok()?, i128::try_from(d).ok()?);
        }
        (before, last) = (last, convergent);
        (a, b) = (b, a % b);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_means_the_simplest_fraction_that_rounds_to_it() {
        let ratio = |x: f64| simplest_rational(x).map(|r| (r.numerator, r.denominator));
        for n in -40..=40_i64 {
            for d in 1..=40_u64 {
                let divisor = gcd(n.unsigned_abs().into(), d.into()) as i64;
                assert_eq!(ratio(n as f64 / d as f64), Some((n / divisor, d / divisor as u64)));
            }
        }
        assert_eq!(ratio(0.1), Some((1, 10)));
        assert_eq!(ratio(1.000000001), Some((1_000_000_001, 1_000_000_000)));
        assert_eq!(ratio(-2.5e-7), Some((-1, 4_000_000)));
        assert_eq!(ratio(9.81), Some((981, 100)));
        assert_eq!(ratio(1e15), Some((1_000_000_000_000_000, 1)));
        for none in [f64::NAN, f64::INFINITY, 1e300, 1e-300] {
            assert_eq!(simplest_rational(none), None);
        }
        // must-fail case: the next number is another one
        assert_ne!(ratio(0.1_f64.next_up()), Some((1, 10)));
    }

    #[test]
    fn a_printed_number_is_the_fraction_that_its_digits_write() {
        let ratio = |n, d| Ratio::new(n, d);
        for (digits, expected) in [
            ("2", ratio(2, 1)),
            ("0.250", ratio(1, 4)),
            (".5", ratio(1, 2)),
            ("12e-1", ratio(6, 5)),
            ("1.5e3", ratio(1500, 1)),
            ("1.00000000000000001", ratio(100_000_000_000_000_001, 100_000_000_000_000_000)),
        ] {
            assert!(expected.is_some());
            assert_eq!(Ratio::from_decimal(digits), expected, "{digits}");
        }
        // must-fail cases: no digits, too many digits, and a neighbour that rounds to the same double
        for none in ["", ".", "x", "1e", "1.2.3", "1.0000000000000000000000001", "1e40"] {
            assert_eq!(Ratio::from_decimal(none), None, "{none}");
        }
        assert_ne!(Ratio::from_decimal("0.1"), Ratio::from_decimal("0.10000000000000001"));
    }

    #[test]
    fn parts_of_a_turn_are_parts_of_pi() {
        use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6, TAU};
        let of_pi = |n, d| Some(ExactConstant::MultipleOfPi(Ratio { numerator: n, denominator: d }));
        assert_eq!(exact_constant(PI), of_pi(1, 1));
        assert_eq!(exact_constant(-FRAC_PI_2), of_pi(-1, 2));
        assert_eq!(exact_constant(FRAC_PI_3), of_pi(1, 3));
        assert_eq!(exact_constant(FRAC_PI_6), of_pi(1, 6));
        assert_eq!(exact_constant(TAU), of_pi(2, 1));
        assert_eq!(exact_constant(3.0 * PI / 4.0), of_pi(3, 4));
        // must-fail cases
        assert_eq!(exact_constant(22.0 / 7.0), Some(ExactConstant::Ratio(Ratio { numerator: 22, denominator: 7 })));
        assert_eq!(exact_constant(12.5664), Some(ExactConstant::Ratio(Ratio { numerator: 7854, denominator: 625 })));
        // must-fail cases: a decimal within one rounding of a multiple of π is the decimal
        assert_eq!(exact_constant(1_068_966_896.0), Some(ExactConstant::Ratio(Ratio::whole(1_068_966_896))));
        assert!(matches!(exact_constant(64.355_049_509_9), Some(ExactConstant::Ratio(_))));
        assert_eq!(exact_constant(0.5), Some(ExactConstant::Ratio(Ratio { numerator: 1, denominator: 2 })));
    }
}
