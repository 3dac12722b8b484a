//! The Euler–Lagrange equations d/dt ∂L/∂q̇ᵢ − ∂L/∂qᵢ = 0 of a Lagrangian, and the accelerations that solve them, by pairs of
//! hyper-dual directions. They run the Lagrangian itself: the library offers them, and tests compare the traced system with them.
//!
//! The direction of the motion, (ṫ, q̇, q̈) = (1, v, a), is one of the pair: then the mixed derivative of L with
//! respect to v̇ᵢ and along the motion *is* d/dt ∂L/∂q̇ᵢ, explicit time dependence included.

use nalgebra::DMatrix;
use num_dual::{Dual, HyperDual};

use super::linear_solver;
use super::{Lagrangian, State};
use crate::Result;
use crate::scalar::Number;

/// The residuals d/dt ∂L/∂q̇ᵢ − ∂L/∂qᵢ for given accelerations `a`: zero on shell, whatever `a` off shell.
pub fn residuals<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>, a: &[D; N]) -> [D; N]
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let force = forces(l, at);
    std::array::from_fn(|i| {
        let mut along = at.map(HyperDual::from_re);
        along.v[i] = along.v[i].derivative1();
        along.time.eps2 = D::one();
        along.q.iter_mut().zip(at.v).for_each(|(q, v)| q.eps2 = v);
        along.v.iter_mut().zip(a).for_each(|(v, &a)| v.eps2 = a);
        l.lagrangian(&along).eps1eps2 - force[i]
    })
}

/// The generalized forces ∂L/∂qᵢ.
pub fn forces<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> [D; N]
where
    L: Lagrangian<N, P>,
    D: Number,
{
    std::array::from_fn(|i| {
        let mut along = at.map(Dual::from_re);
        along.q[i] = along.q[i].derivative();
        l.lagrangian(&along).eps
    })
}

/// The mass matrix M_ij = ∂²L/∂q̇ᵢ∂q̇ⱼ (N × N, symmetric).
pub fn mass_matrix<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> DMatrix<D>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let mut matrix = DMatrix::zeros(N, N);
    for i in 0..N {
        for j in i..N {
            let mut along = at.map(HyperDual::from_re);
            along.v[i] = along.v[i].derivative1();
            along.v[j] = along.v[j].derivative2();
            matrix[(i, j)] = l.lagrangian(&along).eps1eps2;
            matrix[(j, i)] = matrix[(i, j)];
        }
    }
    matrix
}

/// The accelerations q̈ that solve the Euler–Lagrange equations: M q̈ = −(residual at q̈ = 0).
///
/// # Errors
/// When the mass matrix is singular or ill-conditioned; the message has the condition number.
pub fn accelerations<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> Result<[D; N]>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let right = residuals(l, at, &[D::zero(); N]).map(|h| -h).to_vec();
    let solution = linear_solver::solve("mass matrix", mass_matrix(l, at), right)?;
    Ok(std::array::from_fn(|i| solution[i]))
}
