//! States of all orders of magnitude, for equalities that may hold on one branch only.
//!
//! |p − 5| = 5 − p holds for all p of order one, but not for all p > 0. A formula with a root, an absolute value, a
//! logarithm or an inverse function may change where its numbers are large, of the other sign, or angles of many turns.
//! A formula without these is the same everywhere and is not tested here. A difference counts if it is large and its
//! numbers are far from overflow. A missing value counts if it is the root or the logarithm of a negative number, for
//! example. All other differences may be rounding error and are ignored.
//!
//! # Why some equalities are tested again, far away
//!
//! States are of order one, so that rounding stays small and no term is lost. A polynomial or a sine is the same
//! formula everywhere. A root, an absolute value and an inverse function are not: |p − 5| = 5 − p holds up to 5.
//! Only these are tested again; certified ones only for where a side has a value, since a field knows all values of
//! a root and not where it has none. Far out exponentials overflow and rounding grows. So a difference counts only
//! if it is large and no number in it is near overflow, and a missing value only if it is the root or logarithm of
//! a negative number.

use crate::Result;
use crate::code::Code;
use crate::formula::tree::Function;
use crate::formula::{Expr, Node, SymbolId, Value};
use crate::scalar::RunningError;

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::{Meaning, ParticleQuantity};
use crate::check::model::sampling::{Mode, Spread};
use crate::check::sample::context::Context;
use crate::check::sample::enclosed;
use crate::check::sample::enclosed::Decision;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::projection::Projection;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::{Failure, Point};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The number of states.
const STATES: usize = 32;

/// The relative size from which a difference counts.
const GROSS: f64 = 1e-6;

/// The magnitude beyond which a number, or its inverse, is close to overflow.
const HUGE: f64 = 1e60;

/// How a formula may change where its numbers are not of order one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Branches {
    /// It is the same everywhere.
    None,
    /// It may be on another branch.
    Changes,
    /// It may have no value.
    Ends,
}

/// The finding on an equality that passed at states of order one, tested again at states of all magnitudes.
///
/// # Errors
/// If the mass matrix of the system is singular at all of them.
pub(crate) fn at_all_magnitudes(link: &Link, context: &Context<'_>, mode: Mode, finding: Finding) -> Result<Finding> {
    let branches = of(&link.lhs, context.model).max(of(&link.rhs, context.model));
    // A prime field tests all branches of a root, but not where it has no value.
    let is_open = match finding.verdict {
        Verdict::Verified => branches > Branches::None,
        Verdict::Certified => branches == Branches::Ends,
        _ => false,
    };
    if !is_open {
        return Ok(finding);
    }
    let setting = Context { spread: Spread::AllMagnitudes, ..*context }.setting(mode);
    let states = Ensemble::draw(context.model, &setting, STATES, &mut context.draw(mode, "wide"))?;
    let message = "the two sides agree where all numbers are of order one, but differ at this state";
    Ok(judged(link, context, (&states.projection, &states.states), message, &finding).unwrap_or(finding))
}

/// The finding that an equality which passed fails at one of these states, or that a side has no value there; `message`
/// says that the sides differ.
pub(crate) fn judged(
    link: &Link,
    context: &Context<'_>,
    (projection, states): (&Projection<'_>, &[SampledState<'_, RunningError>]),
    message: &str,
    passed: &Finding,
) -> Option<Finding> {
    // What an iteration finds in doubles is as accurate as the numbers are alike, which these are not.
    let is_iterated = projection.equalities().next().is_some() || has_eigenvectors(link, context.model);
    let mut ends = None;
    let found = |(code, verdict), message: &str, state, failure: Failure| Finding {
        points: passed.points,
        tried: passed.tried + states.len(),
        max_residual: if verdict == Verdict::Refuted { Some(failure.residual) } else { passed.max_residual },
        counterexample: Some(counterexample(link, state, &failure)),
        ..context.finding(code, verdict, message)
    };
    for state in states {
        let point = residual::test(link, state).map(|point| match point {
            Point::Fails(failure) => match enclosed::decided(link, state, projection) {
                Decision::Agree | Decision::Absorbed => Point::Useless,
                Decision::Differ(failure) => Point::Fails(failure),
                Decision::Open if failure.residual > GROSS && !is_iterated && is_moderate(link, state) => {
                    Point::Fails(failure)
                }
                Decision::Open => Point::Doubtful,
            },
            point => point,
        });
        match point {
            Ok(Point::Fails(failure)) => {
                return Some(found((Code::SidesDiffer, Verdict::Refuted), message, state, failure));
            }
            Ok(Point::OneSided(failure)) if ends.is_none() && residual::has_its_names(link, state) => {
                let side = if failure.lhs.is_finite() { &link.rhs } else { &link.lhs };
                ends = has_no_value(side, state, projection).then_some((state, failure));
            }
            _ => {}
        }
    }
    let (state, failure) = ends.filter(|_| !context.options.deduction)?;
    let message = failure.domain_message();
    Some(found((Code::DomainDiffers, Verdict::Domain), &message, state, failure))
}

