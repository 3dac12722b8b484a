//! The limits of floating-point numbers: values beyond the largest double or below the smallest, and sides that
//! approach each other without meeting.
//!
//! At x = 800 eˣ is infinite to a double and e⁻ˣ is 0. So eˣ ≥ 1 + x seems to have no left side, and e⁻ˣ > 0 seems
//! false. Such states are left out. At x = 40 tanh x is 1 to a double, and tanh x < 1 seems to fail. There the sides
//! are equal further out, but not further in. For (x − 1)² > 0 at x = 1 they are equal in neither direction. So a
//! strict inequality whose sides are only equal is refuted where they are equal at one point, or all around.
//!
//! # What a double does not know
//!
//! e⁻ˣ² is 0 at x = 30, and tanh x is 1. States where something has overflowed or an exponential is lost are left
//! out, for equalities too, and others are drawn nearby if few are left. Sides that are equal at a state and at
//! half the distance are equal because something has overflowed, unless they are equal in the other direction too;
//! such an equality refutes nothing. A maximum is equal at one place, and on neither side of it.

use crate::Result;
use crate::formula::tree::Function;
use crate::formula::{Expr, Node, Relation, Value};
use crate::scalar::RunningError;

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::contains;
use crate::check::state::residual;
use crate::check::state::residual::{DIFFERENCE, Point, Sides};
use crate::check::state::sampled_state::SampledState;

/// The magnitude below which a number may have lost digits, or all of them.
const SMALLEST: f64 = 1e-290;

/// The number of times that a number is doubled and halved to test whether the sides stay equal.
const ASIDE: i32 = 8;

/// The largest number of states that are tested for equality nearby.
const ASKED: usize = 32;

/// The largest number of numbers of a state that are moved.
const MOVED: usize = 48;

/// Whether a formula may leave the range of doubles at moderate numbers, through its definitions too.
fn has_exponentials(expr: &Expr, model: &Model) -> bool {
    let own = match &expr.node {
        Node::Power(base, _) if base.node == Node::Euler => true,
        Node::Power(_, exponent) => !exponent.symbols().is_empty(),
        Node::Call(Function::Exp | Function::Sinh | Function::Cosh | Function::Tanh, _) => true,
        Node::Symbol { id, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => has_exponentials(formula, model),
            _ => false,
        },
        _ => false,
    };
    own || expr.children().into_iter().any(|child| has_exponentials(child, model))
}

/// Whether a part of a formula is beyond the largest double at a state, or an exponential below the smallest.
fn overflows(expr: &Expr, state: &SampledState<'_, RunningError>) -> bool {
    let value = |expr: &Expr| match state.now(expr, &[]) {
        Ok(Value::Scalar(value)) => Some(value.value),
        _ => None,
    };
    let too_large = || value(expr).is_some_and(|value| !value.is_finite());
    let own = match &expr.node {
        Node::Power(base, exponent) if base.node == Node::Euler || !exponent.symbols().is_empty() => {
            value(expr).is_some_and(|value| !value.is_finite() || value.abs() < SMALLEST)
                && !value(base).is_some_and(|base| base <= 0.0)
        }
        Node::Call(Function::Exp, _) => value(expr).is_some_and(|value| !value.is_finite() || value < SMALLEST),
        Node::Call(Function::Sinh | Function::Cosh | Function::Tanh, inner) => {
            too_large() && value(inner).is_some_and(f64::is_finite)
        }
        Node::Power(base, _) => too_large() && value(base).is_some_and(|base| base.is_finite() && base != 0.0),
        Node::Product(factors) => {
            value(expr).is_some_and(f64::is_infinite)
                && factors.iter().all(|factor| value(factor).is_none_or(f64::is_finite))
        }
        Node::Symbol { id, .. } => match state.model().meaning(*id) {
            Some(Meaning::Defined(formula)) => overflows(formula, state),
            _ => false,
        },
        _ => false,
    };
    own || expr.children().into_iter().any(|child| overflows(child, state))
}

