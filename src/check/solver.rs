//! How states are moved onto the hypotheses of a claim.
//!
//! Each hypothesis that is no rule is solved for one number of the base, by Newton's method with derivatives from dual
//! numbers. Which row is solved for which number is the *plan*; it is found at the first state that works, by pivoting,
//! and kept for the others. A state counts when every hypothesis is then seen to hold.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use num_dual::Dual64;

use crate::formula::evaluate::{Unavailable, evaluate_to};
use crate::formula::{Expr, IndexId, Node, Relation, Value};
use crate::mechanics::Elimination;
use crate::scalar::{Measured, Number, Series};
use crate::{Error, Result};

use super::base::{Layout, Slot, slots};
use super::draw::{Reach, contains};
use super::ensemble::{Condition, Setting};
use super::identity::derivatives;
use super::judge;
use super::model::Model;
use super::motion::order;
use super::rules::{Action, Rule, rules};
use super::scene::{Mode, Scene};

/// How many derivatives of a hypothesis that holds throughout are made to vanish, where so many are known.
const THROUGHOUT: usize = 3;

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
pub struct Solver<'m> {
    pub(super) model: &'m Model,
    pub(super) mode: Mode,
    reach: Reach,
    pub(super) conditions: Vec<Condition>,
    /// Which of the conditions are rules, and so need no solving.
    explicit: Vec<bool>,
    pub(super) rules: Arc<[Rule]>,
    /// What a base consists of.
    pub(super) slots: Vec<Slot>,
    pub(super) progress: Progress,
    /// How many derivatives the hypotheses need that are solved.
    terms: usize,
    layout: Arc<Layout>,
}

/// What a solver has learnt from the states that it has moved.
#[derive(Clone, Default)]
pub struct Progress {
    /// Which row is solved for which slot; found at the first state that works.
    pub(super) plan: Vec<(Row, usize)>,
    /// How many states were accepted.
    accepted: usize,
    /// How many bases could not be moved onto the hypotheses, and how many could.
    moved: (usize, usize),
    /// Whether there is more to solve than is solved.
    pub(super) hopeless: bool,
}

/// A base that was moved onto the equalities, as a state, and the hypotheses that are known to hold there.
struct Moved<'m> {
    base: Vec<f64>,
    scene: Scene<'m, Measured>,
    obeys: Vec<usize>,
}

impl Progress {
    /// Whether no base could be moved onto the hypotheses so far.
    pub(super) fn is_stuck(&self) -> bool {
        self.moved.1 == 0
    }
}

/// States that differ from others in the values of some quantities and in nothing else that is free.
pub struct Family<'m> {
    solver: Solver<'m>,
    /// Where each quantity stands in a base that is a number of it; the values of the others are conditions, the last of
    /// the claim's.
    places: Vec<Option<usize>>,
}

impl<'m> Family<'m> {
    /// Of these quantities, under a setting.
    pub fn new(model: &'m Model, setting: &Setting<'_>, quantities: &[Expr]) -> Self {
        let value = |quantity: &Expr| Condition {
            lhs: quantity.clone(),
            relation: Relation::Equal,
            rhs: Expr::integer(0, quantity.span),
            free: Vec::new(),
            throughout: false,
        };
        let plain = Solver::new(model, setting);
        let nothing_is_solved = plain.equalities().next().is_none();
        let place = |quantity: &Expr| plain.place(quantity).filter(|_| nothing_is_solved);
        let places: Vec<Option<usize>> = quantities.iter().map(place).collect();
        let solved = quantities.iter().zip(&places).filter(|(_, place)| place.is_none());
        let values = solved.map(|(quantity, _)| value(quantity));
        let conditions: Vec<Condition> = setting.conditions.iter().cloned().chain(values).collect();
        let solver = Solver::new(model, &Setting { conditions: &conditions, ..setting.clone() });
        Family { solver, places }
    }

