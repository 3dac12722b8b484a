//! The items that an edit is tried for: displays and sentences of a document, and an edit with those that pass with it.

use crate::latex::slips::Edit;
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::verdict::Verdict;

impl Checker<'_> {
    /// Whether a claim needs many states, since it says at which states something holds.
    pub(crate) fn takes_many_states(&self, item: Item) -> bool {
        self.claim_of(item).is_some_and(|claim| !claim.exactly_when.is_empty())
    }

    /// Whether a claim holds under hypotheses only.
    pub(crate) fn has_hypotheses(&self, item: Item) -> bool {
        self.claim_of(item).is_some_and(|claim| !claim.assume.is_empty() || !claim.throughout.is_empty())
    }

    fn claim_of(&self, item: Item) -> Option<&Claim> {
        match item {
            Item::Display(at) => self.assigned[at],
            Item::Sentence(at) => Some(&self.claims.sentences[at].claim),
        }
    }
}

/// The displays and sentences that are as expected, by their indices.
pub(crate) struct Passing {
    pub displays: Vec<usize>,
    pub sentences: Vec<usize>,
}

/// A display or a sentence, by its index.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Item {
    /// A display.
    Display(usize),
    /// A sentence of the claims file.
    Sentence(usize),
}

impl Item {
    /// The display that it is, if it is one.
    pub fn display(self) -> Option<usize> {
        match self {
            Item::Display(at) => Some(at),
            Item::Sentence(_) => None,
        }
    }
}

/// An edit of a display, and the items that pass with it.
pub(crate) struct SharedEdit {
    pub at: usize,
    pub edit: Edit,
    pub repaired: Vec<(Item, Verdict)>,
}
