//! Constraint projection: the equations that the hypotheses of a claim set for the numbers of a state.
//!
//! Each hypothesis that is not a rule gives *rows*: one scalar equation for each entry and each derivative that must
//! vanish. This file evaluates rows over any kind of number. [`super::newton`] solves them for numbers of the base.
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

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::formula::{Expr, Node, Relation};
use crate::mechanics::LinearSolver;
use crate::scalar::{Number, RunningError, Series};
use crate::{Error, Result};

use crate::check::hypotheses::explicit::rules;
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::order::derivatives;
use crate::check::model::sampling::{Mode, Spread};
use crate::check::model::state_cache::{ProjectionRecord, Row};
use crate::check::sample::hypothesis_residual::{THROUGHOUT, difference, difference_to};
use crate::check::sample::sampler::contains;
use crate::check::sample::setting::Setting;
use crate::check::state::numbers::{Layout, Slot, slots};
use crate::check::state::sampled_state::SampledState;

/// The projection of states onto the hypotheses of a claim.
pub struct Projection<'m> {
    pub(crate) model: &'m Model,
    pub(crate) mode: Mode,
    spread: Spread,
    pub(crate) hypotheses: Vec<Hypothesis>,
    /// For each hypothesis whether it is a rule, which needs no solution.
    explicit: Vec<bool>,
    pub(crate) rules: Arc<[Rule]>,
    /// The descriptions of the numbers of a base.
    pub(crate) slots: Vec<Slot>,
    /// What is known from the states that were projected so far.
    pub(crate) record: ProjectionRecord,
    /// The number of derivatives that the solved hypotheses need.
    pub(crate) terms: usize,
    layout: Arc<Layout>,
    /// The most work that may go into solving, and what was spent so far; in values of rows.
    effort: (usize, AtomicUsize),
}

impl<'m> Projection<'m> {
    /// The projection of a setting.
    pub(crate) fn new(model: &'m Model, setting: &Setting<'_>) -> Self {
        let mode = setting.mode;
        let mut hypotheses = setting.hypotheses.to_vec();
        if mode.on_shell {
            hypotheses.extend(model.laws.iter().flat_map(|law| law.hypotheses.iter().cloned()));
            hypotheses.extend(model.constraints.iter().cloned());
        }
        let (found, explicit) = rules(model, setting.local, &hypotheses);
        let slots = slots(model, mode);
        let (rules, terms) = (found.into(), 0);
        let mut projection = Projection {
            model,
            mode,
            spread: setting.spread,
            hypotheses,
            explicit,
            rules,
            slots,
            record: ProjectionRecord::default(),
            terms,
            layout: Layout::of(model, mode),
            effort: (setting.effort, AtomicUsize::new(0)),
        };
        projection.terms = projection.needed();
        projection
    }

    /// Counts the work of so many rows with their derivatives; false, if that is too much.
    pub(crate) fn spend(&self, rows: usize) -> bool {
        let work = rows * self.terms;
        self.effort.1.fetch_add(work, Ordering::Relaxed) + work <= self.effort.0
    }

    /// Whether the work is limited, as it is for the premises of a deduction only.
    pub(crate) fn is_limited(&self) -> bool {
        self.effort.0 < usize::MAX
    }

    /// Whether no more work may go into solving.
    pub(crate) fn is_spent(&self) -> bool {
        self.effort.1.load(Ordering::Relaxed) > self.effort.0
    }

    /// For each hypothesis whether it is a rule.
    pub(crate) fn explicit(&self) -> &[bool] {
        &self.explicit
    }

    /// The equalities that must be solved, with their places among the hypotheses.
    pub(crate) fn equalities(&self) -> impl Iterator<Item = (usize, &Hypothesis)> {
        let is_equality = |c: &Hypothesis| matches!(c.relation, Relation::Equal | Relation::Identical);
        self.hypotheses.iter().enumerate().filter(move |(at, c)| is_equality(c) && !self.explicit[*at])
    }

    /// The values of rows; `None` if one has no value. Each hypothesis is evaluated once.
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

    /// Whether a number of a base may have this value.
    pub(crate) fn allows(&self, slot: usize, value: f64) -> bool {
        self.spread == Spread::BeyondRanges
            || contains(&self.slots[slot].range, value)
            || value == 0.0 && self.is_set_to_zero(slot)
    }

    /// Whether a hypothesis says that a constant is 0: M = 0 is the limiting case of a mass that is declared positive.
    fn is_set_to_zero(&self, slot: usize) -> bool {
        let Slot { symbol: Some(symbol), constant: true, one_of_many: false, .. } = &self.slots[slot] else {
            return false;
        };
        let is_it = |a: &Expr, b: &Expr| a.as_plain_symbol() == Some(*symbol) && b.is_null();
        self.equalities().any(|(_, known)| is_it(&known.lhs, &known.rhs) || is_it(&known.rhs, &known.lhs))
    }

    /// The place of a quantity in a base, if it is a number of the base that no rule gives.
    pub(crate) fn place(&self, quantity: &Expr) -> Option<usize> {
        let Node::Symbol { id, indices, dots } = &quantity.node else { return None };
        let is_free = |rule: &Rule| match &rule.action {
            Action::EquationOfMotion { order, .. } => dots < order,
            Action::Coupled(laws) => laws.unknowns.iter().all(|(symbol, order)| symbol != id || dots < order),
            _ => false,
        };
        let is_it = |slot: &Slot| slot.symbol == Some(*id) && !slot.one_of_many && slot.order == usize::from(*dots);
        let at = self.slots.iter().position(is_it).filter(|_| indices.is_empty())?;
        self.rules.iter().filter(|rule| rule.symbol == *id).all(is_free).then_some(at)
    }

    pub(crate) fn state<B: Number>(&self, base: &[B], terms: usize) -> Result<SampledState<'m, B>> {
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
        joined.map_err(|_| {
            Error::new("families that are joined by \\cup must have the same label")
                .help("declare these families with the same index")
        })?;
        Ok(state)
    }

    pub(crate) fn measured(&self, base: &[f64]) -> Result<SampledState<'m, RunningError>> {
        let base: Vec<RunningError> = base.iter().map(|x| RunningError::new(*x)).collect();
        self.state(&base, self.mode.order + 1)
    }

    fn needed(&self) -> usize {
        let throughout = self.equalities().any(|(_, hypothesis)| hypothesis.throughout);
        let sides = self.equalities().flat_map(|(_, hypothesis)| [&hypothesis.lhs, &hypothesis.rhs]);
        let highest = sides.map(|side| derivatives(side, self.model)).max().unwrap_or(0);
        // The value that a rule gives may contain derivatives.
        let said = self.rules.iter().flat_map(|rule| rule.action.formulas());
        let said = said.map(|formula| derivatives(formula, self.model)).max().unwrap_or(0);
        (highest + said + 1 + if throughout { THROUGHOUT } else { 0 }).clamp(2, self.mode.order + 1)
    }

    /// The rows of the equalities, with their values at a state.
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
}
