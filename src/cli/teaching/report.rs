//! `onshell report`: the verdicts as pages to read in a browser.

use std::path::{Path, PathBuf};

use crate::check::Report;
use crate::derive::Derivation;
use crate::error::reason;
use crate::lecture::Lecture;
use crate::notes::Claims;
use crate::page;
use crate::systems::Registry;
use crate::{Error, Result};

use crate::cli::check;
use crate::cli::outcome::{Outcome, Screen, shown};

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
    let lectures = lectures(&report, registry);
    let pages = page::pages(&report, &lectures, arguments.single);
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

/// The derivations of the systems that the documents name, each once. A system whose equations cannot be typeset has
/// none; `onshell derive` says why.
fn lectures(report: &Report, registry: &Registry) -> Vec<Lecture> {
    let mut names: Vec<String> = Vec::new();
    for path in report.documents.iter().filter_map(|document| document.claims.as_ref()) {
        let system = Claims::read(Path::new(path), path).ok().and_then(|claims| claims.system);
        names.extend(system.map(|system| system.name.value).filter(|name| !names.contains(name)));
    }
    let lecture = |name: &String| {
        let lagrangian = registry.get(name)?;
        let derivation = Derivation::of(lagrangian).ok()?;
        Lecture::new(&lagrangian.trace().ok()?, &derivation, SEED).ok()
    };
    names.iter().filter_map(lecture).collect()
}

/// The seed of the sampled states of a derivation.
const SEED: u64 = 1;

/// Writes pages into a folder, which is made if it is not there.
///
/// # Errors
/// When the folder or a file cannot be written.
pub(super) fn write(folder: &Path, pages: &[page::Page]) -> Result<()> {
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
