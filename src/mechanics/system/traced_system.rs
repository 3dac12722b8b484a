//! The traced system: tapes of all quantities that follow from a Lagrangian, and their evaluation. Every check takes its motion,
//! accelerations and higher derivatives from here (`motion_with`, called in `crate::check::state::system_values`).

use nalgebra::{DMatrix, Matrix3, Vector3};

use super::elimination::upper;
use super::layout::Layout;
use super::programs::Programs;
use super::tracing::{Applied, Recorded, Traced, trace, traced};
use crate::mechanics::linear_solver::{self, LinearSolver};
use crate::mechanics::{Lagrangian, motion};
use crate::scalar::{Number, Series, Symbol, each};
use crate::{Error, Result};

/// The quantities of one state.
#[derive(Clone, Debug)]
pub struct Quantities<D> {
    /// L.
    pub lagrangian: D,
    /// T = L + U, if the system has a potential.
    pub kinetic: Option<D>,
    /// U, if the system has one.
    pub potential: Option<D>,
    /// The generalized momenta pᵢ = ∂L/∂q̇ᵢ.
    pub momenta: Vec<D>,
    /// Σ pᵢ q̇ᵢ − L: the value of the Hamiltonian.
    pub energy: D,
    /// The generalized forces ∂L/∂qᵢ.
    pub forces: Vec<D>,
    /// R of a rigid body: the rows are the body's axes in space components.
    pub orientation: Option<Matrix3<D>>,
    /// ω in space components.
    pub angular_velocity: Option<Vector3<D>>,
    /// ωₐ = ω·êₐ along the body's axes.
    pub body_rates: Option<Vector3<D>>,
}

/// A traced system: the quantities that follow from its Lagrangian, over any number.
///
/// States are slices. `q` (coordinates), `v` (velocities) and `a` (accelerations) have one entry for each coordinate,
/// `parameters` one for each parameter, in the order of [`System::coordinates`] and [`System::parameters`]. A missing
/// entry counts as NaN. Units are those of the parameters; angles are in radians.
pub struct System {
    name: String,
    coordinates: Vec<String>,
    parameters: Vec<String>,
    pub(super) cyclic: Vec<bool>,
    pub(super) traced: Traced,
    pub(super) programs: Programs,
}

impl System {
    /// Traces a Lagrangian.
    ///
    /// # Errors
    /// When it branches on a value.
    pub fn new<L: Lagrangian<N, P>, const N: usize, const P: usize>(l: &L) -> Result<System> {
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        Ok(System::of_traced(l.name(), names(&l.coordinates()), names(&l.parameters()), named(l.name(), trace(l))?))
    }

    /// Traces a Lagrangian that is given as a function of symbols. `lagrangian` returns L, U where L = T − U, and what acts
    /// beside L, as functions of t, q, q̇ and the parameters. The names are spelled as in LaTeX.
    ///
    /// # Errors
    /// When it branches on a value.
    pub fn of_lagrangian(
        name: &str,
        coordinates: Vec<String>,
        parameters: Vec<String>,
        lagrangian: impl FnOnce(Symbol, &[Symbol], &[Symbol], &[Symbol]) -> (Symbol, Option<Symbol>, Applied),
    ) -> Result<System> {
        let layout = Layout { coordinates: coordinates.len(), parameters: parameters.len() };
        let traced = traced(layout, || {
            let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
            let (q, v) = (&inputs[layout.q(0)..layout.v(0)], &inputs[layout.v(0)..layout.v(layout.coordinates)]);
            let (lagrangian, potential, applied) = lagrangian(inputs[0], q, v, &inputs[layout.v(layout.coordinates)..]);
            Recorded { lagrangian, potential, applied, turning: None }
        });
        Ok(System::of_traced(name, coordinates, parameters, named(name, traced)?))
    }

