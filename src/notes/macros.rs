//! Macro definitions in the notes: `\newcommand`, `\def` and similar commands.

use super::tex_scanner;
use crate::source::Span;

/// A command that the notes define.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MacroDefinition {
    /// Its name, with the backslash.
    pub name: String,
    /// How many arguments it takes.
    pub arguments: usize,
    /// The default of the first argument, if it is optional.
    pub default: Option<String>,
    /// The body.
    pub body: String,
    /// The whole definition.
    pub span: Span,
}

/// All definitions in `text`, in order.
pub(super) fn all(text: &str) -> Vec<MacroDefinition> {
    let bytes = text.as_bytes();
    let (mut found, mut i) = (Vec::new(), 0);
    while let Some(at) = tex_scanner::find(text, i, "\\") {
        let word = tex_scanner::word_end(bytes, at);
        if word == at + 1 {
            // An escaped character.
            i = at + 2;
            while !text.is_char_boundary(i) && i < text.len() {
                i += 1;
            }
            continue;
        }
        i = word;
        if let Some(definition) = definition(text, at) {
            i = definition.span.end;
            found.push(definition);
        }
    }
    found
}

/// The definition that starts with the backslash at `at`.
pub(super) fn definition(text: &str, at: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let word = tex_scanner::word_end(bytes, at);
    match &text[at + 1..word] {
        "newcommand" | "renewcommand" | "providecommand" => newcommand(text, at, word),
        "def" => def(text, at, word),
        "DeclareMathOperator" => operator(text, at, word),
        _ => None,
    }
}

/// `\name` or `{\name}` at `at`: the name with its backslash, and the position after.
fn name(text: &str, at: usize) -> Option<(String, usize)> {
    let bytes = text.as_bytes();
    let at = tex_scanner::skip_space(bytes, at);
    let braced = bytes.get(at) == Some(&b'{');
    let start = if braced { tex_scanner::skip_space(bytes, at + 1) } else { at };
    if bytes.get(start) != Some(&b'\\') {
        return None;
    }
    let mut end = tex_scanner::word_end(bytes, start);
    if end == start + 1 {
        end += text[end..].chars().next()?.len_utf8();
    }
    let name = text[start..end].to_owned();
    if braced {
        end = tex_scanner::skip_space(bytes, end);
        if bytes.get(end) != Some(&b'}') {
            return None;
        }
        end += 1;
    }
    Some((name, end))
}

fn newcommand(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let star = usize::from(bytes.get(word) == Some(&b'*'));
    let (name, mut end) = name(text, word + star)?;
    let mut arguments = 0;
    let mut default = None;
    end = tex_scanner::skip_space(bytes, end);
    if let Some((count, after)) = bracketed(text, end) {
        arguments = count.trim().parse().ok().filter(|&n: &usize| n <= 9)?;
        end = tex_scanner::skip_space(bytes, after);
        if let Some((value, after)) = bracketed(text, end) {
            default = Some(value.to_owned());
            end = tex_scanner::skip_space(bytes, after);
        }
    }
    let close = tex_scanner::body(bytes, end)?;
    let body = text[end + 1..close - 1].to_owned();
    Some(MacroDefinition { name, arguments, default, body, span: Span::new(at, close) })
}

/// `[…]` at `at`, short: its inside, and the position after.
fn bracketed(text: &str, at: usize) -> Option<(&str, usize)> {
    let rest = text.get(at..)?.strip_prefix('[')?;
    let length = rest.bytes().take(200).position(|b| b == b']')?;
    Some((&rest[..length], at + length + 2))
}

fn def(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let (name, mut end) = name(text, word)?;
    let mut arguments = 0;
    // Only the plain form, `#1#2`: a delimited argument is left alone, and its uses will be refused.
    while bytes.get(end) == Some(&b'#') {
        let digit = bytes.get(end + 1).filter(|b| b.is_ascii_digit())?;
        arguments = usize::from(digit - b'0');
        end += 2;
    }
    end = tex_scanner::skip_space(bytes, end);
    let close = tex_scanner::body(bytes, end)?;
    let body = text[end + 1..close - 1].to_owned();
    Some(MacroDefinition { name, arguments, default: None, body, span: Span::new(at, close) })
}

fn operator(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let star = usize::from(bytes.get(word) == Some(&b'*'));
    let (name, end) = name(text, word + star)?;
    let end = tex_scanner::skip_space(bytes, end);
    let close = tex_scanner::body(bytes, end)?;
    let operator = if star == 1 { "\\operatorname*" } else { "\\operatorname" };
    let body = format!("{operator}{}", &text[end..close]);
    Some(MacroDefinition { name, arguments: 0, default: None, body, span: Span::new(at, close) })
}
