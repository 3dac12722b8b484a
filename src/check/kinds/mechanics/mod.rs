//! Claims about a Lagrangian or a Hamiltonian of the notes: the same motion, the charge of a symmetry, equilibria, normal
//! frequencies, and oscillations about a steady motion.
//!
//! Offers a function `check` in each file. Knows `judge` and below, as [`kinds`](super) does.

pub(crate) mod charge;
pub(crate) mod equilibrium;
mod expressions;
pub(crate) mod generates;
pub(crate) mod modes;
pub(crate) mod same_motion;
pub(crate) mod steady;
