//! The scan of a TeX file for displays: environments, brackets, comments and verbatim text.

use crate::notes::macros;
use crate::notes::tex_scanner::{self, Delimiter, RawDisplay, ScannedText};
use crate::source::{Fault, Span};

use super::environments::Own;

/// Environments with verbatim text.
const VERBATIM: &[&str] = &["verbatim", "verbatim*", "Verbatim", "lstlisting", "minted", "comment", "filecontents"];

/// Finds the displays of a TeX file.
pub(in crate::notes) fn scan(text: &str) -> Result<ScannedText, Fault> {
    let bytes = text.as_bytes();
    let own = Own::of(text);
    let mut found = ScannedText::default();
    let mut i = 0;
    while i < bytes.len() {
        i = match bytes[i] {
            b'%' => found.comment(text, i)?,
            b'$' if bytes[i..].starts_with(b"$$") => pair(text, i, b"$$", &mut found)?,
            b'$' => found.inline(bytes, i, false),
            b'\\' => match command(text, i, &own, &mut found)? {
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
pub(in crate::notes) fn verbatim_end(text: &str, at: usize) -> Option<usize> {
    if let Some((name, inside)) = tex_scanner::begin(text, at) {
        let closing = format!("\\end{{{name}}}");
        // What is never closed hides the rest; the scan of the displays reports it.
        let end = || tex_scanner::find(text, inside, &closing).unwrap_or(text.len());
        return VERBATIM.contains(&name).then(end);
    }
    macros::definition(text, at).map(|definition| definition.span.end)
}

/// Reads the command at `at`. Returns the position after it, or `None` at the end of the document.
fn command(text: &str, at: usize, own: &Own, found: &mut ScannedText) -> Result<Option<usize>, Fault> {
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
        if tex_scanner::is_foreign(name) {
            let whole = Delimiter::Whole;
            return tex_scanner::environment_display(text, at, inside, name, whole, found).map(Some);
        }
        if let Some((delimiter, real)) = own.environment(name) {
            let next = tex_scanner::environment_display(text, at, inside, name, delimiter, found)?;
            found.raws.iter_mut().last().into_iter().for_each(|raw| raw.is_numbered = tex_scanner::is_numbered(real));
            return Ok(Some(next));
        }
        if name == "empheq" {
            return empheq(text, at, inside, found).map(Some);
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
    let name = &text[at..word];
    if let Some(real) = own.opens(name) {
        return own_display(text, (at, word), own, real, found).map(Some);
    }
    if let Some(real) = own.surrounds(name) {
        let open = tex_scanner::skip_space(bytes, word);
        if let (Some(end), Some(delimiter)) = (tex_scanner::body(bytes, open), tex_scanner::environment(real)) {
            let (span, body) = (Span::new(at, end), Span::new(open + 1, end - 1));
            found.raws.push(RawDisplay { span, body, delimiter, is_numbered: tex_scanner::is_numbered(real) });
            comments(text, body, found)?;
            return Ok(Some(end));
        }
    }
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
        "newenvironment" | "renewenvironment" => {
            let end = environment_end(text, word).unwrap_or(word);
            found.blank.push(Span::new(at, end));
            end
        }
        // The `\begin{equation}` in the body of a macro opens nothing.
        _ if defines => macros::definition(text, at).map_or(word, |definition| definition.span.end),
        _ => word,
    }))
}

/// The position after the definition of an environment whose name comes next.
fn environment_end(text: &str, word: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut at = word + usize::from(bytes.get(word) == Some(&b'*'));
    at = tex_scanner::short_group(bytes, tex_scanner::skip_space(bytes, at))?;
    while bytes.get(tex_scanner::skip_space(bytes, at)) == Some(&b'[') {
        at = tex_scanner::line_end(bytes, at).min(tex_scanner::find(text, at, "]")? + 1);
    }
    at = tex_scanner::body(bytes, tex_scanner::skip_space(bytes, at))?;
    tex_scanner::body(bytes, tex_scanner::skip_space(bytes, at))
}

/// Records the comments in a display.
fn comments(text: &str, body: Span, found: &mut ScannedText) -> Result<(), Fault> {
    let mut i = body.start;
    while i < body.end {
        match text.as_bytes()[i] {
            b'\\' => i += 2,
            b'%' => i = found.comment(text, i)?,
            _ => i += 1,
        }
    }
    Ok(())
}

/// The display between two commands of the author's, as `\be … \ee`.
fn own_display(
    text: &str,
    (at, inside): (usize, usize),
    own: &Own,
    real: &str,
    found: &mut ScannedText,
) -> Result<usize, Fault> {
    let bytes = text.as_bytes();
    let mut i = inside;
    while let Some(next) = tex_scanner::find(text, i, "\\") {
        let word = tex_scanner::word_end(bytes, next);
        let end = match own.closes(&text[next..word]) {
            true => Some(word),
            false => text[next..].starts_with(&format!("\\end{{{real}}}")).then(|| word + real.len() + 2),
        };
        if let (Some(end), Some(delimiter)) = (end, tex_scanner::environment(real)) {
            let body = Span::new(inside, next);
            let is_numbered = tex_scanner::is_numbered(real);
            found.raws.push(RawDisplay { span: Span::new(at, end), body, delimiter, is_numbered });
            comments(text, body, found)?;
            return Ok(end);
        }
        i = word.max(next + 2);
        while i < text.len() && !text.is_char_boundary(i) {
            i += 1;
        }
    }
    let command = &text[at..inside];
    Err(Fault::notes(Span::new(at, inside), format!("the display that {command} opens is never closed"))
        .help(format!("add the command that closes it after the equation, or \\end{{{real}}}")))
}

/// `\begin{empheq}[…]{align}`.
fn empheq(text: &str, at: usize, inside: usize, found: &mut ScannedText) -> Result<usize, Fault> {
    let bytes = text.as_bytes();
    let mut start = inside;
    if bytes.get(start) == Some(&b'[') {
        start = tex_scanner::find(text, start, "]{").map_or(start, |end| end + 1);
    }
    let end = tex_scanner::short_group(bytes, start).unwrap_or(start);
    let real = text.get(start + 1..end.saturating_sub(1)).unwrap_or_default();
    let delimiter = tex_scanner::environment(real.split('=').next().unwrap_or(real)).unwrap_or(Delimiter::Whole);
    let next = tex_scanner::environment_display(text, at, end, "empheq", delimiter, found)?;
    found.raws.iter_mut().last().into_iter().for_each(|raw| raw.is_numbered = tex_scanner::is_numbered(real));
    Ok(next)
}

/// The display whose two-byte opening stands at `open`.
fn pair(text: &str, open: usize, closing: &[u8], found: &mut ScannedText) -> Result<usize, Fault> {
    let bytes = text.as_bytes();
    let mut i = open + 2;
    while i < bytes.len() {
        if bytes[i..].starts_with(closing) {
            let span = Span::new(open, i + 2);
            found.raws.push(RawDisplay {
                span,
                body: Span::new(open + 2, i),
                delimiter: Delimiter::Pair,
                is_numbered: false,
            });
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
