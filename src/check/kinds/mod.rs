//! The kinds of claim other than an identity, one file for each.
//!
//! A new kind of claim goes here. The file of a kind has a function `check(…, &Context) -> Result<Finding>`, which samples states with
//! [`Context::ensemble`](crate::check::sample::context::Context::ensemble) and tests mutants of the claim. [`shapes`] has
//! the sentences about a function of one variable, [`mechanics`] the claims about a Lagrangian. [`compare`] compares two
//! formulas without a document. An identity between two formulas is judged in [`crate::check::judge::identity`]. Knows `judge` and below; `equations` calls it.
//!
//! Offers the function `check` of each kind.

pub(crate) mod compare;
pub(crate) mod conserved;
pub(crate) mod continuum;
pub(crate) mod definitions;
pub(crate) mod exactly_when;
pub(crate) mod identified;
pub(crate) mod initial_values;
pub(crate) mod limit;
pub(crate) mod mechanics;
pub(crate) mod printed_solution;
pub(crate) mod rate;
pub(crate) mod series;
pub(crate) mod shapes;
pub(crate) mod small;
pub(crate) mod solution;
pub(crate) mod solution_of_laws;
pub(crate) mod solves;
