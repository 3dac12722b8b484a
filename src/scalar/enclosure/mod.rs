//! Numbers with as many digits as a question needs, each with a bound on its error.
//!
//! An [`Enclosure`] contains the true value: that of the formula at exactly the numbers that went in. Two sides whose
//! difference excludes 0 differ, however little; a double cannot say that. The precision is chosen by
//! [`evaluate_to`], and may be raised until the answer is clear.
//!
//! A number holds a place in a list of the thread, since it must be `Copy`. The list lives as long as the
//! evaluation. Outside of an evaluation, and where an operation has no value or may have none, there is no enclosure: the
//! number is [`Enclosure::is_known`] no more, and nothing is concluded from it.
//!
//! This folder knows the numeric traits of `scalar`, and nothing of formulas or mechanics.
//!
//! Offers both.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::fmt;

use super::arithmetic::{dual_number, power_by_squaring};
use super::rational::{Ratio, short_decimal};
use super::{Arithmetic, Function};
use ball::{Ball, Precision};

mod ball;

thread_local! {
    static EVALUATION: RefCell<Option<Evaluation>> = const { RefCell::new(None) };
}

/// The numbers of one evaluation.
struct Evaluation {
    precision: Precision,
    balls: Vec<Ball>,
    /// The number of results that may still be computed.
    left: usize,
    /// The precision in bits.
    bits: usize,
    /// Whether a term that is not 0 was too small beside another one to change it.
    has_absorbed: bool,
}

/// A real number between known bounds: see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Enclosure(u32);

/// Runs `f` over enclosures of this precision in bits. After `steps` results every further one is unknown, so that no
/// formula takes longer than that.
pub fn evaluate_to<R>(bits: usize, steps: usize, f: impl FnOnce() -> R) -> R {
    /// Puts the interrupted evaluation back, also when `f` panics.
    struct Interrupted(Option<Evaluation>);
    impl Drop for Interrupted {
        fn drop(&mut self) {
            EVALUATION.replace(self.0.take());
        }
    }
    let (precision, balls) = (Precision::new(bits), Vec::new());
    let evaluation = Evaluation { precision, balls, left: steps, bits, has_absorbed: false };
    let _interrupted = Interrupted(EVALUATION.replace(Some(evaluation)));
    f()
}

/// Whether the evaluation has added a term that is not 0 and too small beside another one to change it: 1 + e⁻⁵⁰⁰⁰. Two formulas
/// may then agree to all digits and still differ.
pub fn has_absorbed() -> bool {
    with_evaluation(|evaluation| evaluation.has_absorbed).unwrap_or(false)
}

impl Evaluation {
    /// Notes whether one of two terms is lost beside the other.
    fn note_absorbed(&mut self, a: Enclosure, b: Enclosure) {
        let (Some(a), Some(b)) = (self.ball(a), self.ball(b)) else { return };
        let (small, large) = if a.log2() < b.log2() { (a, b) } else { (b, a) };
        self.has_absorbed |= large.log2() - small.log2() > self.bits as f64 && small.excludes_zero();
    }

    fn keep(&mut self, ball: Option<Ball>) -> Enclosure {
        match (ball, self.left.checked_sub(1)) {
            (Some(ball), Some(left)) => {
                self.left = left;
                self.balls.push(ball);
                Enclosure(self.balls.len() as u32 - 1)
            }
            _ => Enclosure::UNKNOWN,
        }
    }

    fn ball(&self, of: Enclosure) -> Option<&Ball> {
        self.balls.get(of.0 as usize)
    }
}

fn with_evaluation<R>(f: impl FnOnce(&mut Evaluation) -> R) -> Option<R> {
    EVALUATION.with_borrow_mut(|open| open.as_mut().map(f))
}

impl Enclosure {
    /// The number of which nothing is known.
    const UNKNOWN: Self = Enclosure(u32::MAX);

    /// The number that is exactly this double.
    pub fn exact(x: f64) -> Self {
        Self::kept(|_| Ball::exact(x))
    }

    /// Whether there are bounds.
    pub fn is_known(self) -> bool {
        self.asked(|_| ()).is_some()
    }

    /// Whether 0 is certainly not the value.
    pub fn excludes_zero(self) -> bool {
        self.asked(Ball::excludes_zero).unwrap_or(false)
    }

