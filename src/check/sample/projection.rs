//! Constraint projection: the numbers of a state are changed until the hypotheses of a claim hold.
//!
//! Which hypothesis is solved for which number is the *plan*. It is found at the first state that works, by
//! pivoting, and kept for the others.
//!
//! # How hypotheses are met
//!
//! Rejecting states cannot meet an equality. Each equality is solved for one number of the state by Newton's
//! method, with derivatives from dual numbers. Pivoting chooses the number: higher derivatives before velocities
//! before coordinates before constants; within a class a number in which the equality is linear first; and only
//! where the Jacobian of all equalities together stays regular. `throughout` adds the time derivatives of the
//! hypothesis as rows; one that vanishes by itself needs no number. A number that is declared not to vanish and
//! would have to comes last: at rest sin θ is 0 and not g. Inequalities select. Every state is tested against all
//! hypotheses before it is used. So (6.74) is checked from "θ̇ = 0 at all times" alone: that θ̈ = 0 then fixes a
//! second velocity is found. If no motion obeys the hypotheses, the claim is `undecided`, also if it is false off
//! shell, since a state that is no motion refutes nothing about motions.

use nalgebra::{DMatrix, DVector};
use num_dual::Dual64;
use std::sync::Arc;

use crate::formula::{Expr, Node, Relation};
use crate::mechanics::LinearSolver;
use crate::scalar::{Number, RunningError, Series};
use crate::{Error, Result};

use crate::check::hypotheses::explicit::rules;
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::order::{derivatives, order};
use crate::check::model::states::{Mode, Progress, Reach, Row};
use crate::check::sample::hypothesis_residual::{THROUGHOUT, difference, difference_to};
use crate::check::sample::sampler::contains;
use crate::check::sample::setting::Setting;
use crate::check::state::numbers::{Layout, Slot, slots};
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;

/// After so many bases none of which could be moved onto the hypotheses no more are tried.
const GIVEN_UP: usize = 12;

/// So many steps of Newton's are made to move a base, and so many in a row that are not shorter by this than any before.
const MOST_ROUNDS: usize = 30;

const MOST_STALLED: usize = 5;

const SHORTER: f64 = 0.9;

/// Steps below this may be rounding where the rows are large.
const ROUNDED: f64 = 1e-9;

/// So many equations are solved at most; hypotheses about whole families are rules instead.
const MOST: usize = 24;

/// How states are moved onto the hypotheses of a claim.
pub struct Projection<'m> {
    pub(crate) model: &'m Model,
    pub(crate) mode: Mode,
    reach: Reach,
    pub(crate) hypotheses: Vec<Hypothesis>,
    /// Which of the hypotheses are rules, and so need no solving.
    explicit: Vec<bool>,
    pub(crate) rules: Arc<[Rule]>,
    /// What a base consists of.
    pub(crate) slots: Vec<Slot>,
    pub(crate) progress: Progress,
    /// How many derivatives the hypotheses need that are solved.
    terms: usize,
    layout: Arc<Layout>,
}

/// A base that was moved onto the equalities, as a state, and the hypotheses that are known to hold there.
struct Moved<'m> {
    base: Vec<f64>,
    state: SampledState<'m, RunningError>,
    obeys: Vec<usize>,
}

impl<'m> Projection<'m> {
    /// For states that obey a setting.
    pub(crate) fn new(model: &'m Model, setting: &Setting<'_>) -> Self {
        let mode = setting.mode;
        let mut hypotheses = setting.hypotheses.to_vec();
        if mode.on_shell {
            hypotheses.extend(model.laws.iter().flat_map(|law| law.hypotheses.iter().cloned()));
        }
        let (found, explicit) = rules(model, setting.local, &hypotheses);
        let slots = slots(model, mode);
        let (rules, terms) = (found.into(), 0);
        let mut projection = Projection {
            model,
            mode,
            reach: setting.reach,
            hypotheses,
            explicit,
            rules,
            slots,
            progress: Progress::default(),
            terms,
            layout: Layout::of(model, mode),
        };
        projection.terms = projection.needed();
        projection
    }

    /// Which of the hypotheses are rules.
    pub(crate) fn explicit(&self) -> &[bool] {
        &self.explicit
    }

