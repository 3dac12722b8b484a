//! What speaks for a premise as it is printed, against an edit of it.
//!
//! An author who makes a slip makes it once. What a formula or a sentence before the premise prints too is no slip in the premise, and
//! neither is a sign that both sides of a conservation law have.
//!
//! Offers `printed_before`, `is_printed_before`, `parts_two_sides` and `is_reducible`. Knows `course`, and formulas.

use crate::check::unaided::course::Course;
use crate::formula::{Expr, Node, Sign, Statement};
use crate::latex::read_display;
use crate::latex::slips::Edit;
use crate::source::Span;

/// Whether an edit writes a fraction of numbers that everybody reduces: `\frac{12}{3}`, `\frac{4}{1}`.
pub(super) fn is_reducible(text: &str, edit: &Edit) -> bool {
    let edited = edit.applied(text);
    let new = Span::new(edit.span.start, edit.span.start + edit.replacement.len());
    edited.match_indices("\\frac").any(|(at, command)| {
        let rest = &edited[at + command.len()..];
        let Some((numerator, rest)) = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')) else { return false };
        let Some((denominator, after)) = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')) else { return false };
        let is_here = Span::new(at, edited.len() - after.len()).contains(new);
        let numbers = (numerator.trim().parse::<u32>(), denominator.trim().parse::<u32>());
        is_here && matches!(numbers, (Ok(above), Ok(below)) if below > 0 && common_divisor(above, below) > 1 || numbers.1 == Ok(1))
    })
}

fn common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

/// The fewest different symbols of a part that is not printed twice by chance.
const FEWEST_SYMBOLS: usize = 3;

/// What the notes print before a display, without what does not change a formula.
pub(super) fn printed_before(course: &Course<'_, '_>, at: usize) -> String {
    let notes = course.checker.notes;
    bare(notes.source.text.get(..notes.equations[at].span.start).unwrap_or_default())
}

/// Whether a part of a premise around an edit, of several symbols, is printed before the premise too. `place` is the edit in the text
/// of the display, and `before` what is [`printed_before`] it.
pub(super) fn is_printed_before(course: &Course<'_, '_>, at: usize, place: Span, before: &str) -> bool {
    let display = &course.checker.notes.equations[at];
    let members = course.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
    let mut found = false;
    for member in members {
        member.walk(&mut |part| {
            if found || !is_around(part.span, place) || distinct(part) < FEWEST_SYMBOLS {
                return;
            }
            let text = bare(display.text.get(part.span.range()).unwrap_or_default());
            // An argument of a fraction is read with its braces.
            let text = text.strip_prefix('{').and_then(|text| text.strip_suffix('}')).unwrap_or(&text);
            found = !text.is_empty() && stands_in(before, text);
        });
    }
    found
}

/// Whether both sides of a premise are sums with the same signs, as those of a conservation law are, and an edit gives them different
/// ones. `place` is the edit in the text of the display.
pub(super) fn parts_two_sides(
    course: &Course<'_, '_>,
    at: usize,
    statement: &Statement,
    place: Span,
    edit: &Edit,
) -> bool {
    let [left, right] = statement.members.as_slice() else { return false };
    let Some(printed) = signs(left).filter(|printed| signs(right).as_ref() == Some(printed)) else { return false };
    let model = course.checker.model;
    let whole = Edit { span: place, ..edit.clone() };
    let text = whole.applied(&course.checker.notes.equations[at].text);
    let reading = read_display(&text, &mut model.symbols.clone(), &model.macros);
    let edited = reading.statements.iter().flatten().find(|other| other.span.start == statement.span.start);
    edited.is_some_and(|edited| match edited.members.as_slice() {
        [left, right] => [signs(left), signs(right)].iter().any(|signs| signs.as_ref() != Some(&printed)),
        _ => false,
    })
}

/// The signs of the terms of a sum.
fn signs(side: &Expr) -> Option<Vec<bool>> {
    match &side.node {
        Node::Sum(terms) if terms.len() > 1 => Some(terms.iter().map(|term| term.sign == Sign::Plus).collect()),
        _ => None,
    }
}

/// Whether an edit is inside a part; what is put in at the end of a part is beside it.
fn is_around(part: Span, place: Span) -> bool {
    match place.start == place.end {
        true => part.start < place.start && place.end < part.end,
        false => part.contains(place),
    }
}

fn distinct(part: &Expr) -> usize {
    let mut symbols: Vec<usize> = part.symbols().into_iter().map(|(id, _)| id.0).collect();
    symbols.sort_unstable();
    symbols.dedup();
    symbols.len()
}

/// A formula without what does not change it.
fn bare(text: &str) -> String {
    let text = ["\\left", "\\right", "\\,", "\\;", "\\!", "&"]
        .iter()
        .fold(text.to_owned(), |text, mark| text.replace(mark, ""));
    text.split_whitespace().collect()
}

/// Whether a formula contains another one as a whole: no digit, index or power goes on before or after it.
fn stands_in(all: &str, part: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit();
    all.match_indices(part).any(|(at, _)| {
        let (before, after) = (&all[..at], &all[at + part.len()..]);
        let goes_on_before =
            before.ends_with(['^', '_', '\\', '.']) || before.ends_with(is_digit) && part.starts_with(is_digit);
        let goes_on_after =
            after.starts_with(['^', '_', '.']) || after.starts_with(is_digit) && part.ends_with(is_digit);
        !goes_on_before && !goes_on_after
    })
}
