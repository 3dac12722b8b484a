//! What more can be said of a claim that passes: which Euler–Lagrange equations it is made of, and which of its
//! hypotheses it does not need.

use nalgebra::{DMatrix, DVector};

use crate::Result;
use crate::formula::{Expr, Node, Relation, Value, text};
use crate::scalar::Measured;

use super::ensemble::Condition;
use super::identity::{Context, FEWEST, run};
use super::judge::{self, DIFFERENCE, Link};
use super::model::{Meaning, Model};
use super::scene::Scene;

/// So many states are looked at first where most claims fail: the first of those that are drawn then.
const FIRST: usize = 3;

/// A claim that holds on shell, as a combination of the Euler–Lagrange equations with constant coefficients: its
/// residual off shell is fitted by theirs, and the fit must be exact.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn combination(link: &Link, context: &Context<'_>) -> Result<Option<String>> {
    let coordinates = &context.model.coordinates;
    if !link.free.is_empty() || link.relation != Relation::Equal || !context.conditions.is_empty() {
        return Ok(None);
    }
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, context.options.points.max(2 * coordinates.len() + 4))?;
    let mut rows: Vec<(Vec<f64>, f64, f64)> = Vec::new();
    for scene in &ensemble.scenes {
        let sides = (scene.now(&link.lhs, &[]), scene.now(&link.rhs, &[]));
        let (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) = sides else { return Ok(None) };
        let residual: Measured = a - b;
        let Some(equations) = scene.euler_lagrange() else { return Ok(None) };
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
            format!(
                "{} × the Euler–Lagrange equation of {name}",
                if nearest < 0.0 { format!("−{}", -nearest) } else { nearest.to_string() }
            )
        })
        .collect();
    let rational = fit.iter().all(|c| (c * 60.0 - (c * 60.0).round()).abs() < 1e-7);
    Ok((exact && rational && !terms.is_empty()).then(|| terms.join(" + ")))
}

/// The hypotheses that a claim which holds does not need, by trying it without each.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn unneeded(link: &Link, context: &Context<'_>, on_shell: bool) -> Result<Vec<String>> {
    let mut found = Vec::new();
    for (at, dropped) in context.conditions.iter().enumerate() {
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
    let mut fewer: Vec<Condition> = context.conditions.to_vec();
    fewer.remove(at);
    let without = Context { conditions: &fewer, ..*context };
    let mode = without.mode(on_shell, &[&link.lhs, &link.rhs]);
    let clean = |scenes: &[Scene<'_, Measured>]| {
        let outcome = run(link, scenes).ok()?;
        (outcome.failure.is_none() && outcome.one_sided.is_none() && outcome.doubtful == 0).then_some(outcome.points)
    };
    if without.ensemble(mode, false, FIRST).is_ok_and(|first| clean(&first.scenes).is_none()) {
        return Ok(false);
    }
    let ensemble = without.ensemble(mode, false, context.options.points)?;
    let enough = |points: usize| points >= FEWEST.min(context.options.points);
    Ok(enough(ensemble.scenes.len()) && clean(&ensemble.scenes).is_some_and(enough))
}

/// A term of a claim that cannot be seen at any state: it is there, and so small beside the others that leaving it out
/// would change nothing that can be told from rounding.
pub fn unseen(link: &Link, scenes: &[Scene<'_, Measured>]) -> Option<String> {
    fn terms(side: &Expr) -> Vec<&Expr> {
        match &side.node {
            Node::Sum(terms) => terms.iter().map(|term| &term.expr).collect(),
            _ => vec![side],
        }
    }
    if !link.free.is_empty() {
        return None;
    }
    let all: Vec<&Expr> = terms(&link.lhs).into_iter().chain(terms(&link.rhs)).collect();
    hidden(&all, scenes)
}

/// The same of a term of a sum inside of a claim: below a root, in a sine, in an exponent.
pub fn unseen_inside(link: &Link, scenes: &[Scene<'_, Measured>]) -> Option<String> {
    let mut sums: Vec<Vec<&Expr>> = Vec::new();
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |expr| match &expr.node {
            Node::Sum(terms) if terms.len() > 1 => sums.push(terms.iter().map(|term| &term.expr).collect()),
            _ => {}
        });
    }
    sums.iter().find_map(|terms| hidden(terms, scenes))
}

