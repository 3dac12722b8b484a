//! Hypotheses and laws that say outright what a symbol is.
//!
//! Offers [`rule::Rule`], what a hypothesis makes of a symbol, and [`explicit::rules`], which sorts hypotheses into rules and
//! those that must be solved. Knows `model` and nothing above it.

pub(crate) mod components;
pub(crate) mod coupled;
pub(crate) mod explicit;
pub(crate) mod motion;
pub(crate) mod rule;
