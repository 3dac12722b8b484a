//! The worst state of an inequality: a minimum of its margin, found by a direct search.
//!
//! Random, special and boundary states miss a failure in a corner, where several numbers are at their ends, or at an
//! extremum: u + v < 1.9 for two numbers between 0 and 1, (x − 7)² > 0. So the *margin* is minimised from the states
//! with the smallest margins. The search changes one number after another, then all together along the last step, then
//! in a random direction, since hypotheses may forbid the others (Hooke and Jeeves). A state that obeys all hypotheses
//! and is clearly false is a counterexample. Sides that only become equal refute a strict inequality if they are equal
//! inside of all ranges and hypotheses. At an open end they may come arbitrarily close: a + b < 2 for two numbers below
//! 1 is true.

use crate::code::Code;
use crate::formula::{Expr, Node, Relation, Value};
use crate::notes::claims::Range;
use crate::scalar::RunningError;

use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::free_symbols::drawn;
use crate::check::model::meaning::is_angle;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::{Sampler, contains};
use crate::check::search::boundary;
use crate::check::search::boundary::{is_clear, is_ordinary};
use crate::check::search::double_range::{is_strict, is_truly_equal};
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::{DIFFERENCE, Margin, Point, Sides};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The number of states from which the search starts.
const STARTS: usize = 4;

/// The number of states from which it starts along the boundary of each hypothesis.
const ALONG: usize = 2;

/// The largest number of steps from each state.
const STEPS: usize = 700;

/// The largest number of numbers that are changed.
const MOVED: usize = 16;

/// The first step, of a logarithm, an angle or a number of order one; for an interval, a fraction of its width.
const FIRST: f64 = 0.4;

/// The factor of a step after two steps that reduced the margin.
const LONGER: f64 = 2.0;

/// The factor of a step after one that did not.
const SHORTER: f64 = 0.35;

/// The smallest step.
const LAST: f64 = 1e-9;

/// The step below which a margin above [`WIDE`] is taken not to reach 0.
const SMALL: f64 = 2e-3;

/// The margin above which a search with small steps ends.
const WIDE: f64 = 1e-3;

/// The smallest change of a relative margin that counts.
const FLAT: f64 = 1e-14;

/// The relative margin below which the sides may be equal.
const CLOSED: f64 = 1e-12;

/// The relative margin below which the sides are equal to rounding error.
const EQUAL: f64 = 1e-15;

/// The smallest distance from an open end of a range, as a fraction of its width.
const NEAR: f64 = 1e-7;

/// The largest magnitude of a number in the search.
const FAR: f64 = 1e6;

/// The distance from the boundary of a hypothesis, relative to its sides.
const EDGE: f64 = 1e-7;

/// The distance from a simple number within which that number is tried.
const SIMPLE: f64 = 1e-4;

/// The largest number of passes over all numbers in which simple numbers are tried.
const PASSES: usize = 4;

/// The finding on an inequality that passed, tested again at its worst states.
pub(crate) fn at_worst_state(link: &Link, context: &Context<'_>, ensemble: &Ensemble<'_>, finding: Finding) -> Finding {
    if finding.verdict != Verdict::Verified {
        return finding;
    }
    let mut starts: Vec<(f64, Vec<f64>)> = Vec::new();
    for state in &ensemble.states {
        let base: Vec<f64> = state.base.numbers().iter().map(|x| x.value).collect();
        let in_range = ensemble.projection.slots.iter().zip(&base).all(|(slot, x)| contains(&slot.range, *x));
        if let (Some(margin), true) = (margin(link, state), in_range) {
            starts.push((margin.share, base));
        }
    }
    // The drawn states with the smallest margins, and those of all states.
    let own = starts.len().min(ensemble.bases.len());
    starts[..own].sort_by(|a, b| a.0.total_cmp(&b.0));
    let random: Vec<(f64, Vec<f64>)> = starts.drain(..own).collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let others = starts.into_iter().filter(|(margin, _)| *margin > CLOSED).take(STARTS - STARTS / 2);
    let nearest: Vec<Vec<f64>> = random.iter().take(STARTS / 2).cloned().chain(others).map(|(_, base)| base).collect();
    let random: Vec<Vec<f64>> = random.into_iter().take(ALONG).map(|(_, base)| base).collect();
    // Inside of all hypotheses, and along the boundary of each: single steps do not follow an oblique boundary.
    let edges = context.hypotheses.iter().filter_map(|hypothesis| along_the_edge(hypothesis, context, ensemble));
    let places = std::iter::once((context.hypotheses.to_vec(), &nearest)).chain(edges.map(|edge| (edge, &random)));
    for (hypotheses, starts) in places {
        let projection =
            Projection::new(context.model, &Context { hypotheses: &hypotheses, ..*context }.setting(ensemble.mode));
        let draw = context.draw(ensemble.mode, "adversary");
        let mut search = Search { link, context, projection, draw, slots: Vec::new() };
        let found = starts.iter().find_map(|start| {
            let state = search.worst_from(start.clone())?;
            match residual::test(link, &state) {
                Ok(Point::Fails(failure)) => Some((state, failure)),
                _ => None,
            }
        });
        if let Some((state, failure)) = found {
            let glyph = link.relation.glyph();
            let place = if ensemble.mode.on_shell { " on shell" } else { "" };
            return Finding {
                points: finding.points,
                tried: finding.tried,
                max_residual: Some(failure.residual),
                counterexample: Some(counterexample(link, &state, &failure)),
                ..context.finding(
                    Code::InequalityFails,
                    Verdict::Refuted,
                    format!("“{glyph}” is false{place} at a state that a search found"),
                )
            };
        }
    }
    finding
}

