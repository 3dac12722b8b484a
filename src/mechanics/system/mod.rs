//! A Lagrangian system traced once: everything that follows from its Lagrangian, for many evaluations over any number.
//!
//! The Lagrangian is recorded as a graph and differentiated in reverse and in forward mode (`tracing`). The results are
//! tapes of L, momenta, energy, forces, mass matrix and accelerations (`traced_system`). Accelerations of many states
//! are computed in blocks (`accelerations`, `programs`), or written as Rust source (`rust_source`). The Hamiltonian and
//! the Routhian are Legendre transforms, whole and partial (`legendre`, `routhian`); `cyclic` finds the cyclic
//! coordinates, `natural` tells whether L = T − V. `multipliers` completes the equations of motion where constraints have Lagrange multipliers.
//!
//! This folder imports the Lagrangian's trait, tapes, the linear solver and Newton's method from [`mechanics`](super),
//! and numbers from [`scalar`](crate::scalar).
//!
//! Offers [`System`], its [`AccelerationEvaluator`] and [`Quantities`].

mod accelerations;
mod any_lagrangian;
mod cyclic;
mod elimination;
mod layout;
mod legendre;
mod multipliers;
mod named_values;
mod natural;
mod programs;
mod routhian;
mod rust_source;
mod traced_system;
mod tracing;

pub use accelerations::AccelerationEvaluator;
pub use any_lagrangian::{AnyLagrangian, Parts, erased};
pub use traced_system::{Quantities, System};
pub use tracing::Applied;
