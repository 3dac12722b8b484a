//! Functions and types that the Markdown scan and the TeX scan share: walking over TeX byte by byte.
//!
//! The look-ahead of each function is bounded, so that no input takes quadratic time.

use crate::source::{Fault, Span};

/// The most bytes of a short argument (`\tag{…}`, `\label{…}`).
const SHORT: usize = 1024;
/// The most bytes of a macro's body.
const BODY: usize = 8192;

/// The displays, names, comments and inline formulas of a file.
#[derive(Default)]
pub(super) struct ScannedText {
    /// The displays, in order.
    pub raws: Vec<RawDisplay>,
    /// The names given by `onshell:` comments, in order.
    pub names: Vec<Name>,
    /// Code, comments and other text that is no LaTeX.
    pub blank: Vec<Span>,
    /// Inline mathematics, with its dollar signs.
    pub inline: Vec<Span>,
    /// Block-quote markers.
    pub markers: Vec<Span>,
}

impl ScannedText {
    /// Records the inline mathematics that the `$` at `at` opens, if it opens any. Returns the position after it.
    pub fn inline(&mut self, bytes: &[u8], at: usize, strict: bool) -> usize {
        let end = inline(bytes, at, strict).map_or(at, |close| close) + 1;
        self.inline.push(Span::new(at, end));
        end
    }

    /// Records the options in the first lines of a fence, as `:label: energy`. Returns the rest of its body.
    pub fn options(&mut self, text: &str, body: Span) -> Span {
        let mut start = body.start;
        for line in text[body.range()].split_inclusive('\n') {
            let own = line.trim();
            let option = own.strip_prefix(':').and_then(|rest| rest.split_once(':'));
            let Some((name, value)) = option.filter(|(name, _)| !name.contains(char::is_whitespace)) else {
                if own.is_empty() {
                    start += line.len();
                    continue;
                }
                break;
            };
            if matches!(name, "label" | "name") {
                let span = Span::new(start, start + line.trim_end().len());
                self.names.push(Name { id: value.trim().to_owned(), span });
            }
            start += line.len();
        }
        Span::new(start.min(body.end), body.end)
    }

    /// Records the TeX comment at `at`. Returns the end of its line.
    pub fn comment(&mut self, text: &str, at: usize) -> Result<usize, Fault> {
        let end = line_end(text.as_bytes(), at);
        self.names.extend(name_in(text, Span::new(at + 1, end))?);
        self.blank.push(Span::new(at, end));
        Ok(end)
    }
}

/// A display before it is numbered and joined with its neighbours.
#[derive(Clone, Copy)]
pub(super) struct RawDisplay {
    pub span: Span,
    pub body: Span,
    pub delimiter: Delimiter,
    /// Whether LaTeX numbers it by itself.
    pub is_numbered: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Delimiter {
    /// `$$` or `\[`: two bytes on each side.
    Pair,
    /// An environment of one equation, or a math fence.
    Whole,
    /// An environment of rows, each of which may be numbered.
    Rows,
}

/// An `onshell: veff` comment.
pub(super) struct Name {
    pub id: String,
    pub span: Span,
}

/// The display environments.
pub(super) fn environment(name: &str) -> Option<Delimiter> {
    match name.strip_suffix('*').unwrap_or(name) {
        "equation" | "displaymath" | "multline" | "dmath" => Some(Delimiter::Whole),
        "align" | "gather" | "flalign" | "alignat" | "xalignat" | "eqnarray" | "IEEEeqnarray" => Some(Delimiter::Rows),
        _ => None,
    }
}

/// Whether LaTeX numbers the displays of an environment.
pub(super) fn is_numbered(name: &str) -> bool {
    !name.ends_with('*') && name != "displaymath"
}

/// Display environments that are reported, but not read.
pub(super) fn is_foreign(name: &str) -> bool {
    matches!(name.strip_suffix('*').unwrap_or(name), "numcases" | "subnumcases" | "dseries" | "darray" | "xxalignat")
}

/// The position of the next `needle` at or after `from`.
pub(super) fn find(text: &str, from: usize, needle: &str) -> Option<usize> {
    text.get(from..)?.find(needle).map(|i| from + i)
}

/// The position of the next `needle` that no odd run of backslashes escapes; `needle` may itself start with one.
pub(super) fn find_unescaped(text: &str, from: usize, needle: &[u8]) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut i = from;
    while i < bytes.len() {
        if bytes[i..].starts_with(needle) {
            return Some(i);
        }
        i += if bytes[i] == b'\\' { 2 } else { 1 };
    }
    None
}

/// The end of the line that holds `at`: the position of its newline, or of the end of the text.
pub(super) fn line_end(bytes: &[u8], at: usize) -> usize {
    bytes[at..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |i| at + i)
}

/// Whether only white space follows in the line of `at`.
pub(super) fn ends_line(bytes: &[u8], at: usize) -> bool {
    bytes[at..].iter().take_while(|&&b| b != b'\n').all(u8::is_ascii_whitespace)
}

/// The first byte at or after `at` that is no white space.
pub(super) fn skip_space(bytes: &[u8], mut at: usize) -> usize {
    while bytes.get(at).is_some_and(u8::is_ascii_whitespace) {
        at += 1;
    }
    at
}

/// The `{…}` that starts at `at`, as the position after its closing brace.
fn group(bytes: &[u8], at: usize) -> Option<usize> {
    if bytes.get(at) != Some(&b'{') {
        return None;
    }
    let (mut i, mut depth) = (at, 0usize);
    while i < bytes.len() {
        match bytes[i] {
            b'\\' => i += 1,
            b'{' => depth += 1,
            b'}' => {
                depth -= 1;
                if depth == 0 {
                    return Some(i + 1);
                }
            }
            _ => {}
        }
        i += 1;
    }
    None
}

