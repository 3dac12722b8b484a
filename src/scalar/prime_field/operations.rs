//! The operations on numbers of the field: draws, sums, products, quotients, square roots, sines and cosines.
//!
//! Each keeps the bound on the numerator's degree and coefficients, and what is known of the result.

use super::angle::Angle;
use super::denominators::Size;
use super::evaluation::{Evaluation, with_evaluation};
use super::modulus::Modulus;
use super::number::{Kind, Modular};
use super::residue::Residue;
use super::simple_numbers::SIMPLE_NORM;
use super::square_roots::RootFound;
use crate::scalar::Arithmetic;
use crate::scalar::rational::Ratio;

/// Above this a difference of two numbers could vanish in the field without being zero: they are not compared.
const SETTLED_NORM: f64 = (1_u128 << 100) as f64;
impl<F: Modulus> Modular<F> {
    /// A random number, which may also be an angle.
    pub fn random() -> Self {
        let (value, place) = with_evaluation::<F, _>(Evaluation::random_angle);
        Modular { kind: Kind::Angle(place), ..Self::plain(value, Size::VARIABLE, 0) }.remembered()
    }

    /// A random number that is no angle.
    pub fn random_plain() -> Self {
        let value = with_evaluation::<F, _>(Evaluation::random_number);
        Self::plain(value, Size::VARIABLE, 0).remembered()
    }

    /// Remembers a simple number, for others to turn out to be it.
    pub fn remembered(self) -> Self {
        with_evaluation(|evaluation| evaluation.keep(self));
        self
    }

    /// What is as large as a polynomial, and has the value of a simple number here, is that number: that it is not is
    /// an accident, and counted as one.
    pub(super) fn settled(self) -> Self {
        if self.roots != 0 || !(SIMPLE_NORM..SETTLED_NORM).contains(&self.size.norm) {
            return self;
        }
        with_evaluation(|evaluation| evaluation.settle(self))
    }

    pub(super) fn ratio(self, evaluation: &Evaluation<F>) -> Option<Ratio> {
        match self.kind {
            Kind::Integer(n) => Some(Ratio::whole(n.into())),
            Kind::Ratio(place) => evaluation.ratios.get(place as usize).copied(),
            Kind::Plain | Kind::Angle(_) | Kind::Root(_) => None,
        }
    }

    /// The number with the value that it has: that of a root is needed from here on.
    pub(super) fn used(self) -> Self {
        match self.kind {
            Kind::Root(place) if !self.value.is_zero() => {
                let (value, roots) =
                    with_evaluation(|evaluation: &mut Evaluation<F>| evaluation.value_of_root(place as usize));
                Modular { value, kind: Kind::Plain, roots: self.roots | roots, ..self }
            }
            _ => self,
        }
    }

    /// The kind of a fraction.
    pub(super) fn of_ratio(ratio: Option<Ratio>, evaluation: &mut Evaluation<F>) -> Kind {
        match ratio {
            None => Kind::Plain,
            Some(Ratio { numerator, denominator: 1 }) if i32::try_from(numerator).is_ok() => {
                Kind::Integer(numerator as i32)
            }
            Some(ratio) => {
                evaluation.ratios.push(ratio);
                Kind::Ratio(evaluation.ratios.len() as u32 - 1)
            }
        }
    }

    /// As an angle: what is nothing else is a rest.
    fn angle(self, evaluation: &Evaluation<F>) -> Angle<F> {
        match self.kind {
            Kind::Angle(place) => evaluation.angles[place as usize],
            _ => Angle { rest: self.value, ..Angle::NONE },
        }
    }

    /// Times a fraction, as an angle.
    pub(super) fn scaled_angle(self, ratio: Ratio, value: Residue<F>, evaluation: &mut Evaluation<F>) -> Kind {
        match self.kind {
            Kind::Angle(_) => {
                let angle = self.angle(evaluation).scaled(ratio, value);
                Kind::Angle(evaluation.angle(angle))
            }
            _ => Kind::Plain,
        }
    }

