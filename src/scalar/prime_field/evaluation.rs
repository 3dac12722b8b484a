//! One evaluation at one random point of the field: what is drawn there, and the tables that its numbers share.
//!
//! A number of the field cannot return an error where it has no square root or is asked for its sign. Such events are
//! noted by the evaluation that is open on the thread. Its caller reads them in the [`EvaluationRecord`].

use std::any::Any;
use std::cell::RefCell;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use rustc_hash::FxHashMap;

use super::angle::{Angle, common_multiple};
use super::comparisons::{Comparisons, EvaluationRecord, Fraction, SIMPLE_MULTIPLES};
use super::denominators::{Size, degree_as_f64};
use super::modulus::Modulus;
use super::number::Modular;
use super::residue::Residue;
use super::simple_numbers::SimpleNumbers;
use super::square_roots::{RootFound, SquareRoots};
use super::unit_circle::{Point, drawn_bits, turn_bits};
use crate::scalar::rational::{Ratio, short_decimal};

thread_local! {
    static EVALUATION: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
}

/// Evaluates `f` at the random point of the field that `seed` determines.
///
/// The n-th bit of `signs` is the sign of the n-th square root. `finest` is the least common denominator of the
/// multiples of angles, 1 if it is not known yet. The record says whether a conclusion may be drawn from the result. If
/// its `finest` is larger than the given one, the degrees are too small: repeat the evaluation with that value.
pub fn evaluate_at_point<F: Modulus, R>(
    seed: u64,
    signs: u32,
    finest: u64,
    f: impl FnOnce() -> R,
) -> (R, EvaluationRecord) {
    /// Puts the interrupted evaluation back, also when `f` panics.
    struct Interrupted(Option<Box<dyn Any>>);
    impl Drop for Interrupted {
        fn drop(&mut self) {
            EVALUATION.replace(self.0.take());
        }
    }
    let interrupted = Interrupted(EVALUATION.replace(Some(Box::new(Evaluation::<F>::new(seed, signs, finest)))));
    let result = f();
    let evaluation = EVALUATION.take().and_then(|evaluation| evaluation.downcast::<Evaluation<F>>().ok());
    drop(interrupted);
    let record = evaluation.map(|evaluation| evaluation.comparisons.into_record());
    (result, record.unwrap_or_default())
}

/// Runs `f` on the evaluation that is open on this thread, or on a scratch evaluation if none is open.
pub(super) fn with_evaluation<F: Modulus, R>(f: impl FnOnce(&mut Evaluation<F>) -> R) -> R {
    EVALUATION.with_borrow_mut(|open| match open.as_mut().and_then(|evaluation| evaluation.downcast_mut()) {
        Some(evaluation) => f(evaluation),
        None => f(&mut Evaluation::new(0, 0, 1)),
    })
}

/// A constant as a number of the field.
#[derive(Clone, Copy)]
pub(super) struct ConstantInField<F> {
    pub value: Residue<F>,
    pub size: Size,
    pub denominator: u32,
    /// The fraction, if it is rational.
    pub ratio: Option<Ratio>,
    /// Its index among the angles, if it is a multiple of π.
    pub angle: Option<u32>,
}

/// A number with its logarithm: the number is `base` to the power `parts`.
pub(super) struct Exponential<F: Modulus> {
    pub logarithm: Modular<F>,
    pub base: Modular<F>,
    pub parts: i32,
}

impl<F: Modulus> Clone for Exponential<F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F: Modulus> Copy for Exponential<F> {}

/// The state of an evaluation.
pub(super) struct Evaluation<F: Modulus> {
    generator: Pcg64Mcg,
    points: FxHashMap<u128, Point<F>>,
    pub comparisons: Comparisons<F>,
    constants: FxHashMap<Ratio, ConstantInField<F>>,
    pub angles: Vec<Angle<F>>,
    pub ratios: Vec<Ratio>,
    pub roots: SquareRoots<F>,
    simple_numbers: SimpleNumbers<F>,
    /// The arguments of sines of which only the value is known, each with the label that was drawn for it.
    plain_angles: Vec<(Residue<F>, u128, Fraction)>,
    /// The exponentials and logarithms of this evaluation.
    pub exponentials: Vec<Exponential<F>>,
    pi: Residue<F>,
    /// The place of π among the angles.
    half_turn: Option<u32>,
}

