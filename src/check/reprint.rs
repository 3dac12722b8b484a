//! A second print of the same equations, checked by the claims about the first.
//!
//! The claims file and its own notes, the *reference*, give names, definitions, hypotheses and errata. Each display of the
//! print with the number of an equation of the reference is read with these names and checked by the claim of that number.
//! A statement that reads as in the reference is what it is there: a definition, for example. Any other statement must hold
//! with the names of the reference, and the display must say as much as the reference: a missing link or row is reported.
//! Sentences are quoted from the reference, and checked there only.
//!
//! # How a converted copy is checked
//!
//! A lost bar may leave a formula that reads well and means something else. So the print is read with the names of
//! a reference, and the readings are compared as trees without places. If they are the same, the reference's
//! verdict is right by construction; if they differ, the print's own formula is tested. Definitions are never taken
//! from a print, so damage in one display cannot spread, and cannot make a damaged definition true by definition.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::code::Code;
use crate::latex::{Macros, Reading};
use crate::notes::claims::{Claim, Claims, Expected};
use crate::notes::document::Numbered;
use crate::notes::{Display, Notes};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::document::names::{repeated, unjudged};
use crate::check::document::reading::corrected;
use crate::check::document::reread::{missing_from_print, read_in_place, reads_alike};
use crate::check::document::setup::{Run, define_macros, with_checker};
use crate::check::equations::merge::worst;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::{Document, Equation, Part};

/// Checks a print by claims, each with its reference. If several have a claim about an equation, the worst finding counts; a
/// numbered equation without a claim is unclaimed. If the print uses a number twice, the first display is checked, and the
/// second gets a finding about its number.
///
/// # Errors
/// As [`check_document`](super::check_document) for each reference, and for a print that has no number of any.
pub fn check_reprint(run: &Run<'_>, sets: &[(Claims, Notes)], print: &Notes) -> Result<Document> {
    let found: Vec<Vec<Equation>> =
        sets.par_iter().map(|(claims, reference)| apply(run, claims, reference, print)).collect::<Result<_>>()?;
    if !sets.iter().any(|(_, reference)| pairs(reference, print).any(|(_, display)| display.is_some())) {
        let names: Vec<&str> = sets.iter().map(|(_, reference)| reference.source.path.as_str()).collect();
        let message = format!("{} and {} have no equation number in common", print.source.path, names.join(" or "));
        return Err(Error::new(message)
            .help("the claims of other notes are found by the numbers of the equations; check the numbers"));
    }
    let mut equations: Vec<Equation> = Vec::new();
    for equation in found.into_iter().flatten() {
        match equations.iter_mut().find(|known| known.id == equation.id) {
            Some(known) if known.finding.verdict.severity() < equation.finding.verdict.severity() => *known = equation,
            Some(_) => {}
            None => equations.push(equation),
        }
    }
    for display in wanted(run, print) {
        let Some(number) = display.id().filter(|number| equations.iter().all(|known| known.id != *number)) else {
            continue;
        };
        let message = format!("the notes of the claims file have no ({number}); add it there, or remove it here");
        let finding = Finding::new(Code::NoClaim, Verdict::Unclaimed, display.body, message);
        equations.push(unjudged(print, number, display.line, finding));
    }
    for (number, line) in repeated(print) {
        if run.only.is_none_or(|only| number.id == only) {
            let message = format!("the number ({}) is used twice: on line {line}, and here", number.id);
            let finding = Finding::new(Code::NotesFile, Verdict::Unreadable, number.span, message);
            let line = print.source.line_column(number.span.start).0;
            equations.push(unjudged(print, &number.id, line, finding));
        }
    }
    equations.sort_by_key(|equation| (equation.line, equation.finding.span.start));
    let paths: Vec<&str> = sets.iter().map(|(claims, _)| claims.source.path.as_str()).collect();
    let inferred = sets.iter().map(|(claims, reference)| {
        let (claims, own, sentences) = (&claims.source.path, &reference.source.path, claims.sentences.len());
        format!("{claims} is about {own}; its {sentences} quoted sentences are checked there, not here")
    });
    Ok(Document {
        is_guessed: false,
        automatic_numbers: BTreeMap::new(),
        path: print.source.path.clone(),
        claims: Some(paths.join(", ")),
        source: print.source.clone(),
        equations,
        sentences: Vec::new(),
        unnumbered: print.equations.iter().filter(|display| display.id().is_none()).count(),
        inferred: inferred.collect(),
        definitions: Vec::new(),
    })
}

fn wanted<'a>(run: &'a Run<'_>, notes: &'a Notes) -> impl Iterator<Item = &'a Display> {
    notes.equations.iter().filter(|display| run.only.is_none_or(|only| display.id() == Some(only)))
}

/// The numbered equations of a reference, by their places, each with the display of the print that has its number.
fn pairs<'a>(reference: &'a Notes, print: &'a Notes) -> impl Iterator<Item = (usize, Option<&'a Display>)> {
    let number = |display: &'a Display| display.number.as_ref().map(|number| number.id.as_str());
    let numbered = reference.equations.iter().enumerate().filter_map(move |(at, d)| Some((at, number(d)?)));
    numbered.map(move |(at, wanted)| (at, print.equations.iter().find(|display| number(display) == Some(wanted))))
}

/// The equations of a reference to check, each with its display in the print; none, if the print has none of its numbers.
fn work<'a>(reference: &'a Notes, print: &'a Notes, only: Option<&str>) -> Vec<(usize, Option<&'a Display>)> {
    let all: Vec<_> = pairs(reference, print).collect();
    if all.iter().all(|(_, display)| display.is_none()) {
        return Vec::new();
    }
    let chosen = |at: usize| only.is_none_or(|only| reference.equations[at].id() == Some(only));
    all.into_iter().filter(|(at, _)| chosen(*at)).collect()
}