/// The finding that an equality which passed fails at one of the first `closely` states by less than doubles tell.
pub(crate) fn judged_closely(
    link: &Link,
    context: &Context<'_>,
    (projection, states): (&Projection<'_>, &[SampledState<'_, RunningError>]),
    (closely, message): (usize, &str),
    passed: &Finding,
) -> Option<Finding> {
    let mut known = states[..closely].iter().filter(|state| is_moderate(link, state));
    let differs = known.find_map(|state| match enclosed::decided(link, state, projection) {
        Decision::Differ(failure) => Some(Finding {
            points: passed.points,
            tried: passed.tried + states.len(),
            max_residual: Some(failure.residual),
            counterexample: Some(counterexample(link, state, &failure)),
            ..context.finding(Code::SidesDiffer, Verdict::Refuted, message)
        }),
        _ => None,
    });
    // Between two roots of a radicand, however close, a side has no value.
    let has_no_value = |finding: &Finding| finding.verdict == Verdict::Domain;
    differs.or_else(|| judged(link, context, (projection, &states[..closely]), message, passed).filter(has_no_value))
}

/// Whether a claim contains eigenvalues or eigenvectors, through definitions too.
fn has_eigenvectors(link: &Link, model: &Model) -> bool {
    let mut waiting: Vec<SymbolId> =
        [&link.lhs, &link.rhs].iter().flat_map(|side| side.symbols()).map(|(id, _)| id).collect();
    let mut at = 0;
    while let Some(id) = waiting.get(at).copied() {
        at += 1;
        match model.meaning(id) {
            Some(Meaning::Particles(ParticleQuantity::PrincipalMoments | ParticleQuantity::PrincipalAxes, ..)) => {
                return true;
            }
            Some(Meaning::Defined(formula)) => {
                for (inner, _) in formula.symbols() {
                    if !waiting.contains(&inner) {
                        waiting.push(inner);
                    }
                }
            }
            _ => {}
        }
    }
    false
}

/// How a formula may change, through its definitions too.
fn of(expr: &Expr, model: &Model) -> Branches {
    let own = match &expr.node {
        Node::Norm(_) | Node::Call(Function::Arctan, _) => Branches::Changes,
        Node::Root(degree, _) if degree % 2 == 0 => Branches::Ends,
        Node::Call(Function::Ln | Function::Arcsin | Function::Arccos, _) => Branches::Ends,
        Node::Power(_, exponent) if exponent.as_digits().is_none() && !is_whole(exponent) => Branches::Ends,
        Node::Symbol { id, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => of(formula, model),
            _ => Branches::None,
        },
        _ => Branches::None,
    };
    expr.children().into_iter().map(|child| of(child, model)).fold(own, Branches::max)
}

/// Whether an exponent is a negative whole number.
fn is_whole(exponent: &Expr) -> bool {
    matches!(&exponent.node, Node::Sum(terms) if terms.len() == 1 && terms[0].expr.as_digits().is_some())
}

/// The value of a scalar formula.
fn number(expr: &Expr, state: &SampledState<'_, RunningError>) -> Option<RunningError> {
    match state.now(expr, &[]) {
        Ok(Value::Scalar(value)) => Some(value),
        _ => None,
    }
}

/// Whether no part of the two sides is close to overflow or 0.
fn is_moderate(link: &Link, state: &SampledState<'_, RunningError>) -> bool {
    let mut moderate = true;
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |expr| {
            let size = || number(expr, state).map_or(1.0, |value| value.value.abs());
            moderate = moderate && (expr.is_null() || (HUGE.recip()..HUGE).contains(&size()));
        });
    }
    moderate
}

/// Whether a formula contains a root, a logarithm or an angle that clearly has no value.
fn has_no_value(expr: &Expr, state: &SampledState<'_, RunningError>, projection: &Projection<'_>) -> bool {
    let argument = |inner: &Expr| number(inner, state).filter(|value| value.value.is_finite());
    let is_negative = |inner: &Expr| {
        argument(inner).is_some_and(|value| {
            value.value < -GROSS * value.magnitude
                || value.value <= 0.0 && enclosed::is_negative(inner, state, projection)
        })
    };
    let own = match &expr.node {
        Node::Root(degree, inner) => degree % 2 == 0 && is_negative(inner),
        Node::Call(Function::Ln, inner) => is_negative(inner),
        Node::Call(Function::Arcsin | Function::Arccos, inner) => {
            argument(inner).is_some_and(|value| value.value.abs() - 1.0 > GROSS * value.magnitude)
        }
        Node::Power(base, exponent) => {
            is_negative(base)
                && argument(exponent).is_some_and(|power| (power.value - power.value.round()).abs() > GROSS)
        }
        Node::Symbol { id, .. } => match state.model().meaning(*id) {
            Some(Meaning::Defined(formula)) => has_no_value(formula, state, projection),
            _ => false,
        },
        _ => false,
    };
    own || expr.children().into_iter().any(|child| has_no_value(child, state, projection))
}