/// Removes the states of a claim with values beyond doubles. If there are any, states with numbers of order one are
/// added.
///
/// # Errors
/// If the mass matrix is singular at all of these.
pub(crate) fn within_doubles(link: &Link, context: &Context<'_>, ensemble: &mut Ensemble<'_>) -> Result<()> {
    if ![&link.lhs, &link.rhs].into_iter().any(|side| has_exponentials(side, context.model)) {
        return Ok(());
    }
    let keep = |state: &SampledState<'_, RunningError>| !overflows(&link.lhs, state) && !overflows(&link.rhs, state);
    let all = ensemble.states.len();
    retain(ensemble, keep);
    if ensemble.states.len() < all {
        let near = Context { spread: Spread::OrderOne, ..*context }.setting(ensemble.mode);
        let mut draw = context.draw(ensemble.mode, "near");
        let mut more = Ensemble::draw(ensemble.projection.model, &near, context.options.points, &mut draw)?;
        retain(&mut more, keep);
        ensemble.tried += more.tried;
        ensemble.states.append(&mut more.states);
        ensemble.bases.append(&mut more.bases);
    }
    Ok(())
}

fn retain(ensemble: &mut Ensemble<'_>, keep: impl Fn(&SampledState<'_, RunningError>) -> bool) {
    let kept: Vec<bool> = ensemble.states.iter().map(keep).collect();
    let mut at = kept.iter();
    ensemble.states.retain(|_| at.next() == Some(&true));
    let mut at = kept.iter();
    ensemble.bases.retain(|_| at.next() != Some(&false));
}

/// Removes the states of an inequality at which it holds by less than a clear difference. If it fails only at states
/// with equal sides, those at which they are equal by rounding only are removed too.
pub(crate) fn without_rounded_equalities(link: &Link, context: &Context<'_>, ensemble: &mut Ensemble<'_>) {
    let is_close = |state: &SampledState<'_, RunningError>| {
        let margin = || Sides::of(link, state).ok()?.margin(link.relation);
        matches!(residual::test(link, state), Ok(Point::Doubtful)) && margin().is_some_and(|margin| margin.share > 0.0)
    };
    ensemble.states.retain(|state| !is_close(state));
    if !is_strict(link.relation) {
        return;
    }
    let failure = |state: &SampledState<'_, RunningError>| match residual::test(link, state) {
        Ok(Point::Fails(failure)) => Some(failure.residual > DIFFERENCE),
        _ => None,
    };
    let fails: Vec<Option<bool>> = ensemble.states.iter().map(failure).collect();
    if !fails.contains(&Some(false)) || fails.contains(&Some(true)) {
        return;
    }
    let mut projection = Projection::new(context.model, &context.setting(ensemble.mode));
    let mut asked = 0;
    let mut stays = |(state, fails): (&SampledState<'_, RunningError>, &Option<bool>)| {
        asked += usize::from(fails.is_some());
        let base = || state.base.numbers().iter().map(|x| x.value).collect::<Vec<f64>>();
        fails.is_none() || asked <= ASKED && is_truly_equal(link, &mut projection, &base())
    };
    let kept: Vec<bool> = ensemble.states.iter().zip(&fails).map(&mut stays).collect();
    let mut at = kept.into_iter();
    ensemble.states.retain(|_| at.next() == Some(true));
}

/// Whether a relation excludes equality.
pub(crate) fn is_strict(relation: Relation) -> bool {
    matches!(relation, Relation::Less | Relation::Greater | Relation::NotEqual)
}

/// Whether sides that are equal at a state are really equal there. If a number is so large that rounding makes them
/// equal, they are equal further out as well, but not further in.
pub(crate) fn is_truly_equal(link: &Link, projection: &mut Projection<'_>, base: &[f64]) -> bool {
    let equal = Link { relation: Relation::Equal, ..link.clone() };
    (1..base.len()).take(MOVED).all(|at| {
        let [one, other] = [0.5, 2.0].map(|factor: f64| {
            let mut seen = None;
            for k in 1..=ASIDE {
                let mut moved = base.to_vec();
                moved[at] =
                    if base[at] == 0.0 { (factor - 1.0) * f64::from(k) / 2.0 } else { base[at] * factor.powi(k) };
                let state = contains(&projection.slots[at].range, moved[at]).then(|| projection.project(moved));
                match state {
                    Some(Ok(Some((_, state)))) => match residual::test(&equal, &state) {
                        Ok(Point::Fails(_) | Point::Doubtful) => return Some(false),
                        // Values beyond doubles do not distinguish the sides.
                        _ => seen = Some(true),
                    },
                    _ => break,
                }
            }
            seen
        });
        one.is_none() || other.is_none() || one == other
    })
}
