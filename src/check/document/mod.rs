//! A document made ready to be checked.
//!
//! Offers [`setup`], which reads the displays in rounds, assigns the claims and infers the units; [`checker::Checker`], what one
//! equation needs of its document. Knows `kinds` only for the types of their parameters.

pub(crate) mod checker;
pub(crate) mod names;
pub(crate) mod reading;
pub(crate) mod reread;
pub(crate) mod setup;
pub(crate) mod unit_conflicts;
pub(crate) mod units;
pub(crate) mod unreadable;
