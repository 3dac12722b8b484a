//! Where notes begin to treat another system: a chapter of examples, each with a Lagrangian, coordinates and letters of its own.
//!
//! A display that gives the Lagrangian another formula belongs to another system if an example, a heading or a paragraph about
//! another system begins between the two, or if the new formula moves other coordinates and no display relates
//! these to the old ones. The system begins where the example or section does, or with the first display before the
//! formula that is about its coordinates. Where this is unclear a display stays with the system before, with whose coordinates it
//! has nothing in common, so it is taken for granted.
//!
//! Where a Lagrangian stands in an example, each example is a system. Where there are several systems, a section without a Lagrangian
//! may be about one more: its heading is no lower than that of the system before it, and names no step of its treatment.

use std::collections::HashSet;

use crate::check::document::inferred::open_energies::is_energy;
use crate::check::unaided::guess::headings::Mark;
use crate::check::unaided::guess::lagrangian::{is_lagrangian, squares_a_rate};
use crate::check::unaided::guess::named::Named;
use crate::formula::symbols::Name;
use crate::notes::Notes;

/// A system of notes.
struct System<'n> {
    /// Its first display.
    start: usize,
    /// The display that gives its Lagrangian a formula.
    formula: usize,
    /// What moves in the Lagrangian and its energies.
    coordinates: HashSet<&'n Name>,
}

/// The displays with which the systems of notes begin, in order.
pub(super) fn starts(notes: &Notes, names: &[Named], marks: &[Mark]) -> Vec<usize> {
    let mut found: Vec<System<'_>> = Vec::new();
    for at in (0..names.len()).filter(|at| names[*at].introduced.iter().any(is_lagrangian)) {
        let after = found.last().map_or(0, |system| system.formula + 1);
        let Some(coordinates) = coordinates(notes, names, (after, at)) else { continue };
        let start = match found.last() {
            None => Some(marked_start(names, marks, (0, at)).unwrap_or(0)),
            Some(before) => next_start((names, marks), before, (at, &coordinates)),
        };
        match (start, found.last_mut()) {
            (Some(start), _) => found.push(System { start, formula: at, coordinates }),
            // Another form of the same Lagrangian.
            (None, Some(before)) => before.formula = at,
            (None, None) => {}
        }
    }
    let mut starts: Vec<usize> = found.iter().map(|system| system.start).collect();
    if starts.len() > 1 {
        starts.extend(sections_of_their_own(&found, marks));
    }
    let examples = || marks.iter().filter(|mark| mark.example.is_some()).map(|mark| mark.at);
    if starts.iter().any(|start| examples().any(|example| example == *start)) {
        starts.extend(examples());
    }
    starts.sort_unstable();
    starts.dedup();
    starts
}

/// The first displays of sections that may be about other systems than the one before them.
fn sections_of_their_own<'m>(systems: &[System<'_>], marks: &'m [Mark]) -> impl Iterator<Item = usize> + use<'m> {
    let levels: Vec<(usize, usize, usize)> = systems
        .iter()
        .filter_map(|system| {
            let mark = marks.iter().find(|mark| mark.at == system.start)?;
            Some((system.start, system.formula, mark.lowest))
        })
        .collect();
    let is_own = move |mark: &&Mark| {
        let before = levels.iter().rfind(|(start, ..)| *start < mark.at);
        before.is_some_and(|(_, formula, level)| *formula < mark.at && mark.level <= *level) && !mark.is_step
    };
    marks.iter().filter(|mark| mark.begins_a_section() && mark.may_begin_a_system()).filter(is_own).map(|mark| mark.at)
}

