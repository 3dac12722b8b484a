//! `onshell check`: from documents to verdicts.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::check::document::setup;
use crate::check::{Document, Options, Report, Run, check_claims, check_reprint, reprint, unaided};
use crate::notes::Notes;
use crate::report::{self, wrap};
use crate::systems::Registry;
use crate::{Error, Result};

use super::files::documents::{Job, Loaded, equations_of, find, folder, load, misnamed};
use super::fix::{Fixed, Made, fix, not_passing};
use super::outcome::{Outcome, Screen, shown};
use super::progress::ProgressLine;
use super::values;

/// Checks the equations of notes against their claims
///
/// Notes without a claims file are checked too. The report says what follows, what is taken for granted, and what one
/// likely slip has made wrong.
///
/// Exits with 0 if every equation is as expected, 1 if one is not, 2 if something could not be checked.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  onshell check notes.md\n  onshell check derivations --only 6.73 --verbose")]
pub struct Arguments {
    /// Claims files (.json), notes with their claims beside them (.md, .tex, .ipynb, .rst and others), or folders of these
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// The claims file for the notes, if it is not beside them; may be repeated, or be a folder of claims files
    ///
    /// If the claims are about another file, the notes are checked as a second copy of that file, number by number.
    #[arg(long, value_name = "FILE")]
    claims: Vec<PathBuf>,
    /// Check only the equation with this number or label
    #[arg(long, value_name = "ID")]
    only: Option<String>,
    /// The seed of the sampled states
    #[arg(long, default_value_t = 1, allow_negative_numbers = true, value_parser = values::seed)]
    seed: u64,
    /// The number of sampled states for each equation
    #[arg(long, default_value_t = 24, allow_negative_numbers = true, value_parser = values::points)]
    points: u32,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    format: ReportFormat,
    /// List every equation, how it was read, and what was inferred
    #[arg(short, long)]
    verbose: bool,
    /// Exit with 2 where something was not decided or not read, and where notes have no claims file or one with guesses
    #[arg(long)]
    strict: bool,
    /// Make the likely edits among the suggested ones, after asking for each, and check again
    #[arg(long)]
    fix: bool,
    /// Make the edits of --fix without asking
    #[arg(long, requires = "fix")]
    yes: bool,
}

/// The form of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum ReportFormat {
    /// For people
    Text,
    /// For programs
    Json,
    /// Workflow commands of GitHub Actions
    Github,
    /// SARIF 2.1.0, for code scanning, with the repairs as fixes
    Sarif,
    /// JUnit XML, for GitLab and Jenkins
    Junit,
}

pub(super) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let (mut result, mut errors) = checked(arguments, registry);
    let mut told = Vec::new();
    let mut again = arguments.fix;
    while again {
        again = false;
        let Fixed { made, told: more, edited, errors: failures } = fix(&result, arguments.yes, screen.err);
        told.extend(more);
        if made != Made::Nothing {
            (result, errors) = checked(arguments, registry);
            let still_wrong = not_passing(&edited, &result);
            again = made == Made::Shared && still_wrong.is_empty() && failures.is_empty();
            told.extend(still_wrong);
        }
        errors.extend(failures);
    }
    if arguments.fix && told.is_empty() && errors.is_empty() {
        told.push(match result.unexpected() {
            0 => "nothing was edited: everything is as expected".to_owned(),
            _ => "nothing was edited: there is no suggestion for the equations that are not as expected".to_owned(),
        });
    }
    told.splice(0..0, warnings(arguments));
    let mut known = HashSet::new();
    told.retain(|line: &String| known.insert(line.clone()));
    let code = match errors.is_empty() {
        true if arguments.strict => result.strict_exit_code(),
        true => result.exit_code(),
        false => 2,
    };
    let output = match arguments.format {
        ReportFormat::Text if result.documents.is_empty() && !errors.is_empty() => String::new(),
        ReportFormat::Text => report::text::report(&result, arguments.verbose, screen.out),
        ReportFormat::Json => format!("{:#}\n", report::json::report(&result, &errors)),
        ReportFormat::Github => report::requests::github::report(&result, &errors),
        ReportFormat::Sarif => format!("{:#}\n", report::requests::sarif::report(&result, &errors)),
        ReportFormat::Junit => report::requests::junit::report(&result, &errors),
    };
    let told: String = told.iter().map(|line| wrap("", line, 2, screen.err.width) + "\n").collect();
    Outcome { output, messages: told + &shown(&errors, screen), code }
}