/// As [`group`], for short arguments.
pub(super) fn short_group(bytes: &[u8], at: usize) -> Option<usize> {
    group(&bytes[..bytes.len().min(at.saturating_add(SHORT))], at)
}

/// As [`group`], for the bodies of macros.
pub(super) fn body(bytes: &[u8], at: usize) -> Option<usize> {
    group(&bytes[..bytes.len().min(at.saturating_add(BODY))], at)
}

/// The command word at `at` (which holds a backslash): the position after its letters.
pub(super) fn word_end(bytes: &[u8], at: usize) -> usize {
    let letters = bytes[at + 1..].iter().take_while(|b| b.is_ascii_alphabetic()).count();
    at + 1 + letters
}

/// `\begin{name}` at `at`: the name, and the position after it.
pub(super) fn begin(text: &str, at: usize) -> Option<(&str, usize)> {
    let rest = text.get(at..)?.strip_prefix("\\begin{")?;
    let length = rest.bytes().take(40).position(|b| b == b'}')?;
    Some((rest.get(..length)?, at + "\\begin{".len() + length + 1))
}

/// The closing `$` of inline mathematics that opens at `at`, when it closes before the paragraph ends.
///
/// `strict` requires, as Markdown does, that no space follows the first sign or precedes the second; a price is no
/// formula. What has spaces at both ends, `$ k = GMm $`, is one if it is on one line and has a sign of mathematics.
pub(super) fn inline(bytes: &[u8], at: usize, strict: bool) -> Option<usize> {
    if strict && bytes.get(at + 1) == Some(&b' ') {
        let line = bytes[at + 1..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |end| at + 1 + end);
        let close = at + 1 + bytes[at + 1..line].iter().position(|byte| *byte == b'$')?;
        let inside = &bytes[at + 1..close];
        let is_formula = inside.ends_with(b" ") && inside.iter().any(|byte| b"=\\^_".contains(byte));
        return is_formula.then_some(close);
    }
    if strict && bytes.get(at + 1).is_none_or(u8::is_ascii_whitespace) {
        return None;
    }
    let mut i = at + 1;
    while i < bytes.len() {
        match bytes[i] {
            b'\\' => i += 1,
            b'$' => return (!strict || !bytes[i - 1].is_ascii_whitespace()).then_some(i),
            b'\n' if ends_line(bytes, i + 1) => return None,
            _ => {}
        }
        i += 1;
    }
    None
}

/// A printed number in parentheses at `at`, such as `(6.73)`, `(A.3)` or `(12a)`: its text and the position after.
pub(super) fn number(text: &str, at: usize) -> Option<(&str, usize)> {
    let rest = text.get(at..)?.strip_prefix('(')?;
    let length = rest.bytes().take(20).position(|b| b == b')')?;
    let id = rest.get(..length)?.trim();
    is_number(id).then_some((id, at + length + 2))
}

/// Whether `id` looks like the printed number of an equation.
pub(super) fn is_number(id: &str) -> bool {
    id.bytes().any(|b| b.is_ascii_digit())
        && id.starts_with(|c: char| c.is_ascii_alphanumeric())
        && id.chars().filter(char::is_ascii_alphabetic).count() <= 2
        && id.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'-' | b'\''))
}

/// Records the environment whose `\begin{name}` is at `at` and ends at `inside`. Returns the position after it.
pub(super) fn environment_display(
    text: &str,
    at: usize,
    inside: usize,
    name: &str,
    delimiter: Delimiter,
    found: &mut ScannedText,
) -> Result<usize, Fault> {
    let bytes = text.as_bytes();
    let mut start = inside;
    if name.contains("alignat") || name.starts_with("IEEE") {
        start = short_group(bytes, start).unwrap_or(start);
    }
    let closing = format!("\\end{{{name}}}");
    if is_foreign(name) {
        // With its \begin, so that it is not taken for what its rows alone would say.
        start = at;
    }
    let mut i = start;
    while i < bytes.len() {
        match bytes[i] {
            b'\\' if bytes[i..].starts_with(closing.as_bytes()) => {
                let span = Span::new(at, i + closing.len());
                let body = Span::new(start, if start == at { span.end } else { i });
                found.raws.push(RawDisplay { span, body, delimiter, is_numbered: is_numbered(name) });
                return Ok(span.end);
            }
            b'\\' => i += 2,
            b'%' => i = found.comment(text, i)?,
            _ => i += 1,
        }
    }
    Err(Fault::notes(Span::new(at, inside), format!("\\begin{{{name}}} is never closed"))
        .help(format!("add \\end{{{name}}} after the equation")))
}

/// The id in the text of a comment, when it is an `onshell: veff` comment.
pub(super) fn name_in(text: &str, comment: Span) -> Result<Option<Name>, Fault> {
    let inside = &text[comment.range()];
    let Some(id) = inside.trim().strip_prefix("onshell:") else { return Ok(None) };
    let id = id.trim();
    if id.is_empty() || !id.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'_' | b'.')) {
        return Err(Fault::notes(comment, format!("`{id}` cannot be the name of an equation"))
            .help("a name is one word of letters, digits, `-`, `_` and `.`, as in `onshell: veff`"));
    }
    Ok(Some(Name { id: format!("#{id}"), span: comment }))
}
