//! Points for wanted results.
//!
//! A slip costs points once: at the first result that it spoils. There the result gets half, if the rubric says so of that
//! kind of slip, and else nothing. Later results that carry the slip on are given in full.

use crate::check::document::setup::define_macros;
use crate::check::usage::{Usage, names_of};
use crate::latex::Macros;
use crate::notes::Display;

use super::judged::{Found, Judged};
use super::marked::{Line, Mark, Reached, ResultMark};
use super::problem::Problem;

/// The lines with their points, and the results.
pub(super) fn given(problem: &Problem, judged: Judged) -> (Vec<Line>, Vec<ResultMark>) {
    let Judged { mut lines, found } = judged;
    let mut results = nothing(problem);
    let steps = Steps::of(problem, &lines, &found);
    let mut charged: Vec<usize> = Vec::new();
    let mut order: Vec<usize> = (0..results.len()).collect();
    order.sort_by_key(|at| found[*at].as_ref().map_or(usize::MAX, |found| found.line));
    for at in order {
        let Some(found) = &found[at] else { continue };
        let result = &mut results[at];
        result.line = Some(found.line);
        let share = match found.is_right {
            true if steps.lead_to(found, &lines) => {
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

/// Which lines of a hand-in lead to results.
struct Steps {
    /// Whether a line is a step: a condition inside the text leads nowhere by itself.
    is_step: Vec<bool>,
    /// Whether a line is no more than a result.
    is_result: Vec<bool>,
    /// Whether that result is an equation of motion.
    is_motion: Vec<bool>,
    /// Whether no line is more than a result of the rubric, so that the hand-in may be a copy of the list.
    is_list: bool,
}

impl Steps {
    fn of(problem: &Problem, lines: &[Line], found: &[Option<Found>]) -> Steps {
        let is_step = |line: &Line| match line.mark {
            Mark::Right | Mark::Carried | Mark::Wrong => true,
            Mark::Given => !line.inline,
            Mark::Open | Mark::Unread => false,
        };
        let is_step: Vec<bool> = lines.iter().map(is_step).collect();
        let (mut is_result, mut is_motion) = (vec![false; lines.len()], vec![false; lines.len()]);
        let mut macros = Macros::default();
        define_macros(&problem.notes.macros, &mut macros);
        for (wanted, found) in problem.wanted.iter().zip(found) {
            let Some(found) = found else { continue };
            for at in found.parts.iter().copied().chain([found.line]) {
                is_result[at] |= !is_chain(&lines[at]) && !uses_others(problem, wanted.display, &lines[at], &macros);
                is_motion[at] |= found.is_motion;
            }
        }
        // Without a rubric each equation with a number is a result, and each step too.
        let is_list = problem.names_results && (0..lines.len()).all(|at| !is_step[at] || is_result[at]);
        Steps { is_step, is_result, is_motion, is_list }
    }

    /// Whether something leads to a result: a line before it, a chain, or nothing where it stands first in a hand-in that has
    /// other lines. In a list of results only an equation of motion leads to the result behind it.
    fn lead_to(&self, found: &Found, lines: &[Line]) -> bool {
        let line = found.line;
        // The statements of the result itself do not lead to it.
        let is_other = |at: &usize| self.is_step[*at] && *at != line && !found.parts.contains(at);
        let before = (0..line).rev().find(is_other);
        let is_first = before.is_none() && (0..lines.len()).any(|at| is_other(&at));
        let leads = |at: usize| !self.is_list || self.is_motion[at] && self.is_result[at];
        before.is_some_and(leads) || is_chain(&lines[line]) || is_first && (!self.is_list || found.is_motion)
    }
}

/// Whether a line reaches a result by other quantities of the problem than those in the display of the result, and so is no copy of it:
/// ω = 2π/T for ω = √(k/m).
fn uses_others(problem: &Problem, wanted: usize, line: &Line, macros: &Macros) -> bool {
    let display = &problem.notes.equations[wanted];
    let of = |text: String| names_of(&[Display { text, ..display.clone() }], macros);
    // What stands in the middle of a chain is on the way to the result.
    let (first, last) = (display.text.split('=').next(), display.text.rsplit('=').next());
    let printed = of([first, last].map(Option::unwrap_or_default).join(" = "));
    let is_other = |usage: &Usage| {
        problem.names.symbols.find(&usage.name).is_some() && printed.iter().all(|other| other.name != usage.name)
    };
    of(line.statement.clone()).iter().any(is_other)
}

/// Whether a line is a chain, which leads to its last member.
fn is_chain(line: &Line) -> bool {
    line.statement.matches('=').count() > 1
}
