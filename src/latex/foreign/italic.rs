//! Units that are written like letters: `4.2\,m/s^2`, `3\,\frac ms`.

use crate::source::Span;

use super::units::{braced, skipped, words};

/// The letters of units behind a gap after a number that ends at a place, and the same upright.
pub(super) fn units_after(text: &str, number: usize) -> Option<(Span, String)> {
    let start = skipped(text, number);
    let is_apart = start > number && text[number..start].contains(['\\', '~']);
    if !is_apart {
        return None;
    }
    let rest = &text[start..];
    if let Some(inside) = rest.strip_prefix("\\frac") {
        let (above, after) = argument(inside)?;
        let (below, after) = argument(after)?;
        let upright = format!("\\frac{{{}}}{{{}}}", upright(above)?, upright(below)?);
        return Some((Span::new(start, text.len() - after.len()), upright));
    }
    let is_part = |c: char| c.is_ascii_alphanumeric() || "/^{}-".contains(c);
    let word = &rest[..rest.find(|c: char| !is_part(c)).unwrap_or(rest.len())];
    // A brace that closes a group before the unit is no part of it.
    let closes_more =
        |(at, c): &(usize, char)| *c == '}' && word[..=*at].matches('}').count() > word[..*at].matches('{').count();
    let word = &word[..word.char_indices().find(closes_more).map_or(word.len(), |(at, _)| at)];
    let is_whole = !rest[word.len()..].trim_start().starts_with(['_', '(', '\'', '^']);
    Some((Span::new(start, start + word.len()), upright(word).filter(|_| is_whole)?))
}

/// The first argument of a command, in braces or a single letter, and what stands after it.
fn argument(text: &str) -> Option<(&str, &str)> {
    let text = text.trim_start();
    match text.strip_prefix('{') {
        Some(inside) => braced(inside).map(|(inner, length)| (inner, &inside[length..])),
        None => text.chars().next().map(|first| text.split_at(first.len_utf8())),
    }
}

fn upright(word: &str) -> Option<String> {
    let begins = word.starts_with(|c: char| c.is_ascii_alphabetic()) && !word.contains('\\');
    (begins && words(word).is_some()).then(|| format!("\\mathrm{{{word}}}"))
}

#[cfg(test)]
mod tests {
    use super::units_after;

    #[test]
    fn letters_that_spell_units_stand_upright() {
        let of = |text: &str, end: usize| units_after(text, end).map(|(_, upright)| upright);
        assert_eq!(of(r"4.2\,s", 3).as_deref(), Some(r"\mathrm{s}"));
        assert_eq!(of(r"4.2\,m/s^2", 3).as_deref(), Some(r"\mathrm{m/s^2}"));
        assert_eq!(of(r"\sqrt{4\,\frac{m^2}{s^2}}", 7).as_deref(), Some(r"\frac{\mathrm{m^2}}{\mathrm{s^2}}"));
        assert_eq!(of(r"\frac{3\,s}{2}", 7).as_deref(), Some(r"\mathrm{s}"));
        // The twins: no gap, no unit, a name with a subscript.
        for (text, end) in [("4.2s", 3), (r"4.2\,x", 3), (r"4.2\,m_1", 3), (r"4.2\,\theta", 3)] {
            assert_eq!(of(text, end), None, "{text}");
        }
    }
}
