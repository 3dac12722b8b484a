//! The finding on each equation and each sentence of a document.
//!
//! Offers [`sentences::check`] and methods of [`Checker`](crate::check::document::checker::Checker): `equation` for a whole
//! display, `parts` for another text of it, `uses` for the equations that use a defined name. [`definition_tests`] says
//! whether these equations fail with another definition. Knows `document`, `kinds` and below.

pub(crate) mod advice;
pub(crate) mod approximations;
pub(crate) mod chain;
pub(crate) mod chain_certificates;
pub(crate) mod consequences;
pub(crate) mod definition_tests;
pub(crate) mod equation;
mod foundations;
pub(crate) mod laws;
pub(crate) mod measured;
pub(crate) mod merge;
pub(crate) mod motion;
pub(crate) mod sentences;
pub(crate) mod uses;
pub(crate) mod whole;
pub(crate) mod whole_displays;
