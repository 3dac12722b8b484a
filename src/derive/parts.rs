//! The steps between the parts of a system and its equations of motion, as formulas: places and velocities, the angular
//! velocity, T and U, ∂L/∂q, the rate of ∂L/∂q̇, and steady precession.

use std::collections::BTreeMap;

use num_traits::One;

use super::algebra::Fraction;
use super::names::symbol;
use super::polynomial::{Monomial, Polynomial};
use super::quantities::{Derivation, Work};
use super::rational::Exact;
use crate::Result;
use crate::formula::Expr;
use crate::latex::typeset;
use crate::scalar::Symbol;

/// A point mass. A component that is 0 at all times is `None`.
pub struct ParticleFormulas {
    /// Its mass.
    pub mass: Expr,
    /// x, y, z.
    pub place: [Option<Expr>; 3],
    /// Their rates, for the same components.
    pub velocity: [Expr; 3],
}

/// A rigid body.
pub struct BodyFormulas {
    /// The axes of the body, each with its three space components.
    pub axes: [[Expr; 3]; 3],
    /// ω in space components.
    pub space: [Expr; 3],
    /// ω along the axes of the body.
    pub along: [Expr; 3],
    /// The principal moments.
    pub moments: Option<[Expr; 3]>,
}

/// Steady motion in a coordinate θ while a cyclic coordinate φ turns at the rate Ω: the equation of motion of θ with θ
/// at rest is a quadratic a Ω² + b Ω + c = 0, in which another cyclic coordinate ψ is replaced by its momentum.
pub struct Precession {
    /// The coordinate at rest.
    pub rest: usize,
    /// The coordinate that turns.
    pub turns: usize,
    /// The coordinate whose momentum is given.
    pub spins: usize,
    /// The left side, with common factors divided out; Ω is the rate of the coordinate that turns.
    pub quadratic: [Expr; 3],
    /// −b, b² − 4 a c and 2 a.
    pub root: [Expr; 3],
    /// −b / a and −c / b: the two rates where b is large.
    pub far: [Expr; 2],
}

impl Derivation {
    /// A formula as LaTeX that onshell reads.
    pub fn typeset(&self, formula: &Expr) -> String {
        typeset(formula, self.symbols())
    }

    /// The point masses.
    ///
    /// # Errors
    /// When a formula cannot be typeset.
    pub fn particles(&self) -> Result<Vec<ParticleFormulas>> {
        let mut found = Vec::new();
        for (mass, place, velocity) in &self.recorded.particles {
            let place = self.several(*place)?;
            let there = |expr: Expr| (!is_zero(&expr)).then_some(expr);
            found.push(ParticleFormulas {
                mass: self.one(*mass)?,
                place: place.map(there),
                velocity: self.several(*velocity)?,
            });
        }
        Ok(found)
    }

    /// The rigid body.
    ///
    /// # Errors
    /// When a formula cannot be typeset.
    pub fn body(&self) -> Result<Option<BodyFormulas>> {
        let Some(body) = &self.recorded.body else { return Ok(None) };
        let [one, two, three] = body.axes;
        Ok(Some(BodyFormulas {
            axes: [self.several(one)?, self.several(two)?, self.several(three)?],
            space: self.several(body.space)?,
            along: self.several(body.along)?,
            moments: body.moments.map(|moments| self.several(moments)).transpose()?,
        }))
    }

    /// T and U, where L = T − U.
    ///
    /// # Errors
    /// When a formula cannot be typeset.
    pub fn energies(&self) -> Result<Option<[Expr; 2]>> {
        let Some([kinetic, potential]) = self.recorded.energies else { return Ok(None) };
        Ok(Some([self.one(kinetic)?, self.one(potential)?]))
    }

    /// ∂L/∂qᵢ.
    ///
    /// # Errors
    /// When it cannot be typeset.
    pub fn force(&self, i: usize) -> Result<Expr> {
        self.one(self.recorded.forces[i])
    }

    /// d/dt ∂L/∂q̇ᵢ, with accelerations.
    ///
    /// # Errors
    /// When it cannot be typeset.
    pub fn momentum_rate(&self, i: usize) -> Result<Expr> {
        self.one(self.recorded.momentum_rates[i])
    }

