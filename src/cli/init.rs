//! `onshell init`: the inferred claims of notes, written beside them to be corrected.

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::check::{Options, Run, draft};
use crate::error::reason;
use crate::notes::{Notes, claims_beside};
use crate::report::wrap;
use crate::systems::Registry;
use crate::{Error, Result};

use super::files::documents::{Job, find};
use super::files::replace_file::replace;
use super::outcome::{Outcome, Screen, shown};

/// Writes a claims file beside notes, with what is inferred from them
///
/// Each guess stands in the file with its reason. `check` gives the same verdicts with the file as without it, until you
/// correct it.
///
/// Exits with 0 if every file was written, 2 if one was not.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell init notes.md\n  onshell check notes.md")]
pub struct Arguments {
    /// Notes (.md, .tex, .ipynb, .rst and others), or folders of these
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// Replace claims files that are there already
    #[arg(long)]
    overwrite: bool,
}

pub(super) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let (mut output, mut errors) = (String::new(), Vec::new());
    let mut tell = |line: &str| output += &(wrap("", line, 2, screen.out.width) + "\n");
    let mut written = Vec::new();
    for path in &arguments.paths {
        for job in notes_of(path, arguments.overwrite).unwrap_or_else(|error| vec![Err(error)]) {
            let made = job.and_then(|job| match job {
                Named::Notes(notes) => write(&notes, arguments.overwrite, registry),
                Named::Claimed(claims) => {
                    Ok(format!("{}: this claims file exists already; it was not changed", claims.display()))
                }
            });
            match made {
                Ok(line) => {
                    tell(&line);
                    written.push(path);
                }
                Err(error) => errors.push(error),
            }
        }
    }
    if let Some(path) = written.first() {
        let check = format!("onshell\u{a0}check\u{a0}{}", path.display());
        tell("");
        tell("Next: correct what is wrong in the file. Under \"guesses\" stands the reason for each declaration.");
        tell(&format!("Then run: {check}"));
        tell(
            "When all declarations are right, remove \"guesses\". Each equation must then follow from what is \
             declared. List an equation that is a law, and is not to be checked, by its number: \"laws\": { \"Newton's \
             second law\": \"1\" }.",
        );
    }
    Outcome { output, code: if errors.is_empty() { 0 } else { 2 }, messages: shown(&errors, screen) }
}

/// A document that a path names.
enum Named {
    Notes(PathBuf),
    /// A claims file of a folder.
    Claimed(PathBuf),
}

/// The notes that a path names. In a folder, those that have claims already are left as they are.
fn notes_of(path: &Path, overwrite: bool) -> Result<Vec<Result<Named>>> {
    if path.extension().is_some_and(|extension| extension == "json") {
        return Err(Error::new(format!("{} is not a file of notes", path.display()))
            .help("give the file of the notes, as in onshell init notes.md; its claims file will be notes.json"));
    }
    let named = |job| match job {
        Job::Notes(notes) | Job::Pair { notes, .. } => Ok(Named::Notes(notes)),
        Job::Claims(claims) if overwrite => crate::notes::Claims::read(&claims, &claims.display().to_string())
            .map(|read| Named::Notes(read.notes_path())),
        Job::Claims(claims) => Ok(Named::Claimed(claims)),
    };
    Ok(find(path, &[])?.into_iter().map(named).collect())
}

/// Writes the claims file of notes. Returns what was written.
fn write(path: &Path, overwrite: bool, registry: &Registry) -> Result<String> {
    let beside = claims_beside(path);
    let (from, to) = (path.display(), beside.display());
    let exists = beside.exists();
    if exists && !overwrite {
        return Err(Error::new(format!("{to} is there already")).help("add --overwrite to replace it"));
    }
    let notes = Notes::read(path, &from.to_string())?;
    let options = Options { seed: 1, points: 24, explain: false, ..Options::default() };
    let draft = draft(&Run { registry, options, only: None, progress: &() }, &notes)?;
    if exists {
        let before =
            std::fs::read(&beside).map_err(|error| Error::new(format!("cannot read {to}: {}", reason(&error))))?;
        replace(&beside, &before, draft.text.as_bytes())?;
    } else {
        // Another program may have made the file in the meantime; it stays.
        let made = std::fs::OpenOptions::new().write(true).create_new(true).open(&beside);
        let failed = |error| {
            Error::new(format!("cannot write {to}: {}", reason(&error)))
                .help("make its folder writable, or free space on the disk")
        };
        made.and_then(|mut file| file.write_all(draft.text.as_bytes())).map_err(failed)?;
    }
    let names = match draft.declared {
        0 if notes.equations.is_empty() => "no display was found in the notes, so nothing was inferred".to_owned(),
        0 => "no name needs a declaration".to_owned(),
        1 => "onshell guessed what 1 name means".to_owned(),
        n => format!("onshell guessed what {n} names mean"),
    };
    Ok(format!("{to}: written; {names}"))
}
