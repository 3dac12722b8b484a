//! One claim between two formulas.
//!
//! Offers [`identity::check`]: tested at sampled states, held against its mutants, certified over a prime field, and explained
//! where it is refuted. Knows everything below `kinds`.

pub(crate) mod at_states;
pub(crate) mod conclusion;
pub(crate) mod difference;
pub(crate) mod identity;
pub(crate) mod mutants;
pub(crate) mod symbolic_base;
pub(crate) mod term_fit;
pub(crate) mod trivial;
