//! From a Lagrangian to tapes: it is run once over symbols, then differentiated by running what was recorded over symbols
//! again.
//!
//! One sweep backwards gives ∂L/∂q and ∂L/∂q̇. The gradient, itself recorded, is run forwards over num-dual's dual
//! numbers: along the motion for d/dt ∂L/∂q̇, along each velocity for a column of the mass matrix. So n coordinates take n
//! runs of a program that is no longer than a few times L. The graph takes equal expressions for one.

use num_dual::Dual;
use num_traits::One;

use super::reverse::gradient;
use super::rotations::Turning;
use super::tape::Tape;
use super::{Lagrangian, State};
use crate::Result;
use crate::scalar::{Graph, Node, Number, Symbol, shortened, simplify_all};

/// Where things stand among a tape's inputs: time, coordinates, velocities, parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub coordinates: usize,
    pub parameters: usize,
}

impl Layout {
    pub fn inputs(self) -> usize {
        1 + 2 * self.coordinates + self.parameters
    }
    pub fn q(self, i: usize) -> usize {
        1 + i
    }
    pub fn v(self, i: usize) -> usize {
        1 + self.coordinates + i
    }
}

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
    pub has_potential: bool,
    pub has_orientation: bool,
}

/// What is recorded of a system.
pub(super) struct Recorded {
    /// L.
    pub lagrangian: Symbol,
    /// U, if L = T − U.
    pub potential: Option<Symbol>,
    /// Of a rigid body: R row by row, ω in space components, ω along the body.
    pub turning: Option<Vec<Symbol>>,
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
        let turning = Turning::of(l, &at).map(|turning| {
            let rows = turning.orientation.transpose();
            rows.iter().chain(&turning.angular_velocity).chain(&turning.body_rates).copied().collect()
        });
        let potential = l.potential_energy(&at);
        Recorded { lagrangian: l.lagrangian(&at), potential, turning }
    })
}

/// Differentiates what is recorded of a system over the inputs of a layout.
///
/// # Errors
/// When it branches on a value.
pub(super) fn traced(layout: Layout, record: impl FnOnce() -> Recorded) -> Result<Traced> {
    let tape = |graph: &Graph, outputs: &[Symbol]| Tape::new(graph, layout.inputs(), outputs);
    let n = layout.coordinates;

    let (graph, (lagrangian, potential, turning)) = Graph::record(|| {
        let Recorded { lagrangian, potential, turning } = record();
        let simple = |outputs: Option<Vec<Symbol>>| outputs.map(|outputs| simplify_all(&outputs));
        (simplify_all(&[lagrangian]), simple(potential.map(|u| vec![u])), simple(turning))
    })?;
    let lagrangian = tape(&graph, &lagrangian);
    let potential = potential.map(|outputs| tape(&graph, &outputs));
    let turning = turning.map(|outputs| tape(&graph, &outputs));

    let (graph, (value, slopes)) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        gradient(&lagrangian, &inputs)
    })?;
    let momenta = tape(&graph, &slopes[layout.v(0)..layout.v(n)]);
    let first = tape(&graph, &[&[value], &slopes[layout.q(0)..layout.v(n)]].concat());

    let (graph, derived) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        let derived = Derived::new(layout, &first, &momenta, &inputs);
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
        let mut outputs = eliminate(&order, mass, bias, shortened);
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

/// The place of M_ij in the upper triangle, stored row by row.
pub(super) fn upper(n: usize, i: usize, j: usize) -> usize {
    let (i, j) = (i.min(j), i.max(j));
    i * n - i * (i + 1) / 2 + j
}

/// The diagonal entries of the mass matrix in the order in which they become pivots: first those that no state changes,
/// which are inverted once and for all, as one would by hand.
fn pivots(layout: Layout, mass: impl Fn(usize) -> Tape) -> Vec<usize> {
    let varies = |&k: &usize| {
        let entry = mass(k);
        (0..layout.v(layout.coordinates)).any(|input| entry.reads(input))
    };
    let (varying, uniform): (Vec<usize>, Vec<usize>) = (0..layout.coordinates).partition(varies);
    [uniform, varying].concat()
}

/// Whether a number is a product of inputs and functions of inputs: such a pivot has lost no digits, however small it is.
fn is_product(number: Symbol) -> bool {
    match number.node() {
        Node::Constant(_) | Node::Input(_) => true,
        Node::Mul(a, b) => is_product(Symbol::at(a)) && is_product(Symbol::at(b)),
        Node::Neg(a) | Node::Recip(a) | Node::Powi(a, _) | Node::Powf(a, _) => is_product(Symbol::at(a)),
        Node::Apply(_, a) => matches!(Symbol::at(a).node(), Node::Input(_)),
        Node::Add(..) | Node::Sub(..) | Node::Atan2(..) => false,
    }
}