impl<F: Modulus> Evaluation<F> {
    /// An evaluation at the point that `seed` names. The n-th bit of `signs` is the sign of the n-th square root.
    pub fn new(seed: u64, signs: u32, finest: u64) -> Self {
        let mut evaluation = Evaluation {
            generator: Pcg64Mcg::seed_from_u64(seed),
            points: FxHashMap::default(),
            comparisons: Comparisons::new(finest),
            constants: FxHashMap::default(),
            angles: Vec::new(),
            ratios: Vec::new(),
            roots: SquareRoots::new(signs),
            simple_numbers: SimpleNumbers::new(),
            plain_angles: Vec::new(),
            exponentials: Vec::new(),
            pi: Residue::ONE,
            half_turn: None,
        };
        evaluation.pi = evaluation.random_residue();
        evaluation
    }

    /// Records the first reason why nothing can be concluded.
    pub fn fault(&mut self, why: &'static str) {
        self.comparisons.record.unsupported.get_or_insert(why);
    }

    fn bits(&mut self) -> u128 {
        (u128::from(self.generator.next_u64()) << 64) | u128::from(self.generator.next_u64())
    }

    /// A random residue, each as probable as the others.
    fn random_residue(&mut self) -> Residue<F> {
        loop {
            let bits = self.bits() >> F::PRIME.leading_zeros();
            if bits < F::PRIME {
                return Residue::new(bits);
            }
        }
    }

    /// A random label that can be halved a few times.
    fn random_label(&mut self) -> u128 {
        (self.bits() & ((1 << drawn_bits::<F>()) - 1)) << F::HALVINGS
    }

    /// A random number.
    pub fn random_number(&mut self) -> Residue<F> {
        let value = self.random_residue();
        self.roots.drawn_by_square.insert(value.square().key(), value);
        value
    }

    /// A random number that is an angle too.
    pub fn random_angle(&mut self) -> (Residue<F>, u32) {
        let (value, label) = (self.random_number(), self.random_label());
        (value, self.angle(Angle { label, spread: 1.0, ..Angle::NONE }))
    }

    /// Keeps an angle.
    pub fn angle(&mut self, angle: Angle<F>) -> u32 {
        self.angles.push(angle);
        self.angles.len() as u32 - 1
    }

    /// The constant that an `f64` of a Lagrangian in Rust was written as: a short decimal. Any other `f64` may be a
    /// rounded number, so nothing is concluded.
    pub fn constant(&mut self, x: f64) -> ConstantInField<F> {
        if let Some(ratio) = short_decimal(x) {
            return self.fraction(ratio);
        }
        // What is not finite stands for a number that is not there, and is not used.
        if x.is_finite() {
            self.fault("a constant of a function in Rust that is not a short decimal number");
        }
        let size = Size { degree: 0, norm: f64::INFINITY };
        ConstantInField { value: Residue::ZERO, size, denominator: 0, ratio: None, angle: None }
    }

    /// A constant fraction.
    pub fn fraction(&mut self, ratio: Ratio) -> ConstantInField<F> {
        if let Some(known) = self.constants.get(&ratio) {
            return *known;
        }
        let reciprocal = self.comparisons.reciprocal(Residue::new(ratio.denominator.into()));
        let value = Residue::whole(ratio.numerator).times(reciprocal);
        let size = Size { degree: 0, norm: ratio.numerator.unsigned_abs() as f64 };
        let denominator = self.comparisons.denominators.whole(ratio.denominator);
        let known = ConstantInField { value, size, denominator, ratio: Some(ratio), angle: None };
        self.constants.insert(ratio, known);
        known
    }

