//! The single edits of the author's text with which a wrong equation passes, and their ranking.
//!
//! A display that is refuted, or cannot be read, is tried with every edit that undoes a slip
//! ([`crate::latex::slips::corrections`]). Those that hold at a few states get the full check, and only what passes
//! it is offered. Suggestions are ranked by how likely the slip is. Missing terms are looked for only if nothing
//! else helps: in the display, in other displays, in the sentences, and then by computation
//! ([`super::lost_terms`]).
//!
//! # Why a suggestion is never false
//!
//! It has passed the check that the author's text failed. Another one may have been meant; so up to three are
//! shown, the most likely first, and `--fix` acts on a single one or a clearly more likely one. Many true edits are
//! silly: a factor that is the right side over the left one, or a sum of three terms that were all lost. These are
//! not looked for.

use rayon::prelude::*;
use std::cell::Cell;

use crate::Result;
use crate::formula::{Expr, Node, Statement};
use crate::latex::slips::{Edit, Pool, Slip};
use crate::latex::{Reading, names, slips};
use crate::notes::claims::Claim;
use crate::source::{Fault, Span};

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::{is_plain, is_wrong};
use crate::check::document::setup::Run;
use crate::check::model::Model;
use crate::check::repair::lost_terms;
use crate::check::trial::trial_text::{Answer, Trial, cut};
use crate::check::trial::wrong::{MISSING, OFFERED, Wrong};
use crate::check::vacuity::tautology::{is_lost, is_reordered, is_taken_back};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::{Equation, Part};

/// So many candidates at least are tried by one thread at a time: the states that refute them are drawn for each share.
const SHARE: usize = 32;

/// Which pool of what may be put in comes last.
const LAST: usize = 4;

/// A suggestion, with how the display reads then.
pub(crate) struct Suggestion {
    /// The edit, in the text of the display.
    pub edit: Edit,
    /// What it reads as.
    pub reading: Reading,
    /// The worst verdict of its parts.
    pub verdict: Verdict,
    /// Whether it mends a step of a chain alone.
    pub step: bool,
    /// Whether a member is then zero whatever its symbols mean: it is true, and says nothing.
    pub idle: bool,
}

impl Checker<'_> {
    /// An equation with the edits that would make it pass, if it is refuted or cannot be read and ought not to be. One in
    /// another display is looked for if the equation is alone in being wrong; else that is for
    /// [`super::shared`] to find.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn with_repairs(
        &self,
        run: &Run<'_>,
        at: usize,
        mut equation: Equation,
        alone: bool,
    ) -> Result<Equation> {
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        let is_known = claim.expect.is_some() || !claim.errata.is_empty();
        if equation.ok || is_known || !self.options.explain {
            return Ok(equation);
        }
        let (display, reading) = (&self.notes.equations[at], &self.readings[at]);
        let places = places(&equation, display.body);
        let steps = steps(&equation, reading, display.body.start);
        let wrong = Wrong { at, text: &display.text, reading, claim, places, steps };
        // What it assumes may need a name that is lost with another display: then no text can be judged.
        let is_judged = self.hypotheses(claim).is_ok() && self.local(claim).is_ok();
        if is_wrong(&equation) && is_judged {
            let contradicted = self.contradicts_definitions(at)?;
            if contradicted {
                equation.repairs = self.repairs_of_definitions(run, at, alone)?;
            }
            if equation.repairs.len() < OFFERED {
                // Nothing is to be learnt from what is wrong, the units of its terms neither.
                let found = suggestions(&self.doubting(at), &wrong)?;
                for repair in in_file(self, &wrong, display.body.start, found) {
                    let is_it = |known: &Repair| (known.span, &known.replacement) == (repair.span, &repair.replacement);
                    if !equation.repairs.iter().any(is_it) {
                        equation.repairs.push(repair);
                    }
                }
                equation.repairs.truncate(OFFERED);
            }
            if equation.repairs.is_empty() && !contradicted {
                equation.repairs = self.repairs_of_definitions(run, at, alone)?;
            }
            if !equation.repairs.is_empty() {
                equation.parts.iter_mut().for_each(|part| part.finding.fit = None);
                equation.finding.fit = None;
            }
        }
        Ok(equation)
    }
}

