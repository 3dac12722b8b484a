//! Where a motion begins: "it is released from rest at $\\theta = \\theta_0$".
//!
//! A relation with the value of the coordinate there, such as the energy integral \(\\dot\\theta^2 = …(\\cos\\theta - \\cos\\theta_0)\), holds on
//! this motion and on no other.

use crate::latex::names;
use crate::notes::claims::Claim;

use super::conditions::{coordinate, start_at};
use super::notes_names::NotesNames;
use super::places::Place;
use super::words::Sentence;
use super::{ProseClaim, spanned};

/// The claims of the displays with the value of a coordinate from which a motion begins.
pub(super) fn infer(notes_names: &NotesNames<'_>, places: &[Place]) -> Vec<ProseClaim> {
    let mut found: Vec<ProseClaim> = Vec::new();
    let displays = notes_names.notes.equations.len();
    for at in 0..displays {
        let words = Sentence::paragraph(notes_names.notes, at);
        if !words.says_that_it_starts() || !words.says_that_it_rests() {
            continue;
        }
        let Some((coordinate, value)) = words.formulas.iter().find_map(|formula| value_of(notes_names, formula)) else {
            continue;
        };
        if places.iter().any(|place| place.value == value) {
            continue;
        }
        let assume = start_at(&coordinate, &value).map(spanned).to_vec();
        let is_known = |at: usize| found.iter().any(|claim| claim.displays.contains(&at));
        // A solution says itself where it begins.
        let wanted: Vec<usize> = (at..displays)
            .filter(|at| notes_names.is_free(*at) && notes_names.mentions(*at, &value) && !is_known(*at))
            .filter(|at| !notes_names.mentions(*at, "t"))
            .collect();
        for at in wanted {
            let id = notes_names.notes.equations[at].id().unwrap_or_default();
            let claim = Claim { assume: assume.clone(), ..Claim::default() };
            found.push(ProseClaim {
                why: format!("({id}) is about the motion from rest at {coordinate} = {value}"),
                claims: vec![(at, claim)],
                displays: vec![at],
                ..ProseClaim::default()
            });
        }
    }
    found
}

/// The coordinate and the name of its value, where a formula gives it one.
fn value_of(notes_names: &NotesNames<'_>, formula: &str) -> Option<(String, String)> {
    let (left, right) = formula.split_once('=')?;
    let (left, right) = (left.trim(), right.trim());
    let declared = coordinate(notes_names, left)?;
    names::parse(right)?;
    Some((declared.name.value.clone(), right.to_owned()))
}
