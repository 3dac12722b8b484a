//! What is true: mechanics derived from a Lagrangian by automatic differentiation.
//!
//! A [`Lagrangian`] is a Rust function, generic in the number. From it follow the Euler–Lagrange equations
//! ([`euler_lagrange`]), momenta and energy ([`momenta`]), the Hamiltonian ([`legendre`]), time derivatives along a
//! motion ([`motion`]), cyclic coordinates ([`World::is_cyclic`]) and the effective potential of Routh
//! ([`World::effective_potential`]). [`World`] has all of it traced once, for many evaluations; the generic functions
//! of the other modules run the Lagrangian itself, and the two are tested against each other.
//!
//! What needs no Lagrangian: frames that turn ([`frames`]), bodies as nodes to integrate over ([`bodies`]), and what
//! resists their turning ([`inertia`]).
//!
//! This floor knows numbers ([`crate::scalar`]) and nothing of formulas or notes: no closed form that is printed
//! somewhere may enter here.

pub mod euler_lagrange;
mod lagrangian;
pub mod legendre;
mod linear_solver;
pub mod momenta;
pub mod motion;
mod newton;
pub mod quadrature;
pub mod rigid_body;
pub mod system;
mod tape;

pub use lagrangian::{Lagrangian, State};
pub(crate) use linear_solver::solve_by;
pub use linear_solver::{Elimination, MAX_CONDITION, condition_number};
pub use quadrature::{Body, Nodes, bodies};
pub use rigid_body::frames::{Frame, axes_about};
pub use rigid_body::{frames, inertia, rotations};
pub use system::{Accelerator, Quantities, System, World, of};
pub use tape::{Op, Tape};