/// Of terms that are added the first that cannot be seen beside the others at any state.
fn hidden(all: &[&Expr], scenes: &[Scene<'_, Measured>]) -> Option<String> {
    // A literal zero is not there, and need not be seen.
    let (mut seen, mut there): (Vec<bool>, Vec<bool>) = all.iter().map(|term| (term.is_null(), false)).unzip();
    for scene in scenes {
        if seen.iter().all(|seen| *seen) {
            return None;
        }
        let values: Option<Vec<Measured>> = all
            .iter()
            .map(|term| match scene.now(term, &[]) {
                Ok(Value::Scalar(value)) => Some(value),
                _ => None,
            })
            .collect();
        let Some(values) = values else { continue };
        let scale: f64 = values.iter().map(|value| value.magnitude).sum();
        for (at, value) in values.iter().enumerate().filter(|(_, value)| value.value.is_finite()) {
            let is_there = !judge::vanishes(*value);
            there[at] |= is_there;
            seen[at] |= is_there && value.value.abs() > DIFFERENCE * scale;
        }
    }
    let hidden = (0..all.len()).find(|at| there[*at] && !seen[*at])?;
    Some(text::formula(all[hidden], &scenes.first()?.model().symbols))
}

/// Whether both sides of a claim are zero at all states, though neither is printed as 0: then any factor would do.
pub fn vanishes_throughout(link: &Link, scenes: &[Scene<'_, Measured>]) -> bool {
    let zero = |side: &Expr| Link { lhs: side.clone(), rhs: Expr::integer(0, side.span), ..link.clone() };
    let vanishes = |side: &Expr| run(&zero(side), scenes).is_ok_and(|o| o.failure.is_none() && o.doubtful == 0);
    !link.lhs.is_null() && !link.rhs.is_null() && vanishes(&link.lhs) && vanishes(&link.rhs)
}

/// How little a claim that holds says of the world.
pub enum Emptiness {
    /// It says something.
    None,
    /// It follows from its hypotheses, whatever the world; that may still be worth printing.
    Follows,
    /// It says nothing, for this reason.
    Empty(&'static str),
}

/// Whether a claim that holds says anything of the world, or follows from its hypotheses alone, or restates them.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn emptiness(link: &Link, context: &Context<'_>, on_shell: bool) -> Result<Emptiness> {
    let formulas = [&link.lhs, &link.rhs].into_iter();
    if on_shell || context.conditions.is_empty() || formulas.clone().any(|f| concerns_world(f, context.model)) {
        return Ok(Emptiness::None);
    }
    let unconditional = Context { conditions: &[], ..*context };
    let mode = unconditional.mode(false, &[&link.lhs, &link.rhs]);
    let free = unconditional.ensemble(mode, false, context.options.points)?;
    if run(link, &free.scenes).is_ok_and(|outcome| outcome.failure.is_none()) {
        return Ok(Emptiness::None);
    }
    if context.conditions.iter().any(|condition| condition.throughout) {
        return Ok(Emptiness::Empty("it follows from its assumptions alone, whatever the motion"));
    }
    // The converse: if the claim in turn gives the hypotheses, the two say the same.
    let claim = [Condition::of(Link { relation: Relation::Equal, ..link.clone() }, false)];
    let converse = Context { conditions: &claim, ..*context };
    let states = converse.ensemble(mode, false, context.options.points)?;
    let given_back = |condition: &Condition| {
        let Condition { lhs, relation, rhs, free, .. } = condition.clone();
        let link = Link { lhs, relation, rhs, free };
        run(&link, &states.scenes).is_ok_and(|o| o.failure.is_none() && o.points >= FEWEST.min(states.scenes.len()))
    };
    let mut needed: Vec<&Condition> = Vec::new();
    for (at, condition) in context.conditions.iter().enumerate() {
        if !holds_without(link, context, at, false)? {
            needed.push(condition);
        }
    }
    let restates = !states.scenes.is_empty() && !needed.is_empty() && needed.into_iter().all(given_back);
    Ok(if restates { Emptiness::Empty("it only restates its assumptions") } else { Emptiness::Follows })
}

/// Whether a formula speaks of something that the world determines.
fn concerns_world(expr: &Expr, model: &Model) -> bool {
    expr.symbols().iter().any(|(id, _)| match model.meaning(*id) {
        Some(Meaning::World(_) | Meaning::Particles(..) | Meaning::Frame(_) | Meaning::Rigid(_)) => true,
        Some(Meaning::Defined(formula)) => concerns_world(formula, model),
        _ => false,
    })
}
