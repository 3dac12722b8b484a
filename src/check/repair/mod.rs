//! Repairs: single edits with which a wrong equation passes.
//!
//! Offers methods of [`Checker`](crate::check::document::checker::Checker) that add repairs to equations. The edits change
//!
//! - the display itself ([`suggest`]; for inequalities see [`inequalities`]), or put missing terms and factors into it ([`missing_terms`]);
//! - a definition that it makes or uses ([`definition_edit`]);
//! - a definition or law that several wrong equations use ([`shared_edit`]), or one that no passing equation uses
//!   ([`unconfirmed_premises`]).
//!
//! Where an edit of the Lagrangian corrects several equations, [`blame`] calls the Lagrangian wrong and not these.
//!
//! Repairs are ranked in [`ranking`]. Each repair that is offered has passed the full check. Knows `trial` and below.

pub(crate) mod blame;
pub(crate) mod culprit;
pub(crate) mod definition_edit;
pub(crate) mod inequalities;
pub(crate) mod items;
pub(crate) mod missing_terms;
pub(crate) mod missing_vectors;
pub(crate) mod power_products;
pub(crate) mod ranking;
pub(crate) mod shared_edit;
pub(crate) mod suggest;
pub(crate) mod unconfirmed_premises;
