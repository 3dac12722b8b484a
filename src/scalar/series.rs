//! Truncated Taylor series in time: a motion near an instant, to fifth order.
//!
//! Feed the coordinates of a motion in as series and any quantity comes out as a series: dots on a symbol, d/dt of a
//! bracket and chains of either are then read off. A series also says how many of its coefficients are known, so that
//! a derivative that the motion does not determine is absent, not wrong.
//!
//! # Why everything is a Taylor series in time
//!
//! A dot, two dots, d/dt of a bracket and "constant" are then one operation, a shift of coefficients. A series
//! knows how many of its coefficients are known; a derivative that nobody supplied is `Unavailable`, never zero. On
//! shell, the accelerations are run over series, and each run gives one more order. The fifth derivative is the last.

use std::fmt;

use super::arithmetic::{dual_number, power_by_squaring};
use super::{Arithmetic, Function, Number, Ratio};

/// How many coefficients a [`Series`] holds: the value and the derivatives up to `TERMS - 1`.
pub const TERMS: usize = 6;

/// x(t) = Σₖ cₖ τᵏ with τ the time since the instant; the k-th derivative is k!·cₖ.
///
/// Sums, products and functions are known as far as all that went in; a constant is known to all orders. What is a
/// polynomial in time by how it was made, as a constant is, costs no more than its own coefficients.
#[derive(Copy, Debug)]
pub struct Series<B> {
    coefficients: [B; TERMS],
    known: u8,
    /// So many coefficients, one at least, may differ from zero; those that follow are zero identically.
    length: u8,
}

// Derived, it would copy coefficient after coefficient.
impl<B: Copy> Clone for Series<B> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

impl<B: Number> Series<B> {
    /// A value that does not vary.
    pub fn constant(value: B) -> Self {
        Series::build(TERMS, 1, |_, _| value)
    }

    /// The time itself, at an instant.
    pub fn time(now: B) -> Self {
        Series::build(TERMS, 2, |k, _| if k == 0 { now } else { B::one() })
    }

    /// From the value, the first derivative, the second …: as many as are known (those beyond [`TERMS`] are dropped).
    pub fn from_derivatives(derivatives: &[B]) -> Self {
        let mut factorial = 1.0;
        let known = derivatives.len().min(TERMS);
        Series::build(known, known, |k, _| {
            factorial *= k.max(1) as f64;
            derivatives[k] / factorial
        })
    }

    /// The value at the instant; NaN if not even that is known.
    pub fn value(&self) -> B {
        self.coefficients[0]
    }

    /// How many derivatives are known, the zeroth (the value) included.
    pub fn known(&self) -> usize {
        self.known as usize
    }

    /// The k-th time derivative at the instant, if it is known.
    pub fn nth_derivative_value(&self, k: usize) -> Option<B> {
        (k < self.known()).then(|| self.coefficients[k] * factorial(k))
    }

    /// Of which the value is known and nothing else.
    pub fn of_value(value: B) -> Self {
        Series::build(1, 1, |_, _| value)
    }

    /// The k-th coefficient, if it is known and may differ from zero.
    pub fn coefficient(&self, k: usize) -> Option<B> {
        (k < self.known() && k < self.length()).then(|| self.coefficients[k])
    }

    /// The value of the k-th of the derivatives that [`derivative`](Self::derivative) takes one after the other, to the
    /// last digit; `None` if it is not known.
    pub fn rate(&self, k: usize) -> Option<B> {
        if k >= self.known() {
            return None;
        }
        if k >= self.length() {
            let mut rate = *self;
            for _ in 0..k {
                rate = rate.derivative();
            }
            return Some(rate.value());
        }
        Some(Self::rate_of(self.coefficients[k], k))
    }

    /// The value of the k-th derivative of what has this k-th coefficient, likewise to the last digit.
    pub fn rate_of(coefficient: B, k: usize) -> B {
        let mut rate = coefficient;
        for j in (1..=k).rev() {
            rate *= j as f64;
        }
        rate
    }

    /// The series of the time derivative; it knows one order less.
    ///
    /// ```
    /// use onshell::scalar::Series;
    /// let t = Series::time(2.0);
    /// assert_eq!((t * t * t).derivative().value(), 12.0);
    /// ```
    pub fn derivative(&self) -> Self {
        Series::build(self.known().saturating_sub(1), self.length() - 1, |k, _| {
            self.coefficients[k + 1] * (k + 1) as f64
        })
    }

    /// The same series, known to no more than `known` coefficients.
    pub fn truncated(&self, known: usize) -> Self {
        let mut series = *self;
        series.truncate(known);
        series
    }

