//! A repair: one edit of the notes with which an equation passes.

use crate::latex::slips::Slip;
use crate::source::Span;

use crate::check::verdict::Verdict;

/// An edit of the notes with which an equation passes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repair {
    /// The bytes of the notes that go.
    pub span: Span,
    /// What comes in their place.
    pub replacement: String,
    /// The slip that it undoes.
    pub slip: Slip,
    /// The verdict on the equation then; on the step, where it mends no more than that.
    pub verdict: Verdict,
    /// Whether it mends a step of a chain and not yet the rest, which carries the slip on or has another.
    pub step: bool,
    /// Whether a side is then zero whatever its symbols mean: offered where nothing else is, and for its author to make.
    pub idle: bool,
    /// Where it changes another display, on which several wrong equations stand.
    pub shared: Option<Shared>,
}

impl Repair {
    /// Whether it changes what stands in the notes, or puts in what stands there already, or a number; else the factor or
    /// the term was put together from what is true.
    pub fn is_in_the_notes(&self, notes: &str) -> bool {
        if !matches!(self.slip, Slip::Factor | Slip::Term) {
            return true;
        }
        let put_in = self.replacement.trim().trim_end_matches(r"\,").trim().trim_start_matches(['+', '-']).trim();
        let is_number = put_in.replace(r"\frac", "").chars().all(|c| c.is_ascii_digit() || "{} /".contains(c));
        is_number || notes.contains(put_in)
    }
}

/// What one edit of a display mends beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shared {
    /// The display that is changed, by its number.
    pub of: String,
    /// The equations that hold then, by their numbers.
    pub mends: Vec<String>,
}
