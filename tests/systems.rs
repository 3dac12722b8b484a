//! The systems of textbooks in `examples/systems/`: every equation passes, and one slip in each document is refuted.
//!
//! That no other slip passes is in the table of mutants of `docs/benchmarks.md`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use onshell::Source;
use onshell::check::{Document, Options, Verdict, check_document};
use onshell::notes::{Claims, Kind, Notes};
use onshell::systems::Registry;

/// Every claims file of the folder, in order.
fn claims_files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/systems");
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let paths = entries.map(|entry| entry.expect("the entry can be read").path());
    let mut found: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|ending| ending == "json")).collect();
    found.sort();
    found
}

fn check(claims: &Claims, notes: &Notes) -> Document {
    let mut options = Options::default();
    options.explain = false;
    check_document(claims, notes, &Registry::standard(), options, None).expect("the claims fit the notes")
}

fn read(path: &Path) -> (Claims, Notes) {
    let claims = Claims::read(path, &path.display().to_string()).expect("the claims file can be read");
    let notes = Notes::read(&claims.notes_path(), "notes.md").expect("the notes can be read");
    (claims, notes)
}

#[test]
fn every_equation_of_every_system_passes() {
    let files = claims_files();
    assert!(files.len() >= 24, "{} documents", files.len());
    for path in files {
        let (claims, notes) = read(&path);
        let document = check(&claims, &notes);
        assert!(document.equations.len() >= 6, "{} has few equations", path.display());
        for equation in document.equations.iter().chain(&document.sentences) {
            let finding = &equation.finding;
            assert!(finding.verdict.passes(), "{} ({}): {}", path.display(), equation.id, finding.message);
        }
    }
}

#[test]
fn another_sign_in_the_last_equation_with_a_sum_does_not_pass() {
    for path in claims_files() {
        let (claims, notes) = read(&path);
        let text = &notes.source.text;
        let passes = check(&claims, &notes);
        let is_claim = |id: &str| {
            passes.equations.iter().any(|equation| {
                equation.id == id && matches!(equation.finding.verdict, Verdict::Certified | Verdict::Verified)
            })
        };
        let with_sum = notes.equations.iter().rev().find_map(|display| {
            let id = display.id()?;
            let body = &text[display.body.start..display.body.end];
            let sign = body.find(" + ").or_else(|| body.find(" - "))? + display.body.start;
            is_claim(id).then(|| (id.to_owned(), sign))
        });
        let (id, sign) = with_sum.unwrap_or_else(|| panic!("{} has no sum", path.display()));
        let other = if text[sign..].starts_with(" +") { " - " } else { " + " };
        let slipped = [&text[..sign], other, &text[sign + 3..]].concat();
        let notes = Notes::parse(Arc::new(Source::new("notes.md", slipped)), Kind::Markdown).expect("it can be read");
        let document = check(&claims, &notes);
        let wrong = document.equations.iter().find(|equation| equation.id == id).expect("it is there");
        assert!(!wrong.ok, "{} ({id}) passes with another sign", path.display());
    }
}
