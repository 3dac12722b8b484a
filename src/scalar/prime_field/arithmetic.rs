//! The numeric traits of a number of the field, by the operations of its neighbour module.

use std::cmp::Ordering;
use std::fmt;

use super::denominators::Size;
use super::evaluation::{ConstantInField, Evaluation, with_evaluation};
use super::modulus::Modulus;
use super::number::{Kind, Modular};
use super::residue::Residue;
use crate::scalar::arithmetic::{dual_number, power_by_squaring};
use crate::scalar::rational::Ratio;
use crate::scalar::{Arithmetic, Function};

impl<F: Modulus> Arithmetic for Modular<F> {
    type Inner = f64;

    fn constant(value: f64) -> Self {
        if value == 0.0 {
            return Self::ZERO;
        }
        if value == 1.0 {
            return Self::ONE;
        }
        if value.fract() == 0.0 && value.abs() < 1e9 {
            let size = Size { degree: 0, norm: value.abs() };
            let value_in_the_field = Residue::whole(value as i64);
            return Modular { kind: Kind::Integer(value as i32), ..Self::plain(value_in_the_field, size, 0) };
        }
        Self::of_constant(|evaluation| evaluation.constant(value))
    }

    fn decimal(digits: &str) -> Option<Self> {
        Some(match Ratio::from_decimal(digits) {
            Some(Ratio { numerator, denominator: 1 }) if numerator.abs() < 1_000_000_000 => {
                Self::constant(numerator as f64)
            }
            Some(ratio) => Self::of_constant(|evaluation| evaluation.fraction(ratio)),
            None => Self::refused("a number with too many digits"),
        })
    }

    fn pi() -> Self {
        Self::of_constant(Evaluation::half_turn)
    }

    fn uncertain(_error: f64) -> Option<Self> {
        None
    }
    fn real(self) -> f64 {
        match with_evaluation(|evaluation| self.ratio(evaluation)) {
            Some(ratio) => ratio.value(),
            None => {
                Self::refused("an absolute value, or an exponent that varies");
                f64::NAN
            }
        }
    }

    fn plus(self, other: Self) -> Self {
        if self.is_constant_zero() {
            return other;
        }
        if other.is_constant_zero() {
            return self;
        }
        let (a, b) = (self.used(), other.used());
        a.sum(b, a.value.plus(b.value), false)
    }

    fn minus(self, other: Self) -> Self {
        if other.is_constant_zero() {
            return self;
        }
        if self.is_constant_zero() {
            return other.negated();
        }
        let (a, b) = (self.used(), other.used());
        a.sum(b, a.value.minus(b.value), true)
    }

    fn times(self, other: Self) -> Self {
        if self.is_constant_zero() || other.is_constant_zero() {
            return Self::ZERO;
        }
        if let (Kind::Root(place), Kind::Root(other)) = (self.kind, other.kind)
            && place == other
            && let Some((_, radicand)) =
                with_evaluation(|evaluation: &mut Evaluation<F>| evaluation.roots.taken.get(&place).copied())
        {
            return Modular { kind: Kind::Plain, ..radicand };
        }
        let (this, other) = match (self.kind, other.kind) {
            (Kind::Integer(1), _) => return other,
            (_, Kind::Integer(1)) => return self,
            _ => (self.used(), other.used()),
        };
        this.product(other)
    }

    fn over(self, other: Self) -> Self {
        if other.kind == Kind::Integer(1) {
            return self;
        }
        self.used().quotient(other.used())
    }

    fn negated(self) -> Self {
        let number = self.used();
        let kind = match number.kind {
            Kind::Plain | Kind::Root(_) => Kind::Plain,
            Kind::Integer(n) if n != i32::MIN => Kind::Integer(-n),
            Kind::Integer(_) | Kind::Ratio(_) => with_evaluation(|evaluation| {
                let ratio = self.ratio(evaluation).and_then(Ratio::negated);
                Self::of_ratio(ratio, evaluation)
            }),
            Kind::Angle(_) => {
                with_evaluation(|evaluation| self.scaled_angle(Ratio::whole(-1), Residue::whole(-1), evaluation))
            }
        };
        Modular { value: number.value.negated(), kind, ..number }
    }

