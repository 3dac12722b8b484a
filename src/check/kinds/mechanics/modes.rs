//! Normal frequencies of several coordinates: the roots of det(K − ω²M) = 0.
//!
//! K and M are the second derivatives of −L and of L by the coordinates and by the velocities, where all of these are 0. A name for
//! one frequency is tested by its formula, and no root can pass for another: two names with the same formula pass only if this
//! root is a double one. A printed secular equation is compared as a whole: its two sides must differ by det(K − ω²M) times a factor
//! without ω. So it has all roots, and no others.

use crate::code::Code;
use crate::formula::{Expr, Node, SymbolId};
use crate::source::Span;
use crate::{Error, Result};

use super::expressions::{equal, lagrangian, partial, product, symbol, without_velocity_forces};
use crate::check::judge::identity;
use crate::check::model::PrintedLagrangian;
use crate::check::model::claim::Link;
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The most coordinates whose determinant is written out.
const MOST: usize = 4;

/// Checks that the square of a frequency, `square`, is that of a normal mode, and of another one than those in `others`, which are
/// the squares with their names.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn check(square: &Expr, others: &[(String, Expr)], context: &Context<'_>) -> Result<Finding> {
    let Some(matrices) = matrices(context) else { return Ok(unsupported(context)) };
    if let Some(why) = obstacle(&matrices, context)? {
        return Ok(context.finding(Code::NotSupported, Verdict::Undecided, why));
    }
    let zero = Expr::integer(0, Span::default());
    let link = equal(&secular(&matrices, square), &zero);
    let context = &Context { on_shell: Some(false), ..*context };
    let found = identity::check(&link, context)?;
    match found.verdict {
        // Without masses the determinant says nothing of a frequency.
        verdict if verdict.holds() && is_zero(&determinant(&matrices.1), context)? => return Ok(unsupported(context)),
        verdict if verdict.holds() => {}
        Verdict::Refuted => {
            let message =
                "is not a normal frequency: det(K − ω²M) is not 0 there; below, the left side is this determinant";
            return Ok(Finding { message: message.to_owned(), ..found });
        }
        _ => return Ok(found),
    }
    for (name, other) in others {
        let is_same = square == other || identity::check(&equal(square, other), &context.quick())?.verdict.holds();
        if is_same && !is_double(&matrices, square, context)? {
            let message = format!("this is the same normal frequency as {name}, which is no double one");
            return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, message));
        }
    }
    Ok(Finding { message: "is a normal frequency: det(K − ω²M) is 0 there".to_owned(), ..found })
}

/// Checks that an equation is the secular equation for a frequency.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn secular_equation(link: &Link, omega: SymbolId, context: &Context<'_>) -> Result<Finding> {
    let Some(matrices) = matrices(context) else { return Ok(unsupported(context)) };
    if let Some(why) = obstacle(&matrices, context)? {
        return Ok(context.finding(Code::NotSupported, Verdict::Undecided, why));
    }
    let name = symbol(omega, 0);
    let ours = secular(&matrices, &product(vec![name.clone(), name]));
    let printed = link.lhs.clone().minus(link.rhs.clone());
    let context = &Context { on_shell: Some(false), ..*context };
    let entries = || matrices.0.iter().chain(&matrices.1).flatten();
    if entries().any(|entry| context.model.depends_on(entry, &[omega])) {
        return Ok(unsupported(context));
    }
    let is_hidden =
        printed.symbols().iter().any(|(id, _)| *id != omega && context.model.depends_on(&symbol(*id, 0), &[omega]));
    let does_not_fit = |message: &str| Ok(context.finding(Code::ClaimDoesNotFit, Verdict::Undecided, message));
    if is_hidden {
        return does_not_fit("a name in this equation is defined by the frequency; write the frequency itself");
    }
    if !context.model.depends_on(&printed, &[omega]) {
        return does_not_fit("this is no equation for the frequency, since it does not depend on it");
    }
    // Two functions are proportional if f(ω) g(1) = f(1) g(ω).
    let at_one = |of: &Expr| {
        let mut of = of.clone();
        of.substitute(&|part| match part {
            Node::Symbol { id, .. } if *id == omega => Some(Expr::integer(1, Span::default())),
            _ => None,
        });
        of
    };
    let (printed_at_one, ours_at_one) = (at_one(&printed), at_one(&ours));
    let link = equal(&product(vec![printed.clone(), ours_at_one]), &product(vec![ours, printed_at_one]));
    let found = identity::check(&link, context)?;
    if found.verdict.holds() && is_zero(&printed, context)? {
        return does_not_fit("both sides are equal for every frequency, so this is no equation for it");
    }
    let message = match found.verdict {
        verdict if verdict.holds() && is_zero(&determinant(&matrices.1), context)? => return Ok(unsupported(context)),
        verdict if verdict.holds() => "is the secular equation det(K − ω²M) = 0, up to a factor",
        Verdict::Refuted => "is not the secular equation: its sides do not differ by a multiple of det(K − ω²M)",
        _ => return Ok(found),
    };
    Ok(Finding { message: message.to_owned(), counterexample: None, ..found })
}