    /// A system with the coordinates and the orientation of this one, another Lagrangian, and further parameters after
    /// its own. `lagrangian` returns L and, where L = T − U, also U, as functions of t, q, q̇ and all parameters.
    ///
    /// # Errors
    /// When the Lagrangian branches on a value.
    pub fn with_lagrangian(
        &self,
        name: &str,
        more: Vec<String>,
        lagrangian: impl FnOnce(Symbol, &[Symbol], &[Symbol], &[Symbol]) -> (Symbol, Option<Symbol>),
    ) -> Result<System> {
        let parameters = [self.parameters.as_slice(), &more].concat();
        let layout = Layout { coordinates: self.coordinates.len(), parameters: parameters.len() };
        let traced = traced(layout, || {
            let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
            let (q, v) = (&inputs[layout.q(0)..layout.v(0)], &inputs[layout.v(0)..layout.v(layout.coordinates)]);
            let parameters = &inputs[layout.v(layout.coordinates)..];
            let (lagrangian, potential) = lagrangian(inputs[0], q, v, parameters);
            let own = self.quantities(inputs[0], q, v, parameters);
            let turning = own.orientation.zip(own.angular_velocity).zip(own.body_rates);
            let turning = turning.map(|((orientation, space), body)| {
                let rows = orientation.transpose();
                rows.iter().chain(&space).chain(&body).copied().collect()
            });
            Recorded { lagrangian, potential, applied: Applied::default(), turning }
        });
        Ok(System::of_traced(name, self.coordinates.clone(), parameters, named(name, traced)?))
    }

    fn of_traced(name: &str, coordinates: Vec<String>, parameters: Vec<String>, traced: Traced) -> System {
        let cyclic = traced.certainly_cyclic.clone();
        let (name, programs) = (name.to_owned(), Programs::default());
        let mut system = System { name, coordinates, parameters, cyclic, programs, traced };
        system.cyclic = (0..system.coordinates.len()).map(|i| system.cyclic[i] || system.force_vanishes(i)).collect();
        system
    }

    /// The system's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The coordinates as LaTeX spells them, in the order of all slices.
    pub fn coordinates(&self) -> &[String] {
        &self.coordinates
    }

    /// The parameters as LaTeX spells them, in the order of all slices.
    pub fn parameters(&self) -> &[String] {
        &self.parameters
    }

    /// Whether L = T − U with a potential energy U.
    pub fn has_potential(&self) -> bool {
        self.traced.has_potential
    }

    /// Whether there is a rigid body with an orientation.
    pub fn has_orientation(&self) -> bool {
        self.traced.has_orientation
    }

    /// Whether L depends on the time explicitly.
    pub fn depends_on_time(&self) -> bool {
        self.traced.lagrangian.reads(0)
    }

    /// One entry a coordinate.
    pub(super) fn each_coordinate<D: Number>(&self, x: &[D]) -> Vec<D> {
        exactly(x, self.coordinates.len())
    }

    fn inputs<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Vec<D> {
        let parameters = exactly(parameters, self.parameters.len());
        [vec![time], self.each_coordinate(q), self.each_coordinate(v), parameters].concat()
    }

    /// L.
    pub fn lagrangian<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> D {
        self.traced.lagrangian.evaluate(&self.inputs(time, q, v, parameters))[0]
    }

    /// Every quantity of a state at once.
    pub fn quantities<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Quantities<D> {
        let n = self.coordinates.len();
        let values = self.traced.quantities.evaluate(&self.inputs(time, q, v, parameters));
        let (momenta, rest) = values[1..].split_at(n);
        let (forces, mut rest) = rest[1..].split_at(n);
        let (mut potential, mut kinetic) = (None, None);
        if self.has_potential() {
            (potential, kinetic) = (Some(rest[0]), Some(rest[1]));
            rest = &rest[2..];
        }
        let turning = |from: usize| self.has_orientation().then(|| Vector3::from_row_slice(&rest[from..from + 3]));
        Quantities {
            lagrangian: values[0],
            kinetic,
            potential,
            momenta: momenta.to_vec(),
            energy: values[1 + n],
            forces: forces.to_vec(),
            orientation: self.has_orientation().then(|| Matrix3::from_row_slice(&rest[..9])),
            angular_velocity: turning(9),
            body_rates: turning(12),
        }
    }

