//! LaTeX to formulas and back.
//!
//! [`lexer`] cuts the text of a display into tokens, [`macros`] expands the author's own commands, old forms and ornaments
//! are made plain (`old_forms`), [`layout`] gathers the tokens into what is typeset (groups, fences, fractions, scripts,
//! rows) and cannot fail: what it does not understand becomes a node that carries the fault. [`reader`] gives the layout
//! its one meaning, with the help of the declared symbols, or says at which bytes there is none or more than one.
//! [`statements`] reads a whole display, [`introductions`] finds the names that it introduces, and [`mod@typeset`] writes a
//! formula so that it reads back as itself. [`slips`] are the edits of a text that authors make by mistake, and those that
//! mend them.
//!
//! The rules that settle what authors leave open are in the module documentation of [`reader`].

pub mod introductions;
pub mod layout;
pub mod lexer;
pub mod macros;
pub mod names;
mod old_forms;
pub mod reader;
pub mod slips;
pub mod statements;
pub mod typeset;

pub use introductions::Introduced;
pub use macros::Macros;
pub use reader::read_formula;
pub use statements::{Reading, read_display};
pub use typeset::typeset;
