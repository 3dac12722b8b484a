//! Generalized momenta pᵢ = ∂L/∂q̇ᵢ and the energy Σ pᵢ q̇ᵢ − L.

use num_dual::Dual;

use super::{Lagrangian, State};
use crate::scalar::Number;

/// The generalized momenta pᵢ = ∂L/∂q̇ᵢ.
pub fn momenta<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> [D; N]
where
    L: Lagrangian<N, P>,
    D: Number,
{
    std::array::from_fn(|i| {
        let mut along = at.map(Dual::from_re);
        along.v[i] = along.v[i].derivative();
        l.lagrangian(&along).eps
    })
}

/// The energy (Jacobi's integral) Σ pᵢ q̇ᵢ − L; T + U when L = T − U with T quadratic in the velocities.
pub fn energy<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>) -> D
where
    L: Lagrangian<N, P>,
    D: Number,
{
    // one direction is enough: Σ pᵢ q̇ᵢ is the derivative of L as all velocities grow in proportion
    let mut along = at.map(Dual::from_re);
    for (v, rate) in along.v.iter_mut().zip(at.v) {
        v.eps = rate;
    }
    let l = l.lagrangian(&along);
    l.eps - l.re
}