/// Whether a formula is 0 whatever its symbols are.
fn is_zero(of: &Expr, context: &Context<'_>) -> Result<bool> {
    let link = equal(of, &Expr::integer(0, Span::default()));
    Ok(of.is_zero() || identity::check(&link, &Context { on_shell: Some(false), ..context.quick() })?.verdict.holds())
}

fn unsupported(context: &Context<'_>) -> Finding {
    let message = "the second derivatives of the Lagrangian at rest cannot be formed as formulas";
    context.finding(Code::NotSupported, Verdict::Undecided, message)
}

/// Why det(K − ω²M) = 0 may not give the frequencies, if something speaks against it.
fn obstacle(matrices: &(Rows, Rows), context: &Context<'_>) -> Result<Option<&'static str>> {
    let model = context.model;
    let is_pushed = |printed: &PrintedLagrangian| !printed.forces.is_empty() || !printed.constraints.is_empty();
    if model.printed_lagrangian.as_ref().is_some_and(is_pushed) {
        return Ok(Some("there are forces or constraints beside the Lagrangian, which det(K − ω²M) does not contain"));
    }
    if matrices.0.iter().chain(&matrices.1).flatten().any(|entry| model.contains_time(entry)) {
        return Ok(Some("the Lagrangian depends on the time, so the motion has no normal frequencies"));
    }
    let Some(lagrangian) = lagrangian(context) else { return Ok(None) };
    let context = &Context { on_shell: Some(false), ..context.quick() };
    // A few states tell 0 from what is not 0, and every suggestion that is tried asks again.
    let is_refuted = |link: &Link| {
        let ensemble = context.ensemble(context.mode(false, &[&link.lhs, &link.rhs]), false, FEWEST)?;
        Ok::<bool, Error>(run(link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_some()))
    };
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    for link in without_velocity_forces(&lagrangian, &coordinates, context).into_iter().flatten() {
        let [one, other] = [link.lhs, link.rhs].map(|side| at_zero(side, &coordinates));
        if one != other && is_refuted(&equal(&one, &other))? {
            return Ok(Some("there are forces that are linear in the velocities, which det(K − ω²M) does not contain"));
        }
    }
    for a in &coordinates {
        let Some(force) = partial(&lagrangian, *a, 0, context).map(|force| at_zero(force, &coordinates)) else {
            continue;
        };
        let is_driven = model.contains_time(&force);
        if !is_driven && !force.is_zero() && is_refuted(&equal(&force, &Expr::integer(0, Span::default())))? {
            return Ok(Some(
                "the system does not stay at rest where all coordinates are 0; measure the coordinates from the place of rest",
            ));
        }
    }
    Ok(None)
}

/// A formula where all coordinates and velocities are 0.
fn at_zero(mut formula: Expr, coordinates: &[SymbolId]) -> Expr {
    formula.substitute(&|part| match part {
        Node::Symbol { id, .. } if coordinates.contains(id) => Some(Expr::integer(0, Span::default())),
        _ => None,
    });
    formula
}

/// A matrix of formulas, by rows.
type Rows = Vec<Vec<Expr>>;

/// K and M.
fn matrices(context: &Context<'_>) -> Option<(Rows, Rows)> {
    let lagrangian = lagrangian(context)?;
    let coordinates: Vec<SymbolId> = context.model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    if coordinates.len() > MOST {
        return None;
    }
    let matrix = |dots: u8| -> Option<Vec<Vec<Expr>>> {
        let entry = |a: &SymbolId, b: &SymbolId| {
            let second = partial(&partial(&lagrangian, *a, dots, context)?, *b, dots, context)?;
            let second = at_zero(second, &coordinates);
            Some(if dots == 0 { second.negated() } else { second })
        };
        coordinates.iter().map(|a| coordinates.iter().map(|b| entry(a, b)).collect()).collect()
    };
    Some((matrix(0)?, matrix(1)?))
}

/// det(K − λM).
fn secular((stiffness, masses): &(Vec<Vec<Expr>>, Vec<Vec<Expr>>), lambda: &Expr) -> Expr {
    let entry = |k: &Expr, m: &Expr| match m.is_zero() {
        true => k.clone(),
        false => k.clone().minus(product(vec![lambda.clone(), m.clone()])),
    };
    let rows = stiffness.iter().zip(masses);
    let matrix: Vec<Vec<Expr>> = rows.map(|(k, m)| k.iter().zip(m).map(|(k, m)| entry(k, m)).collect()).collect();
    determinant(&matrix)
}

/// A determinant, written out by its first row.
fn determinant(matrix: &[Vec<Expr>]) -> Expr {
    let (Some(first), true) = (matrix.first(), matrix.len() > 1) else {
        return matrix.first().map_or(Expr::integer(1, Span::default()), |row| row[0].clone());
    };
    let mut whole: Option<Expr> = None;
    for (at, entry) in first.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
        let without = |row: &Vec<Expr>| {
            row.iter().enumerate().filter(|(column, _)| *column != at).map(|(_, entry)| entry.clone()).collect()
        };
        let rest: Vec<Vec<Expr>> = matrix[1..].iter().map(without).collect();
        let term = product(vec![entry.clone(), determinant(&rest)]);
        whole = Some(match (whole, at % 2 == 0) {
            (Some(whole), true) => whole.minus(term.negated()),
            (Some(whole), false) => whole.minus(term),
            (None, true) => term,
            (None, false) => term.negated(),
        });
    }
    whole.unwrap_or_else(|| Expr::integer(0, Span::default()))
}

/// Whether a root of the determinant is a double one: its derivative by λ is 0 too. That is the sum of the determinants with one row
/// of −M in the place of that of K − λM.
fn is_double(matrices: &(Vec<Vec<Expr>>, Vec<Vec<Expr>>), root: &Expr, context: &Context<'_>) -> Result<bool> {
    let (stiffness, masses) = matrices;
    let entry = |k: &Expr, m: &Expr| k.clone().minus(product(vec![root.clone(), m.clone()]));
    let row = |at: usize| stiffness[at].iter().zip(&masses[at]).map(|(k, m)| entry(k, m)).collect::<Vec<_>>();
    let mut all = Vec::new();
    for replaced in 0..stiffness.len() {
        let rows = (0..stiffness.len()).map(|at| if at == replaced { masses[at].clone() } else { row(at) });
        all.push(determinant(&rows.collect::<Vec<_>>()));
    }
    is_zero(&super::expressions::sum(all), context)
}
