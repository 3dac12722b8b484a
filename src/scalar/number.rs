//! The bound that mechanics and formulas put on a number, and the constants that a number must know exactly.
//!
//! A double cannot hold 1/3, π, or a printed number of many digits. So a formula asks its number for such a constant,
//! and a number that can be exact (a prime field, an enclosure) is. A meaning is never guessed from a double.

use num_dual::{Dual, Dual2, Dual2SVec, Dual3, DualNum, DualSVec, DualStruct, HyperDual, HyperHyperDual};
use num_traits::Signed;

use super::rational::Ratio;

/// A number that mechanics and formulas are evaluated on: a `Copy` dual number over `f64` that may cross threads.
pub trait Number: DualNum<Primitive = f64> + Copy + Send + Sync {
    /// The constant that these decimal digits write, such as `2`, `0.25` or `1e-3`; `None` if they write none.
    fn decimal(digits: &str) -> Option<Self> {
        double(digits).map(Self::from)
    }
    /// The constant π.
    fn pi() -> Self {
        Self::from(std::f64::consts::PI)
    }
    /// A number that is 0 up to this error, for what is known no better, and unknown if that is infinite; `None` for
    /// numbers that must be exact.
    fn uncertain(error: f64) -> Option<Self>;
    /// The hyperbolic tangent, and its derivatives, also where the hyperbolic sine and cosine are too large for a double.
    fn hyperbolic_tangent(self) -> Self {
        self.tanh()
    }
    /// The power with a constant rational exponent, for positive numbers.
    fn rational_power(self, exponent: Ratio) -> Self {
        self.powf(exponent.value())
    }
    /// Its value, if it has one: what is traced has none but for constants.
    fn known_value(&self) -> Option<f64> {
        Some(self.re())
    }
}

/// The double nearest to a decimal; most have one digit.
fn double(digits: &str) -> Option<f64> {
    match digits.as_bytes() {
        [digit @ b'0'..=b'9'] => Some(f64::from(digit - b'0')),
        _ => digits.parse().ok(),
    }
}

impl Number for f64 {
    fn uncertain(error: f64) -> Option<Self> {
        Some(if error.is_finite() { 0.0 } else { f64::NAN })
    }
}

/// The numbers of num-dual take their constants from the number that they are built over.
macro_rules! over_inner {
    ($($name:ident $(<$n:ident>)?),*) => {
        $(impl<D: Number $(, const $n: usize)?> Number for $name<D $(, $n)?> {
            fn decimal(digits: &str) -> Option<Self> {
                D::decimal(digits).map(Self::from_re)
            }
            fn pi() -> Self {
                Self::from_re(D::pi())
            }
            fn uncertain(error: f64) -> Option<Self> {
                D::uncertain(error).map(Self::from_re)
            }
            fn known_value(&self) -> Option<f64> {
                self.re.known_value()
            }
            fn hyperbolic_tangent(self) -> Self {
                // num-dual divides the hyperbolic sine by the cosine.
                if <Self as DualStruct>::re(&self).abs() >= 20.0 {
                    let one = Self::from_re(D::one());
                    let small = (Signed::abs(&self) * -2.0).exp();
                    return Signed::signum(&self) * ((one - small) / (one + small));
                }
                self.tanh()
            }
        })*
    };
}
over_inner!(Dual, Dual2, Dual3, HyperDual, HyperHyperDual, DualSVec<N>, Dual2SVec<N>);

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;

    #[test]
    fn the_hyperbolic_tangent_of_a_large_number_is_one() {
        for (x, value) in [(1e3, 1.0), (-1e3, -1.0), (1e200, 1.0)] {
            let found = Dual64::new(x, 1.0).hyperbolic_tangent();
            assert_eq!((found.re, found.eps), (value, 0.0), "{x}");
        }
        // Both ways agree where both can be taken.
        for x in [19.9, 20.1, -20.1] {
            let (own, other) = (Dual64::new(x, 1.0).hyperbolic_tangent(), Dual64::new(x, 1.0).tanh());
            assert!((own.re - other.re).abs() < 1e-15 && (own.eps - other.eps).abs() < 1e-15, "{own} {other}");
        }
        // must-fail case: the quotient of sine and cosine is no number there
        assert!(Dual64::new(1e3, 1.0).tanh().re.is_nan());
    }
}
