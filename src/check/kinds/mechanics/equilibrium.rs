//! Equilibria of the motion, and their stability.
//!
//! A position is an equilibrium if all accelerations are 0 on shell where the system is at rest there. A motion is steady if
//! only cyclic coordinates move, and the others are not accelerated. A position is stable if
//! K = −∂²L/∂q∂q and the masses M = ∂²L/∂q̇∂q̇ are positive there: then the energy has a strict minimum, by the theorem of
//! Lagrange and Dirichlet, also with forces that are linear in the velocities. It is unstable if L has no such forces and K has a
//! negative direction. In between, as for x⁴, the second derivatives do not decide, and the verdict is `undecided`.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, SymbolId, text};
use crate::notes::claims::Equilibrium;
use crate::source::Span;

use super::expressions::{
    NO_LAGRANGIAN, NOT_ELEMENTARY, equal, lagrangian, partial, product, symbol, without_velocity_forces,
};
use crate::check::judge::identity;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The most coordinates for which stability is decided.
const MOST: usize = 3;

/// The hypotheses that the system of a printed Lagrangian stays at rest where coordinates have these values, and the others are 0: no force
/// acts there. `None` where this is not known as formulas, and with forces, constraints or the time in L.
pub(crate) fn rest_at(places: &[(SymbolId, Expr)], context: &Context<'_>) -> Option<Vec<Hypothesis>> {
    let model = context.model;
    let printed = model.printed_lagrangian.as_ref()?;
    let lagrangian = lagrangian(context).filter(|of| !model.contains_time(of))?;
    if printed.dissipation.is_some() || !printed.forces.is_empty() || !printed.constraints.is_empty() {
        return None;
    }
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    let mut hypotheses = Vec::new();
    for q in &coordinates {
        let mut force = partial(&lagrangian, *q, 0, context)?;
        force.substitute(&|part| match part {
            Node::Symbol { id, dots, .. } if coordinates.contains(id) => {
                let place = places.iter().find(|(known, _)| known == id && *dots == 0).map(|(_, value)| value.clone());
                Some(place.unwrap_or_else(|| Expr::integer(0, Span::default())))
            }
            _ => None,
        });
        // A name in it may be made of coordinates.
        if model.depends_on(&force, &coordinates) {
            return None;
        }
        if !force.is_zero() {
            let link = equal(&force, &Expr::integer(0, Span::default()));
            hypotheses.push(Hypothesis { implied: true, ..Hypothesis::of(link, false) });
        }
    }
    Some(hypotheses)
}

/// Checks that the system stays at rest where the hypotheses of the context put it, and how stable that is.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn check(claimed: Equilibrium, context: &Context<'_>) -> Result<Finding> {
    let undecided = |code, message: &str| Ok(context.finding(code, Verdict::Undecided, message));
    let Some(system) = &context.model.system else {
        return undecided(
            Code::NoMotion,
            "an equilibrium needs equations of motion, and there are none; name a \"system\", or a Lagrangian under \"means\"",
        );
    };
    let all = context.model.coordinates.iter().enumerate();
    let may_move = |at: usize| claimed == Equilibrium::Steady && system.is_certainly_cyclic(at);
    let own = all.filter(|(at, _)| !system.multipliers().contains(at) && !may_move(*at));
    let coordinates: Vec<SymbolId> = own.map(|(_, coordinate)| coordinate.symbol).collect();
    let zero = Expr::integer(0, Span::default());
    let at_rest = coordinates.iter().map(|q| Hypothesis::of(equal(&symbol(*q, 1), &zero), false));
    let hypotheses: Vec<Hypothesis> =
        context.hypotheses.iter().cloned().chain(at_rest).map(|known| Hypothesis { implied: true, ..known }).collect();
    let context = &Context { hypotheses: &hypotheses, on_shell: Some(true), ..*context };
    let mut worst: Option<Finding> = None;
    for q in &coordinates {
        let found = identity::check(&equal(&symbol(*q, 2), &zero), context)?;
        // The equation of rest is printed nowhere, so a mutant of it says nothing of what is printed.
        let found = match found.code == Code::MutantPasses {
            true => {
                let holds = context.verified("", "a place that hypotheses give");
                Finding { points: found.points, tried: found.tried, ..holds }
            }
            false => found,
        };
        if !found.verdict.holds() {
            let moves = found.verdict == Verdict::Refuted;
            let stays = match claimed {
                Equilibrium::Steady => "stay on this steady motion",
                _ => "stay at rest here",
            };
            let message = match moves {
                true => {
                    let name = text::plain(&context.model.name(*q));
                    format!("the system does not {stays}: the acceleration of {name} is not 0")
                }
                false => found.message.clone(),
            };
            return Ok(Finding { message, ..found });
        }
        let is_weaker = |known: &Finding| found.verdict == Verdict::Verified && known.verdict == Verdict::Certified;
        if worst.as_ref().is_none_or(is_weaker) {
            worst = Some(found);
        }
    }
    let Some(rest) = worst else {
        return undecided(
            Code::NotDecided,
            "an equilibrium needs a coordinate that stays at rest, and there is none; declare it under \"coordinates\"",
        );
    };
    let stays = match claimed {
        Equilibrium::Steady => "the system stays on this steady motion",
        _ => "the system stays at rest here",
    };
    let rest = Finding { message: stays.to_owned(), ..rest };
    match claimed {
        Equilibrium::Any | Equilibrium::Steady => Ok(rest),
        Equilibrium::Stable | Equilibrium::Unstable => stability(claimed, &coordinates, rest, context),
    }
}

