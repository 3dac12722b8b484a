//! Mechanical systems, each a Lagrangian in its own file, and the registry that finds them by name.
//!
//! A claims file's `"system"` is looked up in a [`Registry`]. No file here contains a closed form that is checked
//! elsewhere: a rigid body starts from its rotation matrix. Units are the caller's, used consistently; angles are in
//! radians.
//!
//! This folder imports `mechanics` and `scalar`.
//!
//! Offers [`Registry`] and each system.
//!
//! # Why a system contains no closed form
//!
//! Otherwise a check would compare a formula with its copy. The top starts from R = R_z(ψ) R_y(θ) R_z(φ). ω follows
//! from R by differentiation, T = ½ Σ λ_a ω_a², and U from the height of the center of mass. So (5.68) to (5.70)
//! and (6.71) of the lecture are theorems about it.

use crate::mechanics::{AnyLagrangian, Lagrangian, erased};

mod damped_oscillator;
mod free_rigid_body;
mod heavy_top;
mod kepler;
mod pendulum;
mod relativistic_particle;

pub use damped_oscillator::DampedOscillator;
pub use free_rigid_body::FreeRigidBody;
pub use heavy_top::HeavyTop;
pub use kepler::Kepler;
pub use pendulum::Pendulum;
pub use relativistic_particle::RelativisticParticle;

/// The systems that claims may name. Start from [`Registry::standard`] and add your own.
pub struct Registry {
    systems: Vec<Box<dyn AnyLagrangian>>,
}

impl Registry {
    /// No systems at all.
    pub fn empty() -> Self {
        Registry { systems: Vec::new() }
    }

    /// The systems of this crate.
    pub fn standard() -> Self {
        let mut registry = Registry::empty();
        registry.add(HeavyTop).add(FreeRigidBody).add(Pendulum::<1>::new()).add(Pendulum::<2>::new());
        registry.add(Kepler).add(DampedOscillator).add(RelativisticParticle);
        registry
    }

    /// Adds a Lagrangian; it takes the place of one that has the same name.
    pub fn add<L: Lagrangian<N, P>, const N: usize, const P: usize>(&mut self, lagrangian: L) -> &mut Self {
        self.systems.retain(|system| system.name() != lagrangian.name());
        self.systems.push(Box::new(erased(lagrangian)));
        self
    }

    /// The system of that name.
    pub fn get(&self, name: &str) -> Option<&dyn AnyLagrangian> {
        self.systems.iter().find(|system| system.name() == name).map(Box::as_ref)
    }

    /// All names, in the order in which they were added.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.systems.iter().map(|system| system.name())
    }
}

impl Default for Registry {
    fn default() -> Self {
        Registry::standard()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_system_can_be_traced() {
        let registry = Registry::standard();
        assert_eq!(registry.names().count(), 7);
        for name in registry.names() {
            let system = registry.get(name).map(AnyLagrangian::trace).unwrap().unwrap();
            assert_eq!(system.name(), name);
        }
        assert!(registry.get("heavy_tpo").is_none());
    }

    #[test]
    fn a_system_of_the_same_name_takes_the_place() {
        let mut registry = Registry::standard();
        let before = registry.names().count();
        registry.add(HeavyTop);
        assert_eq!(registry.names().count(), before);
    }
}
