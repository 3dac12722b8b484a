//! Lines of a file, and displays written from them; what the formats share.

use crate::source::{Builder, Span};

/// The levels of headings in Markdown.
const LEVELS: usize = 6;

/// The lines of `within`, without their ends.
pub(super) fn lines(text: &str, within: Span) -> Vec<Span> {
    let mut at = within.start;
    let line = |line: &str| {
        let span = Span::new(at, at + line.trim_end_matches(['\n', '\r']).len());
        at += line.len();
        span
    };
    text.get(within.range()).unwrap_or_default().split_inclusive('\n').map(line).collect()
}

/// A line without the white space on both sides.
pub(super) fn trimmed(text: &str, line: Span) -> Span {
    let own = &text[line.range()];
    let start = line.start + own.len() - own.trim_start().len();
    Span::new(start, start + own.trim().len())
}

/// How deep a line is indented.
pub(super) fn indent(text: &str, line: Span) -> usize {
    trimmed(text, line).start - line.start
}

/// A heading of Markdown in the place of `mark`, which another format writes before a heading. Its words follow.
pub(super) fn heading(view: &mut Builder, mark: Span, level: usize) {
    view.written(mark, &format!("{} ", "#".repeat(level.clamp(1, LEVELS))));
}

/// The level of a heading that one `mark` for each level begins, and how long the marks and the space after them are.
pub(super) fn marked_heading(line: &str, mark: char) -> Option<(usize, usize)> {
    let words = line.trim_start_matches(mark);
    let level = line.len() - words.len();
    let is_heading = (1..=LEVELS).contains(&level) && words.starts_with(' ') && !words.trim().is_empty();
    is_heading.then(|| (level, line.len() - words.trim_start().len()))
}

/// A display: its lines between `$$`, and its label. It begins at the first byte of `open`.
pub(super) fn display(
    view: &mut Builder,
    open: Span,
    body: &[Span],
    label: Option<&str>,
    copy: fn(&mut Builder, Span),
) {
    let end = body.last().map_or(open.end, |line| line.end);
    view.written(open, "\n$$");
    if let Some(label) = label {
        view.written(open, &format!("\\label{{{label}}}"));
    }
    for line in body {
        view.written(Span::at(line.start), "\n");
        copy(view, *line);
    }
    view.written(Span::new(end, end), "\n$$\n\n");
}

/// What this file writes as LaTeX does.
pub(super) fn as_latex(text: &str) -> Option<String> {
    Some(text.to_owned())
}

/// As [`as_latex`], in one line: another line would need the marks of a comment or its indentation.
pub(super) fn in_one_line(text: &str) -> Option<String> {
    (!text.contains('\n')).then(|| text.to_owned())
}
