//! Claims that hold in a limit: `A ≈ B` as x → a.
//!
//! The ratio of the sides must tend to 1, or their difference to 0 where the right side is 0. The error is computed at
//! several steps towards the limit and must fall as a power of the distance, which is reported. Steps at which rounding
//! exceeds the error are not used. A number is approached from both sides, as far as the range of the symbol and the
//! hypotheses allow.
//!
//! # When ≈ holds
//!
//! The relative error is followed over eleven steps, the distance halved each time, and a power is fitted to the
//! last four above rounding. The claim is followed further, to 10⁻⁹, since √(1 + a) ≈ 1.0001 looks like an approach
//! for long; if everything is over after the first step, as for tanh a ≈ 1 − 2e⁻²ᵃ, the steps are shorter. A power
//! above 0.3 is an approach. That alone would accept 1 + a/3 for √(1 + a). So each printed term of the right side
//! must improve the power by at least ½. Where nothing is solved, the error is also enclosed at distances such as 2⁻¹⁰⁰
//! and 2⁻²⁰⁰: there an error that stays differs from one that falls slowly, as that of ln(2x)/ln x ≈ 1. The left side is free, since a limit drops its terms. A number is
//! approached from both sides, since √(a²) ≈ a holds from one side only.

use std::sync::Arc;

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, Node, SymbolId, Value};
use crate::notes::claims::Range;
use crate::scalar::{Arithmetic, Enclosure, RunningError, Series};

use crate::check::hypotheses::rule::Rule;
use crate::check::judge::mutants::{Slip, mutants_of};
use crate::check::kinds::rate::{self, Course};
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::sampling::Mode;
use crate::check::sample::context::Context;
use crate::check::sample::projection::Projection;
use crate::check::sample::setting::FEWEST;
use crate::check::state::counterexample::counterexample;
use crate::check::state::numbers::slots;
use crate::check::state::residual;
use crate::check::state::residual::{Failure, Point};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Where a limit goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Towards {
    /// `\infty`, `+\infty`
    Infinity,
    /// `-\infty`
    MinusInfinity,
    /// A number.
    Number(f64),
}

impl Towards {
    /// The limit as it is printed in messages.
    fn in_words(&self) -> String {
        match self {
            Towards::Infinity => "∞".to_owned(),
            Towards::MinusInfinity => "−∞".to_owned(),
            Towards::Number(value) => format!("{value}"),
        }
    }

    /// The value at the k-th step towards the limit, where k need not be whole; a number is approached from above, if `side`
    /// is 1, and from below, if it is −1.
    pub fn step(self, k: f64, side: f64) -> f64 {
        let far = 16.0 * k.exp2();
        match self {
            Towards::Infinity => far,
            Towards::MinusInfinity => -far,
            Towards::Number(a) => a + side / far,
        }
    }
}

/// The sides from which a number is approached within a range: 1 from above, −1 from below.
pub(crate) fn sides(range: &Range, end: f64) -> &'static [f64] {
    let is_at = |other: f64| (end - other).abs() <= 1e-9;
    match range {
        Range::Interval { high, .. } if is_at(*high) => &[-1.0],
        Range::Interval { low, .. } if is_at(*low) => &[1.0],
        Range::Positive if is_at(0.0) => &[1.0],
        Range::Negative if is_at(0.0) => &[-1.0],
        _ => &[1.0, -1.0],
    }
}

/// The approach of the two sides of a claim at one state.
enum Approach {
    /// The error falls as this power of the distance from the limit.
    Power(f64),
    /// The error does not fall, from this side, up to this step.
    Fails(Failure, f64, f64),
    /// Too few steps are usable.
    Useless,
}

/// Checks a claim in the limit of one symbol: always, else on shell.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(link: &Link, variable: SymbolId, towards: Towards, context: &Context<'_>) -> Result<Finding> {
    let always = match context.on_shell {
        Some(on_shell) => return check_in(link, variable, towards, context, on_shell),
        None => check_in(link, variable, towards, context, false)?,
    };
    if always.verdict == Verdict::Verified || !context.model.has_motion() {
        return Ok(always);
    }
    let on_shell = check_in(link, variable, towards, context, true)?;
    Ok(if on_shell.verdict == Verdict::Verified { on_shell } else { always })
}

