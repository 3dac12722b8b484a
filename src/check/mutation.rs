//! Mutation testing of a document: each equation with every single slip in it, checked.
//!
//! A mutant is an equation with one slip ([`crate::latex::slips`]). The document should refute it, or refuse it
//! because it cannot be read or its shapes do not fit. A mutant that says the same, or is proved to be as true, is
//! equivalent. The others have survived. A definition or a law cannot be wrong by itself: a slip in it is noticed
//! if anything else in the document fails.
//!
//! # When a mutant is equivalent
//!
//! When it is proved: it reads the same, or is certified; or its members are those of the equation over a field,
//! whatever the symbols mean or as they are meant or where the hypotheses hold; or, beside a zero, it is a multiple
//! or the rate of the equation's side. That no state tells it apart is not enough. A slip that leaves the equation
//! true cannot be found by a check of truth.

use rayon::prelude::*;
use std::sync::Arc;

use crate::Result;
use crate::formula::Expr;
use crate::latex::slips;
use crate::latex::slips::{Edit, Slip};
use crate::notes::claims::{Claim, Claims};
use crate::notes::{Display, Notes};
use crate::source::{Source, Span};

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::reading::corrected;
use crate::check::document::reread;
use crate::check::document::setup::{Run, wanted, with_checker};
use crate::check::equations::noticed::Pins;
use crate::check::repair::suggest::{is_real, suggestions};
use crate::check::run::check_in;
use crate::check::trial::document::retyped;
use crate::check::trial::trial_text::{Answer, Trial};
use crate::check::trial::wrong::Wrong;
use crate::check::verdict::Verdict;

/// So many mutants of an equation are judged by one thread at a time.
const SHARE: usize = 16;

/// What became of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// A counterexample was found; or, of a definition or a law, something else was no longer so.
    Refuted,
    /// It cannot be read, its types or its units do not fit, or it says too little to be checked.
    Refused,
    /// It says what the equation says, or is proved to be as true.
    Equivalent,
    /// It passes.
    Survived,
}

/// A slip that nothing noticed, or that is not mended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survivor {
    /// The bytes of the notes, their errata mended, that the slip changes.
    pub span: Span,
    /// What stands there.
    pub original: String,
    /// What would stand there.
    pub replacement: String,
    /// The kind of slip.
    pub slip: Slip,
    /// Why it passes, or what is suggested.
    pub because: String,
}

/// The mutants of one equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutants {
    /// The equation's number, label or line.
    pub id: String,
    /// The line in which it starts.
    pub line: usize,
    /// How many were refuted.
    pub refuted: usize,
    /// How many were refused.
    pub refused: usize,
    /// How many say the same.
    pub equivalent: usize,
    /// Those that passed.
    pub survivors: Vec<Survivor>,
    /// Why there are none, where the equation was left out.
    pub left_out: Option<String>,
    /// How well the noticed ones were mended, if that was asked for.
    pub repairs: Option<Repairs>,
}

/// How many noticed slips were tried to be mended, and for how many the original, or what says the same, was suggested.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// Mutants that were noticed.
    pub tried: usize,
    /// For so many it was the first suggestion.
    pub first: usize,
    /// For so many it was one of the suggestions, three at most.
    pub offered: usize,
    /// The others.
    pub missed: Vec<Survivor>,
}

impl Mutants {
    fn none(display: &Display, left_out: Option<String>) -> Self {
        let (id, line) = (shown(display), display.line);
        Mutants { id, line, refuted: 0, refused: 0, equivalent: 0, survivors: Vec::new(), left_out, repairs: None }
    }

    /// How many there were.
    pub fn count(&self) -> usize {
        self.refuted + self.refused + self.equivalent + self.survivors.len()
    }

    fn add(&mut self, fate: Fate) {
        match fate {
            Fate::Refuted => self.refuted += 1,
            Fate::Refused => self.refused += 1,
            Fate::Equivalent => self.equivalent += 1,
            Fate::Survived => {}
        }
    }
}

/// The mutants of a document's equations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutated {
    /// The notes.
    pub path: String,
    /// The notes as they were mutated: with their errata mended.
    pub source: Arc<Source>,
    /// Each claimed equation.
    pub equations: Vec<Mutants>,
}

