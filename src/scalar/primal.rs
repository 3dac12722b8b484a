//! The primal value of a series: its first coefficient without the derivatives.
//!
//! Most values are never differentiated, and a [`Series`](super::Series) would carry six coefficients to use one. Every
//! operation on a [`Primal`] rounds as the same operation on a series does, so that both give the same number.

use std::cmp::Ordering;
use std::fmt;

use super::arithmetic::{dual_number, power_by_squaring};
use super::{Arithmetic, Function, Number, Ratio};

/// The value of a series, without its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Primal<B>(pub B);

impl<B: Number> Arithmetic for Primal<B> {
    type Inner = B;
    const DERIVATIVES: usize = B::NDERIV;

    fn constant(value: B) -> Self {
        Primal(value)
    }
    fn real(self) -> f64 {
        self.0.re()
    }
    fn known_value(self) -> Option<f64> {
        self.0.known_value()
    }
    fn same(self, other: Self) -> bool {
        self.0 == other.0
    }
    /// The order; where doubles show none, that of the numbers below: 10⁻⁴⁰⁰ is 0 to a double.
    fn order(self, other: Self) -> Option<Ordering> {
        match self.real().partial_cmp(&other.real()) {
            Some(Ordering::Equal) => {
                let difference = self.0 - other.0;
                Some(match (difference.is_negative(), difference.is_positive()) {
                    (true, _) => Ordering::Less,
                    (_, true) => Ordering::Greater,
                    _ => Ordering::Equal,
                })
            }
            found => found,
        }
    }
    #[inline]
    fn plus(self, other: Self) -> Self {
        Primal(self.0 + other.0)
    }
    #[inline]
    fn minus(self, other: Self) -> Self {
        Primal(self.0 - other.0)
    }
    #[inline]
    fn times(self, other: Self) -> Self {
        Primal(self.0 * other.0)
    }
    #[inline]
    fn over(self, other: Self) -> Self {
        Primal(self.0 / other.0)
    }
    #[inline]
    fn negated(self) -> Self {
        Primal(-self.0)
    }
    fn power(self, n: i32) -> Self {
        power_by_squaring(self, n)
    }
    fn real_power(self, n: f64) -> Self {
        match n.fract() == 0.0 && n.abs() <= 64.0 {
            true => self.power(n as i32),
            false => Primal(self.0.powf(n)),
        }
    }
    fn rational_power(self, n: Ratio) -> Self {
        Primal(self.0.rational_power(n))
    }
    fn apply(self, function: Function) -> Self {
        match function {
            Function::Sqrt => self.real_power(0.5),
            Function::Sin => self.sine_cosine().0,
            Function::Cos => self.sine_cosine().1,
            Function::Tan => {
                let (sine, cosine) = self.sine_cosine();
                sine.over(cosine)
            }
            function => Primal(function.of(self.0)),
        }
    }
    fn angle_from(self, x: Self) -> Self {
        Primal(self.0.atan2(x.0))
    }
    fn sine_cosine(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Primal(sine), Primal(cosine))
    }
}

impl<B: fmt::Display> fmt::Display for Primal<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

dual_number!(Primal<B: Number>);
