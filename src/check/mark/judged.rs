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
    /// How well the hand-in fits the problem: what holds and is reached, less what is false or cannot be read. After the first
    /// false line a false line may be carried on, and says little; so does a true one, which may follow from it.
    pub fn score(&self) -> i64 {
        let mut is_after = false;
        let mut sum = 0;
        for line in &self.lines {
            sum += match line.mark {
                Mark::Right if is_after => 2,
                Mark::Right => 4,
                Mark::Carried => 2,
                Mark::Wrong if is_after => -1,
                Mark::Wrong => -4,
                Mark::Unread | Mark::Open => -2,
                Mark::Given => 0,
            };
            is_after |= line.mark == Mark::Wrong;
        }
        let reached = self.found.iter().flatten().filter(|found| found.is_right).count();
        sum + 8 * i64::try_from(reached).unwrap_or(0)
    }
}
