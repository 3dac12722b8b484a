//! Directed search for counterexamples, where random states would miss them.
//!
//! Offers the [`boundary`] of an inequality, its [`worst_state`], the [`branches`] of hypotheses, all [`magnitudes`],
//! both sides of [`branch_points`], the limits of the [`double_range`], and other [`family_sizes`]; the [`interval_bounds`] of
//! formulas over whole ranges, the [`proof`] of an inequality by them, and the [`dips`] of a formula. Knows `certificate`, `sample` and below. Each
//! function takes the finding on a claim that has passed so far, or adds states to its ensemble.

pub(crate) mod boundary;
pub(crate) mod branch_points;
pub(crate) mod branches;
pub(crate) mod dips;
pub(crate) mod double_range;
pub(crate) mod family_sizes;
pub(crate) mod interval_bounds;
pub(crate) mod magnitudes;
pub(crate) mod proof;
pub(crate) mod worst_state;
