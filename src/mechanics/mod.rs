//! Lagrangian mechanics by automatic differentiation: accelerations, momenta, energy, the Hamiltonian, from L alone.
//!
//! A [`Lagrangian`] is a Rust function L(q, q̇, t), generic in the number. From it follow the Euler–Lagrange equations,
//! the generalized momenta pᵢ = ∂L/∂q̇ᵢ, the energy Σ pᵢ q̇ᵢ − L, the Hamiltonian, time derivatives along a motion, the
//! cyclic coordinates and the effective potential. No closed form is typed in anywhere.
//!
//! There are two ways to evaluate them:
//!
//! - [`System`] (folder [`system`]) traces the Lagrangian once. Use it for many evaluations, as a simulation needs.
//! - The functions of [`euler_lagrange`], [`momenta`], [`legendre`] and [`motion`] run the Lagrangian itself for each
//!   evaluation, over dual numbers. They need no preparation, and the traced results are tested against them.
//!
//! What needs no Lagrangian: rotations, rotating frames and inertia tensors ([`rigid_body`]), and integrals over bodies
//! ([`quadrature`]).
//!
//! Offers what is listed above, and [`LinearSolver`].
//!
//! # Example: simulate a top from its Lagrangian
//!
//! The heavy symmetric top has the Euler angles φ, θ, ψ as coordinates. L depends on neither φ, ψ nor the time, so p_φ,
//! p_ψ and the energy are conserved. The example integrates one second with the classical Runge–Kutta method and
//! measures how far they drift.
//!
//! ```
//! use onshell::mechanics::{AccelerationEvaluator, System};
//! use onshell::systems::HeavyTop;
//!
//! type Vector = [f64; 3];
//!
//! /// One step of length h of the classical Runge–Kutta method for q̇ = v, v̇ = a(q, v).
//! fn step(a: &mut AccelerationEvaluator<'_>, q: &mut Vector, v: &mut Vector, h: f64) -> onshell::Result<()> {
//!     let plus = |x: &Vector, dx: &Vector, h: f64| std::array::from_fn(|i| x[i] + h * dx[i]);
//!     let (mut dq, mut dv) = (*v, [0.0; 3]);
//!     let (mut sum_q, mut sum_v) = ([0.0; 3], [0.0; 3]);
//!     for (ahead, weight) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
//!         let (at_q, at_v): (Vector, Vector) = (plus(q, &dq, ahead * h), plus(v, &dv, ahead * h));
//!         (dq, dv) = (at_v, a.accelerations(0.0, &at_q, &at_v)?.try_into().unwrap());
//!         (sum_q, sum_v) = (plus(&sum_q, &dq, weight), plus(&sum_v, &dv, weight));
//!     }
//!     (*q, *v) = (plus(q, &sum_q, h / 6.0), plus(v, &sum_v, h / 6.0));
//!     Ok(())
//! }
//!
//! let top = System::new(&HeavyTop)?;
//! // moments of inertia in kg m², mass in kg, g in m/s², distance of the centre of mass in m
//! let parameters =
//!     top.parameter_values(&[("\\lambda_1", 0.8), ("\\lambda_3", 0.5), ("M", 1.0), ("g", 9.81), ("R", 0.3)])?;
//! let energy_and_momenta = |q: &Vector, v: &Vector| {
//!     let at = top.quantities(0.0, q, v, &parameters);
//!     [at.energy, at.momenta[0], at.momenta[2]]
//! };
//! // the largest relative change of the energy, p_φ and p_ψ in one second
//! let drift = |steps: usize| -> onshell::Result<f64> {
//!     let mut accelerations = top.acceleration_evaluator(&parameters);
//!     let (mut q, mut v) = ([0.0, 0.5, 0.0], [0.0, 0.0, 20.0]); // tilted by 0.5 rad, 20 rad/s about its axis
//!     let start = energy_and_momenta(&q, &v);
//!     for _ in 0..steps {
//!         step(&mut accelerations, &mut q, &mut v, 1.0 / steps as f64)?;
//!     }
//!     let end = energy_and_momenta(&q, &v);
//!     Ok((0..3).map(|k| (end[k] - start[k]).abs() / start[k].abs()).fold(0.0, f64::max))
//! };
//! assert!(drift(2000)? < 1e-9);
//! // a coarse step drifts more
//! assert!(drift(20)? > 100.0 * drift(2000)?);
//!
//! // the value of the Hamiltonian is the energy; without the potential energy it is not
//! let (q, v) = ([0.0, 0.5, 0.0], [0.3, 0.1, 20.0]);
//! let at = top.quantities(0.0, &q, &v, &parameters);
//! let hamiltonian = top.hamiltonian(0.0, &q, &at.momenta, &parameters)?;
//! assert!((hamiltonian - at.energy).abs() < 1e-12 * at.energy);
//! assert!((hamiltonian - at.kinetic.unwrap()).abs() > 1.0);
//! # Ok::<(), onshell::Error>(())
//! ```
//!
//! This folder imports numbers ([`crate::scalar`]) and errors. It knows nothing of formulas, notes or checks.

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

pub use lagrangian::{Lagrangian, Particle, State};
#[cfg(feature = "notes")]
pub(crate) use linear_solver::solve_with;
pub use linear_solver::{LinearSolver, MAX_CONDITION, condition_number};
pub use quadrature::{Body, Nodes, bodies};
pub use rigid_body::frames::{Frame, axes_about};
pub use rigid_body::{frames, inertia, rotations};
pub use system::{AccelerationEvaluator, AnyLagrangian, Applied, Parts, Quantities, System, erased};
pub use tape::{Op, Tape};
