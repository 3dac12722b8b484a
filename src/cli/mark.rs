//! `onshell mark`: a class of hand-ins against a problem.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::check::mark::{Mark, Marked, Problem, Reached};
use crate::check::{Options, Run};
use crate::error::reason;
use crate::notes::{Claims, Notes};
use crate::page;
use crate::report::marks::{self, Hints};
use crate::systems::Registry;
use crate::{Error, Result};

use super::outcome::{Outcome, Screen, shown};
use super::values;

/// Marks hand-ins: each line against a problem, and against the lines before it
///
/// The problem is a claims file; its notes are the model solution. Hand-ins need no equation numbers, and may use other letters.
///
/// A line is right (✓: it follows from the problem), wrong (✗), carried (→: a right step from a wrong line), given (a name, a
/// condition, or what the problem gives), undecided or not read (?). Missing results are listed.
///
/// Exits with 0 if every line is right and no result is missing, 1 if a line is wrong or a result is missing, 2 if something
/// was not read or not decided, or could not be marked.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  onshell mark class/*.md --claims problem.json\n  \
                  onshell mark class --claims problem.json --format csv > marks.csv\n  \
                  onshell mark anna.md --claims problem.json --hints 2")]
pub struct Arguments {
    /// Hand-ins (.md, .tex, .txt), or folders of these
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The claims file of the problem
    #[arg(long, value_name = "FILE")]
    claims: PathBuf,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
    /// What a hint says: 0 that something is wrong, 1 where, 2 what kind of slip, 3 the correction
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::hints)]
    hints: u8,
    /// Write a page for each student, and an index, into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// The seed of the sampled states
    #[arg(long, default_value_t = 1, allow_negative_numbers = true, value_parser = values::seed)]
    seed: u64,
}

/// The endings of claims files and of tables of marks, which may lie beside hand-ins.
const OF_THE_TEACHER: [&str; 2] = ["json", "csv"];

/// The form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Form {
    /// For people.
    Text,
    /// A table, one row for each student and line.
    Csv,
    /// The same rows as JSON.
    Json,
}

pub(crate) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let (class, warnings, errors) = match marked(arguments, registry) {
        Ok(found) => found,
        Err(error) => return Outcome { output: String::new(), messages: shown(&[error], screen), code: 2 },
    };
    let hints = Hints(arguments.hints);
    let mut errors = errors;
    if let Some(folder) = &arguments.out {
        let pages = page::class_pages(&arguments.claims.display().to_string(), &class, hints);
        errors.extend(super::pages::report::write(folder, &pages).err());
    }
    let output = match arguments.format {
        Form::Text if class.is_empty() => String::new(),
        Form::Text => marks::text(&class, hints, screen.out),
        Form::Csv => marks::csv(&class, hints),
        Form::Json => format!("{:#}\n", marks::json(&arguments.claims.display().to_string(), &class, hints)),
    };
    let code = match () {
        () if !errors.is_empty() => 2,
        () if class.iter().any(Marked::is_wrong) => 1,
        () if class.iter().any(Marked::is_open) => 2,
        () => 0,
    };
    Outcome { output, messages: warnings + &shown(&errors, screen), code }
}

/// The marked hand-ins, what is to be said of the model solution, and the errors of hand-ins that cannot be opened.
///
/// # Errors
/// For a problem that cannot be used.
fn marked(arguments: &Arguments, registry: &Registry) -> Result<(Vec<Marked>, String, Vec<Error>)> {
    let at = &arguments.claims;
    let claims = Claims::read(at, &at.display().to_string())?;
    let path = claims.notes_path();
    let notes = Notes::read(&path, &path.display().to_string())?;
    let options = Options { seed: arguments.seed, points: 24, explain: true, ..Options::default() };
    let run = Run { registry, options, only: None, progress: &() };
    let problem = Problem::prepare(&run, &claims, &notes)?;
    // What is held against the model solution would be held against every student who writes the same.
    let mut warnings = of_the_model(&problem.mark(&run, &path, &notes.source.text));
    let mut errors = Vec::new();
    let mut files = Vec::new();
    for path in &arguments.files {
        match hand_ins(path, &claims.notes_path()) {
            Ok((found, others)) => {
                files.extend(found);
                warnings += &passed_over(path, &others);
            }
            Err(error) => errors.push(error),
        }
    }
    let class: Vec<Result<Marked>> = files
        .par_iter()
        .with_max_len(1)
        .map(|path| {
            let bytes = std::fs::read(path)
                .map_err(|error| Error::new(format!("cannot read {}: {}", path.display(), reason(&error))))?;
            Ok(problem.mark(&run, path, &String::from_utf8_lossy(&bytes)))
        })
        .collect();
    let mut marked = Vec::new();
    for found in class {
        match found {
            Ok(found) => marked.push(found),
            Err(error) => errors.push(error),
        }
    }
    Ok((marked, warnings, errors))
}

