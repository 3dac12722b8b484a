//! Rotations and angular velocity.
//!
//! An orientation is a matrix R with êₐ = R_ab ê_b(0) (notes 5.64): its *rows* are the body's axes in space components,
//! so R takes the space components of a vector to its body components. A *passive* rotation turns the axes by an angle,
//! an *active* one turns the vectors; each is the transpose of the other.

use nalgebra::{Matrix3, Vector3};
use num_dual::Dual;

use crate::mechanics::{Lagrangian, State};
use crate::scalar::{Number, cross};

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Axis {
    X,
    Y,
    Z,
}

/// The active rotation of vectors by `angle` about the unit vector `axis`, right-handed (Rodrigues):
/// cos α·1 + sin α·[n×] + (1 − cos α)·n nᵀ.
pub fn rodrigues<D: Number>(axis: &Vector3<D>, angle: D) -> Matrix3<D> {
    let (sine, cosine) = angle.sin_cos();
    let cross = Matrix3::new(
        D::zero(),
        -axis.z,
        axis.y, //
        axis.z,
        D::zero(),
        -axis.x, //
        -axis.y,
        axis.x,
        D::zero(),
    );
    let along = Matrix3::from_fn(|i, j| axis[i] * axis[j] * (-cosine + 1.0));
    Matrix3::from_diagonal_element(cosine) + along + cross.map(|entry| entry * sine)
}

/// The active rotation by `angle` about a coordinate axis: v ↦ R v turns the vector.
pub fn active_rotation<D: Number>(axis: Axis, angle: D) -> Matrix3<D> {
    let mut unit = Vector3::zeros();
    unit[axis as usize] = D::one();
    rodrigues(&unit, angle)
}

/// The passive rotation by `angle` about a coordinate axis: the rows are the turned axes. About z it is
/// ((cos, sin, 0), (−sin, cos, 0), (0, 0, 1)), as in the notes' (5.63).
pub fn passive_rotation<D: Number>(axis: Axis, angle: D) -> Matrix3<D> {
    active_rotation(axis, angle).transpose()
}

/// R = R_z(ψ) R_y(θ) R_z(φ), each passive: the Euler angles of the notes' (5.63).
pub fn euler_angles<D: Number>(phi: D, theta: D, psi: D) -> Matrix3<D> {
    passive_rotation(Axis::Z, psi) * passive_rotation(Axis::Y, theta) * passive_rotation(Axis::Z, phi)
}

/// The angular velocity in *space* components, from the axes êₐ (rows of `r`) and their rates (rows of `rate`):
/// ω = ½ Σₐ êₐ × dêₐ/dt, the vector with dêₐ/dt = ω × êₐ.
pub fn angular_velocity<D: Number>(r: &Matrix3<D>, rate: &Matrix3<D>) -> Vector3<D> {
    let mut twice = Vector3::zeros();
    for a in 0..3 {
        let of = |m: &Matrix3<D>| Vector3::new(m[(a, 0)], m[(a, 1)], m[(a, 2)]);
        twice += cross(&of(r), &of(rate));
    }
    twice.map(|component| component * 0.5)
}

/// The components ωₐ = ω·êₐ of a vector along the body's axes.
pub fn body_components<D: Number>(r: &Matrix3<D>, vector: &Vector3<D>) -> Vector3<D> {
    r * vector
}

/// A matrix and its time derivative, from one over dual numbers in time.
pub fn value_and_rate<D: Number>(moving: &Matrix3<Dual<D>>) -> (Matrix3<D>, Matrix3<D>) {
    (moving.map(|entry| entry.re), moving.map(|entry| entry.eps))
}

/// The rotational state of a rigid body: its orientation, and its angular velocity in space and in body components.
#[derive(Clone, Copy, Debug)]
pub struct RotationalState<D> {
    /// R: the rows are the body's axes in space components.
    pub orientation: Matrix3<D>,
    /// ω in space components.
    pub angular_velocity: Vector3<D>,
    /// ωₐ = ω·êₐ.
    pub body_rates: Vector3<D>,
}

impl<D: Number> RotationalState<D> {
    /// From an orientation over dual numbers in time, as [`State::moving`] gives it.
    pub fn from_moving(moving: &Matrix3<Dual<D>>) -> Self {
        let (orientation, rate) = value_and_rate(moving);
        let angular_velocity = angular_velocity(&orientation, &rate);
        RotationalState { orientation, angular_velocity, body_rates: body_components(&orientation, &angular_velocity) }
    }

    /// The turning of a body with a Lagrangian at a state, if it has an orientation.
    pub fn of<L: Lagrangian<N, P>, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> Option<Self> {
        l.orientation(&at.moving()).map(|moving| RotationalState::from_moving(&moving))
    }

    /// The kinetic energy of rotation ½ Σ λₐ ωₐ² with the principal moments λ of the body.
    pub fn kinetic_energy(&self, moments: [D; 3]) -> D {
        let [one, two, three] = std::array::from_fn(|a| moments[a] * self.body_rates[a] * self.body_rates[a]);
        (one + two + three) * 0.5
    }
}
