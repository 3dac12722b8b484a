//! Connections that words make rigid: "for a rigid joint, $q_1 = q_2 = q$, this becomes", "as $k \\to \\infty$, $q_1 = q_2$".
//!
//! A force keeps the coordinates equal then, which the Lagrangian does not have. So a display that fails is checked once more with the
//! constraint q_1 − q_2 = 0, whose multiplier is this force. What the words say of other displays does not change.

use crate::notes::Notes;
use crate::notes::claims::{Claims, Declaration, Range, Role};

use crate::check::document::setup::Run;
use crate::check::run::check_in;
use crate::check::verdict::report::Document;

use super::conditions::coordinate;
use super::notes_names::NotesNames;
use super::words::Sentence;
use super::{has_lagrangian, passes, spanned};

/// Words for connections that do not give, as they begin.
const RIGID: [&str; 8] = ["rigid", "stiff", "inextens", "lock", "clamp", "starr", "rigide", "unelast"];

/// The name of the multiplier, which no notes have.
const MULTIPLIER: &str = "\\lambda_{\\mathrm{rigid}}";

/// Replaces what was found of displays that fail, and pass where coordinates are kept equal as the words before them say.
pub(super) fn judge(run: &Run<'_>, (claims, notes): (&Claims, &Notes), found: &mut Document) {
    if !has_lagrangian(claims) {
        return;
    }
    let names = NotesNames::of(claims, notes);
    for at in (0..notes.equations.len()).filter(|at| names.is_free(*at)) {
        let Some(id) = notes.equations[at].id() else { continue };
        let Some(place) = found.equations.iter().position(|equation| equation.id == id && !passes(equation)) else {
            continue;
        };
        let Some((equal, with)) = connected(&names, at) else { continue };
        let Ok(checked) = check_in(&Run { only: Some(id), progress: &(), ..*run }, &with, notes) else { continue };
        let Some(equation) = checked.equations.into_iter().find(|equation| equation.id == id) else { continue };
        if equation.ok || !equation.repairs.is_empty() {
            found.equations[place] = equation;
            found.inferred.push(format!("({id}) is about motions on which {equal}, as the words around it say"));
        }
    }
}

/// What the words before a display keep equal, and the claims with this constraint.
fn connected(names: &NotesNames<'_>, at: usize) -> Option<(String, Claims)> {
    let words = Sentence::paragraph(names.notes, at);
    let is_infinite = |formula: &String| formula.contains("\\to") && formula.contains("\\infty");
    let is_rigid = words.says(&RIGID) || words.says_phrase(&["at all times"]) || words.formulas.iter().any(is_infinite);
    if !is_rigid || words.denies() {
        return None;
    }
    words.formulas.iter().rev().find_map(|formula| {
        let members: Vec<&str> = formula.split('=').map(|member| member.trim().trim_end_matches([',', '.'])).collect();
        let [first, second, rest @ ..] = members.as_slice() else { return None };
        let (first, second) = (coordinate(names, first)?, coordinate(names, second)?);
        let (first, second) = (first.name.value.clone(), second.name.value.clone());
        let mut with = names.claims.clone();
        match rest {
            [] => {}
            [name] if !names.is_declared(name) && !names.is_defined(name) => {
                with.define.push((spanned((*name).to_owned()), spanned(first.clone())));
            }
            _ => return None,
        }
        with.declarations.push(Declaration {
            role: Role::Coordinate,
            name: spanned(MULTIPLIER.to_owned()),
            range: spanned(Range::Any),
            is_formula: false,
        });
        with.constraints.push((spanned(MULTIPLIER.to_owned()), spanned(format!("{first} - {second}"))));
        Some((format!("{first} = {second}"), with))
    })
}
