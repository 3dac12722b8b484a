//! Derivatives and integrals as they are printed, with the names in them.
//!
//! Offers `derivatives::collect` and `integrals::collect`. Knows LaTeX alone.

pub(super) mod derivatives;
pub(super) mod integrals;
