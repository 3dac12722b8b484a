//! Numbers to evaluate on. Each is a [`num_dual::DualNum`], so that one Rust function of mechanics, or one formula read
//! from the notes, runs over all of them: `f64` and num-dual's own dual numbers, a Taylor series in time ([`Series`]),
//! a value that remembers its rounding ([`Measured`]), a node of a graph ([`Symbol`]).
//!
//! A new number implements the dozen functions of [`Arithmetic`] and calls the macro `dual_number!`; nothing else.
//! This floor knows nothing of mechanics, formulas or files.

pub use num_dual::DualNum;

mod arithmetic;
mod measured;
mod polynomial;
mod series;
mod symbol;

pub use arithmetic::{Arithmetic, Function};
pub use measured::Measured;
pub use polynomial::simplify_all;
pub use series::{Series, TERMS};
pub use symbol::{Graph, Node, Symbol};

/// A number that mechanics and formulas are evaluated on: any `Copy` dual number over `f64` that may cross threads.
///
/// Implemented for everything that qualifies; it is a short name for a bound.
pub trait Number: DualNum<Primitive = f64> + Copy + Send + Sync {}

impl<D: DualNum<Primitive = f64> + Copy + Send + Sync> Number for D {}
