//! A claim at a sampled state, decided with as many digits as it needs.
//!
//! Doubles screen. What they cannot decide, and what they accept or refute by a small margin, is evaluated again at the
//! same state over [`Enclosure`]s of rising precision. The sides differ if their difference excludes 0, and agree if it
//! contains 0 and is below 10⁻⁶⁰ of the size of their terms; for printed numbers of more digits, below all of these. A state that solves hypotheses is refined to the same
//! precision first.
//!
//! What rests on a quadrature, on eigenvectors, or on a double in a Lagrangian that is no short decimal, is known to the digits of a
//! double and no further. It stays open here, and what the doubles say of it stands.

use nalgebra::DVector;
use num_dual::DualStruct;

use crate::formula::evaluate::constant_exponent;
use crate::formula::{Expr, IndexId, Node, Relation, Value};
use crate::scalar::enclosure::{Enclosure, evaluate_to, has_absorbed};
use crate::scalar::{Primal, RunningError};

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::{Meaning, ParticleQuantity, Quantity};
use crate::check::model::state_cache::Row;
use crate::check::sample::projection::Projection;
use crate::check::state::residual;
use crate::check::state::residual::{DIFFERENCE, Failure, Point};
use crate::check::state::sampled_state::SampledState;

/// The precisions that are tried in turn, in bits.
const PRECISIONS: [usize; 3] = [320, 640, 1280];

/// The precision for one state of each claim that agrees at the lower ones.
const FINEST: usize = 2000;

/// The number of results that one evaluation may take.
const STEPS: usize = 60_000;

/// Sides whose difference is below this power of 2 of their terms agree: 6·10⁻⁶¹.
const AGREEMENT: f64 = -200.0;

/// The number of printed digits that a claim may have before it is tested to more of them, and the bits of each.
const USUAL_DIGITS: f64 = 40.0;
const BITS_PER_DIGIT: f64 = 3.33;

/// The largest number of bits that are added for printed digits.
const MOST_PRINTED_BITS: f64 = 2400.0;

/// The largest depth of definitions within definitions.
const DEEPEST: usize = 8;

/// A state that solves hypotheses is a solution to this power of 2, relative to its numbers.
const SOLVED: f64 = -256.0;

/// The smallest difference that counts at a state that solves hypotheses, as a power of 2 of the terms.
const CLEAR_AT_SOLUTION: f64 = -120.0;

/// The largest number of steps in which a state is refined; each gains about ten digits.
const REFINEMENTS: usize = 16;

/// A difference above this power of 2 that contains 0 is not known better at a higher precision.
const HOPELESS: f64 = -90.0;

/// Failures by less than this, relative to the terms, are evaluated again.
const MARGIN: f64 = 1e-6;

/// As [`MARGIN`], at states that solve hypotheses.
const MARGIN_AT_SOLUTION: f64 = 1e-3;

/// Values beyond this, or below its inverse, may have lost digits to overflow or underflow.
const EXTREME: f64 = 1e150;

/// What is known of the two sides of an equality at a state.
#[derive(Debug)]
pub(crate) enum Decision {
    /// They agree.
    Agree,
    /// They agree to all digits, but a term was too small beside another one to be seen: 1 + e⁻⁵⁰⁰⁰.
    Absorbed,
    /// They differ.
    Differ(Failure),
    /// Neither is certain.
    Open,
}

/// Replaces what doubles say of an equality at a state by what is certain, where doubles may err.
pub(crate) fn settled(
    point: Point,
    link: &Link,
    state: &SampledState<'_, RunningError>,
    projection: &Projection<'_>,
) -> Point {
    let is_open = match &point {
        Point::Doubtful => true,
        Point::Fails(failure) => {
            let margin = if projection.equalities().next().is_some() { MARGIN_AT_SOLUTION } else { MARGIN };
            let is_extreme = |x: f64| !(EXTREME.recip()..EXTREME).contains(&x.abs());
            failure.residual < margin || is_extreme(failure.lhs) || is_extreme(failure.rhs)
        }
        _ => false,
    };
    if !is_open {
        return point;
    }
    match decided(link, state, projection) {
        Decision::Agree => Point::Holds(AGREEMENT.exp2()),
        Decision::Differ(failure) => Point::Fails(failure),
        Decision::Absorbed => Point::Doubtful,
        Decision::Open => point,
    }
}

