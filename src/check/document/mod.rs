//! The preparation of a document for its check.
//!
//! Offers [`setup::with_checker`], which reads the displays, assigns the claims to them and infers the units, and
//! [`checker::Checker`], all that the check of one equation needs. Knows `kinds` and below.

pub(crate) mod checker;
pub(crate) mod coordinate_chains;
pub(crate) mod definition;
pub(crate) mod inferred;
pub(crate) mod motion_by_laws;
pub(crate) mod names;
pub(crate) mod normal_frequencies;
pub(crate) mod part_claims;
pub(crate) mod printed_lagrangian;
pub(crate) mod reading;
pub(crate) mod reread;
pub(crate) mod setup;
pub(crate) mod unit_conflicts;
pub(crate) mod units;
pub(crate) mod unreadable;
