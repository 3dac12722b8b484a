//! Which of several slips explains that displays are called wrong.
//!
//! | file | what it has |
//! | --- | --- |
//! | `shared_cause` | a definition or the Lagrangian, with which several displays are wrong |
//! | `consequences` | a display before them, from which they were calculated |
//!
//! Offers `weighed`, which takes findings back. Knows the guessed claims, `contradictions`, and `repair` and below.

mod consequences;
mod shared_cause;

use crate::Result;
use crate::check::document::setup::Run;
use crate::check::verdict::report::Equation;
use crate::notes::Notes;

/// How notes are read and judged.
pub(super) struct Judge<'j> {
    /// Each statement of notes as a display with a name.
    pub named: &'j dyn Fn(&Notes) -> Notes,
    /// The findings on notes.
    pub found: &'j dyn Fn(&Notes) -> Result<Vec<Equation>>,
}

/// Takes the findings back that other slips explain: in what a display uses, and in a display before it.
///
/// # Errors
/// As for a check of the notes.
pub(super) fn weighed(run: &Run<'_>, notes: &Notes, found: &mut [Equation], judge: &Judge<'_>) -> Result<()> {
    shared_cause::weighed(run, notes, found, judge)?;
    consequences::excused(notes, found, judge.found)
}
