//! When letters count with which a line is an equation of the problem but for a slip.
//!
//! In such a hand-in each line may be taken for the definition of a letter of the student's own, and no line would be wrong: `M b = M g
//! \cos\theta - F` defines F. So these letters count only where the hand-in says nothing in the letters of the problem, and where most of
//! its lines are no further mistakes with them.

use crate::check::mark::judged::Judged;
use crate::check::mark::marked::Mark;
use crate::check::mark::names::{Letters, Names};
use crate::check::usage::Usage;

/// Whether a hand-in reaches no result, and each of its true lines that is no law has a letter that stands for nothing in the problem.
/// `names` are those in each line.
pub(super) fn says_nothing(known: &Names, table: &Letters, names: &[Vec<Usage>], judged: &Judged) -> bool {
    let is_own = |usage: &Usage| known.symbols.find(&usage.name).is_none() && !table.contains_key(&usage.name);
    let mut lines = judged.lines.iter().zip(names);
    judged.reached() == 0 && lines.all(|(line, names)| line.mark != Mark::Right || names.iter().any(is_own))
}

/// How many lines are right or follow from a wrong one, with letters that make a line one of the problem with a slip; `None`, if no line is
/// wrong, or if most lines are. `plain` are the marks without these letters.
pub(super) fn sound(plain: &[Mark], judged: &Judged) -> Option<usize> {
    let count = |marks: &[Mark]| judged.lines.iter().filter(|line| marks.contains(&line.mark)).count();
    let wrong = count(&[Mark::Wrong]);
    let is_open = |mark: &&Mark| matches!(mark, Mark::Open | Mark::Unread);
    let is_mostly_sound = wrong <= 1 || 2 * wrong <= judged.lines.len();
    let is_decided = count(&[Mark::Open, Mark::Unread]) <= plain.iter().filter(is_open).count();
    (wrong > 0 && is_mostly_sound && is_decided).then(|| count(&[Mark::Right, Mark::Carried]))
}
