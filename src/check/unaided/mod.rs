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
//! Offers [`unaided`]. Knows all other folders of `check`.

mod course;
mod gate;
mod inference;
mod names;
mod premises;
mod prose;

use crate::Result;
use crate::check::document::setup::{Run, with_checker};
use crate::check::verdict::report::Document;
use crate::notes::{Notes, Numbered};

/// Checks notes without a claims file.
///
/// # Errors
/// When no claims file makes sense of the notes.
pub fn unaided(run: &Run<'_>, notes: &Notes) -> Result<Document> {
    let notes = with_ids(notes);
    let claims = inference::claims(run, &notes)?;
    with_checker(run, &claims, &notes, |checker| {
        let mut equations = course::judged(&checker)?;
        if let Some(only) = run.only {
            equations.retain(|equation| equation.id == only);
        }
        Ok(Document {
            path: notes.source.path.clone(),
            claims: None,
            source: notes.source.clone(),
            equations,
            sentences: Vec::new(),
            unnumbered: 0,
            inferred: checker.model.inferred.clone(),
        })
    })
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
