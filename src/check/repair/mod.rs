//! The edits that correct a refuted equation.
//!
//! Offers methods of [`Checker`](crate::check::document::checker::Checker) that add repairs to equations: edits of the
//! display itself, of a definition or law that several wrong equations use, and of lost terms and factors. Repairs are ranked
//! in [`suggest`]. Knows `trial` and below.

pub(crate) mod definition_edit;
pub(crate) mod lost_products;
pub(crate) mod lost_terms;
pub(crate) mod lost_vectors;
pub(crate) mod shared_edit;
pub(crate) mod suggest;
pub(crate) mod unconfirmed;
