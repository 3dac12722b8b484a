//! Words that name one of several cases, of which a display is about one: "two resistors in series", and later "two in parallel".
//!
//! Offers `differ`, whether two displays are about cases that exclude each other. Knows notes and the words of prose.

use crate::check::document::inferred::prose::words_between;
use crate::check::unaided::inline::is_inline;
use crate::notes::Notes;

/// Words of which each names a case that excludes the others of its row.
const CASES: [&[&str]; 9] = [
    &["series", "parallel"],
    &["elastic", "elastically", "inelastic", "inelastically"],
    &["isothermal", "isothermally", "adiabatic", "adiabatically", "isobaric", "isochoric"],
    &["inside", "outside"],
    &["overdamped", "underdamped"],
    &["constructive", "destructive"],
    &["converging", "diverging"],
    &["hyperbolic", "parabolic", "elliptic", "circular"],
    &["bosons", "fermions"],
];

/// Whether the words before two displays name cases that exclude each other. A display without such words is about the case of the one
/// before it.
pub(in crate::check::unaided) fn differ(notes: &Notes, one: usize, other: usize) -> bool {
    CASES.iter().any(|row| match (named(notes, one, row), named(notes, other, row)) {
        (Some(a), Some(b)) => a != b && !is_of_one_stem(row[a], row[b]),
        _ => false,
    })
}

/// The case of a row that the words before a display name, or those before the last display for which they name one. Where they name
/// several, none is meant.
fn named(notes: &Notes, at: usize, row: &[&str]) -> Option<usize> {
    let displays = &notes.equations;
    let is_printed = |place: &usize| !is_inline(notes, &displays[*place]);
    let mut end = at;
    loop {
        let before = (0..end).rev().find(is_printed);
        let start = before.map_or(0, |place| displays[place].span.end);
        let stop = displays[end].span.start.max(start);
        let words = words_between(notes, start, stop);
        let mut found = row.iter().enumerate().filter(|(_, case)| words.iter().any(|word| word == *case));
        match (found.next(), found.next()) {
            (Some((case, _)), None) => return Some(case),
            (Some(_), Some(_)) => return None,
            (None, _) => end = before?,
        }
    }
}

/// Whether two words are forms of one: an adjective and its adverb.
fn is_of_one_stem(a: &str, b: &str) -> bool {
    a.starts_with(b) || b.starts_with(a)
}
