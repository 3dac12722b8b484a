//! `onshell report`: the verdicts as pages to read in a browser.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::check::Report;
use crate::error::reason;
use crate::lecture::{Beside, Lecture};
use crate::page::{self, Exhibit};
use crate::plot;
use crate::systems::Registry;
use crate::{Error, Result};

use crate::cli::check;
use crate::cli::outcome::{Outcome, Screen, shown};
use crate::cli::system::subject::Subject;

/// Writes pages that show every equation typeset, with its verdict and the evidence
///
/// DIR gets an index.html and a page for each document. Exits as `check` does.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  onshell report derivations --out pages\n  onshell report notes.md --out . --single"
)]
pub struct Arguments {
    /// Claims files (.json), notes (.md, .tex, .ipynb, .rst and others), or folders of these
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// The claims file for the notes, if it is not beside them
    #[arg(long, value_name = "FILE")]
    claims: Vec<PathBuf>,
    /// The folder for the pages; it is made if it is not there
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Write one file, index.html, with everything in it
    #[arg(long)]
    single: bool,
}

pub(crate) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let (report, mut errors) = check::documents(&arguments.paths, &arguments.claims, registry);
    let exhibits = exhibits(&report, registry);
    let pages = page::pages(&report, &exhibits.iter().collect::<Vec<_>>(), arguments.single);
    let code = if errors.is_empty() { report.exit_code() } else { 2 };
    let written = if report.documents.is_empty() { Ok(()) } else { write(&arguments.out, &pages) };
    if let Err(error) = written {
        errors.push(error);
        return Outcome { output: String::new(), messages: shown(&errors, screen), code: 2 };
    }
    let output = match report.documents.is_empty() {
        true => String::new(),
        false => format!("{}\n", arguments.out.join("index.html").display()),
    };
    Outcome { output, messages: shown(&errors, screen), code }
}

/// What follows from the systems of the documents: each system of the registry once, and the Lagrangian of each notes that
/// define one. A system whose equations cannot be typeset has no derivation; `onshell derive` says why.
pub(super) fn exhibits(report: &Report, registry: &Registry) -> Vec<Exhibit> {
    let mut all: Vec<(Subject<'_>, Vec<String>)> = Vec::new();
    for document in &report.documents {
        // The notes are read again for their Lagrangian only if they speak of one.
        let text = &document.source.text;
        if document.claims.is_none() && !text.contains("agrang") && !text.contains("partial") {
            continue;
        }
        let path = document.claims.as_ref().unwrap_or(&document.path);
        let Ok(Some(subject)) = Subject::of_notes(Path::new(path), &[], registry) else { continue };
        let is_known =
            |(known, _): &&mut (Subject<'_>, Vec<String>)| known.is_named() && known.name() == subject.name();
        match all.iter_mut().find(is_known).filter(|_| subject.is_named()) {
            Some((_, documents)) => documents.push(document.path.clone()),
            None => all.push((subject, vec![document.path.clone()])),
        }
    }
    let exhibits = all.into_par_iter().filter_map(|(subject, documents)| exhibit(&subject, documents));
    exhibits.collect()
}

fn exhibit(subject: &Subject<'_>, documents: Vec<String>) -> Option<Exhibit> {
    let lecture = || {
        let lecture = Lecture::new(&subject.system, &subject.derivation().ok()?, SEED).ok()?;
        // The steps of notes that do not all pass would explain nothing.
        (lecture.exit_code() == 0).then_some(lecture)
    };
    let (lecture, (beside, pictures)) = rayon::join(lecture, || {
        let beside = subject.derivation().and_then(|derivation| Beside::new(subject.system.clone(), derivation));
        (beside.ok(), plot::gallery(&subject.system))
    });
    (lecture.is_some() || !pictures.is_empty()).then_some(Exhibit { lecture, beside, pictures, documents })
}

/// The seed of the sampled states of a derivation.
const SEED: u64 = 1;

/// Writes pages into a folder, which is made if it is not there.
///
/// # Errors
/// When the folder or a file cannot be written.
pub(crate) fn write(folder: &Path, pages: &[page::Page]) -> Result<()> {
    let failed = |path: &Path, error: &std::io::Error| {
        Error::new(format!("cannot write {}: {}", path.display(), reason(error)))
            .help("name a folder under --out that can be written")
    };
    std::fs::create_dir_all(folder).map_err(|error| failed(folder, &error))?;
    for page in pages {
        let path = folder.join(&page.name);
        std::fs::write(&path, &page.text).map_err(|error| failed(&path, &error))?;
    }
    Ok(())
}