/// Where an equation is refuted, in the text of its display; what cannot be read may be wrong anywhere.
fn places(equation: &Equation, body: Span) -> Vec<Span> {
    let own = |part: &&Part| !part.ok && part.finding.follows_from.is_none();
    let parts = equation.parts.iter().filter(own).map(|part| &part.finding);
    let findings: Vec<_> = if equation.parts.is_empty() { vec![&equation.finding] } else { parts.collect() };
    if findings.iter().any(|finding| finding.verdict == Verdict::Unreadable) {
        return Vec::new();
    }
    let within = |span: Span| body.contains(span).then(|| Span::new(span.start - body.start, span.end - body.start));
    findings.into_iter().filter_map(|finding| within(finding.span)).collect()
}

/// The suggestions for a display, the likeliest first.
///
/// # Errors
/// As for a check of the display itself.
pub(crate) fn suggestions(checker: &Checker<'_>, wrong: &Wrong<'_>) -> Result<Vec<Suggestion>> {
    let (symbols, macros) = (&checker.model.symbols, &checker.model.macros);
    let mut tried = Vec::new();
    let own = || Pool::of(std::iter::once(wrong.text), symbols, macros, MISSING);
    let others = || checker.notes.equations.iter().enumerate().filter(|(at, _)| *at != wrong.at);
    let texts = || std::iter::once(wrong.text).chain(others().map(|(_, display)| display.text.as_str()));
    let all = || Pool::of(texts(), symbols, macros, MISSING).with_members(wrong.text, symbols, macros);
    // What the sentences speak of may stand in one display only, and that has lost it.
    let said = || checker.notes.inline.iter().map(|span| checker.notes.source.slice(*span).trim_matches('$'));
    let prose = || Pool::of(said(), symbols, macros, MISSING).factors_only();
    let like = || own().of_like_terms(symbols, macros);
    let pools: [&dyn Fn() -> Pool; 5] = [&|| own().factors_only(), &|| all().factors_only(), &all, &prose, &like];
    // With a term or a factor less much is true that nobody meant: then what was lost is looked for as well.
    let mut less: Vec<Suggestion> = Vec::new();
    // What says nothing is offered where nothing else is.
    let mut idle: Vec<Suggestion> = Vec::new();
    for (at, pool) in pools.iter().enumerate() {
        // What is found from what is true comes after all that stands in the document, and before what is only like it.
        if at == LAST {
            let mut found = passing(checker, wrong, &lost_terms::edits(checker, wrong)?)?;
            found.retain(|suggestion| !suggestion.idle);
            if !found.is_empty() {
                return Ok(distinct(checker, less.into_iter().chain(found)));
            }
        }
        let mut edits = slips::corrections(wrong.text, symbols, macros, &pool());
        edits.retain(|edit| wrong.concerns(edit) && !tried.contains(edit));
        // What is left out with a ± before it is a root; and a ± stands before one, or beside another.
        let has_root = |edit: &Edit| match edit.slip {
            Slip::Term => edit.replacement.contains("sqrt"),
            Slip::Sign => wrong.text.contains("sqrt"),
            _ => true,
        };
        edits.retain(|edit| !has_branches(&edit.replacement) || has_branches(wrong.text) || has_root(edit));
        let mut found = passing(checker, wrong, &edits)?;
        tried.extend(edits);
        found.sort_by_key(|suggestion| likelihood(wrong.text, &suggestion.edit, suggestion.step));
        idle.extend(found.extract_if(.., |suggestion| suggestion.idle).filter(|_| at < LAST));
        let is_less = found.iter().all(|suggestion| takes_away(&suggestion.edit));
        less.extend(found);
        if !is_less {
            break;
        }
    }
    Ok(distinct(checker, if less.is_empty() { idle } else { less }))
}

/// Whether a text says two things at once.
pub(crate) fn has_branches(text: &str) -> bool {
    text.contains(r"\pm") || text.contains(r"\mp")
}

/// Whether an edit leaves out a term or a factor that stands there once.
fn takes_away(edit: &Edit) -> bool {
    matches!(edit.slip, Slip::Term | Slip::Factor) && edit.replacement.trim().is_empty()
}

/// The first few suggestions, without those that say what one before them says.
fn distinct(checker: &Checker<'_>, found: impl IntoIterator<Item = Suggestion>) -> Vec<Suggestion> {
    let mut distinct: Vec<Suggestion> = Vec::new();
    for suggestion in found {
        if !distinct.iter().any(|known| is_one(&known.reading, &suggestion.reading, checker.model)) {
            distinct.push(suggestion);
        }
    }
    distinct.truncate(OFFERED);
    distinct
}

