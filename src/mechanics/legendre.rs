//! The Legendre transform: from L(q, q̇) to the Hamiltonian H(q, p) = Σ pᵢ q̇ᵢ − L and back, and Hamilton's equations.
//!
//! The velocities that belong to given momenta are found by Newton's method on ∂L/∂q̇ = p. Where L is quadratic in the
//! velocities, one step is exact. Derivatives come through, since the steps are taken over the number at hand.

use nalgebra::DMatrix;
use num_dual::{Dual, HyperDual};

use super::euler_lagrange::mass_matrix;
use super::momenta::momenta;
use super::newton::invert;
use super::{Lagrangian, State};
use crate::Result;
use crate::scalar::Number;

/// A point of phase space: time, coordinates q, momenta p, parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhasePoint<D, const N: usize, const P: usize> {
    /// The time t.
    pub time: D,
    /// The coordinates q.
    pub q: [D; N],
    /// The generalized momenta p.
    pub p: [D; N],
    /// The parameters, in the order of [`Lagrangian::parameters`].
    pub parameters: [D; P],
}

impl<D: Number, const N: usize, const P: usize> PhasePoint<D, N, P> {
    /// The same point over another number.
    pub fn map<E: Number>(&self, lift: impl Fn(D) -> E) -> PhasePoint<E, N, P> {
        PhasePoint {
            time: lift(self.time),
            q: self.q.map(&lift),
            p: self.p.map(&lift),
            parameters: self.parameters.map(&lift),
        }
    }

    fn moving_with(&self, v: [D; N]) -> State<D, N, P> {
        State { time: self.time, q: self.q, v, parameters: self.parameters }
    }
}

/// The velocities with ∂L/∂q̇ = p.
///
/// # Errors
/// When the mass matrix is singular, or no velocities are found.
pub fn velocities<L, D, const N: usize, const P: usize>(l: &L, at: &PhasePoint<D, N, P>) -> Result<[D; N]>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let v = invert("mass matrix", vec![D::zero(); N], &at.p, |v| {
        let state = at.moving_with(std::array::from_fn(|i| v[i]));
        Ok((momenta(l, &state).to_vec(), mass_matrix(l, &state)))
    })?;
    Ok(std::array::from_fn(|i| v[i]))
}

/// The Hamiltonian H(q, p, t) = Σ pᵢ q̇ᵢ − L.
///
/// # Errors
/// As [`velocities`].
pub fn hamiltonian<L, D, const N: usize, const P: usize>(l: &L, at: &PhasePoint<D, N, P>) -> Result<D>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let v = velocities(l, at)?;
    let pv: D = at.p.iter().zip(&v).map(|(&p, &v)| p * v).sum();
    Ok(pv - l.lagrangian(&at.moving_with(v)))
}

/// Hamilton's equations: (q̇, ṗ) = (∂H/∂p, −∂H/∂q), by differentiating the Hamiltonian.
///
/// # Errors
/// As [`velocities`].
pub fn hamilton_equations<L, D, const N: usize, const P: usize>(
    l: &L,
    at: &PhasePoint<D, N, P>,
) -> Result<([D; N], [D; N])>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let (mut q_rate, mut p_rate) = ([D::zero(); N], [D::zero(); N]);
    for i in 0..N {
        let mut along = at.map(Dual::from_re);
        along.p[i] = along.p[i].derivative();
        q_rate[i] = hamiltonian(l, &along)?.eps;
        let mut along = at.map(Dual::from_re);
        along.q[i] = along.q[i].derivative();
        p_rate[i] = -hamiltonian(l, &along)?.eps;
    }
    Ok((q_rate, p_rate))
}

/// The transform once more, from H back: Σ pᵢ q̇ᵢ − H at the momenta with ∂H/∂p = q̇. It gives L again: the Legendre
/// transform is an involution.
///
/// # Errors
/// As [`velocities`].
pub fn lagrangian_from_hamiltonian<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> Result<D>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let phase = |p: &[D]| PhasePoint {
        time: at.time,
        q: at.q,
        p: std::array::from_fn::<D, N, _>(|i| p[i]),
        parameters: at.parameters,
    };
    let p = invert("Hessian of H in the momenta", vec![D::zero(); N], &at.v, |p| {
        let (mut gradient, mut hessian) = (vec![D::zero(); N], DMatrix::zeros(N, N));
        for i in 0..N {
            for j in i..N {
                let mut along = phase(p).map(HyperDual::from_re);
                along.p[i] = along.p[i].derivative1();
                along.p[j] = along.p[j].derivative2();
                let h = hamiltonian(l, &along)?;
                gradient[i] = h.eps1;
                (hessian[(i, j)], hessian[(j, i)]) = (h.eps1eps2, h.eps1eps2);
            }
        }
        Ok((gradient, hessian))
    })?;
    let pv: D = p.iter().zip(&at.v).map(|(&p, &v)| p * v).sum();
    Ok(pv - hamiltonian(l, &phase(&p))?)
}
