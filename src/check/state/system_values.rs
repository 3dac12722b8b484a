//! The quantities of the traced system at a sampled state: coordinates on shell, energies, momenta, the orientation.

use std::cell::OnceCell;

use nalgebra::Vector3;

use crate::Result;
use crate::check::model::Model;
use crate::check::model::meaning::Quantity;
use crate::check::model::sampling::Mode;
use crate::check::state::numbers::Base;
use crate::check::state::values::matrix;
use crate::formula::Value;
use crate::mechanics::{LinearSolver, Quantities, System};
use crate::scalar::{Number, Primal, Series, each};

/// The coordinates of a state as series in time, and the quantities of the system, computed on demand.
pub(crate) struct SystemValues<'m, B: Number> {
    system: Option<&'m System>,
    solver: LinearSolver,
    /// The number of terms of drawn functions.
    terms: usize,
    time: B,
    parameters: Vec<B>,
    coordinates: Vec<Series<B>>,
    series: OnceCell<Option<Box<Quantities<Series<B>>>>>,
    /// The quantities at the instant.
    values: OnceCell<Option<Box<Quantities<Primal<B>>>>>,
}

impl<'m, B: Number> SystemValues<'m, B> {
    /// The coordinates from the equations of motion if the state is on shell and there is a system, else as drawn.
    ///
    /// # Errors
    /// If the mass matrix is singular at this state.
    pub(crate) fn new(
        model: &'m Model,
        mode: Mode,
        base: &Base<B>,
        solver: LinearSolver,
        terms: usize,
    ) -> Result<Self> {
        let system = model.system.as_deref();
        let parameters = each(&model.parameters, &|place| base.constant(*place)[0]);
        let coordinates = match system {
            Some(system) if mode.on_shell => {
                let q: Vec<B> = base.coordinates().map(|jet| jet[0]).collect();
                let v: Vec<B> = base.coordinates().map(|jet| jet[1]).collect();
                let order = mode.order.min(terms - 1).max(1);
                system.motion_with(solver, base.time, &q, &v, &parameters, order)?
            }
            _ => base.coordinates().map(|jet| Series::from_derivatives(jet).truncated(terms)).collect(),
        };
        let (series, values) = (OnceCell::new(), OnceCell::new());
        Ok(SystemValues { system, solver, terms, time: base.time, parameters, coordinates, series, values })
    }

    /// How linear equations are solved at this state.
    pub(crate) fn solver(&self) -> LinearSolver {
        self.solver
    }

    /// The coordinates as functions of time.
    pub(crate) fn coordinates(&self) -> &[Series<B>] {
        &self.coordinates
    }

    /// The quantities of the system as series in time.
    pub(crate) fn series(&self) -> Option<&Quantities<Series<B>>> {
        let compute = || {
            let v = self.velocities();
            Some(Box::new(self.system?.quantities(self.time(), &self.coordinates, &v, &self.constants())))
        };
        self.series.get_or_init(compute).as_deref()
    }

    /// The quantities of the system at the instant.
    fn values(&self) -> Option<&Quantities<Primal<B>>> {
        let compute = || {
            let derivative = |order: usize| try_each(&self.coordinates, &|q| q.rate(order).map(Primal));
            let parameters = each(&self.parameters, &|parameter| Primal(*parameter));
            let time = Primal(self.time);
            Some(Box::new(self.system?.quantities(time, &derivative(0)?, &derivative(1)?, &parameters)))
        };
        self.values.get_or_init(compute).as_deref()
    }

    /// One quantity at the instant, if it is among those that the system computes together.
    pub(crate) fn value(&self, quantity: Quantity, indices: &[u8]) -> Option<Value<Primal<B>>> {
        match quantity {
            Quantity::SpaceAxes | Quantity::EffectivePotential => None,
            quantity => one_of(self.values()?, quantity, indices),
        }
    }

    /// One quantity as a series in time.
    pub(crate) fn quantity(&self, quantity: Quantity, indices: &[u8]) -> Option<Value<Series<B>>> {
        match quantity {
            Quantity::SpaceAxes => {
                let at = usize::from(*indices.first()?) - 1;
                let constant = |x| Series::constant(x).truncated(self.terms);
                Some(Value::Vector(Vector3::from_fn(|i, _| constant(if i == at { B::one() } else { B::zero() }))))
            }
            Quantity::EffectivePotential => {
                let (system, v, parameters) = (self.system?, self.velocities(), self.constants());
                let value = match self.solver {
                    LinearSolver::PartialPivoting => {
                        system.effective_potential(self.time(), &self.coordinates, &v, &parameters)
                    }
                    LinearSolver::CramersRule => {
                        system.effective_potential_exact(self.time(), &self.coordinates, &v, &parameters)
                    }
                };
                value.ok().map(Value::Scalar)
            }
            quantity => one_of(self.series()?, quantity, indices),
        }
    }

    /// The Euler–Lagrange residuals of the system, one for each coordinate.
    pub(crate) fn euler_lagrange(&self) -> Option<Vec<B>> {
        let derivative = |order: usize| try_each(&self.coordinates, &|q| q.nth_derivative_value(order));
        let (q, v, a) = (derivative(0)?, derivative(1)?, derivative(2)?);
        Some(self.system?.euler_lagrange(self.time, &q, &v, &self.parameters, &a))
    }

    fn time(&self) -> Series<B> {
        Series::time(self.time).truncated(self.terms)
    }

    fn velocities(&self) -> Vec<Series<B>> {
        each(&self.coordinates, &Series::derivative)
    }

    fn constants(&self) -> Vec<Series<B>> {
        each(&self.parameters, &|x| Series::constant(*x).truncated(self.terms))
    }
}

/// One of the quantities that a system computes together.
fn one_of<D: Number>(all: &Quantities<D>, quantity: Quantity, indices: &[u8]) -> Option<Value<D>> {
    let place = |at: usize| indices.get(at).map(|index| usize::from(*index) - 1);
    Some(match quantity {
        Quantity::Lagrangian => Value::Scalar(all.lagrangian),
        Quantity::KineticEnergy => Value::Scalar(all.kinetic?),
        Quantity::PotentialEnergy => Value::Scalar(all.potential?),
        Quantity::Energy => Value::Scalar(all.energy),
        Quantity::Momentum(i) => Value::Scalar(*all.momenta.get(i)?),
        Quantity::Force(i) => Value::Scalar(*all.forces.get(i)?),
        Quantity::RotationMatrix => match indices {
            [] => matrix(all.orientation.as_ref()?),
            _ => Value::Scalar(all.orientation.as_ref()?[(place(0)?, place(1)?)]),
        },
        Quantity::AngularVelocity => match indices {
            [] => Value::Vector(all.angular_velocity?),
            _ => Value::Scalar(all.body_rates.as_ref()?[place(0)?]),
        },
        Quantity::BodyAxes => Value::Vector(all.orientation.as_ref()?.row(place(0)?).transpose()),
        Quantity::EffectivePotential | Quantity::SpaceAxes => return None,
    })
}

/// `f` of every entry, if there is one of each.
fn try_each<A, B>(entries: &[A], f: &dyn Fn(&A) -> Option<B>) -> Option<Vec<B>> {
    let mut all = Vec::with_capacity(entries.len());
    for entry in entries {
        all.push(f(entry)?);
    }
    Some(all)
}
