//! `onshell check`: documents to verdicts.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::check::{Document, Options, Report, Run, check_in, check_reprint, document, reprint, unclaimed};
use crate::notes::{Claims, Notes, claims_beside, json};
use crate::report;
use crate::systems::Registry;
use crate::{Error, Result};

use super::progress::Terminal;
use super::{Format, Outcome, colours};

/// Checks the equations of notes against their claims
///
/// Exits with 0 if every equation is as expected, 1 if one is not, 2 if something could not be checked.
#[derive(clap::Args)]
pub struct Arguments {
    /// Claims files (.json), notes with their claims beside them (.md, .tex), or folders of these
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// The claims file to use for the notes, if it is not beside them; may be repeated, or a folder of claims files
    ///
    /// Claims about another file are applied to the notes as to a second print of its equations, number by number.
    #[arg(long, value_name = "FILE")]
    claims: Vec<PathBuf>,
    /// Check only the equation with this number or label
    #[arg(long, value_name = "ID")]
    only: Option<String>,
    /// The seed of the sampled states
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How many usable states each claim is tested at
    #[arg(long, default_value_t = 24, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    points: u32,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Show how each equation was read, and what was inferred
    #[arg(short, long)]
    verbose: bool,
}

pub(super) fn run(arguments: &Arguments, registry: &Registry) -> Outcome {
    let options = Options { seed: arguments.seed, points: arguments.points as usize };
    let colour = colours(&std::io::stderr());
    let mut errors: Vec<Error> = Vec::new();
    let mut result = Report::default();
    let mut jobs = Vec::new();
    match given(arguments) {
        Ok((paths, claims)) => {
            for path in paths {
                match find(path, &claims) {
                    Ok(found) => jobs.extend(found),
                    Err(error) => errors.push(error),
                }
            }
        }
        Err(error) => errors.push(error),
    }
    let only = arguments.only.as_deref();
    let loaded: Vec<Result<Loaded>> = jobs.par_iter().map(load).collect();
    let items = loaded.iter().flatten().map(|loaded| loaded.items(only)).sum();
    let progress = Terminal::start(items);
    let run = Run { registry, options, only, progress: &progress };
    let checked: Vec<Result<Document>> = loaded.into_par_iter().map(|loaded| loaded?.check(&run)).collect();
    drop(progress);
    for document in checked {
        match document {
            Ok(document) => result.documents.push(document),
            Err(error) => errors.push(error),
        }
    }
    if let Some(only) = only {
        // With several documents, `--only` means the one that has the equation.
        result.documents.retain(|document| !document.equations.is_empty());
        if result.documents.is_empty() && errors.is_empty() {
            let error = Error::new(format!("there is no equation ({only})")).help("name it by its number or its label");
            errors.push(error);
        }
    }
    let code = if errors.is_empty() { result.exit_code() } else { 2 };
    let output = match arguments.format {
        Format::Text if result.documents.is_empty() && !errors.is_empty() => String::new(),
        Format::Text => report::text::report(&result, arguments.verbose, colours(&std::io::stdout())),
        Format::Json => format!("{:#}\n", report::json::report(&result, &errors)),
    };
    let shown = errors.iter().map(|error| report::diagnostic::error(error, colour) + "\n").collect();
    Outcome { output, errors: shown, code }
}

/// Notes with their claims, or without.
enum Job {
    Claims(PathBuf),
    Pair { notes: PathBuf, claims: Vec<PathBuf> },
    Notes(PathBuf),
}

/// What is to be checked, and the claims files that are given for it.
///
/// Beside `--claims`, a claims file among the paths is one more of them: so a shell writes `--claims derivations/*.json`.
fn given(arguments: &Arguments) -> Result<(Vec<&Path>, Vec<PathBuf>)> {
    let paths = arguments.paths.iter().map(PathBuf::as_path);
    if arguments.claims.is_empty() {
        return Ok((paths.collect(), Vec::new()));
    }
    let is_claims = |path: &&Path| path.extension().is_some_and(|extension| extension == "json");
    let (more, paths): (Vec<&Path>, Vec<&Path>) = paths.partition(is_claims);
    if paths.is_empty() {
        return Err(Error::new("the claims are given, and no notes to apply them to")
            .help("onshell check notes.md --claims claims.json"));
    }
    let mut claims = Vec::new();
    for path in arguments.claims.iter().map(PathBuf::as_path).chain(more) {
        if !path.is_dir() {
            claims.push(path.to_owned());
            continue;
        }
        let mut jobs = Vec::new();
        folder(path, &mut jobs)?;
        let before = claims.len();
        claims.extend(jobs.into_iter().filter_map(|job| match job {
            Job::Claims(claims) => Some(claims),
            Job::Pair { .. } | Job::Notes(_) => None,
        }));
        if claims.len() == before {
            return Err(Error::new(format!("there is no claims file in {}", path.display())));
        }
    }
    Ok((paths, claims))
}

