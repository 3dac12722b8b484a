//! Hypotheses over a field: each is solved exactly for a number in which it is linear, if that is the only way to
//! meet it.
//!
//! The *slope* is the coefficient A in A·s + B = 0. If it vanishes nowhere in the declared ranges, the hypothesis
//! is an equation for s. If it vanishes only where B does not, the solutions are still of one piece; but a further
//! hypothesis could cut them into several, so no other may follow. What cannot be decided gets no certificate. If a
//! hypothesis is about a vector, its components may be solved for those of another vector together; then A is the
//! determinant of their slopes.
//!
//! A hypothesis that can be met in another way is not solved exactly. A·s + B = 0 means s = −B/A only if A and B
//! have no common factor, as x cos θ = y cos θ has. The slope A must vanish nowhere in the ranges, or, for the last
//! hypothesis that is solved, not together with B. A claim that is an identity without its hypotheses needs none of
//! this.

use nalgebra::Vector3;
use std::cell::RefCell;
use std::marker::PhantomData;

use crate::formula::SymbolId;
use crate::mechanics::LinearSolver;
use crate::notes::claims::Range;
use crate::scalar::Modular;
use crate::scalar::prime_field::Modulus;

use crate::check::model::sampling::Spread;
use crate::check::model::state_cache::Row;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::Sampler;
use crate::check::state::generic_body::{Generality, GenericBody};
use crate::check::state::numbers;
use crate::check::state::numbers::Slot;
use crate::check::state::sampled_state::SampledState;

/// Hypotheses that are sums over members, by their places, and the families that they are solved for.
#[derive(Default)]
pub(crate) struct SumHypotheses {
    pub hypotheses: Vec<usize>,
    pub families: Vec<SymbolId>,
}

pub(crate) const NOT_SOLVED: &str =
    "hypotheses that are not linear in any symbol, so that they cannot be solved exactly";

/// Why a claim stays open of whose hypotheses one solution alone was looked at.
pub(crate) const OTHER_WAYS: &str = "hypotheses that may have more than one solution";

