//! Numbers printed inside of displays: `$$a = b \qquad (3)$$` and `$$a = b (2.8)$$`.
//!
//! A product may end the same way, so the other numbers of the file decide.

use std::collections::HashSet;

use super::display::Numbered;
use super::tex_scanner;
use crate::source::Span;

/// A display: its body, and the number that it has otherwise.
pub(super) struct Body {
    pub span: Span,
    pub number: Option<String>,
}

/// The displays whose body ends with their number, and these numbers. `clean` has spaces for what is no formula.
pub(super) fn find(source: &str, clean: &[u8], displays: &[Body]) -> Vec<(usize, Numbered)> {
    let ends: Vec<Option<End>> = displays
        .iter()
        .map(|display| if display.number.is_none() { ending(source, clean, display.span) } else { None })
        .collect();
    let chapter = |id: &str| id.split_once('.').map(|(chapter, _)| chapter.to_owned());
    let chapters: HashSet<String> = displays.iter().filter_map(|display| chapter(display.number.as_deref()?)).collect();
    let in_order = in_order(displays, &ends);
    let is_one = |i: usize, end: &End| match chapter(&end.numbered.id) {
        Some(chapter) => chapters.is_empty() || chapters.contains(&chapter),
        None => in_order.contains(&i),
    };
    let found = ends.into_iter().enumerate().filter_map(|(i, end)| Some((i, end?)));
    found.filter(|(i, end)| is_one(*i, end)).map(|(i, end)| (i, end.numbered)).collect()
}

/// A number in parentheses at the end of a display, behind a space.
struct End {
    numbered: Numbered,
    /// The place in the order of the numbers, where it has no chapter: `(3)` and `(3b)`.
    order: Option<(u32, String)>,
}

fn ending(source: &str, clean: &[u8], body: Span) -> Option<End> {
    let (text, trimmed) = (&clean[body.range()], clean[body.range()].trim_ascii_end());
    let open = trimmed.iter().rposition(|&b| b == b'(')?;
    let (id, end) = tex_scanner::number(source, body.start + open)?;
    let before = &text[..open];
    let order = order(id);
    let is_apart =
        if order.is_some() { ends_with_wide_space(before) } else { is_dotted(id) && ends_with_space(before) };
    (is_apart && end == body.start + trimmed.len())
        .then(|| End { numbered: Numbered { id: id.to_owned(), span: Span::new(body.start + open, end) }, order })
}

/// Those of the numbers without a chapter that go on from the number before by one. Two of them are numbers; one alone
/// may be a factor, if it is not 1.
fn in_order(displays: &[Body], ends: &[Option<End>]) -> HashSet<usize> {
    let mut last: Option<(u32, String)> = None;
    let mut found = HashSet::new();
    let mut first = None;
    for (i, (display, end)) in displays.iter().zip(ends).enumerate() {
        let Some(next) = display.number.as_deref().map_or_else(|| end.as_ref()?.order.clone(), order) else { continue };
        let goes_on = match &last {
            None => next.0 == 1,
            Some(last) => next.0 == last.0 + 1 || (next.0 == last.0 && next.1 > last.1),
        };
        if display.number.is_none() {
            if goes_on {
                found.insert(i);
                found.extend(first.take());
            } else if last.is_none() {
                first = Some(i);
            } else {
                continue;
            }
        }
        last = Some(next);
    }
    found
}

/// `3` and `3b` as a number and what follows it; `None` for another text, and for a number with a chapter.
fn order(id: &str) -> Option<(u32, String)> {
    let rest = id.trim_start_matches(|c: char| c.is_ascii_digit());
    let number = id[..id.len() - rest.len()].parse().ok()?;
    let is_suffix = rest.chars().all(|c| c.is_ascii_lowercase() || c == '\'') && rest.len() <= 1;
    is_suffix.then(|| (number, rest.to_owned()))
}

/// `2.8` and `2.8a`.
fn is_dotted(id: &str) -> bool {
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    id.split_once('.').is_some_and(|(a, b)| is_digits(a) && is_digits(b.trim_end_matches(char::is_alphabetic)))
}

fn ends_with_space(before: &[u8]) -> bool {
    before.last().is_some_and(u8::is_ascii_whitespace) || ends_with_wide_space(before)
}

/// A space that no author puts before a factor.
fn ends_with_wide_space(before: &[u8]) -> bool {
    let before = before.trim_ascii_end();
    before.ends_with(b"\\quad") || before.ends_with(b"\\qquad") || before.ends_with(b"\\hfill")
}
