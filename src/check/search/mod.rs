//! States sought on purpose, where random ones would miss what is false.
//!
//! Offers the boundary of an inequality, its worst state, the branches of hypotheses, magnitudes far from the declared
//! ranges, families of other sizes. Knows `certificate` and below; says nothing of verdicts beyond the claim at hand.

pub(crate) mod boundary;
pub(crate) mod branches;
pub(crate) mod double_range;
pub(crate) mod family_sizes;
pub(crate) mod magnitudes;
pub(crate) mod worst_state;
