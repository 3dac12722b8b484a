//! Tracing: a Lagrangian is run once over symbols, and the recorded tape is differentiated by running it over symbols
//! again.
//!
//! One sweep backwards gives ∂L/∂q and ∂L/∂q̇. The gradient, itself recorded, is run forwards over num-dual's dual
//! numbers: along the motion for d/dt ∂L/∂q̇, along each velocity for a column of the mass matrix. So n coordinates
//! take n runs of a program that is no longer than a few times L. The graph takes equal expressions for one.
//!
//! # Why the system is traced
//!
//! A Lagrangian is generic in its number. It is run once over `Symbol`, a node in a hash-consed graph; the record
//! becomes a `Tape`, a straight-line program. The tape runs over `f64`, `RunningError`, series, field elements and
//! duals alike, so one recording serves all purposes. One backward sweep gives ∂L/∂q and ∂L/∂q̇; duals of that
//! program give d/dt ∂L/∂q̇ and the mass matrix. So a chain of n pendulums takes n² operations before the linear
//! system is solved. Tracing needs that the Lagrangian does not branch on values; one that does is an error. The
//! graph is put into a normal form with sin² = 1 − cos² first. The generic functions of `mechanics` run the
//! Lagrangian without tracing, and the tests compare the two.

use num_dual::Dual;
use num_traits::One;

use super::elimination::{eliminate, is_product, pivots, upper};
use super::layout::Layout;
use super::multipliers::Multipliers;
use crate::Result;
use crate::mechanics::rigid_body::rotations::RotationalState;
use crate::mechanics::tape::Tape;
use crate::mechanics::tape::reverse_mode::gradient;
use crate::mechanics::{Lagrangian, State};
use crate::scalar::{Graph, Symbol, simplify_all, try_simplify};

/// A traced system.
pub(super) struct Traced {
    /// L.
    pub lagrangian: Tape,
    /// L, momenta, energy, forces; then U and T if there is a potential; then R row by row, ω in space components,
    /// ω along the body if there is an orientation.
    pub quantities: Tape,
    /// Momenta, then the upper triangle of the mass matrix.
    pub momenta_and_mass: Tape,
    /// The upper triangle of the mass matrix, then the residuals at zero acceleration.
    pub dynamics: Tape,
    /// Accelerations by elimination without exchanges; then each pivot and the diagonal entry that it came from.
    pub accelerations: Tape,
    /// ∂L/∂qᵢ is the constant 0.
    pub certainly_cyclic: Vec<bool>,
    /// Lagrange multipliers among the coordinates.
    pub multipliers: Option<Multipliers>,
    pub has_potential: bool,
    pub has_orientation: bool,
}

/// What is recorded of a system.
pub(super) struct Recorded {
    /// L.
    pub lagrangian: Symbol,
    /// U, if L = T − U.
    pub potential: Option<Symbol>,
    /// What acts beside L.
    pub applied: Applied,
    /// Of a rigid body: R row by row, ω in space components, ω along the body.
    pub turning: Option<Vec<Symbol>>,
}

/// What acts on a system beside its Lagrangian: d/dt ∂L/∂q̇ − ∂L/∂q = Q − ∂F/∂q̇.
#[derive(Default)]
pub struct Applied {
    /// The generalized forces Q, one for each coordinate, as functions of t, q, q̇ and the parameters; empty for none.
    pub forces: Vec<Symbol>,
    /// Rayleigh's dissipation function F.
    pub dissipation: Option<Symbol>,
    /// Constraints g(t, q, q̇) = 0 beside L, each with the place of its multiplier λ among the coordinates: the force is
    /// λ ∂g/∂q̇ (Lagrange–d'Alembert). L contains no such λ.
    pub constraints: Vec<(usize, Symbol)>,
}

/// Traces `l`.
///
/// # Errors
/// When it branches on a value.
pub(super) fn trace<L: Lagrangian<N, P>, const N: usize, const P: usize>(l: &L) -> Result<Traced> {
    let layout = Layout { coordinates: N, parameters: P };
    traced(layout, || {
        let at = State {
            time: Symbol::input(0),
            q: std::array::from_fn(|i| Symbol::input(layout.q(i))),
            v: std::array::from_fn(|i| Symbol::input(layout.v(i))),
            parameters: std::array::from_fn(|i| Symbol::input(1 + 2 * N + i)),
        };
        let turning = RotationalState::of(l, &at).map(|turning| {
            let rows = turning.orientation.transpose();
            rows.iter().chain(&turning.angular_velocity).chain(&turning.body_rates).copied().collect()
        });
        let potential = l.potential_energy(&at);
        Recorded { lagrangian: l.lagrangian(&at), potential, applied: Applied::default(), turning }
    })
}

