//! The kinds of claim beside an identity, a file each.
//!
//! A new kind of claim goes here. Each file has a `check(…, &Context) -> Result<Finding>`, draws its states by
//! [`Context::ensemble`](crate::check::sample::context::Context::ensemble) and says what its mutants are. Knows `judge` and
//! below; `equations` calls it.

pub(crate) mod compare;
pub(crate) mod conserved;
pub(crate) mod continuum;
pub(crate) mod definitions;
pub(crate) mod exactly_when;
pub(crate) mod function_shape;
pub(crate) mod generates;
pub(crate) mod limit;
pub(crate) mod scan;
pub(crate) mod shape;
pub(crate) mod small;
pub(crate) mod solves;
