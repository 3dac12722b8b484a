//! The check of one document, whether its claims are confirmed or guesses.

use crate::Result;
use crate::notes::{Claims, Notes};
use crate::parallel::on_deep_stacks;
use crate::systems::Registry;

use crate::check::document::setup::Run;
use crate::check::run::check_in;
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
        None => check_in(run, claims, notes),
    }
}