    /// The hypotheses that are solved.
    pub(crate) fn equalities(&self) -> impl Iterator<Item = (usize, &Hypothesis)> {
        let is_equality = |c: &Hypothesis| matches!(c.relation, Relation::Equal | Relation::Identical);
        self.hypotheses.iter().enumerate().filter(move |(at, c)| is_equality(c) && !self.explicit[*at])
    }

    /// The values of rows over any number; `None` where one has none. Each hypothesis is evaluated once.
    pub(crate) fn values<B: Number>(&self, state: &SampledState<'m, B>, rows: &[Row]) -> Option<Vec<B>> {
        let mut known: Vec<(usize, Vec<Series<B>>)> = Vec::new();
        let mut values = Vec::with_capacity(rows.len());
        for (at, derivative, entry) in rows {
            if !known.iter().any(|(hypothesis, _)| hypothesis == at) {
                let (mut terms, mut entries) = (0, 0);
                for (_, derivative, entry) in rows.iter().filter(|(hypothesis, ..)| hypothesis == at) {
                    (terms, entries) = (terms.max(derivative + 1), entries.max(entry + 1));
                }
                known.push((*at, difference_to((terms, entries), state, &self.hypotheses[*at]).ok()?));
            }
            let (_, entries) = known.iter().find(|(hypothesis, _)| hypothesis == at)?;
            values.push(entries.get(*entry)?.nth_derivative_value(*derivative)?);
        }
        Some(values)
    }

    /// Whether a number of a base may have a value.
    pub(crate) fn allows(&self, slot: usize, value: f64) -> bool {
        self.reach == Reach::Beyond || contains(&self.slots[slot].range, value)
    }

    /// Where a quantity stands in a base, if it is a number of it that no rule gives.
    pub(crate) fn place(&self, quantity: &Expr) -> Option<usize> {
        let Node::Symbol { id, indices, dots } = &quantity.node else { return None };
        let is_free = |rule: &Rule| match &rule.action {
            Action::Follows { order, .. } => dots < order,
            Action::Together(laws) => laws.unknowns.iter().all(|(symbol, order)| symbol != id || dots < order),
            _ => false,
        };
        let is_it = |slot: &Slot| slot.symbol == Some(*id) && !slot.one_of_many && slot.order == usize::from(*dots);
        let at = self.slots.iter().position(is_it).filter(|_| indices.is_empty())?;
        self.rules.iter().filter(|rule| rule.symbol == *id).all(is_free).then_some(at)
    }

