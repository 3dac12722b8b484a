//! Verdicts, their evidence, and the report of a document: what `check` gives and `report` prints.

use std::fmt;

pub(crate) mod finding;
pub(crate) mod progress;
pub(crate) mod repair;
pub(crate) mod report;

/// What is said of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Verdict {
    /// Decided over a prime field, up to a stated probability.
    Certified,
    /// Agrees at every usable sampled state.
    Verified,
    /// Introduces a symbol that later, checked equations stand on.
    Definition,
    /// A hypothesis, by the claims file's word.
    Law,
    /// A counterexample is given.
    Refuted,
    /// Agrees wherever both sides are defined, but one is defined where the other is not.
    Domain,
    /// Too few usable states, or states that cannot tell.
    Undecided,
    /// Could not be parsed or typed.
    Unreadable,
    /// Numbered, but nothing says what it should mean.
    Unclaimed,
}

impl Verdict {
    /// Every verdict, from the best to the worst; of several parts the worst counts.
    pub const ALL: [Verdict; 9] = [
        Verdict::Certified,
        Verdict::Verified,
        Verdict::Definition,
        Verdict::Law,
        Verdict::Unclaimed,
        Verdict::Undecided,
        Verdict::Domain,
        Verdict::Unreadable,
        Verdict::Refuted,
    ];

    /// Whether this verdict is a pass where nothing else is expected.
    pub fn passes(self) -> bool {
        matches!(self, Verdict::Certified | Verdict::Verified | Verdict::Definition | Verdict::Law)
    }

    /// Whether a claim was tested and found to hold.
    pub fn holds(self) -> bool {
        matches!(self, Verdict::Certified | Verdict::Verified)
    }

    /// How bad it is: its place in [`Verdict::ALL`].
    pub fn severity(self) -> usize {
        Verdict::ALL.iter().position(|verdict| *verdict == self).unwrap_or(0)
    }

    /// The word for it, as claims files and reports spell it.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Certified => "certified",
            Verdict::Verified => "verified",
            Verdict::Definition => "definition",
            Verdict::Law => "law",
            Verdict::Refuted => "refuted",
            Verdict::Domain => "domain",
            Verdict::Undecided => "undecided",
            Verdict::Unreadable => "unreadable",
            Verdict::Unclaimed => "unclaimed",
        }
    }

    /// The verdict that a word names.
    pub fn named(word: &str) -> Option<Verdict> {
        Verdict::ALL.into_iter().find(|verdict| verdict.word() == word)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}
