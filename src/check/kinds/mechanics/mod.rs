//! Claims about a Lagrangian or a Hamiltonian of the notes: the same motion, the charge of a symmetry, equilibria, normal
//! frequencies, oscillations about a steady motion, and motions with the energy of a start.
//!
//! Offers a function `check` in each file, or `holds`. Knows `judge` and below, as [`kinds`](super) does.

pub(crate) mod charge;
pub(crate) mod energy_of_start;
pub(crate) mod equilibrium;
mod expressions;
pub(crate) mod generates;
pub(crate) mod modes;
pub(crate) mod same_motion;
pub(crate) mod steady;
