//! Claims that say nothing, or that follow from their hypotheses alone.
//!
//! Offers the checks that turn a pass into `undecided`: a side that is always zero, a symbol that the hypotheses force to one
//! value, a restatement, a tautology. Knows `certificate` and below.

pub(crate) mod forced_value;
pub(crate) mod monomials;
pub(crate) mod premises;
pub(crate) mod restatement;
pub(crate) mod tautology;
pub(crate) mod unclear_names;
pub(crate) mod zero;