/// The hypotheses of a claim with one of them, an inequality of several numbers, kept just inside of its boundary.
fn along_the_edge(hypothesis: &Hypothesis, context: &Context<'_>, ensemble: &Ensemble<'_>) -> Option<Vec<Hypothesis>> {
    let (lhs, rhs) = boundary::of_hypothesis(hypothesis)?;
    if drawn(&[&lhs, &rhs], context.model).len() < 2 {
        return None;
    }
    let side = |side: &Expr| match ensemble.states.first()?.now(side, &[]) {
        Ok(Value::Scalar(value)) => Some(value.magnitude),
        _ => None,
    };
    let beside = EDGE * (side(&lhs)? + side(&rhs)?);
    let number = Expr::new(Node::Number(format!("{beside:e}")), lhs.span);
    let difference = match hypothesis.relation {
        Relation::Less | Relation::LessEqual => rhs.minus(lhs),
        _ => lhs.minus(rhs),
    };
    let edge = Link { lhs: difference, relation: Relation::Equal, rhs: number, free: Vec::new() };
    let edge = Hypothesis::of(edge, false);
    Some(context.hypotheses.iter().cloned().chain([edge]).collect())
}

fn margin(link: &Link, state: &SampledState<'_, RunningError>) -> Option<Margin> {
    Sides::of(link, state).ok()?.margin(link.relation)
}

/// Whether a margin is lower than another. The margin of (x − 1)² relative to its terms is 1 for all negative x. There
/// the margin itself decides.
fn is_lower(margin: &Margin, than: &Margin) -> bool {
    let by = margin.share - than.share;
    by < -FLAT || by < 0.0 && than.share < WIDE || by < FLAT && than.share > WIDE && margin.size < than.size
}

/// A direct search for the smallest margin.
struct Search<'a, 'm> {
    link: &'a Link,
    context: &'a Context<'m>,
    projection: Projection<'m>,
    draw: Sampler,
    /// The numbers that are changed.
    slots: Vec<usize>,
}

