//! References: the places where the prose cites an equation by its number.
//!
//! A number in parentheses is a reference if it has the form of the document's equation numbers. A number without a
//! point is one only after a word such as "eq.".

use std::collections::HashSet;

use super::tex_scanner;
use crate::source::{Source, Span};

/// A reference to an equation: `(6.73)`, `eq. (6.73)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// The number, without its parentheses.
    pub number: String,
    /// The number with its parentheses.
    pub span: Span,
    /// The line in which it stands, from 1.
    pub line: usize,
}

/// The most bytes up to the `\)` of inline mathematics.
const INLINE: usize = 1024;

/// The references in `prose`, which is the file with spaces in place of everything that is no prose. `numbers` are the
/// equation numbers of the document.
pub(super) fn all<'a>(prose: &[u8], source: &Source, numbers: impl Iterator<Item = &'a str>) -> Vec<Reference> {
    let styles: HashSet<String> = numbers.filter(|number| tex_scanner::is_number(number)).map(style).collect();
    let mut references = Vec::new();
    if styles.is_empty() {
        return references;
    }
    let mut i = 0;
    while i < prose.len() {
        match prose[i] {
            b'\\' if prose.get(i + 1) == Some(&b'(') => {
                let ahead = &prose[i..prose.len().min(i + INLINE)];
                i += ahead.windows(2).position(|pair| pair == b"\\)").unwrap_or(0) + 2;
            }
            b'(' => {
                let found = tex_scanner::number(&source.text, i).filter(|(number, _)| {
                    styles.contains(&style(number)) && (number.contains('.') || follows_word(&prose[..i]))
                });
                if let Some((number, end)) = found {
                    let (line, _) = source.line_column(i);
                    references.push(Reference { number: number.to_owned(), span: Span::new(i, end), line });
                }
                i = found.map_or(i + 1, |(_, end)| end);
            }
            _ => i += 1,
        }
    }
    references
}

/// How a number is written: `9.9` for 6.73 and 6.78b, `a.9` for A.3. What starts with 0 is a decimal.
fn style(number: &str) -> String {
    let number = number.trim_end_matches(|c: char| c.is_ascii_lowercase() || c == '\'');
    let mut style = String::new();
    for c in number.chars() {
        let kind = match c {
            '0' if !style.ends_with(['9', '0']) => '0',
            c if c.is_ascii_digit() => '9',
            c if c.is_alphabetic() => 'a',
            c => c,
        };
        if !(kind == '9' && style.ends_with('9')) {
            style.push(kind);
        }
    }
    style
}

/// Whether `before` ends with a word for equations.
fn follows_word(before: &[u8]) -> bool {
    let tail = &before[before.len().saturating_sub(24)..];
    let tail = String::from_utf8_lossy(tail).to_ascii_lowercase();
    let tail = tail.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '~' | '.'));
    let word = tail.rsplit(|c: char| !c.is_alphabetic()).next();
    matches!(word, Some("eq" | "eqs" | "eqn" | "eqns" | "equation" | "equations"))
}
