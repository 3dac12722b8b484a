//! The free rigid body: three different principal moments, no forces. From its rotation matrix, as the heavy top.

use nalgebra::Matrix3;

use crate::mechanics::rotations::{RotationalState, euler_angles};
use crate::mechanics::{Lagrangian, State};
use crate::scalar::Number;

/// Coordinates φ, θ, ψ (Euler angles z–y–z); parameters λ₁, λ₂, λ₃. The potential energy is 0, so that T is L.
pub struct FreeRigidBody;

impl Lagrangian<3, 3> for FreeRigidBody {
    fn name(&self) -> &str {
        "free_rigid_body"
    }
    fn coordinates(&self) -> [&str; 3] {
        ["\\phi", "\\theta", "\\psi"]
    }
    fn parameters(&self) -> [&str; 3] {
        ["\\lambda_1", "\\lambda_2", "\\lambda_3"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 3, 3>) -> D {
        RotationalState::of(self, at).map_or(D::zero(), |turning| turning.kinetic_energy(at.parameters))
    }
    fn potential_energy<D: Number>(&self, _: &State<D, 3, 3>) -> Option<D> {
        Some(D::zero())
    }
    fn orientation<D: Number>(&self, at: &State<D, 3, 3>) -> Option<Matrix3<D>> {
        let [phi, theta, psi] = at.q;
        Some(euler_angles(phi, theta, psi))
    }
    fn principal_moments<D: Number>(&self, at: &State<D, 3, 3>) -> Option<[D; 3]> {
        Some(at.parameters)
    }
}
