//! Which part of the notes a letter keeps its meaning in.
//!
//! Authors use a letter again in a later section: T is a period, then a kinetic energy. A scope is a run of sections. It
//! ends where a later section gives a known letter a formula that does not follow; from there the names are inferred
//! anew. Definitions before the scope still hold in it, unless the scope gives their names a formula again.

use std::ops::Range;

use crate::check::document::setup::{Run, define_macros};
use crate::check::unaided::names::{Usage, names_of};
use crate::check::unaided::scope::Scope;
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::{Display, Notes};

/// The number of displays after which a scope ends with its section. What is read ahead is read again in the next scope.
const LONGEST: usize = 120;

/// The most definitions that are carried over from before a scope.
const CARRIED: usize = 60;

/// The places of the displays with which a section begins.
pub(super) fn sections(notes: &Notes) -> Vec<usize> {
    let mut found = Vec::new();
    let mut displays = notes.equations.iter().enumerate().peekable();
    for heading in headings(&notes.source.text) {
        let mut is_inside = false;
        while let Some((_, display)) = displays.next_if(|(_, display)| display.span.start < heading) {
            is_inside = display.span.end > heading;
        }
        // A row of a display may begin with an equals sign.
        if is_inside {
            continue;
        }
        if let Some((at, _)) = displays.peek()
            && found.last() != Some(at)
        {
            found.push(*at);
        }
    }
    found
}

/// The places of headings in a text: of Markdown, TeX, Typst, AsciiDoc and reStructuredText.
fn headings(text: &str) -> Vec<usize> {
    let (mut found, mut start, mut before) = (Vec::new(), 0, "");
    for line in text.split_inclusive('\n') {
        let content = line.trim();
        let is_underline = content.len() >= 3
            && content.starts_with(['=', '-', '~', '^', '*'])
            && content.bytes().all(|byte| content.starts_with(char::from(byte)))
            && before.len() > 1
            && before.len() <= content.len();
        let marked = content.trim_start_matches(['#', '=']);
        let is_marked = marked.len() < content.len() && content.len() - marked.len() <= 6 && marked.starts_with(' ');
        let commands = ["\\part{", "\\chapter{", "\\section{", "\\subsection{", "\\subsubsection{"];
        let is_command = commands.iter().any(|command| content.replace('*', "").starts_with(command));
        let environments = ["\\begin{exercise", "\\begin{problem", "\\begin{example", "\\begin{solution"];
        if is_underline || is_marked || is_command || environments.iter().any(|begin| content.starts_with(begin)) {
            found.push(start);
        }
        (start, before) = (start + line.len(), content);
    }
    found
}

/// The scope that begins with the `first`-th display, and the notes with its displays only, after those that are carried over.
pub(super) fn from(run: &Run<'_>, notes: &Notes, first: usize, sections: &[usize]) -> (Notes, Scope) {
    let far = sections.iter().copied().find(|start| *start >= first + LONGEST);
    let end = if run.only.is_some() { notes.equations.len() } else { far.unwrap_or(notes.equations.len()) };
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let own = introduced(&notes.equations[first..end], &macros);
    let mut known = own;
    let mut carried: Vec<usize> = Vec::new();
    for at in (0..first).rev().take(4 * LONGEST) {
        let names = introduced(&notes.equations[at..=at], &macros);
        if !names.is_empty() && names.iter().all(|name| !known.contains(name)) && carried.len() < CARRIED {
            carried.insert(0, at);
            known.extend(names);
        }
    }
    let displays = carried.iter().map(|at| &notes.equations[*at]).chain(&notes.equations[first..end]);
    let equations: Vec<Display> = displays.cloned().collect();
    let inside: Range<usize> = first..end;
    let offset = |start: &usize| start - first + carried.len();
    let starts = sections.iter().filter(|start| inside.contains(start)).map(offset).collect();
    let mut notes = notes.clone();
    notes.equations = equations;
    (notes, Scope { carried: carried.len(), sections: starts })
}

/// The names that displays give a formula.
fn introduced(displays: &[Display], macros: &Macros) -> Vec<Name> {
    let is_introduced = |usage: &Usage| usage.introduced.is_some();
    names_of(displays, macros).into_iter().filter(is_introduced).map(|usage| usage.name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_of_each_format_are_found_and_rules_are_not() {
        assert_eq!(headings("# A\n\ntext\n## B\n"), [0, 10]);
        assert_eq!(headings("text\n\\section*{A}\n"), [5]);
        assert_eq!(headings("Name\n----\n"), [5]);
        assert!(headings("text\n\n---\n#tag\n= 3\n").len() == 1);
        assert!(headings("a = b\n").is_empty());
    }
}