    /// What acts on the i-th coordinate beside L, d/dt ∂L/∂q̇ᵢ − ∂L/∂qᵢ; `None` where it is 0.
    ///
    /// # Errors
    /// When it cannot be typeset.
    pub fn applied_force(&self, i: usize) -> Result<Option<Expr>> {
        let mut work = Work::new(self);
        let recorded = &self.recorded;
        let parts = work.normal(&[recorded.momentum_rates[i], recorded.forces[i], recorded.residuals[i]])?;
        let beside = work.algebra.plus(&parts[0], &parts[1], -Exact::one())?;
        let beside = work.algebra.plus(&beside, &parts[2], -Exact::one())?;
        let beside = work.algebra.presented(&beside)?;
        let printed = work.printed(&[beside])?;
        Ok(Some(printed).filter(|force| !force.is_null()))
    }

    /// The steady motion of a system of three coordinates, two of them cyclic, where there is one.
    ///
    /// # Errors
    /// When a formula cannot be typeset.
    pub fn precession(&self, rest: usize, turns: usize, spins: usize) -> Result<Option<Precession>> {
        let mut work = Work::new(self);
        let inputs = self.names.inputs();
        let (velocities, accelerations) = (work.places(&inputs.velocities()), work.places(&inputs.accelerations()));
        let momentum = work.places(&inputs.momenta())[spins];
        let still: Vec<u32> = accelerations.iter().copied().chain([velocities[rest]]).collect();
        let at_rest: BTreeMap<u32, Fraction> = still.iter().map(|&place| (place, Fraction::default())).collect();
        // p = m ψ̇ + b gives ψ̇
        let canonical = work.normal(&[self.recorded.momenta[spins], self.recorded.mass[spins][spins]])?;
        let none: BTreeMap<u32, Fraction> = [(velocities[spins], Fraction::default())].into();
        let offset = work.algebra.substitute(&canonical[0], &none)?;
        let numerator = work.algebra.plus(&Polynomial::atom(momentum).into(), &offset, -Exact::one())?;
        let inverse = work.algebra.reciprocal(&canonical[1])?;
        let spin = work.algebra.times(&numerator, &inverse)?;
        let mut values = at_rest;
        values.insert(velocities[spins], spin);
        let residual = work.normal(&[self.recorded.residuals[rest]])?.remove(0);
        let steady = work.algebra.substitute(&residual, &values)?;
        let steady = work.algebra.presented(&steady)?;
        if !steady.under.is_empty() || steady.top.is_zero() {
            return Ok(None);
        }
        let quadratic = steady.top.primitive()?;
        let unwanted = work.places(&[inputs.coordinates(), inputs.velocities()].concat());
        let powers = quadratic.powers(velocities[turns])?;
        let (lowest, highest) = quadratic.exponents(velocities[turns]);
        let of = |exponent: i32| powers.get(&exponent).cloned().unwrap_or_default();
        let parts = [of(2), of(1), of(0)];
        let is_plain = parts.iter().all(|part| unwanted.iter().all(|&atom| part.exponents(atom) == (0, 0)));
        if (lowest, highest) != (0, 2) || !is_plain || parts.iter().any(Polynomial::is_zero) {
            return Ok(None);
        }
        // the constant term is printed with a plus, as books do
        let flip = if super::algebra::is_negative(&parts[2]) { -Exact::one() } else { Exact::one() };
        let of = |k: usize| parts[k].scaled(&Monomial::default(), flip);
        let [a, b, c] = [of(0)?, of(1)?, of(2)?];
        let rate = Monomial::atom(velocities[turns], 1);
        let terms = [a.scaled(&rate.power(2), Exact::one())?, b.scaled(&rate, Exact::one())?, c.clone()];
        let four = Exact::from_integer(4);
        let opposite = Polynomial::default().minus(&b)?;
        let discriminant = b.times(&b)?.plus(&a.times(&c)?, -four)?;
        let twice = a.plus(&a, Exact::one())?;
        let over_a = work.algebra.reciprocal(&a.into())?;
        let fast = work.algebra.times(&opposite.clone().into(), &over_a)?;
        let over_b = work.algebra.reciprocal(&opposite.clone().into())?;
        let slow = work.algebra.times(&c.into(), &over_b)?;
        let printed = |value: Polynomial| work.printed(&[value.into()]);
        let [square, linear, constant] = terms;
        Ok(Some(Precession {
            rest,
            turns,
            spins,
            quadratic: [printed(square)?, printed(linear)?, printed(constant)?],
            root: [printed(opposite)?, printed(discriminant)?, printed(twice)?],
            far: [work.printed(&[fast])?, work.printed(&[slow])?],
        }))
    }

