//! A judged hand-in, before points are given.

use crate::notes::claims::Lost;

use super::marked::{Line, Mark};

/// A line that reaches a result.
#[derive(Clone, Debug)]
pub(super) struct Found {
    /// The line, by its place.
    pub line: usize,
    /// Whether it is right; else it reaches the result with a slip.
    pub is_right: bool,
    /// The kind of the slip, if it is known.
    pub lost: Option<Lost>,
}

/// The lines of a hand-in with their marks, and the lines that reach the wanted results.
pub(super) struct Judged {
    pub lines: Vec<Line>,
    pub found: Vec<Option<Found>>,
}

impl Judged {
    /// How well the hand-in fits the problem: what holds and is reached, less what is false or cannot be read.
    pub fn score(&self) -> i64 {
        let weight = |line: &Line| match line.mark {
            Mark::Right => 2,
            Mark::Carried => 1,
            Mark::Wrong => -2,
            Mark::Unread | Mark::Open => -1,
            Mark::Given => 0,
        };
        let reached = self.found.iter().flatten().filter(|found| found.is_right).count();
        self.lines.iter().map(weight).sum::<i64>() + 4 * i64::try_from(reached).unwrap_or(0)
    }
}