/// Judges every single slip in the claimed equations of a document, and with `repair` tries to mend those that are noticed.
/// Each equation done is told.
///
/// # Errors
/// As [`check_document`](super::check_document), and for an erratum that is not in the notes.
pub fn mutate(run: &Run<'_>, claims: &Claims, notes: &Notes, repair: bool) -> Result<Mutated> {
    let (claims, notes) = mended(claims, notes)?;
    let silent = Run { progress: &(), ..*run };
    let sound = check_in(&Run { only: None, ..silent }, &claims, &notes)?;
    let sound: Vec<String> = sound.equations.into_iter().filter(|e| e.ok).map(|e| e.id).collect();
    let equations = with_checker(&silent, &claims, &notes, |checker| {
        let chosen = wanted(&notes, checker.assigned, run.only);
        let all: Result<Vec<Mutants>> = chosen
            .par_iter()
            .with_max_len(1)
            .map(|at| {
                let found = equation(&silent, &checker, *at, &sound, repair);
                run.progress.done(&notes.source.path);
                found
            })
            .collect();
        all
    })?;
    Ok(Mutated { path: notes.source.path.clone(), source: notes.source.clone(), equations })
}

/// The notes with their errata mended, and claims that know of none.
fn mended(claims: &Claims, notes: &Notes) -> Result<(Claims, Notes)> {
    let mut text = notes.source.text.clone();
    let mut claims = claims.clone();
    let all = claims.clone();
    let assigned = crate::check::document::setup::assign(&all, notes)?;
    for (display, claim) in notes.equations.iter().zip(assigned).rev() {
        let Some(claim) = claim.filter(|claim| !claim.errata.is_empty()) else { continue };
        let body = corrected(&claims, notes.source.slice(display.body), &claim.errata)?;
        text.replace_range(display.body.range(), &body);
    }
    claims.equations.iter_mut().for_each(|(_, claim)| claim.errata.clear());
    Ok((claims, retyped(notes, text)?))
}

fn equation(run: &Run<'_>, checker: &Checker<'_>, at: usize, sound: &[String], repair: bool) -> Result<Mutants> {
    let display = &checker.notes.equations[at];
    let left_out = |why: &str| Ok(Mutants::none(display, Some(why.to_owned())));
    let plain = Claim::default();
    let claim = checker.assigned[at].unwrap_or(&plain);
    if claim.skip.is_some() {
        return left_out("the claims file skips the equation");
    }
    if claim.expect.is_some() {
        return left_out("the claims file expects the equation not to pass");
    }
    if !sound.contains(&shown(display)) {
        return left_out("the equation does not pass");
    }
    let edits = slips::slips(&display.text, &checker.model.symbols, &checker.model.macros);
    // An edit is of what stands in the file, and not of what was put in its place to be read.
    let real = |edit: &Edit| is_real(checker, &display.text, edit, display.body.start);
    let edits: Vec<Edit> = edits.into_iter().filter(real).collect();
    let pins: Vec<Pins<'_, '_>> = checker.readings[at]
        .introduced
        .iter()
        .map(|introduced| Pins::of(checker, introduced, false))
        .collect::<Result<_>>()?;
    let judged: Result<Vec<Vec<(Fate, String)>>> = edits
        .par_chunks(SHARE)
        .map(|share| {
            let trial = Trial::new(checker, at, &checker.readings[at], claim)?;
            share.iter().map(|edit| fate(run, checker, (at, &pins), &trial, edit)).collect()
        })
        .collect();
    let mut mutants = Mutants::none(display, None);
    let judged: Vec<(Fate, String)> = judged?.into_iter().flatten().collect();
    if repair {
        let noticed = edits.iter().zip(&judged).filter(|(_, (fate, _))| matches!(fate, Fate::Refuted | Fate::Refused));
        let noticed: Vec<&Edit> = noticed.map(|(edit, _)| edit).collect();
        mutants.repairs = Some(repairs(checker, at, claim, &noticed)?);
    }
    for (edit, (fate, because)) in edits.into_iter().zip(judged) {
        mutants.add(fate);
        if fate == Fate::Survived {
            mutants.survivors.push(survivor(display, edit, because));
        }
    }
    Ok(mutants)
}

