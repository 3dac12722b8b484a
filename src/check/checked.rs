//! The check of one document, whether its claims are confirmed or guesses.

use crate::Result;
use crate::notes::{Claims, Notes};
use crate::parallel::on_deep_stacks;
use crate::systems::Registry;

use crate::check::document::inferred::open_energies;
use crate::check::document::setup::{Run, without_open_energies};
use crate::check::prose_claims;
use crate::check::sample::context::Options;
use crate::check::unaided::guessed;
use crate::check::verdict::report::Document;

/// Checks a document; `only` restricts the check to the equation with this number, which the document may lack.
///
/// # Errors
/// For claims that do not fit the notes or the system, each at its place in the claims file.
pub fn check_document(
    claims: &Claims,
    notes: &Notes,
    registry: &Registry,
    options: Options,
    only: Option<&str>,
) -> Result<Document> {
    on_deep_stacks(|| check_claims(&Run { registry, options, only, progress: &() }, claims, notes))
}

/// Checks a document as part of a run.
///
/// # Errors
/// As [`check_document`].
pub fn check_claims(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    match claims.guesses {
        Some(_) => guessed(run, claims, notes),
        None => {
            let read = without_open_energies(claims, notes);
            let mut document = with_untested_definitions(prose_claims::checked(run, claims, &read)?);
            document.inferred.extend(open_energies::left_out(notes, &read));
            Ok(document)
        }
    }
}

/// The document, in which a definition that no other display tests is no failure. Nothing says that it is wrong: it may be the
/// last result. It stays `undecided`, and the report warns of it.
fn with_untested_definitions(mut document: Document) -> Document {
    for equation in document.equations.iter_mut().filter(|equation| !equation.ok && equation.because.is_none()) {
        for part in &mut equation.parts {
            part.ok |= part.finding.is_untested_definition();
        }
        equation.ok = match equation.parts.is_empty() {
            true => equation.finding.is_untested_definition(),
            false => equation.parts.iter().all(|part| part.ok),
        };
    }
    document
}
