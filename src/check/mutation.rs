//! Mutation testing of a document: every single slip in each equation, and whether the check detects it.
//!
//! A mutant is an equation with one slip ([`crate::latex::slips`]). The check should refute it, or refuse it as unreadable
//! or ill-typed. A mutant that reads the same, or is proved over a prime field to be equal, is equivalent, and no check can
//! detect it. The other mutants survive: slips that the claims, or the checker, let pass.
//!
//! A definition or a law cannot be false by itself. A slip in it is detected if anything in the document is then not as
//! expected, so the whole document is checked with it.
//!
//! # When a mutant is equivalent
//!
//! When it is proved: it reads the same, or is certified; or its members are those of the equation over a field,
//! whatever the symbols mean or as they are meant or where the hypotheses hold; or, beside a zero, it is a multiple
//! or the rate of the equation's side. That no state tells it apart is not enough. A slip that leaves the equation
//! true cannot be found by a check of truth.

use std::collections::HashMap;
use std::fmt;
use std::sync::Arc;

use rayon::prelude::*;

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
use crate::check::equations::definition_tests::DefinitionTests;
use crate::check::repair::suggest::{Search, is_in_source, suggestions};
use crate::check::run::check_in;
use crate::check::trial::edited_document::with_text;
use crate::check::trial::failed_display::FailedDisplay;
use crate::check::trial::text_trial::{Answer, Trial};
use crate::check::verdict::Verdict;

/// The number of mutants of an equation that one thread checks at a time.
const SHARE: usize = 16;

/// The outcome of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MutantOutcome {
    /// A counterexample was found; or, for a definition or a law, another equation failed.
    Refuted,
    /// It cannot be read, its types or its units do not fit, or it says too little to be checked.
    Refused,
    /// It reads as the original does, or is proved to be equal to it.
    Equivalent,
    /// It passes.
    Survived,
}

impl MutantOutcome {
    /// The word for it in reports.
    pub fn word(self) -> &'static str {
        match self {
            MutantOutcome::Refuted => "refuted",
            MutantOutcome::Refused => "refused",
            MutantOutcome::Equivalent => "equivalent",
            MutantOutcome::Survived => "survived",
        }
    }
}

/// A slip that was not detected, or whose correction was not suggested.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survivor {
    /// The bytes of the notes, with their errata corrected, that the slip changes.
    pub span: Span,
    /// The text there.
    pub original: String,
    /// The text with the slip.
    pub replacement: String,
    /// The kind of slip.
    pub slip: Slip,
    /// The reason why it passes, or the suggestions.
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
    /// How many are equivalent.
    pub equivalent: usize,
    /// Those that passed.
    pub survivors: Vec<Survivor>,
    /// The reason why the equation was left out, if it was.
    pub left_out: Option<LeftOut>,
    /// The quality of the suggestions for detected mutants, if requested.
    pub repairs: Option<Repairs>,
}

/// Why an equation has no mutants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftOut {
    /// The claims file skips it.
    Skipped,
    /// The claims file expects that it does not pass.
    ExpectedNotToPass,
    /// It does not pass. Whether a slip in it would be detected can be told of an equation that passes only.
    DoesNotPass(Verdict),
}

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LeftOut::Skipped => f.write_str("the claims file skips the equation"),
            LeftOut::ExpectedNotToPass => f.write_str("the claims file expects the equation not to pass"),
            LeftOut::DoesNotPass(verdict) => write!(f, "the equation does not pass: it is {verdict}"),
        }
    }
}

/// The quality of suggestions: for how many detected mutants the original, or an equivalent text, was suggested.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// The number of detected mutants.
    pub tried: usize,
    /// The number for which it was the first suggestion.
    pub first: usize,
    /// The number for which it was among the suggestions, at most three.
    pub offered: usize,
    /// The others.
    pub missed: Vec<Survivor>,
}

impl Mutants {
    fn none(display: &Display, left_out: Option<LeftOut>) -> Self {
        let (id, line) = (shown(display), display.line);
        Mutants { id, line, refuted: 0, refused: 0, equivalent: 0, survivors: Vec::new(), left_out, repairs: None }
    }

    /// How many there were.
    pub fn count(&self) -> usize {
        self.refuted + self.refused + self.equivalent + self.survivors.len()
    }

    fn add(&mut self, outcome: MutantOutcome) {
        match outcome {
            MutantOutcome::Refuted => self.refuted += 1,
            MutantOutcome::Refused => self.refused += 1,
            MutantOutcome::Equivalent => self.equivalent += 1,
            MutantOutcome::Survived => {}
        }
    }
}

