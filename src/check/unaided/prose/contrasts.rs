//! Words that name one of several cases, of which a display is about one: "two resistors in series", and later "two in parallel".
//!
//! Offers `Cases`, which tells whether two displays are about cases that exclude each other. Knows notes and the words of prose.

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

/// The cases that the words before displays name.
pub(crate) struct Cases {
    /// By the place of a display, the case of each row. A display without such words is about the case of the one before it; where the
    /// words name several cases, none is meant.
    named: Vec<[Option<usize>; CASES.len()]>,
}

impl Cases {
    /// The cases that notes name.
    pub fn of(notes: &Notes) -> Cases {
        let (mut now, mut end) = ([None; CASES.len()], 0);
        let mut named = Vec::new();
        for display in &notes.equations {
            if !is_inline(notes, display) {
                let words = words_between(notes, end, display.span.start);
                for (case, row) in now.iter_mut().zip(CASES) {
                    let mut found = row.iter().enumerate().filter(|(_, case)| words.iter().any(|word| word == *case));
                    match (found.next(), found.next()) {
                        (Some((at, _)), None) => *case = Some(at),
                        (Some(_), Some(_)) => *case = None,
                        (None, _) => {}
                    }
                }
                end = end.max(display.span.end);
            }
            named.push(now);
        }
        Cases { named }
    }

    /// Whether the words before two displays name cases that exclude each other.
    pub fn differ(&self, one: usize, other: usize) -> bool {
        let (Some(one), Some(other)) = (self.named.get(one), self.named.get(other)) else { return false };
        one.iter().zip(other).zip(CASES).any(|cases| match cases {
            ((Some(a), Some(b)), row) => a != b && !is_of_one_stem(row[*a], row[*b]),
            _ => false,
        })
    }
}

/// Whether two words are forms of one: an adjective and its adverb.
fn is_of_one_stem(a: &str, b: &str) -> bool {
    a.starts_with(b) || b.starts_with(a)
}
