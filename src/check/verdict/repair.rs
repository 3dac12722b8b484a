//! A suggested repair: one edit of the notes with which an equation passes.

use crate::latex::slips::{Edit, Slip};
use crate::source::Span;

use crate::check::verdict::Verdict;

/// An edit of the notes with which an equation passes.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Repair {
    /// The bytes of the notes that are replaced.
    pub span: Span,
    /// The text that replaces them.
    pub replacement: String,
    /// The kind of mistake that it corrects.
    pub slip: Slip,
    /// The verdict on the corrected equation; on the corrected step, if it corrects only that.
    pub verdict: Verdict,
    /// Whether it corrects one step of a chain only: the rest repeats the mistake or has another one.
    pub step: bool,
    /// Whether a side is then zero whatever its symbols mean. Such an edit is offered only if there is no other one.
    pub idle: bool,
    /// The other display that is changed, if several wrong equations use it.
    pub shared: Option<Shared>,
}

impl Repair {
    /// The repair that an edit of a text makes, where the text starts at `offset` in the notes.
    pub(crate) fn of(edit: Edit, offset: usize, verdict: Verdict) -> Repair {
        Repair {
            span: edit.span.shifted(offset),
            replacement: edit.replacement,
            slip: edit.slip,
            verdict,
            step: false,
            idle: false,
            shared: None,
        }
    }

    /// Whether the replacement is a number or text that is already in the notes. If not, the factor or term was
    /// composed from the derived equation.
    pub fn is_in_the_notes(&self, notes: &str) -> bool {
        if !matches!(self.slip, Slip::Factor | Slip::Term) {
            return true;
        }
        let put_in = self.replacement.trim().trim_end_matches(r"\,").trim().trim_start_matches(['+', '-']).trim();
        let is_number = put_in.replace(r"\frac", "").chars().all(|c| c.is_ascii_digit() || "{} /".contains(c));
        is_number || notes.contains(put_in)
    }
}

/// The equations that an edit of another display corrects.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Shared {
    /// The number of the display that is changed.
    pub of: String,
    /// The numbers of the equations that hold then.
    pub mends: Vec<String>,
}