/// Whether a difference is too small for doubles to show it.
pub(crate) fn is_beyond_doubles(failure: &Failure) -> bool {
    failure.residual < DIFFERENCE
}

/// Decides an equality at a state.
pub(crate) fn decided(link: &Link, state: &SampledState<'_, RunningError>, projection: &Projection<'_>) -> Decision {
    decided_in(&PRECISIONS, link, state, projection)
}

/// Decides an equality at a state with the highest precision at once: 1 − tanh 100 is 10⁻⁸⁷.
pub(crate) fn decided_finely(
    link: &Link,
    state: &SampledState<'_, RunningError>,
    projection: &Projection<'_>,
) -> Decision {
    decided_in(&[FINEST], link, state, projection)
}

fn decided_in(
    precisions: &[usize],
    link: &Link,
    state: &SampledState<'_, RunningError>,
    projection: &Projection<'_>,
) -> Decision {
    let is_equality = matches!(link.relation, Relation::Equal | Relation::Identical);
    if !is_equality || !state.is_as_drawn() || is_found_in_doubles(state.model()) {
        return Decision::Open;
    }
    let base: Vec<f64> = state.base.numbers().iter().map(|x| x.value).collect();
    let printed = printed_bits(link, state.model());
    let mut last = Decision::Open;
    for bits in precisions {
        let found = evaluate_to(bits + printed, STEPS, || at_precision(link, state, projection, &base, printed as f64));
        match found {
            // More digits may show the term.
            Some(Ok(Decision::Absorbed)) => last = Decision::Absorbed,
            Some(Ok(decision)) => return decision,
            Some(Err(width)) if width < HOPELESS - printed as f64 => {}
            _ => return Decision::Open,
        }
    }
    last
}

/// The number of bits that the printed numbers of a claim have beyond those that any claim is tested to: two numbers of a
/// hundred digits may differ in the last one, and 10⁻⁸⁰ is printed with two digits.
fn printed_bits(link: &Link, model: &Model) -> usize {
    fn digits(expr: &Expr, model: &Model, depth: usize) -> f64 {
        let own = match &expr.node {
            Node::Number(digits) => digits.len() as f64,
            Node::Power(base, exponent) => {
                let times = constant_exponent(exponent).map_or(0.0, |times| times.value().abs());
                times * base.as_digits().map_or(0.0, |digits| digits.len() as f64)
            }
            Node::Symbol { id, .. } if depth < DEEPEST => match model.meaning(*id) {
                Some(Meaning::Defined(formula)) => digits(formula, model, depth + 1),
                _ => 0.0,
            },
            _ => 0.0,
        };
        expr.children().into_iter().map(|child| digits(child, model, depth)).fold(own, |a, b| a + b)
    }
    let all = digits(&link.lhs, model, 0) + digits(&link.rhs, model, 0);
    let beyond = (all - USUAL_DIGITS).max(0.0) * BITS_PER_DIGIT;
    beyond.min(MOST_PRINTED_BITS) as usize
}

/// Whether a model has values that a double's digits end: a quadrature, eigenvectors, a Legendre transform by Newton's
/// method.
pub(crate) fn is_found_in_doubles(model: &Model) -> bool {
    let is_in_doubles = |meaning: &Meaning| match meaning {
        Meaning::Particles(quantity, ..) => *quantity != ParticleQuantity::InertiaTensor,
        Meaning::System(quantity) => *quantity == Quantity::EffectivePotential,
        _ => false,
    };
    !model.continua.is_empty() || model.meanings.iter().flatten().any(is_in_doubles)
}

/// Whether a number is certainly negative at a state that solves nothing, however close to 0 it is.
pub(crate) fn is_negative(formula: &Expr, state: &SampledState<'_, RunningError>, projection: &Projection<'_>) -> bool {
    if !state.is_as_drawn() || is_found_in_doubles(state.model()) || !projection.record.plan.is_empty() {
        return false;
    }
    let base: Vec<f64> = state.base.numbers().iter().map(|x| x.value).collect();
    let found = evaluate_to(PRECISIONS[0], STEPS, || {
        let state = projection.state(&refined(&base, projection)?, projection.mode.order + 1).ok()?;
        let Value::Scalar(Primal(value)) = state.instant(formula, &[]).ok()? else { return None };
        Some(value.is_known() && value.excludes_zero() && value.re() < 0.0)
    });
    found.unwrap_or(false)
}