    /// The state near a base at which the quantities have these values, if there is one.
    ///
    /// # Errors
    /// When the mass matrix is singular there.
    pub fn at(&mut self, base: &[f64], values: &[f64]) -> Result<Option<Scene<'m, Measured>>> {
        let laws: usize = match self.solver.mode.on_shell {
            true => self.solver.model.laws.iter().map(|law| law.conditions.len()).sum(),
            false => 0,
        };
        let end = self.solver.conditions.len() - laws;
        let solved = self.places.iter().filter(|place| place.is_none()).count();
        let mut base = base.to_vec();
        for (at, value) in self.places.iter().zip(values).filter_map(|(place, value)| Some(((*place)?, *value))) {
            if !self.solver.allows(at, value) {
                return Ok(None);
            }
            base[at] = value;
        }
        let others = self.places.iter().zip(values).filter(|(place, _)| place.is_none()).map(|(_, value)| value);
        for (condition, value) in self.solver.conditions[end - solved..end].iter_mut().zip(others) {
            let number = Expr::new(Node::Number(format!("{:e}", value.abs())), condition.lhs.span);
            condition.rhs = if *value < 0.0 { number.negated() } else { number };
        }
        Ok(self.solver.state(base)?.map(|(_, scene)| scene))
    }
}

/// The `derivative`-th time derivative of the `condition`-th hypothesis, one entry of it.
pub(super) type Row = (usize, usize, usize);

impl<'m> Solver<'m> {
    /// For states that obey a setting.
    pub(super) fn new(model: &'m Model, setting: &Setting<'_>) -> Self {
        let mode = setting.mode;
        let mut conditions = setting.conditions.to_vec();
        if mode.on_shell {
            conditions.extend(model.laws.iter().flat_map(|law| law.conditions.iter().cloned()));
        }
        let (found, explicit) = rules(model, setting.local, &conditions);
        let slots = slots(model, mode);
        let (rules, terms) = (found.into(), 0);
        let mut solver = Solver {
            model,
            mode,
            reach: setting.reach,
            conditions,
            explicit,
            rules,
            slots,
            progress: Progress::default(),
            terms,
            layout: Layout::of(model, mode),
        };
        solver.terms = solver.needed();
        solver
    }

    /// Which of the conditions are rules.
    pub(super) fn explicit(&self) -> &[bool] {
        &self.explicit
    }

    /// The hypotheses that are solved.
    pub(super) fn equalities(&self) -> impl Iterator<Item = (usize, &Condition)> {
        let is_equality = |c: &Condition| matches!(c.relation, Relation::Equal | Relation::Identical);
        self.conditions.iter().enumerate().filter(move |(at, c)| is_equality(c) && !self.explicit[*at])
    }

    /// The values of rows over any number; `None` where one has none. Each hypothesis is evaluated once.
    pub(super) fn values<B: Number>(&self, scene: &Scene<'m, B>, rows: &[Row]) -> Option<Vec<B>> {
        let mut known: Vec<(usize, Vec<Series<B>>)> = Vec::new();
        let mut values = Vec::with_capacity(rows.len());
        for (at, derivative, entry) in rows {
            if !known.iter().any(|(condition, _)| condition == at) {
                let (mut terms, mut entries) = (0, 0);
                for (_, derivative, entry) in rows.iter().filter(|(condition, ..)| condition == at) {
                    (terms, entries) = (terms.max(derivative + 1), entries.max(entry + 1));
                }
                known.push((*at, difference_to((terms, entries), scene, &self.conditions[*at]).ok()?));
            }
            let (_, entries) = known.iter().find(|(condition, _)| condition == at)?;
            values.push(entries.get(*entry)?.nth_derivative_value(*derivative)?);
        }
        Some(values)
    }

    /// Whether a number of a base may have a value.
    fn allows(&self, slot: usize, value: f64) -> bool {
        self.reach == Reach::Beyond || contains(&self.slots[slot].range, value)
    }

    /// Where a quantity stands in a base, if it is a number of it that no rule gives.
    fn place(&self, quantity: &Expr) -> Option<usize> {
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

    fn scene<B: Number>(&self, base: &[B], terms: usize) -> Result<Scene<'m, B>> {
        self.scene_by(Elimination::Pivots, base, terms)
    }

