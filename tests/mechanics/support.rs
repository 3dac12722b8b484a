//! States to evaluate at, and what it means to agree.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use num_dual::{Dual2SVec64, hessian};
use onshell::mechanics::{Lagrangian, State};
use proptest::prelude::*;

pub fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Coordinates away from 0 and π, velocities of both signs, positive parameters.
pub fn state<const N: usize, const P: usize>() -> impl Strategy<Value = State<f64, N, P>> {
    let (q, v) = (prop::collection::vec(0.3..2.8, N), prop::collection::vec(-2.0..2.0, N));
    let parameters = prop::collection::vec(0.5..2.0, P);
    (0.1..1.0, q, v, parameters).prop_map(|(time, q, v, parameters)| State {
        time,
        q: std::array::from_fn(|i| q[i]),
        v: std::array::from_fn(|i| v[i]),
        parameters: std::array::from_fn(|i| parameters[i]),
    })
}

/// One fixed state, for the twins.
pub fn some_state<const N: usize, const P: usize>() -> State<f64, N, P> {
    State {
        time: 0.4,
        q: std::array::from_fn(|i| 0.7 + 0.31 * i as f64),
        v: std::array::from_fn(|i| 0.9 - 0.67 * i as f64),
        parameters: std::array::from_fn(|i| 1.3 - 0.17 * i as f64),
    }
}

/// Slower than light: c is the second parameter.
pub fn slow(mut at: State<f64, 1, 3>) -> State<f64, 1, 3> {
    at.parameters[1] += 2.5;
    at
}

pub fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, x| x.abs().max(m))
}

pub fn agree(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let scale = largest(a).max(largest(b)).max(1e-3);
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance * scale)
}

/// Accelerations from num-dual's Hessian of L in the X = 1 + 2N variables time, coordinates and velocities.
pub fn by_hessian<L: Lagrangian<N, P>, const N: usize, const P: usize, const X: usize>(
    l: &L,
    at: &State<f64, N, P>,
) -> Vec<f64> {
    let x = SVector::<f64, X>::from_iterator([at.time].into_iter().chain(at.q).chain(at.v));
    let lagrangian = |x: SVector<Dual2SVec64<X>, X>| {
        l.lagrangian(&State {
            time: x[0],
            q: std::array::from_fn(|i| x[1 + i]),
            v: std::array::from_fn(|i| x[1 + N + i]),
            parameters: at.parameters.map(Into::into),
        })
    };
    let (_, gradient, second) = hessian(lagrangian, &x);
    let mass: SMatrix<f64, N, N> = second.fixed_view::<N, N>(1 + N, 1 + N).into();
    let mixed: SMatrix<f64, N, N> = second.fixed_view::<N, N>(1 + N, 1).into();
    let explicit: SVector<f64, N> = second.fixed_view::<N, 1>(1 + N, 0).into();
    let right: SVector<f64, N> = gradient.fixed_rows::<N>(1) - mixed * SVector::from(at.v) - explicit;
    let mass = DMatrix::from_fn(N, N, |i, j| mass[(i, j)]);
    mass.lu().solve(&DVector::from_fn(N, |i, _| right[i])).unwrap().as_slice().to_vec()
}
