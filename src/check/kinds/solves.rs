//! Claims that formulas solve an earlier equation for an unknown.
//!
//! Each printed branch put in for the unknown makes the equation hold; the branches differ; and the equation has no other
//! real root. Roots are counted by the signs of the equation on a grid of both signs that is logarithmic in the unknown.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, SymbolId, Value};
use crate::notes::claims::Range;
use crate::scalar::{RunningError, Series};

use crate::check::certificate::solutions::certify_solutions;
use crate::check::judge::mutants::mutants_of;
use crate::check::model::claim::Link;
use crate::check::sample::context::Context;
use crate::check::sample::sampler::contains;
use crate::check::sample::setting::FEWEST;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::{Failure, Point};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The decades of the unknown that are searched for roots, either way from one.
const DECADES: i32 = 7;

/// Grid points in a decade.
const PER_DECADE: i32 = 8;

/// Checks that `branch` is a solution of `target` for `unknown`; there may be others.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check_branch(target: &Link, unknown: SymbolId, branch: &Expr, context: &Context<'_>) -> Result<Finding> {
    put_in_and_count(target, unknown, std::slice::from_ref(branch), false, context)
}

/// Checks that `branches` are the solutions of `target` for `unknown`, and all of them.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(target: &Link, unknown: SymbolId, branches: &[Expr], context: &Context<'_>) -> Result<Finding> {
    put_in_and_count(target, unknown, branches, true, context)
}

