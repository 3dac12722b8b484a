//! The comma that separates decimals in many languages.

use super::super::lexer::{Token, TokenKind};

/// Whether a decimal comma in braces, `3{,}5`, comes next after the digits `whole` that end at `end`. Three digits after it may
/// be a group of thousands, but for those after a 0.
pub(super) fn is_decimal_comma(tokens: &[Token], end: usize, whole: &str) -> bool {
    let [open, comma, close, decimals @ ..] = tokens else { return false };
    let is_comma = comma.kind == TokenKind::Other(',') && close.kind == TokenKind::Close;
    let is_tight = open.span.start == end && close.span.end == end + "{,}".len();
    let is_digit = |token: &&Token| matches!(token.kind, TokenKind::Digit(c) if c != '.');
    let count = decimals.iter().take_while(is_digit).count();
    is_comma && is_tight && count > 0 && (count != 3 || whole == "0")
}
