//! Which part of the notes a letter keeps its meaning in.
//!
//! Authors use a letter again in a later section: T is a period, then a kinetic energy. A scope is a run of sections. It
//! ends where a later section gives a known letter a formula that does not follow; from there the names are inferred
//! anew. It ends as well, before anything is judged, with a section that gives another Lagrangian or several known
//! letters a formula. A definition before the scope holds in it, if the scope uses its name and does not define it again.

use std::collections::HashSet;
use std::ops::Range;

use crate::check::document::setup::{Run, define_macros};
use crate::check::unaided::scope::Scope;
use crate::check::usage::{Usage, names_of};
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::{Display, Notes};

/// The number of displays after which a scope ends with its section. What is read ahead is read again in the next scope.
const LONGEST: usize = 40;

/// The number of displays after which a scope ends where there is no section.
const WITHOUT_SECTIONS: usize = 120;

/// The number of displays after which a scope ends with its chapter.
const SHORT: usize = 12;

/// The level of a heading that does not say its level.
const LOWEST: usize = 9;

/// The level of bold words with which a paragraph begins: "**4. Dipole.** From the potential …".
const RUN_IN: usize = 10;

/// The most definitions that are carried over from before a scope.
const CARRIED: usize = 60;

/// How far back definitions are sought.
const FAR_BACK: usize = 480;

/// The number of letters with a new formula that begin a new scope.
const RENEWED: usize = 3;

/// The names in one display.
struct Named {
    /// Those that it gives a formula.
    introduced: Vec<Name>,
    /// All of them.
    used: Vec<Name>,
    /// Those with a dot, or under d/dt.
    moving: Vec<Name>,
}

/// The names in the displays of notes, and where sections begin.
pub(crate) struct Outline {
    names: Vec<Named>,
    /// The displays with which a section begins, and those with which a chapter begins.
    sections: Vec<usize>,
    chapters: HashSet<usize>,
}

impl Outline {
    /// The outline of notes.
    pub fn of(notes: &Notes) -> Outline {
        let mut macros = Macros::default();
        define_macros(&notes.macros, &mut macros);
        let named = |display: &Display| {
            let usages = names_of(std::slice::from_ref(display), &macros);
            let is_introduced = |usage: &&Usage| usage.introduced.is_some();
            Named {
                introduced: usages.iter().filter(is_introduced).map(|usage| usage.name.clone()).collect(),
                used: usages.iter().map(|usage| usage.name.clone()).collect(),
                moving: usages.iter().filter(|usage| usage.moves).map(|usage| usage.name.clone()).collect(),
            }
        };
        let found = sections(notes);
        // Where there are headings below those of the highest level, the latter are those of chapters.
        let highest = found.iter().map(|(_, level)| *level).min();
        let has_lower = found.iter().any(|(_, level)| Some(*level) > highest && *level < RUN_IN);
        let chapters = found.iter().filter(|(_, level)| has_lower && Some(*level) == highest);
        Outline {
            names: notes.equations.iter().map(named).collect(),
            chapters: chapters.map(|(at, _)| *at).collect(),
            sections: found.into_iter().map(|(at, _)| at).collect(),
        }
    }

    /// The last display before the `first`-th one that gives a name the formula which this one replaces.
    fn of_renewed_function(&self, first: usize) -> Option<usize> {
        let renewed = &self.names.get(first)?.introduced;
        (0..first).rev().find(|at| self.names[*at].introduced.iter().any(|name| renewed.contains(name)))
    }

    /// The display at which the scope that begins with the `first`-th display ends.
    fn end(&self, first: usize) -> usize {
        let all = self.names.len().min(first + WITHOUT_SECTIONS);
        let starts: Vec<usize> =
            self.sections.iter().copied().filter(|start| *start > first && *start < all).chain([all]).collect();
        let mut known: Vec<&Name> = self.names[first..starts[0]].iter().flat_map(|named| &named.introduced).collect();
        for (start, next) in starts.iter().zip(&starts[1..]) {
            let here = || self.names[*start..*next].iter().flat_map(|named| &named.introduced);
            let renewed: HashSet<&Name> = here().filter(|name| known.contains(name)).collect();
            let is_lagrangian = |name: &&Name| ["L", "\\mathcal{L}"].contains(&name.base.as_str());
            let is_chapter = self.chapters.contains(start) && *start >= first + SHORT;
            if is_chapter || *start >= first + LONGEST || renewed.len() >= RENEWED || renewed.iter().any(is_lagrangian)
            {
                return *start;
            }
            known.extend(here());
        }
        all
    }
}

/// The places of the displays with which a section begins, each with the level of its heading.
fn sections(notes: &Notes) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    let mut displays = notes.equations.iter().enumerate().peekable();
    for (heading, level) in headings(&notes.source.text) {
        let mut is_inside = false;
        while let Some((_, display)) = displays.next_if(|(_, display)| display.span.start < heading) {
            is_inside = display.span.end > heading;
        }
        // A row of a display may look like the line under a heading.
        if is_inside {
            continue;
        }
        match (displays.peek(), found.last_mut()) {
            (Some((at, _)), Some((last, above))) if last == at => *above = level.min(*above),
            (Some((at, _)), _) => found.push((*at, level)),
            (None, _) => {}
        }
    }
    found
}

