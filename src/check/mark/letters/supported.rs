//! Whether the lines of a hand-in support it that a letter of the problem stands for another quantity of the problem.
//!
//! A letter that the problem uses is that letter. One line that becomes right with another meaning proves little: `h = u^2/(2g)` is
//! right if u is the speed v_2, and the student may have taken the wrong speed.

use crate::check::mark::judged::Judged;
use crate::check::mark::marked::{Line, Mark};
use crate::check::mark::names::{Letters, Names};
use crate::check::mark::problem::Problem;
use crate::check::usage::Usage;
use crate::check::verdict::Verdict;
use crate::formula::symbols::Name;

/// The fewest right lines with a letter of the problem that give it another meaning.
const FEWEST: usize = 2;

/// Whether each letter of the problem that stands for another one does so in several right lines and in no false one, and no line
/// with it is right as it stands. Where a line is one of the problem with these letters (`is_by_form`), one other line may be false.
/// `names` are those in each line; `plain` is the hand-in judged with the letters in `declared` alone.
pub(super) fn is_supported(
    problem: &Problem,
    (declared, way, is_by_form): (&Letters, &Letters, bool),
    names: &[Vec<Usage>],
    (plain, judged): (&Judged, &Judged),
) -> bool {
    let new = way.keys().filter(|name| !declared.contains_key(*name) && is_of_problem(&problem.names, name));
    new.into_iter().all(|name| {
        let has = |at: &usize| names[*at].iter().any(|usage| usage.name.base == name.base && same(&usage.name, name));
        let lines: Vec<usize> = (0..names.len()).filter(has).collect();
        let mark = |judged: &Judged, at: usize| judged.lines.get(at).map(|line| line.mark);
        let is_false = |at: &usize| {
            matches!(mark(judged, *at), None | Some(Mark::Wrong | Mark::Carried | Mark::Unread | Mark::Open))
        };
        let is_wrong = |at: &&usize| matches!(mark(judged, **at), None | Some(Mark::Wrong));
        let is_refuted = match is_by_form {
            true => lines.iter().filter(is_wrong).count() > 1,
            false => lines.iter().any(is_false),
        };
        // Beside names of the student's own a line may be right with any meaning of the letter.
        let is_open =
            |at: usize| is_by_form && names[at].iter().any(|usage| problem.names.symbols.find(&usage.name).is_none());
        let is_plain = |at: &usize| plain.lines.get(*at).is_some_and(is_true) && !is_open(*at);
        let right = lines.iter().filter(|at| judged.lines.get(**at).is_some_and(is_true)).count();
        right >= FEWEST && !is_refuted && !lines.iter().any(is_plain)
    })
}

/// Whether a line is true, and not only taken for granted.
fn is_true(line: &Line) -> bool {
    line.mark == Mark::Right || line.verdict == Some(Verdict::Law)
}

/// Whether a name is that of a number of the problem.
fn is_of_problem(known: &Names, name: &Name) -> bool {
    known.names.iter().any(|(own, ..)| own == name)
}

fn same(a: &Name, b: &Name) -> bool {
    Name { primes: 0, ..a.clone() } == Name { primes: 0, ..b.clone() }
}
