//! Constants that only the prose introduces: "released at $x = x_0$", "with an amplitude $A$".
//!
//! Whoever writes a name in a sentence means this name, so it is no slip of the pen for another one. A name that a display or a
//! sentence gives a formula is no such constant, nor is one that moves.

use crate::latex::{name_search, names};
use crate::notes::claims::Range;

use crate::check::document::inferred::prose::{body_of, words_between};

use super::ProseClaim;
use super::notes_names::NotesNames;
use super::places::{Place, is_value_of};

/// The words of quantities that are positive.
const POSITIVE: [&str; 16] = [
    "amplitude",
    "angle",
    "distance",
    "frequency",
    "height",
    "length",
    "mass",
    "period",
    "radius",
    "speed",
    "stiffness",
    "time",
    "depth",
    "width",
    "size",
    "energy",
];

/// Names that have a meaning without a declaration.
pub(super) const KNOWN: [&str; 5] = ["t", "e", "i", "d", "\\pi"];

/// The bytes before a formula in which its noun is sought.
const NEAR: usize = 40;

/// The constants that the prose introduces.
pub(super) fn infer(notes_names: &NotesNames<'_>, places: &[Place]) -> Vec<ProseClaim> {
    let notes = notes_names.notes;
    let mut found: Vec<ProseClaim> = Vec::new();
    for span in &notes.inline {
        let Some(body) = body_of(notes, *span) else { continue };
        let text = notes.source.slice(body).trim();
        let name = match text.split('=').collect::<Vec<_>>().as_slice() {
            [only] => only.trim(),
            // `x = x_0`: the value of a name.
            [left, right] if names::parse(left.trim()).is_some() => right.trim(),
            _ => continue,
        };
        let Some((parsed, 0)) = names::parse(name) else { continue };
        let name = parsed.to_string();
        let Some(usage) = notes_names.usages.iter().find(|usage| usage.name == parsed) else { continue };
        let is_known = KNOWN.contains(&name.as_str())
            || notes_names.is_declared(&name)
            || places.iter().any(|place| name_search::same(&place.value, &name))
            || found.iter().any(|claim| claim.constants.iter().any(|(known, _)| *known == name));
        let is_vector = ["\\vec", "\\mathbf", "\\hat", "\\bm"].iter().any(|mark| name.contains(mark));
        let moves = usage.moves || usage.arguments.is_some() || usage.differentiates;
        if is_known || is_vector || moves || is_given(notes_names, &name) {
            continue;
        }
        let displays: Vec<usize> =
            notes_names.displays_with(&name).into_iter().filter(|at| notes_names.is_free(*at)).collect();
        // A relation between a value of a coordinate and constants is a condition, and not true for all values.
        let is_value = notes_names.coordinates().any(|(_, coordinate)| is_value_of(&parsed, &coordinate));
        if displays.is_empty() || is_value && displays.iter().any(|at| !notes_names.has_coordinates(*at)) {
            continue;
        }
        let mut near = span.start.saturating_sub(NEAR);
        while !notes.source.text.is_char_boundary(near) {
            near += 1;
        }
        let words = words_between(notes, near, span.start);
        let is_positive = words.iter().rev().take(3).any(|word| POSITIVE.contains(&word.as_str()));
        let range = if is_positive { Range::Positive } else { Range::Any };
        let line = 1 + notes.source.text[..span.start].matches('\n').count();
        found.push(ProseClaim {
            why: format!("{name} is a constant, which line {line} of the notes introduces"),
            constants: vec![(name, range)],
            displays,
            is_enough: true,
            ..ProseClaim::default()
        });
    }
    found.extend(first_values(notes_names, &found));
    found
}

/// The x_0 of `x = x_0 + vt`: the value of a coordinate that displays beside the coordinate have, and nothing declares.
fn first_values(notes_names: &NotesNames<'_>, known: &[ProseClaim]) -> Vec<ProseClaim> {
    let mut found = Vec::new();
    for usage in &notes_names.usages {
        let name = usage.name.to_string();
        let is_first = usage.name.subscript == ["0"]
            && notes_names.coordinates().any(|(_, coordinate)| is_value_of(&usage.name, &coordinate));
        let is_known = notes_names.is_declared(&name)
            || known.iter().any(|claim| claim.constants.iter().any(|(other, _)| *other == name));
        let moves = usage.moves || usage.arguments.is_some() || usage.differentiates;
        if !is_first || is_known || moves || is_given(notes_names, &name) {
            continue;
        }
        let displays: Vec<usize> =
            notes_names.displays_with(&name).into_iter().filter(|at| notes_names.is_free(*at)).collect();
        if displays.is_empty() || displays.iter().any(|at| !notes_names.has_coordinates(*at)) {
            continue;
        }
        found.push(ProseClaim {
            why: format!("{name} is a constant, a value of the coordinate"),
            constants: vec![(name, Range::Any)],
            displays,
            is_enough: true,
            ..ProseClaim::default()
        });
    }
    found
}

/// Whether a display or a formula in a sentence gives a name, or a power of it, a formula.
fn is_given(notes_names: &NotesNames<'_>, name: &str) -> bool {
    let notes = notes_names.notes;
    let given = |text: &str| name_search::is_a_side(text, name, &notes_names.macros);
    let in_prose = notes.inline.iter().filter_map(|span| body_of(notes, *span)).any(|body| {
        let text = notes.source.slice(body);
        // `x = x_0` gives no formula.
        let says_value = text.split_once('=').is_some_and(|(_, right)| name_search::same(right.trim(), name));
        text.contains('=') && given(text) && !says_value
    });
    in_prose || notes_names.is_defined(name)
}
