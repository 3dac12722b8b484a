//! Ball arithmetic: a middle and a radius, such that the true value is never further from the middle than the radius.
//!
//! The middle is rounded to the working precision by `dashu-float`, whose operations and functions are correctly
//! rounded. The radius is rounded up. What is added to it is the rounding of the middle, and the change of the result over
//! the balls that went in (van der Hoeven, *Ball arithmetic*, 2010).

use dashu_float::ops::Abs;
use dashu_float::round::mode::{Down, HalfEven, Up};
use dashu_float::{ConstCache, Context, FBig, FpResult, Repr};
use dashu_int::{IBig, Sign, UBig};

/// A number in binary, of any precision.
type Real = Repr<2>;

/// The precision of a radius, in bits.
const RADIUS_BITS: usize = 32;

/// A sine is computed of numbers below this power of 2.
const LARGEST_ANGLE: isize = 1 << 11;

/// An exponential is computed of numbers below this power of 2.
const LARGEST_EXPONENT: isize = 40;

/// A set of real numbers: all that are not further from the middle than the radius.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    middle: Real,
    radius: Real,
}

/// The working precision, with the constants that its functions keep.
pub(super) struct Precision {
    bits: usize,
    cache: ConstCache,
}

fn up() -> Context<Up> {
    Context::new(RADIUS_BITS)
}

fn is_zero(x: &Real) -> bool {
    x.significand().is_zero()
}

fn size(x: &Real) -> Real {
    Repr::new(x.significand().clone().abs(), x.exponent())
}

/// The power of 2 above a number that is not 0: |x| < 2ⁿ.
fn above(x: &Real) -> isize {
    x.exponent() + x.digits() as isize
}

fn power_of_two(n: isize) -> Real {
    Repr::new(IBig::ONE, n)
}

fn sum(a: &Real, b: &Real) -> Option<Real> {
    Some(up().add(a, b).ok()?.value().into_repr())
}

fn product(a: &Real, b: &Real) -> Option<Real> {
    Some(up().mul(a, b).ok()?.value().into_repr())
}

fn quotient(a: &Real, b: &Real) -> Option<Real> {
    Some(up().div(a, b).ok()?.value().into_repr())
}

impl Precision {
    pub fn new(bits: usize) -> Self {
        Precision { bits, cache: ConstCache::new() }
    }

    fn context(&self) -> Context<HalfEven> {
        Context::new(self.bits)
    }

    /// The ball of a rounded result: one unit in its last place around it, and what else it may be off by.
    fn rounded(&self, result: FpResult<FBig<HalfEven, 2>>, further: Option<Real>) -> Option<Ball> {
        let (middle, is_exact) = match result.ok()? {
            dashu_base::Approximation::Exact(x) => (x.into_repr(), true),
            dashu_base::Approximation::Inexact(x, _) => (x.into_repr(), false),
        };
        let further = further?;
        if middle.is_infinite() || further.is_infinite() || !is_exact && is_zero(&middle) {
            return None;
        }
        let radius = match is_exact {
            true => further,
            false => sum(&power_of_two(above(&middle) - self.bits as isize), &further)?,
        };
        Some(Ball { middle, radius })
    }

    /// The ball of a fraction of whole numbers.
    pub fn fraction(&self, numerator: IBig, denominator: IBig) -> Option<Ball> {
        let result = self.context().div(&Repr::new(numerator, 0), &Repr::new(denominator, 0));
        self.rounded(result, Some(Real::zero()))
    }

    /// The ball of π.
    pub fn pi(&mut self) -> Option<Ball> {
        let pi: FBig<HalfEven, 2> = self.cache.pi(self.bits).value();
        let middle = pi.into_repr();
        let radius = power_of_two(above(&middle) - self.bits as isize);
        Some(Ball { middle, radius })
    }

    pub fn plus(&self, a: &Ball, b: &Ball) -> Option<Ball> {
        self.rounded(self.context().add(&a.middle, &b.middle), sum(&a.radius, &b.radius))
    }

    pub fn minus(&self, a: &Ball, b: &Ball) -> Option<Ball> {
        self.rounded(self.context().sub(&a.middle, &b.middle), sum(&a.radius, &b.radius))
    }

    pub fn times(&self, a: &Ball, b: &Ball) -> Option<Ball> {
        let further = match (is_zero(&a.radius), is_zero(&b.radius)) {
            (true, true) => Real::zero(),
            // |a|·r_b + |b|·r_a + r_a·r_b
            _ => sum(&product(&sum(&size(&a.middle), &a.radius)?, &b.radius)?, &product(&size(&b.middle), &a.radius)?)?,
        };
        self.rounded(self.context().mul(&a.middle, &b.middle), Some(further))
    }

    pub fn over(&self, a: &Ball, b: &Ball) -> Option<Ball> {
        let least = b.least()?;
        let result = self.context().div(&a.middle, &b.middle);
        let further = match (is_zero(&a.radius), is_zero(&b.radius)) {
            (true, true) => Real::zero(),
            // (r_a + |a/b|·r_b) / (|b| − r_b)
            _ => {
                let ratio = quotient(&size(&a.middle), &size(&b.middle))?;
                quotient(&sum(&a.radius, &product(&ratio, &b.radius)?)?, &least)?
            }
        };
        self.rounded(result, Some(further))
    }