    pub(super) fn sum(self, other: Self, value: Residue<F>, negated: bool) -> Self {
        let constant = |x: Self| matches!(x.kind, Kind::Integer(_) | Kind::Ratio(_));
        let kind = match (self.kind, other.kind) {
            (Kind::Plain | Kind::Root(_), Kind::Plain | Kind::Root(_)) => Kind::Plain,
            (Kind::Integer(a), Kind::Integer(b)) if a.checked_add(if negated { -b } else { b }).is_some() => {
                Kind::Integer(a + if negated { -b } else { b })
            }
            _ if constant(self) && constant(other) => with_evaluation(|evaluation| {
                let second = other.ratio(evaluation).and_then(|r| if negated { r.negated() } else { Some(r) });
                let ratio = self.ratio(evaluation).zip(second).and_then(|(a, b)| a.plus(b));
                Self::of_ratio(ratio, evaluation)
            }),
            (Kind::Angle(_), _) | (_, Kind::Angle(_)) => with_evaluation(|evaluation| {
                let second = other.angle(evaluation);
                let second = if negated { second.scaled(Ratio::whole(-1), Residue::whole(-1)) } else { second };
                let angle = self.angle(evaluation).plus(second);
                Kind::Angle(evaluation.angle(angle))
            }),
            _ => Kind::Plain,
        };
        let roots = self.roots | other.roots;
        if self.denominator == other.denominator {
            return Modular { value, size: self.size.plus(other.size), denominator: self.denominator, kind, roots }
                .settled();
        }
        let common = with_evaluation(|evaluation: &mut Evaluation<F>| {
            evaluation.comparisons.denominators.common(self.denominator, other.denominator)
        });
        let size = self.size.times(common.first).plus(other.size.times(common.second));
        Modular { value, size, denominator: common.denominator, kind, roots }.settled()
    }

    /// Cosine and sine.
    pub(super) fn circular(self) -> (Self, Self) {
        if self.is_constant_zero() {
            return (Self::ONE, Self::ZERO);
        }
        let number = self.used();
        let (point, degree, denominator) = with_evaluation(|evaluation| {
            let angle = number.angle(evaluation);

            let (point, degree) = evaluation.point(angle, number);
            // (e^{iθ} ± e^{−iθ})/2
            (point, degree, evaluation.comparisons.denominators.whole(2))
        });
        let number = |value| Self::plain(value, Size { degree, norm: 2.0 }, denominator);
        (number(point.cosine), number(point.sine))
    }

    pub(super) fn root(self) -> Self {
        if self.is_constant_zero() {
            return Self::ZERO;
        }
        let exact = |n: u128| (n.isqrt() * n.isqrt() == n).then(|| n.isqrt() as f64);
        let ratio = with_evaluation(|evaluation| self.ratio(evaluation)).filter(|ratio| ratio.numerator > 0);
        if let Some(ratio) = ratio
            && let (Some(n), Some(d)) = (exact(ratio.numerator.unsigned_abs().into()), exact(ratio.denominator.into()))
        {
            return Self::constant(n).over(Self::constant(d));
        }
        let number = self.used();
        let found = with_evaluation(|evaluation| evaluation.root(number));
        let root = |place, value, size, denominator| {
            let root = Modular { value, size, denominator, kind: Kind::Root(place), roots: number.roots };
            with_evaluation(|evaluation: &mut Evaluation<F>| evaluation.roots.taken.insert(place, (root, number)));
            root
        };
        match found {
            RootFound::Ratio(ratio) => Self::constant(ratio.value()),
            RootFound::Again(place) => with_evaluation(|evaluation: &mut Evaluation<F>| {
                evaluation.roots.taken.get(&place).map(|(root, _)| *root)
            })
            .unwrap_or(number),
            RootFound::Magnitude(place) => root(place, Residue::ONE, Size::VARIABLE, 0),
            RootFound::Root(place) => {
                // √(X/Y) = √(XY)/Y
                let below = with_evaluation(|evaluation: &mut Evaluation<F>| {
                    evaluation.comparisons.denominators.size(number.denominator)
                });
                let degree = number.size.degree.saturating_add(below.degree).div_ceil(2);
                let size = Size { degree, norm: (number.size.norm * below.norm).sqrt().max(1.0) };
                root(place, if number.value.is_zero() { Residue::ZERO } else { Residue::ONE }, size, number.denominator)
            }
        }
    }

