//! `onshell check --fix`: the one repair of an equation that leaves no doubt, made in the file.
//!
//! A repair is made if it is the only one, or of a likelier kind of slip than the next; after asking, or at once with
//! `--yes`. One that mends a step alone, which the rest carries on, is left to the author. Nothing else in the file changes, and nothing at all if the file is no longer as it was checked.

use std::io::{BufRead, IsTerminal, Write};

use crate::check::{Document, Equation, Repair, Report};
use crate::report::diagnostic;
use crate::{Error, Result};

use super::colours;

/// Makes the repairs that leave no doubt; how many were made.
pub(super) fn fix(report: &Report, yes: bool) -> Result<usize> {
    let mut made = 0;
    for document in &report.documents {
        let mut chosen: Vec<&Repair> = Vec::new();
        for (equation, repair) in document.equations.iter().filter_map(|equation| Some((equation, clear(equation)?))) {
            let apart = |other: &&Repair| other.span.end <= repair.span.start || repair.span.end <= other.span.start;
            if chosen.iter().all(apart) && (yes || agreed(document, equation, repair)?) {
                chosen.push(repair);
            }
        }
        if !chosen.is_empty() {
            apply(document, &chosen)?;
            made += chosen.len();
        }
    }
    Ok(made)
}

/// The repair of an equation that is the only one, or clearly the likeliest.
fn clear(equation: &Equation) -> Option<&Repair> {
    match equation.repairs.as_slice() {
        [only] => Some(only),
        [first, second, ..] if first.slip < second.slip => Some(first),
        _ => None,
    }
    .filter(|repair| !repair.step)
}

/// Asks whether a repair is to be made.
fn agreed(document: &Document, equation: &Equation, repair: &Repair) -> Result<bool> {
    let (input, mut terminal) = (std::io::stdin(), std::io::stderr());
    if !input.is_terminal() {
        return Err(Error::new("--fix asks before it changes a file, and there is no terminal to ask at")
            .help("add --yes to make every repair that leaves no doubt"));
    }
    let shown = diagnostic::repair(repair, true, &document.source, colours(&terminal));
    let failed = |error: std::io::Error| Error::new(format!("cannot ask: {error}"));
    write!(terminal, "({}): {shown}\nchange {}? [y/N] ", equation.id, document.path).map_err(failed)?;
    let mut answer = String::new();
    input.lock().read_line(&mut answer).map_err(failed)?;
    Ok(matches!(answer.trim(), "y" | "Y" | "yes"))
}

/// Writes the notes with repairs made, the last first, so that the places of the others stay.
fn apply(document: &Document, repairs: &[&Repair]) -> Result<()> {
    let path = &document.path;
    let failed = |error: std::io::Error| Error::new(format!("cannot change {path}: {error}"));
    if std::fs::read_to_string(path).map_err(failed)? != document.source.text {
        return Err(Error::new(format!("{path} has changed since it was checked")).help("run the command again"));
    }
    let mut text = document.source.text.clone();
    let mut sorted = repairs.to_vec();
    sorted.sort_by_key(|repair| std::cmp::Reverse(repair.span.start));
    for repair in sorted {
        text.replace_range(repair.span.range(), &repair.replacement);
    }
    std::fs::write(path, text).map_err(failed)
}