/// The finding on the stability of an equilibrium.
fn stability(claimed: Equilibrium, coordinates: &[SymbolId], rest: Finding, context: &Context<'_>) -> Result<Finding> {
    let open = |why: &str| {
        let message = format!("{}; its stability is not decided, because {why}", rest.message);
        Ok(context.finding(Code::NotDecided, Verdict::Undecided, message))
    };
    let printed = context.model.printed_lagrangian.as_ref();
    let has_forces = printed.is_some_and(|printed| {
        !printed.forces.is_empty() || printed.dissipation.is_some() || !printed.constraints.is_empty()
    });
    let has_multipliers = context.model.system.as_ref().is_some_and(|system| !system.multipliers().is_empty());
    if has_forces || has_multipliers {
        return open("there are forces or constraints beside the Lagrangian");
    }
    if coordinates.len() > MOST {
        return open("this is supported for at most three coordinates");
    }
    let Some(lagrangian) = lagrangian(context) else { return open(NO_LAGRANGIAN) };
    if context.model.contains_time(&lagrangian) {
        return open("the Lagrangian depends on the time");
    }
    let matrix = |dots: u8, sign: bool| -> Option<Vec<Vec<Expr>>> {
        let entry = |a: &SymbolId, b: &SymbolId| {
            let second = partial(&partial(&lagrangian, *a, dots, context)?, *b, dots, context)?;
            Some(if sign { second.negated() } else { second })
        };
        coordinates.iter().map(|a| coordinates.iter().map(|b| entry(a, b)).collect()).collect()
    };
    let (Some(stiffness), Some(masses)) = (matrix(0, true), matrix(1, false)) else {
        return open(NOT_ELEMENTARY);
    };
    let all = |minors: &[Expr], relation: Relation| -> Result<bool> {
        for minor in minors {
            if sign(minor, relation, context)?.verdict != Verdict::Verified {
                return Ok(false);
            }
        }
        Ok(true)
    };
    let is_positive = |minor: &Expr| -> Result<bool> {
        let refuted = at_states(minor, Relation::Greater, context)?.is_some_and(|it| it.verdict == Verdict::Refuted);
        Ok(!refuted)
    };
    if !minors(&masses).iter().map(is_positive).collect::<Result<Vec<_>>>()?.into_iter().all(|positive| positive) {
        return open("the mass matrix may not be positive definite");
    }
    let is_minimum = all(&minors(&stiffness), Relation::Greater)?;
    let is_stable = claimed == Equilibrium::Stable;
    if is_minimum {
        let tested = Finding {
            verdict: Verdict::Verified,
            false_accept_log2: None,
            not_certified_because: Some("an inequality, because only an equality can have a certificate".to_owned()),
            ..rest.clone()
        };
        return Ok(match is_stable {
            true => Finding {
                message: format!("{}; it is stable, because the energy has a minimum here", rest.message),
                ..tested
            },
            false => Finding {
                message: format!("{}, but it is stable, because the energy has a minimum here", rest.message),
                code: Code::SidesDiffer,
                verdict: Verdict::Refuted,
                not_certified_because: None,
                ..tested
            },
        });
    }
    let Some(turning) = without_velocity_forces(&lagrangian, coordinates, context) else {
        return open(NOT_ELEMENTARY);
    };
    for link in turning {
        let is_same = link.lhs == link.rhs || identity::check(&link, &context.quick())?.verdict.holds();
        if !is_same {
            return open("forces that are linear in the velocities may make it stable");
        }
    }
    let mut falls = false;
    let mut falls_somewhere = None;
    for minor in negative_if_falling(&stiffness) {
        falls = falls || sign(&minor, Relation::Less, context)?.verdict == Verdict::Verified;
        if at_states(&minor, Relation::GreaterEqual, context)?.is_some_and(|found| found.verdict == Verdict::Refuted) {
            falls_somewhere = Some(minor);
        }
    }
    match (is_stable, falls_somewhere) {
        (false, _) if falls => Ok(Finding {
            message: format!("{}; it is unstable", rest.message),
            verdict: Verdict::Verified,
            false_accept_log2: None,
            not_certified_because: Some("an inequality, because only an equality can have a certificate".to_owned()),
            ..rest
        }),
        // Stability is claimed of all states, and one with a negative direction refutes it.
        (true, Some(minor)) => {
            let found = identity::check(&signed(&minor, Relation::GreaterEqual), &context.quick())?;
            Ok(Finding { message: format!("{}, but it is not stable", rest.message), ..found })
        }
        _ => open("at some sampled states the second derivatives of the Lagrangian do not decide it"),
    }
}

