//! What can be derived of a system and typeset: the Lagrangian, momenta, energy, equations of motion, H.
//!
//! The [`System`] runs over symbols with the same code as over numbers. Solving is not recorded: accelerations, and
//! velocities as functions of momenta, are computed from the mass matrix in normal form.

use std::collections::BTreeMap;

use num_traits::One;

use super::algebra::{Algebra, Fraction};
use super::names::{Inputs, Names, symbol};
use super::polynomial::Polynomial;
use super::print::Printer;
use super::rational::Exact;
use super::recorded::{Places, Recorded};
use crate::formula::{Expr, Relation, Statement, Symbols, text};
use crate::latex::typeset;
use crate::mechanics::{AnyLagrangian, Parts, System};
use crate::scalar::{Graph, Symbol};
use crate::source::Span;
use crate::{Error, Result};

/// A quantity to derive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// L(q, q̇, t).
    Lagrangian,
    /// pᵢ = ∂L/∂q̇ᵢ.
    Momenta,
    /// d/dt ∂L/∂q̇ᵢ = ∂L/∂qᵢ, the accelerations on the left.
    EulerLagrange,
    /// E = Σ pᵢ q̇ᵢ − L, in velocities.
    Energy,
    /// H(q, p, t).
    Hamiltonian,
    /// q̇ᵢ = ∂H/∂pᵢ and ṗᵢ = −∂H/∂qᵢ.
    Hamilton,
    /// The Euler–Lagrange equations solved for q̈ᵢ.
    Accelerations,
    /// M_ij = ∂²L/∂q̇ᵢ∂q̇ⱼ for i ≤ j.
    MassMatrix,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Quantity; 8] = [
        Quantity::Lagrangian,
        Quantity::Momenta,
        Quantity::EulerLagrange,
        Quantity::Energy,
        Quantity::Hamiltonian,
        Quantity::Hamilton,
        Quantity::Accelerations,
        Quantity::MassMatrix,
    ];
}

/// A derived equation.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its name in words, such as `momentum of θ`.
    pub name: String,
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
}

/// A system whose equations are to be typeset.
pub struct Derivation {
    pub(super) names: Names,
    pub(super) graph: Graph,
    pub(super) recorded: Recorded,
}

impl Derivation {
    /// Prepares a system.
    ///
    /// # Errors
    /// When two of its names are the same, or a name cannot be read.
    pub fn new(system: &System) -> Result<Self> {
        Derivation::of_parts(system, |_, _, _, _| Parts::default())
    }

    /// Prepares a system of a registry, with the parts that it consists of.
    ///
    /// # Errors
    /// As [`Derivation::new`], and when the Lagrangian cannot be traced.
    pub fn of(lagrangian: &dyn AnyLagrangian) -> Result<Self> {
        let parts = |time, q: &[Symbol], v: &[Symbol], p: &[Symbol]| lagrangian.parts(time, q, v, p);
        Derivation::of_parts(&lagrangian.trace()?, parts)
    }

    fn of_parts(system: &System, parts: impl FnOnce(Symbol, &[Symbol], &[Symbol], &[Symbol]) -> Parts) -> Result<Self> {
        let names = Names::new(system)?;
        let inputs = Inputs { n: system.coordinates().len(), parameters: system.parameters().len() };
        let places = Places::record(&inputs, parts)?;
        let (graph, recorded) = Graph::record(|| Recorded::new(system, &inputs, &places))?;
        let mut derivation = Derivation { names, graph, recorded };
        derivation.find_angles()?;
        Ok(derivation)
    }

    /// The names that occur in the equations.
    pub fn symbols(&self) -> &Symbols {
        &self.names.symbols
    }

    /// An equation as LaTeX that onshell reads.
    pub fn latex(&self, equation: &Equation) -> String {
        format!("{} = {}", typeset(&equation.left, self.symbols()), typeset(&equation.right, self.symbols()))
    }

    /// An equation in plain text.
    pub fn text(&self, equation: &Equation) -> String {
        let span = Span::default();
        let members = vec![equation.left.clone(), equation.right.clone()];
        let relations = vec![(Relation::Equal, span)];
        text::statement(
            &Statement { members, relations, conditions: Vec::new(), constant: None, branch: None, row: 1, span },
            self.symbols(),
        )
    }

