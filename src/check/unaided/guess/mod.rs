//! What is guessed about notes that have no claims file: the declarations, and
//! the scopes of letters.
//!
//! | file | what it has |
//! | --- | --- |
//! | `values` | formulas that stand for one name |
//! | `letters` | what h, i and hats mean |
//! | `inference` | the claims file that is inferred |
//! | `scopes` | where a letter gets another meaning |
//! | `draft` | the inferred claims as a file |
//!
//! Imports the neighbours `inline` and `scope`, and what is below `unaided`.
//!
//! Offers `inference`, the claims that are guessed, `draft`, the same as a file, and `scopes`. Knows `usage`, `document` and below.

#[cfg(feature = "cli")]
pub(super) mod draft;
#[cfg(feature = "cli")]
pub(super) mod inference;
#[cfg(feature = "cli")]
mod letters;
#[cfg(feature = "cli")]
pub(super) mod scopes;
#[cfg(feature = "cli")]
mod values;
