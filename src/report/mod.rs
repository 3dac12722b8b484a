//! Reports for people and for machines: text that fits a terminal, diagnostics with the lines of a file, and JSON.
//!
//! This folder decides nothing. It prints what [`crate::check`] found: [`text`] a check, [`mutants`] a run of mutation
//! testing, [`marks`] a marked class, [`requests`] a check for the programs of a pull request, [`answer`] a comparison of two
//! formulas, each as JSON too ([`json`]), whose schema is in [`schema`]; [`diagnostic`] one error, and
//! [`explain`] a verdict or a code. A [`Style`] says how wide a line may be. It may know `check`, `formula`, `source`,
//! `error` and `code`; nothing but `cli` and `testing` may know it.
//!
//! Offers a function in each file that gives a text or a JSON value.

pub mod answer;
pub mod code;
mod crop;
pub mod diagnostic;
mod excerpt;
pub mod explain;
mod headline;
pub mod json;
pub mod marks;
pub mod mutants;
pub mod requests;
pub mod schema;
pub mod style;
pub mod suggestion;
pub mod text;
mod wrap;

pub use style::Style;
pub(crate) use wrap::wrap;
