//! A value with a running bound on its rounding error (running error analysis: Wilkinson 1986; Higham, *Accuracy and
//! Stability of Numerical Algorithms*, section 3.3).
//!
//! Two sides of an equation are compared on the scale of the terms in their sums, not of the result after cancellation.
//! [`RunningError`] carries that scale: the magnitudes of terms add.
//!
//! # Why a number carries a magnitude
//!
//! For a sum the magnitudes of the terms add, so a cancellation is remembered. A result that is only rounding has
//! no value: a quotient by it, 1/(sin² + cos² − 1), is undefined, and so is the sine of an angle so large that its
//! rounding is no longer small beside a turn. Otherwise such a quotient would be a large number, and be compared.

use std::fmt;

use num_dual::Dual64;

use super::arithmetic::dual_number;
use super::{Arithmetic, Function, Number};

/// A real value, and the size of its rounding error in units of the machine epsilon.
///
/// A quotient by a number that may be rounding error alone (such as sin² + cos² − 1) is NaN. So is the sine of an angle
/// whose rounding error is not small compared with a turn.
///
/// Constants and inputs have magnitude |value|; for a sum the magnitudes add, for a product it is |a|·mb + |b|·ma, for
/// a function |f(x)| + |f′(x)|·mx. The magnitude is never below |value|.
#[derive(Clone, Copy, Debug)]
pub struct RunningError {
    /// The value, exactly as `f64` arithmetic gives it.
    pub value: f64,
    /// To first order, the value is off by no more than a few epsilons times this.
    pub magnitude: f64,
}

/// The number of roundings that may be in a value for each unit of its magnitude.
const ROUNDINGS: f64 = 8.0;

impl RunningError {
    /// A value known as well as an `f64` can hold it.
    pub fn new(value: f64) -> Self {
        RunningError { value, magnitude: value.abs() }
    }

    /// Whether rounding alone could have made this of a zero.
    fn is_noise(self) -> bool {
        self.value.abs() <= ROUNDINGS * f64::EPSILON * self.magnitude
    }

    /// The result of dividing by what may be zero.
    const UNDEFINED: RunningError = RunningError { value: f64::NAN, magnitude: f64::NAN };

    /// What has a value that was not found. A state where a side is unknown does not count.
    const UNKNOWN: RunningError = RunningError { value: 1.0, magnitude: f64::INFINITY };

    /// Whether nothing is known of the value.
    pub fn is_unknown(self) -> bool {
        self.value.is_finite() && self.magnitude == f64::INFINITY
    }

    /// The result of an operation that is not defined at what may be 0, or at what has lost all digits.
    fn undefined_at(self) -> RunningError {
        if self.is_unknown() { RunningError::UNKNOWN } else { RunningError::UNDEFINED }
    }

    fn from_slope(value: f64, slope: f64, magnitude: f64) -> Self {
        // an input known exactly (magnitude 0) adds nothing, however steep the function
        let carried = if magnitude == 0.0 { 0.0 } else { slope.abs() * magnitude };
        RunningError { value, magnitude: value.abs() + carried }
    }
}

impl fmt::Display for RunningError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (scale {})", self.value, self.magnitude)
    }
}

impl Arithmetic for RunningError {
    type Inner = f64;

