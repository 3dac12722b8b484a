//! A relativistic particle on a line, bound by a spring: L is not quadratic in the velocity.

use crate::mechanics::{Lagrangian, State};
use crate::scalar::Number;

/// L = −m c² √(1 − ẋ²/c²) − ½ k x². Coordinate x; parameters m, c, k.
///
/// There is no potential energy in the sense of L = T − U: L + ½ k x² is not the kinetic energy.
pub struct RelativisticParticle;

impl Lagrangian<1, 3> for RelativisticParticle {
    fn name(&self) -> &str {
        "relativistic_particle"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["x"]
    }
    fn parameters(&self) -> [&str; 3] {
        ["m", "c", "k"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 3>) -> D {
        let ([x], [v], [mass, c, k]) = (at.q, at.v, at.parameters);
        let rest = mass * c * c;
        -rest * (-(v * v) / (c * c) + 1.0).sqrt() - k * x * x * 0.5
    }
}