/// The determinant of one number, or of three columns.
pub(crate) fn determinant<F: Modulus>(columns: &[Vec<Modular<F>>]) -> Modular<F> {
    let vector = |column: &Vec<Modular<F>>| Vector3::new(column[0], column[1], column[2]);
    match columns {
        [a, b, c] => vector(a).cross(&vector(b)).dot(&vector(c)),
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
    /// The values of the whole numbers that matter, by their places in a base.
    whole: Vec<(usize, f64)>,
    /// What of the hypotheses is solved for which numbers.
    pub(crate) plan: Vec<Step>,
    /// Whether the slope of the last of them may vanish.
    pub(crate) may_vanish: bool,
    /// Whether the hypotheses hold.
    pub(crate) obeys: bool,
    /// What stands in for particles whose principal axes are stated of; not by the hypotheses.
    generality: Generality,
    /// Numbers that obey no hypothesis: there nothing is at rest by accident.
    pub(crate) anywhere: Vec<f64>,
    /// Of each row that was asked about, the numbers that it does not depend on.
    idle: RefCell<Vec<(Row, Vec<bool>)>>,
    field: PhantomData<F>,
}

/// One row of the hypotheses and the number that it is solved for, or the three of a vector and as many numbers.
#[derive(Clone)]
pub(crate) struct Step {
    pub(crate) rows: Vec<Row>,
    pub(crate) slots: Vec<usize>,
}

impl<'s, 'm, F: Modulus> Solved<'s, 'm, F> {
    /// States that obey no hypotheses.
    pub fn without_hypotheses(projection: &'s Projection<'m>, whole: Vec<(usize, f64)>) -> Self {
        let mut anywhere = Sampler::new(1, "anywhere").base(&projection.slots, Spread::Declared);
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

    /// The same with particles that others stand in for.
    pub fn with(self, generality: Generality) -> Self {
        Solved { generality, ..self }
    }

    /// Whether there was anything to solve.
    pub fn is_free(&self) -> bool {
        self.plan.is_empty()
    }

    /// Whether hypotheses that are sums over members are solved for numbers of these families, and the others for none of
    /// other families.
    pub fn moves(&self, sums: &SumHypotheses) -> bool {
        let Projection { model, slots, .. } = self.projection;
        let is_known = |at: &usize| slots[*at].symbol.is_some_and(|id| sums.families.contains(&id));
        let is_single = |at: &usize| slots[*at].symbol.is_none_or(|id| model.symbols.entry(id).slots.is_empty());
        let is_sum = |step: &Step| sums.hypotheses.contains(&step.rows[0].0);
        let moves = |step: &Step| step.slots.iter().all(|at| is_known(at) || !is_sum(step) && is_single(at));
        sums.hypotheses.is_empty() || self.plan.iter().all(moves)
    }

    /// The state at the point at hand.
    pub fn draw_state(&self) -> Result<SampledState<'m, Modular<F>>, String> {
        let mut base = self.drawn();
        // That the rows are linear, so that this is the only way, is seen at every point anew.
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
            // nobody takes the sine of a velocity
            slot if slot.order > 0 => Modular::random_plain(),
            _ => Modular::random(),
        }
    }

    pub(crate) fn drawn(&self) -> Vec<Modular<F>> {
        let mut base: Vec<Modular<F>> = (0..self.projection.slots.len()).map(|at| self.drawn_at(at)).collect();
        if let Some(direction) = numbers::direction(self.projection.model) {
            unit_vector(&mut base[direction.clone()]);
            // ω comes from R and Ṙ, as long polynomials; it is no accident that it is this
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

    /// Moves a base so that all that is planned holds, one after the other.
    pub(crate) fn follow(&self, base: &mut [Modular<F>]) -> Result<(), String> {
        for step in &self.plan {
            self.put(base, step)?.ok_or(NOT_SOLVED)?;
        }
        Ok(())
    }

    /// What rows change by as one number after the other changes by 1: for each number the changes of all rows.
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

    /// Moves numbers of the base so that rows vanish that are linear in them, if they are independent; the determinant of
    /// their slopes.
    fn put(&self, base: &mut [Modular<F>], step: &Step) -> Result<Option<Modular<F>>, String> {
        let zero = self.values(base, &step.rows)?;
        let slopes = self.slopes(base, step, &zero)?;
        Ok(self.put_by(base, step, (&zero, &slopes)))
    }

    /// The same for rows of which these are the values and slopes.
    pub(crate) fn put_by(
        &self,
        base: &mut [Modular<F>],
        step: &Step,
        (zero, slopes): (&Vec<Modular<F>>, &[Vec<Modular<F>>]),
    ) -> Option<Modular<F>> {
        let slope = determinant(slopes);
        // most numbers have nothing to do with a row
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

    /// Whether a row has nothing to do with a number; doubles tell that at once.
    pub(crate) fn is_idle(&self, row: Row, slot: usize) -> bool {
        let mut known = self.idle.borrow_mut();
        if !known.iter().any(|(other, _)| *other == row) {
            let slots = 0..self.anywhere.len();
            known.push((row, slots.map(|slot| !self.projection.depends(&self.anywhere, row, slot)).collect()));
        }
        known.iter().any(|(other, idle)| *other == row && idle[slot])
    }

    /// Whether a number can still be moved.
    pub(crate) fn is_open(&self, slot: usize) -> bool {
        !self.plan.iter().any(|step| step.slots.contains(&slot))
            && !numbers::direction(self.projection.model).is_some_and(|direction| direction.contains(&slot))
            && !matches!(self.projection.slots[slot].range, Range::Integer { .. })
    }

    /// The base with another value for one number, on what is planned.
    pub(crate) fn moved(&self, base: &[Modular<F>], at: usize, to: Modular<F>) -> Result<Vec<Modular<F>>, String> {
        let mut moved = base.to_vec();
        moved[at] = to;
        self.follow(&mut moved)?;
        Ok(moved)
    }
}
