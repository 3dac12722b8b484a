//! The number of the field as data: its value, the size of its numerator, its denominator, and what else is known of
//! it.

use super::denominators::{DenominatorId, Size};
use super::modulus::{FirstPrime, Modulus};
use super::residue::Residue;

/// A number of the field: see the [module](super).
#[derive(Clone, Copy, Debug)]
pub struct Modular<F: Modulus = FirstPrime> {
    pub(super) value: Residue<F>,
    /// The size of the numerator, were the number written as one fraction.
    pub(super) size: Size,
    /// The denominator of that fraction.
    pub(super) denominator: DenominatorId,
    pub(super) kind: Kind,
    /// The irrational square roots in it, one bit each.
    pub(super) roots: u32,
}

/// What is known of a number beside its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// Nothing.
    Plain,
    /// A small integer.
    Integer(i32),
    /// A rational constant, by its index in the evaluation.
    Ratio(u32),
    /// An angle, by its index in the evaluation.
    Angle(u32),
    /// A square root whose value has not been needed yet, by its index in the evaluation. The number has the size of
    /// the root. Its value is 0 where the radicand is 0, else 1.
    Root(u32),
}

impl<F: Modulus> Modular<F> {
    pub(super) const ZERO: Self =
        Modular { value: Residue::ZERO, size: Size::ZERO, denominator: 0, kind: Kind::Integer(0), roots: 0 };
    pub(super) const ONE: Self =
        Modular { value: Residue::ONE, size: Size::ONE, denominator: 0, kind: Kind::Integer(1), roots: 0 };

    /// The number of bits that a non-zero coefficient may have and still be non-zero modulo p: ⌊log₂ p⌋.
    pub fn most_bits() -> f64 {
        f64::from(F::PRIME.ilog2())
    }

    /// Whether the number is 0 at this point.
    pub fn vanishes(self) -> bool {
        self.value.is_zero()
    }

    /// A number of which the value is known and nothing else.
    pub(super) fn plain(value: Residue<F>, size: Size, denominator: DenominatorId) -> Self {
        Modular { value, size, denominator, kind: Kind::Plain, roots: 0 }
    }

    /// Whether the number is the constant 0, at every point.
    pub(super) fn is_constant_zero(self) -> bool {
        self.size.norm == 0.0
    }
}
