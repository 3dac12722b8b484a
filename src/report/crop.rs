//! Lines of source cut down to a width, around the places in them that are marked.

use std::ops::Range;

use super::style::columns_of;

/// Stands for what is cut off.
const ELLIPSIS: &str = "…";

/// The least columns in which a mark can be recognised.
const LEAST: usize = 6;

/// Lines of a source, cut down.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Cropped {
    /// The lines that are shown.
    pub text: String,
    /// What is kept, in order: the bytes of the source, and where they begin in `text`.
    kept: Vec<(Range<usize>, usize)>,
}

impl Cropped {
    /// The lines, each of at most `room` columns.
    ///
    /// A line that is wider shows what is marked, with as much around it as there is room for, and an ellipsis for the
    /// rest. A mark that is itself wider shows its beginning; several marks share the line.
    pub(super) fn new(lines: &str, marks: &[Range<usize>], room: usize) -> Cropped {
        let mut cropped = Cropped { text: String::new(), kept: Vec::new() };
        let mut start = 0;
        for (number, line) in lines.split('\n').enumerate() {
            if number > 0 {
                cropped.text.push('\n');
            }
            let end = start + line.len();
            let own = marks.iter().filter(|mark| mark.start <= end && start <= mark.end);
            let own: Vec<Range<usize>> =
                own.map(|mark| mark.start.max(start) - start..mark.end.min(end) - start).collect();
            let windows = windows(line, &own, room);
            for (at, window) in windows.iter().enumerate() {
                if at > 0 || window.start > 0 {
                    cropped.text.push_str(ELLIPSIS);
                }
                cropped.kept.push((start + window.start..start + window.end, cropped.text.len()));
                cropped.text.push_str(&line[window.clone()]);
            }
            if windows.last().is_some_and(|last| last.end < line.len()) {
                cropped.text.push_str(ELLIPSIS);
            }
            start = end + 1;
        }
        cropped
    }

    /// Where a range of the source is in the text that is shown. An end of it that is cut off is at an ellipsis.
    pub(super) fn shown(&self, range: &Range<usize>) -> Range<usize> {
        let inside = |at: usize| {
            let (kept, start) = self.kept.iter().find(|(kept, _)| kept.start <= at && at <= kept.end)?;
            Some(start + at - kept.start)
        };
        let before = |at: usize| self.kept.iter().rev().find(|(kept, _)| kept.end <= at);
        let start =
            inside(range.start).unwrap_or_else(|| before(range.start).map_or(0, |(kept, start)| start + kept.len()));
        let end = inside(range.end)
            .unwrap_or_else(|| before(range.end).map_or(0, |(kept, start)| start + kept.len() + ELLIPSIS.len()));
        start..end.max(start).min(self.text.len())
    }
}

/// The parts of a line to keep, in order and apart from each other.
fn windows(line: &str, marks: &[Range<usize>], room: usize) -> Vec<Range<usize>> {
    let wide = |range: Range<usize>| line[range].chars().map(columns_of).sum::<usize>();
    if wide(0..line.len()) <= room {
        return std::iter::once(0..line.len()).collect();
    }
    let start = std::slice::from_ref(&(0..0));
    let marks = if marks.is_empty() { start } else { marks };
    // Too many marks for one line: the first of them is shown.
    let marks = if room / marks.len() < LEAST { &marks[..1] } else { marks };
    // Each part has an ellipsis at either end.
    let share = (room / marks.len()).saturating_sub(2).max(1);
    let mut windows: Vec<Range<usize>> = Vec::new();
    for mark in marks {
        let own = wide(mark.clone());
        let around = share.saturating_sub(own);
        let ahead = wide(0..mark.start);
        let behind = wide(mark.end..line.len());
        // What one side does not need, the other has.
        let left = ahead.min((around / 2).max(around.saturating_sub(behind)));
        let first = back(line, mark.start, left);
        windows.push(first..on(line, first, share));
    }
    windows.sort_by_key(|window| window.start);
    let mut apart: Vec<Range<usize>> = Vec::new();
    for window in windows {
        match apart.last_mut() {
            Some(last) if window.start <= last.end + ELLIPSIS.len() => last.end = last.end.max(window.end),
            _ => apart.push(window),
        }
    }
    apart
}

