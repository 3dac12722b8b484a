//! Compares what is printed with what is derived: each equation of a document against what is true.
//!
//! [`check_document`] reads every numbered display, builds the [`model`] of its symbols, and gives each claim a
//! [`Verdict`] with its evidence. The folders import one way, each from those above it in this table:
//!
//! | folder | purpose |
//! | --- | --- |
//! | `verdict` | verdicts, findings, repairs, reports: plain data |
//! | `model` | what each symbol means |
//! | `hypotheses` | hypotheses and laws that say outright what a symbol is |
//! | `state` | a sampled state: the value of every symbol and formula in it, and the residual of a claim |
//! | `sample` | states drawn at random and projected onto the hypotheses |
//! | `certificate` | polynomial identity testing over a prime field |
//! | `search` | states sought on purpose: boundaries, branches, extreme magnitudes, other family sizes |
//! | `vacuity` | claims that say nothing, and hypotheses that force a result |
//! | `judge` | one claim between two formulas: numbers, mutants, certificate, and what a refuted claim is off by |
//! | `kinds` | the other kinds of claim, one file for each |
//! | `document` | the preparation of a document: displays read, claims assigned, units inferred |
//! | `equations` | the finding on each equation and each sentence of a document |
//! | `trial` | trials of another text in place of a display |
//! | `repair` | suggestions: single edits with which a wrong equation passes, and their ranking |
//! | `steps` | derivations: false steps that follow from a false step before them |
//! | `mutation` | mutation testing of a document |
//! | `reprint`, `run` | a second print of the same equations; the check of one document |
//! | `prose_claims` | claims that the words around a display make, kept where they hold |
//! | `usage` | how names stand in the displays |
//! | `mark` | hand-ins: each line against a problem and the lines before it |
//! | `unaided` | notes without a claims file, or with guesses in it: claims inferred, findings weighed |
//! | `checked` | the check of one document, whether its claims are guesses or not |
//!
//! Offers [`check_document`], and for the command line each of the other checks: a whole run, a comparison of two formulas, mutation
//! testing, marks of hand-ins. May know everything but `report`, `page`, `plot`, `lecture` and `cli`.

pub(crate) mod certificate;
pub(crate) mod checked;
pub(crate) mod document;
pub(crate) mod equations;
pub(crate) mod hypotheses;
pub(crate) mod judge;
pub(crate) mod kinds;
#[cfg(feature = "cli")]
pub(crate) mod mark;
pub(crate) mod model;
#[cfg(feature = "cli")]
pub(crate) mod mutation;
pub(crate) mod prose_claims;
pub(crate) mod repair;
#[cfg(feature = "cli")]
pub(crate) mod reprint;
pub(crate) mod run;
pub(crate) mod sample;
pub(crate) mod search;
pub(crate) mod state;
pub(crate) mod steps;
pub(crate) mod trial;
pub(crate) mod unaided;
pub(crate) mod usage;
pub(crate) mod vacuity;
pub(crate) mod verdict;

/// The kinds of slip that a repair undoes.
pub use crate::latex::slips::Slip;
#[cfg(feature = "cli")]
pub(crate) use checked::check_claims;
pub use checked::check_document;
#[cfg(feature = "cli")]
pub(crate) use document::setup::{Run, define_macros};
#[cfg(feature = "cli")]
pub(crate) use reprint::check_reprint;
pub use sample::context::Options;
#[cfg(feature = "cli")]
pub(crate) use unaided::{draft, system, system_of, unaided};
pub use verdict::Verdict;
pub use verdict::finding::{Counterexample, Finding, Fit, Formula, Fraction, Inherited, Misfit};
#[cfg(feature = "cli")]
pub(crate) use verdict::progress::Progress;
pub use verdict::repair::{Repair, Shared};
pub use verdict::report::{Document, Equation, Part, Report};
