//! From paths to documents: which files belong together, and their texts.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use crate::code::Code;
use crate::error::reason;
use crate::notes::formats::Format;
use crate::notes::{Claims, Kind, Notes, claims_beside, json};
use crate::{Error, Result};

/// The files of a document.
pub(crate) enum Job {
    Claims(PathBuf),
    Pair { notes: PathBuf, claims: Vec<PathBuf> },
    Notes(PathBuf),
}

/// The documents that a path names. `claims` are the claims files for notes whose claims are not beside them.
pub(crate) fn find(path: &Path, claims: &[PathBuf]) -> Result<Vec<Job>> {
    if path.is_dir() {
        if !claims.is_empty() {
            return Err(Error::new(format!("--claims cannot be used with the folder {}", path.display())).help(
                "give the file of the notes, or leave out --claims; then the claims file beside each document is used",
            ));
        }
        let mut jobs = Vec::new();
        folder(path, &mut jobs)?;
        without_parts(&mut jobs);
        if jobs.is_empty() {
            return Err(Error::new(format!("there is nothing to check in {}", path.display())).help(
                "notes are .md, .tex and other files; a claims file beside them has the same name and ends in .json",
            ));
        }
        return Ok(jobs);
    }
    if path.extension().is_some_and(|extension| extension == "json") {
        return Ok(vec![Job::Claims(path.to_owned())]);
    }
    if let Err(error) = path.metadata() {
        return Err(Error::new(format!("cannot read {}: {}", path.display(), reason(&error))));
    }
    if claims.is_empty() && !claims_beside(path).exists() {
        return Ok(vec![Job::Notes(path.to_owned())]);
    }
    let claims = if claims.is_empty() { vec![claims_beside(path)] } else { claims.to_vec() };
    if let Some(absent) = claims.iter().find(|claims| !claims.exists()) {
        return Err(Error::new(format!("there is no claims file {}", absent.display()))
            .with_code(Code::NoClaimsFile)
            .help("correct the name after --claims, or leave out --claims to check the notes without a claims file"));
    }
    Ok(vec![Job::Pair { notes: path.to_owned(), claims }])
}

/// The documents of a folder and of those in it, in the order of their names. A part of a TeX project is no document of its own.
///
/// Left out are hidden folders, those of packages, and those that a build marks as its own.
pub(crate) fn folder(path: &Path, jobs: &mut Vec<Job>) -> Result<()> {
    let unreadable =
        |error: std::io::Error| Error::new(format!("cannot read the folder {}: {}", path.display(), reason(&error)));
    let entries: std::io::Result<Vec<_>> = std::fs::read_dir(path).map_err(unreadable)?.collect();
    let mut paths: Vec<PathBuf> = entries.map_err(unreadable)?.into_iter().map(|entry| entry.path()).collect();
    paths.sort();
    for path in &paths {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        if path.is_dir() {
            // A link to a folder could lead back here.
            let name = path.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
            let is_foreign = name.starts_with('.') || name == "node_modules" || path.join("CACHEDIR.TAG").is_file();
            if !path.is_symlink() && !is_foreign {
                folder(path, jobs)?;
            }
        } else if !path.is_file() {
            continue;
        } else if extension == "json" && names_notes(path) {
            jobs.push(Job::Claims(path.clone()));
        } else if extension != "txt" && !claims_beside(path).exists() && has_displays(path) {
            jobs.push(Job::Notes(path.clone()));
        }
    }
    Ok(())
}

/// Removes the TeX files that are parts of others.
fn without_parts(jobs: &mut Vec<Job>) {
    let is_tex = |path: &Path| Format::of(path).is_some_and(|format| format.kind == Kind::Tex);
    let canonical = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let mut parts = HashSet::new();
    for job in jobs.iter() {
        if let Job::Notes(path) = job
            && is_tex(path)
            && let Ok(notes) = Notes::read(path, &shown(path))
        {
            parts.extend(notes.source.files().iter().skip(1).map(|part| canonical(Path::new(&part.path))));
        }
    }
    jobs.retain(|job| !matches!(job, Job::Notes(path) if parts.contains(&canonical(path))));
}

