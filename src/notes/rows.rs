//! The rows of a display, which `\\` or a blank line separates.

use super::tex_scanner;
use crate::source::Span;

/// The rows of `body` in `text`, without the `\\` between them.
pub(super) fn split(text: &[u8], body: Span) -> Vec<Span> {
    let bytes = &text[..body.end];
    let mut rows = Vec::new();
    let (mut braces, mut inner) = (0usize, 0usize);
    let (mut start, mut i) = (body.start, body.start);
    while i < bytes.len() {
        match bytes[i] {
            b'{' => braces += 1,
            b'}' => braces = braces.saturating_sub(1),
            b'\\' if bytes[i..].starts_with(b"\\begin{") => inner += 1,
            b'\\' if bytes[i..].starts_with(b"\\end{") => inner = inner.saturating_sub(1),
            b'\\' if bytes.get(i + 1) == Some(&b'\\') && braces == 0 && inner == 0 => {
                rows.push(Span::new(start, i));
                i = after_break(bytes, i + 2);
                start = i;
                continue;
            }
            b'\\' => i += 1,
            _ => {}
        }
        i += 1;
    }
    rows.push(Span::new(start, body.end));
    rows
}

/// The position after the optional star and length of a `\\`.
fn after_break(bytes: &[u8], at: usize) -> usize {
    let at = at + usize::from(bytes.get(at) == Some(&b'*'));
    let length = || bytes[at + 1..].iter().take(40).position(|&b| b == b']');
    match bytes.get(at) {
        Some(b'[') => length().map_or(at, |length| at + 1 + length + 1),
        _ => at,
    }
}

/// Writes a row break, `\\`, over the first blank line between two rows of `body`.
///
/// TeX allows no blank line in a display, but some converters print blank lines between rows. Nothing is written within
/// braces, an environment or `\left … \right`. A line with only a comment or a `\tag` is not blank.
pub(super) fn mark_blank_lines(clean: &mut [u8], source: &str, body: Span) {
    let source = source.as_bytes();
    let is_blank = |clean: &[u8], start: usize| {
        let line = (start..body.end).take_while(|&at| clean[at] != b'\n');
        let length = line.clone().count();
        start + length < body.end
            && line.clone().all(|at| clean[at].is_ascii_whitespace())
            && line.clone().all(|at| source[at].is_ascii_whitespace() || source[at] == b'>')
    };
    let mut depth = 0usize;
    // Whether something stands in this row, and the line end after which it may be broken.
    let (mut begun, mut gap) = (false, None);
    let mut i = body.start;
    while i < body.end {
        let rest = &clean[i..body.end];
        let mut next = i + 1;
        match rest[0] {
            b'\n' => {
                if begun && depth == 0 && gap.is_none() && is_blank(clean, i + 1) {
                    gap = Some(i);
                }
                i = next;
                continue;
            }
            byte if byte.is_ascii_whitespace() => {
                i = next;
                continue;
            }
            b'\\' if rest.starts_with(b"\\\\") && depth == 0 => {
                (begun, gap) = (false, None);
                i = after_break(&clean[..body.end], i + 2);
                continue;
            }
            _ => {}
        }
        if let Some(at) = gap.take() {
            clean[at..at + 2].copy_from_slice(b"\\\\");
        }
        begun = true;
        match clean[i] {
            b'{' => depth += 1,
            b'}' => depth = depth.saturating_sub(1),
            b'\\' => {
                let word = tex_scanner::word_end(&clean[..body.end], i);
                match &clean[i + 1..word] {
                    b"begin" | b"left" => depth += 1,
                    b"end" | b"right" => depth = depth.saturating_sub(1),
                    _ => {}
                }
                next = word.max(i + 2);
            }
            _ => {}
        }
        i = next;
    }
}

/// The commands that are relations.
const RELATIONS: &[&str] = &[
    "\\equiv",
    "\\approx",
    "\\simeq",
    "\\sim",
    "\\cong",
    "\\propto",
    "\\neq",
    "\\ne",
    "\\leq",
    "\\le",
    "\\geq",
    "\\ge",
    "\\ll",
    "\\gg",
    "\\lt",
    "\\gt",
    "\\Rightarrow",
    "\\implies",
    "\\Longrightarrow",
    "\\iff",
    "\\Leftrightarrow",
    "\\to",
    "\\rightarrow",
    "\\longrightarrow",
    "\\coloneqq",
    "\\doteq",
    "\\leqslant",
    "\\geqslant",
    "\\lesssim",
    "\\gtrsim",
];

/// Whether `text` starts with a relation, alignment marks aside, and so continues the row before.
pub(super) fn starts_with_relation(text: &str) -> bool {
    let text = text.trim_start_matches(|c: char| c.is_whitespace() || c == '&');
    let text = match text.strip_prefix("{}") {
        Some(rest) => rest.trim_start(),
        None => text,
    };
    if text.starts_with(['=', '<', '>']) || text.starts_with(":=") {
        return true;
    }
    let Some(name) = text.starts_with('\\').then(|| &text[..tex_scanner::word_end(text.as_bytes(), 0)]) else {
        return false;
    };
    RELATIONS.contains(&name) || ["\\stackrel", "\\overset"].contains(&name) && is_stacked_relation(&text[name.len()..])
}

/// Whether what stands below a mark is a relation, as in `{!}{=}`; it may be a letter with dots, `{..}{x}`.
fn is_stacked_relation(arguments: &str) -> bool {
    let Some((_, below)) = arguments.split_once('}') else { return false };
    below.trim_start().strip_prefix('{').is_some_and(starts_with_relation)
}

/// The place after the last relation of a row that stands in no braces, environment or `\left … \right`.
pub(super) fn last_relation_end(text: &[u8], row: Span) -> Option<usize> {
    let bytes = &text[..row.end];
    let (mut depth, mut at, mut found) = (0usize, row.start, None);
    while at < row.end {
        let mut next = at + 1;
        match bytes[at] {
            b'{' => depth += 1,
            b'}' => depth = depth.saturating_sub(1),
            b'=' if depth == 0 => found = Some(next),
            b'\\' => {
                let word = tex_scanner::word_end(bytes, at);
                match &bytes[at + 1..word] {
                    b"begin" | b"left" => depth += 1,
                    b"end" | b"right" => depth = depth.saturating_sub(1),
                    _ if depth == 0 && RELATIONS.iter().any(|name| name.as_bytes() == &bytes[at..word]) => {
                        found = Some(word);
                    }
                    _ => {}
                }
                next = word.max(at + 2);
            }
            _ => {}
        }
        at = next;
    }
    found
}
