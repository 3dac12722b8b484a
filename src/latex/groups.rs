//! What authors write in groups that set nothing: digits in threes, `10\,472`, a delimiter in braces, `{\bigl (}`, and the d of a
//! derivative, `\frac{{d}^2 x}{{d}t^2}`.

use super::lexer::{Space, Token, TokenKind};

/// The same tokens, where digits in groups of three are one number, and braces around a delimiter are left out.
pub(super) fn without_groups(tokens: Vec<Token>) -> Vec<Token> {
    let mut found: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        if let Some((token, length)) = lone_delimiter(&tokens, at).or_else(|| braced_d(&tokens, at)) {
            found.push(token);
            at += length;
            continue;
        }
        match found.last_mut() {
            // Digits that touch are one number.
            Some(before) if divides_thousands(&tokens, at) => before.span = before.span.to(tokens[at].span),
            _ => found.push(tokens[at].clone()),
        }
        at += 1;
    }
    found
}

fn is_digit(token: Option<&Token>) -> bool {
    token.is_some_and(|token| matches!(token.kind, TokenKind::Digit('0'..='9')))
}

/// Whether a thin space stands between groups of digits, as in `10\,472`, or a comma as in `2,510.8`.
fn divides_thousands(tokens: &[Token], at: usize) -> bool {
    let follow = tokens[at + 1..].iter().take_while(|token| is_digit(Some(token))).count();
    let before = tokens[..at].iter().rev().take_while(|token| is_digit(Some(token))).count();
    if follow != 3 || !(1..=3).contains(&before) {
        return false;
    }
    // Digits directly after a decimal point or a script are no thousands.
    let first = at - before;
    let starts = first.checked_sub(1).is_none_or(|before| {
        !matches!(tokens[before].kind, TokenKind::Sub | TokenKind::Super | TokenKind::Digit(_))
            && !matches!(tokens[before].kind, TokenKind::Space(_) if before > 0 && is_digit(tokens.get(before - 1)))
    });
    match tokens[at].kind {
        TokenKind::Space(Space::Thin) => starts,
        TokenKind::Other(',') => {
            let touches =
                tokens[at - 1].span.end == tokens[at].span.start && tokens[at].span.end == tokens[at + 1].span.start;
            starts && touches && tokens.get(at + 4).is_some_and(|token| token.kind == TokenKind::Digit('.'))
        }
        _ => false,
    }
}

/// The d in braces at the beginning of other braces, with the number of tokens.
fn braced_d(tokens: &[Token], at: usize) -> Option<(Token, usize)> {
    let is_first = at.checked_sub(1).is_some_and(|before| tokens[before].kind == TokenKind::Open);
    match &tokens[at..] {
        [open, letter, close, next, ..]
            if is_first
                && open.kind == TokenKind::Open
                && letter.kind == TokenKind::Letter('d')
                && close.kind == TokenKind::Close
                && next.kind != TokenKind::Close =>
        {
            Some((letter.clone(), 3))
        }
        _ => None,
    }
}

/// The delimiter that is all there is in braces, with the number of tokens.
fn lone_delimiter(tokens: &[Token], at: usize) -> Option<(Token, usize)> {
    let is_free = at
        .checked_sub(1)
        .is_none_or(|before| !matches!(tokens[before].kind, TokenKind::Sub | TokenKind::Super | TokenKind::Command(_)));
    if tokens[at].kind != TokenKind::Open || !is_free {
        return None;
    }
    let spaces =
        |from: usize| tokens[from..].iter().take_while(|token| matches!(token.kind, TokenKind::Space(_))).count();
    let place = at + 1 + spaces(at + 1);
    let delimiter = tokens.get(place).filter(|token| matches!(token.kind, TokenKind::Other('(' | ')' | '[' | ']')))?;
    let end = place + 1 + spaces(place + 1);
    let close = tokens.get(end).filter(|token| token.kind == TokenKind::Close)?;
    let span = tokens[at].span.to(close.span);
    Some((Token { kind: delimiter.kind.clone(), span }, end + 1 - at))
}
