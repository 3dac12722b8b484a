//! Vacuous claims: those that say nothing, or that follow from their hypotheses alone.
//!
//! Offers the tests that turn a pass into `undecided`: a side that is always [`zero`], a [`forced_value`], a
//! [`restatement`], a [`tautology`], [`premises`] that are not needed, [`unclear_names`]. Knows `certificate`, `sample`
//! and below.

pub(crate) mod forced_value;
pub(crate) mod monomials;
pub(crate) mod premises;
pub(crate) mod restatement;
pub(crate) mod tautology;
pub(crate) mod unclear_names;
pub(crate) mod zero;
