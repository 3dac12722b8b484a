//! Documents: the notes as the author wrote them, and the claims file beside them.
//!
//! [`Notes`] are the display equations of a document in one of the [`formats`], each with the byte range of the display, of its
//! number and of its labels. [`Claims`] are the contents of the JSON file that declares the symbols and states what the
//! equations claim. An [`Address`] in the claims file names an equation of the notes. LaTeX stays text here; no
//! mathematics is read.
//!
//! This folder may import [`crate::source`], [`crate::code`], [`crate::error`] and [`crate::suggest`]. It does not know
//! LaTeX formulas, mechanics or verdicts.
//!
//! Reading takes time linear in the size of a file, and does not recurse on its nesting.
//!
//! Offers these three, and what finds a display in a text.

pub(crate) mod address;
pub(crate) mod claims;
mod display;
mod displays;
pub(crate) mod document;
mod file;
pub mod formats;
mod inner_numbers;
pub(crate) mod json;
mod kind;
mod macros;
pub(crate) mod markdown;
pub(crate) mod normalize;
pub(crate) mod references;
mod rows;
mod tex;
mod tex_scanner;

pub use address::{Address, Item, Place, Point, Target};
pub use claims::{Claim, Claims, Sentence, Spanned, claims_beside};
pub use display::{Display, Numbered};
pub use document::{Kind, Notes};
pub use macros::{Form, MacroDefinition, definitions};
pub use references::Reference;