    /// The square root; of 0 and of what is certainly positive.
    pub fn sqrt(&self, a: &Ball) -> Option<Ball> {
        if a.is_exactly_zero() {
            return Some(a.clone());
        }
        let least = a.least().filter(|_| a.middle.sign() == Sign::Positive)?;
        let below = Context::<Down>::new(RADIUS_BITS).sqrt(&least).ok()?.value().into_repr();
        self.rounded(self.context().sqrt(&a.middle), quotient(&a.radius, &below))
    }

    pub fn exp(&mut self, a: &Ball) -> Option<Ball> {
        if !is_zero(&a.middle) && above(&a.middle) > LARGEST_EXPONENT || !is_zero(&a.radius) && above(&a.radius) > 0 {
            return None;
        }
        let value = self.context().exp(&a.middle, Some(&mut self.cache));
        // e^r − 1 ≤ 2r for r ≤ 1, and the middle is below 2ⁿ
        let further = match &value {
            Ok(rounded) if !is_zero(&a.radius) => {
                let largest = power_of_two(above(rounded.value_ref().repr()) + 1);
                product(&product(&a.radius, &power_of_two(1))?, &largest)
            }
            _ => Some(Real::zero()),
        };
        self.rounded(value, further)
    }

    /// The natural logarithm of what is certainly positive.
    pub fn ln(&mut self, a: &Ball) -> Option<Ball> {
        let least = a.least().filter(|_| a.middle.sign() == Sign::Positive)?;
        let value = self.context().ln(&a.middle, Some(&mut self.cache));
        self.rounded(value, quotient(&a.radius, &least))
    }

    /// Sine and cosine.
    pub fn sine_cosine(&mut self, a: &Ball) -> Option<(Ball, Ball)> {
        if !is_zero(&a.middle) && above(&a.middle) > LARGEST_ANGLE {
            return None;
        }
        let (sine, cosine) = self.context().sin_cos(&a.middle, Some(&mut self.cache));
        Some((self.rounded(sine, Some(a.radius.clone()))?, self.rounded(cosine, Some(a.radius.clone()))?))
    }

    pub fn atan(&mut self, a: &Ball) -> Option<Ball> {
        let value = self.context().atan(&a.middle, Some(&mut self.cache));
        self.rounded(value, Some(a.radius.clone()))
    }
}

impl Ball {
    /// The number `x` exactly; `None` for what is not finite.
    pub fn exact(x: f64) -> Option<Self> {
        let middle = Real::try_from(x).ok().filter(|middle| !middle.is_infinite())?;
        Some(Ball { middle, radius: Real::zero() })
    }

    /// All that a double may be the rounding of.
    pub fn rounded_to_double(x: f64) -> Option<Self> {
        let Ball { middle, radius } = Ball::exact(x)?;
        let radius = if is_zero(&middle) { radius } else { power_of_two(above(&middle) - 53) };
        Some(Ball { middle, radius })
    }

    /// The middle alone.
    pub fn middle(&self) -> Self {
        Ball { middle: self.middle.clone(), radius: Real::zero() }
    }

    pub fn negated(&self) -> Self {
        let (significand, exponent) = self.middle.clone().into_parts();
        Ball { middle: Repr::new(-significand, exponent), radius: self.radius.clone() }
    }

    /// The double nearest to the middle.
    pub fn value(&self) -> f64 {
        self.middle.to_f64().value()
    }

    /// Whether the middle is negative.
    pub fn is_negative(&self) -> bool {
        self.middle.sign() == Sign::Negative && !is_zero(&self.middle)
    }

    /// Whether it is 0 and nothing else.
    pub fn is_exactly_zero(&self) -> bool {
        is_zero(&self.middle) && is_zero(&self.radius)
    }

    /// A lower bound of all magnitudes in it; `None` if it contains 0.
    fn least(&self) -> Option<Real> {
        let least = Context::<Down>::new(RADIUS_BITS).sub(&size(&self.middle), &self.radius).ok()?.value().into_repr();
        (!is_zero(&least) && least.sign() == Sign::Positive).then_some(least)
    }

    /// Whether 0 is not in it.
    pub fn excludes_zero(&self) -> bool {
        self.least().is_some()
    }

    /// An upper bound of the base-2 logarithm of all magnitudes in it; −∞ for 0.
    pub fn log2(&self) -> f64 {
        match sum(&size(&self.middle), &self.radius) {
            Some(largest) if is_zero(&largest) => f64::NEG_INFINITY,
            Some(largest) => above(&largest) as f64,
            None => f64::INFINITY,
        }
    }
}

/// The whole numbers whose quotient is a decimal, such as `0.25` or `1e-3`; `None` if it is no decimal, or too long.
pub(super) fn decimal(digits: &str) -> Option<(IBig, IBig)> {
    const LONGEST: usize = 2000;
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let joined = format!("{whole}{part}");
    let is_decimal = !joined.is_empty() && joined.len() <= LONGEST && joined.bytes().all(|b| b.is_ascii_digit());
    let places = exponent.parse::<i64>().ok()?.checked_sub(i64::try_from(part.len()).ok()?)?;
    let size = usize::try_from(places.unsigned_abs()).ok().filter(|size| *size <= LONGEST)?;
    let number = IBig::from(UBig::from_str_radix(&joined, 10).ok().filter(|_| is_decimal)?);
    let power = IBig::from(UBig::from(10_u8).pow(size));
    Some(if places < 0 { (number, power) } else { (number * power, IBig::ONE) })
}
