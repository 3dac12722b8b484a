//! The layout of a text as an author typed it: with macros and legacy commands.

use crate::code::Code;
use crate::source::{Fault, Span};

use super::super::groups::without_groups;
use super::super::lexer::{Token, TokenKind, tokens};
use super::super::macros::Macros;
use super::super::normalize::normalized;
use super::boxes::{without_boxes, without_delimiters, without_emphasis};
use super::item::Item;
use super::lengths::with_plain_spaces;
use super::marks::with_plain_marks;
use super::parser::layout;
use super::rest::with_rests;
use super::spelled::{with_commands, with_names, with_units};
use super::values::has_derivative;

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
    let tokens = macros.expand(without_emphasis(without_delimiters(tokens(text))))?;
    let tokens = without_groups(with_plain_spaces(with_ellipses(tokens)));
    let items =
        layout(&normalized(with_units(with_names(with_commands(with_plain_marks(without_boxes(tokens)))))), text.len());
    Ok(with_rests(macros.values.named(items)))
}

/// Three points or more side by side are an ellipsis; one beside ∇ is the sign of a product.
fn with_ellipses(tokens: Vec<Token>) -> Vec<Token> {
    let is_point = |at: usize| tokens.get(at).is_some_and(|token| token.kind == TokenKind::Other('.'));
    let is_nabla = |at: usize| matches!(tokens.get(at).map(|token| &token.kind), Some(TokenKind::Command(name)) if name == "\\nabla");
    let is_factor = |at: usize| {
        tokens.get(at).is_some_and(|token| {
            matches!(token.kind, TokenKind::Letter(_) | TokenKind::Open | TokenKind::Other('(' | '['))
                || matches!(&token.kind, TokenKind::Command(name) if name != "\\end" && name != "\\right")
        })
    };
    let mut found: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let points = (at..tokens.len()).take_while(|at| is_point(*at)).count();
        let is_sign = points == 1 && at > 0 && is_factor(at + 1) && (is_nabla(at - 1) || is_nabla(at + 1));
        let length = if points > 2 { points } else { 1 };
        let span = tokens[at].span.to(tokens[at + length - 1].span);
        let command = |name: &str| Token { kind: TokenKind::Command(name.to_owned()), span };
        let is_ellipsis = points > 2
            || tokens[at].kind == TokenKind::Other('…')
            || matches!(&tokens[at].kind, TokenKind::Command(name) if name == "\\dots");
        match is_ellipsis {
            true => {
                // `1, 2, 3...` is a list that goes on, and no product.
                if ends_a_list(&found) && tokens.get(at + length).is_none_or(is_no_factor) {
                    found.push(Token { kind: TokenKind::Other(','), span: Span::at(span.start) });
                }
                found.push(command("\\dots"));
            }
            false if is_sign => found.push(command("\\cdot")),
            false => found.push(tokens[at].clone()),
        }
        at += length;
    }
    found
}

/// Whether tokens end with a whole number after a comma.
fn ends_a_list(tokens: &[Token]) -> bool {
    let is_space = |token: &&Token| matches!(token.kind, TokenKind::Space(_));
    let is_digit = |token: &&Token| matches!(token.kind, TokenKind::Digit('0'..='9'));
    let mut before = tokens.iter().rev().skip_while(is_space).peekable();
    before.peek().is_some_and(is_digit)
        && before
            .skip_while(is_digit)
            .find(|token| !is_space(token))
            .is_some_and(|token| token.kind == TokenKind::Other(','))
}

fn is_no_factor(token: &Token) -> bool {
    matches!(
        token.kind,
        TokenKind::Space(_) | TokenKind::Close | TokenKind::Row | TokenKind::Align | TokenKind::Other(_)
    ) || matches!(&token.kind, TokenKind::Command(name) if name == "\\end" || name == "\\right")
}

/// Whether a derivative stands in a text that can be typeset.
pub(crate) fn prints_derivative(text: &str, macros: &Macros) -> bool {
    typeset_items(text, macros).is_ok_and(|items| has_derivative(&items))
}
