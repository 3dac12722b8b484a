//! The tokens that open and close each delimiter.

use super::super::lexer::{Token, TokenKind};
use super::item::Delimiter;

/// Whether a token is the `|` that closes a fence opened by a `|`.
pub(super) fn is_plain_bar(token: &Token, delimiter: Delimiter) -> bool {
    let is_bar = match &token.kind {
        TokenKind::Other('|') => true,
        TokenKind::Command(name) => name == "\\vert",
        _ => false,
    };
    delimiter == Delimiter::PlainBar && is_bar
}

/// The delimiter that a token opens after `\left`.
pub(super) fn opening(token: &Token) -> Option<Delimiter> {
    match &token.kind {
        TokenKind::Other('(') => Some(Delimiter::Round),
        TokenKind::Other('[') => Some(Delimiter::Square),
        TokenKind::Other('|') => Some(Delimiter::Bar),
        TokenKind::Other('<') => Some(Delimiter::Angle),
        TokenKind::Command(name) => match name.as_str() {
            "\\{" => Some(Delimiter::Curly),
            "\\lvert" | "\\vert" => Some(Delimiter::Bar),
            "\\|" | "\\lVert" | "\\Vert" => Some(Delimiter::DoubleBar),
            "\\langle" => Some(Delimiter::Angle),
            _ => None,
        },
        _ => None,
    }
}

/// The delimiter that a token closes.
pub(super) fn closing(token: &Token) -> Option<Delimiter> {
    match &token.kind {
        TokenKind::Other(')') => Some(Delimiter::Round),
        TokenKind::Other(']') => Some(Delimiter::Square),
        TokenKind::Other('|') => Some(Delimiter::Bar),
        TokenKind::Command(name) => match name.as_str() {
            "\\}" => Some(Delimiter::Curly),
            "\\rvert" | "\\vert" => Some(Delimiter::Bar),
            "\\|" | "\\rVert" | "\\Vert" => Some(Delimiter::DoubleBar),
            "\\rangle" => Some(Delimiter::Angle),
            _ => None,
        },
        _ => None,
    }
}

/// What opens a pair, for a message.
pub(super) fn glyph(delimiter: Delimiter) -> &'static str {
    match delimiter {
        Delimiter::Round => "(",
        Delimiter::Square => "[",
        Delimiter::Curly => "\\{",
        Delimiter::Bar => "\\lvert",
        Delimiter::PlainBar => "|",
        Delimiter::DoubleBar => "\\|",
        Delimiter::Angle | Delimiter::Bra => "\\langle",
        Delimiter::Ket => "|",
        Delimiter::LeftOpen | Delimiter::RightOpen => "(",
        Delimiter::Evaluation => "\\left.",
    }
}
