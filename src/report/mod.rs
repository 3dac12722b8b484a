//! Verdicts for people and for machines: a terminal's text, JSON, and the diagnostics of errors.
//!
//! This room only shows; what is shown was decided in [`crate::check`].

pub mod diagnostic;
pub mod json;
pub mod mutants;
pub mod text;
