//! The centre of mass, the inertia tensor, principal moments and axes.
//!
//! The inertia tensor is the second derivative of the kinetic energy of rotation by the angular velocity,
//! I_ab = ∂²T/∂ω_a∂ω_b. Its closed form is not used here.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use num_dual::Dual;

use crate::mechanics::quadrature::Nodes;
use crate::scalar::{Number, cross, dot, each};
use crate::{Error, Result};

/// T = ½ Σ m |ω × r|² of particles (weights are masses) that turn about the origin with angular velocity ω.
pub fn kinetic_energy<D: Number>(particles: &Nodes<D>, angular_velocity: &Vector3<D>) -> D {
    particles.integral(|r| {
        let v = cross(angular_velocity, r);
        dot(&v, &v) * 0.5
    })
}

/// The inertia tensor about the origin, in the axes in which the points are given: T is quadratic in ω, so ∂T/∂ω_a at
/// the unit rate about b is its second derivative by both.
pub fn inertia_tensor<D: Number>(particles: &Nodes<D>) -> Matrix3<D> {
    let lift = |(r, mass): &(Vector3<D>, D)| (r.map(Dual::from_re), Dual::from_re(*mass));
    let lifted = Nodes { points: each(&particles.points, &lift) };
    let mut tensor = Matrix3::zeros();
    for a in 0..3 {
        for b in a..3 {
            let mut omega = Vector3::from_element(Dual::from_re(D::zero()));
            omega[b].re = D::one();
            omega[a].eps = D::one();
            tensor[(a, b)] = kinetic_energy(&lifted, &omega).eps;
            tensor[(b, a)] = tensor[(a, b)];
        }
    }
    tensor
}

/// Σ m r / Σ m.
///
/// # Errors
/// When the masses add up to 0, or are not finite.
pub fn centre_of_mass<D: Number>(particles: &Nodes<D>) -> Result<Vector3<D>> {
    let total = particles.total();
    let (mass, sum) = (total.re(), particles.points.iter().map(|(_, mass)| mass.re().abs()).sum::<f64>());
    // what is left of masses that cancel is rounding
    if !mass.is_finite() || mass.abs() <= sum * f64::EPSILON * particles.points.len() as f64 {
        return Err(Error::new(format!("the centre of mass is not defined, because the masses add up to {mass:e}"))
            .help("give masses whose sum is finite and not 0"));
    }
    Ok(Vector3::from_fn(|i, _| particles.integral(|r| r[i]) / total))
}

/// The eigenvalues of an inertia tensor, ascending, and its eigenvectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// λ₁ ≤ λ₂ ≤ λ₃.
    pub moments: [f64; 3],
    /// R: the rows are ê₁, ê₂, ê₃ in the axes of the tensor, so that R I Rᵀ is diagonal. Unit vectors, right-handed. Of
    /// ê₁ and ê₂ the component of the largest magnitude (the first of those within 10⁻⁹ of it) is positive; ê₃ = ê₁ ×
    /// ê₂. Where two moments are equal the axes in their plane are some two of many.
    pub axes: Matrix3<f64>,
}

/// Principal moments and axes of a symmetric tensor.
///
/// # Errors
/// When it is not finite, or not symmetric to 10⁻⁹ of its norm.
pub fn principal_axes(tensor: &Matrix3<f64>) -> Result<PrincipalAxes> {
    if tensor.iter().any(|entry| !entry.is_finite()) {
        return Err(Error::new("the inertia tensor has no principal axes, because it is not finite")
            .help("check the masses and the positions for infinite or undefined values"));
    }
    if (tensor - tensor.transpose()).norm() > 1e-9 * tensor.norm() {
        return Err(Error::new("the inertia tensor has no principal axes, because it is not symmetric")
            .help("check the products of inertia: I_ab must equal I_ba"));
    }
    let eigen = SymmetricEigen::new(*tensor);
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    let axis = |i: usize| {
        let vector: Vector3<f64> = eigen.eigenvectors.column(order[i]).into();
        let leading = vector.iter().copied().find(|component| component.abs() > vector.amax() - 1e-9);
        vector * leading.map_or(1.0, f64::signum)
    };
    // The iteration leaves the eigenvectors at right angles but for many roundings; these leave one.
    let first = axis(0).normalize();
    let second = axis(1);
    let second = (second - first * first.dot(&second)).normalize();
    let axes = Matrix3::from_rows(&[first, second, first.cross(&second)].map(|axis| axis.transpose()));
    Ok(PrincipalAxes { moments: order.map(|i| eigen.eigenvalues[i]), axes })
}
