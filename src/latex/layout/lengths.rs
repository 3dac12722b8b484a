//! Spaces with a length: `\hspace{25pt}`, `\hskip 1cm`, `\kern-2pt`.
//!
//! A space as wide as a `\quad` separates statements, a narrower one is thin, and one of negative length sets nothing.

use super::super::lexer::{Space, Token, TokenKind};

/// The same tokens, where each space with a length is a plain space.
pub(super) fn with_plain_spaces(tokens: Vec<Token>) -> Vec<Token> {
    let is_space = |token: &Token| space_command(token).is_some();
    if !tokens.iter().any(is_space) {
        return tokens;
    }
    let mut found = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let token = &tokens[at];
        let read = space_command(token).and_then(|in_braces| match in_braces {
            true => braced(&tokens[at + 1..]),
            false => bare(&tokens[at + 1..]),
        });
        match read {
            Some((space, length)) => {
                let span = token.span.to(tokens[at + length].span);
                found.extend(space.map(|space| Token { kind: TokenKind::Space(space), span }));
                at += 1 + length;
            }
            None => {
                found.push(token.clone());
                at += 1;
            }
        }
    }
    found
}

/// Whether the length of a space stands in braces; `None` for what is no space.
fn space_command(token: &Token) -> Option<bool> {
    let TokenKind::Command(name) = &token.kind else { return None };
    match name.as_str() {
        "\\hspace" | "\\mspace" => Some(true),
        "\\hskip" | "\\kern" | "\\mkern" | "\\mskip" => Some(false),
        _ => None,
    }
}

/// The space of a length in braces, and the number of its tokens. A length that is a command, as `\fill`, is wide.
fn braced(tokens: &[Token]) -> Option<(Option<Space>, usize)> {
    let star = usize::from(matches!(tokens.first()?.kind, TokenKind::Other('*')));
    if tokens.get(star)?.kind != TokenKind::Open {
        return None;
    }
    let close = tokens[star..].iter().position(|token| token.kind == TokenKind::Close)? + star;
    let inside = &tokens[star + 1..close];
    let has_command = inside.iter().any(|token| matches!(token.kind, TokenKind::Command(_)));
    let space = match length(inside) {
        Some((width, _)) => space_of(width),
        None if has_command => Some(Space::Wide),
        None => return None,
    };
    Some((space, close + 1))
}

/// The same of a length without braces; what it may stretch by, `plus 1pt minus 1pt`, belongs to it.
fn bare(tokens: &[Token]) -> Option<(Option<Space>, usize)> {
    let (width, mut end) = length(tokens)?;
    for word in ["plus", "minus"] {
        let letter = |token: &Token| if let TokenKind::Letter(c) = token.kind { c } else { ' ' };
        let spelled: String = tokens[end..].iter().take(word.len()).map(letter).collect();
        if spelled == word
            && let Some((_, more)) = length(&tokens[end + word.len()..])
        {
            end += word.len() + more;
        }
    }
    Some((space_of(width), end))
}

fn space_of(width: f64) -> Option<Space> {
    const WIDE: f64 = 0.9;
    match width {
        width if width < 0.0 => None,
        width if width < WIDE => Some(Space::Thin),
        _ => Some(Space::Wide),
    }
}

/// The length at the beginning of some tokens, in widths of a `\quad`, and the number of its tokens.
fn length(tokens: &[Token]) -> Option<(f64, usize)> {
    let mut at = 0;
    let mut sign = 1.0;
    if let TokenKind::Other(c @ ('-' | '+')) = tokens.first()?.kind {
        sign = if c == '-' { -1.0 } else { 1.0 };
        at += 1;
    }
    let mut digits = String::new();
    while let Some(TokenKind::Digit(c) | TokenKind::Other(c @ '.')) = tokens.get(at).map(|token| &token.kind) {
        digits.push(*c);
        at += 1;
    }
    let letter = |at: usize| match tokens.get(at).map(|token| &token.kind) {
        Some(TokenKind::Letter(c)) => Some(*c),
        _ => None,
    };
    let unit: String = [letter(at)?, letter(at + 1)?].iter().collect();
    let quads = match unit.as_str() {
        "em" => 1.0,
        "ex" => 0.45,
        "mu" => 1.0 / 18.0,
        "pt" => 0.1,
        "px" => 0.075,
        "bp" => 0.1,
        "pc" => 1.2,
        "mm" => 0.285,
        "cm" => 2.85,
        "in" => 7.2,
        _ => return None,
    };
    Some((sign * digits.parse::<f64>().ok()? * quads, at + 2))
}

#[cfg(test)]
mod tests {
    use super::super::super::lexer::tokens;
    use super::*;

    /// A text with its spaces: `|` for a wide one, `.` for a thin one.
    fn shown(text: &str) -> String {
        let one = |token: Token| match token.kind {
            TokenKind::Space(Space::Wide) => "|".to_owned(),
            TokenKind::Space(Space::Thin) => ".".to_owned(),
            TokenKind::Letter(c) | TokenKind::Digit(c) | TokenKind::Other(c) => c.to_string(),
            TokenKind::Command(name) => name,
            _ => "?".to_owned(),
        };
        with_plain_spaces(tokens(text)).into_iter().map(one).collect()
    }

    #[test]
    fn the_length_of_a_space_decides_whether_it_separates() {
        for (text, found) in [
            ("a\\hspace{25pt}b", "a|b"),
            ("a\\hspace*{1cm}b", "a|b"),
            ("a\\hspace{\\fill}b", "a|b"),
            ("a\\hspace{0.5\\textwidth}b", "a|b"),
            ("a\\hskip 1cm P", "a|P"),
            ("a\\hskip 10pt plus 2pt minus 1pt b", "a|b"),
            ("a\\kern 20pt b", "a|b"),
            ("a\\mkern18mu b", "a|b"),
            // must-fail cases: a small space does not separate, and one of negative length is none.
            ("a\\hspace{2pt}b", "a.b"),
            ("a\\hspace{0.1cm}b", "a.b"),
            ("a\\mspace{5mu}b", "a.b"),
            ("a\\kern.1em b", "a.b"),
            ("a\\hspace{-2cm}b", "ab"),
            ("a\\mkern-9mu b", "ab"),
            ("a\\kern b", "a\\kernb"),
        ] {
            assert_eq!(shown(text), found, "{text}");
        }
    }
}