/// Differentiates what is recorded of a system over the inputs of a layout.
///
/// # Errors
/// When it branches on a value.
pub(super) fn traced(layout: Layout, record: impl FnOnce() -> Recorded) -> Result<Traced> {
    let tape = |graph: &Graph, outputs: &[Symbol]| Tape::new(graph, layout.inputs(), outputs);
    let n = layout.coordinates;

    let (graph, (lagrangian, potential, forces, dissipation, turning, rolling)) = Graph::record(|| {
        let Recorded { lagrangian, potential, applied, turning } = record();
        let simple = |outputs: Option<Vec<Symbol>>| outputs.map(|outputs| simplify_all(&outputs));
        let one = |value: Option<Symbol>| simple(value.map(|value| vec![value]));
        let forces = simplify_all(&applied.forces);
        let (places, constraints): (Vec<usize>, Vec<Symbol>) = applied.constraints.into_iter().unzip();
        let rolling = (places, simplify_all(&constraints));
        (simplify_all(&[lagrangian]), one(potential), forces, one(applied.dissipation), simple(turning), rolling)
    })?;
    let lagrangian = tape(&graph, &lagrangian);
    let potential = potential.map(|outputs| tape(&graph, &outputs));
    let turning = turning.map(|outputs| tape(&graph, &outputs));
    let forces = tape(&graph, &forces);
    let dissipation = dissipation.map(|outputs| tape(&graph, &outputs));
    let rolling = (rolling.0, tape(&graph, &rolling.1));
    let (graph, losses) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        dissipation.map(|function| gradient(&function, &inputs).1[layout.v(0)..layout.v(n)].to_vec())
    })?;
    let losses = losses.map(|slopes| tape(&graph, &slopes));

    let (graph, (value, slopes)) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        gradient(&lagrangian, &inputs)
    })?;
    let momenta = tape(&graph, &slopes[layout.v(0)..layout.v(n)]);
    let first = tape(&graph, &[&[value], &slopes[layout.q(0)..layout.v(n)]].concat());
    let multipliers = Multipliers::of(layout, &tape(&graph, &slopes[layout.q(0)..layout.v(0)]), &momenta, &rolling)?;

    let (graph, derived) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        let mut derived = Derived::new(layout, &first, &momenta, &inputs);
        let losses = losses.as_ref().map_or_else(Vec::new, |losses| losses.evaluate(&inputs));
        for (bias, force) in derived.bias.iter_mut().zip(forces.evaluate(&inputs)) {
            *bias -= force;
        }
        if let Some(multipliers) = &multipliers {
            let forces = multipliers.forces(layout, &inputs);
            derived.bias.iter_mut().zip(forces).for_each(|(bias, force)| *bias -= force);
        }
        for (bias, loss) in derived.bias.iter_mut().zip(losses) {
            *bias += loss;
        }
        let mut quantities = vec![derived.value];
        quantities.extend(&derived.momenta);
        quantities.push(derived.energy);
        quantities.extend(&derived.forces);
        if let Some(potential) = &potential {
            let u = potential.evaluate(&inputs)[0];
            quantities.push(u);
            quantities.extend(simplify_all(&[derived.value + u]));
        }
        if let Some(turning) = &turning {
            quantities.extend(turning.evaluate(&inputs));
        }
        let momenta_and_mass = [&derived.momenta[..], &derived.mass].concat();
        let dynamics = [&derived.mass[..], &derived.bias].concat();
        let cyclic = derived.forces.iter().map(|force| force.as_constant() == Some(0.0)).collect();
        (quantities, momenta_and_mass, dynamics, cyclic)
    })?;
    let (quantities, momenta_and_mass, dynamics, certainly_cyclic) = derived;
    let order = pivots(layout, |k| tape(&graph, &[dynamics[upper(n, k, k)]]));
    let (quantities, momenta_and_mass) = (tape(&graph, &quantities), tape(&graph, &momenta_and_mass));
    let dynamics = tape(&graph, &dynamics);

    let (graph, accelerations) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        let values = dynamics.evaluate(&inputs);
        let (mass, bias) = values.split_at(n * (n + 1) / 2);
        let mut outputs = eliminate(&order, mass, bias, try_simplify);
        for pair in outputs[n..].chunks_mut(2).filter(|pair| is_product(pair[0])) {
            pair[1] = pair[0]; // it is sound unless it vanishes
        }
        outputs
    })?;
    Ok(Traced {
        accelerations: tape(&graph, &accelerations),
        quantities,
        momenta_and_mass,
        dynamics,
        certainly_cyclic,
        multipliers,
        has_potential: potential.is_some(),
        has_orientation: turning.is_some(),
        lagrangian,
    })
}

/// What follows from L, as symbols.
struct Derived {
    value: Symbol,
    momenta: Vec<Symbol>,
    energy: Symbol,
    forces: Vec<Symbol>,
    mass: Vec<Symbol>,
    bias: Vec<Symbol>,
}

impl Derived {
    /// From the tape of L, ∂L/∂q and ∂L/∂q̇, and that of ∂L/∂q̇ alone.
    fn new(layout: Layout, first: &Tape, momenta: &Tape, inputs: &[Symbol]) -> Self {
        let n = layout.coordinates;
        let along = |direction: &[(usize, Symbol)]| {
            let mut at: Vec<_> = inputs.iter().copied().map(Dual::from_re).collect();
            direction.iter().for_each(|&(input, component)| at[input].eps = component);
            momenta.evaluate(&at).into_iter().map(|p| p.eps).collect::<Vec<_>>()
        };
        let values = first.evaluate(inputs);
        let (value, forces, momenta) = (values[0], values[1..=n].to_vec(), values[1 + n..].to_vec());
        // the motion without acceleration
        let mut motion = vec![(0, Symbol::one())];
        motion.extend((0..n).map(|i| (layout.q(i), inputs[layout.v(i)])));
        let bias: Vec<Symbol> = along(&motion).into_iter().zip(&forces).map(|(rate, &force)| rate - force).collect();
        let columns: Vec<_> = (0..n).map(|j| along(&[(layout.v(j), Symbol::one())])).collect();
        let mass: Vec<Symbol> = (0..n).flat_map(|i| columns[i..].iter().map(move |column| column[i])).collect();
        let pv = momenta.iter().enumerate().map(|(i, &p)| p * inputs[layout.v(i)]).sum::<Symbol>();
        let energy = simplify_all(&[pv - value])[0];
        let (momenta, forces, dynamics) =
            (simplify_all(&momenta), simplify_all(&forces), simplify_all(&[mass, bias].concat()));
        let (mass, bias) = dynamics.split_at(n * (n + 1) / 2);
        Derived { value, momenta, energy, forces, mass: mass.to_vec(), bias: bias.to_vec() }
    }
}