    /// The constant π: an independent number, which as an angle is half a turn.
    pub fn half_turn(&mut self) -> ConstantInField<F> {
        let angle = match self.half_turn {
            Some(angle) => angle,
            None => self.angle(Angle { label: 1 << (turn_bits::<F>() - 1), of_pi: true, ..Angle::NONE }),
        };
        self.half_turn = Some(angle);
        let size = Size { degree: 1, norm: 1.0 };
        ConstantInField { value: self.pi, size, denominator: 0, ratio: None, angle: Some(angle) }
    }

    /// Cosine and sine of an angle, and their degree.
    pub fn point(&mut self, angle: Angle<F>, number: Modular<F>) -> (Point<F>, u32) {
        if angle.lost {
            self.fault("the sine or cosine of this fraction of an angle");
        }
        let (mut label, mut spread) = (angle.label, angle.spread);
        let mut denominator = angle.denominator;
        if !angle.rest.is_zero() {
            self.comparisons.record.opaque = true;
            let (of_rest, multiple) = self.plain_angle(angle.rest, number);
            label = label.wrapping_add(of_rest);
            spread += multiple.value().abs();
            denominator = common_multiple(denominator, multiple.denominator);
        }
        self.comparisons.record.finest = common_multiple(self.comparisons.record.finest, denominator);
        let point = match self.points.get(&label) {
            Some(point) => *point,
            None => {
                let point = F::circle().at(label);
                self.points.insert(label, point);
                point
            }
        };
        (point, (2.0 * spread * self.comparisons.record.finest as f64).ceil().min(f64::from(u32::MAX)) as u32)
    }

    /// A label for a value of which nothing else is known, and which multiple it is of one that was drawn.
    fn plain_angle(&mut self, value: Residue<F>, number: Modular<F>) -> (u128, Ratio) {
        let (degree, fraction) = (number.size.degree, Fraction::of(number));
        for (known, label, known_fraction) in self.plain_angles.clone() {
            for (numerator, denominator) in SIMPLE_MULTIPLES {
                self.comparisons.record.coincidences += degree_as_f64(degree.max(known_fraction.size.degree));
                // value = (n/d)·known
                let multiple = known.times(Residue::whole(numerator));
                if multiple == value.times(Residue::new(denominator.into())) {
                    self.comparisons.found_equal(fraction, known_fraction);
                    let ratio = Ratio { numerator, denominator };
                    let angle = Angle::<F> { label, ..Angle::NONE };
                    return (angle.scaled(ratio, Residue::ONE).label, ratio);
                }
            }
        }
        let label = self.random_label();
        self.plain_angles.push((value, label, fraction));
        (label, Ratio::whole(1))
    }

    /// The square root of a number.
    pub fn root(&mut self, number: Modular<F>) -> RootFound {
        self.roots.root(number, &mut self.comparisons)
    }

    /// The value of a square root, and the bits of the irrational roots that it is made of.
    pub fn value_of_root(&mut self, index: usize) -> (Residue<F>, u32) {
        self.roots.value_of_root(index, &mut self.comparisons)
    }

    /// Remembers a simple number by its value.
    pub fn keep(&mut self, number: Modular<F>) {
        self.simple_numbers.keep(number, &mut self.comparisons);
    }

    /// The simple number that has the value of a large one, or the large one.
    pub fn settle(&mut self, number: Modular<F>) -> Modular<F> {
        self.simple_numbers.settle(number, &mut self.comparisons)
    }
}

#[cfg(test)]
mod tests {
    use super::super::modulus::FirstPrime;
    use super::*;

    #[test]
    fn a_rounded_number_is_not_guessed() {
        let refused = |x: f64| {
            let mut evaluation = Evaluation::<FirstPrime>::new(1, 0, 1);
            evaluation.constant(x);
            evaluation.comparisons.record.unsupported.is_some()
        };
        let (root, pi) = (std::f64::consts::SQRT_2, std::f64::consts::PI);
        assert_eq!([root, 1.0 / root, pi, 4.0 * pi / 3.0, 1.0 / 3.0].map(refused), [true; 5]);
        // must-fail cases: decimals
        assert_eq!([0.5, 6.674e-11, 1e9, 340_262_731.0].map(refused), [false; 4]);
    }
}