/// What the marks of the model solution itself show of the problem: its lines that are wrong, and its results that it does not reach.
fn of_the_model(model: &Marked) -> String {
    let path = &model.source.path;
    let mut text = String::new();
    for line in model.lines.iter().filter(|line| line.mark == Mark::Wrong) {
        text += &format!(
            "warning: {path}:{}: this line of the model solution would be marked wrong in a hand-in: it {}\n  help: \
             declare the names in the line, or say in words under which condition it holds\n\n",
            line.line, line.because
        );
    }
    for result in model.results.iter().filter(|result| result.reached == Reached::No) {
        text += &format!(
            "warning: {path}: no hand-in can reach the result {}: no line of the model solution reaches it\n  help: \
             print the result as a formula in the model solution; if it is a number, remove it from \"results\"\n\n",
            marks::called(result)
        );
    }
    text
}

/// A warning that names what in a folder was not marked, and why; nothing, if that is nothing.
fn passed_over(folder: &Path, others: &[PathBuf]) -> String {
    if others.is_empty() {
        return String::new();
    }
    let why = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match () {
            () if path.is_dir() => format!("{name} is a folder"),
            () if !path.exists() => format!("{name} is a link to a file that does not exist"),
            () => format!("{name} is not .md, .tex or .txt"),
        }
    };
    let all: Vec<String> = others.iter().map(why).collect();
    format!(
        "warning: {}: not marked: {}\n  help: to mark a folder inside this one, name it on the command line too; save \
         other files as .md, .tex or .txt\n\n",
        folder.display(),
        all.join("; ")
    )
}

/// The hand-ins that a path names: the file, or the notes in a folder, without the problem's own; and what else is in the folder but for
/// hidden files and files of the teacher.
fn hand_ins(path: &Path, own: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>)> {
    if !path.is_dir() {
        if let Err(error) = path.metadata() {
            return Err(Error::new(format!("cannot read {}: {}", path.display(), reason(&error))));
        }
        return match crate::notes::document::Kind::of(path) {
            Some(_) => Ok((vec![path.to_owned()], Vec::new())),
            None => {
                Err(Error::new(format!("{} is not a hand-in", path.display())).help("a hand-in is .md, .tex or .txt"))
            }
        };
    }
    let failed =
        |error: std::io::Error| Error::new(format!("cannot read the folder {}: {}", path.display(), reason(&error)));
    let entries: std::io::Result<Vec<_>> = std::fs::read_dir(path).map_err(failed)?.collect();
    let mut files: Vec<PathBuf> = entries.map_err(failed)?.into_iter().map(|entry| entry.path()).collect();
    let own = own.canonicalize().ok();
    files.retain(|file| own.is_none() || file.canonicalize().ok() != own);
    files.sort();
    let is_notes = |file: &PathBuf| crate::notes::document::Kind::of(file).is_some() && file.is_file();
    let (files, mut others): (Vec<PathBuf>, Vec<PathBuf>) = files.into_iter().partition(is_notes);
    others.retain(|file| {
        let is_hidden = file.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
        !is_hidden && !file.extension().is_some_and(|end| OF_THE_TEACHER.iter().any(|other| end == *other))
    });
    match files.is_empty() {
        true => {
            Err(Error::new(format!("there is no hand-in in {}", path.display())).help("hand-ins are .md, .tex or .txt"))
        }
        false => Ok((files, others)),
    }
}