/// The places of headings in a text, with their levels: of Markdown, as which other formats are read, and of TeX.
fn headings(text: &str) -> Vec<(usize, usize)> {
    let (mut found, mut start, mut before) = (Vec::new(), 0, "");
    for line in text.split_inclusive('\n') {
        let content = line.trim();
        let is_underline = content.len() >= 3
            && content.starts_with(['=', '-'])
            && content.bytes().all(|byte| content.starts_with(char::from(byte)))
            && before.len() > 1
            && before.len() <= content.len();
        let marked = content.trim_start_matches('#');
        let is_marked = marked.len() < content.len() && content.len() - marked.len() <= 6 && marked.starts_with(' ');
        let commands = ["\\part{", "\\chapter{", "\\section{", "\\subsection{", "\\subsubsection{"];
        let plain = content.replace('*', "");
        let command = commands.iter().position(|command| plain.starts_with(command));
        let environments = ["\\begin{exercise", "\\begin{problem", "\\begin{example", "\\begin{solution"];
        let is_exercise = environments.iter().any(|begin| content.starts_with(begin));
        let level = match command {
            Some(level) => Some(level + 1),
            None if is_marked => Some(content.len() - marked.len()),
            None if is_underline || is_exercise => Some(LOWEST),
            None => (before.is_empty() && is_run_in(content)).then_some(RUN_IN),
        };
        found.extend(level.map(|level| (start, level)));
        (start, before) = (start + line.len(), content);
    }
    found
}

/// Whether a paragraph that begins with this line begins with a heading of its own.
fn is_run_in(line: &str) -> bool {
    let line = line.trim_start_matches("\\noindent").trim_start();
    let is_bold = line.strip_prefix("**").is_some_and(|rest| rest.contains("**"));
    is_bold
        || ["\\textbf{", "\\paragraph{", "\\subparagraph{"]
            .iter()
            .any(|command| line.replace('*', "").starts_with(command))
}

/// The scope that begins with the `first`-th display, and the notes with its displays only, after those that are carried over.
pub(crate) fn from(run: &Run<'_>, notes: &Notes, first: usize, outline: &Outline) -> (Notes, Scope) {
    let end = if run.only.is_some() { notes.equations.len() } else { outline.end(first) };
    let inside = &outline.names[first..end];
    let mut known: HashSet<&Name> = inside.iter().flat_map(|named| &named.introduced).collect();
    let mut used: HashSet<&Name> = inside.iter().flat_map(|named| &named.used).collect();
    let moving: HashSet<&Name> = inside.iter().flat_map(|named| &named.moving).collect();
    let mut carried: Vec<usize> = Vec::new();
    let before = outline.of_renewed_function(first);
    for at in (0..first).rev().take(FAR_BACK) {
        let Named { introduced, used: needs, .. } = &outline.names[at];
        let is_wanted = introduced.iter().any(|name| used.contains(name));
        // A coordinate of the scope is not given by names of another one: φ = θ − θ₀, where the scope has φ̇ and no θ.
        let is_coordinate = introduced.iter().any(|name| moving.contains(name));
        let is_foreign = is_coordinate && !needs.iter().any(|name| !introduced.contains(name) && used.contains(name));
        // A place r_m that was found with another formula for U(r) is another one with this.
        let is_place = |name: &Name| {
            let axis = Name { subscript: Vec::new(), ..name.clone() };
            !name.subscript.is_empty() && outline.names[first].used.contains(&axis)
        };
        let is_of_before = before.is_some_and(|old| at > old) && introduced.iter().any(is_place);
        if is_wanted
            && !is_foreign
            && !is_of_before
            && introduced.iter().all(|name| !known.contains(name))
            && carried.len() < CARRIED
        {
            carried.insert(0, at);
            known.extend(introduced);
            used.extend(needs);
        }
    }
    let displays = carried.iter().map(|at| &notes.equations[*at]).chain(&notes.equations[first..end]);
    let equations: Vec<Display> = displays.cloned().collect();
    let inside: Range<usize> = first..end;
    let offset = |start: &usize| start - first + carried.len();
    let starts = outline.sections.iter().filter(|start| inside.contains(start)).map(offset).collect();
    let mut notes = notes.clone();
    notes.equations = equations;
    (notes, Scope { carried: carried.len(), sections: starts, links: Vec::new() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_of_each_format_are_found_and_rules_are_not() {
        assert_eq!(headings("# A\n\ntext\n## B\n"), [(0, 1), (10, 2)]);
        assert_eq!(headings("text\n\\section*{A}\n"), [(5, 3)]);
        assert_eq!(headings("Name\n----\n"), [(5, LOWEST)]);
        assert_eq!(headings("text\n\n**2. Dipole.** The field\n"), [(6, RUN_IN)]);
        assert_eq!(headings("\\paragraph{Force}\n"), [(0, RUN_IN)]);
        assert!(headings("text\n\n---\n#tag\n= 3\n").is_empty());
        assert!(headings("a\n**b** c\n\nthe **d** e\n").is_empty());
        assert!(headings("a = b\n").is_empty());
    }
}