    /// Forgets all but the first `known` coefficients.
    #[inline]
    pub fn truncate(&mut self, known: usize) {
        if known < self.known() {
            if known == 0 {
                self.coefficients[0] = B::from(f64::NAN); // an unknown value must not look like a number
            }
            // unknown coefficients are never read
            (self.known, self.length) = (known as u8, self.length.min(known.max(1) as u8));
        }
    }

    /// Coefficient after coefficient, each from those before it; beyond `length` they are zero.
    #[inline]
    fn build(known: usize, length: usize, mut next: impl FnMut(usize, &[B; TERMS]) -> B) -> Self {
        let mut series = Series { coefficients: [B::zero(); TERMS], known: known as u8, length: 1 };
        if known == 0 {
            series.coefficients[0] = B::from(f64::NAN); // nothing is known: whoever looks shall not find a number
        }
        let length = length.min(known);
        for k in 0..length {
            series.coefficients[k] = next(k, &series.coefficients);
        }
        series.settle(length);
        series
    }

    /// Says how many coefficients may differ from zero. What has no value does not stay as it is: no rate of it is 0
    /// because nothing in it varies.
    #[inline]
    fn settle(&mut self, length: usize) {
        let known = self.known();
        let length = length.clamp(1, known.max(1));
        self.length = length as u8;
        if length >= known {
            return;
        }
        // Not every number has a real part to ask. What is infinite or NaN is NaN times 0, which alone differs from
        // itself.
        let nothing = self.coefficients[0] * B::zero();
        #[expect(clippy::eq_op, reason = "NaN alone differs from itself")]
        if nothing != nothing {
            self.coefficients[length..known].fill(B::from(f64::NAN));
            self.length = self.known;
        }
    }

    fn length(&self) -> usize {
        self.length as usize
    }

    /// How many coefficients a function of this has: that of a constant is a constant.
    fn length_of_function(&self) -> usize {
        if self.length == 1 { 1 } else { self.known() }
    }

    fn common(&self, other: &Self) -> usize {
        self.known.min(other.known) as usize
    }

    /// Σⱼ j·aⱼ·b₍ₖ₋ⱼ₎ / k: the k-th coefficient of ∫ b da.
    fn integral_step(k: usize, a: &[B; TERMS], b: &[B; TERMS]) -> B {
        let mut sum = a[1] * b[k - 1];
        for j in 2..=k {
            sum += a[j] * b[k - j] * j as f64;
        }
        sum / k as f64
    }

    /// f(x) from its value and the series of f′(x): f(x) = f(x₀) + ∫ f′(x) dx.
    fn integrate(&self, value: B, slope: Self) -> Self {
        Series::build(self.known(), self.length_of_function(), |k, _| match k {
            0 => value,
            _ => Self::integral_step(k, &self.coefficients, &slope.coefficients),
        })
    }

    /// A power y = xⁿ from its value, by x·y′ = n·y·x′; `factor(j, k)` is n·j − (k − j).
    fn power_of_value(&self, value: B, factor: &dyn Fn(usize, usize) -> B) -> Self {
        let x = &self.coefficients;
        Series::build(self.known(), self.length_of_function(), |k, y| match k {
            0 => value,
            _ => {
                let mut sum = x[1] * y[k - 1] * factor(1, k);
                for j in 2..=k {
                    sum += x[j] * y[k - j] * factor(j, k);
                }
                sum / (x[0] * k as f64)
            }
        })
    }

    /// Two functions, each the other's derivative up to a sign: sine and cosine (−1), their hyperbolic sisters (+1).
    fn coupled(&self, first: B, second: B, sign: f64) -> (Self, Self) {
        let (x, length) = (&self.coefficients, self.length_of_function());
        let [mut s, mut c] = [first, second].map(|value| Series { known: self.known, ..Series::constant(value) });
        for k in 1..length {
            s.coefficients[k] = Self::integral_step(k, x, &c.coefficients);
            c.coefficients[k] = Self::integral_step(k, x, &s.coefficients) * sign;
        }
        s.settle(length);
        c.settle(length);
        (s, c)
    }

    // The operators take their numbers by value, which for so large a type means copies. What they do is written over
    // references, so that the copies are seen to be needless.

    fn sum(&self, other: &Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        Series::build(self.common(other), self.length().max(other.length()), |k, _| {
            match (k < self.length(), k < other.length()) {
                (true, true) => a[k] + b[k],
                (true, false) => a[k],
                _ => b[k],
            }
        })
    }

    fn difference(&self, other: &Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        Series::build(self.common(other), self.length().max(other.length()), |k, _| {
            match (k < self.length(), k < other.length()) {
                (true, true) => a[k] - b[k],
                (true, false) => a[k],
                _ => -b[k],
            }
        })
    }

    fn product(&self, other: &Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        Series::build(self.common(other), self.length() + other.length() - 1, |k, _| {
            let first = k.saturating_sub(other.length() - 1);
            let mut sum = a[first] * b[k - first];
            for j in first + 1..=k.min(self.length() - 1) {
                sum += a[j] * b[k - j];
            }
            sum
        })
    }

