//! Verdicts, their evidence, and the report of a document: what `check` gives and `report` prints.
//!
//! Offers [`Verdict`], and in its files findings, suggestions (in the code: repairs) and reports. Knows no other folder of `check`.

use std::fmt;

pub(crate) mod finding;
pub(crate) mod progress;
pub(crate) mod repair;
pub(crate) mod report;

/// The verdict on a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Verdict {
    /// Holds exactly: decided over a prime field, up to a stated probability.
    Certified,
    /// Holds at every sampled state that can decide it.
    Verified,
    /// Defines a symbol, and checked equations test the definition.
    Definition,
    /// A law: a hypothesis that the claims file declares, not checked.
    Law,
    /// A relation that is taken for granted, in notes without a claims file.
    Assumed,
    /// Fails at a state, which is given.
    Refuted,
    /// The two sides agree where both are defined, but one is defined where the other is not.
    Domain,
    /// Not decided: too few states, or states that do not distinguish it from a mutant.
    Undecided,
    /// Cannot be parsed, or has inconsistent shapes or units.
    Unreadable,
    /// Numbered, but the claims file says nothing about it.
    Unclaimed,
}

impl Verdict {
    /// Every verdict, from the best to the worst. The worst of several parts counts.
    pub const ALL: [Verdict; 10] = [
        Verdict::Certified,
        Verdict::Verified,
        Verdict::Definition,
        Verdict::Law,
        Verdict::Assumed,
        Verdict::Unclaimed,
        Verdict::Undecided,
        Verdict::Domain,
        Verdict::Unreadable,
        Verdict::Refuted,
    ];

    /// Whether this verdict is a pass, if no other verdict is expected.
    pub fn passes(self) -> bool {
        matches!(self, Verdict::Certified | Verdict::Verified | Verdict::Definition | Verdict::Law | Verdict::Assumed)
    }

    /// Whether the claim was tested and holds.
    pub fn holds(self) -> bool {
        matches!(self, Verdict::Certified | Verdict::Verified)
    }

    /// The severity: the place in [`Verdict::ALL`].
    pub fn severity(self) -> usize {
        Verdict::ALL.iter().position(|verdict| *verdict == self).unwrap_or(0)
    }

    /// The word in claims files and reports.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Certified => "certified",
            Verdict::Verified => "verified",
            Verdict::Definition => "definition",
            Verdict::Law => "law",
            Verdict::Assumed => "assumed",
            Verdict::Refuted => "refuted",
            Verdict::Domain => "domain",
            Verdict::Undecided => "undecided",
            Verdict::Unreadable => "unreadable",
            Verdict::Unclaimed => "unclaimed",
        }
    }

    /// The verdict with this word.
    pub fn named(word: &str) -> Option<Verdict> {
        Verdict::ALL.into_iter().find(|verdict| verdict.word() == word)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}
