//! From a Lagrangian to tapes: it is run once over symbols, then differentiated by running what was recorded over
//! num-dual's numbers whose parts are symbols.

use num_dual::{Dual, HyperDual};
use num_traits::One;

use super::rotations::Turning;
use super::tape::Tape;
use super::{Lagrangian, State};
use crate::Result;
use crate::scalar::{Graph, Number, Symbol, simplify_all};

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

/// Traces `l`.
///
/// # Errors
/// When it branches on a value.
pub(super) fn trace<L: Lagrangian<N, P>, const N: usize, const P: usize>(l: &L) -> Result<Traced> {
    let layout = Layout { coordinates: N, parameters: P };
    let tape = |graph: &Graph, outputs: &[Symbol]| Tape::new(graph, layout.inputs(), outputs);

    let (graph, (lagrangian, potential, turning)) = Graph::record(|| {
        let at = State {
            time: Symbol::input(0),
            q: std::array::from_fn(|i| Symbol::input(layout.q(i))),
            v: std::array::from_fn(|i| Symbol::input(layout.v(i))),
            parameters: std::array::from_fn(|i| Symbol::input(1 + 2 * N + i)),
        };
        let turning = Turning::of(l, &at).map(|turning| {
            let rows = turning.orientation.transpose();
            rows.iter().chain(&turning.angular_velocity).chain(&turning.body_rates).copied().collect::<Vec<_>>()
        });
        let potential = l.potential_energy(&at).map(|u| vec![u]);
        let simple = |outputs: Option<Vec<Symbol>>| outputs.map(|outputs| simplify_all(&outputs));
        (simplify_all(&[l.lagrangian(&at)]), simple(potential), simple(turning))
    })?;
    let lagrangian = tape(&graph, &lagrangian);
    let potential = potential.map(|outputs| tape(&graph, &outputs));
    let turning = turning.map(|outputs| tape(&graph, &outputs));

    let (graph, derived) = Graph::record(|| {
        let inputs: Vec<Symbol> = (0..layout.inputs()).map(Symbol::input).collect();
        let derived = Derived::new(layout, &lagrangian, &inputs);
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
        let accelerations = eliminate(N, &derived.mass, &derived.bias);
        let cyclic = derived.forces.iter().map(|force| force.as_constant() == Some(0.0)).collect();
        (quantities, momenta_and_mass, dynamics, accelerations, cyclic)
    })?;
    let (quantities, momenta_and_mass, dynamics, accelerations, certainly_cyclic) = derived;
    Ok(Traced {
        quantities: tape(&graph, &quantities),
        momenta_and_mass: tape(&graph, &momenta_and_mass),
        dynamics: tape(&graph, &dynamics),
        accelerations: tape(&graph, &accelerations),
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
    fn new(layout: Layout, lagrangian: &Tape, inputs: &[Symbol]) -> Self {
        let n = layout.coordinates;
        let value = lagrangian.evaluate(inputs)[0];
        let forces: Vec<Symbol> = (0..n)
            .map(|i| {
                let mut along: Vec<_> = inputs.iter().copied().map(Dual::from_re).collect();
                along[layout.q(i)].eps = Symbol::one();
                lagrangian.evaluate(&along)[0].eps
            })
            .collect();
        let (mut momenta, mut bias) = (Vec::new(), Vec::new());
        for (i, &force) in forces.iter().enumerate() {
            // the second direction is that of the motion without acceleration
            let mut along: Vec<_> = inputs.iter().copied().map(HyperDual::from_re).collect();
            along[layout.v(i)].eps1 = Symbol::one();
            along[0].eps2 = Symbol::one();
            for j in 0..n {
                along[layout.q(j)].eps2 = inputs[layout.v(j)];
            }
            let l = lagrangian.evaluate(&along)[0];
            momenta.push(l.eps1);
            bias.push(l.eps1eps2 - force);
        }
        let mut mass = Vec::new();
        for i in 0..n {
            for j in i..n {
                let mut along: Vec<_> = inputs.iter().copied().map(HyperDual::from_re).collect();
                along[layout.v(i)].eps1 = Symbol::one();
                along[layout.v(j)].eps2 = Symbol::one();
                mass.push(lagrangian.evaluate(&along)[0].eps1eps2);
            }
        }
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

/// Solves M a = −h for a symmetric M as L D Lᵀ, without exchanging rows: good enough for nearly all mass matrices,
/// and whoever uses the result looks at the pivots first. Outputs a, then the pairs (pivot, its diagonal entry).
fn eliminate<D: Number>(n: usize, mass: &[D], bias: &[D]) -> Vec<D> {
    let m = |i, j| mass[upper(n, i, j)];
    let mut factor = vec![vec![D::zero(); n]; n];
    let mut pivot: Vec<D> = Vec::with_capacity(n);
    let mut inverse: Vec<D> = Vec::with_capacity(n);
    for k in 0..n {
        let taken = |i: usize, k: usize, factor: &[Vec<D>], pivot: &[D]| {
            (0..k).map(|j| factor[i][j] * factor[k][j] * pivot[j]).fold(D::zero(), |sum, term| sum + term)
        };
        pivot.push(m(k, k) - taken(k, k, &factor, &pivot));
        inverse.push(pivot[k].recip());
        for i in k + 1..n {
            factor[i][k] = (m(i, k) - taken(i, k, &factor, &pivot)) * inverse[k];
        }
    }
    let mut a: Vec<D> = bias.iter().map(|&h| -h).collect();
    for i in 0..n {
        for j in 0..i {
            a[i] = a[i] - factor[i][j] * a[j];
        }
    }
    for i in 0..n {
        a[i] *= inverse[i];
    }
    for i in (0..n).rev() {
        for j in i + 1..n {
            a[i] = a[i] - factor[j][i] * a[j];
        }
    }
    a.extend((0..n).flat_map(|k| [pivot[k], m(k, k)]));
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
        assert_eq!(eliminate(2, &[4.0, 2.0, 3.0], &[-8.0, -7.0]), [1.25, 1.5, 4.0, 4.0, 2.0, 3.0]);
        // a singular one is seen at its last pivot
        assert_eq!(eliminate(2, &[1.0, 1.0, 1.0], &[1.0, 2.0])[4], 0.0);
    }
}