/// The ratio of the sides far on the way to a limit, from one base each; `None` where it has no value, or comes nearer to 1.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn ratios(
    link: &Link,
    variable: SymbolId,
    towards: Towards,
    (context, count): (&Context<'_>, usize),
) -> Result<Vec<Option<f64>>> {
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, count)?;
    let of = |base: &Vec<f64>| {
        let steps = Steps { context, mode, base, rules: &ensemble.rules, variable, towards };
        let side = *steps.sides().first()?;
        let at = |k: f64| {
            let state = steps.state(k, side)?;
            let (Value::Scalar(a), Value::Scalar(b)) =
                (state.now(&link.lhs, &[]).ok()?, state.now(&link.rhs, &[]).ok()?)
            else {
                return None;
            };
            let ratio = a.value / b.value;
            let is_known = a.value.abs() > NOISE * a.magnitude && b.value.abs() > NOISE * b.magnitude;
            (ratio.is_finite() && is_known).then_some(ratio)
        };
        // Exponentials have values at short steps only.
        let (near, far) = FAR_ENOUGH.iter().find_map(|[near, far]| Some((at(*near)?, at(*far)?)))?;
        let is_settled = (near - far).abs() <= UNSETTLED * far.abs();
        // What goes away from 1 does not come back so far out.
        let goes_away = near.abs().ln().abs() > AWAY && far.abs().ln().abs() > near.abs().ln().abs();
        (is_settled || goes_away).then_some(far)
    };
    Ok(ensemble.bases.iter().map(of).collect())
}

/// Whether the sides are nearly equal where a symbol has nearly the value of a formula, at one of a few states.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn meet_at(
    link: &Link,
    variable: SymbolId,
    place: &Expr,
    (context, count): (&Context<'_>, usize),
) -> Result<bool> {
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, count)?;
    let meets = |(state, base): (&SampledState<'_, RunningError>, &Vec<f64>)| {
        let Ok(Value::Scalar(end)) = state.now(place, &[]) else { return false };
        let towards = Towards::Number(end.value);
        let steps = Steps { context, mode, base, rules: &ensemble.rules, variable, towards };
        let at = |k: f64, side: f64| {
            let state = steps.state(k, side)?;
            let value = |formula: &Expr| match state.now(formula, &[]) {
                Ok(Value::Scalar(value)) => Some(value.value),
                _ => None,
            };
            Some([value(&link.lhs)?, value(&link.rhs)?])
        };
        let is_near = |side: f64| {
            let (Some([a, b]), Some([c, d])) = (at(BESIDE, side), at(CLOSER, side)) else { return false };
            let (gap, closer) = ((a / b - 1.0).abs(), (c / d - 1.0).abs());
            // Graphs that only cross are equal at one point. Of an approximation by a formula that varies, the error falls faster than
            // the distance, unless both sides go to 0 or to infinity.
            let crosses = (c / a).ln().abs() < 1.0 && b != d && closer > gap * (1.5 * (BESIDE - CLOSER)).exp2();
            gap < UNSETTLED && !crosses
        };
        [1.0, -1.0].into_iter().any(is_near)
    };
    Ok(ensemble.states.iter().zip(&ensemble.bases).any(meets))
}

/// The step at which a symbol has nearly a value, and a later one.
const BESIDE: f64 = 8.0;
const CLOSER: f64 = 12.0;

/// Pairs of steps on the way to a limit, those farthest away first.
const FAR_ENOUGH: [[f64; 2]; 3] = [[10.0, 14.0], [4.0, 6.0], [0.0, 1.0]];

/// The relative change of a ratio between two such steps from which it is no limit.
const UNSETTLED: f64 = 0.02;

/// The logarithm of a ratio that is far from 1.
const AWAY: f64 = 2.0;

/// A value below this share of its terms may be rounding.
const NOISE: f64 = 1e-6;

