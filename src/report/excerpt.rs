//! Lines of a file in a diagnostic: which of them are shown, and how much of each.

use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Element, Group, Patch, Renderer, Snippet, Title};

use crate::source::{Source, Span};

use super::crop::Cropped;
use super::style::{Style, columns, columns_of};
use super::wrap::shortened;

/// A span of more lines than this is shown by its first line.
const MOST_LINES: usize = 12;

/// Stands for the path in what is rendered, until the place is put in: the renderer would count columns in lines that are
/// cut down. A character for private use, which no message has.
const PATH: &str = "\u{f0000}";

/// The lines that a span touches.
pub(super) struct Excerpt<'a> {
    /// What the spans are in.
    view: &'a Source,
    /// The file that is shown.
    source: &'a Source,
    /// The bytes of the lines in the source.
    lines: Range<usize>,
    /// The number of the first line.
    first: usize,
    /// What is marked, in bytes of the source.
    span: Range<usize>,
}

/// A place in a file that is marked, with a word on it.
pub(super) struct Mark {
    /// The bytes of the source.
    pub span: Span,
    /// What is said of it; may be empty.
    pub label: String,
}

impl<'a> Excerpt<'a> {
    /// The lines of a span.
    pub(super) fn of(source: &'a Source, span: Span) -> Excerpt<'a> {
        let place = source.place(span);
        let (view, source, span) = (source, place.file, place.span);
        let text = &source.text;
        let (mut from, mut to) = (span.start.min(text.len()), span.end.min(text.len()));
        while !text.is_char_boundary(from) {
            from -= 1;
        }
        while !text.is_char_boundary(to) {
            to += 1;
        }
        let to_trim = &text[from..to.max(from)];
        let trimmed = to_trim.trim();
        if !trimmed.is_empty() {
            from += to_trim.len() - to_trim.trim_start().len();
            to = from + trimmed.len();
        }
        let to = to.max(from);
        let to = if text[from..to].lines().count() > MOST_LINES {
            from + text[from..to].find('\n').unwrap_or(0)
        } else {
            to
        };
        let start = text[..from].rfind('\n').map_or(0, |at| at + 1);
        let end = text[to..].find('\n').map_or(text.len(), |at| to + at);
        let (first, _) = source.line_column(start);
        Excerpt { view, source, lines: start..end, first, span: from..to }
    }

    /// Whether a span lies within the lines that are shown.
    pub(super) fn has(&self, span: Span) -> bool {
        let span = self.view.place(span).span;
        self.lines.start <= span.start && span.end <= self.lines.end
    }

    /// The line in which the span begins, with a line of carets below it, at most so wide; nothing for an empty line.
    pub(super) fn beneath(&self, width: usize) -> Vec<String> {
        let (text, start) = (&self.source.text, self.lines.start);
        let end = text[self.span.start..].find('\n').map_or(text.len(), |at| self.span.start + at);
        let line: Vec<char> = text[start..end].chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let before = text[start..self.span.start].chars().count();
        let marked = text[self.span.start..self.span.end.min(end)].chars().count().max(1);
        // The place stands in the middle, if the line is too long.
        let from = before.saturating_sub(width / 2);
        let is_cut = |at: usize| at == from && from > 0 || at + 1 == from + width && at + 1 < line.len();
        let part = line.iter().enumerate().skip(from).take(width);
        let shown: String = part.map(|(at, c)| if is_cut(at) { '…' } else { *c }).collect();
        if shown.trim().is_empty() {
            return Vec::new();
        }
        let at: usize = line[from..before].iter().map(|c| columns_of(*c)).sum();
        let carets = marked.min(width.saturating_sub(at)).max(1);
        vec![shown.trim_end().to_owned(), format!("{}{}", " ".repeat(at), "^".repeat(carets))]
    }

    /// The lines with the span marked.
    pub(super) fn marked(&self, title: Title<'_>, below: Vec<Element<'_>>, style: Style) -> String {
        self.drawn(title, &[self.inside(self.span.clone().into())], &[String::new()], below, style)
    }

    /// The lines with several marks.
    pub(super) fn with_marks(&self, title: Title<'_>, marks: &[Mark], below: Vec<Element<'_>>, style: Style) -> String {
        let spans: Vec<Range<usize>> = marks.iter().map(|mark| self.within(mark.span)).collect();
        let labels: Vec<String> = marks.iter().map(|mark| mark.label.clone()).collect();
        self.drawn(title, &spans, &labels, below, style)
    }

    fn drawn(
        &self,
        title: Title<'_>,
        spans: &[Range<usize>],
        labels: &[String],
        below: Vec<Element<'_>>,
        style: Style,
    ) -> String {
        let label = labels.iter().map(|label| columns(label)).max().filter(|wide| *wide > 0).map_or(0, |wide| wide + 1);
        let cropped = Cropped::new(self.text(), spans, self.room(style).saturating_sub(label));
        let annotations = labels.iter().zip(spans).map(|(label, span)| {
            let annotation: Annotation<'_> = AnnotationKind::Primary.span(cropped.shown(span));
            if label.is_empty() { annotation } else { annotation.label(label.as_str()) }
        });
        let snippet = Snippet::source(cropped.text.as_str()).line_start(self.first).path(PATH).fold(false);
        let group = title.element(snippet.annotations(annotations)).elements(below);
        self.placed(&renderer(style).render(&[group]))
    }

    /// The lines as they are, and as they are with a span of them replaced.
    pub(super) fn replaced(&self, title: Title<'_>, span: Span, replacement: &str, style: Style) -> String {
        // Where the file cannot be edited so, the edit is shown as LaTeX.
        let (span, replacement) = match self.view.edit(span, replacement) {
            Ok(edit) => (self.inside(edit.place.span), edit.replacement),
            Err(_) => (self.within(span), replacement.to_owned()),
        };
        let room = self.room(style);
        let lines: Vec<String> = replacement.split('\n').map(|line| shortened(line, room / 2)).collect();
        let replacement = lines.join("\n");
        let old = self.text()[span.clone()].split('\n').map(columns).max().unwrap_or(0);
        let longer = lines.iter().map(|line| columns(line)).max().unwrap_or(0).saturating_sub(old);
        let cropped = Cropped::new(self.text(), std::slice::from_ref(&span), room.saturating_sub(longer));
        let patch = Patch::new(cropped.shown(&span), replacement);
        let snippet = Snippet::source(cropped.text.as_str()).line_start(self.first).path(PATH).patch(patch);
        self.placed(&renderer(style).render(&[title.element(snippet)]))
    }

    fn text(&self) -> &'a str {
        &self.source.text[self.lines.clone()]
    }

