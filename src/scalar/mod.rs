//! The numbers on which Lagrangians and formulas are evaluated.
//!
//! Each is a [`num_dual::DualNum`], so that one generic Rust function runs over all of them:
//!
//! - `f64`, and the dual numbers of num-dual (forward-mode automatic differentiation);
//! - [`Series`]: a truncated Taylor series in time;
//! - [`Primal`]: the value of a series without its derivatives;
//! - [`RunningError`]: a value with a running bound on its rounding error;
//! - [`Enclosure`]: a value of any precision between bounds;
//! - [`Interval`]: the bounds of a formula over ranges, in doubles; no [`num_dual::DualNum`], since it has no value;
//! - [`Symbol`]: a node of an expression graph, for tracing a function ([`Graph::record`]);
//! - [`Modular`]: an element of a prime field, for polynomial identity testing ([`prime_field`]).
//!
//! A new number implements the functions of [`Arithmetic`] and calls the macro `dual_number!`; nothing else.
//! [`simplify_all`] shortens traced expressions, and [`rational`] finds the exact constant that an `f64` was written
//! for.
//!
//! This folder imports the crate's error type, and knows nothing of mechanics, formulas or files.
//!
//! Offers these numbers and [`Number`], what every one of them can do.

pub use num_dual::DualNum;

mod arithmetic;
#[cfg(feature = "notes")]
pub mod enclosure;
#[cfg(feature = "notes")]
pub mod interval;
mod lists;
mod number;
mod primal;
pub mod prime_field;
pub mod rational;
mod running_error;
mod series;
mod simplify;
mod symbol;
mod vectors;

pub use arithmetic::{Arithmetic, Function};
#[cfg(feature = "notes")]
pub use enclosure::Enclosure;
#[cfg(feature = "notes")]
pub use interval::Interval;
pub(crate) use lists::{each, up_to};
pub use number::Number;
pub use primal::Primal;
pub use prime_field::Modular;
pub use rational::Ratio;
pub use running_error::RunningError;
pub use series::{Series, TERMS};
pub use simplify::{simplify_all, try_simplify};
pub use symbol::{Graph, Node, Symbol};
pub(crate) use vectors::{cross, dot};

#[cfg(test)]
mod tests {
    use num_dual::third_derivative;
    use proptest::prelude::*;

    use super::*;

    /// One of many functions of one variable, by its number.
    fn function<D: DualNum<Primitive = f64> + Copy>(which: usize, t: D) -> D {
        let x = t * t * 0.3 + 0.2; // within every domain for 0 < t < 1.2
        match which {
            0 => x.exp() * x.ln(),
            1 => x.sqrt() + x.cbrt(),
            2 => x.powf(2.7) - x.powf(3.0) / x.powi(-2),
            3 => x.powi(5) + x.powi(-3),
            4 => x.sin() * x.cos() + x.tan(),
            5 => x.asin() - x.acos() * x,
            6 => x.atan() + t.atan2(x),
            7 => x.sinh() * x.cosh() - x.tanh(),
            8 => x.asinh() + (x + 1.0).acosh() + x.atanh(),
            9 => x.exp_m1() * x.ln_1p(),
            10 => x.exp2() + x.log2() + x.log10() - x.log(3.0),
            11 => x.recip() / (x + t) - x.powd(t),
            12 => x.sph_j0() + x.sph_j1() * x.sph_j2(),
            _ => x.abs() + x.signum() - (t - 2.0).abs() + x.mul_add(t, x),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn series_have_the_derivatives_of_num_dual(t in 0.2..1.2_f64, which in 0..14_usize) {
            let series = function(which, Series::time(t));
            let (f0, f1, f2, f3) = third_derivative(|t| function(which, t), t);
            let derivatives: Vec<f64> = (0..4).map(|k| series.nth_derivative_value(k).unwrap()).collect();
            for (k, (a, b)) in derivatives.iter().zip([f0, f1, f2, f3]).enumerate() {
                prop_assert!((a - b).abs() <= 1e-10 * (1.0 + b.abs()), "function {which}, order {k}: {a} {b}");
            }
            // the derivative of the series is the series of the derivative, to the orders that num-dual has not
            let fifth = series.derivative().derivative().nth_derivative_value(3).unwrap();
            prop_assert!((fifth - series.nth_derivative_value(5).unwrap()).abs() <= 1e-12 * (1.0 + fifth.abs()));
            // must-fail case: an order off is noticed
            prop_assert!(which == 13 || derivatives[2] != derivatives[3]);
        }

        #[test]
        fn an_instant_is_the_first_coefficient_of_a_series(t in 0.2..1.2_f64, which in 0..14_usize) {
            let t = RunningError::new(t);
            let (series, instant) = (function(which, Series::constant(t)), function(which, Primal(t)));
            let (a, b) = (series.value(), instant.0);
            prop_assert_eq!((a.value, a.magnitude), (b.value, b.magnitude), "function {}", which);
            // must-fail case: a plain number finds a power, and how large its rounding is, in another way
            let plain = function(which, t);
            prop_assert!(which != 3 || (plain.value, plain.magnitude) != (b.value, b.magnitude));
        }

        #[test]
        fn a_measured_number_has_the_value_of_the_plain_one(t in 0.2..1.2_f64, which in 0..14_usize) {
            let (plain, measured) = (function(which, t), function(which, RunningError::new(t)));
            prop_assert!((plain - measured.value).abs() <= 8.0 * f64::EPSILON * measured.magnitude);
            prop_assert!(measured.magnitude >= measured.value.abs());
            // and the bound is not far too large
            prop_assert!(measured.magnitude <= 1e4 * (1.0 + plain.abs()), "function {which}: {measured}");
        }
    }
}