fn check_in(
    link: &Link,
    variable: SymbolId,
    towards: Towards,
    context: &Context<'_>,
    on_shell: bool,
) -> Result<Finding> {
    let mode = context.mode(on_shell, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, context.options.points)?;
    if ensemble.states.is_empty() {
        return Ok(context.no_state(&ensemble));
    }
    let mut powers: Vec<f64> = Vec::new();
    let mut used: Vec<Steps<'_>> = Vec::new();
    for base in &ensemble.bases {
        let steps = Steps { context, mode, base, rules: &ensemble.rules, variable, towards };
        let approach = steps.approach(link, FARTHEST);
        let approach = match approach {
            Ok(approach) if used.len() < EXACT || matches!(approach, Approach::Fails(..)) => {
                Ok(steps.exactly(link, &ensemble.projection, approach))
            }
            approach => approach,
        };
        match approach {
            Ok(Approach::Power(power)) => {
                powers.push(power);
                used.push(steps);
            }
            Ok(Approach::Fails(failure, side, k)) => {
                return Ok(Finding {
                    points: powers.len() + 1,
                    tried: ensemble.tried,
                    max_residual: Some(failure.residual),
                    counterexample: steps.state(k, side).map(|state| counterexample(link, &state, &failure)),
                    ..context.finding(
                        Code::LimitNotReached,
                        Verdict::Refuted,
                        format!(
                            "the two sides do not approach each other in the limit {} → {}",
                            crate::formula::text::plain(&context.model.name(variable)),
                            towards.in_words()
                        ),
                    )
                });
            }
            Ok(Approach::Useless) => {}
            Err(reason) => return Ok(context.unavailable(&reason)),
        }
    }
    if powers.len() < FEWEST.min(context.options.points) {
        let message =
            format!("only {} of {} sampled states reach the limit; narrow the ranges", powers.len(), ensemble.tried);
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    // Each mutant of the right side must have a larger error. Terms on the left that vanish in the limit are not tested, so
    // there only exchanged symbols count.
    for mutant in mutants_of(link, context.model) {
        if mutant.link.rhs == link.rhs && mutant.slip != Slip::Symbol {
            continue;
        }
        let as_near = used.iter().zip(&powers).all(
            |(steps, power)| matches!(steps.approach(&mutant.link, LAST), Ok(Approach::Power(other)) if other > power - 0.5),
        );
        if as_near {
            let way_out = match towards {
                Towards::Number(_) => {
                    "the limit alone does not show the difference: write \"small\" in place of \"limit\", or widen \
                     the ranges"
                }
                _ => "widen the ranges",
            };
            let message = format!(
                "the sampled states do not distinguish this from the same claim with {}; {way_out}",
                mutant.change
            );
            return Ok(context.finding(Code::MutantPasses, Verdict::Undecided, message));
        }
    }
    let slowest = powers.iter().copied().fold(f64::INFINITY, f64::min);
    let name = crate::formula::text::plain(&context.model.name(variable));
    let distance = match towards {
        Towards::Number(_) => "of the distance from the limit".to_owned(),
        _ => format!("of 1/{name}"),
    };
    Ok(Finding {
        points: powers.len(),
        tried: ensemble.tried,
        ..context.verified(
            format!("holds in the limit; the relative error falls as the power {slowest:.1} {distance}"),
            "a limit",
        )
    })
}

/// The last step for mutants.
const LAST: i32 = 10;

/// The last step for the claim itself, since a remaining error may be small, such as 10⁻⁴ for √(1 + a) ≈ 1.0001.
const FARTHEST: i32 = 26;

/// The number of short steps before the first one, for an error that vanishes at once, such as that of tanh a ≈ 1 − 2e⁻²ᵃ.
const BEFORE: i32 = 16;

/// The number of states at which the approach is measured with many digits, and the number of bits.
const EXACT: usize = 2;
const BITS: usize = 1600;

/// The powers of 2 of the distances at which it is measured, those farthest away first.
const FAR: [[i32; 2]; 2] = [[100, 200], [12, 28]];

/// The power below which an approach may be none, and the number of steps that tell a slow one from none.
const SLOW: f64 = 0.3;
const BETWEEN: i32 = 8;

/// The length of a short step.
const SHORT: f64 = 0.25;

/// The states on the way to a limit: one base, with the variable moved.
struct Steps<'a> {
    context: &'a Context<'a>,
    mode: Mode,
    base: &'a [f64],
    rules: &'a Arc<[Rule]>,
    variable: SymbolId,
    towards: Towards,
}

