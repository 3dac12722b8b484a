//! Displays in a TeX file. The scan knows only comments, verbatim text and mathematics.

use super::macros;
use super::tex_scanner::{self, Delimiter, RawDisplay, ScannedText};
use crate::source::{Fault, Span};

/// Environments with verbatim text.
const VERBATIM: &[&str] = &["verbatim", "verbatim*", "Verbatim", "lstlisting", "minted", "comment", "filecontents"];

/// Finds the displays of a TeX file.
pub(super) fn scan(text: &str) -> Result<ScannedText, Fault> {
    let bytes = text.as_bytes();
    let mut found = ScannedText::default();
    let mut i = 0;
    while i < bytes.len() {
        i = match bytes[i] {
            b'%' => found.comment(text, i)?,
            b'$' if bytes[i..].starts_with(b"$$") => pair(text, i, b"$$", &mut found)?,
            b'$' => found.inline(bytes, i, false),
            b'\\' => match command(text, i, &mut found)? {
                Some(next) => next,
                None => {
                    found.blank.push(Span::new(i, text.len()));
                    break;
                }
            },
            _ => i + 1,
        };
    }
    Ok(found)
}

/// The position after the verbatim text or the definition that begins at `at`.
pub(super) fn verbatim_end(text: &str, at: usize) -> Option<usize> {
    if let Some((name, inside)) = tex_scanner::begin(text, at) {
        let closing = format!("\\end{{{name}}}");
        // What is never closed hides the rest; the scan of the displays reports it.
        let end = || tex_scanner::find(text, inside, &closing).unwrap_or(text.len());
        return VERBATIM.contains(&name).then(end);
    }
    macros::definition(text, at).map(|definition| definition.span.end)
}

/// Reads the command at `at`. Returns the position after it, or `None` at the end of the document.
fn command(text: &str, at: usize, found: &mut ScannedText) -> Result<Option<usize>, Fault> {
    let bytes = text.as_bytes();
    if bytes[at..].starts_with(b"\\[") {
        return pair(text, at, b"\\]", found).map(Some);
    }
    if bytes[at..].starts_with(b"\\end{document}") {
        return Ok(None);
    }
    if let Some((name, inside)) = tex_scanner::begin(text, at) {
        if let Some(delimiter) = tex_scanner::environment(name) {
            return tex_scanner::environment_display(text, at, inside, name, delimiter, found).map(Some);
        }
        if VERBATIM.contains(&name) {
            let closing = format!("\\end{{{name}}}");
            let Some(end) = tex_scanner::find(text, inside, &closing) else {
                return Err(Fault::notes(Span::new(at, inside), format!("\\begin{{{name}}} is never closed"))
                    .help(format!("add {closing}; without it the rest of the file is not read")));
            };
            found.blank.push(Span::new(at, end));
            return Ok(Some(end));
        }
        return Ok(Some(inside));
    }
    let word = tex_scanner::word_end(bytes, at);
    let defines = matches!(&text[at + 1..word], "def" | "newcommand" | "renewcommand" | "providecommand");
    Ok(Some(match &text[at + 1..word] {
        "" => at + 2,
        "verb" | "lstinline" => {
            let start = word + usize::from(bytes.get(word) == Some(&b'*'));
            let line = bytes.iter().skip(start + 1).take_while(|&&b| b != b'\n');
            let close = bytes.get(start).and_then(|mark| line.into_iter().position(|b| b == mark));
            let end = close.map_or(word, |i| start + 1 + i + 1);
            found.blank.push(Span::new(at, end));
            end
        }
        // The `\begin{equation}` in the body of a macro opens nothing.
        _ if defines => macros::definition(text, at).map_or(word, |definition| definition.span.end),
        _ => word,
    }))
}

/// The display whose two-byte opening stands at `open`.
fn pair(text: &str, open: usize, closing: &[u8], found: &mut ScannedText) -> Result<usize, Fault> {
    let bytes = text.as_bytes();
    let mut i = open + 2;
    while i < bytes.len() {
        if bytes[i..].starts_with(closing) {
            let span = Span::new(open, i + 2);
            found.raws.push(RawDisplay { span, body: Span::new(open + 2, i), delimiter: Delimiter::Pair });
            return Ok(i + 2);
        }
        match bytes[i] {
            b'\\' => i += 2,
            b'%' => i = found.comment(text, i)?,
            _ => i += 1,
        }
    }
    let opening = &text[open..open + 2];
    Err(Fault::notes(Span::new(open, open + 2), format!("this `{opening}` is never closed"))
        .help(format!("add `{}` after the equation", String::from_utf8_lossy(closing))))
}