/// The entries and determinants of two coordinates of which one is negative only where a symmetric matrix has a negative
/// direction.
fn negative_if_falling(matrix: &[Vec<Expr>]) -> Vec<Expr> {
    let mut all: Vec<Expr> = (0..matrix.len()).map(|k| matrix[k][k].clone()).collect();
    for a in 0..matrix.len() {
        for b in a + 1..matrix.len() {
            all.push(determinant(matrix, (a, b), (a, b)));
        }
    }
    all
}

/// The finding that a formula has a sign: at sampled states, and where none fails also at states that are sought.
fn sign(of: &Expr, relation: Relation, context: &Context<'_>) -> Result<Finding> {
    if let Some(found) = at_states(of, relation, context)? {
        return Ok(found);
    }
    identity::check(&signed(of, relation), &context.quick())
}

/// The finding that a formula has a sign where a sampled state refutes it, or where no more is asked; else `None`.
fn at_states(of: &Expr, relation: Relation, context: &Context<'_>) -> Result<Option<Finding>> {
    let link = signed(of, relation);
    let ensemble = context.ensemble(context.mode(true, &[of]), false, context.options.points)?;
    let Ok(outcome) = run(&link, &ensemble.states) else { return Ok(None) };
    let found = |verdict| Some(context.finding(Code::SidesDiffer, verdict, "the formula has another sign"));
    Ok(match outcome.failure {
        Some(_) => found(Verdict::Refuted),
        // A text that is tried in the place of the display is not searched for the worst state.
        None if !context.options.explain && outcome.points > 0 && outcome.doubtful == 0 => found(Verdict::Verified),
        None => None,
    })
}

fn signed(of: &Expr, relation: Relation) -> Link {
    Link { lhs: of.clone(), relation, rhs: Expr::integer(0, Span::default()), free: Vec::new() }
}

/// The determinants of the first rows and columns of a symmetric matrix, of up to three.
fn minors(matrix: &[Vec<Expr>]) -> Vec<Expr> {
    let mut all = vec![matrix[0][0].clone()];
    if matrix.len() > 1 {
        all.push(determinant(matrix, (0, 1), (0, 1)));
    }
    if matrix.len() > 2 {
        let part =
            |k: usize, a: usize, b: usize| product(vec![matrix[0][k].clone(), determinant(matrix, (1, 2), (a, b))]);
        all.push(part(0, 1, 2).minus(part(1, 0, 2)).minus(part(2, 0, 1).negated()));
    }
    all
}

/// The determinant of two rows and two columns.
fn determinant(matrix: &[Vec<Expr>], (a, b): (usize, usize), (c, d): (usize, usize)) -> Expr {
    let entry = |row: usize, column: usize| matrix[row][column].clone();
    product(vec![entry(a, c), entry(b, d)]).minus(product(vec![entry(a, d), entry(b, c)]))
}
