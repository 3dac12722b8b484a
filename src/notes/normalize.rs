//! The normal form of LaTeX text: without spaces, sizing commands, and braces around one token.
//!
//! `p_{\psi}` is `p_\psi`, and `\left( x \right)` is `(x)`. The normal form is used to find an equation by a snippet,
//! and a symbol that is declared twice. No mathematics is read.

/// Commands that change only the look of a formula.
const LOOKS: &[&str] = &[
    "\\left",
    "\\right",
    "\\middle",
    "\\big",
    "\\Big",
    "\\bigg",
    "\\Bigg",
    "\\bigl",
    "\\Bigl",
    "\\biggl",
    "\\Biggl",
    "\\bigr",
    "\\Bigr",
    "\\biggr",
    "\\Biggr",
    "\\bigm",
    "\\,",
    "\\;",
    "\\:",
    "\\!",
    "\\>",
    "\\ ",
    "\\quad",
    "\\qquad",
    "\\displaystyle",
    "\\textstyle",
    "\\limits",
    "\\nolimits",
    "~",
];

/// The normal form of `latex`: its significant tokens, each followed by a separator.
///
/// If a formula contains a snippet, its normal form contains the normal form of the snippet.
pub fn normalized(latex: &str) -> String {
    let mut tokens: Vec<&str> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut at = 0;
    while let Some(token) = next(&latex[at..]) {
        at += token.len();
        if token.trim().is_empty() || LOOKS.contains(&token) {
            continue;
        }
        if token == "}"
            && let Some(start) = open.pop()
            && tokens.len() == start + 2
            && let Some(only) = tokens.pop()
        {
            tokens[start] = only;
            continue;
        }
        if token == "{" {
            open.push(tokens.len());
        }
        tokens.push(token);
    }
    let mut plain = String::with_capacity(latex.len() * 2);
    for token in tokens {
        plain.push_str(token);
        plain.push('\u{1f}');
    }
    plain
}

/// The first token: a command, or a character.
fn next(rest: &str) -> Option<&str> {
    let first = rest.chars().next()?;
    let mut length = first.len_utf8();
    if first == '\\' {
        let letters = rest[1..].bytes().take_while(u8::is_ascii_alphabetic).count();
        length += if letters > 0 { letters } else { rest[1..].chars().next().map_or(0, char::len_utf8) };
    }
    rest.get(..length)
}

#[cfg(test)]
mod tests {
    use super::normalized;

    #[test]
    fn spellings_of_one_formula_agree_and_other_formulas_do_not() {
        assert_eq!(normalized(r"p_{\psi}"), normalized(r"p_ \psi"));
        assert!(normalized(r"a = \dot{z}\,(2c)").contains(&normalized(r"\dot z \left(2 c\right)")));
        assert!(!normalized(r"\dot\theta_1").contains(&normalized(r"\dot\theta_2")));
    }
}
