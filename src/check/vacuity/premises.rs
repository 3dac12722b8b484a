//! The premises of a claim that passes: the Euler–Lagrange equations that it combines, and the hypotheses that it does
//! not need.
//!
//! # What a claim is worth that follows from its hypotheses
//!
//! This is asked of every equality that passes off shell under hypotheses and mentions nothing that the system
//! determines. If the hypotheses also follow from it, it restates them and is `undecided`. If they hold
//! `throughout`, nothing was said about the motion, and it is `undecided` too. Otherwise it is a deduction and
//! passes with a remark, since a deduction may be worth printing. A term that is too small to be seen at all states
//! was not tested, and prevents a pass.

use nalgebra::{DMatrix, DVector};

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Relation, SymbolId, Value, text};
use crate::scalar::RunningError;

use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual::DIFFERENCE;
use crate::check::state::sampled_state::SampledState;

/// The number of states of a first, quick test; they are the first of the full set.
const FIRST: usize = 3;

/// A claim that holds on shell, as a combination of the Euler–Lagrange equations with constant coefficients. Its
/// residuals off shell are fitted by theirs, and the fit must be exact.
///
/// # Errors
/// If the mass matrix of the system is singular.
pub fn combination(link: &Link, context: &Context<'_>) -> Result<Option<String>> {
    let coordinates = &context.model.coordinates;
    if !link.free.is_empty() || link.relation != Relation::Equal || !context.hypotheses.is_empty() {
        return Ok(None);
    }
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, context.options.points.max(2 * coordinates.len() + 4))?;
    let mut rows: Vec<(Vec<f64>, f64, f64)> = Vec::new();
    for state in &ensemble.states {
        let sides = (state.now(&link.lhs, &[]), state.now(&link.rhs, &[]));
        let (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) = sides else { return Ok(None) };
        let residual: RunningError = a - b;
        let Some(equations) = state.euler_lagrange() else { return Ok(None) };
        let scale = residual.magnitude + equations.iter().map(|e| e.magnitude).sum::<f64>();
        rows.push((equations.iter().map(|e| e.value).collect(), residual.value, scale));
    }
    if rows.len() < coordinates.len() + FEWEST {
        return Ok(None);
    }
    let matrix = DMatrix::from_fn(rows.len(), coordinates.len(), |i, j| rows[i].0[j]);
    let residuals = DVector::from_fn(rows.len(), |i, _| rows[i].1);
    let Ok(fit) = matrix.clone().svd(true, true).solve(&residuals, 1e-12) else { return Ok(None) };
    let rest = matrix * &fit - residuals;
    let exact = rest.iter().zip(&rows).all(|(rest, (_, _, scale))| rest.abs() <= DIFFERENCE * scale);
    let terms: Vec<String> = fit
        .iter()
        .zip(coordinates)
        .filter(|(coefficient, _)| coefficient.abs() > 1e-9)
        .map(|(coefficient, variable)| {
            let name = text::plain(&context.model.name(variable.symbol));
            let nearest = (coefficient * 60.0).round() / 60.0;
            let factor = match nearest {
                1.0 => String::new(),
                factor if factor < 0.0 => format!("−{} × ", -factor),
                factor => format!("{factor} × "),
            };
            format!("{factor}the Euler–Lagrange equation of {name}")
        })
        .collect();
    // The sum of the equations of all coordinates is said as one.
    let all_once = fit.iter().all(|coefficient| (coefficient - 1.0).abs() <= 1e-9) && fit.len() > 1;
    let terms = match all_once {
        true => {
            let names: Vec<String> =
                coordinates.iter().map(|variable| text::plain(&context.model.name(variable.symbol))).collect();
            vec![format!("the sum of the Euler–Lagrange equations of {}", names.join(", "))]
        }
        false => terms,
    };
    let rational = fit.iter().all(|c| (c * 60.0 - (c * 60.0).round()).abs() < 1e-7);
    Ok((exact && rational && !terms.is_empty()).then(|| terms.join(" + ")))
}

/// The hypotheses that a claim does not need, found by a test without each of them. That a normal frequency exists is no
/// hypothesis of an author.
///
/// # Errors
/// If the mass matrix of the system is singular.
pub fn unneeded(link: &Link, context: &Context<'_>, on_shell: bool) -> Result<Vec<String>> {
    let mut found = Vec::new();
    let stated = context.hypotheses.iter().enumerate();
    for (at, dropped) in stated.filter(|(_, hypothesis)| !hypothesis.implied) {
        if holds_without(link, context, at, on_shell)? {
            let symbols = &context.model.symbols;
            let (lhs, rhs) = (text::formula(&dropped.lhs, symbols), text::formula(&dropped.rhs, symbols));
            found.push(format!("{lhs} {} {rhs}", dropped.relation.glyph()));
        }
    }
    Ok(found)
}

/// Whether a claim holds without its `at`-th hypothesis.
fn holds_without(link: &Link, context: &Context<'_>, at: usize, on_shell: bool) -> Result<bool> {
    let mut fewer: Vec<Hypothesis> = context.hypotheses.to_vec();
    fewer.remove(at);
    let without = Context { hypotheses: &fewer, ..*context };
    let mode = without.mode(on_shell, &[&link.lhs, &link.rhs]);
    let clean = |states: &[SampledState<'_, RunningError>]| {
        let outcome = run(link, states).ok()?;
        (outcome.failure.is_none() && outcome.one_sided.is_none() && outcome.doubtful == 0).then_some(outcome.points)
    };
    if without.ensemble(mode, false, FIRST).is_ok_and(|first| clean(&first.states).is_none()) {
        return Ok(false);
    }
    let ensemble = without.ensemble(mode, false, context.options.points)?;
    let enough = |points: usize| points >= FEWEST.min(context.options.points);
    Ok(enough(ensemble.states.len()) && clean(&ensemble.states).is_some_and(enough))
}

