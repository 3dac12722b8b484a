//! Directed search for counterexamples, where random states would miss them.
//!
//! Offers the [`boundary`] of an inequality, its [`worst_state`], the [`branches`] of hypotheses, all [`magnitudes`],
//! the limits of the [`double_range`], and other [`family_sizes`]. Knows `certificate`, `sample` and below. Each
//! function takes the finding on a claim that has passed so far, or adds states to its ensemble.

pub(crate) mod boundary;
pub(crate) mod branches;
pub(crate) mod double_range;
pub(crate) mod family_sizes;
pub(crate) mod magnitudes;
pub(crate) mod worst_state;