    /// An upper bound of log₂ |x|; −∞ for 0, +∞ if nothing is known.
    pub fn log2(self) -> f64 {
        self.asked(Ball::log2).unwrap_or(f64::INFINITY)
    }

    /// The middle of the bounds, taken as an exact number.
    pub fn middle(self) -> Self {
        self.mapped(|_, x| Some(x.middle()))
    }

    fn asked<R>(self, ask: impl FnOnce(&Ball) -> R) -> Option<R> {
        with_evaluation(|evaluation| evaluation.ball(self).map(ask)).flatten()
    }

    fn kept(make: impl FnOnce(&mut Precision) -> Option<Ball>) -> Self {
        let kept = with_evaluation(|evaluation| {
            let ball = make(&mut evaluation.precision);
            evaluation.keep(ball)
        });
        kept.unwrap_or(Self::UNKNOWN)
    }

    fn mapped(self, f: impl FnOnce(&mut Precision, &Ball) -> Option<Ball>) -> Self {
        let kept = with_evaluation(|evaluation| {
            let Evaluation { precision, balls, .. } = evaluation;
            let ball = balls.get(self.0 as usize).and_then(|x| f(precision, x));
            evaluation.keep(ball)
        });
        kept.unwrap_or(Self::UNKNOWN)
    }

    fn combined(self, other: Self, f: impl FnOnce(&Precision, &Ball, &Ball) -> Option<Ball>) -> Self {
        let kept = with_evaluation(|evaluation| {
            let ball = match (evaluation.ball(self), evaluation.ball(other)) {
                (Some(a), Some(b)) => f(&evaluation.precision, a, b),
                _ => None,
            };
            evaluation.keep(ball)
        });
        kept.unwrap_or(Self::UNKNOWN)
    }

    fn whole(n: i32) -> Self {
        Self::exact(f64::from(n))
    }

    fn half_pi() -> Self {
        Self::pi().over(Self::whole(2))
    }

    /// (eˣ + sign·e⁻ˣ)/2.
    fn hyperbolic(self, sign: i32) -> Self {
        let (up, down) = (self.apply(Function::Exp), self.negated().apply(Function::Exp));
        up.plus(down.times(Self::whole(sign))).over(Self::whole(2))
    }

    fn is_negative(self) -> bool {
        self.asked(Ball::is_negative).unwrap_or(false)
    }

    fn is_exactly_zero(self) -> bool {
        self.asked(Ball::is_exactly_zero).unwrap_or(false)
    }
}

impl Arithmetic for Enclosure {
    type Inner = f64;

