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
        let reached = self.found.iter().flatten().filter(|found| found.is_right).count();
        worth(&self.lines).0 + RESULT * count(reached)
    }
}

/// What a right line and a result that is reached add to the score; after a false line a right one adds less.
const RIGHT: i64 = 4;
const RIGHT_AFTER: i64 = 2;
const RESULT: i64 = 8;

/// The most that the score of a hand-in can become, of which these lines are judged and others are left, with so many results.
pub(super) fn at_most(lines: &[Line], left: usize, results: usize) -> i64 {
    let (sum, is_after) = worth(lines);
    sum + count(left) * if is_after { RIGHT_AFTER } else { RIGHT } + RESULT * count(results)
}

/// What lines add to the score, and whether one is false. After the first false line a false line may be carried on, and says
/// little; so does a true one, which may follow from it.
fn worth(lines: &[Line]) -> (i64, bool) {
    let mut is_after = false;
    let mut sum = 0;
    for line in lines {
        sum += match line.mark {
            Mark::Right if is_after => RIGHT_AFTER,
            Mark::Right => RIGHT,
            Mark::Carried => 2,
            Mark::Wrong if is_after => -1,
            Mark::Wrong => -4,
            Mark::Unread | Mark::Open => -2,
            Mark::Given => 0,
        };
        is_after |= line.mark == Mark::Wrong;
    }
    (sum, is_after)
}

fn count(number: usize) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX / 100)
}
