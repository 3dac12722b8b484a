//! Equations of a motion that starts with given values: x(0) = x_0 and ẋ(0) = 0.
//!
//! The motion follows from these values, so its derivatives by the time are known where it starts. An equation holds along it if both sides,
//! and their derivatives, agree there; as many are compared as the series in time have. This decides an energy relation as well as a
//! solution, and needs no numerical solution of the equations of motion.
//!
//! Where a coordinate rests all the time, its derivatives say nothing, so the equation must hold for all motions, or for all
//! with the energy of this start.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation};

use crate::check::judge::identity;
use crate::check::kinds::mechanics::energy_of_start;
use crate::check::kinds::printed_solution::Solution;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The derivatives of a coordinate that vanish where it rests.
const DOTS_AT_REST: u8 = 3;

/// The number of derivatives that are compared, beside the two sides themselves.
const DERIVATIVES: u8 = 4;

/// Checks a link along the motion that starts as the hypotheses of the context say, at the time 0.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn check(link: &Link, context: &Context<'_>) -> Result<Finding> {
    let found = where_it_starts(link, context)?;
    if found.code == Code::NoState {
        return Ok(by_the_energy_alone(link, context)?.unwrap_or(found));
    }
    if !found.verdict.holds() {
        return Ok(found);
    }
    let on_energy = energy_of_start::holds(link, context)?;
    let rests = rests(link, context)?;
    if rests && on_energy != Some(true) {
        let in_general = Context { hypotheses: &[], on_shell: Some(true), ..context.quick() };
        if !identity::check(link, &in_general)?.verdict.holds() {
            let message = "the system stays at rest from this start, so any relation that holds at the start would \
                           pass; give initial values from which it moves";
            return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
        }
    }
    if on_energy == Some(false) && !has_a_branch(link) {
        let message = format!(
            "at the start, the two sides and their first {DERIVATIVES} derivatives agree; but this fails for other \
             motions with the same energy, so it was not decided"
        );
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    Ok(found)
}

/// The finding on a motion of one coordinate that starts at an end of its range, where no state is sampled, as at θ = 0 of (0, π/2): its
/// energy decides where a formula has no branch.
fn by_the_energy_alone(link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
    if context.model.coordinates.len() != 1 || has_a_branch(link) {
        return Ok(None);
    }
    let Some(found) = energy_of_start::check(link, context)? else { return Ok(None) };
    Ok(match found.verdict {
        verdict if verdict.holds() => {
            let message = "holds for every motion with the energy of this start";
            let why = "a claim about one start, of which only the energy was used";
            Some(Finding { points: found.points, tried: found.tried, ..context.verified(message, why) })
        }
        Verdict::Refuted => {
            let message = "the two sides differ on a motion with the energy of this start".to_owned();
            Some(Finding { message, code: Code::SidesDiffer, ..found })
        }
        _ => None,
    })
}