    /// The energy with some coordinates at rest, as a function of the momenta of the others: the effective potential of
    /// those at rest.
    ///
    /// # Errors
    /// When L is not quadratic in the velocities, or the formula cannot be typeset.
    pub fn effective_potential(&self, turning: &[usize]) -> Result<Expr> {
        let mut work = Work::new(self);
        // the same errors as for H
        work.hamiltonian()?;
        let places = work.places(&self.names.inputs().momenta());
        let at_rest = work.normal(&self.recorded.at_rest.momenta)?;
        let (mut mass, mut momenta) = (Vec::new(), Vec::new());
        for &i in turning {
            let row: Vec<Symbol> = turning.iter().map(|&j| self.recorded.mass[i][j]).collect();
            mass.push(work.normal(&row)?);
            momenta.push(work.algebra.plus(&Polynomial::atom(places[i]).into(), &at_rest[i], -Exact::one())?);
        }
        let velocities = work.algebra.solve(&mass, &momenta)?;
        let mut kinetic = Fraction::default();
        for (velocity, momentum) in velocities.iter().zip(&momenta) {
            let product = work.algebra.times(velocity, momentum)?;
            kinetic = work.algebra.plus(&kinetic, &product, Exact::new(1, 2))?;
        }
        let rest = work.present(self.recorded.at_rest.lagrangian)?;
        let rest = work.algebra.plus(&Fraction::default(), &rest, -Exact::one())?;
        let kinetic = work.algebra.presented(&kinetic)?;
        work.printed(&[kinetic, rest])
    }

    /// Whether H has a pole where the sine of a coordinate is 0, as for an angle from a pole.
    pub fn is_polar(&self, i: usize) -> bool {
        let mut work = Work::new(self);
        let Ok(parts) = work.hamiltonian() else { return false };
        let angle = Polynomial::atom(work.places(&self.names.inputs().coordinates())[i]);
        let Some(pair) = work.algebra.pairs().iter().find(|pair| pair.angle == angle) else { return false };
        parts.iter().any(|part| {
            let below = part.under.keys().any(|factor| factor.exponents(pair.sine) != (0, 0));
            part.top.exponents(pair.sine).0 < 0 || below
        })
    }

    /// A coordinate with this number of dots.
    pub fn coordinate(&self, i: usize, dots: u8) -> Expr {
        symbol(self.names.coordinates[i], dots)
    }

    /// The momentum of a coordinate.
    pub fn momentum(&self, i: usize) -> Expr {
        symbol(self.names.momenta[i], 0)
    }

    /// The names of L, E and H.
    pub fn functions(&self) -> [Expr; 3] {
        [self.names.lagrangian, self.names.energy, self.names.hamiltonian].map(|id| symbol(id, 0))
    }

    /// Whether a coordinate stands in sines and cosines.
    pub fn is_angle(&self, i: usize) -> bool {
        self.symbols().entry(self.names.coordinates[i]).angle
    }

    /// Whether L has a pole where a coordinate is 0.
    ///
    /// # Errors
    /// When L has no normal form.
    pub fn has_pole(&self, i: usize) -> Result<bool> {
        let mut work = Work::new(self);
        let value = work.normal(&[self.recorded.lagrangian])?.remove(0);
        let place = work.places(&self.names.inputs().coordinates())[i];
        Ok(value.top.exponents(place).0 < 0 || !value.under.is_empty())
    }

    fn one(&self, of: Symbol) -> Result<Expr> {
        let mut work = Work::new(self);
        let value = work.present(of)?;
        work.printed(&[value])
    }

    fn several<const K: usize>(&self, of: [Symbol; K]) -> Result<[Expr; K]> {
        let printed: Vec<Expr> = of.iter().map(|&symbol| self.one(symbol)).collect::<Result<_>>()?;
        Ok(std::array::from_fn(|i| printed[i].clone()))
    }
}

/// Whether a formula is the number 0.
pub(super) fn is_zero(expr: &Expr) -> bool {
    matches!(&expr.node, crate::formula::Node::Number(digits) if digits == "0")
}
