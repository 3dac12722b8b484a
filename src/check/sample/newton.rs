//! Newton's method for the hypotheses of a claim, with derivatives from dual numbers.
//!
//! Each row is solved for one number of the base. Which row is solved for which number is the *plan*. Pivoting finds it
//! at the first base, and later bases use it again.

use nalgebra::{DMatrix, DVector};
use num_dual::{Dual, Dual64};

use crate::Result;
use crate::formula::{Expr, Node, Relation, SymbolId, Value};
use crate::scalar::RunningError;

use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;
use crate::check::model::order::order;
use crate::check::model::state_cache::Row;
use crate::check::sample::hypothesis_residual::{THROUGHOUT, difference};
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::contains;
use crate::check::state::numbers::Slot;
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;

/// The number of bases after which the search is given up if none of them could be projected.
const GIVEN_UP: usize = 24;

/// The largest number of Newton steps for one base.
const MOST_ROUNDS: usize = 30;

/// The largest number of Newton steps in a row that are not shorter than all before by the factor [`SHORTER`].
const MOST_STALLED: usize = 5;

const SHORTER: f64 = 0.9;

/// A number of this size or less may be 0 but for rounding.
const NEAR_ZERO: f64 = 1e-9;

/// The relative size below which a step may be rounding where the rows are large.
const ROUNDED: f64 = 1e-9;

/// The largest number of equations that are solved. Hypotheses about whole families are rules instead.
const MOST: usize = 24;

/// A base that was projected onto the equalities.
struct Projected<'m> {
    /// The numbers.
    base: Vec<f64>,
    /// The state that they fix.
    state: SampledState<'m, RunningError>,
    /// The hypotheses that are known to hold there, by their places.
    obeys: Vec<usize>,
}

impl<'m> Projection<'m> {
    /// The state near a base at which every hypothesis holds, if Newton's method finds one.
    ///
    /// # Errors
    /// If the mass matrix is singular.
    pub(crate) fn project(&mut self, base: Vec<f64>) -> Result<Option<(Vec<f64>, SampledState<'m, RunningError>)>> {
        let Some(Projected { base, state, obeys }) = self.solve(base)? else {
            self.record.moved.0 += 1;
            // A search that has found nothing so far costs most and finds least.
            self.record.hopeless |= self.record.moved.1 == 0 && self.record.moved.0 == GIVEN_UP || self.is_spent();
            return Ok(None);
        };
        self.record.moved.1 += 1;
        Ok((self.accepts(&state, &obeys) && has_a_lagrangian(&state)).then_some((base, state)))
    }

    /// The hypotheses of which all rows vanish.
    fn obeyed(&self, rows: &[(Row, RunningError)]) -> Vec<usize> {
        let of = |at: usize| rows.iter().filter(move |(row, _)| row.0 == at).map(|(_, value)| *value);
        let vanish = |at: &usize| of(*at).next().is_some() && of(*at).all(residual::vanishes);
        self.equalities().map(|(at, _)| at).filter(vanish).collect()
    }

