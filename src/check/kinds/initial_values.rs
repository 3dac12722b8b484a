//! Equations of a motion that starts with given values: x(0) = x_0 and ẋ(0) = 0.
//!
//! The motion follows from these values, so its derivatives by the time are known where it starts. An equation holds along it if both sides,
//! and their derivatives, agree there; as many are compared as the series in time have. This decides an energy relation as well as a
//! solution, and needs no numerical solution of the equations of motion.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node};

use crate::check::judge::identity;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The number of derivatives that are compared, beside the two sides themselves.
const DERIVATIVES: u8 = 4;

/// Checks a link along the motion that starts as the hypotheses of the context say, at the time 0.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn check(link: &Link, context: &Context<'_>) -> Result<Finding> {
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
        let message = "too few derivatives could be compared where the motion starts";
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    let message = format!(
        "holds along the motion that starts like this: the two sides and their first {compared} derivatives agree there"
    );
    let why = "derivatives where the motion starts, which are compared to a finite order";
    Ok(Finding { points, tried: points, ..context.verified(message, why) })
}
