//! A derivation on disk: the notes as the author typeset them, and the claims beside them.
//!
//! [`Notes`] finds the display equations of a Markdown or TeX file and keeps the byte range of everything: of the
//! display, of its number, of its labels. It reads no mathematics. [`Claims`] is the JSON file that says what the
//! symbols are and what the equations claim; its LaTeX stays text here, each piece with its place. An [`Address`]
//! ties the two together.
//!
//! Everything here is linear in the size of the file and never recurses on what the file nests.

pub(crate) mod address;
pub(crate) mod claims;
mod displays;
pub(crate) mod document;
pub(crate) mod json;
mod macros;
mod markdown;
pub(crate) mod references;
mod rows;
mod scan;
pub(crate) mod spelling;
mod tex;

pub use address::{Address, Item, Place, Point, Target};
pub use claims::{Claim, Claims, Sentence, Spanned, claims_beside};
pub use document::{Display, Kind, MacroDefinition, Notes, Numbered};
pub use references::Reference;
