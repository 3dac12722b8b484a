//! How a macro takes its arguments from the text after it.

use super::super::lexer::{Space, Token, TokenKind, tokens};

/// One argument of a macro, or a mark that stands where an argument could.
#[derive(Clone, Debug)]
pub(super) enum Parameter {
    /// One token, or one group without its braces.
    Mandatory,
    /// `[…]`, or its default.
    Optional(Vec<Token>),
    /// All up to these tokens, which are taken too. Without tokens it is as [`Parameter::Mandatory`].
    Until(Vec<Token>),
    /// These tokens must be next; they are no argument.
    Literal(Vec<Token>),
    /// `*`, which changes nothing.
    Star,
    /// `[…]` without effect.
    Ignored,
}

impl Parameter {
    /// Whether its value is one of `#1`, `#2`, ….
    pub(super) fn has_number(&self) -> bool {
        matches!(self, Parameter::Mandatory | Parameter::Optional(_) | Parameter::Until(_))
    }

    /// Takes its value from the end of the reversed input: one value, or none for a mark. `None` if it is missing.
    pub(super) fn take(&self, pending: &mut Vec<Token>) -> Option<Vec<Vec<Token>>> {
        match self {
            Parameter::Mandatory => argument(pending).map(|value| vec![value]),
            Parameter::Optional(default) => Some(vec![bracketed(pending).unwrap_or_else(|| default.clone())]),
            Parameter::Until(end) => until(pending, end).map(|value| vec![value]),
            Parameter::Literal(wanted) => {
                wanted.iter().all(|wanted| pending.pop().is_some_and(|token| token.kind == wanted.kind)).then(Vec::new)
            }
            Parameter::Star => {
                star(pending);
                Some(Vec::new())
            }
            Parameter::Ignored => {
                bracketed(pending);
                Some(Vec::new())
            }
        }
    }
}

/// The parameters of a parameter text such as `#1#2` or `(#1,#2)`.
pub(super) fn of_pattern(pattern: &str) -> Vec<Parameter> {
    let (mut found, mut literal) = (Vec::new(), Vec::new());
    let mut open = false;
    let flush = |literal: &mut Vec<Token>, open: &mut bool, found: &mut Vec<Parameter>| {
        let text = std::mem::take(literal);
        match (*open, text.is_empty()) {
            (true, true) => found.push(Parameter::Mandatory),
            (true, false) => found.push(Parameter::Until(text)),
            (false, true) => {}
            (false, false) => found.push(Parameter::Literal(text)),
        }
        *open = false;
    };
    for token in tokens(pattern) {
        match token.kind {
            TokenKind::Parameter(_) => {
                flush(&mut literal, &mut open, &mut found);
                open = true;
            }
            _ => literal.push(token),
        }
    }
    flush(&mut literal, &mut open, &mut found);
    found
}

/// The parameters of the argument types of `\NewDocumentCommand`; `None` for a type that is not supported.
pub(super) fn of_types(types: &str) -> Option<Vec<Parameter>> {
    let mut pending: Vec<Token> = tokens(types).into_iter().rev().collect();
    let mut found = Vec::new();
    while let Some(token) = pending.pop() {
        match token.kind {
            TokenKind::Letter('m') => found.push(Parameter::Mandatory),
            TokenKind::Letter('o') => found.push(Parameter::Optional(Vec::new())),
            TokenKind::Letter('O') => found.push(Parameter::Optional(argument(&mut pending)?)),
            TokenKind::Other('+' | '!') => {}
            _ => return None,
        }
    }
    Some(found)
}

/// Takes one token, or one group without its braces, from the end of the reversed input.
pub(super) fn argument(pending: &mut Vec<Token>) -> Option<Vec<Token>> {
    skip_spaces(pending);
    let first = pending.pop()?;
    match first.kind {
        TokenKind::Open => balanced(pending, &TokenKind::Open, &TokenKind::Close),
        TokenKind::Close => None,
        _ => Some(vec![first]),
    }
}

/// Takes `{…}` if it is next, without its braces.
pub(super) fn group(pending: &mut Vec<Token>) -> Option<Vec<Token>> {
    is_next(pending, &TokenKind::Open).then(|| argument(pending)).flatten()
}

/// Takes `[…]` if it is next, without its brackets.
pub(super) fn bracketed(pending: &mut Vec<Token>) -> Option<Vec<Token>> {
    let (open, close) = (TokenKind::Other('['), TokenKind::Other(']'));
    enclosed(pending, &open, &close)
}

/// Takes what is between these two tokens if the first is next, without the two.
pub(super) fn enclosed(pending: &mut Vec<Token>, open: &TokenKind, close: &TokenKind) -> Option<Vec<Token>> {
    if !is_next(pending, open) {
        return None;
    }
    // An argument that is longer than this is taken for one that never ends.
    const LONGEST: usize = 10_000;
    let ahead = pending.len().saturating_sub(LONGEST);
    let mut near = pending[ahead..pending.len() - 1].to_vec();
    let found = balanced(&mut near, open, close)?;
    pending.truncate(ahead + near.len());
    Some(found)
}

/// Takes a `*` if it is next.
pub(super) fn star(pending: &mut Vec<Token>) -> bool {
    let found = is_next(pending, &TokenKind::Other('*'));
    if found {
        pending.pop();
    }
    found
}

/// Whether this token is next.
pub(super) fn is_next(pending: &[Token], kind: &TokenKind) -> bool {
    pending.last().is_some_and(|token| token.kind == *kind)
}

fn skip_spaces(pending: &mut Vec<Token>) {
    while pending.last().is_some_and(|token| token.kind == TokenKind::Space(Space::Thin)) {
        pending.pop();
    }
}

/// Takes all up to the token that closes the one that was taken before.
fn balanced(pending: &mut Vec<Token>, open: &TokenKind, close: &TokenKind) -> Option<Vec<Token>> {
    let (mut depth, mut braces) = (1, 0);
    let mut taken = Vec::new();
    loop {
        let token = pending.pop()?;
        // A brace hides what is in it from other delimiters.
        if braces == 0 {
            depth += i32::from(token.kind == *open && open != close);
            depth -= i32::from(token.kind == *close);
        }
        if *open != TokenKind::Open {
            braces += i32::from(token.kind == TokenKind::Open) - i32::from(token.kind == TokenKind::Close);
        }
        if depth == 0 {
            return Some(taken);
        }
        taken.push(token);
    }
}

/// Takes all up to `end`, which is taken too; a brace hides what is in it.
fn until(pending: &mut Vec<Token>, end: &[Token]) -> Option<Vec<Token>> {
    let (mut taken, mut depth) = (Vec::new(), 0);
    loop {
        let is_end = depth == 0
            && pending.len() >= end.len()
            && end.iter().zip(pending.iter().rev()).all(|(wanted, token)| wanted.kind == token.kind);
        if is_end {
            pending.truncate(pending.len() - end.len());
            return Some(taken);
        }
        let token = pending.pop()?;
        depth += i32::from(token.kind == TokenKind::Open) - i32::from(token.kind == TokenKind::Close);
        taken.push(token);
    }
}