/// The edits with which the display passes.
fn passing(checker: &Checker<'_>, wrong: &Wrong<'_>, edits: &[Edit]) -> Result<Vec<Suggestion>> {
    let share = edits.len().div_ceil(4 * rayon::current_num_threads()).max(SHARE);
    let found: Result<Vec<Vec<Suggestion>>> = edits
        .par_chunks(share)
        .map(|share| {
            let whole = Trial::new(checker, wrong.at, wrong.reading, wrong.claim)?;
            let cuts: Vec<_> = wrong.steps.iter().map(|step| (*step, step_of(wrong.reading, *step))).collect();
            let mut steps = Vec::new();
            for (step, now) in cuts.iter().filter(|_| is_plain(wrong.claim)) {
                steps.push((*step, now, Trial::new(checker, wrong.at, now, wrong.claim)?.of_step(*step)));
            }
            let mut passing = Vec::new();
            for edit in share {
                let text = edit.applied(wrong.text);
                // A name put beside its like, and the product of vectors with one of them, are zero too easily.
                let multiplies = ["\\times", "\\cdot"].iter().any(|operator| edit.replacement.contains(operator));
                let may_say_nothing = !takes_away(edit) && edit.slip != Slip::Name && !multiplies;
                let mut passes = |trial: &Trial<'_, '_>, now: &Reading, step: bool| -> Result<bool> {
                    let idle = Cell::new(false);
                    let is_meant = |reading: &Reading| {
                        idle.set(is_empty(now, reading, checker.model));
                        let says_something = match idle.get() {
                            true => may_say_nothing && is_null(reading),
                            false => {
                                let is_one_way = !has_branches(wrong.text);
                                let taken_back = is_one_way && is_taken_back(now, reading);
                                !(taken_back || is_lost(now, reading, checker.model) || says_twice(reading))
                            }
                        };
                        says_something && !whole.stands_still(reading)
                    };
                    let Answer::Passes(reading, parts) = trial.of_one(&text, is_meant)? else { return Ok(false) };
                    let (edit, verdict, idle) = (edit.clone(), worst(&parts), idle.get());
                    passing.push(Suggestion { edit, reading, verdict, step, idle });
                    Ok(true)
                };
                if passes(&whole, wrong.reading, false)? {
                    continue;
                }
                for (_, now, trial) in steps.iter().filter(|(step, ..)| stands_in(edit, wrong.reading, *step)) {
                    if passes(trial, now, true)? {
                        break;
                    }
                }
            }
            Ok(passing)
        })
        .collect();
    Ok(found?.into_iter().flatten().collect())
}

/// The first wrong members of chains where mending them would not be all: the rest follows from them, or there is a slip
/// more. Of each its statement and its place there. What comes after another slip is not mended to agree with that.
fn steps(equation: &Equation, reading: &Reading, offset: usize) -> Vec<(usize, usize)> {
    let parts = equation.parts.iter().filter(|part| !part.ok).map(|part| &part.finding);
    let findings: Vec<&Finding> = if equation.parts.is_empty() { vec![&equation.finding] } else { parts.collect() };
    let first = |(at, statement): (usize, &std::result::Result<Statement, Fault>)| {
        let statement = statement.as_ref().ok()?;
        let here = |finding: &&&Finding| statement.span.shifted(offset).contains(finding.span);
        let (first, more) = (findings.iter().find(here)?, findings.iter().filter(here).count() > 1);
        if first.follows_from.is_some() {
            return None;
        }
        let ends = |member: &Expr| member.span.end + offset == first.span.end;
        let member = statement.members.iter().position(ends).filter(|member| *member > 0)?;
        (first.carried > 0 || more).then_some((at, member))
    };
    reading.statements.iter().enumerate().filter_map(first).collect()
}

/// A reading with one step of a chain.
fn step_of(reading: &Reading, step: (usize, usize)) -> Reading {
    let mut reading = reading.clone();
    cut(&mut reading, step);
    reading
}

/// Whether an edit changes a member.
fn stands_in(edit: &Edit, reading: &Reading, (statement, member): (usize, usize)) -> bool {
    let statement = reading.statements.get(statement).and_then(|statement| statement.as_ref().ok());
    statement.and_then(|statement| statement.members.get(member)).is_some_and(|member| member.span.contains(edit.span))
}

/// Whether a member has become zero whatever its symbols mean, and is not written so: it is true, and says nothing.
fn is_empty(before: &Reading, after: &Reading, model: &Model) -> bool {
    let vanishes =
        |member: &Expr| !member.is_null() && formulas::is_identity(member, &Expr::integer(0, member.span), model);
    let known: Vec<&Expr> = before.statements.iter().flatten().flat_map(|statement| &statement.members).collect();
    let mut members = after.statements.iter().flatten().flat_map(|statement| &statement.members);
    members.any(|member| vanishes(member) && !known.contains(&member))
}