/// Whether a printed solution has the position and the velocity of a start that the hypotheses of the context give at the time 0.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn holds_at_start(solution: &Solution, context: &Context<'_>) -> Result<bool> {
    let hypotheses: Vec<Hypothesis> =
        context.hypotheses.iter().map(|known| Hypothesis { implied: true, ..known.clone() }).collect();
    let context = Context { hypotheses: &hypotheses, on_shell: Some(true), ..context.quick() };
    for link in [solution.link(0), solution.link(1)] {
        let ensemble = context.ensemble(context.mode(true, &[&link.lhs, &link.rhs]), false, FEWEST)?;
        if !run(&link, &ensemble.states).is_ok_and(|found| found.failure.is_none() && found.points > 0) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether a coordinate of a link stays where it is along the motion that starts like this, and does not along each motion.
fn rests(link: &Link, context: &Context<'_>) -> Result<bool> {
    let model = context.model;
    let implied: Vec<Hypothesis> =
        context.hypotheses.iter().map(|known| Hypothesis { implied: true, ..known.clone() }).collect();
    let multipliers: Vec<usize> =
        model.printed_lagrangian.iter().flat_map(|printed| &printed.constraints).map(|(at, _)| *at).collect();
    for (_, coordinate) in model.coordinates.iter().enumerate().filter(|(at, _)| !multipliers.contains(at)) {
        let id = coordinate.symbol;
        if !model.depends_on(&link.lhs, &[id]) && !model.depends_on(&link.rhs, &[id]) {
            continue;
        }
        let stays = |hypotheses: &[Hypothesis], dots: u8| -> Result<bool> {
            let rate = Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, link.lhs.span);
            let zero = Expr::integer(0, link.lhs.span);
            let at_rest = Link { lhs: rate, relation: Relation::Equal, rhs: zero, free: Vec::new() };
            let context = Context { hypotheses, on_shell: Some(true), ..context.quick() };
            let mode = context.mode(true, &[&at_rest.lhs]);
            let ensemble = context.ensemble(mode, false, FEWEST)?;
            Ok(run(&at_rest, &ensemble.states).is_ok_and(|found| found.failure.is_none() && found.points > 0))
        };
        let mut rests = true;
        for dots in 1..=DOTS_AT_REST {
            rests = rests && stays(&implied, dots)?;
        }
        if rests && !stays(&[], 1)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether a link has a root, a modulus or a plain rate in it, of which only one sign belongs to the motion that starts.
fn has_a_branch(link: &Link) -> bool {
    let mut found = false;
    for side in [&link.lhs, &link.rhs] {
        let plain = |part: &Expr| matches!(&part.node, Node::Symbol { dots: 1, .. });
        found |= plain(side);
        side.walk(&mut |part| {
            found |= match &part.node {
                Node::Root(..) | Node::Norm(_) => true,
                Node::Sum(terms) => terms.iter().any(|term| plain(&term.expr)),
                Node::Product(factors) => factors.iter().filter(|factor| plain(factor)).count() == 1,
                Node::Quotient(a, b) => plain(a) || plain(b),
                Node::Power(base, exponent) => plain(base) && !is_even(exponent),
                _ => false,
            };
        });
    }
    found
}

fn is_even(exponent: &Expr) -> bool {
    matches!(&exponent.node, Node::Number(digits) if digits.parse::<u32>().is_ok_and(|n| n % 2 == 0))
}

/// The finding by the derivatives where the motion starts.
fn where_it_starts(link: &Link, context: &Context<'_>) -> Result<Finding> {
    let hypotheses: Vec<Hypothesis> =
        context.hypotheses.iter().map(|known| Hypothesis { implied: true, ..known.clone() }).collect();
    let context = &Context { hypotheses: &hypotheses, on_shell: Some(true), ..*context };
    let rate = |side: &Expr, times: u8| Expr::new(Node::TimeDerivative(times, Box::new(side.clone())), side.span);
    let (mut points, mut compared) = (usize::MAX, 0);
    for times in 0..=DERIVATIVES {
        let link = match times {
            0 => link.clone(),
            _ => Link { lhs: rate(&link.lhs, times), rhs: rate(&link.rhs, times), ..link.clone() },
        };
        let ensemble = context.ensemble(context.mode(true, &[&link.lhs, &link.rhs]), false, context.options.points)?;
        if ensemble.states.is_empty() {
            return Ok(context.no_state(&ensemble));
        }
        // A derivative of an order that the series do not have is compared no more.
        let Ok(found) = run(&link, &ensemble.states) else { break };
        if found.failure.is_some() {
            let message = match times {
                0 => "the two sides differ where the motion starts".to_owned(),
                _ => "the two sides differ along the motion that starts like this; below are their derivatives at the start"
                    .to_owned(),
            };
            if !context.options.explain {
                return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, message));
            }
            let shown = identity::check(&link, &context.quick())?;
            return Ok(match shown.verdict {
                Verdict::Refuted => Finding { message, ..shown },
                _ => context.finding(Code::SidesDiffer, Verdict::Refuted, message),
            });
        }
        if found.points == 0 || found.doubtful > 0 {
            break;
        }
        (points, compared) = (points.min(found.points), times);
    }
    if compared < 2 {
        let message = "at the start, too few derivatives could be compared, so this was not decided";
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    let message = format!(
        "holds along the motion that starts like this: the two sides and their first {compared} derivatives agree there"
    );
    let why = "derivatives where the motion starts, which are compared to a finite order";
    Ok(Finding { points, tried: points, ..context.verified(message, why) })
}