    fn constant(value: f64) -> Self {
        RunningError::new(value)
    }
    fn uncertain(error: f64) -> Option<Self> {
        let magnitude = error / (ROUNDINGS * f64::EPSILON);
        Some(if magnitude.is_finite() { RunningError { value: 0.0, magnitude } } else { RunningError::UNKNOWN })
    }
    fn real(self) -> f64 {
        self.value
    }
    fn plus(self, other: Self) -> Self {
        RunningError { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }
    fn minus(self, other: Self) -> Self {
        RunningError { value: self.value - other.value, magnitude: self.magnitude + other.magnitude }
    }
    fn times(self, other: Self) -> Self {
        let magnitude = self.value.abs() * other.magnitude + other.value.abs() * self.magnitude;
        RunningError { value: self.value * other.value, magnitude }
    }
    fn over(self, other: Self) -> Self {
        if other.is_noise() {
            return other.undefined_at();
        }
        let value = self.value / other.value;
        RunningError { value, magnitude: (self.magnitude + value.abs() * other.magnitude) / other.value.abs() }
    }
    fn negated(self) -> Self {
        RunningError { value: -self.value, magnitude: self.magnitude }
    }
    fn power(self, n: i32) -> Self {
        if n == 0 {
            return RunningError::new(1.0);
        }
        if n < 0 && self.is_noise() {
            return self.undefined_at();
        }
        let slope = f64::from(n) * self.value.powi(n - 1);
        Self::from_slope(self.value.powi(n), slope, self.magnitude)
    }
    fn real_power(self, n: f64) -> Self {
        if n == 0.0 {
            return RunningError::new(1.0);
        }
        // The compiler may turn x^(1/2) into √x, which rounds otherwise, in one caller and not in another.
        let value = if n == 0.5 { self.value.sqrt() } else { self.value.powf(n) };
        Self::from_slope(value, n * self.value.powf(n - 1.0), self.magnitude)
    }
    fn apply(self, function: Function) -> Self {
        let periodic = matches!(function, Function::Sin | Function::Cos | Function::Tan);
        if periodic && self.magnitude * f64::EPSILON > 1e-5 {
            return self.undefined_at();
        }
        let moving = Dual64::new(self.value, 1.0);
        let Dual64 { re, eps } = match function {
            Function::Tanh => moving.hyperbolic_tangent(),
            _ => function.of(moving),
        };
        Self::from_slope(re, eps, self.magnitude)
    }
    fn sine_cosine(self) -> (Self, Self) {
        if self.magnitude * f64::EPSILON > 1e-5 {
            return (self.undefined_at(), self.undefined_at());
        }
        let (sine, cosine) = self.value.sin_cos();
        (Self::from_slope(sine, cosine, self.magnitude), Self::from_slope(cosine, sine, self.magnitude))
    }
    fn angle_from(self, x: Self) -> Self {
        let value = self.value.atan2(x.value);
        let square = self.value * self.value + x.value * x.value;
        let carried = (x.value.abs() * self.magnitude + self.value.abs() * x.magnitude) / square;
        RunningError { value, magnitude: value.abs() + carried }
    }
}

dual_number!(RunningError);

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::DualNum;

    #[test]
    fn a_cancellation_is_remembered() {
        let large = RunningError::new(1e10);
        let difference = (large + 1.0) - large;
        assert_eq!(difference.value, 1.0);
        assert!(difference.magnitude >= 2e10);
        // must-fail case: without cancellation the scale stays that of the value
        assert!((RunningError::new(1.0) + 2.0).magnitude <= 3.0);
    }

    #[test]
    fn the_magnitude_covers_the_value_and_its_error() {
        let x = RunningError::new(0.3);
        for y in [x * x, x / 7.0, x.sin(), x.exp(), x.powi(3), x.powi(-2), x.powf(0.5), x.atan2(x), x.ln()] {
            assert!(y.magnitude >= y.value.abs(), "{y}");
        }
        // π off by an epsilon: the sine is all error, and the scale says so
        let sine = RunningError::new(std::f64::consts::PI).sin();
        assert!(sine.value.abs() <= f64::EPSILON * sine.magnitude);
    }

    #[test]
    fn a_quotient_by_rounding_is_undefined() {
        let x = RunningError::new(0.3);
        let nothing = x.sin() * x.sin() + x.cos() * x.cos() - 1.0;
        assert!((x / nothing).value.is_nan());
        assert!(nothing.powi(-1).value.is_nan());
        // must-fail case: small, and known to be
        assert_eq!((RunningError::new(1.0) / 1e-200).value, 1e200);
    }

    #[test]
    fn what_is_unknown_stays_unknown() {
        let uncertain = <RunningError as Number>::uncertain;
        let unknown = uncertain(f64::INFINITY).expect("a number");
        let x = RunningError::new(0.3);
        for y in
            [unknown, x / unknown, unknown / x, unknown + x, unknown * x, unknown.powi(-2), unknown.sin(), unknown.ln()]
        {
            assert!(y.is_unknown(), "{y}");
        }
        // must-fail cases: what has no value, and what is known up to an error
        assert!(!(x / 0.0).is_unknown() && !RunningError::UNDEFINED.is_unknown());
        assert!(!uncertain(1e-12).expect("a number").is_unknown());
    }

    #[test]
    fn exact_zero_carries_nothing_through_a_steep_function() {
        assert_eq!(RunningError::new(0.0).sqrt().magnitude, 0.0);
    }
}
