//! The check of notes that have no claims file.
//!
//! The claims file is inferred ([`inference`]), and the notes are checked with it like any others. Then each finding is
//! weighed ([`gate`]): what holds follows, what gives a name a formula introduces it, and a relation that does not follow
//! is taken for granted. It is called wrong only if one likely slip lies between it and an equation that is certified.
//! A free assumption is not one edit away from a theorem, so notes that state laws of nature are not called wrong.
//!
//! # Why nothing else is called wrong
//!
//! Without claims nobody says what the symbols mean. Most equations in notes are laws, conditions or values, and fail at
//! random states. A false "wrong" costs the trust that ten found slips earn. So the correction must be there before the
//! word is said, it must be certified, and it must not be a triviality such as a = a.
//!
//! Offers [`unaided`], [`draft`] for the inferred claims as a file, and `guessed` for the check with such a file. Knows all
//! other folders of `check`.

#[cfg(feature = "cli")]
mod draft;
mod gate;
mod inference;
pub(super) mod names;

use crate::Result;
use crate::check::document::setup::{Run, with_checker};
use crate::check::run::check_in;
use crate::check::sample::context::Options;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::{Document, Equation};
use crate::formula::{Expr, SymbolId};
use crate::notes::{Claims, Notes, Numbered};

#[cfg(feature = "cli")]
pub use draft::draft;

/// Checks notes without a claims file.
///
/// # Errors
/// When no claims file makes sense of the notes.
pub fn unaided(run: &Run<'_>, notes: &Notes) -> Result<Document> {
    let notes = with_ids(notes);
    let claims = inference::claims(run, &notes)?;
    let document = weighed(run, &claims, &notes)?;
    Ok(Document { claims: None, ..document })
}

/// Checks notes whose claims file has guesses. A display with a claim of its own is judged by it; the others are weighed.
///
/// # Errors
/// For claims that do not fit the notes.
pub(super) fn guessed(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    weighed(run, claims, &with_ids(notes))
}

/// Checks notes with claims that nobody has confirmed.
fn weighed(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    // Corrections take long to find, so they are sought only for what may be a slip.
    let brief = Run { options: Options { explain: false, ..run.options }, ..*run };
    let mut document = check_in(&brief, claims, notes)?;
    let candidates = gate::candidates(run, claims, notes)?;
    for equation in &mut document.equations {
        let is_candidate = |id: &String| *id == equation.id;
        if equation.finding.verdict == Verdict::Refuted && candidates.iter().any(is_candidate) {
            let only = Run { only: Some(equation.id.as_str()), ..*run };
            let again = check_in(&only, claims, notes)?;
            if let Some(found) = again.equations.into_iter().next() {
                *equation = found;
            }
        }
    }
    let equations = std::mem::take(&mut document.equations);
    document.equations = with_checker(run, claims, notes, |checker| {
        let weighed = |equation: Equation| {
            let at = notes.equations.iter().position(|display| display.id() == Some(&equation.id));
            let Some(at) = at.filter(|at| checker.assigned[*at].is_none()) else { return equation };
            let others = checker.readings.iter().enumerate().filter(|(other, _)| *other != at);
            let members = others.flat_map(|(_, reading)| reading.statements.iter().flatten()).flat_map(|s| &s.members);
            let elsewhere: Vec<SymbolId> = members.flat_map(Expr::symbols).map(|(id, _)| id).collect();
            gate::weigh(equation, &notes.equations[at], (checker.model, &elsewhere))
        };
        Ok(equations.into_iter().map(weighed).collect())
    })?;
    document.is_guessed = true;
    document.unnumbered = 0;
    Ok(document)
}

/// The notes, in which each display without a number has the name `L` and its line, and no number is there twice.
fn with_ids(notes: &Notes) -> Notes {
    let mut notes = notes.clone();
    let mut known: Vec<String> = Vec::new();
    for display in &mut notes.equations {
        let own = display.id().filter(|id| !known.iter().any(|other| other == id)).map(str::to_owned);
        let id = own.clone().unwrap_or_else(|| {
            let line = format!("L{}", display.line);
            let more = (2..).map(|n| format!("{line}.{n}"));
            std::iter::once(line.clone()).chain(more).find(|id| !known.contains(id)).unwrap_or(line)
        });
        if own.is_none() {
            display.number = Some(Numbered { id: id.clone(), span: display.body });
            display.labels.clear();
        }
        known.push(id);
    }
    notes
}