/// The mutants of a document's equations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutated {
    /// The notes.
    pub path: String,
    /// The notes that were mutated, with their errata corrected.
    pub source: Arc<Source>,
    /// Each claimed equation.
    pub equations: Vec<Mutants>,
}

/// Checks every mutant of the claimed equations of a document; with `repair`, also the suggestions for those detected.
/// Reports each equation that is done to `run.progress`.
///
/// # Errors
/// As [`check_document`](super::check_document), and for an erratum that is not in the notes.
pub fn mutate(run: &Run<'_>, claims: &Claims, notes: &Notes, repair: bool) -> Result<Mutated> {
    let (claims, notes) = with_errata_corrected(claims, notes)?;
    let silent = Run { progress: &(), ..*run };
    let checked = check_in(&Run { only: None, ..silent }, &claims, &notes)?;
    let failing = checked.equations.into_iter().filter(|equation| !equation.ok);
    let failing: HashMap<String, Verdict> = failing.map(|equation| (equation.id, equation.finding.verdict)).collect();
    let equations = with_checker(&silent, &claims, &notes, |checker| {
        let chosen = wanted(&notes, checker.assigned, run.only);
        let all: Result<Vec<Mutants>> = chosen
            .par_iter()
            .with_max_len(1)
            .map(|at| {
                let found = equation(&silent, &checker, *at, &failing, repair);
                run.progress.done(&notes.source.path);
                found
            })
            .collect();
        all
    })?;
    Ok(Mutated { path: notes.source.path.clone(), source: notes.source.clone(), equations })
}

/// The notes with their errata corrected, and the claims without errata.
fn with_errata_corrected(claims: &Claims, notes: &Notes) -> Result<(Claims, Notes)> {
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
    Ok((claims, with_text(notes, text)?))
}

fn equation(
    run: &Run<'_>,
    checker: &Checker<'_>,
    at: usize,
    failing: &HashMap<String, Verdict>,
    repair: bool,
) -> Result<Mutants> {
    let display = &checker.notes.equations[at];
    let left_out = |why: LeftOut| Ok(Mutants::none(display, Some(why)));
    let plain = Claim::default();
    let claim = checker.assigned[at].unwrap_or(&plain);
    if claim.skip.is_some() {
        return left_out(LeftOut::Skipped);
    }
    if claim.expect.is_some() {
        return left_out(LeftOut::ExpectedNotToPass);
    }
    if let Some(verdict) = failing.get(&shown(display)) {
        return left_out(LeftOut::DoesNotPass(*verdict));
    }
    let edits = slips::slips(&display.text, &checker.model.symbols, &checker.model.macros);
    // Only text of the file is edited, not text that an erratum put in its place.
    let real = |edit: &Edit| is_in_source(checker, &display.text, edit, display.body.start);
    let edits: Vec<Edit> = edits.into_iter().filter(real).collect();
    let tests: Vec<DefinitionTests<'_, '_>> = checker.readings[at]
        .introduced
        .iter()
        .map(|introduced| DefinitionTests::of(checker, introduced, false))
        .collect::<Result<_>>()?;
    let judged: Result<Vec<Vec<(MutantOutcome, String)>>> = edits
        .par_chunks(SHARE)
        .map(|share| {
            let trial = Trial::new(checker, at, &checker.readings[at], claim)?;
            share.iter().map(|edit| outcome(run, checker, (at, &tests), &trial, edit)).collect()
        })
        .collect();
    let mut mutants = Mutants::none(display, None);
    let judged: Vec<(MutantOutcome, String)> = judged?.into_iter().flatten().collect();
    if repair {
        let detected = edits
            .iter()
            .zip(&judged)
            .filter(|(_, (outcome, _))| matches!(outcome, MutantOutcome::Refuted | MutantOutcome::Refused));
        let detected: Vec<&Edit> = detected.map(|(edit, _)| edit).collect();
        mutants.repairs = Some(repairs(checker, at, claim, &detected)?);
    }
    for (edit, (outcome, because)) in edits.into_iter().zip(judged) {
        mutants.add(outcome);
        if outcome == MutantOutcome::Survived {
            mutants.survivors.push(survivor(display, edit, because));
        }
    }
    Ok(mutants)
}