/// The byte at most so many columns before another.
fn back(line: &str, from: usize, columns: usize) -> usize {
    let mut used = 0;
    let mut at = from;
    for (start, c) in line[..from].char_indices().rev() {
        used += columns_of(c);
        if used > columns {
            break;
        }
        at = start;
    }
    // A combining mark stays with its letter.
    while line[at..].chars().next().is_some_and(|c| columns_of(c) == 0) {
        at += line[at..].chars().next().map_or(0, char::len_utf8);
    }
    at
}

/// The byte at most so many columns after another.
fn on(line: &str, from: usize, columns: usize) -> usize {
    let mut used = 0;
    for (start, c) in line[from..].char_indices() {
        used += columns_of(c);
        if used > columns {
            return from + start;
        }
    }
    line.len()
}

#[cfg(test)]
mod tests {
    use super::super::style::columns;
    use super::*;

    fn long() -> String {
        (0..60).map(|n| format!("{:03} ", n)).collect()
    }

    #[test]
    fn a_line_that_fits_is_kept() {
        let cropped = Cropped::new("a = b\nc = d", std::slice::from_ref(&(6..7)), 20);
        assert_eq!((cropped.text.as_str(), cropped.shown(&(6..7))), ("a = b\nc = d", 6..7));
    }

    #[test]
    fn what_is_marked_is_shown_wherever_it_is() {
        let line = long();
        for start in 0..line.len() - 3 {
            let mark = start..start + 3;
            let cropped = Cropped::new(&line, std::slice::from_ref(&mark), 40);
            assert!(columns(&cropped.text) <= 40, "{}", cropped.text);
            assert_eq!(&cropped.text[cropped.shown(&mark)], &line[mark.clone()], "{}", cropped.text);
            // The room is used.
            assert!(columns(&cropped.text) >= 37, "{}", cropped.text);
        }
    }

    #[test]
    fn a_mark_that_is_too_wide_shows_its_beginning() {
        let line = long();
        let cropped = Cropped::new(&line, std::slice::from_ref(&(20..200)), 40);
        assert!(columns(&cropped.text) <= 40, "{}", cropped.text);
        let shown = cropped.shown(&(20..200));
        assert!(cropped.text[shown.clone()].starts_with("005 006 "), "{}", cropped.text);
        assert!(cropped.text[shown].ends_with('…'), "{}", cropped.text);
    }

    #[test]
    fn several_marks_share_a_line() {
        let line = long();
        let marks = [4..7, 120..123, 200..203];
        let cropped = Cropped::new(&line, &marks, 60);
        assert!(columns(&cropped.text) <= 60, "{}", cropped.text);
        for mark in &marks {
            assert_eq!(&cropped.text[cropped.shown(mark)], &line[mark.clone()]);
        }
        assert_eq!(cropped.text.matches('…').count(), 3, "{}", cropped.text);
    }

    #[test]
    fn each_line_of_several_is_cut() {
        let lines = format!("{}\n{}\nend", long(), long());
        let mark = 100..lines.len() - 1;
        let cropped = Cropped::new(&lines, std::slice::from_ref(&mark), 40);
        assert!(cropped.text.lines().all(|line| columns(line) <= 40), "{}", cropped.text);
        assert_eq!(cropped.text.lines().count(), 3);
        assert!(cropped.text[cropped.shown(&mark)].starts_with("025 "), "{}", cropped.text);
        assert!(cropped.text[cropped.shown(&mark)].ends_with("en"), "{}", cropped.text);
    }

    #[test]
    fn no_mark_is_parted_from_its_letter() {
        let line = "θ\u{307}+".repeat(80);
        for start in (0..line.len()).filter(|at| line.is_char_boundary(*at)) {
            let cropped = Cropped::new(&line, std::slice::from_ref(&(start..start)), 40);
            let first = cropped.text.trim_start_matches('…').chars().next();
            assert!(first.is_some_and(|c| c != '\u{307}') && columns(&cropped.text) <= 40, "{}", cropped.text);
        }
    }
}
