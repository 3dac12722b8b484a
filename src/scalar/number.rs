//! The bound that mechanics and formulas put on a number, and the constants that a number must know exactly.
//!
//! A double cannot hold 1/3, π, or a printed number of many digits. So a formula asks its number for such a constant,
//! and a number that can be exact (a prime field, an enclosure) is. A meaning is never guessed from a double.

use num_dual::{Dual, Dual2, Dual2SVec, Dual3, DualNum, DualSVec, HyperDual, HyperHyperDual};

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
    /// The power with a constant rational exponent, for positive numbers.
    fn rational_power(self, exponent: Ratio) -> Self {
        self.powf(exponent.value())
    }
}

/// The double nearest to a decimal; most have one digit.
fn double(digits: &str) -> Option<f64> {
    match digits.as_bytes() {
        [digit @ b'0'..=b'9'] => Some(f64::from(digit - b'0')),
        _ => digits.parse().ok(),
    }
}

impl Number for f64 {}

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
        })*
    };
}
over_inner!(Dual, Dual2, Dual3, HyperDual, HyperHyperDual, DualSVec<N>, Dual2SVec<N>);
