//! Rational exponents of units.
//!
//! Exponents are small numbers. Arithmetic that overflows 64 bits gives [`Ratio::LOST`]; every operation on it gives
//! [`Ratio::LOST`] again, and no conflict is reported from it.

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A fraction in lowest terms with a positive denominator, or [`Ratio::LOST`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Ratio {
    numerator: i64,
    /// The value 0 marks an overflow.
    denominator: i64,
}

impl Ratio {
    /// 0.
    pub const ZERO: Ratio = Ratio::whole(0);
    /// 1.
    pub const ONE: Ratio = Ratio::whole(1);
    /// The result of an overflow or of a division by 0.
    pub const LOST: Ratio = Ratio { numerator: 0, denominator: 0 };

    /// A whole number.
    pub const fn whole(value: i64) -> Ratio {
        Ratio { numerator: value, denominator: 1 }
    }

    /// A fraction; lost where the denominator is 0.
    pub fn new(numerator: i64, denominator: i64) -> Ratio {
        Ratio::reduced(numerator.into(), denominator.into())
    }

    /// Whether it is 0.
    pub fn is_zero(self) -> bool {
        self == Ratio::ZERO
    }

    /// Whether it is [`Ratio::LOST`].
    pub fn is_lost(self) -> bool {
        self.denominator == 0
    }

    /// 1 / self; lost for 0.
    pub fn inverse(self) -> Ratio {
        Ratio::reduced(self.denominator.into(), self.numerator.into())
    }

    /// The value, if it is a whole number.
    pub fn as_whole(self) -> Option<i64> {
        (self.denominator == 1).then_some(self.numerator)
    }

    fn reduced(numerator: i128, denominator: i128) -> Ratio {
        if denominator == 0 {
            return Ratio::LOST;
        }
        let (mut a, mut b) = (numerator.unsigned_abs(), denominator.unsigned_abs());
        while b > 0 {
            (a, b) = (b, a % b);
        }
        let common = (a as i128) * denominator.signum();
        match (i64::try_from(numerator / common), i64::try_from(denominator / common)) {
            (Ok(numerator), Ok(denominator)) => Ratio { numerator, denominator },
            _ => Ratio::LOST,
        }
    }
}

impl Add for Ratio {
    type Output = Ratio;
    fn add(self, other: Ratio) -> Ratio {
        let [a, b, c, d] = [self.numerator, self.denominator, other.numerator, other.denominator].map(i128::from);
        match (a * d).checked_add(c * b) {
            Some(sum) => Ratio::reduced(sum, b * d),
            None => Ratio::LOST,
        }
    }
}

impl Neg for Ratio {
    type Output = Ratio;
    fn neg(self) -> Ratio {
        Ratio::reduced(-i128::from(self.numerator), self.denominator.into())
    }
}

impl Sub for Ratio {
    type Output = Ratio;
    fn sub(self, other: Ratio) -> Ratio {
        self + -other
    }
}

impl Mul for Ratio {
    type Output = Ratio;
    fn mul(self, other: Ratio) -> Ratio {
        let [a, b, c, d] = [self.numerator, self.denominator, other.numerator, other.denominator].map(i128::from);
        Ratio::reduced(a * c, b * d)
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.numerator, self.denominator) {
            (_, 0) => f.write_str("?"),
            (whole, 1) => write!(f, "{whole}"),
            (above, below) => write!(f, "{above}/{below}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Ratio;

    #[test]
    fn fractions_are_in_lowest_terms() {
        assert_eq!(Ratio::new(2, -4), Ratio::new(-1, 2));
        assert_eq!(Ratio::new(1, 2) + Ratio::new(1, 3), Ratio::new(5, 6));
        assert_eq!(Ratio::new(2, 3) * Ratio::new(2, 3).inverse(), Ratio::ONE);
        assert_ne!(Ratio::new(1, 2), Ratio::new(1, 3));
    }

    #[test]
    fn what_leaves_64_bits_is_lost_and_stays_so() {
        let large = Ratio::whole(i64::MAX);
        assert!((large * large).is_lost() && (large + large - large).is_lost());
        assert!(Ratio::ZERO.inverse().is_lost() && (-Ratio::whole(i64::MIN)).is_lost());
        assert!((Ratio::new(1, i64::MAX) + Ratio::new(i64::MIN, i64::MAX - 1)).is_lost());
    }
}
