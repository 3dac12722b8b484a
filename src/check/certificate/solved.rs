//! Hypotheses over a prime field, solved exactly: each for a number in which it is linear, with a unique solution.
//!
//! A·s + B = 0 has the one solution s = −B/A, unless A and B have a common factor: (x − y)(z − 1) = 0 is solved by x =
//! y, and by z = 1 with x and y free. So the zeros of the *slope* A are examined. If A vanishes nowhere in the declared
//! ranges, the hypothesis is an equation for s. If A vanishes where B does not, the two have no common factor, and the
//! solutions are irreducible. A further hypothesis could make them reducible, so none may follow. A claim with an
//! unclear case is not certified. If the components of a vector hypothesis cannot be solved one by one, they are solved
//! together for those of another vector; then A is the determinant of their slopes.

use nalgebra::Vector3;
use std::cell::RefCell;
use std::marker::PhantomData;

use crate::formula::SymbolId;
use crate::mechanics::LinearSolver;
use crate::notes::claims::Range;
use crate::scalar::prime_field::Modulus;
use crate::scalar::{Modular, cross, dot};

use crate::check::model::sampling::Spread;
use crate::check::model::state_cache::Row;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::Sampler;
use crate::check::state::generic_body::{Generality, GenericBody};
use crate::check::state::numbers;
use crate::check::state::numbers::Slot;
use crate::check::state::sampled_state::SampledState;

/// Hypotheses that are sums over members, by their places, and the families for which they are solved.
#[derive(Default)]
pub(crate) struct SumHypotheses {
    pub hypotheses: Vec<usize>,
    pub families: Vec<SymbolId>,
}

pub(crate) const NOT_SOLVED: &str = "hypotheses that cannot be solved exactly, because they are linear in no symbol";

/// The reason for which a claim stays open if only one solution of its hypotheses was tested.
pub(crate) const OTHER_WAYS: &str = "hypotheses that may have more than one solution";

/// The determinant of a 1 × 1 or 3 × 3 matrix, given by columns.
pub(crate) fn determinant<F: Modulus>(columns: &[Vec<Modular<F>>]) -> Modular<F> {
    let vector = |column: &Vec<Modular<F>>| Vector3::new(column[0], column[1], column[2]);
    match columns {
        [a, b, c] => dot(&cross(&vector(a), &vector(b)), &vector(c)),
        columns => columns[0][0],
    }
}

/// Makes three numbers the components of a unit vector, by the stereographic projection of the first two.
fn unit_vector<F: Modulus>(direction: &mut [Modular<F>]) {
    let [x, y, z] = direction else { return };
    let (a, b) = (*x, *y);
    let square = a * a + b * b;
    let length = square + 1.0;
    (*x, *y, *z) = (a * 2.0 / length, b * 2.0 / length, (-square + 1.0) / length);
}

/// States at points of the field at which the hypotheses hold exactly.
pub(crate) struct Solved<'s, 'm, F> {
    pub(crate) projection: &'s Projection<'m>,
    /// The values of integers, by their places in a base.
    whole: Vec<(usize, f64)>,
    /// The steps of the solution.
    pub(crate) plan: Vec<Step>,
    /// Whether the slope of the last step may vanish.
    pub(crate) may_vanish: bool,
    /// Whether the states must obey the hypotheses.
    pub(crate) obeys: bool,
    /// The generic body in place of particles whose principal axes occur in the claim.
    generality: Generality,
    /// A generic base of floating-point numbers, which obeys no hypothesis.
    pub(crate) anywhere: Vec<f64>,
    /// For each row that was examined, whether it is independent of each number.
    idle: RefCell<Vec<(Row, Vec<bool>)>>,
    field: PhantomData<F>,
}

/// A row with the number for which it is solved, or the three rows of a vector with three numbers.
#[derive(Clone)]
pub(crate) struct Step {
    pub(crate) rows: Vec<Row>,
    pub(crate) slots: Vec<usize>,
}

impl<'s, 'm, F: Modulus> Solved<'s, 'm, F> {
    /// States that obey no hypotheses.
    pub fn without_hypotheses(projection: &'s Projection<'m>, whole: Vec<(usize, f64)>) -> Self {
        let mut anywhere = Sampler::new(1, "anywhere").draw_base(&projection.slots, Spread::Declared);
        whole.iter().for_each(|(at, value)| anywhere[*at] = *value);
        let (plan, idle) = (Vec::new(), RefCell::default());
        Solved {
            projection,
            whole,
            plan,
            may_vanish: false,
            obeys: false,
            generality: Generality::GivenParticles,
            anywhere,
            idle,
            field: PhantomData,
        }
    }

    /// The same states with a generic body in place of particles.
    pub fn with(self, generality: Generality) -> Self {
        Solved { generality, ..self }
    }

    /// Whether no hypothesis had to be solved.
    pub fn is_free(&self) -> bool {
        self.plan.is_empty()
    }

    /// Whether the hypotheses that are sums over members are solved for numbers of these families, and no others are
    /// solved for numbers of other families.
    pub fn moves(&self, sums: &SumHypotheses) -> bool {
        let Projection { model, slots, .. } = self.projection;
        let is_known = |at: &usize| slots[*at].symbol.is_some_and(|id| sums.families.contains(&id));
        let is_single = |at: &usize| slots[*at].symbol.is_none_or(|id| model.symbols.entry(id).slots.is_empty());
        let is_sum = |step: &Step| sums.hypotheses.contains(&step.rows[0].0);
        let moves = |step: &Step| step.slots.iter().all(|at| is_known(at) || !is_sum(step) && is_single(at));
        sums.hypotheses.is_empty() || self.plan.iter().all(moves)
    }

