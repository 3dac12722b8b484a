//! `onshell check --fix`: the suggested edits that are clear, made in the notes.
//!
//! An edit is clear if it is the only one of its equation, or undoes a likelier kind of mistake than the next one. It is
//! made after asking, or at once with `--yes`. An edit of a display that several wrong equations use is made before edits
//! of the equations themselves.
//!
//! These edits are left to the author:
//! - an edit that corrects one step of a chain only;
//! - an edit after which a side is zero whatever its symbols mean;
//! - a new term or factor that stands nowhere in the notes and is not a number;
//! - another name, a term or a factor, where anything else is suggested;
//! - an edit of one of two displays that contradict each other;
//! - an edit of another display, where an edit of a third display would do as well, or where it leaves something out.
//!
//! These edits are made after asking only: an edit of an equation that uses a display which no passing equation uses; an
//! edit outside of the part that fails; a sign, a number or a factor in a definition whose other side may be wrong.
//! A display that cannot be read is never edited: what it says is not known. Nothing else in the file changes, and nothing
//! at all if the file has changed since it was checked ([`super::files::replace_file`]). After the edits the file is checked again;
//! an edited equation that does not pass then is named.
//!
//! Offers `fix`, which edits the notes of a report, and `not_passing`, what still fails after it. Knows reports and `files`.

use std::io::{BufRead, IsTerminal, Write};
use std::path::Path;

use crate::check::{Document, Equation, Repair, Report, Verdict};
use crate::code::Code;
use crate::latex::slips::Slip;
use crate::report::{Style, mutants, suggestion, wrap};
use crate::{Error, Result};

use super::files::replace_file::replace;

/// What was done to the notes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Made {
    /// Nothing.
    Nothing,
    /// All clear edits.
    All,
    /// An edit of a display that several equations use. Only another check shows what else is wrong.
    Shared,
}

/// The result of `--fix`.
#[derive(Debug)]
pub(super) struct Fixed {
    /// What was done to the notes.
    pub made: Made,
    /// What was edited, and the edits that are left to the author with the reasons: a sentence each.
    pub told: Vec<String>,
    /// The edited equations, which should pass now: each as the path of its notes and its name.
    pub edited: Vec<(String, String)>,
    /// Why files could not be changed, or the author not be asked.
    pub errors: Vec<Error>,
}

/// Makes the edits that are clear.
pub(super) fn fix(report: &Report, yes: bool, style: Style) -> Fixed {
    let mut fixed = Fixed { made: Made::Nothing, told: Vec::new(), edited: Vec::new(), errors: Vec::new() };
    if let Err(error) = fix_documents(report, yes, style, &mut fixed) {
        fixed.errors.push(error);
    }
    fixed
}

/// The sentences on edited equations that do not pass in `report`, which is of the edited notes.
pub(super) fn not_passing(edited: &[(String, String)], report: &Report) -> Vec<String> {
    let found = |(path, id): &(String, String)| {
        let document = report.documents.iter().find(|document| document.path == *path)?;
        let equation = document.equations.iter().find(|equation| equation.id == *id)?;
        let verdict = equation.finding.verdict;
        (!equation.ok)
            .then(|| format!("({id}) was edited as suggested in {path}, but now it is {verdict}: undo the edit"))
    };
    edited.iter().filter_map(found).collect()
}

