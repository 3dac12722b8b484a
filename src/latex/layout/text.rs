//! The layout of a text as an author typed it: with macros and legacy commands.

use crate::code::Code;
use crate::source::{Fault, Span};

use super::super::lexer::tokens;
use super::super::macros::Macros;
use super::super::normalize::normalized;
use super::item::Item;
use super::parser::layout;

/// The layout of a text, with its macros expanded and legacy commands normalized.
///
/// # Errors
/// A text that is too long, or a macro that lacks an argument or never stops expanding.
pub(crate) fn typeset_items(text: &str, macros: &Macros) -> Result<Vec<Item>, Fault> {
    const LONGEST: usize = 1 << 18;
    if text.len() > LONGEST {
        return Err(Fault::new(Span::new(0, LONGEST), format!("this formula has more than {LONGEST} bytes"))
            .code(Code::TooLarge)
            .help("split it into several equations"));
    }
    Ok(layout(&normalized(macros.expand(tokens(text))?), text.len()))
}
