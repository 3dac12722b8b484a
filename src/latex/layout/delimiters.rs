//! The tokens that open and close each delimiter, and the faults where one of a pair, or an argument, is missing.

use crate::source::{Fault, Span};

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

/// The fault of a token that closes what nothing opens.
pub(super) fn unopened(token: &Token) -> Fault {
    let close = match &token.kind {
        TokenKind::Close => "}".to_owned(),
        TokenKind::Other(c) => c.to_string(),
        TokenKind::Command(name) => name.clone(),
        _ => return Fault::new(token.span, "this closes a group that was never opened").help("remove it"),
    };
    let open = match close.as_str() {
        "}" => "{",
        ")" => "(",
        "]" => "[",
        "\\}" => "\\{",
        "\\rvert" => "\\lvert",
        "\\rVert" => "\\lVert",
        "\\rangle" => "\\langle",
        "\\right" => "\\left",
        "\\end" => "\\begin",
        _ => return Fault::new(token.span, format!("this {close} closes nothing")).help("remove it"),
    };
    Fault::new(token.span, format!("this {close} has no matching {open}")).help(format!("remove it, or add {open}"))
}

/// The fault of a parenthesis or bracket that the other one closes.
pub(super) fn misclosed(open: Span, delimiter: Delimiter, token: &Token) -> Option<Fault> {
    let (opened, wanted, closed) = match (delimiter, closing(token)?) {
        (Delimiter::Round, Delimiter::Square) => ("(", ")", "]"),
        (Delimiter::Square, Delimiter::Round) => ("[", "]", ")"),
        _ => return None,
    };
    let message = format!("this {opened} is closed by {closed}");
    Some(Fault::new(open.to(token.span), message).help(format!("write {wanted} in place of {closed}")))
}

/// The fault of something that is opened, and not closed.
pub(super) fn unclosed(span: Span, open: &str) -> Fault {
    let close = match open {
        "{" => "}",
        "(" => ")",
        "[" => "]",
        "|" => "|",
        "\\{" => "\\}",
        "\\lvert" => "\\rvert",
        "\\|" => "\\|",
        "\\langle" => "\\rangle",
        "\\left" => "\\right and a bracket, as in \\right),",
        _ if open.starts_with("\\begin") => &open.replacen("\\begin", "\\end", 1),
        _ => return Fault::new(span, format!("this {open} is never closed")).help("add what closes it"),
    };
    Fault::new(span, format!("this {open} is never closed")).help(format!("add {close} where it ends"))
}

/// The fault of a command, or of a script, without what must follow it.
pub(super) fn without_argument(command: Option<&Token>, span: Span) -> Fault {
    match command.map(|token| &token.kind) {
        Some(TokenKind::Super) => {
            Fault::new(span, "a superscript is missing after this ^").help("write one, as in x^2, or remove the ^")
        }
        Some(TokenKind::Sub) => {
            Fault::new(span, "a subscript is missing after this _").help("write one, as in x_1, or remove the _")
        }
        Some(TokenKind::Command(name)) if name == "\\frac" => {
            Fault::new(span, "\\frac needs a numerator and a denominator").help("write \\frac{a}{b}")
        }
        Some(TokenKind::Command(name)) => {
            Fault::new(span, format!("{name} needs an argument")).help(format!("write {name}{{…}}"))
        }
        _ => Fault::new(span, "an argument is missing here").help("write the argument in braces"),
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
