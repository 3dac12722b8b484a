//! The layout of a text as an author typed it: with macros and legacy commands.

use crate::code::Code;
use crate::source::{Fault, Span};

use super::super::lexer::{Token, TokenKind, tokens};
use super::super::macros::Macros;
use super::super::normalize::normalized;
use super::item::Item;
use super::parser::layout;
use super::rest::with_rests;

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
    let items = layout(&normalized(with_ellipses(macros.expand(tokens(text))?)), text.len());
    Ok(with_rests(macros.values.named(items)))
}

/// Three points side by side are an ellipsis.
fn with_ellipses(tokens: Vec<Token>) -> Vec<Token> {
    let is_point = |at: usize| tokens.get(at).is_some_and(|token| token.kind == TokenKind::Other('.'));
    let mut found = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let points = (at..at + 3).all(is_point);
        let span = if points { tokens[at].span.to(tokens[at + 2].span) } else { tokens[at].span };
        match points || tokens[at].kind == TokenKind::Other('…') {
            true => found.push(Token { kind: TokenKind::Command("\\dots".to_owned()), span }),
            false => found.push(tokens[at].clone()),
        }
        at += if points { 3 } else { 1 };
    }
    found
}
