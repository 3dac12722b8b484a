//! Natural systems (Arnold, §19): L = T − V, with T quadratic in the velocities and V a function of the coordinates. Their energy
//! T + V is the one quantity that authors mean by that word.
//!
//! In a turning frame a part of T has no velocities, as ½mr²Ω² of a bead on a hoop that is driven. Then T + V is another quantity than
//! Σ pᵢ q̇ᵢ − L, and the Lagrangian alone does not say which of them is meant.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use super::traced_system::System;
use crate::scalar::RunningError;

/// The states at which a system is tested.
const STATES: usize = 24;

impl System {
    /// Whether L = T − V with T quadratic in the velocities, and no part of V may be one of T that has no velocities: one that is
    /// negative and goes with the square of a parameter. Tested to rounding at 24 random states.
    pub fn is_natural(&self) -> bool {
        if self.depends_on_time() || !self.multipliers().is_empty() {
            return false;
        }
        let mut random = Pcg64Mcg::seed_from_u64(0x6e61_7475);
        let mut draw = |low: f64, high: f64| {
            let share = (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
            RunningError::new(low + (high - low) * share)
        };
        let mut seen = 0;
        for _ in 0..STATES {
            let q: Vec<_> = self.coordinates().iter().map(|_| draw(0.2, 2.9)).collect();
            let v: Vec<_> = self.coordinates().iter().map(|_| draw(-1.5, 1.5)).collect();
            let parameters: Vec<_> = self.parameters().iter().map(|_| draw(0.3, 3.0)).collect();
            let times = |factor: f64| v.iter().map(|v| *v * RunningError::new(factor)).collect::<Vec<_>>();
            let at = |v: &[RunningError], parameters: &[RunningError]| {
                self.lagrangian(RunningError::new(0.0), &q, v, parameters)
            };
            let rest = at(&times(0.0), &parameters);
            let kinetic = |factor: f64| at(&times(factor), &parameters) - rest;
            let (once, back, twice) = (kinetic(1.0), kinetic(-1.0), kinetic(2.0));
            if differ(once, back) || differ(twice, once * RunningError::new(4.0)) {
                return false;
            }
            for changed in 0..parameters.len() {
                let with = |factor: f64| {
                    let mut all = parameters.clone();
                    all[changed] *= RunningError::new(factor);
                    at(&times(0.0), &all)
                };
                let (flipped, doubled) = (with(-1.0), with(2.0));
                if !differ(flipped, rest) && differ(doubled, rest) && doubled.value > rest.value {
                    return false;
                }
            }
            seen += usize::from(once.value.is_finite());
        }
        seen >= STATES / 3
    }
}

/// Whether two numbers differ by more than rounding.
fn differ(a: RunningError, b: RunningError) -> bool {
    let difference = a - b;
    difference.value.abs() > 64.0 * f64::EPSILON * difference.magnitude
}
