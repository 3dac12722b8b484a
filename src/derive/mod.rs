//! What the machine derived, as a formula that people read: L, momenta, equations of motion, H, typeset.
//!
//! `mechanics` has what follows from a Lagrangian as a recorded graph, good for numbers and unreadable. Here it becomes
//! a [`formula::Expr`](crate::formula::Expr) with the system's own names. `normal` expands the graph over atoms with exact
//! rational coefficients (`rational`, `polynomial`, `algebra`), `shorten` finds the shortest way to write it, `print`
//! collects and orders it. `linear` solves for accelerations and for the velocities that belong to momenta. `names` has
//! the letters, [`quantities`] says what there is to derive, and [`mod@difference`] shows what is left of one side
//! without the other.
//!
//! A normal form explains, and decides nothing: no verdict is taken from it. What is typeset here reads back to the
//! numbers that automatic differentiation gives, and that is tested for every system. Where no exact form is found, or
//! none that can be printed, that is an error.

mod algebra;
pub mod difference;
mod linear;
mod names;
mod normal;
mod polynomial;
mod print;
pub mod quantities;
mod rational;
mod shorten;

pub use difference::{difference, equation_of_motion};
pub use quantities::{Derivation, Equation, Quantity};

use crate::formula::Expr;

/// The name of an input of a recorded graph, and what kind of thing it is, for its place in a term.
#[derive(Clone, Debug)]
pub struct Letter {
    /// The input as it is printed.
    pub expr: Expr,
    /// What it is.
    pub class: Class,
}

/// What an input is. In a term they stand in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// A parameter of the system, any other constant.
    Parameter,
    /// The time.
    Time,
    /// A coordinate.
    Coordinate,
    /// A generalized momentum.
    Momentum,
    /// The second time derivative of a coordinate.
    Acceleration,
    /// The first time derivative of a coordinate.
    Velocity,
}