fn find(path: &Path, claims: &[PathBuf]) -> Result<Vec<Job>> {
    if path.is_dir() {
        if !claims.is_empty() {
            return Err(Error::new(format!("{} is a folder, and claims are applied to notes", path.display()))
                .help("name the notes, or leave out --claims: each document of a folder has its claims beside it"));
        }
        let mut jobs = Vec::new();
        folder(path, &mut jobs)?;
        if jobs.is_empty() {
            return Err(Error::new(format!("there is nothing to check in {}", path.display()))
                .help("a document is a notes file (.md, .tex) with a claims file (.json) of the same name beside it"));
        }
        return Ok(jobs);
    }
    if path.extension().is_some_and(|extension| extension == "json") {
        return Ok(vec![Job::Claims(path.to_owned())]);
    }
    if let Err(error) = path.metadata() {
        return Err(Error::new(format!("cannot read {}: {error}", path.display())));
    }
    let claims = if claims.is_empty() { vec![claims_beside(path)] } else { claims.to_vec() };
    if let Some(absent) = claims.iter().find(|claims| !claims.exists()) {
        return Err(Error::new(format!("{} has no claims file", path.display()))
            .help(format!("it would be {}", absent.display())));
    }
    Ok(vec![Job::Pair { notes: path.to_owned(), claims }])
}

/// The documents of a folder and of those in it, in the order of their names.
fn folder(path: &Path, jobs: &mut Vec<Job>) -> Result<()> {
    let unreadable = |error: std::io::Error| Error::new(format!("cannot read the folder {}: {error}", path.display()));
    let entries: std::io::Result<Vec<_>> = std::fs::read_dir(path).map_err(unreadable)?.collect();
    let mut paths: Vec<PathBuf> = entries.map_err(unreadable)?.into_iter().map(|entry| entry.path()).collect();
    paths.sort();
    for path in &paths {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        if path.is_dir() {
            // A link to a folder could lead back here.
            if !path.is_symlink() {
                folder(path, jobs)?;
            }
        } else if !path.is_file() {
            continue;
        } else if extension == "json" && names_notes(path) {
            jobs.push(Job::Claims(path.clone()));
        } else if matches!(extension, "md" | "tex") && !claims_beside(path).exists() {
            jobs.push(Job::Notes(path.clone()));
        }
    }
    Ok(())
}

/// Whether a JSON file is a claims file, rather than some other: one that cannot be read counts, to be reported.
fn names_notes(path: &Path) -> bool {
    let Ok(text) = std::fs::read_to_string(path) else { return true };
    text.contains("\"notes\"") || text.trim().is_empty() || json::read(&text).is_err()
}

/// The files of a job, read.
enum Loaded {
    /// Claims and the notes that they are about.
    Own(Box<Claims>, Notes),
    /// Claims, each with the notes that they are about, for another print of these.
    Reprint(Vec<(Claims, Notes)>, Notes),
    Unclaimed(Notes),
}

impl Loaded {
    /// How many equations and sentences there are to check.
    fn items(&self, only: Option<&str>) -> usize {
        match self {
            Loaded::Own(claims, notes) => document::items(claims, notes, only),
            Loaded::Reprint(sets, print) => reprint::items(sets, print, only),
            Loaded::Unclaimed(_) => 0,
        }
    }

    fn check(self, run: &Run<'_>) -> Result<Document> {
        match &self {
            Loaded::Own(claims, notes) => check_in(run, claims, notes),
            Loaded::Reprint(sets, print) => check_reprint(run, sets, print),
            Loaded::Unclaimed(notes) => Ok(unclaimed(notes)),
        }
    }
}

fn load(job: &Job) -> Result<Loaded> {
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
            let message = format!("{} is about {} itself", shown(file), shown(path));
            return Err(Error::new(message).help("give it alone; the others are about other notes"));
        }
        sets.push((claims, notes_at(&own)?));
    }
    Ok(Loaded::Reprint(sets, notes))
}

fn is_same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