    /// A span of the view in the lines.
    fn within(&self, span: Span) -> Range<usize> {
        self.inside(self.view.place(span).span)
    }

    /// A span of the file in the lines.
    fn inside(&self, span: Span) -> Range<usize> {
        let inside = |at: usize| at.clamp(self.lines.start, self.lines.end) - self.lines.start;
        inside(span.start)..inside(span.end)
    }

    /// How many columns there are for the source, beside the numbers of its lines and the marks of a span of several.
    fn room(&self, style: Style) -> usize {
        let last = self.first + self.text().matches('\n').count();
        let is_long = self.source.text[self.span.clone()].contains('\n');
        // " | " and the number; of a span of several lines, the bar that holds them together.
        let beside = last.to_string().len() + 3 + if is_long { 3 } else { 0 };
        style.width.saturating_sub(beside)
    }

    /// The rendered text with the place in it: the file, the line and the column of what is marked.
    fn placed(&self, rendered: &str) -> String {
        let (line, column) = self.source.line_column(self.span.start);
        let Some(at) = rendered.find(PATH) else { return rendered.to_owned() };
        let after = &rendered[at + PATH.len()..];
        let rest = after.trim_start_matches(|c: char| c == ':' || c.is_ascii_digit());
        format!("{}{}:{line}:{column}{rest}", &rendered[..at], self.source.path)
    }
}

/// A diagnostic without lines of a file.
pub(super) fn alone(group: Group<'_>, style: Style) -> String {
    renderer(style).render(&[group])
}

/// Draws diagnostics. What is given to it is no wider than the style says; it need not cut anything.
fn renderer(style: Style) -> Renderer {
    let renderer = if style.colour { Renderer::styled() } else { Renderer::plain() };
    renderer.term_width(usize::MAX / 4)
}

#[cfg(test)]
mod tests {
    use annotate_snippets::Level;

    use super::*;

    fn long() -> Source {
        let line: String = (0..80).map(|n| format!("{n:03} ")).collect();
        Source::new("notes.md", format!("first\n{line}\nlast\n"))
    }

    fn fits(text: &str, width: usize) {
        assert!(text.lines().all(|line| columns(line) <= width), "{text}");
    }

    #[test]
    fn the_place_is_that_in_the_file() {
        let source = long();
        for at in [6, 100, 300] {
            for width in [40, 80, 120] {
                let shown = Excerpt::of(&source, Span::new(at, at + 3));
                let text = shown.marked(Level::ERROR.primary_title("x"), Vec::new(), Style::new(width, false));
                fits(&text, width);
                assert!(text.contains(&format!("--> notes.md:2:{}\n", at - 5)), "{text}");
                assert!(text.contains(&source.text[at..at + 3]) && text.contains("^^^"), "{text}");
            }
        }
    }

    #[test]
    fn a_replacement_is_seen_however_long_the_line_and_itself() {
        let source = long();
        for at in [6, 100, 300] {
            for new in ["9", "", &"y z ".repeat(60)] {
                let span = Span::new(at, at + 3);
                let title = Level::HELP.secondary_title("x");
                let text = Excerpt::of(&source, span).replaced(title, span, new, Style::PLAIN);
                fits(&text, 80);
                assert!(text.contains(&source.text[at..at + 3]), "{text}");
                assert!(text.contains(new.get(..3).unwrap_or(new)), "{text}");
            }
        }
    }

    #[test]
    fn a_span_of_several_lines_fits() {
        let source = Source::new("notes.md", long().text.repeat(3));
        let shown = Excerpt::of(&source, Span::new(3, source.text.len() - 2));
        let text = shown.marked(Level::ERROR.primary_title("x"), Vec::new(), Style::PLAIN);
        fits(&text, 80);
        assert!(text.contains("--> notes.md:1:4\n"), "{text}");
    }
}