    /// The equations for one quantity, in the order of the coordinates.
    ///
    /// # Errors
    /// When it does not exist (H, if L is not quadratic in the velocities), or cannot be typeset.
    pub fn equations(&self, quantity: Quantity) -> Result<Vec<Equation>> {
        let names = &self.names;
        let mut work = Work::new(self);
        match quantity {
            Quantity::Lagrangian => {
                let value = work.present(self.recorded.lagrangian)?;
                Ok(vec![work.equation("Lagrangian", symbol(names.lagrangian, 0), &[value])?])
            }
            Quantity::Energy => {
                let value = work.present(self.recorded.energy)?;
                Ok(vec![work.equation("energy", symbol(names.energy, 0), &[value])?])
            }
            Quantity::Momenta => {
                let momentum = |i: usize| {
                    let value = work.present(self.recorded.momenta[i])?;
                    work.equation(&format!("momentum of {}", names.spelled(i)), symbol(names.momenta[i], 0), &[value])
                };
                names.each().map(momentum).collect()
            }
            Quantity::EulerLagrange => names.each().map(|i| work.euler_lagrange(i)).collect(),
            Quantity::Hamiltonian => {
                let value = work.hamiltonian()?;
                Ok(vec![work.equation("Hamiltonian", symbol(names.hamiltonian, 0), &value)?])
            }
            Quantity::Hamilton => work.hamilton(),
            Quantity::Accelerations => {
                let mass = work.mass()?;
                let residuals = work.normal(&self.recorded.at_rest.residuals)?;
                let zero = Fraction::default();
                let forces: Vec<Fraction> =
                    residuals.iter().map(|h| work.algebra.plus(&zero, h, -Exact::one())).collect::<Result<_>>()?;
                let solution = work.algebra.solve(&mass, &forces)?;
                let acceleration = |(i, value): (usize, &Fraction)| {
                    let name = format!("acceleration of {}", names.spelled(i));
                    work.equation(&name, symbol(names.coordinates[i], 2), std::slice::from_ref(value))
                };
                solution.iter().enumerate().map(acceleration).collect()
            }
            Quantity::MassMatrix => {
                let pairs = names.each().flat_map(|i| (i..names.coordinates.len()).map(move |j| (i, j)));
                let entry = |(at, (i, j)): (usize, (usize, usize))| {
                    let value = work.present(self.recorded.mass[i][j])?;
                    let name = format!("mass of {} and {}", names.spelled(i), names.spelled(j));
                    work.equation(&name, symbol(names.masses[at], 0), &[value])
                };
                pairs.enumerate().map(entry).collect()
            }
        }
    }

    /// Marks a coordinate as an angle for typesetting, if its sine or cosine occurs.
    fn find_angles(&mut self) -> Result<()> {
        let mut work = Work::new(self);
        work.normal(&[&[self.recorded.lagrangian], self.recorded.places().as_slice()].concat())?;
        let coordinates = work.places(&self.names.inputs().coordinates());
        let angle = |i: &usize| {
            let own = coordinates[*i];
            work.algebra.pairs().iter().any(|pair| pair.angle.exponents(own) != (0, 0))
        };
        let angles: Vec<usize> = self.names.each().filter(angle).collect();
        for i in angles {
            self.names.symbols.entry_mut(self.names.coordinates[i]).angle = true;
        }
        Ok(())
    }
}

/// One derivation with its own atoms.
pub(super) struct Work<'a> {
    of: &'a Derivation,
    pub algebra: Algebra,
}

impl<'a> Work<'a> {
    pub fn new(of: &'a Derivation) -> Self {
        Work { of, algebra: Algebra::of_inputs(of.names.letters.len()) }
    }

    pub fn normal(&mut self, outputs: &[Symbol]) -> Result<Vec<Fraction>> {
        let normal = self.algebra.normal(&self.of.graph, outputs)?;
        normal.iter().map(|fraction| self.algebra.presented(fraction)).collect()
    }

    pub fn present(&mut self, output: Symbol) -> Result<Fraction> {
        Ok(self.normal(&[output])?.remove(0))
    }

    pub fn printed(&self, value: &[Fraction]) -> Result<Expr> {
        Printer { algebra: &self.algebra, letters: &self.of.names.letters }.sum(value)
    }

    fn equation(&self, name: &str, left: Expr, right: &[Fraction]) -> Result<Equation> {
        Ok(Equation { name: name.to_owned(), left, right: self.printed(right)? })
    }