/// The quality of the suggestions for slips in a display.
fn repairs(checker: &Checker<'_>, at: usize, claim: &Claim, slips: &[&Edit]) -> Result<Repairs> {
    let display = &checker.notes.equations[at];
    let original = &display.text;
    let place = |edit: &&Edit| -> Result<(Option<usize>, String)> {
        let text = edit.applied(original);
        let reading = reread::read_in_place(checker, &checker.model.macros, at, &text, claim);
        let (places, steps) = (Vec::new(), Vec::new());
        let wrong = FailedDisplay { at, text: &text, reading: &reading, claim, places, steps };
        let trial = Trial::new(checker, at, &checker.readings[at], claim)?;
        let found = suggestions(checker, &wrong, Search::Thorough)?;
        for (place, found) in found.iter().enumerate() {
            if found.edit.applied(&text) == *original || trial.is_equivalent(&found.reading)? {
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
        let because = match suggested.as_str() {
            "" => "nothing was suggested".to_owned(),
            suggested => format!("suggested: {suggested}"),
        };
        survivor(display, (*edit).clone(), because)
    };
    Ok(Repairs {
        tried,
        first,
        offered: tried - missed,
        missed: slips.iter().zip(&places).filter(|(_, (place, _))| place.is_none()).map(missed_slip).collect(),
    })
}

/// A slip with its place in the notes.
fn survivor(display: &Display, edit: Edit, because: String) -> Survivor {
    let original = display.text[edit.span.range()].to_owned();
    let span = edit.span.shifted(display.body.start);
    Survivor { span, original, replacement: edit.replacement, slip: edit.slip, because }
}

/// The outcome of a mutant of a display, and the reason; `tests` are the tests of the definitions in the display.
fn outcome(
    run: &Run<'_>,
    checker: &Checker<'_>,
    (at, tests): (usize, &[DefinitionTests<'_, '_>]),
    trial: &Trial<'_, '_>,
    edit: &Edit,
) -> Result<(MutantOutcome, String)> {
    let display = &checker.notes.equations[at];
    let because = String::new();
    let text = edit.applied(&display.text);
    let none = Claim::default();
    let is_tested = match checker.introduced_formulas(at, checker.assigned[at].unwrap_or(&none), &text) {
        Some(formulas) => definition_is_tested(checker, at, tests, &formulas),
        None => return Ok((MutantOutcome::Refused, because)),
    };
    Ok(match trial.judge(&text)? {
        Answer::Same => (MutantOutcome::Equivalent, because),
        Answer::Refused => (MutantOutcome::Refused, because),
        Answer::Refuted if is_tested => (MutantOutcome::Refuted, because),
        Answer::Refuted => match first_failure(run, checker, at, edit)? {
            Some(Verdict::Refuted | Verdict::Domain) => (MutantOutcome::Refuted, because),
            Some(_) => (MutantOutcome::Refused, because),
            None => (MutantOutcome::Survived, "the document passes with this change".to_owned()),
        },
        Answer::Passes(reading, parts) => match parts.iter().find(|part| part.finding.verdict != Verdict::Certified) {
            Some(part) if !trial.is_equivalent(&reading)? => {
                (MutantOutcome::Survived, format!("{}: {}", part.finding.verdict, part.finding.message))
            }
            _ => (MutantOutcome::Equivalent, because),
        },
    })
}

/// Whether the definitions in a display are unchanged, or an equation that uses a changed one fails; `false` for a law.
fn definition_is_tested(
    checker: &Checker<'_>,
    at: usize,
    tests: &[DefinitionTests<'_, '_>],
    formulas: &[Expr],
) -> bool {
    if checker.is_law(at) {
        return false;
    }
    let before = checker.readings[at].introduced.iter().map(|introduced| &introduced.formula);
    let mut changed = before.zip(formulas).zip(tests).filter(|((was, is), _)| was != is).peekable();
    changed.peek().is_none() || changed.any(|((_, formula), tests)| tests.detects(formula))
}

/// The verdict on the first equation or sentence that is not as expected when a display has a slip.
fn first_failure(run: &Run<'_>, checker: &Checker<'_>, at: usize, edit: &Edit) -> Result<Option<Verdict>> {
    let start = checker.notes.equations[at].body.start;
    let mut text = checker.notes.source.text.clone();
    text.replace_range(edit.span.shifted(start).range(), &edit.replacement);
    let found = with_text(checker.notes, text).and_then(|notes| {
        crate::check::trial::edited_document::first_unexpected(run, checker.claims, &notes, at, &|_| false)
    });
    // A document that cannot be checked with the slip detects it.
    Ok(found.unwrap_or(Some(Verdict::Unreadable)))
}
