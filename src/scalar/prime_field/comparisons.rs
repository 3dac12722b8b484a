//! What was compared in an evaluation: each test for zero that may have succeeded by accident is counted.

use rustc_hash::FxHashMap;

use super::denominators::{DenominatorId, Denominators, Size};
use super::modulus::Modulus;
use super::number::Modular;
use super::residue::{Prime, Residue};

/// What happened in an evaluation at one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvaluationRecord {
    /// An operation that a field does not have, if one was used. Nothing can be concluded then.
    pub unsupported: Option<&'static str>,
    /// A denominator that vanishes here, or a number without a square root here. Another point may do.
    pub undefined_here: Option<&'static str>,
    /// How many square roots were taken whose sign is free.
    pub roots: u32,
    /// Whether a number occurred whose relations to others are not known to the field: a root, a sine of a product, a
    /// constant that is not simple. Two sides that differ in the field may then be equal nevertheless.
    pub opaque: bool,
    /// The sum of the degrees of all differences that were tested for zero on the way.
    pub coincidences: f64,
    /// The largest number of bits that a coefficient of a compared difference may have.
    pub compared_bits: f64,
    /// The least common denominator of the multiples of angles.
    pub finest: u64,
}

/// Multiples that are recognised among square roots and among arguments of sines.
pub const SIMPLE_MULTIPLES: [(i64, u64); 14] = [
    (1, 1),
    (-1, 1),
    (2, 1),
    (-2, 1),
    (1, 2),
    (-1, 2),
    (3, 1),
    (-3, 1),
    (1, 3),
    (-1, 3),
    (4, 1),
    (-4, 1),
    (1, 4),
    (-1, 4),
];

/// The bits of the square of the largest of these multiples.
const MULTIPLE_BITS: f64 = 4.0;

/// How large a number is as a fraction.
#[derive(Clone, Copy)]
pub struct Fraction {
    pub size: Size,
    pub denominator: DenominatorId,
}

impl Fraction {
    pub const ONE: Fraction = Fraction { size: Size::ONE, denominator: 0 };

    pub fn of<F: Modulus>(number: Modular<F>) -> Self {
        Fraction { size: number.size, denominator: number.denominator }
    }
}

/// The tables that every comparison uses.
pub struct Comparisons<F> {
    pub denominators: Denominators<F>,
    /// The reciprocals that were needed. One takes as long as two hundred products.
    reciprocals: FxHashMap<u128, Residue<F>>,
    pub record: EvaluationRecord,
}

impl<F: Prime> Comparisons<F> {
    pub fn new(finest: u64) -> Self {
        let record = EvaluationRecord { finest, ..EvaluationRecord::default() };
        Comparisons { denominators: Denominators::new(), reciprocals: FxHashMap::default(), record }
    }

    /// The record, with the comparisons of denominators in it.
    pub fn into_record(self) -> EvaluationRecord {
        EvaluationRecord {
            coincidences: self.record.coincidences + self.denominators.coincidences(),
            compared_bits: self.record.compared_bits.max(self.denominators.compared_bits()),
            ..self.record
        }
    }

    /// Notes that two fractions, or small multiples of them, were found to be equal.
    pub fn found_equal(&mut self, a: Fraction, b: Fraction) {
        let common = self.denominators.common(a.denominator, b.denominator);
        let difference = a.size.times(common.first).plus(b.size.times(common.second));
        let bits = difference.norm.max(1.0).log2() + MULTIPLE_BITS;
        self.record.compared_bits = self.record.compared_bits.max(bits);
    }

    /// The product of two fractions.
    pub fn product_of(&mut self, a: Fraction, b: Fraction) -> Fraction {
        Fraction { size: a.size.times(b.size), denominator: self.denominators.product(a.denominator, b.denominator) }
    }

    /// The reciprocal of a residue; 0 for 0.
    pub fn reciprocal(&mut self, residue: Residue<F>) -> Residue<F> {
        *self.reciprocals.entry(residue.key()).or_insert_with(|| residue.inverse())
    }
}
