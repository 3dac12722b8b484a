//! Marks inside a typeset equation: the part that is wrong, and the part that repairs it.
//!
//! A part is wrapped in a colour that no author writes; in the MathML the colour becomes a class. So the mark is where
//! the typesetter puts the part.

use std::ops::Range;

/// What is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// The part that is wrong.
    Fault,
    /// The part that is put in its place.
    Correction,
}

impl Mark {
    const ALL: [Mark; 2] = [Mark::Fault, Mark::Correction];

    /// The colour that stands for the mark until the MathML is written.
    fn colour(self) -> (&'static str, &'static str) {
        match self {
            Mark::Fault => ("#fe0d5b", "rgb(254 13 91)"),
            Mark::Correction => ("#0dfe5b", "rgb(13 254 91)"),
        }
    }

    fn class(self) -> &'static str {
        match self {
            Mark::Fault => "fault",
            Mark::Correction => "correction",
        }
    }
}

/// LaTeX with the parts in their colours, or `None` if a part cannot be wrapped.
pub(super) fn put_in(latex: &str, parts: &[(Range<usize>, Mark)]) -> Option<String> {
    let mut parts = parts.to_vec();
    parts.sort_by_key(|(range, _)| std::cmp::Reverse(range.start));
    if parts.windows(2).any(|pair| pair[1].0.end > pair[0].0.start) {
        return None;
    }
    let mut out = latex.to_owned();
    for (range, mark) in parts {
        let wrapped = wrapped(out.get(range.clone())?, mark)?;
        // A command word may end where the part begins.
        let glued = out[..range.start].ends_with(|c: char| c.is_alphabetic() || c == '\\') && wrapped.is_empty();
        if out[..range.start].ends_with('\\') || glued {
            return None;
        }
        out.replace_range(range, &wrapped);
    }
    Some(out)
}

/// A part in its colour: cells and rows one by one, because a colour ends with its cell.
fn wrapped(part: &str, mark: Mark) -> Option<String> {
    let mut out = String::new();
    for (piece, separator) in cells(part)? {
        let body = piece.trim_start_matches([' ', '\n', '\t', '^', '_']);
        let lead = &piece[..piece.len() - body.len()];
        let body_end = body.trim_end();
        let tail = &body[body_end.len()..];
        out.push_str(lead);
        if !body_end.is_empty() {
            out.push_str(&format!("{{\\color{{{}}}{body_end}}}", mark.colour().0));
        }
        out.push_str(tail);
        out.push_str(separator);
    }
    (!out.trim().is_empty()).then_some(out)
}

/// The pieces between `&` and `\\` outside of groups, each with what separates it from the next; `None` if groups,
/// fences or environments do not close in their piece.
fn cells(part: &str) -> Option<Vec<(&str, &str)>> {
    let (mut pieces, mut start, mut at) = (Vec::new(), 0, 0);
    let (mut braces, mut fences, mut environments) = (0_i32, 0_i32, 0_i32);
    while let Some(c) = part[at..].chars().next() {
        let rest = &part[at..];
        let word = rest.strip_prefix('\\').map(|rest| {
            let letters = rest.chars().take_while(|c| c.is_ascii_alphabetic()).count();
            &rest[..letters.max(rest.chars().next().map_or(0, char::len_utf8))]
        });
        let length = word.map_or(c.len_utf8(), |word| 1 + word.len());
        match (c, word) {
            ('{', _) => braces += 1,
            ('}', _) => braces -= 1,
            (_, Some("left")) => fences += 1,
            (_, Some("right")) => fences -= 1,
            (_, Some("begin")) => environments += 1,
            (_, Some("end")) => environments -= 1,
            _ => {}
        }
        if braces < 0 || fences < 0 || environments < 0 {
            return None;
        }
        let is_separator = c == '&' || word == Some("\\");
        if is_separator && environments == 0 {
            if braces > 0 || fences > 0 {
                return None;
            }
            pieces.push((&part[start..at], &part[at..at + length]));
            start = at + length;
        }
        at += length;
    }
    pieces.push((&part[start..], ""));
    (braces == 0 && fences == 0 && environments == 0).then_some(pieces)
}

/// The colours of the marks as classes; colours of the author are left out, because they may not be legible.
pub(super) fn as_classes(mathml: &str) -> String {
    let mut out = mathml.to_owned();
    for mark in Mark::ALL {
        let class = format!(" class=\"{}\"", mark.class());
        out = out.replace(&format!(" style=\"color: {}\"", mark.colour().1), &class);
        // A sign at the start of a part keeps the space that it has between two terms.
        out = out.replace(&format!("<mrow{class}><mo>"), &format!("<mrow{class}><mo form=\"infix\">"));
    }
    let mut plain = String::with_capacity(out.len());
    let mut rest = out.as_str();
    while let Some((before, after)) = rest.split_once(" style=\"color: ") {
        plain.push_str(before);
        rest = after.split_once('"').map_or("", |(_, after)| after);
    }
    plain + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exponent_is_marked_and_stays_one() {
        let shown = put_in("x^2 + y", &[(1..3, Mark::Correction)]);
        assert_eq!(shown.as_deref(), Some(r"x^{\color{#0dfe5b}2} + y"));
    }

    #[test]
    fn rows_are_marked_one_by_one_and_half_a_group_is_not_marked() {
        let shown = put_in(r"a &= b \\ &= c", &[(0..14, Mark::Fault)]).unwrap_or_default();
        assert_eq!(shown.matches("color").count(), 3, "{shown}");
        assert_eq!(put_in(r"\frac{a}{b}", &[(5..10, Mark::Fault)]), None);
        assert_eq!(put_in(r"\left( a \right)", &[(0..8, Mark::Fault)]), None);
    }
}
