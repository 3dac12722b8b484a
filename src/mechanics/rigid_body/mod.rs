//! Rigid-body kinematics: rotations, angular velocity, rotating frames, inertia tensors.
//!
//! Conventions: an orientation is a matrix R whose *rows* are the body's axes in space components. R therefore takes
//! space components of a vector to body components. Euler angles are φ, θ, ψ in the z–y–z convention, R = R_z(ψ) R_y(θ)
//! R_z(φ) with passive rotations. Angles are in radians, right-handed.
//!
//! This folder knows numbers, [`State`](super::State) and the nodes of a body ([`quadrature`](super::quadrature)). It
//! knows nothing of traced systems.
//!
//! Offers `rotations`, `frames` and `inertia`.

pub mod frames;
pub mod inertia;
pub mod rotations;