    fn euler_lagrange(&mut self, i: usize) -> Result<Equation> {
        let residual = self.present(self.of.recorded.residuals[i])?;
        let accelerations = self.places(&self.of.names.inputs().accelerations());
        let (left, right) = self.algebra.balanced(residual, &accelerations)?;
        let name = format!("equation of motion of {}", self.of.names.spelled(i));
        let left = self.printed(&[left])?;
        self.equation(&name, left, &[right])
    }

    fn mass(&mut self) -> Result<Vec<Vec<Fraction>>> {
        self.of.recorded.mass.iter().map(|row| self.normal(row)).collect()
    }

    /// The velocities as functions of coordinates and momenta, and the momenta minus the momenta at rest.
    pub fn velocities(&mut self) -> Result<(Vec<Fraction>, Vec<Fraction>)> {
        let mass = self.mass()?;
        let velocities = self.places(&self.of.names.inputs().velocities());
        if mass.iter().flatten().any(|entry| self.algebra.reads(entry, &velocities)) {
            return Err(Error::new(
                "the Lagrangian is not quadratic in the velocities, so its Hamiltonian cannot be typeset",
            )
            .help(
                "use --as energy instead; H is printed only if p = M q̇ + b with M and b independent of the \
                 velocities",
            ));
        }
        let at_rest = self.normal(&self.of.recorded.at_rest.momenta)?;
        let mut momenta = Vec::new();
        for (place, b) in self.places(&self.of.names.inputs().momenta()).into_iter().zip(&at_rest) {
            momenta.push(self.algebra.plus(&Polynomial::atom(place).into(), b, -Exact::one())?);
        }
        Ok((self.algebra.solve(&mass, &momenta)?, momenta))
    }

    /// H = ½ Σ (pᵢ − bᵢ) q̇ᵢ − L at rest, where L = ½ Σ Mᵢⱼ q̇ᵢ q̇ⱼ + Σ bᵢ q̇ᵢ + L at rest.
    pub fn hamiltonian(&mut self) -> Result<Vec<Fraction>> {
        let (velocities, momenta) = self.velocities()?;
        let mut kinetic = Fraction::default();
        for (velocity, momentum) in velocities.iter().zip(&momenta) {
            let product = self.algebra.times(velocity, momentum)?;
            kinetic = self.algebra.plus(&kinetic, &product, Exact::new(1, 2))?;
        }
        let rest = self.present(self.of.recorded.at_rest.lagrangian)?;
        let rest = self.algebra.plus(&Fraction::default(), &rest, -Exact::one())?;
        Ok(vec![self.algebra.presented(&kinetic)?, self.algebra.presented(&rest)?])
    }

    /// ∂H/∂p is q̇, and −∂H/∂q at fixed p is ∂L/∂q at fixed q̇.
    fn hamilton(&mut self) -> Result<Vec<Equation>> {
        let names = &self.of.names;
        let (velocities, _) = self.velocities()?;
        let places = self.places(&names.inputs().velocities());
        let values: BTreeMap<u32, Fraction> = places.into_iter().zip(velocities.iter().cloned()).collect();
        let mut equations = Vec::new();
        for (i, velocity) in velocities.iter().enumerate() {
            let name = format!("rate of {}", names.spelled(i));
            equations.push(self.equation(&name, symbol(names.coordinates[i], 1), std::slice::from_ref(velocity))?);
        }
        let forces = self.algebra.normal(&self.of.graph, &self.of.recorded.forces)?;
        let at_rest = self.algebra.normal(&self.of.graph, &self.of.recorded.at_rest.forces)?;
        for (i, (force, still)) in forces.iter().zip(&at_rest).enumerate() {
            let moving = self.algebra.plus(force, still, -Exact::one())?;
            let moving = self.algebra.presented(&moving)?;
            let moving = self.algebra.substitute(&moving, &values)?;
            let parts = [self.algebra.presented(&moving)?, self.algebra.presented(still)?];
            let name = format!("rate of the momentum of {}", names.spelled(i));
            equations.push(self.equation(&name, symbol(names.momenta[i], 1), &parts)?);
        }
        Ok(equations)
    }

    pub fn places(&self, inputs: &[usize]) -> Vec<u32> {
        inputs.iter().map(|&n| self.algebra.input_place(n)).collect()
    }
}