    fn state<B: Number>(&self, base: &[B], terms: usize) -> Result<SampledState<'m, B>> {
        self.state_by(LinearSolver::PartialPivoting, base, terms)
    }

    /// The state of a base, the mass matrix inverted in the given way.
    pub(crate) fn state_by<B: Number>(
        &self,
        solver: LinearSolver,
        base: &[B],
        terms: usize,
    ) -> Result<SampledState<'m, B>> {
        let state = SampledState::by(solver, terms, self.model, self.mode, (&self.layout, base), &self.rules)?;
        let joined = state.join();
        joined.map_err(|_| Error::new("families that are joined must be families of one label"))?;
        Ok(state)
    }

    /// The state near a base at which every hypothesis holds, if there is one.
    pub(crate) fn project(&mut self, base: Vec<f64>) -> Result<Option<(Vec<f64>, SampledState<'m, RunningError>)>> {
        let Some(Moved { base, state, obeys }) = self.solve(base)? else {
            self.progress.moved.0 += 1;
            // To look further costs more the less there is to be found.
            self.progress.hopeless |= self.progress.moved.1 == 0 && self.progress.moved.0 == GIVEN_UP;
            return Ok(None);
        };
        self.progress.moved.1 += 1;
        Ok(self.accepts(&state, &obeys).then_some((base, state)))
    }

    /// Moves a base onto the equalities.
    fn solve(&mut self, mut base: Vec<f64>) -> Result<Option<Moved<'m>>> {
        if self.equalities().next().is_none() {
            let state = self.measured(&base)?;
            return Ok(Some(Moved { base, state, obeys: Vec::new() }));
        }
        let drawn = base.clone();
        if self.progress.plan.is_empty() {
            let state = self.measured(&base)?;
            return self.complete(base, state);
        }
        if let Some(state) = self.newton(&mut base, &self.progress.plan)? {
            return self.complete(base, state);
        }
        // Another number of particles may want another plan.
        let known = std::mem::take(&mut self.progress.plan);
        let state = self.measured(&drawn)?;
        let solved = self.complete(drawn, state);
        if !matches!(solved, Ok(Some(_))) {
            self.progress.plan = known;
        }
        solved
    }

    /// Solves the rows that are not planned yet, from a base that obeys those that are.
    fn complete(&mut self, mut base: Vec<f64>, mut state: SampledState<'m, RunningError>) -> Result<Option<Moved<'m>>> {
        let rows = self.rows(&state);
        if rows.len() > MOST {
            self.progress.hopeless = true;
            return Ok(None);
        }
        let mut obeys = self.obeyed(&rows);
        for (row, mut value) in rows {
            if self.progress.plan.iter().any(|(planned, _)| *planned == row) {
                continue;
            }
            // What was moved for a row before this one may have moved the others.
            if obeys.is_empty() {
                let Some(values) = self.values(&state, &[row]) else { return Ok(None) };
                value = values[0];
            }
            if residual::vanishes(value) {
                continue;
            }
            let Some(slot) = self.pivot(&base, row)? else { return Ok(None) };
            let mut plan = self.progress.plan.clone();
            plan.push((row, slot));
            let Some(moved) = self.newton(&mut base, &plan)? else { return Ok(None) };
            (state, obeys) = (moved, Vec::new());
            self.progress.plan = plan;
        }
        Ok(Some(Moved { base, state, obeys }))
    }

    /// The hypotheses all of whose rows vanish.
    fn obeyed(&self, rows: &[(Row, RunningError)]) -> Vec<usize> {
        let of = |at: usize| rows.iter().filter(move |(row, _)| row.0 == at).map(|(_, value)| *value);
        let vanish = |at: &usize| of(*at).next().is_some() && of(*at).all(residual::vanishes);
        self.equalities().map(|(at, _)| at).filter(vanish).collect()
    }

    pub(crate) fn measured(&self, base: &[f64]) -> Result<SampledState<'m, RunningError>> {
        let base: Vec<RunningError> = base.iter().map(|x| RunningError::new(*x)).collect();
        self.state(&base, self.mode.order + 1)
    }

    fn needed(&self) -> usize {
        let throughout = self.equalities().any(|(_, hypothesis)| hypothesis.throughout);
        let sides = self.equalities().flat_map(|(_, hypothesis)| [&hypothesis.lhs, &hypothesis.rhs]);
        let highest = sides.map(|side| derivatives(side, self.model)).max().unwrap_or(0);
        // What a rule says a symbol is may have derivatives of its own.
        let said = self.rules.iter().flat_map(|rule| rule.action.formulas());
        let said = said.map(|formula| derivatives(formula, self.model)).max().unwrap_or(0);
        (highest + said + 1 + if throughout { THROUGHOUT } else { 0 }).clamp(2, self.mode.order + 1)
    }

    /// The rows of the hypotheses that are solved, with their values at a state.
    pub(crate) fn rows<B: Number>(&self, state: &SampledState<'m, B>) -> Vec<(Row, B)> {
        let mut rows = Vec::new();
        let differences: Vec<_> = self
            .equalities()
            .map(|(at, hypothesis)| (at, hypothesis, difference(state, hypothesis).unwrap_or_default()))
            .collect();
        for derivative in 0..=THROUGHOUT {
            for (at, hypothesis, entries) in &differences {
                for (entry, value) in entries.iter().enumerate() {
                    if let Some(value) = value.nth_derivative_value(derivative)
                        && (derivative == 0 || hypothesis.throughout)
                    {
                        rows.push(((*at, derivative, entry), value));
                    }
                }
            }
        }
        rows
    }

    /// The slot to solve a row for, besides those of the plan: one in which it is linear, else of the highest class; one
    /// that would have to vanish and may not comes last.
    fn pivot(&self, base: &[f64], row: Row) -> Result<Option<usize>> {
        let class = |slot: &Slot| match (slot.constant, slot.order) {
            (true, _) => 0,
            (false, order) => 1 + order,
        };
        let hypothesis = &self.hypotheses[row.0];
        let sides = [&hypothesis.lhs, &hypothesis.rhs];
        // What nothing but drawn symbols is made of depends on those in it, and on no higher derivatives.
        let moves = self.mode.on_shell && self.model.system.is_some();
        let plain = sides.iter().all(|side| self.model.is_plain(side)) && self.rules.is_empty() && !moves;
        let concerns = |slot: &Slot| {
            let Some(symbol) = slot.symbol else { return !plain };
            let highest = sides.iter().filter_map(|side| order(self.model, side, symbol)).max();
            !plain || highest.is_some_and(|highest| slot.order <= usize::from(highest) + row.1)
        };
        let mut candidates: Vec<usize> = (1..self.slots.len()).collect();
        candidates.retain(|at| !self.progress.plan.iter().any(|(_, taken)| taken == at) && concerns(&self.slots[*at]));
        candidates.sort_by_key(|at| std::cmp::Reverse((class(&self.slots[*at]), *at)));
        let rows: Vec<Row> = self.progress.plan.iter().map(|(row, _)| *row).chain([row]).collect();
        let mut columns = Vec::new();
        for (_, slot) in &self.progress.plan {
            let Some(column) = self.column(base, *slot, &rows)? else { return Ok(None) };
            columns.push(column);
        }
        let n = columns.len();
        let planned = DMatrix::from_fn(n, n, |i, j| columns[j][i].eps);
        let planned = (n > 0).then(|| planned.lu());
        let (mut other, mut outside) = (None, None);
        for slot in candidates {
            let Some(column) = self.column(base, slot, &rows)? else { continue };
            // What the row changes by with the slot while the planned slots keep the planned rows as they are.
            let mut moved = DVector::from_fn(n, |i, _| column[i].eps);
            if planned.as_ref().is_some_and(|planned| !planned.solve_mut(&mut moved)) {
                continue;
            }
            let by_others = || columns.iter().zip(moved.iter()).map(|(other, moved)| other[n].eps * moved);
            let change = column[n].eps - by_others().sum::<f64>();
            let scale = column[n].eps.abs() + by_others().map(f64::abs).sum::<f64>();
            let row_scale = column[n].re.abs() + columns.iter().map(|other| other[n].eps.abs()).sum::<f64>();
            if change.is_nan() || change.abs() <= (1e-7 * scale).max(1e-12 * row_scale) {
                continue;
            }
            if self.is_linear(base, row, slot)? {
                let goes_to = column.last().map_or(base[slot], |value| base[slot] - value.re / value.eps);
                let vanishes = goes_to.abs() <= 1e-9 * base[slot].abs();
                if !vanishes || contains(&self.slots[slot].range, 0.0) {
                    return Ok(Some(slot));
                }
                outside = outside.or(Some(slot));
                continue;
            }
            other = other.or(Some(slot));
        }
        Ok(other.or(outside))
    }

    /// Rows, with their derivatives by a slot.
    fn column(&self, base: &[f64], slot: usize, rows: &[Row]) -> Result<Option<Vec<Dual64>>> {
        let mut dual: Vec<Dual64> = base.iter().map(|x| Dual64::from_re(*x)).collect();
        dual[slot].eps = 1.0;
        let values = self.values(&self.state(&dual, self.terms)?, rows);
        Ok(values.filter(|values| values.iter().all(|value| value.re.is_finite() && value.eps.is_finite())))
    }

    /// Whether the value of a row changes with a number, at a base where nothing keeps it from doing so by accident.
    pub(crate) fn depends(&self, base: &[f64], row: Row, slot: usize) -> bool {
        !matches!(self.column(base, slot, &[row]), Ok(Some(column)) if column.iter().all(|value| value.eps == 0.0))
    }

    fn is_linear(&self, base: &[f64], row: Row, slot: usize) -> Result<bool> {
        let mut values = Vec::new();
        for step in [0.0, 0.5, 1.0] {
            let mut moved = base.to_vec();
            moved[slot] += step;
            let Some(value) = self.values(&self.state(&moved, self.terms)?, &[row]) else { return Ok(false) };
            values.push(value[0]);
        }
        let bend: f64 = values[0] - 2.0 * values[1] + values[2];
        Ok(bend.abs() <= 1e-9 * values.iter().map(|v: &f64| v.abs()).sum::<f64>())
    }

    /// The planned rows and their derivatives by the planned slots.
    fn linearised(&self, base: &[f64], plan: &[(Row, usize)]) -> Result<Option<(DMatrix<f64>, DVector<f64>)>> {
        let n = plan.len();
        let rows: Vec<Row> = plan.iter().map(|(row, _)| *row).collect();
        let (mut jacobian, mut values) = (DMatrix::zeros(n, n), DVector::zeros(n));
        for (j, (_, slot)) in plan.iter().enumerate() {
            let Some(column) = self.column(base, *slot, &rows)? else { return Ok(None) };
            for (i, value) in column.iter().enumerate() {
                jacobian[(i, j)] = value.eps;
                values[i] = value.re;
            }
        }
        Ok(Some((jacobian, values)))
    }

    /// Moves a base until the rows of a plan are as near to 0 as rounding lets them come, if they do; the state there.
    fn newton(&self, base: &mut [f64], plan: &[(Row, usize)]) -> Result<Option<SampledState<'m, RunningError>>> {
        let rows: Vec<Row> = plan.iter().map(|(row, _)| *row).collect();
        let in_range = |base: &[f64]| plan.iter().all(|(_, slot)| self.allows(*slot, base[*slot]));
        let (mut shortest, mut stalled) = (f64::INFINITY, 0);
        for round in 1..=MOST_ROUNDS {
            let Some((jacobian, values)) = self.linearised(base, plan)? else { return Ok(None) };
            let Some(step) = jacobian.lu().solve(&values) else { return Ok(None) };
            let mut largest = 0.0_f64;
            for ((_, slot), step) in plan.iter().zip(step.iter()) {
                base[*slot] -= step;
                largest = largest.max(step.abs() / (1.0 + base[*slot].abs()));
            }
            if largest.is_nan() || largest > 1e6 {
                return Ok(None);
            }
            // Steps that no longer become shorter lead nowhere, but for those that are rounding.
            stalled = if largest < SHORTER * shortest { 0 } else { stalled + 1 };
            shortest = shortest.min(largest);
            let is_last = stalled == MOST_STALLED && shortest < ROUNDED || round == MOST_ROUNDS;
            if stalled == MOST_STALLED && !is_last {
                return Ok(None);
            }
            let state = self.measured(base)?;
            let is_noise = |value: &RunningError| value.value.abs() <= f64::EPSILON * value.magnitude;
            let values = || self.values(&state, &rows);
            if largest < 1e-15 || is_last || values().is_some_and(|values| values.iter().all(is_noise)) {
                return Ok(in_range(base).then_some(state));
            }
        }
        Ok(None)
    }

    /// Whether every hypothesis holds at a state, beside those of which that is known.
    fn accepts(&mut self, state: &SampledState<'m, RunningError>, obeyed: &[usize]) -> bool {
        // Rules hold by what they are, unless one undoes another: that shows at once.
        let all = self.progress.accepted < 2;
        let is_open = |(at, _): &(usize, &Hypothesis)| (all || !self.explicit[*at]) && !obeyed.contains(at);
        for (_, hypothesis) in self.hypotheses.iter().enumerate().filter(is_open) {
            let Ok(entries) = difference(state, hypothesis) else { return false };
            let holds = entries.iter().all(|entry| match hypothesis.relation {
                Relation::Equal | Relation::Identical | Relation::Proportional => {
                    let derivatives = if hypothesis.throughout { entry.known().min(THROUGHOUT + 1) } else { 1 };
                    (0..derivatives).all(|k| entry.nth_derivative_value(k).is_some_and(residual::vanishes))
                }
                relation => residual::holds(relation, entry.value()),
            });
            if !holds {
                return false;
            }
        }
        self.progress.accepted += 1;
        true
    }
}
