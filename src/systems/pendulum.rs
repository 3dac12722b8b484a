//! Plane pendulums: N point masses in a chain of light rods, from their positions (one: simple, two: double pendulum).

use crate::mechanics::{Lagrangian, Particle, State};
use crate::scalar::Number;

/// N equal masses m on rods of equal length l, gravity g; coordinates θ₁ … θ_N from the downward vertical (a single one
/// is just θ).
///
/// T = ½ m Σ (ẋ² + ẏ²) with the velocities by differentiating the positions, U = m g Σ y.
pub struct Pendulum<const N: usize> {
    name: String,
    coordinates: [String; N],
}

impl<const N: usize> Pendulum<N> {
    /// A chain of N links, named `simple_pendulum`, `double_pendulum` or `pendulum_N`.
    pub fn new() -> Self {
        let name = match N {
            1 => "simple_pendulum".to_owned(),
            2 => "double_pendulum".to_owned(),
            _ => format!("pendulum_{N}"),
        };
        let coordinate = |i: usize| match (N, i + 1) {
            (1, _) => "\\theta".to_owned(),
            (_, n @ 1..10) => format!("\\theta_{n}"),
            (_, n) => format!("\\theta_{{{n}}}"),
        };
        Pendulum { name, coordinates: std::array::from_fn(coordinate) }
    }
}

impl<const N: usize> Default for Pendulum<N> {
    fn default() -> Self {
        Pendulum::new()
    }
}

/// The places (x, y) of the masses, y upward.
fn places<D: Number, const N: usize>(at: &State<D, N, 3>) -> [(D, D); N] {
    let [_, length, _] = at.parameters;
    let (mut x, mut y) = (D::zero(), D::zero());
    at.q.map(|angle| {
        let (sine, cosine) = angle.sin_cos();
        x += length * sine;
        y -= length * cosine;
        (x, y)
    })
}

impl<const N: usize> Lagrangian<N, 3> for Pendulum<N> {
    fn name(&self) -> &str {
        &self.name
    }
    fn coordinates(&self) -> [&str; N] {
        self.coordinates.each_ref().map(String::as_str)
    }
    fn parameters(&self) -> [&str; 3] {
        ["m", "l", "g"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, N, 3>) -> D {
        let [mass, _, g] = at.parameters;
        places(&at.moving()).iter().fold(D::zero(), |l, (x, y)| {
            let kinetic = mass * (x.eps * x.eps + y.eps * y.eps) * 0.5;
            l + kinetic - mass * g * y.re
        })
    }
    fn potential_energy<D: Number>(&self, at: &State<D, N, 3>) -> Option<D> {
        let [mass, _, g] = at.parameters;
        Some(places(at).iter().fold(D::zero(), |u, &(_, y)| u + mass * g * y))
    }
    fn particles<D: Number>(&self, at: &State<D, N, 3>) -> Vec<Particle<D>> {
        let [mass, _, _] = at.parameters;
        places(at).iter().map(|&(x, y)| Particle { mass, place: [x, y, D::zero()] }).collect()
    }
}
