//! The finding on each equation and each sentence of a document.
//!
//! Offers methods of [`Checker`](crate::check::document::checker::Checker): `equation`, and [`sentences::check`]. Knows
//! `document`, `kinds` and below.

pub(crate) mod chain;
pub(crate) mod chain_gaps;
pub(crate) mod consequences;
pub(crate) mod equation;
pub(crate) mod laws;
pub(crate) mod merge;
pub(crate) mod noticed;
pub(crate) mod sentences;
pub(crate) mod uses;
pub(crate) mod whole;