/// What is said of claims files whose notes are not there.
fn warnings(arguments: &Arguments) -> Vec<String> {
    let Ok((paths, claims)) = given(arguments) else { return Vec::new() };
    let jobs = paths.into_iter().filter_map(|path| find(path, &claims).ok()).flatten();
    jobs.flat_map(|job| misnamed(&job)).collect()
}

/// The report on these paths with the usual options.
pub(super) fn documents(paths: &[PathBuf], claims: &[PathBuf], registry: &Registry) -> (Report, Vec<Error>) {
    let arguments = Arguments {
        paths: paths.to_vec(),
        claims: claims.to_vec(),
        only: None,
        seed: 1,
        points: 24,
        format: ReportFormat::Text,
        verbose: false,
        strict: false,
        fix: false,
        yes: false,
    };
    checked(&arguments, registry)
}

/// The report on the documents that are named, and the errors of those that could not be checked.
fn checked(arguments: &Arguments, registry: &Registry) -> (Report, Vec<Error>) {
    let options = Options { seed: arguments.seed, points: arguments.points as usize, ..Options::default() };
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
    errors.extend(loaded.iter().flatten().flat_map(|loaded| loaded.notes().absent.iter().cloned()));
    let items = loaded.iter().flatten().map(|loaded| loaded.items(only)).sum();
    let known = equations_of(loaded.iter().flatten().map(Loaded::notes));
    let progress = ProgressLine::start(items);
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
        // Of several documents, only those that have the equation are shown.
        result.documents.retain(|document| !document.equations.is_empty());
        if result.documents.is_empty() && errors.is_empty() {
            errors.push(Error::new(format!("there is no equation ({only})")).help(known));
        }
    }
    (result, errors)
}

/// The paths to check, and the claims files that are given for them.
///
/// With `--claims`, a claims file among the paths is one more of these: a shell expands `--claims derivations/*.json` so.
fn given(arguments: &Arguments) -> Result<(Vec<&Path>, Vec<PathBuf>)> {
    let paths = arguments.paths.iter().map(PathBuf::as_path);
    if arguments.claims.is_empty() {
        return Ok((paths.collect(), Vec::new()));
    }
    let is_claims = |path: &&Path| path.extension().is_some_and(|extension| extension == "json");
    let (more, paths): (Vec<&Path>, Vec<&Path>) = paths.partition(is_claims);
    if paths.is_empty() {
        return Err(Error::new("--claims names a claims file, and the command names no notes to check")
            .help("give the notes too: onshell check notes.md --claims claims.json"));
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

impl Loaded {
    /// The number of equations and sentences to check.
    fn items(&self, only: Option<&str>) -> usize {
        match self {
            Loaded::Own(claims, notes) => setup::items(claims, notes, only),
            Loaded::Reprint(sets, print) => reprint::items(sets, print, only),
            Loaded::Unclaimed(notes) => notes.equations.len(),
        }
    }

    fn notes(&self) -> &Notes {
        match self {
            Loaded::Own(_, notes) | Loaded::Reprint(_, notes) | Loaded::Unclaimed(notes) => notes,
        }
    }

    fn check(self, run: &Run<'_>) -> Result<Document> {
        match &self {
            Loaded::Own(claims, notes) => check_claims(run, claims, notes),
            Loaded::Reprint(sets, print) => check_reprint(run, sets, print),
            Loaded::Unclaimed(notes) => unaided(run, notes),
        }
    }
}
