//! The rows of an `align`: where `\\` breaks them, and which of them one number holds together.

use super::scan;
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

/// The position after the star and the space that a `\\` may take.
fn after_break(bytes: &[u8], at: usize) -> usize {
    let at = at + usize::from(bytes.get(at) == Some(&b'*'));
    let length = || bytes[at + 1..].iter().take(40).position(|&b| b == b']');
    match bytes.get(at) {
        Some(b'[') => length().map_or(at, |length| at + 1 + length + 1),
        _ => at,
    }
}

/// Whether `text` starts with a relation, alignment marks aside: it goes on with what stands before it.
pub(super) fn starts_with_relation(text: &str) -> bool {
    let text = text.trim_start_matches(|c: char| c.is_whitespace() || c == '&');
    let text = match text.strip_prefix("{}") {
        Some(rest) => rest.trim_start(),
        None => text,
    };
    if text.starts_with(['=', '<', '>']) || text.starts_with(":=") {
        return true;
    }
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
        "\\stackrel",
        "\\overset",
        "\\coloneqq",
        "\\doteq",
        "\\leqslant",
        "\\geqslant",
        "\\lesssim",
        "\\gtrsim",
    ];
    text.starts_with('\\') && RELATIONS.contains(&&text[..scan::word_end(text.as_bytes(), 0)])
}
