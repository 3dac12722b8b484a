//! Programs: the comments and strings that document Rust, C, C++, Python and Julia.
//!
//! Only what documents is read, not other comments. Markdown is read in all of them, and where a block has a directive
//! `.. math::` or a role `:math:`, reStructuredText. Doxygen's `\f[ … \f]` is read in C and C++.

use std::path::Path;
use std::sync::Arc;

use super::blocks::{self, indent};
use super::{Format, View, alone, restructured};
use crate::Result;
use crate::notes::kind::Kind;
use crate::source::{Builder, Source, Span};

pub(super) const RUST: Format = Format { extensions: &["rs"], kind: Kind::Markdown, is_code: true, view: comments };
pub(super) const C: Format = Format {
    extensions: &["c", "h", "cc", "cpp", "cxx", "hh", "hpp", "hxx"],
    kind: Kind::Markdown,
    is_code: true,
    view: comments,
};
pub(super) const PYTHON: Format =
    Format { extensions: &["py", "pyi"], kind: Kind::Markdown, is_code: true, view: strings };
pub(super) const JULIA: Format = Format { extensions: &["jl"], kind: Kind::Markdown, is_code: true, view: strings };

/// `///`, `//!`, `/** … */` and `/*! … */`.
fn comments(file: &Arc<Source>, _: &Path) -> Result<View> {
    let text = &file.text;
    let mut view = Builder::new(file.clone());
    let mut block: Vec<Span> = Vec::new();
    let mut is_open = false;
    for line in blocks::lines(text, Span::new(0, text.len())) {
        let words = &text[line.range()];
        let own = words.trim_start();
        let mut start = line.end - own.len();
        let mut end = line.end;
        if is_open
            || own.starts_with("/**") && !own.starts_with("/***") && !own.starts_with("/**/")
            || own.starts_with("/*!")
        {
            if !is_open {
                start += 3;
                is_open = true;
            } else if own.starts_with('*') && !own.starts_with("*/") {
                start += 1;
            }
            if let Some(close) = text[start..line.end].find("*/") {
                end = start + close;
                is_open = false;
            }
            block.push(Span::new(start, end));
            if !is_open {
                document(&mut view, text, std::mem::take(&mut block), Builder::copy);
            }
        } else if (own.starts_with("///") && !own.starts_with("////")) || own.starts_with("//!") {
            block.push(Span::new(start + 3, end));
        } else {
            document(&mut view, text, std::mem::take(&mut block), Builder::copy);
        }
    }
    document(&mut view, text, block, Builder::copy);
    alone(view.finish(blocks::in_one_line))
}

/// `"""…"""` and `'''…'''`, raw or not.
fn strings(file: &Arc<Source>, _: &Path) -> Result<View> {
    let text = &file.text;
    let mut view = Builder::new(file.clone());
    let mut at = 0;
    while let Some(open) = next_string(text, at) {
        let quotes = &text[open..open + 3];
        let before = text[..open].trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let prefix = text[before.len()..open].to_ascii_lowercase();
        let is_raw = prefix.contains('r');
        let mut end = open + 3;
        while end < text.len() && !text[end..].starts_with(quotes) {
            let step = if text[end..].starts_with('\\') { 2 } else { 1 };
            end = (end + step).min(text.len());
            while !text.is_char_boundary(end) {
                end += 1;
            }
        }
        let lines = blocks::lines(text, Span::new(open + 3, end));
        document(&mut view, text, lines, if is_raw { Builder::copy } else { unescaped });
        at = (end + 3).min(text.len());
        while !text.is_char_boundary(at) {
            at += 1;
        }
    }
    // In a string that is not raw, a new command would need two backslashes.
    alone(view.finish(|text| (!text.contains(['\n', '\\', '"'])).then(|| text.to_owned())))
}

/// The next three quotes that no comment hides.
fn next_string(text: &str, from: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut at = from;
    while at < bytes.len() {
        let rest = &bytes[at..];
        match rest[0] {
            b'#' => at += rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len()),
            _ if rest.starts_with(b"\"\"\"") || rest.starts_with(b"'''") => return Some(at),
            quote @ (b'"' | b'\'') => {
                // A string of one line; an apostrophe of Julia may end nothing.
                let near = &rest[..rest.len().min(4096)];
                let line = near.iter().position(|b| *b == b'\n').unwrap_or(near.len());
                let mut end = 1;
                while end < line && rest[end] != quote {
                    end += if rest[end] == b'\\' { 2 } else { 1 };
                }
                at += if end < line { end + 1 } else { 1 };
            }
            _ => at += 1,
        }
    }
    None
}

/// The text of a string in which a backslash is written twice.
fn unescaped(view: &mut Builder, line: Span) {
    let text = view.file().text.clone();
    let mut from = line.start;
    let mut at = line.start;
    while let Some(next) = text[at..line.end].find("\\\\") {
        at += next;
        view.copy(Span::new(from, at));
        view.whole(Span::new(at, at + 2), "\\");
        at += 2;
        from = at;
    }
    view.copy(Span::new(from, line.end));
}

/// Writes what a block of documentation says.
fn document(view: &mut Builder, text: &str, lines: Vec<Span>, copy: fn(&mut Builder, Span)) {
    let Some(last) = lines.last().copied() else { return };
    let depth = |line: &&Span| !text[line.range()].trim().is_empty();
    // The first line of a string stands behind its quotes.
    let common = lines.iter().skip(1).filter(depth).map(|line| indent(text, *line)).min();
    let common = common.unwrap_or(0);
    let dedented: Vec<Span> =
        lines.iter().map(|line| Span::new(line.start + common.min(indent(text, *line)), line.end)).collect();
    let is_restructured =
        lines.iter().any(|line| text[line.range()].contains(".. math::") || text[line.range()].contains(":math:`"));
    if is_restructured {
        restructured::write(view, text, &dedented, copy);
    } else {
        for line in dedented {
            doxygen(view, text, line, copy);
            view.written(Span::at(line.end), "\n");
        }
    }
    view.written(Span::at(last.end), "\n");
}

/// A line in which `\f[` and `@f[` are `\[`, and `\f$` is a dollar sign.
fn doxygen(view: &mut Builder, text: &str, line: Span, copy: fn(&mut Builder, Span)) {
    let mut from = line.start;
    let mut at = line.start;
    while at < line.end {
        let rest = &text[at..line.end];
        let Some(after) = rest.strip_prefix("\\f").or_else(|| rest.strip_prefix("@f")) else {
            at += rest.chars().next().map_or(1, char::len_utf8);
            continue;
        };
        let length = after.bytes().take(40).position(|b| b == b'}');
        let environment = length.and_then(|length| after.get(..length)?.strip_prefix('{'));
        let (length, mark) = match after.chars().next() {
            Some('[') => (3, "\\[".to_owned()),
            Some(']') => (3, "\\]".to_owned()),
            Some('$') => (3, "$".to_owned()),
            Some('}') => (3, "$$".to_owned()),
            Some('{') if environment.is_some() => {
                let length = 4 + environment.map_or(0, str::len);
                let brace = usize::from(rest[length..].starts_with('{'));
                (length + brace, "$$".to_owned())
            }
            _ => (0, String::new()),
        };
        if length == 0 {
            at += 2;
            continue;
        }
        copy(view, Span::new(from, at));
        view.written(Span::new(at, at + length), &mark);
        at += length;
        from = at;
    }
    copy(view, Span::new(from, line.end));
}
