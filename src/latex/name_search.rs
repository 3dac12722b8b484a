//! Names sought in a text: two spellings of one name, and texts that contain a name or have it as a whole side.
//!
//! A text is compared by its tokens, so that it need not be well-formed.

use crate::formula::operators::Function;
use crate::formula::symbols::Name;

use super::lexer::{Space, TokenKind, tokens};
use super::macros::Macros;
use super::names::{is_letter, parse, with_dots};

/// Whether two texts are the same name.
pub fn same(a: &str, b: &str) -> bool {
    a == b || parse(a).is_some_and(|name| Some(name) == parse(b))
}

/// Whether a text contains the letters of a name in their order, without regard to accents and braces.
pub fn mentions(text: &str, name: &str, macros: &Macros) -> bool {
    let letters = |text: &str| -> Vec<TokenKind> {
        let all = printed_kinds(text, macros);
        all.into_iter().filter(is_letter_token).collect()
    };
    let (text, name) = (letters(text), letters(name));
    !name.is_empty() && text.windows(name.len()).any(|part| part == name)
}

/// Whether a name, or a whole power of it, is a whole side of a relation in a text, so that the text may define it.
pub fn is_a_side(text: &str, name: &str, macros: &Macros) -> bool {
    stands_alone(text, name, macros, true)
}

/// Whether a name, or a whole power of it, is the first side of a relation in a text.
pub fn is_the_first_side(text: &str, name: &str, macros: &Macros) -> bool {
    stands_alone(text, name, macros, false)
}

/// Whether a name, or a whole power of it, is a whole side of a relation, or only the first one.
fn stands_alone(text: &str, name: &str, macros: &Macros, may_be_later: bool) -> bool {
    let is_relation = |kind: &TokenKind| match kind {
        TokenKind::Other(c) => *c == '=',
        TokenKind::Command(command) => command == "\\equiv",
        _ => false,
    };
    let is_edge =
        |kind: &TokenKind| matches!(kind, TokenKind::Row | TokenKind::Other(',' | '.' | ';')) || is_wide(kind);
    let is_kept = |kind: &TokenKind| {
        is_letter_token(kind)
            || is_relation(kind)
            || is_edge(kind)
            || matches!(kind, TokenKind::Super | TokenKind::Other(_))
            // The names of a pair, `\omega_\pm`, are not the name without the sign.
            || matches!(kind, TokenKind::Command(sign) if sign == "\\pm" || sign == "\\mp")
            // `\cos\theta_0` is no name.
            || matches!(kind, TokenKind::Command(command) if is_applied(command))
            // A rate, `\dot r = …`, gives the name itself no formula.
            || matches!(kind, TokenKind::Command(dots) if ["dot", "ddot", "dddot"].contains(&dots.trim_start_matches('\\')))
    };
    let kept = |text: &str| -> Vec<TokenKind> { printed_kinds(text, macros).into_iter().filter(is_kept).collect() };
    let (text, name) = (kept(text), kept(name));
    let stands_alone = |at: usize| {
        let (before, after) = (at.checked_sub(1).map(|at| &text[at]), text.get(at + name.len()));
        let ends = |kind: Option<&TokenKind>| kind.is_none_or(|kind| is_relation(kind) || is_edge(kind));
        // Of `\lambda^2 x` the power is a factor.
        let after_power = text[at + name.len()..].iter().skip(1).find(|kind| !matches!(kind, TokenKind::Digit(_)));
        let is_later = before.is_some_and(is_relation);
        ends(before)
            && (may_be_later || !is_later)
            && (ends(after) || after == Some(&TokenKind::Super) && ends(after_power))
    };
    !name.is_empty() && (0..text.len()).any(|at| text[at..].starts_with(&name) && stands_alone(at))
}

fn is_letter_token(kind: &TokenKind) -> bool {
    match kind {
        TokenKind::Letter(_) | TokenKind::Digit(_) | TokenKind::Prime => true,
        TokenKind::Command(command) => is_letter(command),
        _ => false,
    }
}

/// Whether a command is a function, or makes another formula of the one behind it.
fn is_applied(command: &str) -> bool {
    let bare = command.trim_start_matches('\\');
    Function::named(bare).is_some() || ["sqrt", "frac", "dfrac", "tfrac", "det", "partial", "nabla"].contains(&bare)
}

fn is_wide(kind: &TokenKind) -> bool {
    matches!(kind, TokenKind::Space(Space::Wide))
}

/// The tokens of a text with its macros expanded, without the words of `\begin{matrix}` and `\text{for}`.
fn printed_kinds(text: &str, macros: &Macros) -> Vec<TokenKind> {
    let tokens = tokens(text);
    let tokens = macros.expand(tokens.clone()).unwrap_or(tokens);
    let mut words = false;
    let is_word = |kind: &TokenKind| {
        match kind {
            TokenKind::Command(command) => words = ["\\begin", "\\end", "\\text"].contains(&command.as_str()),
            TokenKind::Close => words = false,
            _ => {}
        }
        words
    };
    let kinds = tokens.into_iter().map(|token| token.kind);
    let marked = kinds.scan(is_word, |is_word, kind| Some((is_word(&kind), kind)));
    marked.filter_map(|(is_word, kind)| (!is_word).then_some(kind)).collect()
}

/// The name that a declaration is, with its overdots as a part of it: `\dot{\vec v}` as a separate symbol.
pub fn parse_decorated(text: &str) -> Option<Name> {
    let (name, dots) = parse(text)?;
    with_dots(&name, dots)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_side_is_the_whole_name_or_a_power_of_it() {
        let is_side = |text: &str, name: &str| is_a_side(text, name, &Macros::default());
        for text in ["r_0 = a", "a = r_0", "r_0^2 = a", "r_0^{3} = a", "b = c, \\quad r_0 = a"] {
            assert!(is_side(text, "r_0"), "{text}");
        }
        for text in ["\\cos r_0 = a", "\\sqrt{r_0} = a", "b = r_0^2 x", "b = r_0 x", "r_0 + 1 = a"] {
            assert!(!is_side(text, "r_0"), "{text}");
        }
        assert!(is_side("\\omega^2 = k", "\\omega") && !is_side("\\omega_\\pm^2 = k", "\\omega"));
    }
}
