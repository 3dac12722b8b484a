//! Edits of unmatched parentheses. A display with one has no layout, so its tokens are searched.

use crate::source::Span;

use super::super::lexer::{Token, TokenKind, tokens};
use super::edit::{Edit, Slip};

/// The most places where a partner is tried, the nearest first.
const PLACES: usize = 48;

/// The most unmatched parentheses that one edit may correct.
const ALONE: usize = 2;

/// The edits that remove an unmatched parenthesis, or add its partner.
pub(super) fn balanced(text: &str) -> Vec<Edit> {
    let tokens = tokens(text);
    let mut edits = Vec::new();
    let alone = unmatched(&tokens);
    for at in alone.iter().copied().filter(|_| alone.len() <= ALONE) {
        let span = tokens[at].span;
        let opens = tokens[at].kind == TokenKind::Other('(');
        let sized =
            at > 0 && matches!(&tokens[at - 1].kind, TokenKind::Command(name) if name == "\\left" || name == "\\right");
        let whole = if sized { tokens[at - 1].span.to(span) } else { span };
        edits.push(Edit { span: whole, replacement: String::new(), slip: Slip::Parenthesis });
        let depth = |token: &Token| match token.kind {
            TokenKind::Open | TokenKind::Other('(') => 1,
            TokenKind::Close | TokenKind::Other(')') => -1,
            _ => 0,
        };
        let mut level = 0;
        let mut places: Vec<Span> = Vec::new();
        // The partner stands within the same braces and parentheses, and on the same side of a relation.
        let others: Box<dyn Iterator<Item = usize>> =
            if opens { Box::new(at + 1..tokens.len()) } else { Box::new((0..whole_start(at, sized)).rev()) };
        for other in others {
            let token = &tokens[other];
            level += if opens { depth(token) } else { -depth(token) };
            let ends = matches!(token.kind, TokenKind::Other('=' | '<' | '>') | TokenKind::Row | TokenKind::Align);
            if level < 0 || level == 0 && ends {
                break;
            }
            let sign = matches!(token.kind, TokenKind::Other('+' | '-') | TokenKind::Sub | TokenKind::Super);
            if level == 0 && !sign {
                places.push(token.span);
            }
        }
        let partner = match (opens, sized) {
            (true, false) => ")",
            (true, true) => "\\right)",
            (false, false) => "(",
            (false, true) => "\\left(",
        };
        for place in places.into_iter().take(PLACES) {
            let place = Span::at(if opens { place.end } else { place.start });
            edits.push(Edit { span: place, replacement: partner.to_owned(), slip: Slip::Parenthesis });
        }
    }
    edits
}

/// The first token of a parenthesis, which may be a `\left` or `\right`.
fn whole_start(at: usize, sized: bool) -> usize {
    at - usize::from(sized)
}

/// The round parentheses that have no partner within their braces.
fn unmatched(tokens: &[Token]) -> Vec<usize> {
    let (mut open, mut alone): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    for (at, token) in tokens.iter().enumerate() {
        match token.kind {
            TokenKind::Open | TokenKind::Other('(') => open.push(at),
            TokenKind::Other(')') => match open.last().map(|last| &tokens[*last].kind) {
                Some(TokenKind::Other(_)) => drop(open.pop()),
                _ => alone.push(at),
            },
            TokenKind::Close => {
                while let Some(last) = open.pop() {
                    if tokens[last].kind == TokenKind::Open {
                        break;
                    }
                    alone.push(last);
                }
            }
            _ => {}
        }
    }
    alone.extend(open.into_iter().filter(|at| tokens[*at].kind != TokenKind::Open));
    alone
}
