//! Lagrange multipliers: coordinates λ whose velocities do not occur in L, and which multiply constraints, L + λ f(q, t).
//!
//! The equation of motion of λ is ∂L/∂λ = f = 0, so the mass matrix is singular and λ has no acceleration. But f̈ = 0 along the
//! motion, and with M a + h = λ ∂f/∂q this is a linear system for the accelerations and for λ itself. A state that obeys f = 0
//! and ḟ = 0 then obeys f = 0 at all times.
//!
//! Sign: the force of the constraint is + λ ∂f/∂q, as follows from L + λ f.
//!
//! A constraint g(t, q, q̇) = 0 may also stand beside L, and must if it cannot be integrated. Its force is + λ ∂g/∂q̇ (Lagrange–d'Alembert), and
//! ġ = 0 completes the linear system. L + λ g would give another motion, which no rolling body has.

use num_dual::Dual;
use num_traits::One;

use super::layout::Layout;
use crate::Result;
use crate::mechanics::tape::Tape;
use crate::scalar::{Graph, Number, Series, Symbol, TERMS, each, up_to};

/// The multipliers of a system and their constraints.
pub(super) struct Multipliers {
    /// Their places among the coordinates.
    pub places: Vec<usize>,
    /// For each multiplier ∂f/∂q by each coordinate, then f̈ along a motion without accelerations; or ∂g/∂q̇, then ġ.
    constraints: Tape,
    /// Whether each constraint stands beside L.
    beside: Vec<bool>,
}

impl Multipliers {
    /// The multipliers of a Lagrangian, from tapes of ∂L/∂q and ∂L/∂q̇; `None`, if it has none. A coordinate without velocity in L is
    /// a multiplier if L is linear in it, and if its factor contains no velocity. `beside` are the multipliers of constraints beside L, and `rolling` has
    /// their formulas.
    ///
    /// # Errors
    /// When L branches on a value.
    pub fn of(
        layout: Layout,
        forces: &Tape,
        momenta: &Tape,
        (beside, rolling): &(Vec<usize>, Tape),
    ) -> Result<Option<Self>> {
        let n = layout.coordinates;
        let inputs = || (0..layout.inputs()).map(Symbol::input).collect::<Vec<Symbol>>();
        let is_zero = |value: &Symbol| value.as_constant() == Some(0.0);
        let (_, places) = Graph::record(|| {
            let momenta = momenta.evaluate(&inputs());
            (0..n).filter(|&k| is_zero(&momenta[k])).collect::<Vec<_>>()
        })?;
        if places.is_empty() {
            return Ok(None);
        }
        let along = |tape: &Tape, direction: &[(usize, Symbol)]| {
            let mut at: Vec<_> = inputs().into_iter().map(Dual::from_re).collect();
            direction.iter().for_each(|&(input, component)| at[input].eps = component);
            tape.evaluate(&at).into_iter().map(|value| value.eps).collect::<Vec<Symbol>>()
        };
        let motion = || -> Vec<(usize, Symbol)> {
            let rates = (0..n).map(|i| (layout.q(i), inputs()[layout.v(i)]));
            std::iter::once((0, Symbol::one())).chain(rates).collect()
        };
        let tape = |graph: &Graph, outputs: &[Symbol]| Tape::new(graph, layout.inputs(), outputs);
        let (graph, rates) = Graph::record(|| along(forces, &motion()))?;
        let rates = tape(&graph, &rates);
        let (graph, (outputs, fits)) = Graph::record(|| {
            let bias = along(&rates, &motion());
            let slopes: Vec<Vec<Symbol>> = (0..n).map(|i| along(forces, &[(layout.q(i), Symbol::one())])).collect();
            let by_velocity: Vec<Vec<Symbol>> =
                (0..n).map(|i| along(forces, &[(layout.v(i), Symbol::one())])).collect();
            let in_lagrangian = || places.iter().filter(|k| !beside.contains(k));
            let fits = in_lagrangian().all(|&k| {
                by_velocity.iter().all(|slopes| is_zero(&slopes[k])) && places.iter().all(|&l| is_zero(&slopes[l][k]))
            });
            let rates = along(rolling, &motion());
            let rolls: Vec<Vec<Symbol>> = (0..n).map(|i| along(rolling, &[(layout.v(i), Symbol::one())])).collect();
            let row = |&k: &usize| -> Vec<Symbol> {
                match beside.iter().position(|place| *place == k) {
                    Some(at) => rolls.iter().map(|slopes| slopes[at]).chain([rates[at]]).collect(),
                    None => slopes.iter().map(|slopes| slopes[k]).chain([bias[k]]).collect(),
                }
            };
            (places.iter().flat_map(row).collect::<Vec<_>>(), fits)
        })?;
        let beside = places.iter().map(|place| beside.contains(place)).collect();
        Ok(fits.then(|| Multipliers { constraints: tape(&graph, &outputs), places, beside }))
    }