    /// The state of a base, the mass matrix inverted in the given way.
    pub(super) fn scene_by<B: Number>(
        &self,
        elimination: Elimination,
        base: &[B],
        terms: usize,
    ) -> Result<Scene<'m, B>> {
        let scene = Scene::by(elimination, terms, self.model, self.mode, (&self.layout, base), &self.rules)?;
        let joined = scene.join();
        joined.map_err(|_| Error::new("families that are joined must be families of one label"))?;
        Ok(scene)
    }

    /// The state near a base at which every hypothesis holds, if there is one.
    pub(super) fn state(&mut self, base: Vec<f64>) -> Result<Option<(Vec<f64>, Scene<'m, Measured>)>> {
        let Some(Moved { base, scene, obeys }) = self.solve(base)? else {
            self.progress.moved.0 += 1;
            // To look further costs more the less there is to be found.
            self.progress.hopeless |= self.progress.moved.1 == 0 && self.progress.moved.0 == GIVEN_UP;
            return Ok(None);
        };
        self.progress.moved.1 += 1;
        Ok(self.accepts(&scene, &obeys).then_some((base, scene)))
    }

    /// Moves a base onto the equalities.
    fn solve(&mut self, mut base: Vec<f64>) -> Result<Option<Moved<'m>>> {
        if self.equalities().next().is_none() {
            let scene = self.measured(&base)?;
            return Ok(Some(Moved { base, scene, obeys: Vec::new() }));
        }
        let drawn = base.clone();
        if self.progress.plan.is_empty() {
            let scene = self.measured(&base)?;
            return self.complete(base, scene);
        }
        if let Some(scene) = self.newton(&mut base, &self.progress.plan)? {
            return self.complete(base, scene);
        }
        // Another number of particles may want another plan.
        let known = std::mem::take(&mut self.progress.plan);
        let scene = self.measured(&drawn)?;
        let solved = self.complete(drawn, scene);
        if !matches!(solved, Ok(Some(_))) {
            self.progress.plan = known;
        }
        solved
    }

    /// Solves the rows that are not planned yet, from a base that obeys those that are.
    fn complete(&mut self, mut base: Vec<f64>, mut scene: Scene<'m, Measured>) -> Result<Option<Moved<'m>>> {
        let rows = self.rows(&scene);
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
                let Some(values) = self.values(&scene, &[row]) else { return Ok(None) };
                value = values[0];
            }
            if judge::vanishes(value) {
                continue;
            }
            let Some(slot) = self.pivot(&base, row)? else { return Ok(None) };
            let mut plan = self.progress.plan.clone();
            plan.push((row, slot));
            let Some(moved) = self.newton(&mut base, &plan)? else { return Ok(None) };
            (scene, obeys) = (moved, Vec::new());
            self.progress.plan = plan;
        }
        Ok(Some(Moved { base, scene, obeys }))
    }

    /// The hypotheses all of whose rows vanish.
    fn obeyed(&self, rows: &[(Row, Measured)]) -> Vec<usize> {
        let of = |at: usize| rows.iter().filter(move |(row, _)| row.0 == at).map(|(_, value)| *value);
        let vanish = |at: &usize| of(*at).next().is_some() && of(*at).all(judge::vanishes);
        self.equalities().map(|(at, _)| at).filter(vanish).collect()
    }

    pub(super) fn measured(&self, base: &[f64]) -> Result<Scene<'m, Measured>> {
        let base: Vec<Measured> = base.iter().map(|x| Measured::new(*x)).collect();
        self.scene(&base, self.mode.order + 1)
    }

    fn needed(&self) -> usize {
        let throughout = self.equalities().any(|(_, condition)| condition.throughout);
        let sides = self.equalities().flat_map(|(_, condition)| [&condition.lhs, &condition.rhs]);
        let highest = sides.map(|side| derivatives(side, self.model)).max().unwrap_or(0);
        // What a rule says a symbol is may have derivatives of its own.
        let said = self.rules.iter().flat_map(|rule| rule.action.formulas());
        let said = said.map(|formula| derivatives(formula, self.model)).max().unwrap_or(0);
        (highest + said + 1 + if throughout { THROUGHOUT } else { 0 }).clamp(2, self.mode.order + 1)
    }

    /// The rows of the hypotheses that are solved, with their values at a state.
    pub(super) fn rows<B: Number>(&self, scene: &Scene<'m, B>) -> Vec<(Row, B)> {
        let mut rows = Vec::new();
        let differences: Vec<_> = self
            .equalities()
            .map(|(at, condition)| (at, condition, difference(scene, condition).unwrap_or_default()))
            .collect();
        for derivative in 0..=THROUGHOUT {
            for (at, condition, entries) in &differences {
                for (entry, value) in entries.iter().enumerate() {
                    if let Some(value) = value.nth_derivative_value(derivative)
                        && (derivative == 0 || condition.throughout)
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
        let condition = &self.conditions[row.0];
        let sides = [&condition.lhs, &condition.rhs];
        // What nothing but drawn symbols is made of depends on those in it, and on no higher derivatives.
        let moves = self.mode.on_shell && self.model.world.is_some();
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
        let values = self.values(&self.scene(&dual, self.terms)?, rows);
        Ok(values.filter(|values| values.iter().all(|value| value.re.is_finite() && value.eps.is_finite())))
    }

    /// Whether the value of a row changes with a number, at a base where nothing keeps it from doing so by accident.
    pub(super) fn depends(&self, base: &[f64], row: Row, slot: usize) -> bool {
        !matches!(self.column(base, slot, &[row]), Ok(Some(column)) if column.iter().all(|value| value.eps == 0.0))
    }

    fn is_linear(&self, base: &[f64], row: Row, slot: usize) -> Result<bool> {
        let mut values = Vec::new();
        for step in [0.0, 0.5, 1.0] {
            let mut moved = base.to_vec();
            moved[slot] += step;
            let Some(value) = self.values(&self.scene(&moved, self.terms)?, &[row]) else { return Ok(false) };
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
    fn newton(&self, base: &mut [f64], plan: &[(Row, usize)]) -> Result<Option<Scene<'m, Measured>>> {
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
            let scene = self.measured(base)?;
            let is_noise = |value: &Measured| value.value.abs() <= f64::EPSILON * value.magnitude;
            let values = || self.values(&scene, &rows);
            if largest < 1e-15 || is_last || values().is_some_and(|values| values.iter().all(is_noise)) {
                return Ok(in_range(base).then_some(scene));
            }
        }
        Ok(None)
    }

    /// Whether every hypothesis holds at a state, beside those of which that is known.
    fn accepts(&mut self, scene: &Scene<'m, Measured>, obeyed: &[usize]) -> bool {
        // Rules hold by what they are, unless one undoes another: that shows at once.
        let all = self.progress.accepted < 2;
        let is_open = |(at, _): &(usize, &Condition)| (all || !self.explicit[*at]) && !obeyed.contains(at);
        for (_, condition) in self.conditions.iter().enumerate().filter(is_open) {
            let Ok(entries) = difference(scene, condition) else { return false };
            let holds = entries.iter().all(|entry| match condition.relation {
                Relation::Equal | Relation::Identical | Relation::Proportional => {
                    let derivatives = if condition.throughout { entry.known().min(THROUGHOUT + 1) } else { 1 };
                    (0..derivatives).all(|k| entry.nth_derivative_value(k).is_some_and(judge::vanishes))
                }
                relation => judge::holds(relation, entry.value()),
            });
            if !holds {
                return false;
            }
        }
        self.progress.accepted += 1;
        true
    }
}

/// lhs − rhs, entry by entry, for all values of the free indices; with the derivatives that are made to vanish.
pub(super) fn difference<B: Number>(
    scene: &Scene<'_, B>,
    condition: &Condition,
) -> Result<Vec<Series<B>>, Unavailable> {
    difference_to((THROUGHOUT + 1, usize::MAX), scene, condition)
}

/// The same where no more than so many terms are used, of so many entries.
fn difference_to<B: Number>(
    (terms, entries): (usize, usize),
    scene: &Scene<'_, B>,
    condition: &Condition,
) -> Result<Vec<Series<B>>, Unavailable> {
    let mut indices: Vec<(IndexId, u8)> = condition.free.iter().map(|id| (*id, 1)).collect();
    let terms = if condition.throughout { terms } else { 1 };
    let mut all = Vec::new();
    let (lhs, rhs) = (&condition.lhs, &condition.rhs);
    loop {
        if terms == 1 {
            let sides = (scene.instant(lhs, &indices)?, scene.instant(rhs, &indices)?);
            all.extend(apart(sides, condition)?.into_iter().map(|x| Series::of_value(x.0)));
        } else {
            let side = |side: &Expr| evaluate_to(terms, side, scene, &indices);
            all.extend(apart((side(lhs)?, side(rhs)?), condition)?);
        }
        if all.len() >= entries || !judge::advance(&mut indices, scene)? {
            return Ok(all);
        }
    }
}

/// What should vanish of two sides for a condition to hold: their difference, or the product of vectors that are parallel.
fn apart<D: Number>((lhs, rhs): (Value<D>, Value<D>), condition: &Condition) -> Result<Vec<D>, Unavailable> {
    Ok(match (lhs, rhs) {
        (Value::Vector(a), Value::Vector(b)) if condition.relation == Relation::Proportional => {
            a.cross(&b).iter().copied().collect()
        }
        (Value::Scalar(a), Value::Scalar(b)) => vec![a - b],
        (a, b) if a.shape() == b.shape() => a.entries().iter().zip(b.entries()).map(|(a, b)| *a - b).collect(),
        (a, _) if condition.rhs.is_zero() => a.entries(),
        _ => return Err(Unavailable::Operation("a condition between different shapes")),
    })
}