    fn quotient(&self, other: &Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        let length = if other.length == 1 { self.length() } else { self.common(other) };
        Series::build(self.common(other), length, |k, quotient| {
            let mut left = a[k];
            for j in 1..=k.min(other.length() - 1) {
                left -= b[j] * quotient[k - j];
            }
            left / b[0]
        })
    }
}

fn factorial(k: usize) -> f64 {
    (1..=k).map(|j| j as f64).product()
}

impl<B: Number> Arithmetic for Series<B> {
    type Inner = B;
    const DERIVATIVES: usize = B::NDERIV + TERMS - 1;

    fn constant(value: B) -> Self {
        Series::constant(value)
    }
    fn real(self) -> f64 {
        self.coefficients[0].re()
    }
    fn known_value(self) -> Option<f64> {
        self.value().known_value()
    }
    fn same(self, other: Self) -> bool {
        self.coefficients[0] == other.coefficients[0]
    }
    #[inline]
    fn plus(self, other: Self) -> Self {
        self.sum(&other)
    }
    #[inline]
    fn minus(self, other: Self) -> Self {
        self.difference(&other)
    }
    #[inline]
    fn times(self, other: Self) -> Self {
        self.product(&other)
    }
    #[inline]
    fn over(self, other: Self) -> Self {
        self.quotient(&other)
    }
    fn negated(self) -> Self {
        Series::build(self.known(), self.length(), |k, _| -self.coefficients[k])
    }
    fn power(self, n: i32) -> Self {
        power_by_squaring(self, n)
    }
    fn real_power(self, n: f64) -> Self {
        if n.fract() == 0.0 && n.abs() <= 64.0 {
            return self.power(n as i32);
        }
        let x = &self.coefficients;
        self.power_of_value(x[0].powf(n), &|j, k| B::from(n * j as f64 - (k - j) as f64))
    }
    fn rational_power(self, n: Ratio) -> Self {
        let (above, below) = (n.numerator as f64, n.denominator as f64);
        let factor = |j: usize, k: usize| B::from(above * j as f64 - below * (k - j) as f64) / below;
        self.power_of_value(self.coefficients[0].rational_power(n), &factor)
    }
    fn apply(self, function: Function) -> Self {
        let (one, x0) = (Series::constant(B::one()), self.coefficients[0]);
        let value = || function.of(x0);
        match function {
            Function::Sqrt => self.real_power(0.5),
            Function::Cbrt => self.power_of_value(value(), &|j, k| B::from(j as f64 - 3.0 * (k - j) as f64) / 3.0),
            Function::Exp => Series::build(self.known(), self.length_of_function(), |k, y| match k {
                0 => value(),
                _ => Self::integral_step(k, &self.coefficients, y),
            }),
            Function::ExpM1 => self.integrate(value(), self.apply(Function::Exp)),
            Function::Ln => self.integrate(value(), one.over(self)),
            Function::Ln1p => self.integrate(value(), one.over(one + self)),
            Function::Sin => self.sine_cosine().0,
            Function::Cos => self.sine_cosine().1,
            Function::Tan => {
                let (sine, cosine) = self.sine_cosine();
                sine.over(cosine)
            }
            Function::Sinh => self.coupled(x0.sinh(), x0.cosh(), 1.0).0,
            Function::Cosh => self.coupled(x0.sinh(), x0.cosh(), 1.0).1,
            // y′ = (1 − y²)·x′, which does not overflow where sinh and cosh do
            Function::Tanh => Series::build(self.known(), self.length_of_function(), |k, y| match k {
                0 => value(),
                _ => {
                    let slope = |m: usize| {
                        let mut square: B = y[0] * y[m];
                        for i in 1..=m {
                            square += y[i] * y[m - i];
                        }
                        if m == 0 { -square + 1.0 } else { -square }
                    };
                    let mut sum = self.coefficients[1] * slope(k - 1) * 1.0;
                    for j in 2..=k {
                        sum += self.coefficients[j] * slope(k - j) * j as f64;
                    }
                    sum / k as f64
                }
            }),
            Function::Asin => self.integrate(value(), one.over((one - self * self).apply(Function::Sqrt))),
            Function::Acos => self.integrate(value(), -one.over((one - self * self).apply(Function::Sqrt))),
            Function::Atan => self.integrate(value(), one.over(one + self * self)),
            Function::Asinh => self.integrate(value(), one.over((self * self + one).apply(Function::Sqrt))),
            Function::Acosh => self.integrate(value(), one.over((self * self - one).apply(Function::Sqrt))),
            Function::Atanh => self.integrate(value(), one.over(one - self * self)),
        }
    }
    fn sine_cosine(self) -> (Self, Self) {
        let (sine, cosine) = self.coefficients[0].sin_cos();
        self.coupled(sine, cosine, -1.0)
    }
    fn angle_from(self, x: Self) -> Self {
        // d(angle) = (x dy − y dx) / (x² + y²)
        let square = x * x + self * self;
        let (along_y, along_x) = (x.over(square), self.over(square));
        let value = self.coefficients[0].atan2(x.coefficients[0]);
        let length = self.length_of_function().max(x.length_of_function());
        Series::build(self.common(&x), length, |k, _| match k {
            0 => value,
            _ => {
                Self::integral_step(k, &self.coefficients, &along_y.coefficients)
                    - Self::integral_step(k, &x.coefficients, &along_x.coefficients)
            }
        })
    }
}

