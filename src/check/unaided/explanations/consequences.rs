//! Displays that are wrong only because another one is.
//!
//! A slip in a formula makes whatever is calculated with it wrong too. The notes are judged once more with the slip corrected:
//! a display that is not wrong then, and contradicts nothing, is not called wrong.

use crate::Result;
use crate::check::trial::edited_document::with_text;
use crate::check::unaided::contradictions::undecided;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::notes::Notes;

/// The most corrections with which the notes are judged again.
const TRIED: usize = 4;

/// A correction of a display, and what is not wrong with it.
struct Correction {
    at: usize,
    others: Vec<usize>,
}

/// Takes the findings back that are consequences of others; `judge` gives the findings on notes.
///
/// # Errors
/// As for `judge`.
pub(super) fn excused(
    notes: &Notes,
    found: &mut [Equation],
    judge: &dyn Fn(&Notes) -> Result<Vec<Equation>>,
) -> Result<()> {
    let mut wrong: Vec<usize> = (0..found.len()).filter(|at| is_wrong(&found[*at])).collect();
    // Of two corrections that do the same, that of a definition comes first.
    wrong.sort_by_key(|at| found[*at].finding.code != Code::DefinitionContradicted);
    if wrong.len() < 2 {
        return Ok(());
    }
    let mut corrections = Vec::new();
    for at in wrong.iter().copied().filter(|at| correction_of(&found[*at]).is_some()).take(TRIED) {
        if let Some(again) = corrected(notes, &found[at], judge)? {
            let is_still = |place: usize| {
                let is_it = |equation: &&Equation| equation.id == found[place].id;
                again.iter().find(is_it).is_none_or(|found| !found.ok)
            };
            let others: Vec<usize> = wrong.iter().copied().filter(|other| *other != at && !is_still(*other)).collect();
            if !is_still(at) {
                corrections.push(Correction { at, others });
            }
        }
    }
    corrections.sort_by_key(|correction| std::cmp::Reverse(correction.others.len()));
    for Correction { at, others } in corrections {
        if !is_wrong(&found[at]) {
            continue;
        }
        let name = found[at].id.clone();
        for other in others.into_iter().filter(|other| *other != at) {
            if is_wrong(&found[other]) {
                found[other] = undecided(&found[other], format!("this is no longer wrong once ({name}) is corrected"));
            }
        }
    }
    Ok(())
}

fn is_wrong(equation: &Equation) -> bool {
    equation.finding.verdict == Verdict::Refuted
}

/// The first correction of a display with which it is known to hold.
fn correction_of(equation: &Equation) -> Option<&Repair> {
    let first = equation.repairs.first()?;
    (matches!(first.verdict, Verdict::Certified | Verdict::Verified) && first.shared.is_none()).then_some(first)
}

/// The findings on notes in which a display is corrected; `None` if they cannot be read so.
pub(super) fn corrected(
    notes: &Notes,
    wrong: &Equation,
    judge: &dyn Fn(&Notes) -> Result<Vec<Equation>>,
) -> Result<Option<Vec<Equation>>> {
    let edited = correction_of(wrong).and_then(|repair| with_repair(notes, repair));
    edited.as_ref().map(judge).transpose()
}

/// The notes with a correction; `None` if they cannot be read so.
pub(super) fn with_repair(notes: &Notes, repair: &Repair) -> Option<Notes> {
    let mut text = notes.source.text.clone();
    text.get(repair.span.range())?;
    text.replace_range(repair.span.range(), &repair.replacement);
    with_text(notes, text).ok()
}