    /// The forces λ ∂g/∂q̇ of the constraints beside L, one for each coordinate.
    pub fn forces<D: Number>(&self, layout: Layout, inputs: &[D]) -> Vec<D> {
        let n = layout.coordinates;
        let rows = self.constraints.evaluate(inputs);
        let beside = self.places.iter().zip(rows.chunks(n + 1)).zip(&self.beside).filter(|(_, beside)| **beside);
        beside.fold(vec![D::zero(); n], |sum, ((&k, row), _)| {
            sum.iter().zip(row).map(|(&sum, &slope)| sum + inputs[layout.q(k)] * slope).collect()
        })
    }

    /// The inputs of the tapes with all multipliers 0.
    pub fn without<D: Number>(&self, layout: Layout, mut inputs: Vec<D>) -> Vec<D> {
        for &k in &self.places {
            inputs[layout.q(k)] = D::zero();
        }
        inputs
    }

    /// Completes the linear system for the accelerations, of which `mass` and `right` are the equations without multipliers:
    /// the unknown in the place of a multiplier is its value.
    pub fn complete<D: Number>(&self, inputs: &[D], mass: &mut nalgebra::DMatrix<D>, right: &mut [D]) {
        let n = right.len();
        let rows = self.constraints.evaluate(inputs);
        for (&k, row) in self.places.iter().zip(rows.chunks(n + 1)) {
            for (i, &slope) in row[..n].iter().enumerate() {
                (mass[(k, i)], mass[(i, k)]) = (slope, -slope);
            }
            right[k] = -row[n];
        }
    }

    /// Taylor's recursion as in `motion::complete`, where the solution has a multiplier itself in the place of its acceleration.
    ///
    /// # Errors
    /// Those of `solve`.
    pub fn motion<D: Number>(
        &self,
        q: &[D],
        v: &[D],
        order: usize,
        solve: impl Fn(&[Series<D>], &[Series<D>], usize) -> Result<Vec<Series<D>>>,
    ) -> Result<Vec<Series<D>>> {
        let is_multiplier = |k: usize| self.places.contains(&k);
        let start = |k: usize| if is_multiplier(k) { vec![D::zero(), D::zero()] } else { vec![q[k], v[k]] };
        let mut derivatives: Vec<Vec<D>> = up_to(q.len(), &mut { start });
        let mut multipliers: Vec<Vec<D>> = vec![Vec::new(); q.len()];
        for known in 2..=(order + 2).min(TERMS - 1) {
            let q = each(&derivatives, &|known| Series::from_derivatives(known));
            let v = each(&q, &Series::derivative);
            let q = each(&q, &|q| q.truncated(known - 1));
            for (k, value) in solve(&q, &v, known)?.iter().enumerate() {
                let value = value.nth_derivative_value(known - 2).unwrap_or(D::from(f64::NAN));
                match is_multiplier(k) {
                    true => {
                        multipliers[k].push(value);
                        derivatives[k].push(D::zero());
                    }
                    false => derivatives[k].push(value),
                }
            }
        }
        let all = (0..q.len()).map(|k| if is_multiplier(k) { &multipliers[k] } else { &derivatives[k] });
        Ok(all.map(|known| Series::from_derivatives(&known[..known.len().min(order + 1)])).collect())
    }
}
