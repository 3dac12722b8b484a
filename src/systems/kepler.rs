//! A planet in the field of a fixed sun, in polar coordinates.

use num_dual::DualNum;

use crate::mechanics::{Lagrangian, Particle, State};
use crate::scalar::Number;

/// Coordinates r, φ; parameters m (planet), M (sun), G: U = −G M m / r.
pub struct Kepler;

impl Lagrangian<2, 3> for Kepler {
    fn name(&self) -> &str {
        "kepler"
    }
    fn coordinates(&self) -> [&str; 2] {
        ["r", "\\phi"]
    }
    fn parameters(&self) -> [&str; 3] {
        ["m", "M", "G"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 2, 3>) -> D {
        let moving = at.moving();
        let [r, phi] = moving.q;
        let (x, y) = (r * phi.cos(), r * phi.sin());
        let [mass, sun, gravity] = at.parameters;
        mass * (x.eps * x.eps + y.eps * y.eps) * 0.5 + gravity * sun * mass / at.q[0]
    }
    fn potential_energy<D: Number>(&self, at: &State<D, 2, 3>) -> Option<D> {
        let [mass, sun, gravity] = at.parameters;
        Some(-gravity * sun * mass / at.q[0])
    }
    fn particles<D: Number>(&self, at: &State<D, 2, 3>) -> Vec<Particle<D>> {
        let ([r, phi], [mass, _, _]) = (at.q, at.parameters);
        vec![Particle { mass, place: [r * phi.cos(), r * phi.sin(), D::zero()] }]
    }
}
