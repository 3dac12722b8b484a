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
//! | `groups` | digits in threes, delimiters in braces |
//! | `inference`, `arguments` | what a display without declarations shows about its letters; the parentheses after them |
//! | `primed_names` | which primes mark another quantity |
//! | [`reader`] | layout to a formula; the rules of reading are in its documentation |
//! | `rows`, `pieces` | the rows of a display, and its parts that are statements |
//! | `rename` | a text with other names |
//! | `lines` | the lines of a display, as a reader counts them |
//! | [`statements`], [`definitions`] | a whole display; the names that it defines |
//! | [`mod@typeset`] | a formula back to LaTeX that reads as the same formula |
//! | [`slips`] | small edits of a display: mutations, and candidate corrections |
//!
//! This folder may import [`crate::formula`] and [`crate::source`]. It knows nothing of documents, claims or mechanics.
//!
//! Offers [`read_display`], [`read_formula`] and [`typeset`], and what is said of each file above.

#[cfg(feature = "notes")]
mod arguments;
#[cfg(feature = "notes")]
pub mod definitions;
#[cfg(feature = "notes")]
pub mod foreign;
#[cfg(feature = "notes")]
mod groups;
#[cfg(feature = "notes")]
mod inference;
pub mod layout;
pub mod lexer;
#[cfg(feature = "notes")]
pub mod lines;
#[cfg(feature = "notes")]
pub mod macros;
#[cfg(feature = "notes")]
pub mod name_search;
pub mod names;
mod normalize;
mod overdots;
#[cfg(feature = "notes")]
mod pieces;
#[cfg(feature = "notes")]
mod primed_names;
#[cfg(feature = "notes")]
pub mod reader;
#[cfg(feature = "notes")]
pub mod rename;
#[cfg(feature = "notes")]
mod rows;
#[cfg(feature = "notes")]
pub mod slips;
#[cfg(feature = "notes")]
pub mod statements;
pub mod typeset;

#[cfg(feature = "notes")]
pub use definitions::DefinedSymbol;
#[cfg(feature = "notes")]
pub use macros::Macros;
#[cfg(feature = "notes")]
pub use pieces::says_constant;
#[cfg(feature = "notes")]
pub use reader::has_coefficient;
#[cfg(feature = "notes")]
pub use reader::has_imaginary_unit;
#[cfg(feature = "notes")]
pub use reader::{derivative_name, pairs_by_name, read_formula};
#[cfg(feature = "notes")]
pub use statements::{Reading, read_display};
pub use typeset::typeset;