/// The number of equations that [`check_reprint`] checks.
pub fn items(sets: &[(Claims, Notes)], print: &Notes, only: Option<&str>) -> usize {
    sets.iter().map(|(_, reference)| work(reference, print, only).len()).sum()
}

/// The findings on the equations of one reference, as the print has them.
fn apply(run: &Run<'_>, claims: &Claims, reference: &Notes, print: &Notes) -> Result<Vec<Equation>> {
    let work = work(reference, print, run.only);
    if work.is_empty() {
        return Ok(Vec::new());
    }
    with_checker(run, claims, reference, |checker| {
        let mut macros = checker.model.macros.clone();
        define_macros(&print.macros, &mut macros);
        let checker = Checker { source: &print.source, ..checker };
        let judged = work.par_iter().map(|(at, display)| {
            let equation = match display {
                Some(display) => equation(&checker, &macros, *at, display),
                None => Ok(absent(reference, print, *at)),
            };
            run.progress.done(&print.source.path);
            equation
        });
        judged.collect()
    })
}

/// The finding on a display that prints the `at`-th equation of the checker's notes.
fn equation(checker: &Checker<'_>, macros: &Macros, at: usize, display: &Display) -> Result<Equation> {
    let none = Claim::default();
    let claim = checker.assigned[at].unwrap_or(&none);
    let reading = read_in_place(checker, macros, at, &display.text, claim);
    let mut parts = judged(checker, (at, display), &reading, claim)?;
    let original = || checker.as_printed(&checker.notes.equations[at].text, claim, macros);
    if let Some(message) = missing_from_print(checker, &reading, &checker.readings[at])
        && (claim.errata.is_empty() || missing_from_print(checker, &reading, &original()).is_some())
    {
        parts.push(
            checker.part(Finding::new(Code::LostInPrint, Verdict::Unreadable, display.body, message), String::new()),
        );
    }
    let failed = parts.iter().any(|part| !part.finding.verdict.passes());
    // A failure that the reference expects is expected here too, if both read the same.
    let excused = parts.iter().all(|p| p.finding.verdict.passes() || p.finding.verdict == Verdict::Refuted);
    let (mut ok, mut because) = (!failed, None);
    let known = claim.expect.as_ref().filter(|expect| expect.verdict.value == Expected::Refuted);
    if let Some(expect) = known.filter(|_| failed && excused && reads_alike(&reading, &original())) {
        ok = true;
        because = Some(expect.because.value.clone());
        parts.iter_mut().for_each(|part| part.ok = true);
    }
    if failed && excused && !claim.errata.is_empty() {
        let edits: Vec<String> =
            claim.errata.iter().map(|e| format!("for “{}” read “{}”", e.printed.value, e.read.value)).collect();
        // If the print contains the printed text of the erratum, its correction must pass.
        let verdict = match corrected(checker.claims, &display.text, &claim.errata) {
            Ok(text) => {
                let corrected = read_in_place(checker, macros, at, &text, claim);
                let corrected_parts = judged(checker, (at, display), &corrected, claim)?;
                let whole = missing_from_print(checker, &corrected, &checker.readings[at]).is_none();
                ok = whole && corrected_parts.iter().all(|part| part.finding.verdict.passes());
                if ok {
                    String::new()
                } else {
                    format!("; the corrected equation does not pass: {}", worst(&corrected_parts).message)
                }
            }
            Err(_) => {
                ok = reads_alike(&reading, &original());
                if ok { String::new() } else { "; but these notes have another text here".to_owned() }
            }
        };
        because = Some(format!("a known erratum: {}{verdict}", edits.join(", ")));
    }
    Ok(checker.assembled(display, &reading, parts, ok, because))
}

/// The parts of a reading of the print. A display that lacks what its claim needs is unreadable.
fn judged(
    checker: &Checker<'_>,
    (at, display): (usize, &Display),
    reading: &Reading,
    claim: &Claim,
) -> Result<Vec<Part>> {
    let topic = display.id().unwrap_or_default();
    // If the claim fails on the reference too, the claim is wrong, and not the print.
    checker.parts((at, display.body.start), reading, claim, topic).or_else(|error| {
        checker.parts((at, display.body.start), &checker.readings[at], claim, topic)?;
        let message = format!(
            "the claim for ({topic}) of {} does not fit these notes: {}",
            checker.notes.source.path,
            error.message()
        );
        Ok(vec![
            checker
                .part(Finding::new(Code::ClaimDoesNotFit, Verdict::Unreadable, display.body, message), String::new()),
        ])
    })
}

/// The finding on an equation whose number the print lacks, placed at the number before it, or else after it.
fn absent(reference: &Notes, print: &Notes, at: usize) -> Equation {
    let present: Vec<(usize, &Numbered)> =
        pairs(reference, print).filter_map(|(at, display)| Some((at, display?.number.as_ref()?))).collect();
    let before = present.iter().rev().find(|(known, _)| *known < at);
    let (side, span) = match before.or(present.first()) {
        Some((known, number)) if *known < at => (format!(" after ({})", number.id), number.span),
        Some((_, number)) => (format!(" before ({})", number.id), number.span),
        None => (String::new(), Span::default()),
    };
    let number = reference.equations[at].id().unwrap_or_default();
    let message = format!("these notes have no display ({number}){side}; {} has one", reference.source.path);
    let line = print.source.line_column(span.start).0;
    unjudged(print, number, line, Finding::new(Code::LostInPrint, Verdict::Unreadable, span, message))
}
