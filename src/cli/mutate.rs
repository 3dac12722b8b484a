//! `onshell mutate`: mutation testing of documents.

use std::path::PathBuf;

use rayon::prelude::*;

use crate::check::document::setup;
use crate::check::mutation::{Mutants, Mutated, mutate};
use crate::check::{Options, Run};
use crate::report;
use crate::systems::Registry;
use crate::{Error, Result};

use super::files::documents::{Loaded, equations_of, find, load};
use super::outcome::{Format, Outcome, Screen, shown};
use super::progress::ProgressLine;
use super::values;

/// Changes one thing at a time in the equations of notes, such as a sign, and lists the changes that the check would not detect
///
/// Exits with 0 if it would detect all, 1 if a mistake would pass, 2 if something could not be checked.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell mutate notes.md --only 6.73")]
pub struct Arguments {
    /// Claims files (.json), notes with their claims beside them (.md, .tex, .ipynb, .rst and others), or folders of these
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// Mutate only the equation with this number or label
    #[arg(long, value_name = "ID")]
    only: Option<String>,
    /// Also look for corrections of each detected mistake, and tell how often the original is suggested
    #[arg(long)]
    repair: bool,
    /// The seed of the sampled states
    #[arg(long, default_value_t = 1, allow_negative_numbers = true, value_parser = values::seed)]
    seed: u64,
    /// The number of sampled states for each mutant
    #[arg(long, default_value_t = 24, allow_negative_numbers = true, value_parser = values::points)]
    points: u32,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// List every equation
    #[arg(short, long)]
    verbose: bool,
}

pub(super) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let options = Options { seed: arguments.seed, points: arguments.points as usize, ..Options::default() };
    let only = arguments.only.as_deref();
    let mut errors: Vec<Error> = Vec::new();
    let mut jobs = Vec::new();
    for path in &arguments.paths {
        match find(path, &[]) {
            Ok(found) => jobs.extend(found),
            Err(error) => errors.push(error),
        }
    }
    let loaded: Vec<Result<Loaded>> = jobs.par_iter().map(load).collect();
    let equations = |loaded: &Loaded| match loaded {
        Loaded::Own(claims, notes) => setup::equations(claims, notes, only),
        Loaded::Reprint(..) | Loaded::Unclaimed(_) => 0,
    };
    let known = equations_of(loaded.iter().flatten().filter_map(|loaded| match loaded {
        Loaded::Own(_, notes) => Some(notes),
        Loaded::Reprint(..) | Loaded::Unclaimed(_) => None,
    }));
    let unclaimed = |loaded: &Loaded| match loaded {
        Loaded::Unclaimed(notes) => Some(notes.source.path.clone()),
        Loaded::Own(..) | Loaded::Reprint(..) => None,
    };
    let without_claims: Vec<String> = loaded.iter().flatten().filter_map(unclaimed).collect();
    let progress = ProgressLine::start(loaded.iter().flatten().map(equations).sum());
    let run = Run { registry, options, only, progress: &progress };
    let mutated: Vec<Result<Option<Mutated>>> = loaded
        .into_par_iter()
        .map(|loaded| match loaded? {
            Loaded::Own(claims, notes) => mutate(&run, &claims, &notes, arguments.repair).map(Some),
            Loaded::Reprint(..) | Loaded::Unclaimed(_) => Ok(None),
        })
        .collect();
    drop(progress);
    let mut documents = Vec::new();
    for found in mutated {
        match found {
            Ok(found) => documents.extend(found),
            Err(error) => errors.push(error),
        }
    }
    if only.is_some() {
        documents.retain(|document| !document.equations.is_empty());
    }
    let survivors: usize = documents.iter().flat_map(|d| &d.equations).map(|e| e.survivors.len()).sum();
    let mutants: usize = documents.iter().flat_map(|d| &d.equations).map(|e| e.count()).sum();
    if mutants == 0 && errors.is_empty() {
        let left_out: Vec<&Mutants> =
            documents.iter().flat_map(|d| &d.equations).filter(|e| e.left_out.is_some()).collect();
        errors.push(match left_out.as_slice() {
            [] => match (only, without_claims.as_slice()) {
                (_, [first, ..]) => Error::new(format!("{first} has no claims file, so nothing in it can be mutated"))
                    .help(format!("write one with: onshell init {first}")),
                (Some(only), _) => Error::new(format!("there is no equation ({only}) to mutate"))
                    .help(format!("{known}; only displays with a number or a label are mutated")),
                (None, _) => Error::new("there is no equation to mutate").help(known),
            },
            all => Error::new(format!("no equation can be mutated, because {} left out", counted(all.len())))
                .help("only an equation that passes is mutated; `onshell check` shows what is wrong with the others"),
        });
    }
    let code = if !errors.is_empty() { 2 } else { u8::from(survivors > 0) };
    let output = match arguments.format {
        Format::Text if documents.is_empty() => String::new(),
        Format::Text => report::mutants::text(&documents, arguments.verbose, screen.out),
        Format::Json => format!("{:#}\n", report::mutants::json(&documents, &errors)),
    };
    Outcome { output, messages: shown(&errors, screen), code }
}

fn counted(equations: usize) -> String {
    if equations == 1 { "1 equation was".to_owned() } else { format!("all {equations} equations were") }
}