fn fix_documents(report: &Report, yes: bool, style: Style, fixed: &mut Fixed) -> Result<()> {
    for document in &report.documents {
        let mut chosen: Vec<&Repair> = Vec::new();
        let mut told = Vec::new();
        let mut edited = Vec::new();
        let unclear = |equation: &&Equation| !equation.repairs.is_empty() && clear(document, equation).is_none();
        fixed.told.extend(document.equations.iter().filter(unclear).map(|equation| {
            let why = match equation.finding.code {
                Code::Contradiction => "two displays contradict each other, and only you know which is wrong",
                _ => "no suggested edit of this equation is safe to make automatically",
            };
            format!("({}) was not edited: {why}; choose an edit by hand", equation.id)
        }));
        let mut clear: Vec<(&Equation, &Repair)> =
            document.equations.iter().filter_map(|equation| Some((equation, clear(document, equation)?))).collect();
        if clear.iter().any(|(_, repair)| mends_several(repair)) {
            clear.retain(|(_, repair)| mends_several(repair));
        }
        for (equation, repair) in clear {
            // Of two edits at one place, only the first is made.
            let apart = |other: &&Repair| {
                other.span != repair.span
                    && (other.span.end <= repair.span.start || repair.span.end <= other.span.start)
            };
            if let Some(reason) = unwritable(document, repair) {
                fixed.told.push(format!("({}) was not edited: {reason}; edit it by hand", equation.id));
                continue;
            }
            let doubt = doubt(equation, repair);
            if let (true, Some(doubt)) = (yes, &doubt) {
                fixed.told.push(format!("({}) was not edited: {doubt}", equation.id));
                continue;
            }
            if chosen.iter().all(apart) && (yes || agreed(document, equation, repair, style)?) {
                told.push(sentence(document, equation, repair));
                chosen.push(repair);
                let ids = repair.shared.as_ref().map_or(vec![equation.id.clone()], |shared| shared.mends.clone());
                edited.extend(ids.into_iter().map(|id| (document.path.clone(), id)));
            }
        }
        if !chosen.is_empty() {
            apply(document, &chosen)?;
            fixed.told.append(&mut told);
            fixed.edited.append(&mut edited);
            let is_shared = fixed.made == Made::Shared || chosen.iter().any(|repair| repair.shared.is_some());
            fixed.made = if is_shared { Made::Shared } else { Made::All };
        }
    }
    Ok(())
}

/// The sentence that an edit was made.
fn sentence(document: &Document, equation: &Equation, repair: &Repair) -> String {
    let (line, column) = document.source.line_column(repair.span.start);
    let change = mutants::change(document.source.slice(repair.span).trim(), &repair.replacement);
    format!("({}) was edited at {}:{line}:{column}: {change}", equation.id, document.source.path_at(repair.span.start))
}

/// The edit of an equation that is the only one, or clearly the likeliest.
fn clear<'e>(document: &Document, equation: &'e Equation) -> Option<&'e Repair> {
    // Of two displays that contradict each other, only the author knows which is wrong.
    if equation.finding.code == Code::Contradiction {
        return None;
    }
    let display = |repair: &Repair| repair.shared.as_ref().map(|shared| shared.of.clone());
    // If the first edit is one of the equation itself, edits of other displays are doubts (see `doubt`).
    let is_own = equation.repairs.first().is_some_and(|first| first.shared.is_none());
    let repairs: Vec<&Repair> = equation.repairs.iter().filter(|other| !is_own || other.shared.is_none()).collect();
    match repairs[..] {
        [only] => Some(only),
        // Either of two displays may be wrong.
        [first, second, ..]
            if first.shared.is_some() && second.shared.is_some() && display(first) != display(second) =>
        {
            None
        }
        // One mistake that several equations share is likelier than one in each.
        [first, second, ..] if first.shared.is_some() && second.shared.is_none() => Some(first),
        [first, second, ..] if first.shared.is_some() && second.shared.is_some() && first.slip >= second.slip => None,
        // An added sign can make an equation true that was meant otherwise.
        [first, ..] if first.slip == Slip::Sign && first.span.start == first.span.end => None,
        // So can another name, and a term or a factor that is added or left out.
        [first, _, ..] if matches!(first.slip, Slip::Name | Slip::Factor | Slip::Term) => None,
        [first, second, ..] if first.slip < second.slip => Some(first),
        _ => None,
    }
    // Without a term of a definition, many equations hold that nobody meant.
    .filter(|repair| {
        let leaves_out = matches!(repair.slip, Slip::Factor | Slip::Term) && repair.replacement.trim().is_empty();
        repair.shared.is_none() || !leaves_out
    })
    .filter(|repair| !repair.step && !repair.idle && repair.is_in_the_notes(&document.source.text))
    .filter(|repair| is_read(document, equation, repair))
}

/// Whether the equation, and the display that an edit changes, can be read.
fn is_read(document: &Document, equation: &Equation, repair: &Repair) -> bool {
    let is_read = |equation: &Equation| equation.finding.verdict != Verdict::Unreadable;
    let changed = |other: &&Equation| repair.shared.as_ref().is_some_and(|shared| shared.of == other.id);
    is_read(equation) && document.equations.iter().filter(changed).all(is_read)
}

