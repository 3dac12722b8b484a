//! Routh's reduction: the Routhian of the cyclic coordinates, and the effective potential of the others.

use nalgebra::DMatrix;

use super::traced_system::System;
use crate::mechanics::linear_solver::{LinearSolver, solve_with};
use crate::scalar::{Number, each};
use crate::{Error, Result};

impl System {
    /// The Routhian Σ p_c q̇_c − L over the cyclic coordinates c, as a function of their momenta: `p` counts at the
    /// cyclic places only, `v` at the others only. With this sign it is −(T − U_eff) for what is left.
    ///
    /// # Errors
    /// When the mass matrix of the cyclic velocities is singular, or no velocities have these momenta.
    pub fn routhian<D: Number>(&self, time: D, q: &[D], v: &[D], p: &[D], parameters: &[D]) -> Result<D> {
        self.transformed(&self.cyclic_coordinates(), time, q, v, p, parameters).map(|(value, _)| value)
    }

    /// The effective potential: the Routhian with the non-cyclic coordinates at rest, and the cyclic momenta those of
    /// the given state. Equally, the energy of that state of rest.
    ///
    /// # Errors
    /// As [`System::routhian`].
    pub fn effective_potential<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Result<D> {
        let p = self.quantities(time, q, v, parameters).momenta;
        self.routhian(time, q, &self.at_rest(), &p, parameters)
    }

    /// The same for numbers that have no size, where L is quadratic in the cyclic velocities.
    ///
    /// # Errors
    /// When it is not, or there are too many of them.
    pub fn effective_potential_exact<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Result<D> {
        let cyclic = self.cyclic_coordinates();
        let rest: Vec<D> = self.at_rest();
        let wanted = self.quantities(time, q, v, parameters).momenta;
        let (momenta, mass) = self.momenta_and_mass(time, q, &rest, parameters);
        let mass = DMatrix::from_fn(cyclic.len(), cyclic.len(), |i, j| mass[(cyclic[i], cyclic[j])]);
        let missing = each(&cyclic, &|&i| wanted[i] - momenta[i]);
        let solved = solve_with(LinearSolver::CramersRule, "mass matrix of the cyclic velocities", mass, missing)?;
        let mut at = rest;
        for (&i, &value) in cyclic.iter().zip(&solved) {
            at[i] = value;
        }
        // one step from rest is exact for a quadratic L, and for no other
        let (momenta, _) = self.momenta_and_mass(time, q, &at, parameters);
        if cyclic.iter().any(|&i| momenta[i] != wanted[i]) {
            return Err(Error::new(
                "the effective potential has no exact form, because the momenta are not linear in the velocities",
            )
            .help("call effective_potential, which solves for the velocities numerically"));
        }
        let mut pv = D::zero();
        for &i in &cyclic {
            pv += at[i] * wanted[i];
        }
        Ok(pv - self.lagrangian(time, q, &at, parameters))
    }

    fn cyclic_coordinates(&self) -> Vec<usize> {
        (0..self.coordinates().len()).filter(|&i| self.is_cyclic(i)).collect()
    }
}