    /// A random state at the current point of the field.
    pub fn draw_state(&self) -> Result<SampledState<'m, Modular<F>>, String> {
        let mut base = self.drawn();
        // The rows must be linear at every point, so that the solution is unique.
        for step in &self.plan {
            self.put_if_linear(&mut base, step)?.ok_or(NOT_SOLVED)?;
        }
        let mut state = self.state(&base)?;
        state.set_body(GenericBody::drawn(self.generality));
        if !self.obeys {
            return Ok(state);
        }
        let rows = self.projection.rows(&state);
        if rows.iter().all(|(_, value)| value.vanishes()) { Ok(state) } else { Err(NOT_SOLVED.to_owned()) }
    }

    pub(crate) fn drawn_at(&self, at: usize) -> Modular<F> {
        if let Some((_, value)) = self.whole.iter().find(|(known, _)| *known == at) {
            return Modular::from(*value);
        }
        match &self.projection.slots[at] {
            Slot { range: Range::Integer { low, .. }, .. } => Modular::from(*low as f64),
            // Velocities need no sine and cosine.
            slot if slot.order > 0 => Modular::random_plain(),
            _ => Modular::random(),
        }
    }

    pub(crate) fn drawn(&self) -> Vec<Modular<F>> {
        let mut base: Vec<Modular<F>> = (0..self.projection.slots.len()).map(|at| self.drawn_at(at)).collect();
        if let Some(direction) = numbers::direction(self.projection.model) {
            unit_vector(&mut base[direction.clone()]);
            // ω is computed from R and Ṙ as long polynomials; its simple form is known.
            let rate = self.projection.slots.iter().rposition(|slot| slot.order == 1 && slot.symbol.is_none());
            for component in direction {
                base[component].remembered();
                if let Some(rate) = rate {
                    (base[component] * base[rate]).remembered();
                }
            }
        }
        base
    }

    pub(crate) fn state(&self, base: &[Modular<F>]) -> Result<SampledState<'m, Modular<F>>, String> {
        let terms = self.projection.mode.order + 1;
        self.projection.state_by(LinearSolver::CramersRule, base, terms).map_err(|error| error.message().to_owned())
    }

    pub(crate) fn values(&self, base: &[Modular<F>], rows: &[Row]) -> Result<Vec<Modular<F>>, String> {
        Ok(self.projection.values(&self.state(base)?, rows).ok_or(NOT_SOLVED)?)
    }

    /// Solves the steps of the plan for a base, one after the other.
    pub(crate) fn follow(&self, base: &mut [Modular<F>]) -> Result<(), String> {
        for step in &self.plan {
            self.put(base, step)?.ok_or(NOT_SOLVED)?;
        }
        Ok(())
    }

    /// The slopes: for each number of the step the changes of all rows when it changes by 1.
    pub(crate) fn slopes(
        &self,
        base: &[Modular<F>],
        step: &Step,
        zero: &[Modular<F>],
    ) -> Result<Vec<Vec<Modular<F>>>, String> {
        let along = |slot: &usize| {
            let mut next = base.to_vec();
            next[*slot] += 1.0;
            Ok(self.values(&next, &step.rows)?.iter().zip(zero).map(|(one, zero)| *one - *zero).collect())
        };
        step.slots.iter().map(along).collect()
    }

    /// Solves the rows of a step, which are linear; returns the determinant of the slopes, or `None` if it vanishes.
    fn put(&self, base: &mut [Modular<F>], step: &Step) -> Result<Option<Modular<F>>, String> {
        let zero = self.values(base, &step.rows)?;
        let slopes = self.slopes(base, step, &zero)?;
        Ok(self.put_by(base, step, (&zero, &slopes)))
    }

    /// Solves rows with these values and slopes by Cramer's rule.
    pub(crate) fn put_by(
        &self,
        base: &mut [Modular<F>],
        step: &Step,
        (zero, slopes): (&Vec<Modular<F>>, &[Vec<Modular<F>>]),
    ) -> Option<Modular<F>> {
        let slope = determinant(slopes);
        // A row is independent of most numbers.
        if slope.vanishes() {
            return None;
        }
        for (at, slot) in step.slots.iter().enumerate() {
            let mut instead = slopes.to_vec();
            instead[at].clone_from(zero);
            base[*slot] -= determinant(&instead) / slope;
        }
        Some(slope)
    }

    /// Whether a row is independent of a number, as found with floating-point numbers.
    pub(crate) fn is_idle(&self, row: Row, slot: usize) -> bool {
        let mut known = self.idle.borrow_mut();
        if !known.iter().any(|(other, _)| *other == row) {
            let slots = 0..self.anywhere.len();
            known.push((row, slots.map(|slot| !self.projection.depends(&self.anywhere, row, slot)).collect()));
        }
        known.iter().any(|(other, idle)| *other == row && idle[slot])
    }

    /// Whether a number may still be solved for.
    pub(crate) fn is_open(&self, slot: usize) -> bool {
        !self.plan.iter().any(|step| step.slots.contains(&slot))
            && !numbers::direction(self.projection.model).is_some_and(|direction| direction.contains(&slot))
            && !matches!(self.projection.slots[slot].range, Range::Integer { .. })
    }

    /// The base with another value of one number, with the plan solved again.
    pub(crate) fn moved(&self, base: &[Modular<F>], at: usize, to: Modular<F>) -> Result<Vec<Modular<F>>, String> {
        let mut moved = base.to_vec();
        moved[at] = to;
        self.follow(&mut moved)?;
        Ok(moved)
    }
}
