//! reStructuredText: the directive `.. math::` and the role `:math:`.

use std::path::Path;
use std::sync::Arc;

use super::blocks::{self, indent, trimmed};
use super::{Format, View, alone};
use crate::Result;
use crate::notes::kind::Kind;
use crate::source::{Builder, Source, Span};

pub(super) const FORMAT: Format = Format { extensions: &["rst"], kind: Kind::Markdown, is_code: false, view };

fn view(file: &Arc<Source>, _: &Path) -> Result<View> {
    let mut view = Builder::new(file.clone());
    let lines = blocks::lines(&file.text, Span::new(0, file.text.len()));
    write(&mut view, &file.text, &lines, Builder::copy);
    alone(view.finish(blocks::as_latex))
}

/// Writes the prose and the displays of these lines. `copy` copies mathematics.
pub(super) fn write(view: &mut Builder, text: &str, lines: &[Span], copy: fn(&mut Builder, Span)) {
    let mut at = 0;
    // The lines that are drawn under titles, and whether also above them, by the level of the title.
    let mut styles: Vec<(char, bool)> = Vec::new();
    while let Some(&line) = lines.get(at) {
        if let Some((title, style, length)) = heading(text, &lines[at..]) {
            let level = styles.iter().position(|known| *known == style).unwrap_or_else(|| {
                styles.push(style);
                styles.len() - 1
            });
            blocks::heading(view, Span::at(title.start), level + 1);
            prose(view, text, title, copy);
            view.written(Span::at(lines[at + length - 1].end), "\n\n");
            at += length;
            continue;
        }
        at += 1;
        let own = trimmed(text, line);
        let Some(argument) = text[own.range()].strip_prefix(".. math::") else {
            // A target of links, as `.. _name:`, is no prose.
            if !text[own.range()].starts_with(".. _") {
                prose(view, text, own, copy);
            }
            view.written(Span::at(line.end), "\n");
            if is_before_literal(&text[own.range()]) {
                let depth = indent(text, line);
                let is_inside = |line: &&Span| trimmed(text, **line).range().is_empty() || indent(text, **line) > depth;
                let inside = lines[at..].iter().take_while(is_inside);
                at += inside.map(|line| view.written(Span::at(line.end), "\n")).count();
            }
            continue;
        };
        let depth = indent(text, line);
        let is_inside = |line: Span| trimmed(text, line).range().is_empty() || indent(text, line) > depth;
        let length = lines[at..].iter().take_while(|line| is_inside(**line)).count();
        let inside = &lines[at..at + length];
        at += length;
        let mut label = None;
        let mut groups: Vec<Vec<Span>> = vec![Vec::new()];
        if !argument.trim().is_empty() {
            groups[0].push(trimmed(text, Span::new(own.end - argument.len(), own.end)));
        }
        for line in inside.iter().map(|line| trimmed(text, *line)) {
            let words = &text[line.range()];
            match words.strip_prefix(":label:").or_else(|| words.strip_prefix(":name:")) {
                Some(name) => label = Some(name.trim()),
                None if words.starts_with(":nowrap:")
                    || words.starts_with(":no-wrap:")
                    || words.starts_with(":class:") => {}
                None if words.is_empty() => groups.push(Vec::new()),
                None => groups.last_mut().into_iter().for_each(|group| group.push(line)),
            }
        }
        // A blank line within an environment separates nothing.
        let mut joined: Vec<Vec<Span>> = Vec::new();
        for group in groups.into_iter().filter(|group| !group.is_empty()) {
            let is_open = joined.last().is_some_and(|last| {
                let count =
                    |mark: &str| last.iter().map(|line| text[line.range()].matches(mark).count()).sum::<usize>();
                count("\\begin{") > count("\\end{")
            });
            match joined.last_mut().filter(|_| is_open) {
                Some(last) => last.extend(group),
                None => joined.push(group),
            }
        }
        for (n, group) in joined.iter().enumerate() {
            let open = if n == 0 { own } else { group[0] };
            blocks::display(view, open, group, label.filter(|_| n == 0), copy);
        }
    }
}

/// A title at the start of these lines: its words, how it is underlined, and the number of its lines.
fn heading(text: &str, lines: &[Span]) -> Option<(Span, (char, bool), usize)> {
    let words = |at: usize| lines.get(at).map(|line| text[line.range()].trim_end());
    let rule = |at: usize| {
        let line = words(at)?;
        let first = line.chars().next().filter(char::is_ascii_punctuation)?;
        (line.len() >= 3 && line.chars().all(|c| c == first)).then_some((first, line.len()))
    };
    let is_title = |at: usize, length: usize| {
        words(at).is_some_and(|words| !words.is_empty() && words.trim_start().chars().count() <= length)
    };
    match (rule(0), rule(1), rule(2)) {
        (Some((mark, length)), None, Some((under, _))) if mark == under && is_title(1, length) => {
            Some((trimmed(text, lines[1]), (mark, true), 3))
        }
        (None, Some((mark, length)), _) if is_title(0, length) && !words(0)?.starts_with(' ') => {
            Some((trimmed(text, lines[0]), (mark, false), 2))
        }
        _ => None,
    }
}

/// Whether the indented lines after this one are code, or another text that is printed as it stands.
fn is_before_literal(line: &str) -> bool {
    const DIRECTIVES: [&str; 5] =
        [".. code", ".. sourcecode::", ".. parsed-literal::", ".. highlight::", ".. prompt::"];
    match line.starts_with("..") {
        true => DIRECTIVES.iter().any(|directive| line.starts_with(directive)),
        false => line.ends_with("::"),
    }
}

/// Prose, with its inline mathematics between dollar signs.
fn prose(view: &mut Builder, text: &str, line: Span, copy: fn(&mut Builder, Span)) {
    const ROLE: &str = ":math:`";
    let mut from = line.start;
    while let Some(open) = text[from..line.end].find(ROLE).map(|at| from + at) {
        let start = open + ROLE.len();
        let Some(close) = text[start..line.end].find('`').map(|at| start + at) else { break };
        view.prose(Span::new(from, open));
        view.written(Span::new(open, start), "$");
        copy(view, Span::new(start, close));
        view.written(Span::new(close, close + 1), "$");
        from = close + 1;
    }
    view.prose(Span::new(from, line.end));
}