/// Whether an edit corrects several equations at once.
fn mends_several(repair: &Repair) -> bool {
    repair.shared.as_ref().is_some_and(|shared| shared.mends.len() > 1)
}

/// Why an edit is left to the author: the mistake may be in another place.
fn doubt(equation: &Equation, repair: &Repair) -> Option<String> {
    if mends_several(repair) {
        return None;
    }
    let others: Vec<&str> = equation.elsewhere.iter().map(String::as_str).filter(|id| *id != equation.id).collect();
    if others.len() < equation.elsewhere.len() && is_undone_on_either_side(repair.slip) {
        return Some(
            "no passing equation uses the name that this equation defines, so either side may be wrong".to_owned(),
        );
    }
    if !others.is_empty() {
        return Some(format!("no passing equation uses ({0}), so the mistake may be in ({0})", others.join(") or (")));
    }
    let mut wrong = equation.parts.iter().filter(|part| !part.ok).map(|part| part.finding.span);
    let is_elsewhere =
        repair.shared.is_none() && wrong.clone().next().is_some() && !wrong.any(|w| w.contains(repair.span));
    is_elsewhere.then(|| "the suggested edit changes a part of the equation that does not fail".to_owned())
}

/// Whether an edit of the other side of an equation could undo this kind of mistake as well.
fn is_undone_on_either_side(slip: Slip) -> bool {
    let kinds =
        [Slip::Sign, Slip::Number, Slip::Exponent, Slip::Order, Slip::Fraction, Slip::Name, Slip::Factor, Slip::Term];
    kinds.contains(&slip)
}

/// Asks whether to make an edit.
fn agreed(document: &Document, equation: &Equation, repair: &Repair, style: Style) -> Result<bool> {
    let (input, mut terminal) = (std::io::stdin(), std::io::stderr());
    if !input.is_terminal() {
        return Err(Error::new("--fix asks before it changes a file, and standard input is not a terminal")
            .help("add --yes to make the likely edits without asking"));
    }
    let shown = suggestion::repair(repair, true, &document.source, style);
    let question = wrap("", &format!("change {}? [y/N]", document.path), 2, style.width);
    let failed = |error: std::io::Error| Error::new(format!("cannot ask: {error}"));
    write!(terminal, "({}):\n{shown}\n{question} ", equation.id).map_err(failed)?;
    let mut answer = String::new();
    input.lock().read_line(&mut answer).map_err(failed)?;
    Ok(matches!(answer.trim(), "y" | "Y" | "yes"))
}

/// Writes the files of the notes with edits made, the last first, so that the places of the others stay.
fn apply(document: &Document, repairs: &[&Repair]) -> Result<()> {
    let mut edits = Vec::new();
    for repair in repairs {
        let edit = document.source.edit(repair.span, &repair.replacement);
        edits.push(edit.map_err(|reason| Error::new(format!("cannot edit {}: {reason}", document.path)))?);
    }
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.place.span.start));
    let mut paths: Vec<&str> = edits.iter().map(|edit| edit.place.file.path.as_str()).collect();
    paths.sort_unstable();
    paths.dedup();
    for path in paths {
        let mut own = edits.iter().filter(|edit| edit.place.file.path == path).peekable();
        let Some(file) = own.peek().map(|edit| edit.place.file) else { continue };
        let mut text = file.text.clone();
        own.for_each(|edit| text.replace_range(edit.place.span.range(), &edit.replacement));
        let unwritable = || {
            Error::new(format!(
                "cannot edit {path}: the encoding of the file lacks a character of the edit; save the file as UTF-8"
            ))
        };
        let before = file.encode(&file.text).ok_or_else(unwritable)?;
        replace(Path::new(path), &before, &file.encode(&text).ok_or_else(unwritable)?)?;
    }
    Ok(())
}

/// Why the file cannot be edited so, if it cannot.
fn unwritable(document: &Document, repair: &Repair) -> Option<String> {
    document.source.edit(repair.span, &repair.replacement).err().map(str::to_owned)
}
