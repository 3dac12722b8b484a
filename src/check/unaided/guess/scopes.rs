//! Which part of the notes a letter keeps its meaning in.
//!
//! Authors use a letter again in a later section: T is a period, then a kinetic energy. A scope is a run of sections. It
//! ends where a later section gives a known letter a formula that does not follow; from there the names are inferred
//! anew. It ends as well, before anything is judged, with a section that gives another Lagrangian or several known
//! letters a formula, with an example that gives a letter of an earlier example another formula, and where another system
//! begins (`systems`). A definition before the scope holds in it, if the scope uses its name and does not define it again, and if
//! it is of the same system or stands before all of them.

use std::collections::HashSet;
use std::ops::Range;

use crate::check::document::inferred::open_energies::{self, is_energy};
use crate::check::document::setup::define_macros;
use crate::check::unaided::guess::headings::{self, Mark, RUN_IN};
use crate::check::unaided::guess::lagrangian::is_lagrangian;
use crate::check::unaided::guess::named::Named;
use crate::check::unaided::guess::systems;
use crate::check::unaided::scope::Scope;
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::{Display, Notes};

/// The number of displays after which a scope ends with its section. What is read ahead is read again in the next scope.
const LONGEST: usize = 40;

/// The number of displays after which a scope ends where there is no section.
const WITHOUT_SECTIONS: usize = 120;

/// The number of displays after which a scope ends with its chapter.
const SHORT: usize = 12;

/// The most definitions that are carried over from before a scope.
const CARRIED: usize = 60;

/// How far back definitions are sought.
const FAR_BACK: usize = 480;

/// How many bytes before the first display of a scope a sentence may begin that is about it.
const NEAR: usize = 400;

/// The number of letters with a new formula that begin a new scope.
const RENEWED: usize = 3;

/// The names in the displays of notes, and where sections begin.
pub(crate) struct Outline {
    names: Vec<Named>,
    /// The displays with which a section begins, and those with which a chapter begins.
    sections: Vec<usize>,
    chapters: HashSet<usize>,
    /// The same, with what begins there.
    marks: Vec<Mark>,
    /// The displays with which a system begins.
    systems: Vec<usize>,
    macros: Macros,
}

impl Outline {
    /// The outline of notes.
    pub fn of(notes: &Notes) -> Outline {
        let mut macros = Macros::default();
        define_macros(&notes.macros, &mut macros);
        let marks = headings::marks(notes);
        let found: Vec<&Mark> = marks.iter().filter(|mark| mark.begins_a_section()).collect();
        // Where there are headings below those of the highest level, the latter are those of chapters.
        let highest = found.iter().map(|mark| mark.level).min();
        let has_lower = found.iter().any(|mark| Some(mark.level) > highest && mark.level < RUN_IN);
        let chapters = found.iter().filter(|mark| has_lower && Some(mark.level) == highest);
        let names: Vec<Named> = notes.equations.iter().map(|display| Named::of(display, &macros)).collect();
        Outline {
            chapters: chapters.map(|mark| mark.at).collect(),
            sections: found.iter().map(|mark| mark.at).collect(),
            systems: systems::starts(notes, &names, &marks),
            marks: found.into_iter().copied().collect(),
            names,
            macros,
        }
    }

    /// The last display before the `first`-th one that gives a name the formula which this one replaces.
    fn of_renewed_function(&self, first: usize) -> Option<usize> {
        let renewed = &self.names.get(first)?.introduced;
        (0..first).rev().find(|at| self.names[*at].introduced.iter().any(|name| renewed.contains(name)))
    }

    /// The display at which the scope that begins with the `first`-th display ends.
    fn end(&self, first: usize) -> usize {
        let next = self.systems.iter().skip(1).copied().find(|start| *start > first);
        let all = next.unwrap_or(self.names.len()).min(first + WITHOUT_SECTIONS);
        let starts: Vec<usize> =
            self.sections.iter().copied().filter(|start| *start > first && *start < all).chain([all]).collect();
        let mut known: Vec<&Name> = self.names[first..starts[0]].iter().flat_map(|named| &named.introduced).collect();
        for (start, next) in starts.iter().zip(&starts[1..]) {
            let here = || self.names[*start..*next].iter().flat_map(|named| &named.introduced);
            let renewed: HashSet<&Name> = here().filter(|name| known.contains(name)).collect();
            let is_another_example =
                self.siblings(*start).any(|earlier| earlier >= first && self.renews(earlier, (*start, *next)));
            let is_chapter = self.chapters.contains(start) && *start >= first + SHORT;
            let is_renewed =
                renewed.len() >= RENEWED || renewed.iter().any(|name| is_lagrangian(name)) || is_another_example;
            if is_chapter || *start >= first + LONGEST || is_renewed {
                return *start;
            }
            known.extend(here());
        }
        all
    }