    /// The Euler–Lagrange residuals d/dt ∂L/∂q̇ − ∂L/∂q = M a + h for given accelerations, on shell or off.
    pub fn euler_lagrange<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D], a: &[D]) -> Vec<D> {
        let (mass, bias) = self.dynamics(&self.inputs(time, q, v, parameters));
        let a = self.each_coordinate(a);
        let mut residuals = bias;
        for (i, residual) in residuals.iter_mut().enumerate() {
            for (j, &a) in a.iter().enumerate() {
                *residual += mass[(i, j)] * a;
            }
        }
        residuals
    }

    /// The mass matrix M_ij = ∂²L/∂q̇ᵢ∂q̇ⱼ.
    pub fn mass_matrix<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> DMatrix<D> {
        self.dynamics(&self.inputs(time, q, v, parameters)).0
    }

    pub(super) fn dynamics<D: Number>(&self, inputs: &[D]) -> (DMatrix<D>, Vec<D>) {
        let n = self.coordinates.len();
        let mut values = self.traced.dynamics.evaluate(inputs);
        let bias = values.split_off(n * (n + 1) / 2);
        (DMatrix::from_fn(n, n, |i, j| values[upper(n, i, j)]), bias)
    }

    pub(super) fn momenta_and_mass<D: Number>(
        &self,
        time: D,
        q: &[D],
        v: &[D],
        parameters: &[D],
    ) -> (Vec<D>, DMatrix<D>) {
        let n = self.coordinates.len();
        let mut momenta = self.traced.momenta_and_mass.evaluate(&self.inputs(time, q, v, parameters));
        let mass = momenta.split_off(n);
        (momenta, DMatrix::from_fn(n, n, |i, j| mass[upper(n, i, j)]))
    }

    /// The accelerations on shell.
    ///
    /// # Errors
    /// When the mass matrix is singular or ill-conditioned; the message has the condition number. A Lagrange multiplier has no
    /// acceleration that follows from the state; its entry is NaN.
    pub fn accelerations<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> Result<Vec<D>> {
        let (mass, right) = self.to_solve(time, q, v, parameters);
        let mut solution = linear_solver::solve("mass matrix", mass, right)?;
        for &k in self.multipliers() {
            solution[k] = D::from(f64::NAN);
        }
        Ok(solution)
    }

    /// The mass matrix and the right side of M a = −h. With multipliers, the unknowns in their places are their values.
    fn to_solve<D: Number>(&self, time: D, q: &[D], v: &[D], parameters: &[D]) -> (DMatrix<D>, Vec<D>) {
        let inputs = self.inputs(time, q, v, parameters);
        let Some(multipliers) = &self.traced.multipliers else {
            let (mass, bias) = self.dynamics(&inputs);
            return (mass, each(&bias, &|&h| -h));
        };
        let layout = Layout { coordinates: self.coordinates.len(), parameters: self.parameters.len() };
        let inputs = multipliers.without(layout, inputs);
        let (mut mass, bias) = self.dynamics(&inputs);
        let mut right = each(&bias, &|&h| -h);
        multipliers.complete(&inputs, &mut mass, &mut right);
        (mass, right)
    }

    /// The coordinates that are Lagrange multipliers: L is linear in them and contains none of their velocities.
    pub fn multipliers(&self) -> &[usize] {
        self.traced.multipliers.as_ref().map_or(&[], |multipliers| &multipliers.places)
    }

    /// The motion through a state on shell: each coordinate with its time derivatives up to `order`.
    ///
    /// # Errors
    /// When the mass matrix is singular or ill-conditioned, or `order` is beyond what a [`Series`] holds.
    pub fn motion<D: Number>(
        &self,
        time: D,
        q: &[D],
        v: &[D],
        parameters: &[D],
        order: usize,
    ) -> Result<Vec<Series<D>>> {
        self.motion_with(LinearSolver::PartialPivoting, time, q, v, parameters, order)
    }

    /// The same with the mass matrix inverted in the given way.
    ///
    /// # Errors
    /// As [`System::motion`].
    pub fn motion_with<D: Number>(
        &self,
        solver: LinearSolver,
        time: D,
        q: &[D],
        v: &[D],
        parameters: &[D],
        order: usize,
    ) -> Result<Vec<Series<D>>> {
        let time = Series::time(time);
        let parameters = each(parameters, &|&x| Series::constant(x));
        let solve = |q: &[Series<D>], v: &[Series<D>], known: usize| {
            let (mass, right) = self.to_solve(time, q, v, &parameters);
            match (solver, known) {
                // the first look at its condition is at all of its values
                (LinearSolver::PartialPivoting, 3..) => linear_solver::eliminate("mass matrix", mass, right),
                _ => linear_solver::solve_with(solver, "mass matrix", mass, right),
            }
        };
        match &self.traced.multipliers {
            Some(multipliers) => multipliers.motion(q, v, order, solve),
            None => motion::complete(q, v, order, solve),
        }
    }
}

/// What was traced, an error with the name of the Lagrangian before it.
fn named(name: &str, traced: Result<Traced>) -> Result<Traced> {
    traced.map_err(|error| {
        let help = error.advice().unwrap_or_default().to_owned();
        Error::new(format!("in the Lagrangian \"{name}\", {}", error.message())).help(help)
    })
}

/// The first `n` entries; one that is missing is NaN.
fn exactly<D: Number>(x: &[D], n: usize) -> Vec<D> {
    let mut entries = x[..n.min(x.len())].to_vec();
    entries.resize(n, D::from(f64::NAN));
    entries
}
