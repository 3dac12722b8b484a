//! What is guessed about notes that have no claims file: the names and how they stand in the displays, the declarations, and
//! the scopes of letters.
//!
//! | file | what it has |
//! | --- | --- |
//! | `names` | the names in the displays, and how they stand there |
//! | `differentials` | the d of something, and marks before a name |
//! | `values` | formulas that stand for one name |
//! | `inference` | the claims file that is inferred |
//! | `scopes` | where a letter gets another meaning |
//! | `draft` | the inferred claims as a file |
//!
//! Imports the neighbours `inline` and `scope`, and what is below `unaided`.

mod differentials;
#[cfg(feature = "cli")]
pub(super) mod draft;
#[cfg(feature = "cli")]
pub(super) mod inference;
pub(in crate::check) mod names;
#[cfg(feature = "cli")]
pub(super) mod scopes;
#[cfg(feature = "cli")]
mod values;