/// Solves M a = −h for a symmetric M by elimination, the diagonal entries being pivots in the given order: good enough for
/// nearly all mass matrices, and whoever uses the result looks at the pivots first. What is left after a pivot is
/// simplified together, beside what else is needed, as long as that brings anything. Outputs a, then the pairs (pivot, its diagonal entry).
fn eliminate<D: Number>(
    order: &[usize],
    mass: &[D],
    bias: &[D],
    simplify: impl Fn(&[D], &[D]) -> Option<Vec<D>>,
) -> Vec<D> {
    let n = order.len();
    let (mut left, mut right) = (mass.to_vec(), bias.iter().map(|&h| -h).collect::<Vec<D>>());
    let mut rows = Vec::with_capacity(n);
    let mut is_worth_it = true;
    for (done, &k) in order.iter().enumerate() {
        let shorter = |values: Vec<D>, beside: &[&[D]]| {
            let simple = if is_worth_it { simplify(&values, &beside.concat()) } else { None };
            simple.unwrap_or(values)
        };
        let rest = &order[done + 1..];
        let pivot = left[upper(n, k, k)];
        let inverse = pivot.recip();
        let factors: Vec<D> = rest.iter().map(|&i| left[upper(n, i, k)] * inverse).collect();
        let factors = shorter(factors, &[&left, &right]);
        for (&i, &factor) in rest.iter().zip(&factors) {
            right[i] = right[i] - factor * right[k];
            for &j in rest.iter().filter(|&&j| j >= i) {
                left[upper(n, i, j)] = left[upper(n, i, j)] - factor * left[upper(n, j, k)];
            }
        }
        right[k] = shorter(vec![right[k] * inverse], &[&left, &right, &factors])[0];
        let places: Vec<usize> = rest
            .iter()
            .flat_map(|&i| rest.iter().map(move |&j| (i, j)))
            .filter(|(i, j)| i <= j)
            .map(|(i, j)| upper(n, i, j))
            .collect();
        let remaining: Vec<D> = places.iter().map(|&at| left[at]).chain(rest.iter().map(|&i| right[i])).collect();
        let simple = if is_worth_it { simplify(&remaining, &[&factors[..], &[right[k]]].concat()) } else { None };
        is_worth_it = simple.is_some();
        let (matrix, vector) = simple.as_ref().unwrap_or(&remaining).split_at(places.len());
        places.iter().zip(matrix).for_each(|(&at, &entry)| left[at] = entry);
        rest.iter().zip(vector).for_each(|(&i, &entry)| right[i] = entry);
        rows.push((pivot, factors));
    }
    let mut a = right;
    for (done, &k) in order.iter().enumerate().rev() {
        let others = order[done + 1..].iter().zip(&rows[done].1);
        a[k] = others.fold(a[k], |sum, (&i, &factor)| sum - factor * a[i]);
    }
    a.extend(rows.iter().zip(order).flat_map(|((pivot, _), &k)| [*pivot, mass[upper(n, k, k)]]));
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_upper_triangle_is_stored_row_by_row() {
        let places: Vec<usize> = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|(i, j)| upper(3, i, j)).into();
        assert_eq!(places, [0, 1, 2, 3, 4, 5]);
        assert_eq!(upper(3, 2, 1), upper(3, 1, 2));
    }

    #[test]
    fn elimination_solves_and_shows_its_pivots() {
        // M = ((4, 2), (2, 3)), h = (−8, −7): a = (1.25, 1.5)
        assert_eq!(eliminate(&[0, 1], &[4.0, 2.0, 3.0], &[-8.0, -7.0], |_, _| None), [1.25, 1.5, 4.0, 4.0, 2.0, 3.0]);
        // in whatever order: M = ((4, 2), (2, 2)), h = (−8, −6): a = (1, 2)
        for order in [[0, 1], [1, 0]] {
            assert_eq!(eliminate(&order, &[4.0, 2.0, 2.0], &[-8.0, -6.0], |_, _| None)[..2], [1.0, 2.0]);
            assert_ne!(eliminate(&order, &[4.0, 1.0, 2.0], &[-8.0, -6.0], |_, _| None)[..2], [1.0, 2.0]);
        }
        // a singular one is seen at its last pivot
        assert_eq!(eliminate(&[0, 1], &[1.0, 1.0, 1.0], &[1.0, 2.0], |_, _| None)[4], 0.0);
    }
}