    /// The product of two numbers with their values.
    pub(super) fn product(self, other: Self) -> Self {
        let (value, size) = (self.value.times(other.value), self.size.times(other.size));
        let kind = match (self.kind, other.kind) {
            (Kind::Plain | Kind::Root(_), _) | (_, Kind::Plain | Kind::Root(_)) | (Kind::Angle(_), Kind::Angle(_)) => {
                Kind::Plain
            }
            _ => with_evaluation(|evaluation| match (self.ratio(evaluation), other.ratio(evaluation)) {
                (Some(a), Some(b)) => Self::of_ratio(a.times(b), evaluation),
                (Some(a), None) => other.scaled_angle(a, self.value, evaluation),
                (None, Some(b)) => self.scaled_angle(b, other.value, evaluation),
                (None, None) => Kind::Plain,
            }),
        };
        let denominator = match (self.denominator, other.denominator) {
            (0, denominator) | (denominator, 0) => denominator,
            (a, b) => {
                with_evaluation(|evaluation: &mut Evaluation<F>| evaluation.comparisons.denominators.product(a, b))
            }
        };
        Modular { value, size, denominator, kind, roots: self.roots | other.roots }
    }

    /// The quotient of two numbers with their values.
    pub(super) fn quotient(self, other: Self) -> Self {
        if other.value.is_zero() {
            // a quotient by what is literally 0 has no value anywhere
            if other.is_constant_zero() {
                return Self::refused("a quotient whose denominator is 0 at the sampled point");
            }
            with_evaluation(|evaluation: &mut Evaluation<F>| {
                evaluation.comparisons.record.undefined_here =
                    Some("a quotient whose denominator is 0 at the sampled points")
            });
            return Self::ZERO;
        }
        if other.kind == Kind::Integer(1) || self.is_constant_zero() {
            return self;
        }
        let quotient = with_evaluation(|evaluation| {
            // (a/A)/(b/B) = (a·B)/(A·b), without what A and B share
            let (above, below) = evaluation.comparisons.denominators.reduced(other.denominator, self.denominator);
            let reciprocal = evaluation.comparisons.reciprocal(other.value);
            let inverse = match other.ratio(evaluation).and_then(Ratio::inverse) {
                // a whole number divides prime by prime
                Some(_) if other.denominator == 0 => {
                    let size = other.size.norm as u64;
                    evaluation.comparisons.denominators.whole(size)
                }
                _ => {
                    let numerator = other.value.times(evaluation.comparisons.denominators.value(other.denominator));
                    evaluation.comparisons.denominators.factor(numerator, other.size)
                }
            };
            let (value, denominator) =
                (self.value.times(reciprocal), evaluation.comparisons.denominators.product(below, inverse));
            let size = self.size.times(evaluation.comparisons.denominators.size(above));
            let kind = match (self.kind, other.ratio(evaluation).and_then(Ratio::inverse)) {
                (_, None) => Kind::Plain,
                (Kind::Angle(_), Some(ratio)) => self.scaled_angle(ratio, reciprocal, evaluation),
                (_, Some(ratio)) => {
                    let quotient = self.ratio(evaluation).and_then(|own| own.times(ratio));
                    Self::of_ratio(quotient, evaluation)
                }
            };
            Modular { value, size, denominator, kind, roots: self.roots | other.roots }
        });
        if quotient.size.norm < SIMPLE_NORM { quotient.remembered() } else { quotient.settled() }
    }

    /// What has no meaning in a field.
    pub(super) fn refused(why: &'static str) -> Self {
        with_evaluation(|evaluation: &mut Evaluation<F>| evaluation.fault(why));
        Self::ZERO
    }
}
