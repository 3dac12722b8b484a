//! A wrong equation, as repair sees it.

use crate::latex::Reading;
use crate::latex::slips::Edit;
use crate::notes::claims::Claim;
use crate::source::Span;

/// So many suggestions are offered at most.
pub(crate) const OFFERED: usize = 3;

/// So many factors, and so many terms, are tried where something may have been left out.
pub(crate) const MISSING: usize = 48;

/// What is to be mended.
pub(crate) struct Wrong<'w> {
    /// The display, by its place.
    pub at: usize,
    /// Its text.
    pub text: &'w str,
    /// How it is read.
    pub reading: &'w Reading,
    /// What is claimed of it.
    pub claim: &'w Claim,
    /// The places in the text where it is wrong; all of it, if there are none.
    pub places: Vec<Span>,
    /// The steps of chains that can be mended alone: of each the statement and the member that is wrong.
    pub steps: Vec<(usize, usize)>,
}

impl Wrong<'_> {
    pub(crate) fn concerns(&self, edit: &Edit) -> bool {
        self.places.is_empty() || self.places.iter().any(|place| place.contains(edit.span))
    }
}