    /// A whole number or a short decimal exactly; any other double is a rounded number, known to half a unit in its
    /// last place.
    fn constant(value: f64) -> Self {
        const LARGEST: f64 = 9_007_199_254_740_992.0; // 2⁵³
        if value.fract() == 0.0 && value.abs() <= LARGEST {
            return Self::exact(value);
        }
        match short_decimal(value) {
            Some(Ratio { numerator, denominator }) => {
                Self::kept(|precision| precision.fraction(numerator.into(), denominator.into()))
            }
            None => Self::kept(|_| Ball::rounded_to_double(value)),
        }
    }
    fn decimal(digits: &str) -> Option<Self> {
        let (numerator, denominator) = ball::decimal(digits)?;
        Some(Self::kept(|precision| precision.fraction(numerator, denominator)))
    }
    fn pi() -> Self {
        Self::kept(Precision::pi)
    }
    fn uncertain(_error: f64) -> Option<Self> {
        None
    }
    fn real(self) -> f64 {
        self.asked(Ball::value).unwrap_or(f64::NAN)
    }
    fn plus(self, other: Self) -> Self {
        with_evaluation(|evaluation| evaluation.note_absorbed(self, other));
        self.combined(other, Precision::plus)
    }
    fn minus(self, other: Self) -> Self {
        with_evaluation(|evaluation| evaluation.note_absorbed(self, other));
        self.combined(other, Precision::minus)
    }
    fn times(self, other: Self) -> Self {
        self.combined(other, Precision::times)
    }
    fn over(self, other: Self) -> Self {
        self.combined(other, Precision::over)
    }
    fn negated(self) -> Self {
        self.mapped(|_, x| Some(x.negated()))
    }
    fn power(self, n: i32) -> Self {
        power_by_squaring(self, n)
    }
    fn real_power(self, n: f64) -> Self {
        match n {
            0.5 => self.apply(Function::Sqrt),
            whole if whole.fract() == 0.0 && whole.abs() <= 1024.0 => self.power(whole as i32),
            _ => self.apply(Function::Ln).times(Self::constant(n)).apply(Function::Exp),
        }
    }
    fn rational_power(self, n: Ratio) -> Self {
        if let (Ok(whole), 1) = (i32::try_from(n.numerator), n.denominator) {
            return self.power(whole);
        }
        if self.is_exactly_zero() && n.numerator > 0 {
            return self;
        }
        // an odd root of a negative number
        if self.is_negative() && n.denominator % 2 == 1 {
            let size = self.negated().rational_power(n);
            return if n.numerator % 2 == 0 { size } else { size.negated() };
        }
        let exponent = Self::kept(|precision| precision.fraction(n.numerator.into(), n.denominator.into()));
        self.apply(Function::Ln).times(exponent).apply(Function::Exp)
    }
    fn apply(self, function: Function) -> Self {
        let one = || Self::whole(1);
        match function {
            Function::Sqrt => self.mapped(|precision, x| precision.sqrt(x)),
            Function::Cbrt => self.rational_power(Ratio { numerator: 1, denominator: 3 }),
            Function::Exp => self.mapped(Precision::exp),
            Function::ExpM1 => self.apply(Function::Exp).minus(one()),
            Function::Ln => self.mapped(Precision::ln),
            Function::Ln1p => self.plus(one()).apply(Function::Ln),
            Function::Sin => self.sine_cosine().0,
            Function::Cos => self.sine_cosine().1,
            Function::Tan => {
                let (sine, cosine) = self.sine_cosine();
                sine.over(cosine)
            }
            Function::Asin => self.angle_from(one().minus(self.times(self)).apply(Function::Sqrt)),
            Function::Acos => Self::half_pi().minus(self.apply(Function::Asin)),
            Function::Atan => self.mapped(Precision::atan),
            Function::Sinh => self.hyperbolic(-1),
            Function::Cosh => self.hyperbolic(1),
            Function::Tanh => self.hyperbolic(-1).over(self.hyperbolic(1)),
            Function::Asinh if self.is_negative() => self.negated().apply(Function::Asinh).negated(),
            Function::Asinh => {
                let root = self.times(self).plus(one()).apply(Function::Sqrt);
                self.plus(root).apply(Function::Ln)
            }
            Function::Acosh => {
                let root = self.times(self).minus(one()).apply(Function::Sqrt);
                self.plus(root).apply(Function::Ln)
            }
            Function::Atanh => one().plus(self).over(one().minus(self)).apply(Function::Ln).over(Self::whole(2)),
        }
    }
    fn angle_from(self, x: Self) -> Self {
        let is_clear = |number: Self| number.excludes_zero();
        if is_clear(x) && !x.is_negative() {
            return self.over(x).apply(Function::Atan);
        }
        if is_clear(self) {
            let quarter = if self.is_negative() { Self::half_pi().negated() } else { Self::half_pi() };
            return quarter.minus(x.over(self).apply(Function::Atan));
        }
        if is_clear(x) && self.is_exactly_zero() { Self::pi() } else { Self::UNKNOWN }
    }
    fn sine_cosine(self) -> (Self, Self) {
        let found = with_evaluation(|evaluation| {
            let Evaluation { precision, balls, .. } = evaluation;
            match balls.get(self.0 as usize).and_then(|x| precision.sine_cosine(x)) {
                Some((sine, cosine)) => (evaluation.keep(Some(sine)), evaluation.keep(Some(cosine))),
                None => (Self::UNKNOWN, Self::UNKNOWN),
            }
        });
        found.unwrap_or((Self::UNKNOWN, Self::UNKNOWN))
    }
    /// The order of the middles.
    fn order(self, other: Self) -> Option<Ordering> {
        let difference = self.minus(other);
        let order = |x: &Ball| match (x.is_negative(), x.middle().is_exactly_zero()) {
            (_, true) => Ordering::Equal,
            (true, _) => Ordering::Less,
            _ => Ordering::Greater,
        };
        difference.asked(order)
    }
}

impl fmt::Display for Enclosure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.real())
    }
}

dual_number!(Enclosure);

#[cfg(test)]
mod tests;
