//! A Lagrangian with any number of coordinates and parameters, behind one object-safe trait.

use super::traced_system::System;
use crate::Result;
use crate::mechanics::{Lagrangian, Particle, State};
use crate::scalar::Symbol;

/// What a system consists of, as symbols.
#[derive(Clone, Debug, Default)]
pub struct Parts {
    /// Its point masses.
    pub particles: Vec<Particle<Symbol>>,
    /// The principal moments of its rigid body.
    pub moments: Option<[Symbol; 3]>,
}

/// A mechanical system by name, whatever its number of coordinates. Any [`Lagrangian`] becomes one with [`erased`].
pub trait AnyLagrangian: Send + Sync {
    /// The name that claims files use.
    fn name(&self) -> &str;
    /// The coordinates as LaTeX spells them.
    fn coordinates(&self) -> Vec<String>;
    /// The parameters as LaTeX spells them.
    fn parameters(&self) -> Vec<String>;
    /// Everything that follows from it.
    ///
    /// # Errors
    /// When the Lagrangian branches on a value, so that it cannot be traced.
    fn trace(&self) -> Result<System>;
    /// What it consists of, at symbols for the time, the coordinates, the velocities and the parameters. A missing
    /// symbol counts as NaN.
    fn parts(&self, time: Symbol, q: &[Symbol], v: &[Symbol], parameters: &[Symbol]) -> Parts;
}

/// A Lagrangian as an [`AnyLagrangian`].
pub fn erased<L: Lagrangian<N, P>, const N: usize, const P: usize>(lagrangian: L) -> impl AnyLagrangian + 'static {
    Erased(lagrangian)
}

struct Erased<L, const N: usize, const P: usize>(L);

impl<L: Lagrangian<N, P>, const N: usize, const P: usize> AnyLagrangian for Erased<L, N, P> {
    fn name(&self) -> &str {
        self.0.name()
    }
    fn coordinates(&self) -> Vec<String> {
        self.0.coordinates().map(str::to_owned).into()
    }
    fn parameters(&self) -> Vec<String> {
        self.0.parameters().map(str::to_owned).into()
    }
    fn trace(&self) -> Result<System> {
        System::new(&self.0)
    }
    fn parts(&self, time: Symbol, q: &[Symbol], v: &[Symbol], parameters: &[Symbol]) -> Parts {
        fn exactly<const K: usize>(x: &[Symbol]) -> [Symbol; K] {
            std::array::from_fn(|i| x.get(i).copied().unwrap_or(Symbol::from(f64::NAN)))
        }
        let at = State { time, q: exactly(q), v: exactly(v), parameters: exactly(parameters) };
        Parts { particles: self.0.particles(&at), moments: self.0.principal_moments(&at) }
    }
}
