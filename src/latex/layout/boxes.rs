//! Formulas and signs in boxes of text: `\mbox{$x$}`, `\colorbox{yellow}{$x$}`, `\text{=}`, `\mathrm{,\ }`.
//!
//! A box of text around one formula, or around signs alone, changes how it looks and not what it says. So do fonts inside a
//! text.

use super::super::lexer::{Token, TokenKind};

/// The same tokens, without the boxes around formulas and signs, and without fonts inside a text.
pub(super) fn without_boxes(tokens: Vec<Token>) -> Vec<Token> {
    if !tokens.iter().any(|token| colours(token).is_some() || is(token, "\\mathrm")) {
        return tokens;
    }
    let mut found = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let token = &tokens[at];
        if let Some((formula, end)) = formula_in(&tokens, at) {
            let brace = |kind: TokenKind| Token { kind, span: token.span };
            found.push(brace(TokenKind::Open));
            found.extend(without_boxes(tokens[formula].to_vec()));
            found.push(brace(TokenKind::Close));
            at = end;
        } else if let Some((inside, end)) = signs_in(&tokens, at) {
            found.extend_from_slice(&tokens[inside]);
            at = end;
        } else if is(token, "\\text")
            && let Some((open, close)) = group(&tokens, at + 1)
        {
            found.push(token.clone());
            found.extend(tokens[open..=close].iter().filter(|token| !is_font(token)).cloned());
            at = close + 1;
        } else {
            found.push(token.clone());
            at += 1;
        }
    }
    found
}

/// The tokens of the formula that is all there is in the box at `at`, and the position after the box.
fn formula_in(tokens: &[Token], at: usize) -> Option<(std::ops::Range<usize>, usize)> {
    let mut next = at + 1;
    for _ in 0..colours(tokens.get(at)?)? {
        next = group(tokens, next)?.1 + 1;
    }
    let (open, close) = group(tokens, next)?;
    let is_space = |at: &usize| matches!(tokens[*at].kind, TokenKind::Space(_));
    let first = (open + 1..close).find(|at| !is_space(at))?;
    let last = (open + 1..close).rev().find(|at| !is_space(at))?;
    let is_dollar = |token: &Token| token.kind == TokenKind::Other('$');
    if is_dollar(&tokens[first]) {
        let is_one = last > first && is_dollar(&tokens[last]) && !tokens[first + 1..last].iter().any(is_dollar);
        return is_one.then_some((first + 1..last, close + 1));
    }
    let (formula, end) = formula_in(tokens, first)?;
    (end == last + 1).then_some((formula, close + 1))
}

/// The tokens of a box that has nothing but signs in it, `\text{=-}` or `\mathrm{,\ }`, and the position after it.
fn signs_in(tokens: &[Token], at: usize) -> Option<(std::ops::Range<usize>, usize)> {
    let signs: &[char] = match () {
        () if is(&tokens[at], "\\text") => &['=', '+', '-', '<', '>'],
        () if is(&tokens[at], "\\mathrm") => &[',', ';'],
        () => return None,
    };
    let (open, close) = group(tokens, at + 1)?;
    let is_sign = |token: &Token| matches!(token.kind, TokenKind::Other(c) if signs.contains(&c));
    let inside = &tokens[open + 1..close];
    let is_blank = |token: &Token| matches!(token.kind, TokenKind::Space(_));
    let are_signs = inside.iter().any(is_sign) && inside.iter().all(|token| is_sign(token) || is_blank(token));
    are_signs.then_some((open + 1..close, close + 1))
}

/// The number of colours that a box has as its first arguments; `None` for what is no box of text.
fn colours(token: &Token) -> Option<usize> {
    let TokenKind::Command(name) = &token.kind else { return None };
    match name.as_str() {
        "\\text" => Some(0),
        "\\colorbox" => Some(1),
        "\\fcolorbox" => Some(2),
        _ => None,
    }
}

fn is_font(token: &Token) -> bool {
    ["\\textbf", "\\textsf", "\\texttt", "\\textsc", "\\emph", "\\bfseries"].iter().any(|name| is(token, name))
}

/// The positions of the braces of the group that opens at `open`.
fn group(tokens: &[Token], open: usize) -> Option<(usize, usize)> {
    if tokens.get(open)?.kind != TokenKind::Open {
        return None;
    }
    let mut depth = 0_usize;
    let close = (open..tokens.len()).find(|at| {
        depth += usize::from(tokens[*at].kind == TokenKind::Open);
        depth -= usize::from(tokens[*at].kind == TokenKind::Close);
        depth == 0
    })?;
    Some((open, close))
}

fn is(token: &Token, command: &str) -> bool {
    matches!(&token.kind, TokenKind::Command(name) if name == command)
}

/// A formula that is an equation in bold type as a whole, without the command: the type emphasizes it, and marks no vectors.
pub(super) fn without_emphasis(mut tokens: Vec<Token>) -> Vec<Token> {
    let is_blank = |token: &Token| matches!(token.kind, TokenKind::Space(_) | TokenKind::Other('.' | ','));
    let Some(start) = tokens.iter().position(|token| !is_blank(token)) else { return tokens };
    let is_bold = ["\\mathbf", "\\boldsymbol"].iter().any(|name| is(&tokens[start], name));
    let Some((open, close)) = group(&tokens, start + 1).filter(|_| is_bold) else { return tokens };
    let is_equation = tokens[open + 1..close].iter().any(|token| token.kind == TokenKind::Other('='));
    if is_equation && tokens[close + 1..].iter().all(is_blank) {
        tokens.remove(close);
        tokens.drain(start..=open);
    }
    tokens
}

/// A formula without the signs that set it as one: `$x$`, `$$x$$`, `\(x\)`, `\[x\]`.
pub(super) fn without_delimiters(mut tokens: Vec<Token>) -> Vec<Token> {
    let is_space = |token: &Token| matches!(token.kind, TokenKind::Space(_));
    let is_dollar = |token: &Token| token.kind == TokenKind::Other('$');
    let is_command = |token: &Token, name: &str| matches!(&token.kind, TokenKind::Command(found) if found == name);
    let start = tokens.iter().position(|token| !is_space(token)).unwrap_or(0);
    let end = tokens.iter().rposition(|token| !is_space(token)).map_or(0, |last| last + 1);
    let inside = &tokens[start..end];
    let dollars = inside.iter().take_while(|token| is_dollar(token)).count();
    let length = match inside {
        [first, .., last] if is_command(first, "\\[") && is_command(last, "\\]") => 1,
        [first, .., last] if is_command(first, "\\(") && is_command(last, "\\)") => 1,
        _ if (1..=2).contains(&dollars)
            && inside.len() > 2 * dollars
            && inside.iter().filter(|token| is_dollar(token)).count() == 2 * dollars
            && inside[inside.len() - dollars..].iter().all(is_dollar) =>
        {
            dollars
        }
        _ => return tokens,
    };
    tokens.truncate(end - length);
    tokens.drain(..start + length);
    tokens
}
