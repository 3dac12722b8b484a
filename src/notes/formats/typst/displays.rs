//! The displays of a Typst file as LaTeX, with their places: what is mathematics, and what is code, text or a comment.

use super::math;
use std::path::Path;
use std::sync::Arc;

use crate::Result;
use crate::notes::formats::{Format, View, alone, blocks};
use crate::notes::kind::Kind;
use crate::source::{Builder, Fault, Source, Span};
use crate::{Error, notes::tex_scanner};

use super::math::Piece;

pub(in crate::notes::formats) const FORMAT: Format =
    Format { extensions: &["typ"], kind: Kind::Markdown, is_code: false, view };

fn view(file: &Arc<Source>, _: &Path) -> Result<View> {
    let text = &file.text;
    let bytes = text.as_bytes();
    let mut view = Builder::new(file.clone());
    let (mut from, mut at) = (0, 0);
    while at < bytes.len() {
        let hidden = match bytes[at] {
            b'/' if bytes[at..].starts_with(b"//") && (at == 0 || bytes[at - 1] != b':') => {
                Some(tex_scanner::line_end(bytes, at))
            }
            b'/' if bytes[at..].starts_with(b"/*") => {
                Some(tex_scanner::find(text, at + 2, "*/").map_or(text.len(), |end| end + 2))
            }
            b'`' => Some(raw_end(text, at)),
            b'#' if begins_line(text, at) => setting_end(text, at),
            _ => None,
        };
        if let Some(end) = hidden {
            view.prose(Span::new(from, at));
            from = end;
            at = end;
            continue;
        }
        match bytes[at] {
            b'=' if begins_line(text, at) => {
                let line = &text[at..tex_scanner::line_end(bytes, at)];
                let Some((level, length)) = blocks::marked_heading(line, '=') else {
                    at += 1;
                    continue;
                };
                view.prose(Span::new(from, at));
                from = at + length;
                blocks::heading(&mut view, Span::new(at, from), level);
                at = from;
            }
            b'\\' => at += 2,
            b'$' => {
                let Some(close) = closing(text, at + 1) else {
                    let fault = Fault::notes(Span::new(at, at + 1), "this `$` is never closed");
                    return Err(Error::fault(file, fault.help("add `$` after the formula, or write `\\$` in prose")));
                };
                view.prose(Span::new(from, at));
                let inside = Span::new(at + 1, close);
                let space = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_whitespace);
                let is_display = space(at + 1) && space(close - 1) && close > at + 2;
                from = close + 1;
                let mark = if is_display { "\n$$ " } else { "$" };
                view.written(Span::new(at, at + 1), mark);
                if is_display {
                    let rest = text[from..tex_scanner::line_end(bytes, from)].trim_start();
                    let label = rest.strip_prefix('<').and_then(|rest| rest.split_once('>'));
                    if let Some((name, after)) = label {
                        let end = tex_scanner::line_end(bytes, from) - after.len();
                        view.written(Span::new(from, end), &format!("\\label{{{name}}} "));
                        from = end;
                    }
                }
                for piece in math::latex(text, inside) {
                    match piece {
                        Piece::Copy(place) => view.copy(place),
                        Piece::Written(place, latex) => view.whole(place, &latex),
                        Piece::Mark(at, latex) => view.written(Span::at(at), latex),
                    }
                }
                view.written(Span::new(close, close + 1), if is_display { " $$\n\n" } else { "$" });
                at = from;
            }
            _ => at += 1,
        }
    }
    view.prose(Span::new(from.min(text.len()), text.len()));
    alone(view.finish(as_typst))
}

/// Whether only white space stands before this place in its line.
fn begins_line(text: &str, at: usize) -> bool {
    text[..at].rsplit('\n').next().is_none_or(|before| before.trim().is_empty())
}

/// The end of a line of code that sets how the document looks, or names something: such lines are no prose.
fn setting_end(text: &str, from: usize) -> Option<usize> {
    const WORDS: [&str; 4] = ["#set ", "#show", "#import ", "#let "];
    WORDS.iter().find(|word| text[from..].starts_with(**word))?;
    let (mut depth, mut is_string) = (0usize, false);
    for (at, c) in text[from..].char_indices() {
        match c {
            '"' => is_string = !is_string,
            '(' | '[' | '{' if !is_string => depth += 1,
            ')' | ']' | '}' if !is_string => depth = depth.saturating_sub(1),
            '\n' if depth == 0 && !is_string => return Some(from + at),
            _ => {}
        }
    }
    Some(text.len())
}

/// The end of the raw text that the grave accents at `at` open.
fn raw_end(text: &str, at: usize) -> usize {
    let count = text.as_bytes()[at..].iter().take_while(|&&b| b == b'`').count();
    if count == 2 {
        return at + 2;
    }
    let mark = "`".repeat(count);
    tex_scanner::find(text, at + count, &mark).map_or(text.len(), |end| end + count)
}

/// The dollar sign that closes a formula. In a string it closes nothing.
fn closing(text: &str, from: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let (mut at, mut is_string) = (from, false);
    while at < bytes.len() {
        match bytes[at] {
            b'\\' => at += 1,
            b'"' => is_string = !is_string,
            b'$' if !is_string => return Some(at),
            _ => {}
        }
        at += 1;
    }
    None
}

/// What is written alike in LaTeX and in Typst: signs, numbers and single letters.
fn as_typst(text: &str) -> Option<String> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || " +-=<>().,".contains(c);
    let letters =
        text.as_bytes().windows(2).any(|pair| pair[0].is_ascii_alphabetic() && pair[1].is_ascii_alphanumeric());
    (text.chars().all(is_plain) && !letters).then(|| text.to_owned())
}