    /// The earlier examples of the same section, by their first displays, if an example begins with a display.
    fn siblings(&self, start: usize) -> impl Iterator<Item = usize> {
        let own = self.marks.iter().find(|mark| mark.at == start).and_then(|mark| Some((mark.level, mark.example?)));
        let is_first = |(level, example): (usize, usize)| level < example;
        let level = own.filter(|own| !is_first(*own)).map_or(0, |(_, level)| level);
        let before = self.marks.iter().rev().filter(move |mark| mark.at < start);
        // A section of a higher level has examples of its own.
        let same = before.take_while(move |mark| mark.level >= level && level > 0);
        same.filter(|mark| mark.example.is_some()).map(|mark| mark.at)
    }

    /// Whether some displays give a name another formula than an earlier example does, the one that begins with the `example`-th display.
    fn renews(&self, example: usize, (start, next): (usize, usize)) -> bool {
        let end = self.sections.iter().copied().find(|start| *start > example).unwrap_or(self.names.len());
        let earlier = || self.names[example..end.min(start)].iter();
        let is_other = |named: &Named, name: &Name| {
            earlier().any(|earlier| earlier.introduced.contains(name) && earlier.printed != named.printed)
        };
        self.names[start..next].iter().any(|named| named.introduced.iter().any(|name| is_other(named, name)))
    }

    /// Whether a display before a scope may hold in it: it is of the same system, or stands before all systems; and it is of no
    /// example that gives a letter another formula than the example does with which the scope begins.
    fn may_hold(&self, at: usize, (first, end): (usize, usize)) -> bool {
        let system = |at: usize| self.systems.iter().rposition(|start| *start <= at);
        let section = |at: usize| self.sections.iter().copied().rfind(|start| *start <= at);
        let next = self.sections.iter().copied().find(|start| *start > first).unwrap_or(end).min(end);
        let example = section(at).filter(|section| self.siblings(first).any(|sibling| sibling == *section));
        (system(at).is_none() || system(at) == system(first))
            && example.is_none_or(|example| !self.renews(example, (first, next)))
    }
}

/// The scope that begins with the `first`-th display, and the notes with its displays only, after those that are carried over.
pub(crate) fn from(notes: &Notes, first: usize, outline: &Outline) -> (Notes, Scope) {
    let end = outline.end(first);
    let inside = &outline.names[first..end];
    let mut known: HashSet<&Name> = inside.iter().flat_map(|named| &named.introduced).collect();
    let mut used: HashSet<&Name> = inside.iter().flat_map(|named| &named.used).collect();
    let moving: HashSet<&Name> = inside.iter().flat_map(|named| &named.moving).collect();
    let mut carried: Vec<usize> = Vec::new();
    let before = outline.of_renewed_function(first);
    for at in (0..first).rev().take(FAR_BACK) {
        let Named { introduced, used: needs, .. } = &outline.names[at];
        // `L = T - V` holds for the energies of the scope.
        let is_sum = introduced.iter().any(is_lagrangian)
            && needs.iter().all(|name| is_lagrangian(name) || is_energy(name) && known.contains(name));
        let is_wanted = introduced.iter().any(|name| used.contains(name)) || is_sum;
        // A coordinate of the scope is not given by names of another one: φ = θ − θ₀, where the scope has φ̇ and no θ.
        let is_coordinate = introduced.iter().any(|name| moving.contains(name));
        let is_foreign = is_coordinate && !needs.iter().any(|name| !introduced.contains(name) && used.contains(name));
        if !outline.may_hold(at, (first, end)) {
            continue;
        }
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
    if outline.systems.len() > 1 {
        notes = without_names_of_others(&notes, outline, carried.len());
    }
    (notes, Scope { carried: carried.len(), sections: starts, links: Vec::new(), evaluated: Vec::new() })
}

/// The notes of a scope, in which each `L = T - V = …` is `L = …`, if T and V have formulas in other systems only.
fn without_names_of_others(notes: &Notes, outline: &Outline, carried: usize) -> Notes {
    let mut own = notes.clone();
    let inside = notes.equations.get(carried..).unwrap_or_default();
    if let (Some(first), Some(last)) = (inside.first(), inside.last()) {
        own.inline.retain(|span| first.span.start <= span.start + NEAR && span.start <= last.span.end);
    }
    let mut read = notes.clone();
    read.equations = open_energies::without_names(&own, &outline.macros, true, &|_| false).into_owned().equations;
    read
}
