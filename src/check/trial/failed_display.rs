//! A display that failed its check, as mutation testing and repairs take it.

use crate::latex::Reading;
use crate::latex::slips::Edit;
use crate::notes::claims::Claim;
use crate::source::Span;

/// The largest number of suggestions for one equation.
pub(crate) const OFFERED: usize = 3;

/// The largest number of factors, and of terms, that are tried as missing ones.
pub(crate) const MISSING: usize = 48;

/// A display to be repaired.
pub(crate) struct FailedDisplay<'w> {
    /// The display, by its place.
    pub at: usize,
    /// Its text.
    pub text: &'w str,
    /// Its reading.
    pub reading: &'w Reading,
    /// Its claim.
    pub claim: &'w Claim,
    /// The places in the text where it is wrong; all of it, if there are none.
    pub places: Vec<Span>,
    /// The steps of chains that can be repaired alone, each as the statement and the wrong member.
    pub steps: Vec<(usize, usize)>,
}

impl FailedDisplay<'_> {
    /// Whether an edit changes a place where the display is wrong.
    pub(crate) fn concerns(&self, edit: &Edit) -> bool {
        self.places.is_empty() || self.places.iter().any(|place| place.contains(edit.span))
    }
}

/// Reduces a chain to the step that leads to a member.
pub(crate) fn cut_to_step(reading: &mut Reading, (at, member): (usize, usize)) {
    if let Some(Ok(statement)) = reading.statements.get_mut(at)
        && (1..statement.members.len()).contains(&member)
    {
        statement.members = statement.members[member - 1..=member].to_vec();
        statement.relations = vec![statement.relations[member - 1]];
        statement.constant = None;
        reading.introduced.retain(|introduced| introduced.statement != at);
    }
}
