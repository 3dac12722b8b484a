//! The judgement on one claim between two formulas.
//!
//! Offers [`identity::check`], which tests a claim at sampled states, compares it with its mutants, certifies it over a
//! prime field, and explains it if it is refuted; [`mutants`]; [`difference`], what a refuted claim is off by; and
//! [`term_fit`], which terms of it are wrong. Knows `vacuity`, `search`, `certificate`, `sample` and below.

pub(crate) mod at_states;
pub(crate) mod conclusion;
pub(crate) mod difference;
pub(crate) mod identity;
pub(crate) mod mutants;
pub(crate) mod other_branches;
pub(crate) mod symbolic_base;
pub(crate) mod term_fit;
pub(crate) mod trivial;
