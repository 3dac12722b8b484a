//! `onshell check --fix`: the one repair of an equation that leaves no doubt, made in the file.
//!
//! A repair is made if it is the only one, or of a likelier kind of slip than the next; after asking, or at once with
//! `--yes`. One that mends what several wrong equations stand on goes before those of the equations themselves. Left to
//! the author are: one that mends a step alone, which the rest carries on; one after which a side is zero whatever it is
//! made of; a term or a factor that stands nowhere in the notes and is no number; another name, a term or a factor where
//! anything else is offered; edits of two displays of which either mends all; and what leaves out a part of another
//! display. One of an equation that stands on what nothing else vouches for, or that changes a statement which is not
//! wrong by itself, is made after asking alone; so is a sign, a number or a factor in a chain that says what a name is, which
//! could as well be mended on its other side. Nothing else in the file changes, and nothing at all if the file is no
//! longer as it was checked.

use std::io::{BufRead, IsTerminal, Write};

use crate::check::{Document, Equation, Repair, Report};
use crate::latex::slips::Slip;
use crate::report::diagnostic;
use crate::{Error, Result};

use super::colours;

/// What was done to the notes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Made {
    /// Nothing.
    Nothing,
    /// All that leaves no doubt.
    All,
    /// What several equations stand on was mended; only then it shows what else is wrong.
    Shared,
}

/// Makes the repairs that leave no doubt.
pub(super) fn fix(report: &Report, yes: bool) -> Result<Made> {
    let mut made = Made::Nothing;
    for document in &report.documents {
        let mut chosen: Vec<&Repair> = Vec::new();
        let mut clear: Vec<(&Equation, &Repair)> =
            document.equations.iter().filter_map(|equation| Some((equation, clear(document, equation)?))).collect();
        if clear.iter().any(|(_, repair)| mends_several(repair)) {
            clear.retain(|(_, repair)| mends_several(repair));
        }
        for (equation, repair) in clear {
            // Of two that put something in at one place only the first is made.
            let apart = |other: &&Repair| {
                other.span != repair.span
                    && (other.span.end <= repair.span.start || repair.span.end <= other.span.start)
            };
            let doubt = doubt(equation, repair);
            if let (true, Some(doubt)) = (yes, &doubt) {
                let left = format!("({}): its repair is left to you, as {doubt}", equation.id);
                writeln!(std::io::stderr(), "{left}").map_err(|error| Error::new(format!("cannot say: {error}")))?;
                continue;
            }
            if chosen.iter().all(apart) && (yes || agreed(document, equation, repair)?) {
                chosen.push(repair);
            }
        }
        if !chosen.is_empty() {
            apply(document, &chosen)?;
            let is_shared = made == Made::Shared || chosen.iter().any(|repair| repair.shared.is_some());
            made = if is_shared { Made::Shared } else { Made::All };
        }
    }
    Ok(made)
}

/// The repair of an equation that is the only one, or clearly the likeliest.
fn clear<'e>(document: &Document, equation: &'e Equation) -> Option<&'e Repair> {
    let display = |repair: &Repair| repair.shared.as_ref().map(|shared| shared.of.clone());
    // Where the equation's own display is mended, what else may be wrong is a doubt, and is said as one.
    let is_own = equation.repairs.first().is_some_and(|first| first.shared.is_none());
    let repairs: Vec<&Repair> = equation.repairs.iter().filter(|other| !is_own || other.shared.is_none()).collect();
    match repairs[..] {
        [only] => Some(only),
        // Two displays could be wrong instead.
        [first, second, ..]
            if first.shared.is_some() && second.shared.is_some() && display(first) != display(second) =>
        {
            None
        }
        // Of what several equations stand on: likelier than a slip in each of them.
        [first, second, ..] if first.shared.is_some() && second.shared.is_none() => Some(first),
        [first, second, ..] if first.shared.is_some() && second.shared.is_some() && first.slip >= second.slip => None,
        // A sign put in makes true what was meant otherwise.
        [first, ..] if first.slip == Slip::Sign && first.span.start == first.span.end => None,
        // So does another name, or what is put in or left out.
        [first, _, ..] if matches!(first.slip, Slip::Name | Slip::Factor | Slip::Term) => None,
        [first, second, ..] if first.slip < second.slip => Some(first),
        _ => None,
    }
    // Without a term of a definition much is true that nobody meant.
    .filter(|repair| {
        let leaves_out = matches!(repair.slip, Slip::Factor | Slip::Term) && repair.replacement.trim().is_empty();
        repair.shared.is_none() || !leaves_out
    })
    .filter(|repair| !repair.step && !repair.idle && repair.is_in_the_notes(&document.source.text))
}

/// Whether several equations are mended at once.
fn mends_several(repair: &Repair) -> bool {
    repair.shared.as_ref().is_some_and(|shared| shared.mends.len() > 1)
}

/// Why a repair is for its author to make: the slip may be in another place.
fn doubt(equation: &Equation, repair: &Repair) -> Option<String> {
    if mends_several(repair) {
        return None;
    }
    let others: Vec<&str> = equation.elsewhere.iter().map(String::as_str).filter(|id| *id != equation.id).collect();
    if others.len() < equation.elsewhere.len() && is_undone_on_either_side(repair.slip) {
        return Some("nothing that holds uses what it introduces, and either side may be wrong".to_owned());
    }
    if !others.is_empty() {
        return Some(format!("nothing that holds stands on ({})", others.join("), (")));
    }
    let mut wrong = equation.parts.iter().filter(|part| !part.ok).map(|part| part.finding.span);
    let is_elsewhere =
        repair.shared.is_none() && wrong.clone().next().is_some() && !wrong.any(|w| w.contains(repair.span));
    is_elsewhere.then(|| "it changes what is not wrong by itself".to_owned())
}

/// Whether what a slip does to one side of an equation can be done to the other instead.
fn is_undone_on_either_side(slip: Slip) -> bool {
    let kinds =
        [Slip::Sign, Slip::Number, Slip::Exponent, Slip::Order, Slip::Fraction, Slip::Name, Slip::Factor, Slip::Term];
    kinds.contains(&slip)
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
