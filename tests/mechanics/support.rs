//! States to evaluate at, and what it means to agree.

use onshell::mechanics::State;
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
