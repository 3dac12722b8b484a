//! `onshell report`: the verdicts as pages to read in a browser.

use std::path::PathBuf;

use crate::error::reason;
use crate::page;
use crate::systems::Registry;
use crate::{Error, Result};

use super::check;
use super::outcome::{Outcome, Screen, shown};

/// Writes pages that show every equation typeset, with its verdict and the evidence
///
/// DIR gets an index.html and a page for each document. Exits as `check` does.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  onshell report derivations --out pages\n  onshell report notes.md --out . --single"
)]
pub struct Arguments {
    /// Claims files (.json), notes (.md, .tex), or folders of these
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

pub(super) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let (report, mut errors) = check::documents(&arguments.paths, &arguments.claims, registry);
    let pages = page::pages(&report, arguments.single);
    let code = if errors.is_empty() { report.exit_code() } else { 2 };
    let written = if report.documents.is_empty() { Ok(()) } else { write(arguments, &pages) };
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

/// # Errors
/// When the folder or a file cannot be written.
fn write(arguments: &Arguments, pages: &[page::Page]) -> Result<()> {
    let failed = |path: &std::path::Path, error: &std::io::Error| {
        Error::new(format!("cannot write {}: {}", path.display(), reason(error)))
            .help("name a folder under --out that can be written")
    };
    std::fs::create_dir_all(&arguments.out).map_err(|error| failed(&arguments.out, &error))?;
    for page in pages {
        let path = arguments.out.join(&page.name);
        std::fs::write(&path, &page.text).map_err(|error| failed(&path, &error))?;
    }
    Ok(())
}
