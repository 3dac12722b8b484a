//! Certificates: claims decided as polynomial identities over a prime field.
//!
//! Offers [`decide`], the decision with its bound on false acceptance; [`claim::Claim`], what can be decided;
//! [`formulas`], whether two formulas are equal whatever their symbols mean. Knows `sample`, `state` and below, and
//! [`crate::scalar::prime_field`]. The bound is computed in `scalar/prime_field/false_accept_bound.rs`.

pub(crate) mod claim;
pub(crate) mod decide;
pub(crate) mod family_growth;
pub(crate) mod formulas;
pub(crate) mod growth;
pub(crate) mod named_members;
pub(crate) mod negligible_terms;
pub(crate) mod plan;
pub(crate) mod signs;
pub(crate) mod solutions;
pub(crate) mod solved;
pub(crate) mod zeros;
