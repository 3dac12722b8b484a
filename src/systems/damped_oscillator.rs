//! The damped oscillator as a Lagrangian system: its L depends on the time (Caldirola and Kanai).

use crate::mechanics::{Lagrangian, State};
use crate::scalar::Number;

/// L = e^{γt} (½ m ẋ² − ½ k x²). Coordinate x; parameters m, k, γ.
pub struct DampedOscillator;

impl Lagrangian<1, 3> for DampedOscillator {
    fn name(&self) -> &str {
        "damped_oscillator"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["x"]
    }
    fn parameters(&self) -> [&str; 3] {
        ["m", "k", "\\gamma"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 3>) -> D {
        let ([x], [v], [mass, k, gamma]) = (at.q, at.v, at.parameters);
        (gamma * at.time).exp() * (mass * v * v - k * x * x) * 0.5
    }
}
