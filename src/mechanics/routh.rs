//! Routh's procedure: cyclic coordinates are traded for their constant momenta, what is left moves in an effective
//! potential. And the Hamiltonian, which is the same procedure applied to all coordinates.

use nalgebra::DMatrix;
use num_dual::Dual;

use super::World;
use super::legendre::invert;
use super::linear::{Elimination, solve_by};
use crate::scalar::Number;
use crate::{Error, Result};

impl World {
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
    /// As [`World::routhian`].
    pub fn effective_potential<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Result<D> {
        let p = self.quantities(time, q, v, parameters).momenta;
        self.routhian(time, q, &self.at_rest(), &p, parameters)
    }

    /// The same for numbers that have no size, where L is quadratic in the cyclic velocities.
    ///
    /// # Errors
    /// When it is not, or there are too many of them.
    pub fn effective_potential_exactly<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Result<D> {
        let cyclic = self.cyclic_coordinates();
        let rest: Vec<D> = self.at_rest();
        let wanted = self.quantities(time, q, v, parameters).momenta;
        let (momenta, mass) = self.momenta_and_mass(time, q, &rest, parameters);
        let mass = DMatrix::from_fn(cyclic.len(), cyclic.len(), |i, j| mass[(cyclic[i], cyclic[j])]);
        let missing = cyclic.iter().map(|&i| wanted[i] - momenta[i]).collect();
        let solved = solve_by(Elimination::Cramer, "mass matrix of the cyclic velocities", mass, missing)?;
        let mut at = rest;
        for (&i, &value) in cyclic.iter().zip(&solved) {
            at[i] = value;
        }
        // one step from rest is exact for a quadratic L, and for no other
        let (momenta, _) = self.momenta_and_mass(time, q, &at, parameters);
        if cyclic.iter().any(|&i| momenta[i] != wanted[i]) {
            return Err(Error::new("the momenta are not linear in the velocities"));
        }
        let pv: D = cyclic.iter().map(|&i| at[i] * wanted[i]).sum();
        Ok(pv - self.lagrangian(time, q, &at, parameters))
    }

    fn cyclic_coordinates(&self) -> Vec<usize> {
        (0..self.coordinates().len()).filter(|&i| self.is_cyclic(i)).collect()
    }

    /// The Hamiltonian H(q, p, t) = Σ pᵢ q̇ᵢ − L.
    ///
    /// # Errors
    /// When the mass matrix is singular, or no velocities have these momenta.
    pub fn hamiltonian<D: Number>(&self, time: D, q: &[D], p: &[D], parameters: &[D]) -> Result<D> {
        let all: Vec<usize> = (0..self.coordinates().len()).collect();
        self.transformed(&all, time, q, &self.at_rest(), p, parameters).map(|(value, _)| value)
    }

    /// The velocities that belong to momenta.
    ///
    /// # Errors
    /// As [`World::hamiltonian`].
    pub fn velocities<D: Number>(&self, time: D, q: &[D], p: &[D], parameters: &[D]) -> Result<Vec<D>> {
        let all: Vec<usize> = (0..self.coordinates().len()).collect();
        self.transformed(&all, time, q, &self.at_rest(), p, parameters).map(|(_, v)| v)
    }

    /// Hamilton's equations: (q̇, ṗ) = (∂H/∂p, −∂H/∂q), by differentiating the Hamiltonian.
    ///
    /// # Errors
    /// As [`World::hamiltonian`].
    pub fn hamilton<D: Number>(&self, time: D, q: &[D], p: &[D], parameters: &[D]) -> Result<(Vec<D>, Vec<D>)> {
        let lift = |x: &[D]| x.iter().copied().map(Dual::from_re).collect::<Vec<_>>();
        let (time, q, p, parameters) =
            (Dual::from_re(time), lift(&self.each_coordinate(q)), lift(&self.each_coordinate(p)), lift(parameters));
        let (mut q_rate, mut p_rate) = (Vec::new(), Vec::new());
        for i in 0..q.len() {
            let along = |x: &[Dual<D>]| {
                let mut x = x.to_vec();
                x[i] = x[i].derivative();
                x
            };
            q_rate.push(self.hamiltonian(time, &q, &along(&p), &parameters)?.eps);
            p_rate.push(-self.hamiltonian(time, &along(&q), &p, &parameters)?.eps);
        }
        Ok((q_rate, p_rate))
    }

    fn at_rest<D: Number>(&self) -> Vec<D> {
        vec![D::zero(); self.coordinates().len()]
    }

    /// Σ pᵢ q̇ᵢ − L over `over`, with the velocities there such that they have these momenta; and all velocities.
    fn transformed<D: Number>(
        &self,
        over: &[usize],
        time: D,
        q: &[D],
        v: &[D],
        p: &[D],
        parameters: &[D],
    ) -> Result<(D, Vec<D>)> {
        let (v, p) = (self.each_coordinate(v), self.each_coordinate(p));
        let with = |solved: &[D]| {
            let mut v = v.clone();
            for (&i, &value) in over.iter().zip(solved) {
                v[i] = value;
            }
            v
        };
        let what = if over.len() == v.len() { "mass matrix" } else { "mass matrix of the cyclic velocities" };
        let wanted: Vec<D> = over.iter().map(|&i| p[i]).collect();
        let start: Vec<D> = over.iter().map(|&i| v[i]).collect();
        let solved = invert(what, start, &wanted, |solved| {
            let (momenta, mass) = self.momenta_and_mass(time, q, &with(solved), parameters);
            let momenta = over.iter().map(|&i| momenta[i]).collect();
            Ok((momenta, DMatrix::from_fn(over.len(), over.len(), |i, j| mass[(over[i], over[j])])))
        })?;
        let pv: D = solved.iter().zip(&wanted).map(|(&v, &p)| p * v).sum();
        let v = with(&solved);
        Ok((pv - self.lagrangian(time, q, &v, parameters), v))
    }
}
