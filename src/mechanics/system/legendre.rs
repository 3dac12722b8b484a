//! The Legendre transform of a traced system, in all velocities or in some of them: the Hamiltonian and Hamilton's
//! equations.

use nalgebra::DMatrix;
use num_dual::Dual;

use super::traced_system::System;
use crate::Result;
use crate::mechanics::newton::invert;
use crate::scalar::{Number, each};

impl System {
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
    /// As [`System::hamiltonian`].
    pub fn velocities<D: Number>(&self, time: D, q: &[D], p: &[D], parameters: &[D]) -> Result<Vec<D>> {
        let all: Vec<usize> = (0..self.coordinates().len()).collect();
        self.transformed(&all, time, q, &self.at_rest(), p, parameters).map(|(_, v)| v)
    }

    /// Hamilton's equations: (q̇, ṗ) = (∂H/∂p, −∂H/∂q), by differentiating the Hamiltonian.
    ///
    /// # Errors
    /// As [`System::hamiltonian`].
    pub fn hamilton_equations<D: Number>(
        &self,
        time: D,
        q: &[D],
        p: &[D],
        parameters: &[D],
    ) -> Result<(Vec<D>, Vec<D>)> {
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

    pub(super) fn at_rest<D: Number>(&self) -> Vec<D> {
        vec![D::zero(); self.coordinates().len()]
    }

    /// Σ pᵢ q̇ᵢ − L over `over`, with the velocities there such that they have these momenta; and all velocities.
    pub(super) fn transformed<D: Number>(
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
        let wanted = each(over, &|&i| p[i]);
        let start = each(over, &|&i| v[i]);
        let solved = invert(what, start, &wanted, |solved| {
            let (momenta, mass) = self.momenta_and_mass(time, q, &with(solved), parameters);
            let momenta = each(over, &|&i| momenta[i]);
            Ok((momenta, DMatrix::from_fn(over.len(), over.len(), |i, j| mass[(over[i], over[j])])))
        })?;
        let mut pv = D::zero();
        for (&v, &p) in solved.iter().zip(&wanted) {
            pv += p * v;
        }
        let v = with(&solved);
        Ok((pv - self.lagrangian(time, q, &v, parameters), v))
    }
}