/// How well slips in a display are mended: from the first to the third suggestion.
fn repairs(checker: &Checker<'_>, at: usize, claim: &Claim, slips: &[&Edit]) -> Result<Repairs> {
    let display = &checker.notes.equations[at];
    let original = &display.text;
    let place = |edit: &&Edit| -> Result<(Option<usize>, String)> {
        let text = edit.applied(original);
        let reading = reread::read(checker, &checker.model.macros, at, &text, claim);
        let (places, steps) = (Vec::new(), Vec::new());
        let wrong = Wrong { at, text: &text, reading: &reading, claim, places, steps };
        let trial = Trial::new(checker, at, &checker.readings[at], claim)?;
        let found = suggestions(checker, &wrong)?;
        for (place, found) in found.iter().enumerate() {
            if found.edit.applied(&text) == *original || trial.is_as_true(&found.reading)? {
                return Ok((Some(place), String::new()));
            }
        }
        let offered = found.iter().map(|found| format!("“{}”", found.edit.applied(&text).trim()));
        Ok((None, offered.collect::<Vec<_>>().join(" or ")))
    };
    let places: Vec<(Option<usize>, String)> = slips.par_iter().with_max_len(1).map(place).collect::<Result<_>>()?;
    let at = |wanted| places.iter().filter(|(place, _)| *place == wanted).count();
    let (tried, first, missed) = (places.len(), at(Some(0)), at(None));
    let missed_slip = |(edit, (_, suggested)): (&&Edit, &(_, String))| {
        survivor(display, (*edit).clone(), format!("suggested: {suggested}"))
    };
    Ok(Repairs {
        tried,
        first,
        offered: tried - missed,
        missed: slips.iter().zip(&places).filter(|(_, (place, _))| place.is_none()).map(missed_slip).collect(),
    })
}

/// A slip, by its place in the notes.
fn survivor(display: &Display, edit: Edit, because: String) -> Survivor {
    let original = display.text[edit.span.range()].to_owned();
    let span = edit.span.shifted(display.body.start);
    Survivor { span, original, replacement: edit.replacement, slip: edit.slip, because }
}

/// What becomes of a mutant of a display, whose definitions are held by pins, and why.
fn fate(
    run: &Run<'_>,
    checker: &Checker<'_>,
    (at, pins): (usize, &[Pins<'_, '_>]),
    trial: &Trial<'_, '_>,
    edit: &Edit,
) -> Result<(Fate, String)> {
    let display = &checker.notes.equations[at];
    let because = String::new();
    let text = edit.applied(&display.text);
    let none = Claim::default();
    let held = match checker.introduces(at, checker.assigned[at].unwrap_or(&none), &text) {
        Some(formulas) => holds_fast(checker, at, pins, &formulas),
        None => return Ok((Fate::Refused, because)),
    };
    Ok(match trial.of(&text)? {
        Answer::Same => (Fate::Equivalent, because),
        Answer::Refused => (Fate::Refused, because),
        Answer::Refuted if held => (Fate::Refuted, because),
        Answer::Refuted => match noticed(run, checker, at, edit)? {
            Some(Verdict::Refuted | Verdict::Domain) => (Fate::Refuted, because),
            Some(_) => (Fate::Refused, because),
            None => (Fate::Survived, "the document passes with this change".to_owned()),
        },
        Answer::Passes(reading, parts) => match parts.iter().find(|part| part.finding.verdict != Verdict::Certified) {
            Some(part) if !trial.is_as_true(&reading)? => {
                (Fate::Survived, format!("{}: {}", part.finding.verdict, part.finding.message))
            }
            _ => (Fate::Equivalent, because),
        },
    })
}

/// Whether what a display defines is what it defined before, or else an equation that uses the name fails; what is a law
/// is not held by others.
fn holds_fast(checker: &Checker<'_>, at: usize, pins: &[Pins<'_, '_>], formulas: &[Expr]) -> bool {
    if checker.is_law(at) {
        return false;
    }
    let before = checker.readings[at].introduced.iter().map(|introduced| &introduced.formula);
    let mut changed = before.zip(formulas).zip(pins).filter(|((was, is), _)| was != is).peekable();
    changed.peek().is_none() || changed.any(|((_, formula), pins)| pins.notice(formula))
}

/// The verdict on the first thing in the document that is not as expected when a display has a slip.
fn noticed(run: &Run<'_>, checker: &Checker<'_>, at: usize, edit: &Edit) -> Result<Option<Verdict>> {
    let start = checker.notes.equations[at].body.start;
    let mut text = checker.notes.source.text.clone();
    text.replace_range(edit.span.shifted(start).range(), &edit.replacement);
    let found = retyped(checker.notes, text)
        .and_then(|notes| crate::check::trial::document::first_unexpected(run, checker.claims, &notes, at));
    // What cannot be checked at all with the slip is noticed.
    Ok(found.unwrap_or(Some(Verdict::Unreadable)))
}
