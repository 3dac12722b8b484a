//! Values of coordinates that have names of their own: the $\theta_0$ at which the system rests, the $r_0$ of a circular orbit.
//!
//! The display that says what such a value is must be the condition for rest, or for a steady motion. What other displays say
//! with the name holds under this condition.

use crate::formula::symbols::Name;
use crate::latex::{name_search, names};
use crate::notes::claims::{Claim, Equilibrium, Range, Spanned};

use super::notes_names::NotesNames;
use super::words::{PASSING, Sentence};
use super::{ProseClaim, spanned};

/// Words for a state that lasts, as they begin.
const LASTING: [&str; 17] = [
    "equilib",
    "rests",
    "station",
    "steady",
    "steadi",
    "circular",
    "circle",
    "stay",
    "remain",
    "hang",
    "gleichgew",
    "ruh",
    "kreis",
    "équilib",
    "repos",
    "circul",
    "balanc",
];

/// Words for rest and for what stays as it is. Longer words that begin so mean something else, as "restoring" does.
const RESTS: [&str; 3] = ["rest", "constant", "uniformly"];

/// The value of a coordinate.
pub(super) struct Place {
    /// The coordinate.
    pub coordinate: String,
    /// Its value.
    pub value: String,
    /// The condition under which it is that, where no display gives it a formula.
    pub under: Vec<Spanned<String>>,
    /// The display that says what it is.
    pub at: usize,
    /// Whether the coordinate may be 0.
    pub may_be_zero: bool,
    /// What the prose claims of it.
    pub claim: ProseClaim,
}

/// Whether a name is that of a value of a coordinate: the same letter with a subscript.
pub(super) fn is_value_of(name: &Name, coordinate: &Name) -> bool {
    name.base == coordinate.base
        && name.primes == coordinate.primes
        && coordinate.subscript.is_empty()
        && !name.subscript.is_empty()
}

/// Whether words speak of a state that lasts.
pub(super) fn says_that_it_lasts(words: &Sentence) -> bool {
    (words.says(&LASTING) || words.has_word(&RESTS)) && !words.denies() && !words.says_phrase(&PASSING)
}

/// The values of coordinates at which the prose says that the system stays.
pub(super) fn infer(notes_names: &NotesNames<'_>) -> Vec<Place> {
    where_it_stays(notes_names, &|at| notes_names.is_free(at))
}

/// The same, with those of which a claim already says that the system rests there, or moves steadily.
pub(super) fn known(notes_names: &NotesNames<'_>) -> Vec<Place> {
    where_it_stays(notes_names, &|at| notes_names.is_free(at) || notes_names.is_said_to_stay(at))
}

fn where_it_stays(notes_names: &NotesNames<'_>, is_open: &dyn Fn(usize) -> bool) -> Vec<Place> {
    let several = notes_names.coordinates().count() > 1;
    let mut found = Vec::new();
    for (declared, coordinate) in notes_names.coordinates() {
        for usage in notes_names.usages.iter().filter(|usage| is_value_of(&usage.name, &coordinate)) {
            let value = usage.name.to_string();
            // That it is a constant says nothing of where it is.
            let is_known = notes_names.is_declared(&value) && !notes_names.is_constant(&value);
            if usage.moves || usage.arguments.is_some() || is_known {
                continue;
            }
            let with_it = notes_names.displays_with(&value);
            let says_where = |at: &usize| {
                let lasts = notes_names.sentence_of(*at).iter().any(says_that_it_lasts);
                let is_own = notes_names.is_given_in(*at, &value);
                let is_free = is_open(*at) && !notes_names.has_coordinates(*at);
                lasts && is_free && (is_own || !notes_names.introduces(*at))
            };
            let Some(at) = with_it.iter().copied().find(says_where) else { continue };
            let Some(condition) = notes_names.equality(at) else { continue };
            let coordinate = declared.name.value.clone();
            let is_given = name_search::is_a_side(&condition, &value, &notes_names.macros);
            let claimed = if several { Equilibrium::Steady } else { Equilibrium::Any };
            let stays = Claim {
                equilibrium: Some(spanned(claimed)),
                at: vec![(spanned(coordinate.clone()), spanned(value.clone()))],
                ..Claim::default()
            };
            let mut claim = ProseClaim { claims: vec![(at, stays)], displays: vec![at], ..ProseClaim::default() };
            let id = notes_names.notes.equations[at].id().unwrap_or_default();
            let under = if is_given { Vec::new() } else { condition_of(&condition, &value) };
            if !is_given {
                let range = match &declared.range.value {
                    Range::Angle => Range::Any,
                    range => range.clone(),
                };
                claim.constants.push((value.clone(), range));
                let others = with_it.iter().filter(|other| **other != at && notes_names.is_free(**other));
                let assumed = Claim { implied: under.clone(), ..Claim::default() };
                claim.claims.extend(others.map(|other| (*other, assumed.clone())));
            }
            claim.why = format!("{value} is the value of {coordinate} where the system stays, by ({id})");
            let may_be_zero = !matches!(declared.range.value, Range::Positive | Range::Negative);
            found.push(Place { coordinate, value, under, at, may_be_zero, claim });
        }
    }
    found
}

/// The hypotheses that a condition makes. Of what is given by its square the positive value is meant.
fn condition_of(condition: &str, value: &str) -> Vec<Spanned<String>> {
    let mut hypotheses = vec![spanned(condition.to_owned())];
    let left = condition.split('=').next().unwrap_or_default().trim();
    let root = left.strip_suffix("^2").or(left.strip_suffix("^{2}")).map(str::trim);
    if let Some(root) = root.filter(|root| names::parse(root).is_some_and(|(name, _)| name.to_string() != value)) {
        hypotheses.push(spanned(format!("{root} > 0")));
    }
    hypotheses
}
