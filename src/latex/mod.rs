//! LaTeX to formulas and back.
//!
//! | file | what it does |
//! | --- | --- |
//! | [`lexer`] | text to tokens |
//! | [`macros`] | expands the author's own commands |
//! | `normalize` | rewrites legacy TeX (`\over`, `\bf`) and decoration (`\boxed`, colour) |
//! | [`layout`] | tokens to groups, fences, fractions, scripts, rows; cannot fail |
//! | `overdots` | `\dot x` and its kin: the order of a time derivative |
//! | [`names`] | which name a typeset item is |
//! | [`reader`] | layout to a formula; the rules of reading are in its documentation |
//! | [`statements`], [`definitions`] | a whole display; the names that it defines |
//! | [`mod@typeset`] | a formula back to LaTeX that reads as the same formula |
//! | [`slips`] | small edits of a display: mutations, and candidate corrections |
//!
//! This folder may import [`crate::formula`] and [`crate::source`]. It knows nothing of documents, claims or mechanics.

pub mod definitions;
pub mod layout;
pub mod lexer;
pub mod macros;
pub mod names;
mod normalize;
mod overdots;
pub mod reader;
pub mod slips;
pub mod statements;
pub mod typeset;

pub use definitions::DefinedSymbol;
pub use macros::Macros;
pub use reader::read_formula;
pub use statements::{Reading, read_display};
pub use typeset::typeset;
