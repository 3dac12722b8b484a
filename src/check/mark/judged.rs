//! A judged hand-in, before points are given.

use crate::notes::claims::Lost;

use super::marked::{Line, Mark};
use crate::check::verdict::Verdict;

/// A line that reaches a result.
#[derive(Clone, Debug)]
pub(super) struct Found {
    /// The line, by its place.
    pub line: usize,
    /// Whether it is right; else it reaches the result with a slip.
    pub is_right: bool,
    /// The kind of the slip, if it is known.
    pub lost: Option<Lost>,
    /// The lines that say the statements of the result, where these stand on lines of their own.
    pub parts: Vec<usize>,
    /// Whether the result is an equation of motion.
    pub is_motion: bool,
}

/// The lines of a hand-in with their marks, and the lines that reach the wanted results.
pub(super) struct Judged {
    pub lines: Vec<Line>,
    pub found: Vec<Option<Found>>,
}

impl Judged {
    /// How well the hand-in fits the problem: what holds and is reached, less what is false or cannot be read.
    pub fn score(&self) -> i64 {
        let marks: Vec<Mark> = self.lines.iter().map(counted).collect();
        worth(&marks) + RESULT * count(self.reached())
    }

    /// Whether all lines were judged, and the results were sought.
    pub fn is_complete(&self) -> bool {
        !self.found.is_empty()
    }

    /// The number of results that are reached.
    pub fn reached(&self) -> usize {
        self.found.iter().flatten().filter(|found| found.is_right).count()
    }
}

/// What a right line and a result that is reached add to the score; after a false line a right one adds less.
const RIGHT: i64 = 4;
const RIGHT_AFTER: i64 = 2;
const RESULT: i64 = 8;

/// What is known before a hand-in is judged with other letters, from those with which it was judged before.
pub(super) struct Rival {
    /// The score that must be beaten.
    pub score: i64,
    /// The mark of each line that is the same with letters that were tried.
    pub known: Vec<Option<Mark>>,
    /// For letters that were tried: how many results were reached, and the lines that are not the same with them.
    pub reached: Vec<(usize, Vec<bool>)>,
    /// The number of results.
    pub results: usize,
}

impl Rival {
    /// Whether the score may still be beaten, of which so many lines are judged.
    pub fn may_be_beaten(&self, judged: &[Line]) -> bool {
        // A new condition may make any line after it true.
        let is_condition = |(at, line): (usize, &Line)| {
            self.known[at].is_none() && line.mark == Mark::Given && line.verdict == Some(Verdict::Assumed)
        };
        let is_open = judged.iter().enumerate().any(is_condition);
        let left = self.known.iter().skip(judged.len()).map(|known| known.filter(|_| !is_open).unwrap_or(Mark::Right));
        let marks: Vec<Mark> = judged.iter().map(counted).chain(left).collect();
        // Only a line that is not the same reaches a result that no line has reached.
        let reached = |(reached, is_changed): &(usize, Vec<bool>)| {
            reached + (0..marks.len()).filter(|at| (is_open || is_changed[*at]) && marks[*at] == Mark::Right).count()
        };
        let reached = self.reached.iter().map(reached).min().unwrap_or(self.results).min(self.results);
        worth(&marks) + RESULT * count(reached) > self.score
    }
}

/// The mark with which a line counts where letters are sought: that it prints a law of the problem says as much as a right line.
pub(super) fn counted(line: &Line) -> Mark {
    if line.mark == Mark::Given && line.verdict == Some(Verdict::Law) { Mark::Right } else { line.mark }
}

/// What lines add to the score. After the first false line a false line may be carried on, and says
/// little; so does a true one, which may follow from it.
fn worth(marks: &[Mark]) -> i64 {
    let mut is_after = false;
    let mut sum = 0;
    for mark in marks {
        sum += match mark {
            Mark::Right if is_after => RIGHT_AFTER,
            Mark::Right => RIGHT,
            Mark::Carried => 2,
            Mark::Wrong if is_after => -1,
            Mark::Wrong => -4,
            Mark::Unread | Mark::Open => -2,
            Mark::Given => 0,
        };
        is_after |= *mark == Mark::Wrong;
    }
    sum
}

fn count(number: usize) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX / 100)
}
