//! Derived quantities typeset as formulas: L, momenta, energy, equations of motion, H.
//!
//! `mechanics` records what follows from a Lagrangian as a graph, which can be evaluated and not be read. This
//! folder turns it into a [`formula::Expr`](crate::formula::Expr) with the system's own names. `normal` expands the
//! graph over atoms with exact rational coefficients (`rational`, `polynomial`, `algebra`), `shorten` finds the
//! shortest way to write it, `print` collects and orders it. `linear` solves for accelerations, and for the
//! velocities as functions of momenta. `names` has the letters, [`quantities`] lists what can be derived, and
//! [`mod@difference`] is the difference of two formulas.
//!
//! No verdict depends on a normal form; it only explains. The tests read every typeset formula back and compare it
//! with automatic differentiation, for every system. A quantity without an exact or printable form is an error.
//!
//! This folder imports `mechanics`, `scalar`, `formula`, and the typesetter of `latex`.
//!
//! Offers [`Derivation`], what follows from a system, and [`difference`](fn@difference), what two formulas differ by.

mod algebra;
pub mod difference;
mod linear;
mod names;
mod normal;
pub mod parts;
mod polynomial;
mod print;
pub mod quantities;
mod rational;
mod recorded;
mod shorten;

pub use difference::{difference, equation_of_motion};
pub use parts::{BodyFormulas, ParticleFormulas, Precession};
pub use quantities::{Derivation, Equation, Quantity};

use crate::formula::Expr;

/// The name of an input of a recorded graph, and its kind, which determines its place in a term.
#[derive(Clone, Debug)]
pub struct Letter {
    /// The input as it is printed.
    pub expr: Expr,
    /// Its kind.
    pub class: Class,
}

/// The kind of an input. The factors of a term are ordered by it.
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