/// Whether two statements are one.
fn says_twice(reading: &Reading) -> bool {
    let mut said: Vec<&[Expr]> = Vec::new();
    reading.statements.iter().flatten().any(|statement| {
        let again = said.contains(&statement.members.as_slice());
        said.push(&statement.members);
        again
    })
}

/// Whether something is said to be zero.
fn is_null(reading: &Reading) -> bool {
    reading.statements.iter().flatten().any(|statement| statement.members.iter().any(Expr::is_null))
}

/// Whether two readings say the same, whatever their symbols mean, member for member. Two matrices that do the same to
/// one vector are two.
fn is_one(a: &Reading, b: &Reading, model: &Model) -> bool {
    let has_cells = |expr: &Expr| {
        let mut found = false;
        expr.walk(&mut |inner| found |= matches!(inner.node, Node::Matrix(_)));
        found
    };
    is_each(a, b, |a, b| if has_cells(a) { is_reordered(a, b) } else { formulas::same(a, b, model) })
}

/// Whether two readings are alike member for member, by what is asked of each pair.
pub(crate) fn is_each(a: &Reading, b: &Reading, alike: impl Fn(&Expr, &Expr) -> bool) -> bool {
    let same = |(a, b): (&Statement, &Statement)| {
        a.members.len() == b.members.len() && a.members.iter().zip(&b.members).all(|(a, b)| alike(a, b))
    };
    let (a, b): (Vec<_>, Vec<_>) = (a.statements.iter().flatten().collect(), b.statements.iter().flatten().collect());
    a.len() == b.len() && a.into_iter().zip(b).all(same)
}

fn worst(parts: &[Part]) -> Verdict {
    parts.iter().map(|part| part.finding.verdict).max_by_key(|verdict| verdict.severity()).unwrap_or(Verdict::Verified)
}

/// What ranks an edit of a text: the kind of slip, whether it mends a step alone, how much it changes, and where.
pub(crate) fn likelihood(text: &str, edit: &Edit, step: bool) -> (Slip, bool, usize, usize) {
    let Edit { span, replacement, slip } = edit;
    // A minus before a whole side is wanting less often than a sign is wrong, and on the right more often than on the left;
    // within an argument, below a fraction, nobody means it.
    let in_cell = ["&", r"\\", "matrix}"].iter().any(|edge| text[..span.start].trim_end().ends_with(edge));
    if *slip == Slip::Sign && span.start == span.end && !in_cell {
        let braces = |brace: char| text[..span.start].matches(brace).count();
        let depth = braces('{').saturating_sub(braces('}'));
        return (Slip::Fraction, step, depth, text.len() - span.start);
    }
    let old = &text[span.range()];
    // Nor is a power meant to be one of the reciprocal.
    if *slip == Slip::Sign && old.parse::<u32>().is_ok() {
        return (Slip::Relation, step, 0, span.start);
    }
    // A number of which neither half nor double nor a neighbour was meant.
    let far = *slip == Slip::Number
        && matches!((old.parse::<u32>(), replacement.parse::<u32>()),
        (Ok(n), Ok(m)) if n.abs_diff(m) != 1 && n != 2 * m && m != 2 * n);
    let same = old.bytes().zip(replacement.bytes()).take_while(|(a, b)| a == b).count();
    let longest = old.len().max(replacement.len());
    // To a name that stands alone on its side, nothing is added.
    let to_name = *slip == Slip::Term && old.is_empty() && names::parse(text[..span.start].trim()).is_some();
    (*slip, step, longest - same + usize::from(far || to_name), span.start)
}

/// Whether what an edit changes stands in the file as it was read, in a text that starts there at `offset`.
pub(crate) fn is_real(checker: &Checker<'_>, text: &str, edit: &Edit, offset: usize) -> bool {
    checker.source.slice(edit.span.shifted(offset)) == &text[edit.span.range()]
}

/// Suggestions as edits of the file in which the display's text starts at `offset`. What stands in the file in another
/// way than it was read, between two displays of one number, is not touched.
pub(crate) fn in_file(checker: &Checker<'_>, wrong: &Wrong<'_>, offset: usize, found: Vec<Suggestion>) -> Vec<Repair> {
    let repair = |Suggestion { edit, verdict, step, idle, .. }: Suggestion| Repair {
        span: edit.span.shifted(offset),
        replacement: edit.replacement,
        slip: edit.slip,
        verdict,
        step,
        idle,
        shared: None,
    };
    found.into_iter().filter(|found| is_real(checker, wrong.text, &found.edit, offset)).map(repair).collect()
}
