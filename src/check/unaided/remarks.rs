//! Remarks in parentheses at the end of a display that say when its sides are nearly equal: `A \approx B \qquad (t \gg \tau)`.
//!
//! They are no statements, so they are blanked out before the display is read, and taken for words.

use crate::notes::Display;
use crate::source::Source;

/// The signs of what is small or large.
const SIGNS: [&str; 4] = ["\\ll", "\\gg", "\\to ", "\\rightarrow "];

/// The text of a display with blanks in the place of such a remark; `None` if it has none.
pub(super) fn blanked(text: &str) -> Option<String> {
    let (start, end) = place(text)?;
    let blank: String = text[start..end].chars().map(|c| " ".repeat(c.len_utf8())).collect();
    Some([&text[..start], &blank, &text[end..]].concat())
}

/// The remark of a display, without its parentheses.
pub(super) fn remark<'s>(display: &Display, source: &'s Source) -> Option<&'s str> {
    let printed = source.text.get(display.body.range())?;
    let (start, end) = place(printed)?;
    let remark = &printed[start..end];
    let inner = remark.strip_prefix("\\left").unwrap_or(remark).strip_prefix('(')?.strip_suffix(')')?;
    Some(inner.strip_suffix("\\right").unwrap_or(inner))
}

/// The bytes of a remark in a display that says `\approx`.
fn place(text: &str) -> Option<(usize, usize)> {
    let body = text.trim_end().trim_end_matches(['.', ',', ';']).trim_end();
    let inside = body.strip_suffix(')')?;
    let mut depth = 1;
    let open = inside.char_indices().rev().find(|(_, c)| {
        depth += i32::from(*c == ')') - i32::from(*c == '(');
        depth == 0
    });
    let (open, _) = open?;
    let start = if inside[..open].ends_with("\\left") { open - "\\left".len() } else { open };
    let before = text[..start].trim_end();
    let is_apart = ["\\quad", "\\qquad", "\\;", "\\,", "\\ ", ","].iter().any(|space| before.ends_with(space));
    let says = SIGNS.iter().any(|sign| inside[open..].contains(sign));
    (is_apart && says && before.contains("\\approx")).then_some((start, body.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_remark_is_blanked_and_a_factor_is_not() {
        let text = r"s \approx \frac{a t}{b} \qquad \left( t \gg \frac{b(1 + c)}{a} \right) .";
        let found = blanked(text).unwrap();
        assert_eq!(found.len(), text.len());
        assert_eq!(found.trim_end_matches([' ', '.']), r"s \approx \frac{a t}{b} \qquad");
        assert_eq!(blanked(r"s \approx a (t \gg b)"), None);
        assert_eq!(blanked(r"s = a \quad (t > b)"), None);
        assert_eq!(blanked(r"s \approx a \quad (1 + b)"), None);
    }
}
