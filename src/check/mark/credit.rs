//! Points for wanted results.
//!
//! A slip costs points once: at the first result that it spoils. There the result gets half, if the rubric says so of that
//! kind of slip, and else nothing. Later results that carry the slip on are given in full.

use super::judged::{Found, Judged};
use super::marked::{Line, Mark, Reached, ResultMark};
use super::problem::Problem;

/// The lines with their points, and the results.
pub(super) fn given(problem: &Problem, judged: Judged) -> (Vec<Line>, Vec<ResultMark>) {
    let Judged { mut lines, found } = judged;
    let mut results = nothing(problem);
    let mut charged: Vec<usize> = Vec::new();
    let mut order: Vec<usize> = (0..results.len()).collect();
    order.sort_by_key(|at| found[*at].as_ref().map_or(usize::MAX, |found| found.line));
    for at in order {
        let Some(found) = &found[at] else { continue };
        let result = &mut results[at];
        result.line = Some(found.line);
        let share = match found.is_right {
            true if has_steps(found, &lines) => {
                result.reached = Reached::Yes;
                1.0
            }
            true => {
                result.reached = Reached::WithoutSteps;
                problem.without_steps()
            }
            false => {
                let mut root = found.line;
                while let Some(before) = lines[root].follows_from {
                    root = before;
                }
                let is_charged = charged.contains(&root);
                let is_slip = is_charged || found.lost.is_some();
                result.reached = if is_slip { Reached::WithSlip } else { Reached::Wrong };
                charged.push(root);
                match found.lost {
                    _ if is_charged => 1.0,
                    Some(lost) if problem.rubric.half_for.contains(&lost) => 0.5,
                    _ => 0.0,
                }
            }
        };
        result.got = result.points * share;
        let line = &mut lines[found.line];
        line.result.get_or_insert(at);
        line.credit = Some(line.credit.unwrap_or(0.0) + result.got);
    }
    // Without a rubric, a later result shows that the ones before it were passed.
    if !problem.names_results {
        let last = results
            .iter()
            .rposition(|result| matches!(result.reached, Reached::Yes | Reached::WithSlip | Reached::Wrong));
        for result in results.iter_mut().take(last.unwrap_or(0)).filter(|result| result.reached == Reached::No) {
            (result.reached, result.got) = (Reached::Passed, result.points);
        }
    }
    (lines, results)
}

/// The results of a hand-in that has none.
pub(super) fn nothing(problem: &Problem) -> Vec<ResultMark> {
    let missing = |wanted: &super::problem::Wanted| ResultMark {
        id: wanted.id.clone(),
        name: wanted.name.clone(),
        points: wanted.points,
        reached: Reached::No,
        line: None,
        got: 0.0,
    };
    problem.wanted.iter().map(missing).collect()
}

/// Whether a line before the one that reaches a result leads to it. What stands first in a hand-in needs none, unless it is all that
/// there is.
fn has_steps(found: &Found, lines: &[Line]) -> bool {
    // A condition inside the text leads nowhere by itself.
    let is_step = |line: &Line| match line.mark {
        Mark::Right | Mark::Carried | Mark::Wrong => true,
        Mark::Given => !line.inline,
        Mark::Open | Mark::Unread => false,
    };
    let line = found.line;
    // The statements of the result itself do not lead to it.
    let is_other = |at: &usize| is_step(&lines[*at]) && *at != line && !found.parts.contains(at);
    let is_chain = lines[line].statement.matches('=').count() > 1;
    let is_first = !lines[..line].iter().any(is_step) && (0..lines.len()).any(|at| is_other(&at));
    (0..line).any(|at| is_other(&at)) || is_chain || is_first
}
