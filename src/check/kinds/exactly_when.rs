//! Claims that hold exactly when given conditions hold, tested where these hold and where they fail.

use crate::Result;
use crate::code::Code;
use crate::formula::{Value, evaluate, text};
use crate::scalar::RunningError;

use crate::check::model::claim::{Hypothesis, Link};
use crate::check::sample::context::{Context, NO_EQUALITY};
use crate::check::sample::setting::FEWEST;
use crate::check::search::boundary;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::state::sampled_state::SampledState;
use crate::check::vacuity::forced_value;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Checks that `link` holds where all conditions of one of the alternatives hold, and nowhere else.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(link: &Link, alternatives: &[Vec<Hypothesis>], context: &Context<'_>) -> Result<Finding> {
    let conditions: Vec<&Hypothesis> = alternatives.iter().flatten().collect();
    let restates = |c: &Hypothesis| c.lhs == link.lhs && c.relation == link.relation && c.rhs == link.rhs;
    if alternatives.iter().flatten().any(restates) {
        let message = "one of the conditions is the claim itself, so nothing is checked; remove the condition";
        return Ok(context.finding(Code::Circular, Verdict::Undecided, message));
    }
    let formulas = [&link.lhs, &link.rhs].into_iter().chain(conditions.iter().flat_map(|c| [&c.lhs, &c.rhs]));
    let formulas: Vec<_> = formulas.collect();
    if let Some(finding) = context.unclear(&formulas) {
        return Ok(finding);
    }
    let mode = context.mode(context.on_shell.unwrap_or(context.model.has_motion()), &formulas);
    let ensemble = context.ensemble(mode, false, 2 * context.options.points)?;
    let stated =
        boundary::of_link(link).into_iter().chain(conditions.iter().filter_map(|c| boundary::comparison_of(c)));
    let stated: Vec<_> = stated.collect();
    let own = stated.len();
    let hypotheses = context.hypotheses.iter().filter_map(boundary::of_hypothesis);
    let comparisons: Vec<_> = stated.into_iter().chain(hypotheses).collect();
    let forced = forced_value::of_formulas(&formulas, context, &ensemble);
    let holds = |link: &Link, state: &SampledState<'_, RunningError>| match residual::test(link, state) {
        Ok(Point::Holds(_)) => Some(true),
        Ok(Point::Fails(_)) => Some(false),
        _ => None,
    };
    let (mut both, mut neither, mut other) = (0, 0, 0);
    let mut met_at = vec![0; alternatives.len()];
    let mut tried = 0;
    let mut looked_at = |state: &SampledState<'_, RunningError>, at_an_edge: bool| {
        tried += 1;
        let met = |hypothesis: &Hypothesis| {
            let Hypothesis { lhs, relation, rhs, free, .. } = hypothesis.clone();
            holds(&Link { lhs, relation, rhs, free }, state)
        };
        let alternative =
            |all: &Vec<Hypothesis>| all.iter().map(met).try_fold(true, |so_far, met| Some(so_far && met?));
        let each: Option<Vec<bool>> = alternatives.iter().map(alternative).collect();
        let any = each.as_ref().map(|each| each.contains(&true));
        for (count, met) in met_at.iter_mut().zip(each.into_iter().flatten()) {
            *count += usize::from(met);
        }
        match (holds(link, state), any) {
            (Some(true), Some(true)) => both += 1,
            (Some(false), Some(false)) => neither += 1,
            (Some(claim), Some(_)) => {
                let relation = text_of(link, context);
                let message = match claim {
                    true => format!("“{relation}” holds at this state, but none of the conditions holds"),
                    false => format!("“{relation}” fails at this state, but the conditions hold"),
                };
                let side = |expr| match evaluate(expr, state, &[]) {
                    Ok(Value::Scalar(value)) => value.value().value,
                    _ => f64::NAN,
                };
                let (lhs, rhs) = (side(&link.lhs), side(&link.rhs));
                let failure = residual::Failure { lhs, rhs, residual: 1.0, entry: None };
                return Some(Finding {
                    points: both + neither + 1,
                    tried,
                    counterexample: Some(counterexample(link, state, &failure)),
                    ..context.finding(Code::ExactlyWhenFails, Verdict::Refuted, message)
                });
            }
            _ => other += usize::from(!at_an_edge),
        }
        None
    };
    if let Some(refuted) = ensemble.states.iter().find_map(|state| looked_at(state, false)) {
        return Ok(refuted);
    }
    let special = context.special(mode)?;
    if let Some(refuted) = special.states.iter().find_map(|state| looked_at(state, false)) {
        return Ok(refuted);
    }
    let at_edges = boundary::states((&comparisons, own), context, &ensemble, &special)?;
    if let Some(refuted) = at_edges.iter().find_map(|state| looked_at(state, true)) {
        return Ok(refuted);
    }
    if both < FEWEST / 2 || neither < FEWEST / 2 || both + neither < other {
        let message =
            format!("too few sampled states: the claim holds at {both} and fails at {neither}; widen the ranges");
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    if let Some(symbol) = forced {
        return Ok(context.finding(Code::ForcedValue, Verdict::Undecided, forced_value::message(symbol, context)));
    }
    if let Some(at) = met_at.iter().position(|count| *count == 0) {
        let message = format!(
            "no sampled state satisfies alternative {} of \"true exactly when\"; remove it, or widen the ranges",
            at + 1
        );
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    let message = format!("holds at the {both} states that satisfy the conditions, and fails at the {neither} others");
    Ok(Finding { points: both + neither, tried, ..context.verified(message, NO_EQUALITY) })
}

fn text_of(link: &Link, context: &Context<'_>) -> String {
    let symbols = &context.model.symbols;
    format!("{} {} {}", text::formula(&link.lhs, symbols), link.relation.glyph(), text::formula(&link.rhs, symbols))
}
