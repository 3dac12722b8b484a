//! Equations for something that is sought: "the turning points are the roots of", "the secular equation is".
//!
//! Such an equation holds for what solves it, and for nothing else. Where neither the claims file nor the words say what that is,
//! it is left open: that it fails in general says nothing.

use crate::code::Code;

use crate::check::verdict::Verdict;
use crate::check::verdict::report::Document;

use super::notes_names::NotesNames;
use super::words::{PASSING, ROOTS_OF, Sentence};

/// Words for such equations, as they begin.
const EQUATIONS: [&str; 5] = ["secular", "characteristic", "säkular", "charakteristisch", "séculaire"];

/// Leaves open what was refuted and is an equation for something that is sought, if no words claim more of it.
pub(super) fn leave_open(names: &NotesNames<'_>, is_claimed: impl Fn(usize) -> bool, found: &mut Document) {
    for at in (0..names.notes.equations.len()).filter(|at| names.is_free(*at) && !is_claimed(*at)) {
        let id = names.notes.equations[at].id();
        let equation = found.equations.iter_mut().find(|equation| Some(equation.id.as_str()) == id);
        let Some(equation) = equation.filter(|equation| !equation.ok) else { continue };
        let is_general = equation.finding.verdict == Verdict::Refuted && equation.finding.code == Code::SidesDiffer;
        if !is_general || !is_about_something_sought(&names.before(at)) {
            continue;
        }
        let finding = &mut equation.finding;
        finding.verdict = Verdict::Undecided;
        finding.code = Code::EquationForUnknown;
        finding.message =
            "the text before asks for a solution of this equation, so it was not tested as an identity; say with \
             \"assume\" or \"where\" when it holds, or claim \"secular equation for\""
                .to_owned();
        finding.counterexample = None;
        finding.difference = None;
        finding.fit = None;
        equation.repairs.clear();
        equation.elsewhere.clear();
        for part in &mut equation.parts {
            part.finding = equation.finding.clone();
        }
    }
}

fn is_about_something_sought(words: &Sentence) -> bool {
    words.says(&EQUATIONS) || words.ends_with(&ROOTS_OF) || words.says_phrase(&PASSING)
}
