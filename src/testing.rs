//! Checks of notes as assertions in a test, with the systems of this crate or of your own.
//!
//! ```
//! use onshell::systems::Registry;
//! use onshell::testing::assert_text;
//!
//! let notes = r"$$ \ddot\theta = -\frac{g}{l} \sin\theta \tag{1} $$";
//! let claims = r#"{
//!     "notes": "pendulum.md",
//!     "system": "simple_pendulum",
//!     "coordinates": { "\\theta": "angle" },
//!     "constants": { "m, l, g": "> 0" }
//! }"#;
//! assert_text(notes, claims, &Registry::standard());
//! ```

use std::path::Path;
use std::sync::Arc;

use crate::check::{Document, Options, Report, check_document};
use crate::notes::document::Kind;
use crate::notes::{Claims, Notes, claims_beside};
#[cfg(feature = "cli")]
use crate::report::{self, Style};
use crate::source::Source;
use crate::systems::Registry;
use crate::{Error, Result};

/// The seed and the number of states of `onshell check`.
const OPTIONS: Options = Options { seed: 1, points: 24, explain: true, deduction: false };

/// Checks a document on disk. `path` is a claims file, or notes with a claims file beside them.
///
/// # Errors
/// For files that cannot be read, and claims that do not fit the notes or the system.
pub fn check_file(path: impl AsRef<Path>, registry: &Registry) -> Result<Document> {
    let path = path.as_ref();
    let shown = |path: &Path| path.display().to_string();
    let is_claims = path.extension().is_some_and(|extension| extension == "json");
    let claims = if is_claims { path.to_owned() } else { claims_beside(path) };
    let claims = Claims::read(&claims, &shown(&claims))?;
    let notes = if is_claims { claims.notes_path() } else { path.to_owned() };
    check_document(&claims, &Notes::read(&notes, &shown(&notes))?, registry, OPTIONS, None)
}

/// Checks a document given as two texts: the notes, and the claims file.
///
/// No file is read. The name under `"notes"` says by its ending whether the notes are Markdown or TeX.
///
/// # Errors
/// For claims that cannot be read, or do not fit the notes or the system.
pub fn check_text(notes: &str, claims: &str, registry: &Registry) -> Result<Document> {
    let claims = Claims::parse(Arc::new(Source::new("claims.json", claims)), Path::new("claims.json"))?;
    let name = &claims.notes.value;
    let kind = Kind::of(Path::new(name)).ok_or_else(|| {
        Error::at(&claims.source, claims.notes.span, format!("{name} has an ending that notes do not have"))
            .help("notes end in .md, .markdown, .txt or .tex")
    })?;
    let notes = Notes::parse(Arc::new(Source::new(name.as_str(), notes)), kind)?;
    check_document(&claims, &notes, registry, OPTIONS, None)
}

/// Checks a document on disk as [`check_file`] does, and panics unless everything is as expected.
///
/// # Panics
/// With the report, if an equation is not as expected, if there is none, or if the document cannot be checked.
#[track_caller]
pub fn assert_file(path: impl AsRef<Path>, registry: &Registry) {
    demand(check_file(path, registry));
}

/// Checks two texts as [`check_text`] does, and panics unless everything is as expected.
///
/// # Panics
/// With the report, if an equation is not as expected, if there is none, or if the document cannot be checked.
#[track_caller]
pub fn assert_text(notes: &str, claims: &str, registry: &Registry) {
    demand(check_text(notes, claims, registry));
}

#[track_caller]
fn demand(document: Result<Document>) {
    match document {
        Ok(document) => {
            let report = Report { documents: vec![document] };
            assert!(report.exit_code() == 0, "\n{}", failed(&report));
        }
        Err(error) => panic!("\n{}", refused(&error)),
    }
}

/// The report of a test that fails.
#[cfg(feature = "cli")]
fn failed(report: &Report) -> String {
    report::text::report(report, false, Style::PLAIN)
}

/// The error of a test that fails.
#[cfg(feature = "cli")]
fn refused(error: &Error) -> String {
    report::diagnostic::error(error, Style::PLAIN)
}

/// The report of a test that fails, without the lines of the notes: these need the feature `cli`.
#[cfg(not(feature = "cli"))]
fn failed(report: &Report) -> String {
    let wrong = report.items().filter(|item| !item.ok);
    let line = |item: &crate::check::Equation| {
        format!("line {}: ({}) is {}: {}\n", item.line, item.id, item.finding.verdict, item.finding.message)
    };
    let lines: String = wrong.map(line).collect();
    if lines.is_empty() { "nothing was checked".to_owned() } else { lines }
}

/// The error of a test that fails, without the lines of its file: these need the feature `cli`.
#[cfg(not(feature = "cli"))]
fn refused(error: &Error) -> String {
    error.to_string()
}

/// The example, run as a test.
#[cfg(doctest)]
#[doc = concat!("```\n", include_str!("../examples/own_system.rs"), "\n```")]
struct Example;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::Verdict;

    const CLAIMS: &str = r#"{
        "notes": "pendulum.md",
        "system": "simple_pendulum",
        "coordinates": { "\\theta": "angle" },
        "constants": { "m, l, g": "> 0" }
    }"#;

    #[test]
    fn a_true_equation_passes_and_its_typo_does_not() {
        let registry = Registry::standard();
        let verdict = |notes: &str| check_text(notes, CLAIMS, &registry).unwrap().equations[0].finding.verdict;
        assert_eq!(verdict(r"$$ l \ddot\theta = - g \sin\theta \tag{1} $$"), Verdict::Certified);
        assert_eq!(verdict(r"$$ l \ddot\theta = - g \cos\theta \tag{1} $$"), Verdict::Refuted);
    }

    #[test]
    #[should_panic(expected = "(1) is refuted")]
    fn a_false_equation_fails_the_test() {
        assert_text(r"$$ \ddot\theta = \frac{g}{l} \sin\theta \tag{1} $$", CLAIMS, &Registry::standard());
    }

    #[test]
    #[should_panic(expected = "nothing was checked")]
    fn notes_without_equations_fail_the_test() {
        assert_text("No equation here.", CLAIMS, &Registry::standard());
    }

    #[test]
    #[should_panic(expected = "there is no system")]
    fn claims_that_do_not_fit_fail_the_test() {
        assert_text("$$ x = x $$", &CLAIMS.replace("simple", "smiple"), &Registry::standard());
    }

    #[test]
    fn a_notes_file_finds_its_claims() {
        let [by_notes, by_claims] = ["md", "json"].map(|extension| {
            check_file(format!("derivations/05-euler-angles.{extension}"), &Registry::standard()).unwrap()
        });
        assert_eq!(by_notes, by_claims);
        assert_eq!(by_notes.equations.len(), 8);
    }
}
