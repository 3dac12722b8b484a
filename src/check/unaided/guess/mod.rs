//! What is guessed about notes that have no claims file: the declarations, and
//! the scopes of letters.
//!
//! | file | what it has |
//! | --- | --- |
//! | `values` | formulas that stand for one name |
//! | `lagrangian` | which name is the Lagrangian |
//! | `letters` | what h, i and hats mean |
//! | `inference` | the claims file that is inferred |
//! | `declarations` | what it declares |
//! | `arguments` | the Lagrangian with its arguments |
//! | `order` | displays that use what later ones define |
//! | `headings` | where sections and examples begin |
//! | `named` | the names in one display |
//! | `systems` | where another system begins |
//! | `scopes` | where a letter gets another meaning |
//! | `corrections` | what the author changed in the inferred file |
//! | `draft` | the inferred claims as a file |
//!
//! Imports the neighbours `inline` and `scope`, and what is below `unaided`.
//!
//! Offers `inference`, the claims that are guessed, `draft`, the same as a file, and `scopes`. Knows `usage`, `document` and below.

pub(super) mod arguments;
pub(super) mod corrections;
pub(super) mod declarations;
#[cfg(feature = "cli")]
pub(super) mod draft;
mod headings;
pub(super) mod inference;
mod lagrangian;
mod letters;
mod named;
mod order;
pub(super) mod scopes;
mod systems;
mod values;
