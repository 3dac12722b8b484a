//! The check of a whole document with an edited text.

use std::path::Path;
use std::sync::Arc;

use crate::formula::SymbolId;
use crate::notes::claims::Claims;
use crate::notes::document::Kind;
use crate::notes::{Notes, Numbered};
use crate::source::Source;
use crate::{Error, Result};

use crate::check::document::setup::{Run, wanted, with_checker};
use crate::check::equations::sentences;
use crate::check::verdict::Verdict;

/// An equation or a sentence, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Checked {
    /// The n-th display.
    Display(usize),
    /// The n-th sentence of the claims file.
    Sentence(usize),
}

/// The verdict on the first equation or sentence that is not as expected and not excused; `None`, if there is none. Equations that
/// use a name of the `at`-th display are checked first.
pub(crate) fn first_unexpected(
    run: &Run<'_>,
    claims: &Claims,
    notes: &Notes,
    at: usize,
    is_excused: &dyn Fn(Checked) -> bool,
) -> Result<Option<Verdict>> {
    with_checker(run, claims, notes, |checker| {
        let introduced: Vec<SymbolId> = checker.readings[at].introduced.iter().map(|new| new.symbol).collect();
        let uses = |other: usize| {
            let members = checker.readings[other].statements.iter().flatten().flat_map(|s| &s.members);
            members.flat_map(|member| member.symbols()).any(|(symbol, _)| introduced.contains(&symbol))
        };
        let (mut order, rest): (Vec<usize>, Vec<usize>) = wanted(notes, checker.assigned, None)
            .into_iter()
            .filter(|other| *other != at)
            .partition(|other| uses(*other));
        order.extend(rest);
        for other in order.iter().chain([&at]) {
            let found = checker.equation(*other, checker.assigned[*other])?;
            if !found.ok && !is_excused(Checked::Display(*other)) {
                return Ok(Some(found.finding.verdict));
            }
        }
        for (at, sentence) in claims.sentences.iter().enumerate() {
            let found = sentences::check(&checker, at, sentence)?;
            if !found.ok && !is_excused(Checked::Sentence(at)) {
                return Ok(Some(found.finding.verdict));
            }
        }
        Ok(None)
    })
}

/// The same notes with another text. Displays that the notes give a name, as those without a number have where no claims file is,
/// keep it.
///
/// # Errors
/// When the text cannot be read, or when it has more or fewer displays.
pub(crate) fn with_text(notes: &Notes, text: String) -> Result<Notes> {
    let path = &notes.source.path;
    let kind = Kind::of(Path::new(path)).ok_or_else(|| Error::new(format!("{path} is not a file of notes")))?;
    let mut edited = Notes::parse(Arc::new(Source::new(path.clone(), text)), kind)?;
    // A hand-in and its problem together are no file: read as one, they have other displays.
    if edited.equations.len() != notes.equations.len() {
        return Err(Error::new(format!("with this edit, {path} has more or fewer displays")));
    }
    for (display, before) in edited.equations.iter_mut().zip(&notes.equations) {
        if let (None, Some(name)) = (display.id(), before.id()) {
            display.number = Some(Numbered { id: name.to_owned(), span: display.body });
        }
    }
    Ok(edited)
}