impl<B: Number> fmt::Display for Series<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, coefficient) in self.coefficients[..self.known()].iter().enumerate() {
            if k > 0 {
                write!(f, " + ")?;
            }
            write!(f, "({coefficient})τ^{k}")?;
        }
        write!(f, " + O(τ^{})", self.known)
    }
}

dual_number!(Series<B: Number>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::RunningError;
    use num_dual::DualNum;

    #[test]
    fn a_power_of_zero_has_finite_derivatives() {
        let t = Series::time(0.0_f64);
        let square = t.powi(2);
        assert_eq!(square.nth_derivative_value(2), Some(2.0));
        assert_eq!(square.nth_derivative_value(3), Some(0.0));
        assert_eq!(t.powf(3.0).nth_derivative_value(3), Some(6.0));
        assert_eq!(t.powi(0).nth_derivative_value(1), Some(0.0));
    }

    #[test]
    fn a_constant_without_a_value_has_no_rate() {
        let (zero, t) = (Series::constant(0.0_f64), Series::time(2.0));
        for nothing in [zero / zero, zero.ln() * 2.0, (zero - 1.0).sqrt() + t, t * (zero / zero)] {
            assert!(nothing.derivative().value().is_nan());
            assert!(nothing.nth_derivative_value(1).is_some_and(f64::is_nan));
            assert!(nothing.derivative().derivative().value().is_nan());
        }
        // must-fail case: what has a value and does not vary has the rate 0
        assert_eq!(((zero + 4.0).sqrt() * 3.0).derivative().value(), 0.0);
    }

    #[test]
    fn a_polynomial_is_the_series_with_its_zeros_written_out() {
        let t = Series::time(0.7_f64);
        let polynomials = [Series::constant(1.3), t, t * t - t * 2.0, (t + 0.4) * t * t];
        let written_out = |x: Series<f64>| {
            Series::from_derivatives(&(0..TERMS).filter_map(|k| x.nth_derivative_value(k)).collect::<Vec<_>>())
        };
        for a in polynomials {
            for b in polynomials {
                let (x, y) = (written_out(a), written_out(b));
                let pairs = [(a + b, x + y), (a - b, x - y), (a * b, x * y), (a / b, x / y), (-a, -x)];
                let functions =
                    [(a.sin(), x.sin()), (a.atan2(b), x.atan2(y)), (a.exp(), x.exp()), (a.tanh(), x.tanh())];
                for (short, long) in pairs.into_iter().chain(functions) {
                    for k in 0..TERMS {
                        let (short, long) = (short.nth_derivative_value(k), long.nth_derivative_value(k));
                        assert!(short.zip(long).is_some_and(|(s, l)| (s - l).abs() <= 1e-12 * (1.0 + l.abs())), "{k}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_rate_is_the_value_of_a_derivative() {
        let t = Series::time(RunningError::new(0.7));
        for x in [t, t * t - t * 2.0, t.sin() * t.truncated(4), Series::constant(RunningError::new(1.3))] {
            let mut derivative = x;
            for k in 0..x.known() {
                let (rate, expected) = (x.rate(k).unwrap(), derivative.value());
                assert_eq!((rate.value, rate.magnitude), (expected.value, expected.magnitude));
                derivative = derivative.derivative();
            }
            assert!(x.rate(x.known()).is_none());
        }
        // must-fail case: it is no coefficient
        assert_eq!((t * t).rate(2).unwrap().value, 2.0);
    }

    #[test]
    fn what_is_not_known_is_absent() {
        let x = Series::from_derivatives(&[1.0_f64, 2.0]);
        assert_eq!((x * x).nth_derivative_value(1), Some(4.0));
        assert_eq!((x * x).nth_derivative_value(2), None);
        assert_eq!((x * 3.0).known(), 2);
        assert_eq!(x.derivative().known(), 1);
        assert!(x.derivative().derivative().value().is_nan());
        // must-fail case: a constant is known to all orders
        assert_eq!(Series::constant(3.0_f64).derivative().nth_derivative_value(4), Some(0.0));
    }
}
