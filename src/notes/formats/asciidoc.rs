//! AsciiDoc: the blocks `[latexmath]` and `[stem]`, and their inline macros.

use std::path::Path;
use std::sync::Arc;

use super::blocks::{self, trimmed};
use super::{Format, View, alone};
use crate::Result;
use crate::notes::kind::Kind;
use crate::source::{Builder, Source, Span};

pub(super) const FORMAT: Format =
    Format { extensions: &["adoc", "asciidoc"], kind: Kind::Markdown, is_code: false, view };

/// A delimited block of these is no prose.
const VERBATIM: [&str; 3] = ["----", "....", "////"];

fn view(file: &Arc<Source>, _: &Path) -> Result<View> {
    let text = &file.text;
    let mut view = Builder::new(file.clone());
    let lines = blocks::lines(text, Span::new(0, text.len()));
    let words = |at: usize| lines.get(at).map(|line| text[line.range()].trim());
    // Without this attribute, `stem` is AsciiMath.
    let stem_is_latex =
        (0..lines.len()).any(|at| words(at).is_some_and(|line| line.replace(' ', "") == ":stem:latexmath"));
    let mut label = None;
    let mut at = 0;
    while let Some(line) = words(at) {
        let close =
            |at: usize, mark: &str| (at..lines.len()).find(|other| words(*other) == Some(mark)).unwrap_or(lines.len());
        if let Some(name) = line.strip_prefix("[[").and_then(|rest| rest.strip_suffix("]]")) {
            label = Some(name);
        }
        let attributes = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or_default();
        let style = attributes.split(['#', '%', '.', ',']).next().unwrap_or_default().trim();
        // A title may stand between the attributes and the block.
        let open = (at + 1..lines.len().min(at + 4)).find(|other| words(*other) == Some("++++"));
        if let (Some(open), "latexmath" | "stem" | "asciimath") = (open, style) {
            let end = close(open + 1, "++++");
            let id = attributes.split(['%', '.', ',']).next().and_then(|word| word.split_once('#')).map(|(_, id)| id);
            let body: Vec<Span> = lines[open + 1..end].iter().map(|line| trimmed(text, *line)).collect();
            let is_latex = style == "latexmath"
                || (style == "stem" && stem_is_latex)
                || body.iter().any(|line| text[line.range()].contains('\\'));
            let copy = if is_latex { Builder::copy } else { asciimath };
            blocks::display(&mut view, lines[at], &body, id.or(label.take()), copy);
            label = None;
            at = end + 1;
            continue;
        }
        if let Some(mark) = VERBATIM.iter().find(|mark| **mark == line) {
            at = close(at + 1, mark) + 1;
            continue;
        }
        if !line.is_empty() && !line.starts_with('[') && !line.starts_with('.') {
            label = None;
        }
        let own = trimmed(text, lines[at]);
        match blocks::marked_heading(line, '=') {
            Some((level, length)) => {
                let words = Span::new(own.start + length, own.end);
                blocks::heading(&mut view, Span::new(own.start, words.start), level);
                prose(&mut view, text, words, stem_is_latex);
            }
            None if is_setting(line) => {}
            None => prose(&mut view, text, own, stem_is_latex),
        }
        view.written(Span::at(lines[at].end), "\n");
        at += 1;
    }
    alone(view.finish(blocks::as_latex))
}

/// Whether a line is for the program that shows the document: an attribute, or the style or name of a block.
fn is_setting(line: &str) -> bool {
    let is_attribute = line.strip_prefix(':').and_then(|rest| rest.split_once(':')).is_some_and(|(name, _)| {
        !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '!'))
    });
    is_attribute || (line.starts_with('[') && line.ends_with(']'))
}

/// AsciiMath is not LaTeX, though some of it looks alike. So it must not be read as LaTeX.
fn asciimath(view: &mut Builder, line: Span) {
    view.written(Span::at(line.start), "\\AsciiMath ");
    view.copy(line);
}

/// Prose, with its inline mathematics between dollar signs.
fn prose(view: &mut Builder, text: &str, line: Span, stem_is_latex: bool) {
    let mut from = line.start;
    loop {
        let rest = &text[from..line.end];
        let macros = ["latexmath:[", "stem:["].into_iter().take(if stem_is_latex { 2 } else { 1 });
        let Some((open, start)) =
            macros.filter_map(|name| rest.find(name).map(|at| (from + at, from + at + name.len()))).min()
        else {
            break;
        };
        let Some(close) = text[start..line.end].find(']').map(|at| start + at) else { break };
        view.prose(Span::new(from, open));
        view.written(Span::new(open, start), "$");
        view.copy(Span::new(start, close));
        view.written(Span::new(close, close + 1), "$");
        from = close + 1;
    }
    view.prose(Span::new(from, line.end));
}