    /// Projects a base onto the equalities.
    fn solve(&mut self, mut base: Vec<f64>) -> Result<Option<Projected<'m>>> {
        if self.equalities().next().is_none() {
            let state = self.measured(&base)?;
            return Ok(Some(Projected { base, state, obeys: Vec::new() }));
        }
        let drawn = base.clone();
        if self.record.plan.is_empty() {
            let state = self.measured(&base)?;
            return self.complete(base, state);
        }
        if let Some(state) = self.newton(&mut base, &self.record.plan)? {
            return self.complete(base, state);
        }
        // Another number of members may need another plan.
        let known = std::mem::take(&mut self.record.plan);
        let state = self.measured(&drawn)?;
        let solved = self.complete(drawn, state);
        if !matches!(solved, Ok(Some(_))) {
            self.record.plan = known;
        }
        solved
    }

    /// Solves the rows that are not in the plan yet, from a base that obeys the others.
    fn complete(
        &mut self,
        mut base: Vec<f64>,
        mut state: SampledState<'m, RunningError>,
    ) -> Result<Option<Projected<'m>>> {
        let rows = self.rows(&state);
        if rows.len() > MOST {
            self.record.hopeless = true;
            return Ok(None);
        }
        let mut obeys = self.obeyed(&rows);
        for (row, mut value) in rows {
            if self.record.plan.iter().any(|(planned, _)| *planned == row) {
                continue;
            }
            // The solution for a row before this one may have changed the others.
            if obeys.is_empty() {
                let Some(values) = self.values(&state, &[row]) else { return Ok(self.failed_at(row)) };
                value = values[0];
            }
            if residual::vanishes(value) {
                continue;
            }
            let Some(slot) = self.pivot(&base, row)? else { return Ok(self.failed_at(row)) };
            let mut plan = self.record.plan.clone();
            plan.push((row, slot));
            let Some(moved) = self.newton(&mut base, &plan)? else { return Ok(self.failed_at(row)) };
            (state, obeys) = (moved, Vec::new());
            self.record.plan = plan;
        }
        Ok(Some(Projected { base, state, obeys }))
    }

    /// No base: this row could not be solved.
    fn failed_at(&mut self, row: Row) -> Option<Projected<'m>> {
        self.record.fails_at(row.0);
        None
    }

    /// The number for which a row is solved, beside those of the plan. Numbers in which the row is linear go first,
    /// then those of the highest derivative. A number that would become 0 outside of its range goes last.
    fn pivot(&self, base: &[f64], row: Row) -> Result<Option<usize>> {
        let class = |slot: &Slot| match (slot.constant, slot.order) {
            (true, _) => 0,
            (false, order) => 1 + order,
        };
        let hypothesis = &self.hypotheses[row.0];
        let sides = [&hypothesis.lhs, &hypothesis.rhs];
        // A formula of drawn symbols only depends on these symbols and on no higher derivatives.
        let moves = self.mode.on_shell && self.model.system.is_some();
        let plain = sides.iter().all(|side| self.model.is_plain(side)) && self.rules.is_empty() && !moves;
        let concerns = |slot: &Slot| {
            let Some(symbol) = slot.symbol.filter(|_| plain) else { return !plain };
            let highest = sides.iter().filter_map(|side| order(self.model, side, symbol)).max();
            highest.is_some_and(|highest| slot.order <= usize::from(highest) + row.1)
        };
        // Nothing else is solved for the time, which has the first place, than what is about it alone.
        let is_time = |(id, _): &(SymbolId, u8)| matches!(self.model.meaning(*id), Some(Meaning::Time));
        let mut named = sides.iter().flat_map(|side| side.symbols()).peekable();
        let is_of_time = named.peek().is_some() && named.all(|symbol| is_time(&symbol));
        let mut candidates: Vec<usize> = if is_of_time { vec![0] } else { (1..self.slots.len()).collect() };
        candidates.retain(|at| !self.record.plan.iter().any(|(_, taken)| taken == at));
        // Where the plan has taken all numbers of the row, they follow the other numbers of the rows that they solve: k = 1, after
        // a sin θ = k λ was solved for k.
        if !is_of_time && candidates.iter().any(|at| concerns(&self.slots[*at])) {
            candidates.retain(|at| concerns(&self.slots[*at]));
        }
        candidates.sort_by_key(|at| std::cmp::Reverse((class(&self.slots[*at]), *at)));
        let rows: Vec<Row> = self.record.plan.iter().map(|(row, _)| *row).chain([row]).collect();
        let mut columns = Vec::new();
        for (_, slot) in &self.record.plan {
            let Some(column) = self.column(base, *slot, &rows)? else { return Ok(None) };
            columns.push(column);
        }
        let n = columns.len();
        let planned = DMatrix::from_fn(n, n, |i, j| columns[j][i].eps);
        let planned = (n > 0).then(|| planned.lu());
        let (mut vanishing, mut other, mut common, mut outside): (Option<usize>, _, _, _) = (None, None, None, None);
        for slot in candidates {
            if vanishing.is_some_and(|known| class(&self.slots[known]) > class(&self.slots[slot])) {
                break;
            }
            let Some(column) = self.column(base, slot, &rows)? else { continue };
            // The change of the row with the number while the planned numbers keep the planned rows constant.
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
            if self.is_linear(base, row, slot, &moved)? {
                // The planned numbers follow, so a number may go to 0 although the row alone leaves it elsewhere.
                let goes_to = column.last().map_or(base[slot], |value| base[slot] - value.re / change);
                let is_zero = goes_to.abs() <= 1e-9 * base[slot].abs();
                let is_common = self.is_common_factor(base, row, (slot, goes_to), &moved)?;
                let vanishes = is_zero || is_common;
                let may_vanish = contains(&self.slots[slot].range, if is_zero { 0.0 } else { goes_to });
                if !vanishes || may_vanish && !self.is_limited() {
                    return Ok(Some(slot));
                }
                // l (a − b) = 0 says that a = b: a number that has to vanish comes after the others of its class, and one that makes
                // a common factor vanish after all others.
                let last = match may_vanish {
                    true if is_common => &mut common,
                    true => &mut vanishing,
                    false => &mut outside,
                };
                *last = last.or(Some(slot));
                continue;
            }
            other = other.or(Some(slot));
        }
        Ok(vanishing.or(other).or(common).or(outside))
    }

    /// Whether a factor of all terms of a row vanishes where a number has the value that solves it: (m + M)(½ V² − g h) = 0 says nothing
    /// of M. There the row depends no more on the numbers of the other factors. `follow` is as for [`Self::is_linear`].
    fn is_common_factor(
        &self,
        base: &[f64],
        row: Row,
        (slot, value): (usize, f64),
        follow: &DVector<f64>,
    ) -> Result<bool> {
        let (Some(symbol), hypothesis) = (self.slots[slot].symbol, &self.hypotheses[row.0]) else { return Ok(false) };
        // A name stands for its formula.
        let contains = |part: &Expr, id: SymbolId| self.model.depends_on(part, &[id]);
        let times = |side: &Expr| {
            let mut times = 0;
            side.walk(&mut |part| {
                times += usize::from(matches!(&part.node, Node::Symbol { .. }) && contains(part, symbol));
            });
            times
        };
        // A common factor stands in more than one term.
        if row.1 > 0 || times(&hypothesis.lhs) + times(&hypothesis.rhs) < 2 {
            return Ok(false);
        }
        let step = value - base[slot];
        let mut solved = base.to_vec();
        solved[slot] = value;
        for ((_, planned), change) in self.record.plan.iter().zip(follow.iter()) {
            solved[*planned] -= step * change;
        }
        let concerns = |id: SymbolId| contains(&hypothesis.lhs, id) || contains(&hypothesis.rhs, id);
        let others = (1..self.slots.len()).filter(|at| *at != slot);
        for other in others.filter(|at| self.slots[*at].symbol.is_some_and(concerns)) {
            let (Some(before), Some(after)) = (self.column(base, other, &[row])?, self.column(&solved, other, &[row])?)
            else {
                return Ok(false);
            };
            if before[0].eps.abs() > 0.0 && after[0].eps.abs() <= NEAR_ZERO * before[0].eps.abs() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The rows with their derivatives by one number of the base.
    fn column(&self, base: &[f64], slot: usize, rows: &[Row]) -> Result<Option<Vec<Dual64>>> {
        if !self.spend(rows.len()) {
            return Ok(None);
        }
        let mut dual: Vec<Dual<RunningError>> = base.iter().map(|x| Dual::from_re(RunningError::new(*x))).collect();
        dual[slot].eps = RunningError::new(1.0);
        let Some(values) = self.values(&self.state(&dual, self.terms)?, rows) else { return Ok(None) };
        let column: Vec<Dual64> = values.iter().map(|x| Dual64::new(x.re.value, x.eps.value)).collect();
        Ok(Some(column).filter(|column| column.iter().all(|x| x.re.is_finite() && x.eps.is_finite())))
    }

    /// Whether the value of a row changes with a number, at a generic base.
    pub(crate) fn depends(&self, base: &[f64], row: Row, slot: usize) -> bool {
        !matches!(self.column(base, slot, &[row]), Ok(Some(column)) if column.iter().all(|value| value.eps == 0.0))
    }

    /// Whether a row is linear in a number, while the planned numbers follow it: each by −`follow` for each 1 of the number.
    fn is_linear(&self, base: &[f64], row: Row, slot: usize, follow: &DVector<f64>) -> Result<bool> {
        let mut values = Vec::new();
        for step in [0.0, 0.5, 1.0] {
            let mut moved = base.to_vec();
            moved[slot] += step;
            for ((_, planned), change) in self.record.plan.iter().zip(follow.iter()) {
                moved[*planned] -= step * change;
            }
            let moved: Vec<RunningError> = moved.into_iter().map(RunningError::new).collect();
            let Some(value) = self.values(&self.state(&moved, self.terms)?, &[row]) else { return Ok(false) };
            values.push(value[0].value);
        }
        let bend = values[0] - 2.0 * values[1] + values[2];
        Ok(bend.abs() <= 1e-9 * values.iter().map(|v| v.abs()).sum::<f64>())
    }

    /// The Jacobian and the values of the planned rows.
    pub(crate) fn linearised(
        &self,
        base: &[f64],
        plan: &[(Row, usize)],
    ) -> Result<Option<(DMatrix<f64>, DVector<f64>)>> {
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

    /// Moves a base by Newton steps until the rows of a plan vanish to rounding error; `None` if the steps do not
    /// converge.
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
            // Steps that do not get shorter diverge, unless they are rounding error.
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
                return Ok((in_range(base) && !self.is_excluded_zero(base, plan)?).then_some(state));
            }
        }
        Ok(None)
    }

    /// Whether a number that must not be 0 was moved to 0 but for rounding: the rows nearly hold with 0 in its place.
    fn is_excluded_zero(&self, base: &[f64], plan: &[(Row, usize)]) -> Result<bool> {
        let mut moved = base.to_vec();
        for (_, slot) in plan.iter().filter(|(_, slot)| base[*slot].abs() < NEAR_ZERO && !self.allows(*slot, 0.0)) {
            moved[*slot] = 0.0;
        }
        if moved == base {
            return Ok(false);
        }
        let rows: Vec<Row> = plan.iter().map(|(row, _)| *row).collect();
        let state = self.measured(&moved)?;
        // The other numbers of the plan were solved for with this one.
        let nearly_vanishes = |value: RunningError| value.value.abs() <= NEAR_ZERO * value.magnitude;
        Ok(self.values(&state, &rows).is_some_and(|values| values.into_iter().all(nearly_vanishes)))
    }

    /// Whether every hypothesis holds at a state, apart from those that are known to hold.
    fn accepts(&mut self, state: &SampledState<'m, RunningError>, obeyed: &[usize]) -> bool {
        // Rules hold by construction, unless one contradicts another. The first states show that.
        let all = self.record.accepted < 2;
        let is_open = |(at, _): &(usize, &Hypothesis)| (all || !self.explicit()[*at]) && !obeyed.contains(at);
        let holds = |hypothesis: &Hypothesis| {
            let Ok(entries) = difference(state, hypothesis) else { return false };
            entries.iter().all(|entry| match hypothesis.relation {
                Relation::Equal | Relation::Identical | Relation::Proportional => {
                    let derivatives = if hypothesis.throughout { entry.known().min(THROUGHOUT + 1) } else { 1 };
                    (0..derivatives).all(|k| entry.nth_derivative_value(k).is_some_and(residual::vanishes))
                }
                relation => residual::holds(relation, entry.value()),
            })
        };
        let mut open = self.hypotheses.iter().enumerate().filter(is_open);
        let unmet = open.find(|(_, hypothesis)| !holds(hypothesis)).map(|(at, _)| at);
        match unmet {
            Some(at) => self.record.fails_at(at),
            None => self.record.accepted += 1,
        }
        unmet.is_none()
    }
}

/// Whether the Lagrangian or Hamiltonian that the notes print has a value at a state. Where it has none, as beyond the speed
/// of light, there is no state of the system, and nothing that is said of the system is tested.
fn has_a_lagrangian(state: &SampledState<'_, RunningError>) -> bool {
    let model = state.model();
    let lagrangian = model.printed_lagrangian.as_ref().map(|printed| &printed.lagrangian);
    let name = lagrangian.or(model.printed_hamiltonian.as_ref().map(|printed| &printed.hamiltonian));
    let Some((id, _)) = name.and_then(|name| model.symbols.find(name)) else { return true };
    match model.meaning(id) {
        Some(Meaning::Defined(formula)) => {
            !matches!(state.now(formula, &[]), Ok(Value::Scalar(value)) if value.value.is_nan())
        }
        _ => true,
    }
}