/// Whether both sides of a claim are zero at all states, though neither is printed as 0. Then a wrong factor passes.
pub fn vanishes_throughout(link: &Link, states: &[SampledState<'_, RunningError>]) -> bool {
    let zero = |side: &Expr| Link { lhs: side.clone(), rhs: Expr::integer(0, side.span), ..link.clone() };
    let vanishes = |side: &Expr| run(&zero(side), states).is_ok_and(|o| o.failure.is_none() && o.doubtful == 0);
    !link.lhs.is_null() && !link.rhs.is_null() && vanishes(&link.lhs) && vanishes(&link.rhs)
}

/// Whether a claim that holds says anything about the system.
pub enum Vacuity {
    /// It does.
    None,
    /// It follows from its hypotheses whatever the system does, and may still be worth printing.
    FollowsFromHypotheses,
    /// It says nothing, for the reason in the message.
    Vacuous(Code, &'static str),
}

/// Whether a claim that holds says anything about the system, or follows from its hypotheses alone, or restates them.
///
/// # Errors
/// If the mass matrix of the system is singular.
pub fn vacuity(link: &Link, context: &Context<'_>, on_shell: bool) -> Result<Vacuity> {
    let formulas = [&link.lhs, &link.rhs].into_iter();
    // A hypothesis such as E = 0, in a claim without E, says what E is made of: that follows from the system.
    let of_hypotheses = context.hypotheses.iter().flat_map(|hypothesis| [&hypothesis.lhs, &hypothesis.rhs]);
    let mut all = formulas.chain(of_hypotheses);
    if on_shell || context.hypotheses.is_empty() || all.any(|f| concerns_world(f, context.model)) {
        return Ok(Vacuity::None);
    }
    let unconditional = Context { hypotheses: &[], ..*context };
    let mode = unconditional.mode(false, &[&link.lhs, &link.rhs]);
    let free = unconditional.ensemble(mode, false, context.options.points)?;
    if run(link, &free.states).is_ok_and(|outcome| outcome.failure.is_none()) {
        return Ok(Vacuity::None);
    }
    // What the prose implies is no hypothesis that the author could have restated.
    if context.hypotheses.iter().all(|hypothesis| hypothesis.implied) {
        return Ok(Vacuity::FollowsFromHypotheses);
    }
    if context.hypotheses.iter().any(|hypothesis| hypothesis.throughout) {
        return Ok(Vacuity::Vacuous(
            Code::FollowsFromHypotheses,
            "this follows from its hypotheses alone, whatever the motion; remove those that make it trivial",
        ));
    }
    // The converse: if the claim implies the hypotheses, the two are equivalent.
    let claim = [Hypothesis::of(Link { relation: Relation::Equal, ..link.clone() }, false)];
    let converse = Context { hypotheses: &claim, ..*context };
    let states = converse.ensemble(mode, false, context.options.points)?;
    let given_back = |hypothesis: &Hypothesis| {
        let Hypothesis { lhs, relation, rhs, free, .. } = hypothesis.clone();
        let link = Link { lhs, relation, rhs, free };
        run(&link, &states.states).is_ok_and(|o| o.failure.is_none() && o.points >= FEWEST.min(states.states.len()))
    };
    let mut needed: Vec<&Hypothesis> = Vec::new();
    for (at, hypothesis) in context.hypotheses.iter().enumerate() {
        if !holds_without(link, context, at, false)? {
            needed.push(hypothesis);
        }
    }
    // A hypothesis about a name with a formula, as E = const, needs that formula where the claim has not the name.
    let opens = |hypothesis: &&Hypothesis| {
        let symbols =
            |a: &Expr, b: &Expr| a.symbols().into_iter().chain(b.symbols()).map(|(id, _)| id).collect::<Vec<_>>();
        let own = symbols(&link.lhs, &link.rhs);
        let is_defined = |id: &SymbolId| matches!(context.model.meaning(*id), Some(Meaning::Defined(_)));
        let opened =
            symbols(&hypothesis.lhs, &hypothesis.rhs).into_iter().any(|id| is_defined(&id) && !own.contains(&id));
        let difference = |a: &Expr, b: &Expr| a.clone().minus(b.clone());
        let (said, claimed) = (difference(&hypothesis.lhs, &hypothesis.rhs), difference(&link.lhs, &link.rhs));
        let is_it = |other: &Expr| {
            let link = Link { lhs: said.clone(), relation: Relation::Equal, rhs: other.clone(), free: Vec::new() };
            run(&link, &free.states).is_ok_and(|outcome| outcome.failure.is_none() && outcome.points > 0)
        };
        opened && !is_it(&claimed) && !is_it(&claimed.clone().negated())
    };
    let restates = !states.states.is_empty()
        && !needed.is_empty()
        && !needed.iter().any(opens)
        && needed.into_iter().all(given_back);
    let message = "this only restates its hypotheses, so nothing is checked; remove the hypothesis that says the same";
    Ok(if restates { Vacuity::Vacuous(Code::RestatesHypothesis, message) } else { Vacuity::FollowsFromHypotheses })
}

/// Whether a formula contains a quantity of the system, of particles or of a frame.
fn concerns_world(expr: &Expr, model: &Model) -> bool {
    expr.symbols().iter().any(|(id, _)| match model.meaning(*id) {
        Some(Meaning::System(_) | Meaning::Particles(..) | Meaning::Frame(_) | Meaning::Rigid(_)) => true,
        Some(Meaning::Defined(formula)) => concerns_world(formula, model),
        _ => false,
    })
}