impl<'a> Steps<'a> {
    /// The state at the k-th step: a number of the base is moved there, anything else is given that value.
    fn state(&self, k: f64, side: f64) -> Option<SampledState<'a, RunningError>> {
        let x = self.towards.step(k, side);
        let model = self.context.model;
        let slot = self.slot();
        let mut base: Vec<RunningError> = self.base.iter().map(|x| RunningError::new(*x)).collect();
        if let Some(slot) = slot {
            base[slot] = RunningError::new(x);
        }
        let mut state = SampledState::new(model, self.mode, &base, self.rules).ok()?;
        if slot.is_none() {
            state.set_only(&[(self.variable, Series::constant(RunningError::new(x)))]);
        }
        Some(state)
    }

    /// The number of the base that is moved.
    fn slot(&self) -> Option<usize> {
        let slots = slots(self.context.model, self.mode);
        slots.iter().position(|slot| slot.symbol == Some(self.variable) && slot.order == 0)
    }

    /// The sides from which the limit is approached.
    fn sides(&self) -> Vec<f64> {
        let Towards::Number(end) = self.towards else { return vec![1.0] };
        let context = self.context;
        if self.slot().is_none() {
            // A dependent quantity approaches from the side on which the state has it.
            let base: Vec<RunningError> = self.base.iter().map(|x| RunningError::new(*x)).collect();
            let name = Expr::new(Node::Symbol { id: self.variable, indices: Vec::new(), dots: 0 }, context.span);
            let state = SampledState::new(context.model, self.mode, &base, self.rules).ok();
            let value = state.map(|state| state.now(&name, &[]));
            let is_below = matches!(value, Some(Ok(Value::Scalar(value))) if value.value < end);
            return vec![if is_below { -1.0 } else { 1.0 }];
        }
        let range = context.model.range(self.variable);
        sides(&range, end).iter().copied().filter(|side| self.is_allowed(*side)).collect()
    }

    /// Whether the hypotheses that are inequalities hold on the way to the limit.
    fn is_allowed(&self, side: f64) -> bool {
        let inequalities = || self.context.hypotheses.iter().filter(|hypothesis| !is_equality(hypothesis.relation));
        if inequalities().next().is_none() {
            return true;
        }
        let Some(state) = self.state(LAST.into(), side) else { return false };
        inequalities().all(|hypothesis| {
            let Hypothesis { lhs, relation, rhs, free, .. } = hypothesis.clone();
            !matches!(residual::test(&Link { lhs, relation, rhs, free }, &state), Ok(Point::Fails(_)))
        })
    }

    /// How the sides of a link approach each other up to a step, the slower of the two ways where there are two.
    fn approach(&self, link: &Link, last: i32) -> Result<Approach, Unavailable> {
        let mut slowest = Approach::Useless;
        for side in self.sides() {
            slowest = match (slowest, self.approach_from(side, link, last)?) {
                (_, Approach::Fails(failure, side, k)) => return Ok(Approach::Fails(failure, side, k)),
                (Approach::Power(a), Approach::Power(b)) => Approach::Power(a.min(b)),
                (Approach::Useless, other) | (other, Approach::Useless) => other,
                (fails @ Approach::Fails(..), _) => fails,
            };
        }
        Ok(slowest)
    }

    /// The approach as many digits show it, where they are known: a difference that stays is no approach, however small,
    /// and one that falls more slowly than any power is one.
    fn exactly(&self, link: &Link, projection: &Projection<'_>, approach: Approach) -> Approach {
        let Some(slot) = self.slot() else { return approach };
        let mut slowest: Option<f64> = None;
        for side in self.sides() {
            let gaps = |k: i32| {
                let numbers = || {
                    let mut numbers: Vec<Enclosure> = self.base.iter().map(|x| Enclosure::exact(*x)).collect();
                    let far = 2f64.powi(k);
                    numbers[slot] = match self.towards {
                        Towards::Infinity => Enclosure::exact(far),
                        Towards::MinusInfinity => Enclosure::exact(-far),
                        Towards::Number(a) => Enclosure::constant(a) + Enclosure::exact(side / far),
                    };
                    numbers
                };
                rate::gaps(link, projection, &numbers, (BITS, true))
            };
            // An exponential of a very large number is beyond these numbers too.
            let found = FAR.iter().find_map(|[near, far]| {
                Some((rate::slowest(&gaps(*near)?, &gaps(*far)?, f64::from(far - near)), [*near, *far]))
            });
            let Some(((power, last), [near, far])) = found else { return approach };
            if let Some((_, nearer)) = last.filter(|_| power < SLOW) {
                let between: Option<Vec<_>> =
                    (0..BETWEEN).map(|k| gaps(near + k * (far - near) / (BETWEEN - 1))).collect();
                match between.map_or(Course::Unclear, |steps| rate::course(&steps)) {
                    Course::Falls => {}
                    Course::Stays => return self.failure(link, side, nearer.size),
                    Course::Unclear => return Approach::Useless,
                }
            }
            slowest = Some(slowest.map_or(power, |slowest| slowest.min(power)));
        }
        match (approach, slowest) {
            (Approach::Power(known), Some(power)) => Approach::Power(if power.is_finite() { power } else { known }),
            (Approach::Fails(..), Some(power)) => Approach::Power(power),
            (approach, _) => approach,
        }
    }

    /// The failure of an approach whose error stays: at the last step at which doubles hold both sides.
    fn failure(&self, link: &Link, side: f64, residual: f64) -> Approach {
        let at = |k: f64| {
            let state = self.state(k, side)?;
            let (a, b) = (state.now(&link.lhs, &[]).ok()?, state.now(&link.rhs, &[]).ok()?);
            let (Value::Scalar(a), Value::Scalar(b)) = (a, b) else { return None };
            let are_numbers = a.value.is_finite() && b.value.is_finite();
            are_numbers.then_some(Approach::Fails(
                Failure { lhs: a.value, rhs: b.value, residual, entry: None },
                side,
                k,
            ))
        };
        (0..=FARTHEST).rev().find_map(|k| at(f64::from(k))).unwrap_or(Approach::Useless)
    }

    fn approach_from(&self, side: f64, link: &Link, last: i32) -> Result<Approach, Unavailable> {
        let mut errors = self.errors(link, side, (0..=last).map(f64::from))?;
        if errors.list.len() < 3 {
            let before = errors.list.len() as i32 - 1;
            let closer = (-BEFORE..=before * (1.0 / SHORT) as i32).map(|k| SHORT * f64::from(k));
            errors = self.errors(link, side, closer)?;
        }
        let Errors { list, last: Some((failure, k)) } = errors else { return Ok(Approach::Useless) };
        let tail = &list[list.len().saturating_sub(4)..];
        let ([(first, more), .., (end, less)], 3..) = (tail, list.len()) else {
            // Sides that are equal within rounding agree in the limit.
            return Ok(if failure.residual < 1e-9 { Approach::Power(f64::INFINITY) } else { Approach::Useless });
        };
        let power = (more / less).log2() / (end - first);
        Ok(if power > 0.3 && *less < 0.05 { Approach::Power(power) } else { Approach::Fails(failure, side, k) })
    }

    /// The relative errors at some steps, as long as rounding leaves any.
    fn errors(&self, link: &Link, side: f64, steps: impl Iterator<Item = f64>) -> Result<Errors, Unavailable> {
        let mut errors = Errors { list: Vec::new(), last: None };
        for k in steps {
            let Some(state) = self.state(k, side) else { continue };
            let (Value::Scalar(a), Value::Scalar(b)) = (state.now(&link.lhs, &[])?, state.now(&link.rhs, &[])?) else {
                return Err(Unavailable::Operation("a limit of something that is not a number"));
            };
            if !a.value.is_finite() || !b.value.is_finite() {
                continue;
            }
            let scale = if b.value == 0.0 { 1.0 } else { b.value.abs() };
            let error = (a.value - b.value).abs() / scale;
            let noise = 1e-13 * (a.magnitude + b.magnitude) / scale;
            errors.last = Some((Failure { lhs: a.value, rhs: b.value, residual: error, entry: None }, k));
            if error <= noise {
                break;
            }
            errors.list.push((k, error));
        }
        Ok(errors)
    }
}

/// The steps towards a limit with their errors, and the last state.
struct Errors {
    list: Vec<(f64, f64)>,
    last: Option<(Failure, f64)>,
}
