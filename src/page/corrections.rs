//! Where an equation is wrong and how it reads when it is corrected, as parts of its LaTeX.

use std::ops::Range;

use super::math_marks::Mark;
use crate::check::{Equation, Repair};
use crate::notes::Display;

/// A text with parts that are marked.
pub(super) type Marked = (String, Vec<(Range<usize>, Mark)>);

/// A correction of a display.
pub(super) struct Correction {
    /// What is printed; empty if something is added.
    pub printed: String,
    /// What is to be read; empty if something is left out.
    pub read: String,
    /// The corrected display.
    pub corrected: Option<Marked>,
}

/// The parts of a display that are wrong: what its errata or its likeliest repair replace, or else where it fails.
pub(super) fn faults(item: &Equation, display: &Display) -> Vec<(Range<usize>, Mark)> {
    let text = &display.text;
    let errata: Vec<Range<usize>> = item.errata.iter().filter_map(|(from, to)| changed(text, from, to)).collect();
    let mut ranges: Vec<Range<usize>> = match (errata.is_empty(), item.repairs.first()) {
        (false, _) => errata,
        (true, Some(repair)) => own(repair, display).into_iter().collect(),
        (true, None) if !item.finding.verdict.passes() => {
            let span = item.finding.span;
            let inside =
                display.body.contains(span).then(|| span.start - display.body.start..span.end - display.body.start);
            // The whole display marked says nothing.
            inside
                .filter(|range| text.get(range.clone()).is_some_and(|part| part.trim().len() < text.trim().len()))
                .into_iter()
                .collect()
        }
        (true, None) => Vec::new(),
    };
    ranges.retain(|range| !range.is_empty());
    ranges.into_iter().map(|range| (range, Mark::Fault)).collect()
}

/// The errata of an equation together, as one correction.
pub(super) fn errata(item: &Equation, display: &Display) -> Option<Correction> {
    let (first, rest) = item.errata.split_first()?;
    let mut text = display.text.clone();
    let mut parts: Vec<(Range<usize>, Mark)> = Vec::new();
    for (printed, read) in &item.errata {
        let (Some(at), Some(range)) = (text.find(printed.as_str()), changed(&text, printed, read)) else {
            return Some(Correction { printed: printed.clone(), read: read.clone(), corrected: None });
        };
        let end = at + read.len() - (at + printed.len() - range.end);
        text.replace_range(at..at + printed.len(), read);
        let shift = |place: usize| if place >= at { place + read.len() - printed.len() } else { place };
        parts.iter_mut().for_each(|(known, _)| *known = shift(known.start)..shift(known.end));
        parts.push((range.start..end, Mark::Correction));
    }
    parts.retain(|(range, _)| !range.is_empty());
    let (printed, read) = match rest.is_empty() {
        true => first.clone(),
        false => (String::new(), String::new()),
    };
    Some(Correction { printed, read, corrected: Some((text, parts)) })
}

/// A repair as a correction.
pub(super) fn repair(repair: &Repair, display: Option<&Display>, printed: &str) -> Correction {
    let corrected = display.and_then(|display| {
        let range = own(repair, display)?;
        let mut text = display.text.clone();
        text.get(range.clone())?;
        text.replace_range(range.clone(), &repair.replacement);
        let parts = [(range.start..range.start + repair.replacement.len(), Mark::Correction)];
        Some((text, parts.into_iter().filter(|(range, _)| !range.is_empty()).collect()))
    });
    Correction { printed: printed.to_owned(), read: repair.replacement.clone(), corrected }
}

/// The place of a repair in its display.
fn own(repair: &Repair, display: &Display) -> Option<Range<usize>> {
    let (span, body) = (repair.span, display.body);
    body.contains(span).then(|| span.start - body.start..span.end - body.start)
}

/// What an edit changes of a text: the printed words without those at its start and its end that stay.
fn changed(text: &str, printed: &str, read: &str) -> Option<Range<usize>> {
    let at = text.find(printed)?;
    let words = |text: &str| -> Vec<usize> { text.split_inclusive(' ').map(str::len).collect() };
    let (mut start, mut end) = (0, printed.len());
    for length in words(printed) {
        match start + length < end && printed.get(..start + length) == read.get(..start + length) {
            true => start += length,
            false => break,
        }
    }
    for word in printed.split(' ').rev() {
        let tail = printed.len() - end + word.len() + 1;
        let ends = |text: &str| text.len().checked_sub(tail).and_then(|from| text.get(from..)).map(str::to_owned);
        if end < start + word.len() + 2
            || read.len() < start + tail
            || ends(printed).is_none()
            || ends(printed) != ends(read)
        {
            break;
        }
        end -= word.len() + 1;
    }
    Some(at + start..at + end)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(text: &str, printed: &str, read: &str) -> String {
        changed(text, printed, read).map(|range| text[range].to_owned()).unwrap_or_default()
    }

    #[test]
    fn the_words_around_a_change_are_left_out() {
        assert_eq!(part("a + \\frac{1}{2} b", "+ \\frac{1}{2}", "- \\frac{1}{2}"), "+");
        assert_eq!(part("m_i \\vec{r}_i = 0", "m_i \\vec{r}_i =", "m_i \\vec{\\bar r}_i ="), "\\vec{r}_i");
        assert_eq!(part("x = y", "x", "z"), "x");
        assert_eq!(part("x = y", "w", "z"), "");
    }
}