    fn power(self, n: i32) -> Self {
        power_by_squaring(self, n)
    }

    fn real_power(self, n: f64) -> Self {
        if n.fract() == 0.0 && n.abs() <= 1024.0 {
            return self.power(n as i32);
        }
        if (2.0 * n).fract() == 0.0 && n.abs() <= 512.0 {
            return self.root().power((2.0 * n) as i32);
        }
        Self::refused("an exponent that is neither a whole number nor half of one")
    }

    fn rational_power(self, n: Ratio) -> Self {
        match i32::try_from(n.numerator) {
            Ok(numerator) if n.denominator == 1 && numerator.abs() <= 1024 => self.power(numerator),
            Ok(numerator) if n.denominator == 2 && numerator.abs() <= 1024 => self.root().power(numerator),
            _ => Self::refused("an exponent that is neither a whole number nor half of one"),
        }
    }

    fn apply(self, function: Function) -> Self {
        match function {
            Function::Sqrt => self.root(),
            Function::Sin => self.circular().1,
            Function::Cos => self.circular().0,
            Function::Tan => {
                let (cosine, sine) = self.circular();
                sine.over(cosine)
            }
            Function::Cbrt => Self::refused("a cube root"),
            Function::Exp => self.exponential(),
            Function::ExpM1 => self.exponential().minus(Self::ONE),
            Function::Sinh | Function::Cosh | Function::Tanh => {
                let (up, down) = (self.exponential(), self.negated().exponential());
                match function {
                    Function::Sinh => up.minus(down).over(Self::constant(2.0)),
                    Function::Cosh => up.plus(down).over(Self::constant(2.0)),
                    _ => up.minus(down).over(up.plus(down)),
                }
            }
            Function::Ln => self.logarithm(),
            Function::Ln1p => self.plus(Self::ONE).logarithm(),
            Function::Asin | Function::Acos | Function::Atan | Function::Asinh | Function::Acosh | Function::Atanh => {
                Self::refused("an inverse function")
            }
        }
    }

    fn angle_from(self, _: Self) -> Self {
        Self::refused("an angle that is computed from two coordinates")
    }

    fn sine_cosine(self) -> (Self, Self) {
        let (cosine, sine) = self.circular();
        (sine, cosine)
    }

    fn order(self, other: Self) -> Option<Ordering> {
        let (this, other) = (self.used(), other.used());
        if this.value == other.value {
            return Some(Ordering::Equal);
        }
        match with_evaluation(|evaluation| this.ratio(evaluation).zip(other.ratio(evaluation))) {
            Some((a, b)) => a.value().partial_cmp(&b.value()),
            None => {
                Self::refused("an absolute value, or which of two numbers is larger");
                None
            }
        }
    }

    fn same(self, other: Self) -> bool {
        // whether a root is 0, or the same root, is known without its value
        if other.is_constant_zero() || self.is_constant_zero() || self.kind == other.kind {
            return self.value == other.value;
        }
        self.used().value == other.used().value
    }
}

impl<F: Modulus> Modular<F> {
    /// A constant that the evaluation knows.
    fn of_constant(find: impl FnOnce(&mut Evaluation<F>) -> ConstantInField<F>) -> Self {
        with_evaluation(|evaluation| {
            let known = find(evaluation);
            let kind = match known.angle {
                Some(place) => Kind::Angle(place),
                None => Self::of_ratio(known.ratio, evaluation),
            };
            Modular { kind, ..Self::plain(known.value, known.size, known.denominator) }
        })
    }
}

impl<F: Modulus> fmt::Display for Modular<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (mod {}·2^{} − 1)", self.value.value(), F::ODD, F::BITS)
    }
}

dual_number!(Modular<F: Modulus>);
