//! Bars in angle brackets, `\langle a|b \rangle`, `\langle a|`, `\langle |x|^2 \rangle`; and a lone bar in a parenthesis,
//! `P(A|B)`.

use super::super::lexer::{Space, Token, TokenKind};

/// The number of bars before the angle bracket that closes, outside of groups.
pub(super) fn bars_before_angle(tokens: &[Token]) -> usize {
    let mut depth = 0_usize;
    let mut bars = 0;
    for token in tokens {
        match &token.kind {
            TokenKind::Open | TokenKind::Other('(' | '[') => depth += 1,
            TokenKind::Close | TokenKind::Other(')' | ']') => match depth.checked_sub(1) {
                Some(less) => depth = less,
                None => break,
            },
            TokenKind::Other('|') if depth == 0 => bars += 1,
            TokenKind::Command(name) if depth == 0 && name == "\\rangle" => break,
            _ => {}
        }
    }
    bars
}

/// The number of tokens of the label of a bra, `\langle a|`; `None` if the bracket closes further on, `\langle a|b\rangle`.
pub(super) fn bra_length(tokens: &[Token]) -> Option<usize> {
    let mut depth = 0_usize;
    let mut bar = None;
    for (at, token) in tokens.iter().enumerate() {
        match &token.kind {
            TokenKind::Open | TokenKind::Other('(' | '[') => depth += 1,
            TokenKind::Close | TokenKind::Other(')' | ']') => match depth.checked_sub(1) {
                Some(less) => depth = less,
                None => return bar,
            },
            _ if depth > 0 => {}
            // The first bar counts: `\langle a||b\rangle` and `\langle a| \, |b\rangle` close further on.
            TokenKind::Other('|') => bar = bar.or(Some(at).filter(|at| *at > 0)),
            TokenKind::Command(name) if name == "\\rangle" => return None,
            TokenKind::Command(name) if name == "\\langle" => return bar,
            TokenKind::Other('+' | '-' | ',' | '.' | ';') if bar.is_some_and(|bar| bar + 1 == at) => return bar,
            TokenKind::Other('=' | '<' | '>') | TokenKind::Row | TokenKind::Align if bar.is_some() => return bar,
            TokenKind::Space(Space::Wide) if bar.is_some() => return bar,
            TokenKind::Command(name)
                if bar.is_some()
                    && ["\\right", "\\end", "\\equiv", "\\approx", "\\leq", "\\geq", "\\rightarrow", "\\}"]
                        .contains(&name.as_str()) =>
            {
                return bar;
            }
            _ => {}
        }
    }
    bar
}

/// Whether the bar before these tokens stands alone in its parenthesis, which closes further on.
pub(super) fn is_lone_bar(tokens: &[Token]) -> bool {
    const FARTHEST: usize = 64;
    let mut depth = 0_usize;
    for token in tokens.iter().take(FARTHEST) {
        match &token.kind {
            TokenKind::Open | TokenKind::Other('(' | '[') => depth += 1,
            TokenKind::Close | TokenKind::Other(')' | ']') => match depth.checked_sub(1) {
                Some(less) => depth = less,
                None => return matches!(token.kind, TokenKind::Other(')') | TokenKind::Close),
            },
            TokenKind::Other('|') if depth == 0 => return false,
            TokenKind::Command(name) if depth == 0 && name == "\\vert" => return false,
            // `(\hat a|0\rangle = 0)`
            TokenKind::Command(name) if depth == 0 && name == "\\rangle" => return false,
            _ => {}
        }
    }
    false
}
