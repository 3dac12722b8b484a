//! The heavy symmetric top: a body with λ₁ = λ₂, turning about a fixed point in a uniform gravitational field.
//!
//! The orientation is a product of three elementary rotations (notes 5.63), the angular velocity
//! comes from the turning axes by differentiation, T = ½ Σ λₐ ωₐ², and the height of the centre of mass is read off the
//! third axis.

use nalgebra::Matrix3;

use crate::mechanics::rotations::{RotationalState, euler_angles};
use crate::mechanics::{Lagrangian, State};
use crate::scalar::Number;

/// Coordinates φ, θ, ψ (Euler angles z–y–z); parameters λ₁, λ₃, M, g and R, the distance of the centre of mass from the
/// fixed point along ê₃.
pub struct HeavyTop;

impl Lagrangian<3, 5> for HeavyTop {
    fn name(&self) -> &str {
        "heavy_top"
    }
    fn coordinates(&self) -> [&str; 3] {
        ["\\phi", "\\theta", "\\psi"]
    }
    fn parameters(&self) -> [&str; 5] {
        ["\\lambda_1", "\\lambda_3", "M", "g", "R"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 3, 5>) -> D {
        let [lambda_1, lambda_3, mass, g, distance] = at.parameters;
        let turning = RotationalState::from_moving(&orientation(&at.moving()));
        let height = turning.orientation[(2, 2)] * distance;
        turning.kinetic_energy([lambda_1, lambda_1, lambda_3]) - mass * g * height
    }
    fn potential_energy<D: Number>(&self, at: &State<D, 3, 5>) -> Option<D> {
        let [_, _, mass, g, distance] = at.parameters;
        Some(mass * g * (orientation(at)[(2, 2)] * distance))
    }
    fn orientation<D: Number>(&self, at: &State<D, 3, 5>) -> Option<Matrix3<D>> {
        Some(orientation(at))
    }
    fn principal_moments<D: Number>(&self, at: &State<D, 3, 5>) -> Option<[D; 3]> {
        let [lambda_1, lambda_3, ..] = at.parameters;
        Some([lambda_1, lambda_1, lambda_3])
    }
}

fn orientation<D: Number>(at: &State<D, 3, 5>) -> Matrix3<D> {
    let [phi, theta, psi] = at.q;
    euler_angles(phi, theta, psi)
}
