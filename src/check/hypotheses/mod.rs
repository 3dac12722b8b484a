//! Hypotheses and laws that give a symbol explicitly, so that they need no numerical solution.
//!
//! Offers [`rule::Rule`], the value that a hypothesis gives a symbol, and [`explicit::rules`], which sorts hypotheses
//! into rules and those that must be solved. Knows `model` and no other folder of `check`.

pub(crate) mod components;
pub(crate) mod coupled;
pub(crate) mod explicit;
pub(crate) mod motion;
pub(crate) mod rule;
