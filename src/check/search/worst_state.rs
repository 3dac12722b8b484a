//! The state at which an inequality is nearest to failing, or fails most.
//!
//! Special states are single points: for u + v < 1.9 with two numbers below 1, each edge is harmless and the corner
//! is not. So the margin, the difference of the sides relative to their terms, is minimized: one number after
//! another with steps that grow and shrink, then along the combined direction, then in random directions, which
//! leads along a slanting hypothesis. It starts at the four best states, needs some hundred evaluations, and stops
//! early where the margin does not change. A state that obeys all hypotheses and is clearly false refutes wherever
//! it is. Equal sides refute a strict inequality if no number is at an end that its range or a hypothesis excludes:
//! a + b < 2 is true for a, b < 1.

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
use crate::check::search::double_range::{is_reached, is_strict};
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::{DIFFERENCE, Margin, Point, Sides};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// It goes downhill from so many states.
const STARTS: usize = 4;

/// And from so many along the edge of each hypothesis.
const ALONG: usize = 2;

/// With so many steps from each, and so many numbers that are moved.
const STEPS: usize = 700;

const MOVED: usize = 16;

/// The first step, of a logarithm or an angle or a number of order one; as a share of an interval.
const FIRST: f64 = 0.4;

/// A step is so many times longer after two that led down, and after one that did not.
const LONGER: f64 = 2.0;

const SHORTER: f64 = 0.35;

/// Smaller steps find nothing that a double could show.
const LAST: f64 = 1e-9;

/// Where steps of `SMALL` leave a margin of `WIDE`, the bottom is not at 0.
const SMALL: f64 = 2e-3;

const WIDE: f64 = 1e-3;

/// Where a relative margin changes by less it may be the same.
const FLAT: f64 = 1e-14;

/// A margin below this, relative to the sides, may be none; below that it is rounding.
const CLOSED: f64 = 1e-12;

const NOTHING: f64 = 1e-15;

/// How near numbers are taken to the ends that their ranges leave out, as a share; and how far out they are followed.
const NEAR: f64 = 1e-7;

const FAR: f64 = 1e6;

/// How far from its edge a hypothesis is held, relative to its sides.
const EDGE: f64 = 1e-7;

/// So near to a simple number another one is tried in its place.
const SIMPLE: f64 = 1e-4;

const PASSES: usize = 4;

/// The finding on an inequality that has passed, with what its worst states say of it.
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
    // The nearest of those drawn and the nearest of all.
    let own = starts.len().min(ensemble.bases.len());
    starts[..own].sort_by(|a, b| a.0.total_cmp(&b.0));
    let random: Vec<(f64, Vec<f64>)> = starts.drain(..own).collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let others = starts.into_iter().filter(|(margin, _)| *margin > CLOSED).take(STARTS - STARTS / 2);
    let nearest: Vec<Vec<f64>> = random.iter().take(STARTS / 2).cloned().chain(others).map(|(_, base)| base).collect();
    let random: Vec<Vec<f64>> = random.into_iter().take(ALONG).map(|(_, base)| base).collect();
    // Inside of all hypotheses, and along the edge of each: no straight way leads along an edge that slants.
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
                    format!("“{glyph}” fails{place} at the state with the smallest margin"),
                )
            };
        }
    }
    finding
}

/// The hypotheses of a claim with one of them, that is an inequality of several numbers, held just inside of its edge.
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
    let edge =
        Hypothesis { lhs: difference, relation: Relation::Equal, rhs: number, free: Vec::new(), throughout: false };
    Some(context.hypotheses.iter().cloned().chain([edge]).collect())
}

fn margin(link: &Link, state: &SampledState<'_, RunningError>) -> Option<Margin> {
    Sides::of(link, state).ok()?.margin(link.relation)
}

/// Whether a margin is lower than another. Where (x − 1)² is all there is, relative to its terms it is 1 for all negative x:
/// there the number itself shows the way.
fn is_lower(margin: &Margin, than: &Margin) -> bool {
    let by = margin.share - than.share;
    by < -FLAT || by < 0.0 && than.share < WIDE || by < FLAT && than.share > WIDE && margin.size < than.size
}

/// A way downhill.
struct Search<'a, 'm> {
    link: &'a Link,
    context: &'a Context<'m>,
    projection: Projection<'m>,
    draw: Sampler,
    /// The numbers that are moved.
    slots: Vec<usize>,
}

impl<'m> Search<'_, 'm> {
    /// A state near the bottom of the hill on which a state lies, if the inequality fails there for certain.
    fn worst_from(&mut self, start: Vec<f64>) -> Option<SampledState<'m, RunningError>> {
        let (mut margin, mut base, _) = self.at(start)?;
        self.slots = self.that_matter(&base, margin);
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
            if largest < LAST || largest < SMALL && margin.share > WIDE || margin.share.abs() < NOTHING {
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

    /// The state, if the inequality fails there for certain: clearly, or at an equality that is reached.
    fn settle(&mut self, margin: Margin, base: Vec<f64>) -> Option<SampledState<'m, RunningError>> {
        if margin.share < -DIFFERENCE {
            return self.at(base).map(|(_, _, state)| state);
        }
        if !is_strict(self.link.relation) || margin.share > CLOSED.sqrt() {
            return None;
        }
        let (margin, base) = self.simple(margin, base);
        let (_, base, state) = self.at(base).filter(|_| margin.share < CLOSED)?;
        (self.is_inside(&state) && is_reached(self.link, &mut self.projection, &base)).then_some(state)
    }

    /// Whether a state is at no end that a range or a hypothesis leaves out.
    fn is_inside(&self, state: &SampledState<'_, RunningError>) -> bool {
        let mut hypotheses = self.context.hypotheses.iter().filter_map(boundary::of_hypothesis);
        is_ordinary(state) && hypotheses.all(|hypothesis| is_clear(&hypothesis, state))
    }

    /// The state near a base, with its margin, if it obeys all hypotheses.
    fn at(&mut self, base: Vec<f64>) -> Option<(Margin, Vec<f64>, SampledState<'m, RunningError>)> {
        let (base, state) = self.projection.project(base).ok()??;
        margin(self.link, &state).map(|margin| (margin, base, state))
    }

    /// What is lower than a margin, some steps away.
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

    /// The numbers on which the margin depends, but for those that hypotheses are solved for.
    fn that_matter(&mut self, base: &[f64], margin: Margin) -> Vec<usize> {
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

    /// A number of a state some steps away, within its range.
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

    /// As far again as from one base to another.
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

    /// The same state with simple numbers in the places of those that are near to them, where that is no higher.
    fn simple(&mut self, margin: Margin, base: Vec<f64>) -> (Margin, Vec<f64>) {
        let (mut margin, mut base) = (margin, base);
        // One after the other, and again: a number may wait for another.
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
