//! States at the boundary of an inequality: where its two sides are equal, and close to it on both sides.
//!
//! Random states do not come close to the boundary, so they do not distinguish a > b, a > 1.001 b and a ≥ b. Here the
//! equality of the two sides is solved like a hypothesis.

use crate::Result;
use crate::formula::{Expr, Value};
use crate::notes::claims::Range;
use crate::scalar::{RunningError, Series, TERMS};

use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::prescribed_values::PrescribedValues;
use crate::check::state::sampled_state::SampledState;

/// The number of states from which the boundary is sought.
const FROM: usize = 4;

/// The approximate number of special states from which the boundary is sought.
const SPECIAL: usize = 32;

/// The distance of the two neighbours from the boundary, relative to the sides.
const BESIDE: f64 = 1e-4;

/// The factor between the differences of the sides at two neighbours. Where the sides cross, the numbers of the states
/// differ by the same factor. Where they touch, as a² + b² and 2ab do, they do not. Such a boundary is found to half
/// the digits, and says nothing about other comparisons.
const NEARER: f64 = 4.0;

/// The relative size from which sides that are known to half the digits certainly differ.
const CLEAR: f64 = 1e-3;

/// The distance from an open end of a range, as a fraction, below which a number is taken to approach the end.
const END: f64 = 1e-4;

/// The two sides of an inequality between scalars.
pub(crate) type Comparison = (Expr, Expr);

/// The comparison that a link makes, if it is an inequality without free indices.
pub(crate) fn of_link(link: &Link) -> Option<Comparison> {
    (!is_equality(link.relation) && link.free.is_empty()).then(|| (link.lhs.clone(), link.rhs.clone()))
}

/// The comparison that a hypothesis makes, if it is an inequality. An equality holds at all states.
pub(crate) fn of_hypothesis(hypothesis: &Hypothesis) -> Option<Comparison> {
    (!is_equality(hypothesis.relation)).then(|| comparison_of(hypothesis))?
}

/// The comparison that a hypothesis makes, also if it is an equality.
pub(crate) fn comparison_of(hypothesis: &Hypothesis) -> Option<Comparison> {
    hypothesis.free.is_empty().then(|| (hypothesis.lhs.clone(), hypothesis.rhs.clone()))
}

/// States at the boundaries of comparisons, found from states that obey the hypotheses of a claim. The first `own`
/// comparisons are the claim's: their boundaries are sought from random states. The others are of its hypotheses: their
/// boundaries are sought from special states too, since the claim may fail where both conditions meet.
///
/// # Errors
/// If the mass matrix is singular there.
pub(crate) fn states<'m>(
    (comparisons, own): (&[Comparison], usize),
    context: &Context<'m>,
    ensemble: &Ensemble<'m>,
    special: &Ensemble<'m>,
) -> Result<Vec<SampledState<'m, RunningError>>> {
    let setting = context.setting(ensemble.mode);
    let mut found = Vec::new();
    for (at, (lhs, rhs)) in comparisons.iter().enumerate() {
        if comparisons[..at].contains(&comparisons[at]) {
            continue;
        }
        let difference = lhs.clone().minus(rhs.clone());
        let mut family = PrescribedValues::new(context.model, &setting, &[difference]);
        let beside = |state: &SampledState<'_, RunningError>| {
            let sides = (state.now(lhs, &[]), state.now(rhs, &[]));
            let (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) = sides else { return None };
            Some(BESIDE * (a.magnitude + b.magnitude))
        };
        for (state, base) in ensemble.states.iter().zip(&ensemble.bases).take(FROM) {
            let Some(beside) = beside(state) else { break };
            let edge = family.at(base, &[0.0])?.filter(is_ordinary);
            let mut crosses = false;
            for value in [beside, -beside] {
                let Some(far) = family.at(base, &[value])?.filter(is_ordinary) else { continue };
                if let (Some(edge), Some(near), false) = (&edge, family.at(base, &[value / NEARER])?, crosses) {
                    crosses = distance(&far, edge) > (NEARER - 1.0) * distance(&near, edge);
                }
                found.push(far);
            }
            let others = || comparisons.iter().filter(|other| **other != comparisons[at]);
            found.extend(edge.filter(|edge| crosses || others().all(|other| is_clear(other, edge))));
        }
        let every = special.states.len().div_ceil(SPECIAL).max(1);
        let special = special.states.iter().zip(&special.bases).step_by(every);
        for (state, base) in special.filter(|_| at >= own) {
            let Some(beside) = beside(state) else { break };
            for value in [beside, -beside] {
                found.extend(family.at(base, &[value])?);
            }
        }
    }
    Ok(found)
}

/// Whether the sides of a comparison are far from equal at a state.
pub(crate) fn is_clear((lhs, rhs): &Comparison, state: &SampledState<'_, RunningError>) -> bool {
    let (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) = (state.now(lhs, &[]), state.now(rhs, &[])) else {
        return false;
    };
    let difference = a - b;
    difference.value.abs() > CLEAR * difference.magnitude
}

/// The drawn numbers of a state with their ranges, and the rates of those that vary.
fn numbers(state: &SampledState<'_, RunningError>) -> Vec<(Range, f64)> {
    let model = state.model();
    let rates = |range: &Range, series: &Series<RunningError>| -> Vec<(Range, f64)> {
        let range = |order| if order == 0 { range.clone() } else { Range::Any };
        let rate = |order| Some((range(order), series.nth_derivative_value(order)?.value));
        (0..series.known()).filter_map(rate).collect()
    };
    let constants = model.constants.iter().enumerate();
    let constants = constants.flat_map(|(i, c)| state.base.constant(i).iter().map(|x| (c.range.clone(), x.value)));
    let coordinates = model.coordinates.iter().zip(state.coordinates());
    let coordinates = coordinates.flat_map(|(q, series)| rates(&q.range, series));
    let varying = model.varying.iter().enumerate();
    let varying = varying.flat_map(|(i, f)| {
        let series = (0..f.numbers).filter_map(move |at| state.base.varying(i, at, TERMS));
        series.flat_map(|series| rates(&f.range, &series))
    });
    constants.chain(coordinates).chain(varying).collect()
}

/// The largest difference between the numbers of two states.
fn distance(a: &SampledState<'_, RunningError>, b: &SampledState<'_, RunningError>) -> f64 {
    numbers(a).iter().zip(numbers(b)).map(|((_, a), (_, b))| (a - b).abs()).fold(0.0, f64::max)
}

/// Whether no number of a state is close to an open end of its range. There both sides may be equal to rounding error,
/// though they are equal nowhere in the range.
pub(crate) fn is_ordinary(state: &SampledState<'_, RunningError>) -> bool {
    numbers(state).iter().all(|(range, x)| match range {
        Range::Positive | Range::Negative => x.abs() > END,
        Range::Interval { low, high, low_open, high_open } => {
            let near = END * (high - low);
            (!low_open || x - low > near) && (!high_open || high - x > near)
        }
        _ => true,
    })
}