fn put_in_and_count(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    all_of_them: bool,
    context: &Context<'_>,
) -> Result<Finding> {
    if !mentions(&target.lhs, unknown) && !mentions(&target.rhs, unknown) {
        let name = context.model.name(unknown);
        return Ok(context.finding(
            Code::VariableAbsent,
            Verdict::Undecided,
            format!("{name} does not occur in the equation to be solved; correct the name"),
        ));
    }
    let mut formulas = vec![&target.lhs, &target.rhs];
    formulas.extend(branches);
    let mode = context.mode(false, &formulas);
    // Where the roots are not real there is nothing to put in, so more states are drawn than are asked for.
    let mut ensemble = context.ensemble(mode, false, 3 * context.options.points)?;
    if ensemble.states.is_empty() {
        return Ok(context.no_state(&ensemble));
    }
    let (mut points, mut residual, mut counted) = (0, 0.0_f64, 0);
    let mut used: Vec<usize> = Vec::new();
    for at in 0..ensemble.states.len() {
        if points == context.options.points {
            break;
        }
        let state = &mut ensemble.states[at];
        let mut roots = Vec::new();
        for branch in branches {
            match state.now(branch, &[]) {
                Ok(Value::Scalar(root)) if root.value.is_finite() => roots.push(root),
                Ok(_) => {}
                Err(reason) => return Ok(context.unavailable(&reason)),
            }
        }
        if roots.len() < branches.len() {
            continue;
        }
        for root in &roots {
            match put_in(target, unknown, *root, state) {
                Ok(Point::Holds(found)) => residual = residual.max(found),
                Ok(Point::Fails(failure)) => {
                    state.set_only(&[(unknown, Series::constant(*root))]);
                    return Ok(refuted(target, context, state, &failure, points));
                }
                Ok(_) => {}
                Err(reason) => return Ok(context.unavailable(&reason)),
            }
        }
        for (i, a) in roots.iter().enumerate() {
            if roots[..i].iter().any(|b| residual::vanishes(*a - *b)) {
                return Ok(context.finding(
                    Code::RepeatedSolution,
                    Verdict::Refuted,
                    "two branches are the same solution",
                ));
            }
        }
        let all = if all_of_them { count_roots(target, unknown, state) } else { roots.len() };
        if all > roots.len() {
            let message = format!("the equation has {all} real solutions, but the notes give {}", roots.len());
            let failure = Failure { lhs: all as f64, rhs: roots.len() as f64, residual: 1.0, entry: None };
            let counterexample = Some(counterexample(target, state, &failure));
            return Ok(Finding {
                counterexample,
                ..context.finding(Code::MissingSolutions, Verdict::Refuted, message)
            });
        }
        counted += usize::from(all == roots.len());
        points += 1;
        used.push(at);
    }
    if points < FEWEST.min(context.options.points) {
        let message =
            format!("only {points} of {} sampled states have real solutions; narrow the ranges", ensemble.tried);
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    if 2 * counted < points {
        let message =
            format!("the roots on the grid are the given ones at only {counted} of {points} states; narrow the ranges");
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    // The mutant of one branch may be the other; the whole is held against its mutants_of, not each branch.
    if all_of_them && let Some(change) = survivor(target, unknown, branches, context, &mut ensemble.states, &used) {
        let message = format!("the sampled states cannot tell this from the same solution with {change}");
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    let number = branches.len();
    let message = match all_of_them {
        true => {
            format!("{number} of {number} real solutions; all roots found on the grid at {counted} of {points} states")
        }
        false => "this satisfies the equation".to_owned(),
    };
    let finding = Finding {
        points,
        tried: ensemble.tried,
        max_residual: Some(residual),
        ..context.finding(Code::Holds, Verdict::Verified, message)
    };
    Ok(certify_solutions(target, unknown, branches, all_of_them, context, &ensemble).stamp(finding))
}

/// A mutant of a branch that solves the equation as well.
fn survivor(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    context: &Context<'_>,
    states: &mut [SampledState<'_, RunningError>],
    used: &[usize],
) -> Option<String> {
    for branch in branches {
        let zero = Expr::integer(0, branch.span);
        let link = Link { lhs: zero, relation: target.relation, rhs: branch.clone(), free: Vec::new() };
        for mutant in mutants_of(&link, context.model) {
            let survives = used.iter().all(|at| {
                let state = &mut states[*at];
                let Ok(Value::Scalar(value)) = state.now(&mutant.link.rhs, &[]) else { return false };
                if !contains(&context.model.range(unknown), value.value) {
                    return false;
                }
                // Another branch is a solution too; then the printed one is the mutant of that.
                let other = branches.iter().any(
                    |other| matches!(state.now(other, &[]), Ok(Value::Scalar(r)) if residual::vanishes(r - value)),
                );
                !other && matches!(put_in(target, unknown, value, state), Ok(Point::Holds(_) | Point::Useless))
            });
            if survives {
                return Some(mutant.change);
            }
        }
    }
    None
}

fn put_in(
    target: &Link,
    unknown: SymbolId,
    value: RunningError,
    state: &mut SampledState<'_, RunningError>,
) -> Result<Point, crate::formula::Unavailable> {
    state.set_only(&[(unknown, Series::constant(value))]);
    let point = residual::test(target, state);
    state.set_only(&[]);
    point
}

fn refuted(
    target: &Link,
    context: &Context<'_>,
    state: &SampledState<'_, RunningError>,
    failure: &Failure,
    points: usize,
) -> Finding {
    let message = "this does not satisfy the equation that it should solve";
    Finding {
        points: points + 1,
        max_residual: Some(failure.residual),
        counterexample: Some(counterexample(target, state, failure)),
        ..context.finding(Code::NotASolution, Verdict::Refuted, message)
    }
}

/// How many real roots `target` has in the unknown at a state.
fn count_roots(target: &Link, unknown: SymbolId, state: &mut SampledState<'_, RunningError>) -> usize {
    let range = state.model().range(unknown);
    let roots = roots_on_the_grid(&range, |x| {
        state.set_only(&[(unknown, Series::from_derivatives(&[RunningError::new(x)]))]);
        match (state.now(&target.lhs, &[]), state.now(&target.rhs, &[])) {
            (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) => (a - b).value,
            _ => f64::NAN,
        }
    });
    state.set_only(&[]);
    roots
}

/// How many real roots a function has within a range, on a logarithmic grid of both signs: its changes of sign, and those that it
/// makes twice between two points of the grid, which show as a dip towards zero.
pub fn roots_on_the_grid(range: &Range, mut value_at: impl FnMut(f64) -> f64) -> usize {
    let exponents = -DECADES * PER_DECADE..=DECADES * PER_DECADE;
    // Off the round numbers, where roots of examples lie.
    let positive: Vec<f64> = exponents.map(|k| 1.0123 * 10f64.powf(f64::from(k) / f64::from(PER_DECADE))).collect();
    let grid = positive.iter().rev().map(|x| -x).chain([0.0]).chain(positive.iter().copied());
    let grid = grid.filter(|x| contains(range, *x));
    let points: Vec<(f64, f64)> = grid.map(|x| (x, value_at(x))).filter(|(_, value)| value.is_finite()).collect();
    let changes = points.windows(2).filter(|pair| pair[0].1 * pair[1].1 < 0.0).count();
    let zeros = points.iter().filter(|(_, value)| *value == 0.0).count();
    let is_dip = |triple: &&[(f64, f64)]| {
        let [a, b, c] = [triple[0].1, triple[1].1, triple[2].1];
        a * b > 0.0 && b * c > 0.0 && b.abs() <= a.abs() && b.abs() <= c.abs()
    };
    let dips: Vec<[f64; 3]> =
        points.windows(3).filter(is_dip).map(|triple| [triple[0].0, triple[2].0, triple[1].1.signum()]).collect();
    let twice = dips.into_iter().map(|[low, high, sign]| {
        let scale = (sign * value_at(low)).max(sign * value_at(high));
        let (lowest, _) = lowest(low, high, |x| sign * value_at(x));
        // A touch is one root, a passage is two.
        if lowest < -1e-13 * scale { 2 } else { usize::from(lowest <= 1e-13 * scale) }
    });
    changes + zeros + twice.sum::<usize>()
}

/// The lowest value of a function between two points, and where it is, by golden section; the search ends below zero.
pub fn lowest(mut low: f64, mut high: f64, mut value_at: impl FnMut(f64) -> f64) -> (f64, f64) {
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let mut best = (f64::INFINITY, low);
    for _ in 0..80 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        let (at_a, at_b) = (value_at(a), value_at(b));
        for found in [(at_a, a), (at_b, b)] {
            if found.0 < best.0 {
                best = found;
            }
        }
        if best.0 < 0.0 {
            break;
        }
        if at_a < at_b {
            high = b;
        } else {
            low = a;
        }
    }
    best
}

/// Whether a symbol occurs in a formula.
pub fn mentions(expr: &Expr, id: SymbolId) -> bool {
    expr.symbols().iter().any(|(known, _)| *known == id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_counted_far_apart_and_close_together() {
        let between = |a: f64, b: f64| roots_on_the_grid(&Range::Any, |x| (x - a) * (x - b));
        assert_eq!(between(1.0, 1000.0), 2);
        assert_eq!(between(1.0, 1.0001), 2);
        assert_eq!(between(-3.0, 0.02), 2);
        assert_eq!(roots_on_the_grid(&Range::Any, |x| (x - 2.0) * (x - 2.0)), 1);
        assert_eq!(roots_on_the_grid(&Range::Any, |x| x * x + 1e-6), 0);
        assert_eq!(roots_on_the_grid(&Range::Any, |x| (x - 2.0) * (x - 2.0) + 1e-9), 0);
        assert_eq!(roots_on_the_grid(&Range::Any, |x| 3.0 * x - 1.0), 1);
    }
}
