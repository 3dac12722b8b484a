//! Angles as labels of points on the unit circle over the field.

use super::modulus::Modulus;
use super::residue::Residue;
use crate::scalar::rational::Ratio;

/// A number as an angle: a sum of multiples of what was drawn, and a rest of which nothing is known.
#[derive(Clone, Copy)]
pub struct Angle<F> {
    /// The labels of the multiples, summed.
    pub label: u128,
    /// The value of the rest.
    pub rest: Residue<F>,
    /// The sum of the magnitudes of the multiples.
    pub spread: f64,
    /// Their common denominator.
    pub denominator: u64,
    /// Whether a part of π is in it.
    pub of_pi: bool,
    /// Whether it was divided so that the label is not known.
    pub lost: bool,
}

impl<F: Modulus> Angle<F> {
    /// No angle and no rest.
    pub const NONE: Self =
        Angle { label: 0, rest: Residue::ZERO, spread: 0.0, denominator: 1, of_pi: false, lost: false };

    /// The sum of two.
    pub fn plus(self, other: Self) -> Self {
        Angle {
            label: self.label.wrapping_add(other.label),
            rest: self.rest.plus(other.rest),
            spread: self.spread + other.spread,
            denominator: common_multiple(self.denominator, other.denominator),
            of_pi: self.of_pi || other.of_pi,
            lost: self.lost || other.lost,
        }
    }

    /// A fraction of it.
    pub fn scaled(self, ratio: Ratio, value: Residue<F>) -> Self {
        let halvings = ratio.denominator.trailing_zeros();
        let odd = ratio.denominator >> halvings;
        let multiple = self.label.wrapping_mul(ratio.numerator as i128 as u128);
        // a third of a half turn is no point of this circle
        let divides = multiple.trailing_zeros() >= halvings && !(self.of_pi && odd > 1);
        let halved = ((multiple as i128) >> halvings) as u128;
        Angle {
            label: halved.wrapping_mul(inverse_of_odd(odd.into())),
            rest: self.rest.times(value),
            spread: self.spread * ratio.value().abs(),
            denominator: self.denominator.saturating_mul(ratio.denominator),
            of_pi: self.of_pi,
            lost: self.lost || !divides,
        }
    }
}

pub fn common_multiple(a: u64, b: u64) -> u64 {
    let gcd = |mut a: u64, mut b: u64| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.max(1)
    };
    (a / gcd(a, b)).saturating_mul(b)
}

/// The inverse of an odd number modulo 2¹²⁸, by Newton's iteration.
fn inverse_of_odd(odd: u128) -> u128 {
    (0..7).fold(1_u128, |x, _| x.wrapping_mul(2_u128.wrapping_sub(odd.wrapping_mul(x))))
}

#[cfg(test)]
mod tests {
    use super::super::modulus::FirstPrime;
    use super::super::residue::Prime;
    use super::*;

    #[test]
    fn odd_numbers_have_inverses_modulo_powers_of_two() {
        for odd in (1..100_u128).step_by(2).chain([u128::MAX]) {
            assert_eq!(odd.wrapping_mul(inverse_of_odd(odd)), 1);
        }
    }

    #[test]
    fn a_third_of_three_halves_of_an_angle_is_its_half() {
        let angle = Angle { label: 0x1234_5678 << FirstPrime::HALVINGS, spread: 1.0, ..Angle::NONE };
        let by = |angle: Angle<FirstPrime>, numerator, denominator| {
            angle.scaled(Ratio { numerator, denominator }, Residue::ONE)
        };
        assert_eq!(by(by(angle, 3, 2), 1, 3).label, by(angle, 1, 2).label);
        assert_eq!(by(by(angle, -12, 1), 1, 8).label, by(angle, -3, 2).label);
        assert!(!by(angle, 1, 1 << 10).lost);
        // must-fail cases
        assert_ne!(by(angle, 1, 4).label, by(angle, 1, 2).label);
        assert!(by(angle, 1, 1 << 40).lost);
    }
}
