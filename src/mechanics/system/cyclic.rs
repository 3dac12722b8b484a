//! Cyclic coordinates: L does not depend on them, so their momenta are conserved.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use super::traced_system::System;
use crate::scalar::RunningError;

impl System {
    /// Whether ∂L/∂qᵢ ≡ 0, so that pᵢ is conserved: because it is the constant 0 once traced, or else because it
    /// vanishes to rounding at 24 random states.
    pub fn is_cyclic(&self, i: usize) -> bool {
        self.cyclic.get(i).copied().unwrap_or(false)
    }

    /// Whether ∂L/∂qᵢ ≡ 0 is certain: the traced derivative is the constant 0.
    pub fn is_certainly_cyclic(&self, i: usize) -> bool {
        self.traced.certainly_cyclic.get(i).copied().unwrap_or(false)
    }

    pub(super) fn force_vanishes(&self, i: usize) -> bool {
        const STATES: usize = 24;
        let mut random = Pcg64Mcg::seed_from_u64(0x0c1c_11c0);
        let mut draw = |low: f64, high: f64| {
            let share = (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
            RunningError::new(low + (high - low) * share)
        };
        let mut seen = 0;
        for _ in 0..STATES {
            let time = draw(0.1, 2.0);
            let q: Vec<_> = self.coordinates().iter().map(|_| draw(0.2, 2.9)).collect();
            let v: Vec<_> = self.coordinates().iter().map(|_| draw(-1.5, 1.5)).collect();
            let parameters: Vec<_> = self.parameters().iter().map(|_| draw(0.3, 3.0)).collect();
            let force = self.quantities(time, &q, &v, &parameters).forces[i];
            if force.value.abs() > 64.0 * f64::EPSILON * force.magnitude {
                return false;
            }
            seen += usize::from(force.value.is_finite());
        }
        seen >= STATES / 3
    }
}