/// The decision at one precision, or how wide the difference is at most, as a power of 2 of the terms; `None` where a
/// side has no value.
fn at_precision(
    link: &Link,
    measured: &SampledState<'_, RunningError>,
    projection: &Projection<'_>,
    base: &[f64],
    printed: f64,
) -> Option<Result<Decision, f64>> {
    let numbers = refined(base, projection)?;
    let state = projection.state(&numbers, projection.mode.order + 1).ok()?;
    let is_solved = !projection.record.plan.is_empty();
    let mut widest = f64::NEG_INFINITY;
    let mut indices: Vec<(IndexId, u8)> = link.free.iter().map(|id| (*id, 1)).collect();
    loop {
        let (lhs, rhs) = (state.instant(&link.lhs, &indices).ok()?, state.instant(&link.rhs, &indices).ok()?);
        let shape = if link.lhs.is_zero() { rhs.shape() } else { lhs.shape() };
        let scales = terms(link, measured, &indices);
        let (a, b) = residual::pair(lhs, rhs);
        for (k, (Primal(a), Primal(b))) in a.into_iter().zip(b).enumerate() {
            let difference = a - b;
            if !difference.is_known() {
                return None;
            }
            let scale = a.log2().max(b.log2()).max(scales.get(k).copied().unwrap_or(f64::NEG_INFINITY));
            let size = difference.log2() - scale;
            let is_agreement = size.is_nan() || size == f64::NEG_INFINITY || size < AGREEMENT - printed;
            if is_agreement && (is_solved || !difference.excludes_zero()) {
                continue;
            }
            if difference.excludes_zero() && (!is_solved || size > CLEAR_AT_SOLUTION) {
                let (lhs, rhs) = (a.re(), b.re());
                let entry = residual::entry_label(&state, &indices, shape, k);
                return Some(Ok(Decision::Differ(Failure { lhs, rhs, residual: size.min(0.0).exp2(), entry })));
            }
            widest = widest.max(size);
        }
        if !residual::advance(&mut indices, &state).ok()? {
            break;
        }
    }
    Some(match widest == f64::NEG_INFINITY {
        true if has_absorbed() => Ok(Decision::Absorbed),
        true => Ok(Decision::Agree),
        false => Err(widest),
    })
}

/// The base-2 logarithm of the size of the terms of both sides, entry by entry, as doubles know it.
fn terms(link: &Link, measured: &SampledState<'_, RunningError>, indices: &[(IndexId, u8)]) -> Vec<f64> {
    let side = |side| measured.now(side, indices).ok();
    let Some((lhs, rhs)) = side(&link.lhs).zip(side(&link.rhs)) else { return Vec::new() };
    let (a, b): (Vec<RunningError>, _) = residual::pair::<RunningError>(lhs, rhs);
    let size = |(a, b): (&RunningError, &RunningError)| (a.magnitude + b.magnitude).log2();
    let sizes = a.iter().zip(&b).map(size);
    sizes.map(|size| if size.is_finite() { size } else { f64::NEG_INFINITY }).collect()
}

/// The numbers of a state, exactly. Where hypotheses are solved they are the middle of a solution to many digits, found
/// from the doubles by Newton's method with a fixed Jacobian; `None` if that does not converge.
fn refined(base: &[f64], projection: &Projection<'_>) -> Option<Vec<Enclosure>> {
    let mut numbers: Vec<Enclosure> = base.iter().map(|x| Enclosure::exact(*x)).collect();
    let plan = &projection.record.plan;
    if plan.is_empty() {
        return projection.equalities().next().is_none().then_some(numbers);
    }
    let (jacobian, _) = projection.linearised(base, plan).ok()??;
    let solver = jacobian.lu();
    let rows: Vec<Row> = plan.iter().map(|(row, _)| *row).collect();
    for _ in 0..REFINEMENTS {
        let state = projection.state(&numbers, projection.terms).ok()?;
        let values = projection.values(&state, &rows)?;
        if values.iter().any(|value| !value.is_known()) {
            return None;
        }
        let step = solver.solve(&DVector::from_iterator(values.len(), values.iter().map(DualStruct::re)))?;
        let mut is_solved = true;
        for ((_, slot), step) in plan.iter().zip(step.iter()) {
            let moved = (numbers[*slot] - Enclosure::exact(*step)).middle();
            is_solved &= step.abs().log2() < SOLVED + moved.log2().max(0.0);
            numbers[*slot] = moved;
        }
        if is_solved {
            return Some(numbers);
        }
    }
    None
}