impl<'m> Search<'_, 'm> {
    /// A local minimum of the margin near a state, if the inequality certainly fails there.
    fn worst_from(&mut self, start: Vec<f64>) -> Option<SampledState<'m, RunningError>> {
        let (mut margin, mut base, _) = self.at(start)?;
        self.slots = self.relevant_slots(&base, margin);
        if self.slots.is_empty() {
            return None;
        }
        let mut steps: Vec<f64> = self.slots.iter().map(|at| FIRST * self.width(*at)).collect();
        let (mut taken, mut again) = (0, vec![true; steps.len()]);
        while taken < STEPS && margin.share > -DIFFERENCE {
            let before = base.clone();
            for k in 0..steps.len() {
                let (mut lower, ran) = (None, again[k]);
                for step in [steps[k], -steps[k]] {
                    taken += 1;
                    lower = self.lower(&base, &[(k, step)], margin).map(|found| (found, step));
                    if lower.is_some() {
                        break;
                    }
                }
                again[k] = lower.is_some();
                match lower {
                    Some(((less, moved), step)) => {
                        (margin, base) = (less, moved);
                        steps[k] = if ran { LONGER * step } else { step };
                    }
                    None => steps[k] *= SHORTER,
                }
            }
            let further = match base != before {
                true => self.along(&before, &base),
                false => self.anywhere(&steps),
            };
            taken += 1;
            if let Some((less, moved)) = self.lower(&base, &further, margin) {
                (margin, base) = (less, moved);
            }
            let largest =
                self.slots.iter().zip(&steps).map(|(at, step)| step.abs() / self.width(*at)).fold(0.0, f64::max);
            let stuck = base == before && largest < SMALL;
            if largest < LAST || largest < SMALL && margin.share > WIDE || margin.share.abs() < EQUAL {
                break;
            }
            if stuck
                && margin.share < WIDE * SMALL
                && !self.at(base.clone()).is_some_and(|(.., state)| self.is_inside(&state))
            {
                break;
            }
        }
        self.settle(margin, base)
    }

    /// The state, if the inequality certainly fails there: clearly, or at sides that are truly equal.
    fn settle(&mut self, margin: Margin, base: Vec<f64>) -> Option<SampledState<'m, RunningError>> {
        if margin.share < -DIFFERENCE {
            return self.at(base).map(|(_, _, state)| state);
        }
        if !is_strict(self.link.relation) || margin.share > CLOSED.sqrt() {
            return None;
        }
        let (margin, base) = self.simple(margin, base);
        let (_, base, state) = self.at(base).filter(|_| margin.share < CLOSED)?;
        (self.is_inside(&state) && is_truly_equal(self.link, &mut self.projection, &base)).then_some(state)
    }

    /// Whether a state is away from the open ends of all ranges and hypotheses.
    fn is_inside(&self, state: &SampledState<'_, RunningError>) -> bool {
        let mut hypotheses = self.context.hypotheses.iter().filter_map(boundary::of_hypothesis);
        is_ordinary(state) && hypotheses.all(|hypothesis| is_clear(&hypothesis, state))
    }

    /// The state near a base, with its margin, if it obeys all hypotheses.
    fn at(&mut self, base: Vec<f64>) -> Option<(Margin, Vec<f64>, SampledState<'m, RunningError>)> {
        let (base, state) = self.projection.project(base).ok()??;
        margin(self.link, &state).map(|margin| (margin, base, state))
    }

    /// A base some steps away with a lower margin, if it has one.
    fn lower(&mut self, base: &[f64], steps: &[(usize, f64)], margin: Margin) -> Option<(Margin, Vec<f64>)> {
        let mut moved = base.to_vec();
        for (k, step) in steps {
            let at = self.slots[*k];
            moved[at] = self.moved(at, base[at], *step);
        }
        if moved == base {
            return None;
        }
        self.at(moved).filter(|(less, ..)| is_lower(less, &margin)).map(|(less, base, _)| (less, base))
    }

    /// The numbers on which the margin depends, without those for which hypotheses are solved.
    fn relevant_slots(&mut self, base: &[f64], margin: Margin) -> Vec<usize> {
        let mut found = Vec::new();
        let planned: Vec<usize> = self.projection.record.plan.iter().map(|(_, slot)| *slot).collect();
        for at in (1..base.len()).filter(|at| !planned.contains(at)) {
            if found.len() == MOVED || matches!(self.projection.slots[at].range, Range::Integer { .. }) {
                continue;
            }
            let mut matters = false;
            for step in [0.01, -0.01] {
                let mut moved = base.to_vec();
                moved[at] = self.moved(at, base[at], step * self.width(at));
                if matters || moved == base {
                    continue;
                }
                matters = self.at(moved).is_none_or(|(other, ..)| other != margin);
            }
            if matters {
                found.push(at);
            }
        }
        found
    }

    /// A step of order one.
    fn width(&self, at: usize) -> f64 {
        match &self.projection.slots[at].range {
            Range::Interval { low, high, .. } => high - low,
            _ => 1.0,
        }
    }

    /// A number of a state after a step, within its range.
    fn moved(&self, at: usize, from: f64, step: f64) -> f64 {
        match &self.projection.slots[at].range {
            Range::Positive | Range::Negative => {
                from.signum() * (from.abs() * step.clamp(-9.0, 9.0).exp()).clamp(FAR.recip(), FAR)
            }
            Range::Interval { low, high, low_open, high_open } => {
                let near = |open: bool| if open { NEAR * (high - low) } else { 0.0 };
                (from + step).clamp(low + near(*low_open), high - near(*high_open))
            }
            _ => (from + step).clamp(-FAR, FAR),
        }
    }

    /// The steps from one base to another.
    fn along(&self, before: &[f64], base: &[f64]) -> Vec<(usize, f64)> {
        let step = |at: usize| match &self.projection.slots[at].range {
            Range::Positive | Range::Negative => (base[at] / before[at]).ln(),
            _ => base[at] - before[at],
        };
        self.slots.iter().enumerate().map(|(k, at)| (k, step(*at))).collect()
    }

    /// Steps in a random direction.
    fn anywhere(&mut self, steps: &[f64]) -> Vec<(usize, f64)> {
        steps.iter().enumerate().map(|(k, step)| (k, 4.0 * step * (2.0 * self.draw.unit() - 1.0))).collect()
    }

    /// The state with simple numbers in place of close ones, if the margin does not rise.
    fn simple(&mut self, margin: Margin, base: Vec<f64>) -> (Margin, Vec<f64>) {
        let (mut margin, mut base) = (margin, base);
        // Several passes: one number may become simple only after another.
        for at in self.slots.repeat(self.slots.len().min(PASSES)) {
            let unit = if is_angle(&self.projection.slots[at].range) { std::f64::consts::PI } else { 1.0 } / 12.0;
            let x = base[at];
            let others =
                self.slots.iter().filter(|other| **other != at).flat_map(|other| [base[*other], -base[*other]]);
            let all: Vec<f64> = [0.0, (x / unit).round() * unit, x.round()].into_iter().chain(others).collect();
            for simple in all.into_iter().filter(|simple| (simple - x).abs() < SIMPLE * x.abs().max(1.0)) {
                let mut moved = base.clone();
                moved[at] = simple;
                if contains(&self.projection.slots[at].range, simple)
                    && let Some((less, moved, _)) = self.at(moved).filter(|(less, ..)| less.share <= margin.share)
                {
                    (margin, base) = (less, moved);
                }
            }
        }
        (margin, base)
    }
}