/// What moves in the Lagrangian of a display and in the energies from which it is made, given since a display; `None` if this is no
/// formula of a Lagrangian, but an angular momentum, or `L = T - V` without a formula for T and V.
fn coordinates<'n>(notes: &Notes, names: &'n [Named], (after, at): (usize, usize)) -> Option<HashSet<&'n Name>> {
    let own = &names[at];
    let display = &notes.equations[at];
    if !own.moving.is_empty() {
        let is_script = own.introduced.iter().any(|name| is_lagrangian(name) && name.base != "L");
        let is_it = is_script || squares_a_rate(&display.text) || is_spoken_of_before(notes, at);
        return is_it.then(|| own.moving.iter().collect());
    }
    let is_sum = own.used.iter().all(is_energy);
    let energies = (after..at).filter(|before| names[*before].introduced.iter().any(|name| own.used.contains(name)));
    let moving: HashSet<&Name> = energies.flat_map(|before| &names[before].moving).collect();
    (is_sum && !moving.is_empty()).then_some(moving)
}

/// Whether the words directly before a display speak of a Lagrangian.
fn is_spoken_of_before(notes: &Notes, at: usize) -> bool {
    let start = at.checked_sub(1).map_or(0, |before| notes.equations[before].span.end);
    notes
        .source
        .text
        .get(start..notes.equations[at].span.start)
        .is_some_and(|words| words.contains("agrangian") && !words.contains("momentum"))
}

/// The first display of the system of another formula for the Lagrangian; `None` if it is a form of the one before.
fn next_start<'n>(
    (names, marks): (&'n [Named], &[Mark]),
    before: &System<'n>,
    (at, coordinates): (usize, &HashSet<&'n Name>),
) -> Option<usize> {
    let between = before.formula + 1..at;
    if names[before.formula].printed == names[at].printed {
        return None;
    }
    let renews = |at: usize| names[at].introduced.iter().any(|name| is_energy(name) && !is_lagrangian(name));
    let is_sum = names[before.formula].moving.is_empty();
    // `L = T - V`, and then the same in full.
    if is_sum && !between.clone().any(renews) && coordinates.is_subset(&before.coordinates) {
        return None;
    }
    if let Some(start) = marked_start(names, marks, (between.start, at)) {
        return Some(start);
    }
    let old: HashSet<&Name> = before.coordinates.difference(coordinates).copied().collect();
    let new: HashSet<&Name> = coordinates.difference(&before.coordinates).copied().collect();
    let uses = |at: usize, some: &HashSet<&Name>| names[at].used.iter().any(|name| some.contains(name));
    let is_linked = (before.start..at).any(|at| uses(at, &old) && uses(at, &new));
    if new.is_empty() || old.is_empty() || is_linked {
        return None;
    }
    let mut wanted: HashSet<&Name> = names[at].used.iter().collect();
    let known: HashSet<&Name> = (before.start..=before.formula).flat_map(|at| &names[at].used).collect();
    let mut start = at;
    for place in between.rev() {
        let named = &names[place];
        let gives =
            named.introduced.iter().any(|name| wanted.contains(name) && (is_energy(name) || !known.contains(name)));
        if uses(place, &old) || !uses(place, &new) && !gives {
            break;
        }
        wanted.extend(&named.used);
        start = place;
    }
    Some(start)
}

/// The display with which the example or the section begins in which a Lagrangian gets a formula, if one begins since a display.
fn marked_start(names: &[Named], marks: &[Mark], (after, at): (usize, usize)) -> Option<usize> {
    let inside = || marks.iter().filter(|mark| (after..=at).contains(&mark.at) && mark.may_begin_a_system());
    if let Some(example) = inside().rfind(|mark| mark.example.is_some()) {
        return Some(example.at);
    }
    let highest = inside().map(|mark| mark.level).min()?;
    let start = inside().rfind(|mark| mark.level == highest)?.at;
    // The energies may have a section of their own before that of the Lagrangian.
    let is_energy_of_it = |at: &usize| {
        let named = &names[*at];
        named.introduced.iter().any(|name| is_energy(name) && !is_lagrangian(name)) && !named.moving.is_empty()
    };
    let first = (after..start).find(is_energy_of_it);
    let earlier = first.map(|first| inside().rfind(|mark| mark.at <= first).map_or(first, |mark| mark.at));
    Some(earlier.unwrap_or(start))
}