/// Whether notes without a claims file have displays. Those that cannot be read count, so that their error is reported; but
/// not programs, in whose comments a dollar sign may be anything.
fn has_displays(path: &Path) -> bool {
    let Some(format) = Format::of(path) else { return false };
    if format.is_code {
        return Notes::read(path, &shown(path)).is_ok_and(|notes| !notes.equations.is_empty());
    }
    !Notes::read(path, &shown(path)).is_ok_and(|notes| notes.equations.is_empty())
}

/// Whether a JSON file is a claims file. One that cannot be read counts as one, so that its error is reported.
fn names_notes(path: &Path) -> bool {
    let Ok(text) = std::fs::read_to_string(path) else { return true };
    text.contains("\"notes\"") || text.trim().is_empty() || json::read(&text).is_err()
}

/// The contents of the files of a job.
pub(crate) enum Loaded {
    /// Claims, and the notes that they are about.
    Own(Box<Claims>, Notes),
    /// Claims, each with the notes that they are about, and another edition of these notes.
    Reprint(Vec<(Claims, Notes)>, Notes),
    /// Notes without a claims file.
    Unclaimed(Notes),
}

/// Reads the files of a job.
pub(crate) fn load(job: &Job) -> Result<Loaded> {
    let notes_at = |path: &Path| Notes::read(path, &shown(path));
    let (path, files) = match job {
        Job::Notes(path) => return Ok(Loaded::Unclaimed(notes_at(path)?)),
        Job::Claims(path) => {
            let claims = Claims::read(path, &shown(path))?;
            let notes = notes_at(&claims.notes_path())?;
            return Ok(Loaded::Own(Box::new(claims), notes));
        }
        Job::Pair { notes, claims } => (notes, claims),
    };
    let notes = notes_at(path)?;
    let mut sets = Vec::new();
    for file in files {
        let claims = Claims::read(file, &shown(file))?;
        let own = claims.notes_path();
        // Claims whose notes are not there are taken to be about what is.
        if !own.exists() || is_same(&own, path) {
            if files.len() == 1 {
                return Ok(Loaded::Own(Box::new(claims), notes));
            }
            let message = format!(
                "{} claims files are given, but {} is the claims file of {}",
                files.len(),
                shown(file),
                shown(path)
            );
            return Err(Error::new(message).help(format!("give only {}", shown(file))));
        }
        sets.push((claims, notes_at(&own)?));
    }
    Ok(Loaded::Reprint(sets, notes))
}

/// The claims files of a job whose notes are not there, and that are taken to be about the notes of the job.
pub(crate) fn misnamed(job: &Job) -> Vec<String> {
    let Job::Pair { notes, claims } = job else { return Vec::new() };
    let said = |file: &PathBuf| {
        let own = Claims::read(file, &shown(file)).ok()?.notes_path();
        let is_other = own.file_name() != notes.file_name() && !own.exists();
        is_other.then(|| {
            let (file, notes) = (shown(file), shown(notes));
            format!(
                "warning: {file} is about {}, which is not there; it is used for {notes}. Correct \"notes\" in {file}.",
                shown(&own)
            )
        })
    };
    claims.iter().filter_map(said).collect()
}

/// The equations of notes by their numbers and labels, for the advice where one is not found.
pub(crate) fn equations_of<'n>(notes: impl Iterator<Item = &'n Notes>) -> String {
    const MOST: usize = 12;
    let ids: Vec<String> = notes
        .flat_map(|notes| &notes.equations)
        .filter_map(|display| display.id())
        .map(|id| format!("({id})"))
        .collect();
    match ids.as_slice() {
        [] => "no display in the notes has a number or a label; give the display a number, as in \\tag{1}".to_owned(),
        all if all.len() <= MOST => format!("the notes have {}", all.join(", ")),
        [first, .., last] => format!("the notes have {} equations, from {first} to {last}", ids.len()),
        [only] => format!("the notes have {only}"),
    }
}

fn is_same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
