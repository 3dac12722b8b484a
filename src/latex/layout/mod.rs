//! The typeset structure of a formula: groups, fences, fractions, scripts, accents, rows. Nothing has a meaning yet.
//!
//! `item` has the layout tree, `parser` builds it from tokens, and `delimiters` pairs what opens and closes.
//! [`layout`] cannot fail; what it does not understand becomes a [`Layout::Fault`] at its place.
//!
//! This folder may import the lexer, the macros and the normalizer of [`super`].
//!
//! # Why reading has two steps
//!
//! Layout knows how things are typeset and nothing of what they mean: groups, fences, fractions, scripts. It never
//! fails: what it does not understand becomes a node with a fault in it. The reader then gives the items their
//! meaning, with the declared symbols. So an error in one statement leaves the others readable, and every fault has
//! its bytes. Both steps are bounded: groups nest 64 deep, and a formula has at most 2¹⁸ bytes.

mod delimiters;
mod item;
mod parser;

use crate::code::Code;
use crate::source::{Fault, Span};

use super::lexer::tokens;
use super::macros::Macros;
use super::normalize::normalized;

pub use item::{Delimiter, Item, Layout};
pub use parser::layout;

/// The layout of a text, with its macros expanded and legacy commands normalized.
///
/// # Errors
/// A text that is too long, or a macro that lacks an argument or never stops expanding.
pub(super) fn typeset_items(text: &str, macros: &Macros) -> Result<Vec<Item>, Fault> {
    const LONGEST: usize = 1 << 18;
    if text.len() > LONGEST {
        return Err(Fault::new(Span::new(0, LONGEST), format!("this formula has more than {LONGEST} bytes"))
            .code(Code::TooLarge)
            .help("split it into several equations"));
    }
    Ok(parser::layout(&normalized(macros.expand(tokens(text))?), text.len()))
}
