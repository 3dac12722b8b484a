//! The quantities of a system as symbols of one recording: what follows from L, and the parts that it consists of.

use num_dual::Dual;
use num_traits::{One, Zero};

use super::names::Inputs;
use crate::Result;
use crate::mechanics::{Parts, System, Tape};
use crate::scalar::{Graph, Symbol};

/// The quantities of the system as symbols.
pub(super) struct Recorded {
    pub lagrangian: Symbol,
    pub momenta: Vec<Symbol>,
    pub energy: Symbol,
    pub forces: Vec<Symbol>,
    pub residuals: Vec<Symbol>,
    /// d/dt of each momentum along the motion with any accelerations.
    pub momentum_rates: Vec<Symbol>,
    pub mass: Vec<Vec<Symbol>>,
    pub at_rest: AtRest,
    /// T and U, where L = T − U.
    pub energies: Option<[Symbol; 2]>,
    /// Each point mass: its mass, its place and its velocity.
    pub particles: Vec<(Symbol, [Symbol; 3], [Symbol; 3])>,
    pub body: Option<Body>,
}

/// The same with all velocities, or accelerations, 0.
pub(super) struct AtRest {
    pub lagrangian: Symbol,
    pub momenta: Vec<Symbol>,
    pub forces: Vec<Symbol>,
    pub residuals: Vec<Symbol>,
}

/// A rigid body.
pub(super) struct Body {
    /// R: the rows are the axes of the body in space components.
    pub axes: [[Symbol; 3]; 3],
    /// ω in space components.
    pub space: [Symbol; 3],
    /// ω along the axes of the body.
    pub along: [Symbol; 3],
    /// The principal moments.
    pub moments: Option<[Symbol; 3]>,
}

/// The masses, places and principal moments of the parts of a system, before their velocities are known.
pub(super) struct Places {
    tape: Tape,
    particles: usize,
    has_moments: bool,
}

impl Places {
    /// # Errors
    /// When the parts branch on a value.
    pub fn record(
        inputs: &Inputs,
        parts: impl FnOnce(Symbol, &[Symbol], &[Symbol], &[Symbol]) -> Parts,
    ) -> Result<Places> {
        let symbols = |block: Vec<usize>| block.into_iter().map(Symbol::input).collect::<Vec<_>>();
        let (graph, (outputs, particles, has_moments)) = Graph::record(|| {
            let (q, v) = (symbols(inputs.coordinates()), symbols(inputs.velocities()));
            let parts = parts(Symbol::input(0), &q, &v, &symbols(inputs.parameters()));
            let mut outputs = Vec::new();
            for particle in &parts.particles {
                outputs.push(particle.mass);
                outputs.extend(particle.place);
            }
            outputs.extend(parts.moments.iter().flatten());
            (outputs, parts.particles.len(), parts.moments.is_some())
        })?;
        let tape = Tape::new(&graph, 1 + 2 * inputs.n + inputs.parameters, &outputs);
        Ok(Places { tape, particles, has_moments })
    }

    /// The values along the motion: a place has its velocity as its derivative.
    fn moving(&self, time: Symbol, q: &[Symbol], v: &[Symbol], parameters: &[Symbol]) -> Vec<Dual<Symbol>> {
        let still = |x: &[Symbol]| x.iter().copied().map(Dual::from_re).collect::<Vec<_>>();
        let moved = q.iter().zip(v).map(|(&q, &v)| Dual::new(q, v)).collect::<Vec<_>>();
        let at = [vec![Dual::new(time, Symbol::one())], moved, still(v), still(parameters)].concat();
        self.tape.evaluate(&at)
    }
}

impl Recorded {
    /// Where the parts are, and how they are turned.
    pub fn places(&self) -> Vec<Symbol> {
        let particles = self.particles.iter().flat_map(|(_, place, _)| place);
        particles.chain(self.body.iter().flat_map(|body| body.axes.iter().flatten())).copied().collect()
    }

    /// Records what follows from a system, for symbols of the recording that is under way.
    pub fn new(system: &System, inputs: &Inputs, places: &Places) -> Recorded {
        let symbols = |block: Vec<usize>| block.into_iter().map(Symbol::input).collect::<Vec<_>>();
        let (q, v, parameters) =
            (symbols(inputs.coordinates()), symbols(inputs.velocities()), symbols(inputs.parameters()));
        let (time, a, still) = (Symbol::input(0), symbols(inputs.accelerations()), vec![Symbol::zero(); inputs.n]);
        let moving = system.quantities(time, &q, &v, &parameters);
        let resting = system.quantities(time, &q, &still, &parameters);
        let mass = system.mass_matrix(time, &q, &v, &parameters);
        let parts = places.moving(time, &q, &v, &parameters);
        let along =
            |x: &[Symbol], rates: &[Symbol]| x.iter().zip(rates).map(|(&x, &r)| Dual::new(x, r)).collect::<Vec<_>>();
        let fixed = parameters.iter().copied().map(Dual::from_re).collect::<Vec<_>>();
        let motion = system.quantities(Dual::new(time, Symbol::one()), &along(&q, &v), &along(&v, &a), &fixed);
        let triple = |from: usize, of: fn(&Dual<Symbol>) -> Symbol| std::array::from_fn(|i| of(&parts[from + i]));
        let particle = |k: usize| (parts[4 * k].re, triple(4 * k + 1, |x| x.re), triple(4 * k + 1, |x| x.eps));
        let moments = places.has_moments.then(|| triple(4 * places.particles, |x| x.re));
        let turning = moving.orientation.zip(moving.angular_velocity).zip(moving.body_rates);
        let body = turning.map(|((orientation, space), along)| Body {
            axes: std::array::from_fn(|a| std::array::from_fn(|b| orientation[(a, b)])),
            space: std::array::from_fn(|i| space[i]),
            along: std::array::from_fn(|i| along[i]),
            moments,
        });
        Recorded {
            energies: moving.kinetic.zip(moving.potential).map(|(t, u)| [t, u]),
            particles: (0..places.particles).map(particle).collect(),
            body,
            lagrangian: moving.lagrangian,
            momentum_rates: motion.momenta.iter().map(|momentum| momentum.eps).collect(),
            momenta: moving.momenta,
            energy: moving.energy,
            forces: moving.forces,
            residuals: system.euler_lagrange(time, &q, &v, &parameters, &a),
            mass: mass.row_iter().map(|row| row.iter().copied().collect()).collect(),
            at_rest: AtRest {
                lagrangian: resting.lagrangian,
                momenta: resting.momenta,
                forces: resting.forces,
                residuals: system.euler_lagrange(time, &q, &v, &parameters, &still),
            },
        }
    }
}
