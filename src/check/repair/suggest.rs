//! Suggestions: single edits of a display with which it passes.
//!
//! A display that is refuted, or cannot be read, is tried with every edit that corrects a common slip
//! ([`crate::latex::slips::corrections`]). Edits that hold at a few states get the full check, and only those that pass it
//! are offered. So a suggestion makes a true equation, though its author may have meant another. Suggestions are ranked by
//! the likelihood of the slip ([`super::ranking`]). Missing terms and factors are tried only where nothing else passes: first
//! those of the display, then those of other displays, then those of the prose, then fitted ones ([`super::missing_terms`]).
//!
//! # Why a suggestion is never false
//!
//! It has passed the check that the author's text failed. Another one may have been meant; so up to three are
//! shown, the most likely first, and `--fix` acts on a single one or a clearly more likely one. Many true edits are
//! silly: a factor that is the right side over the left one, or a sum of three terms that were all lost. These are
//! not looked for.

use rayon::prelude::*;
use std::cell::Cell;
use std::collections::HashSet;

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Statement};
use crate::latex::layout::prints_derivative;
use crate::latex::slips::{Edit, Pool, Slip};
use crate::latex::{Reading, slips};
use crate::notes::claims::{Claim, Equilibrium};
use crate::source::{Fault, Span};

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::is_wrong;
use crate::check::document::setup::Run;
use crate::check::model::Model;
use crate::check::repair::inequalities::{has_inequality, may_be_meant};
use crate::check::repair::missing_terms;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::trial::failed_display::{FailedDisplay, MISSING, OFFERED, cut_to_step};
use crate::check::trial::text_trial::{Answer, Trial};
use crate::check::vacuity::tautology::{is_lost, is_reordered, is_taken_back};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::{Equation, Part};

/// The least number of edits that one thread tries at a time; the screening states are sampled for each share.
const SHARE: usize = 32;

/// The index of the last pool of parts to insert.
const LAST: usize = 4;

/// The number of pools that hold parts of the displays.
const LIKELY: usize = 3;

/// Without a claims file: the number of displays before the wrong one that parts are taken from.
const NEAR: usize = 12;

/// Without a claims file: the most edits that are tried with one pool, the likeliest kinds of slip first.
const MOST_EDITS: usize = 180;

/// A suggestion, with the reading of the edited display.
pub(crate) struct Suggestion {
    /// The edit, in the text of the display.
    pub edit: Edit,
    /// The reading of the edited text.
    pub reading: Reading,
    /// The worst verdict of its parts.
    pub verdict: Verdict,
    /// Whether it corrects one step of a chain only.
    pub step: bool,
    /// Whether a member is then zero for all values of its symbols, so that the equation is true and says nothing.
    pub vacuous: bool,
}

impl Checker<'_> {
    /// An equation with its repairs, if it is refuted or unreadable against expectation. Edits of other displays are tried if
    /// it is `alone` in being wrong; otherwise [`super::shared_edit`] finds them.
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
        // Of numbers the finding says what they give; an edit that puts letters among them is none that the author meant.
        let is_numeric = equation.finding.code == Code::NumbersDiffer;
        // What is missing is a claim, and no edit of the display makes one.
        let lacks_a_claim = equation.finding.code == Code::NeedsLimitOrSmall;
        if lacks_a_claim || equation.ok || is_known || is_numeric || !self.options.explain {
            return Ok(equation);
        }
        if !self.is_tried(at) {
            // Said once, of the first of them.
            if (0..at).all(|before| self.is_tried(before)) {
                equation.finding.message.push_str("; no edits of unreadable displays were tried, since there are many");
            }
            return Ok(equation);
        }
        let display = &self.notes.equations[at];
        let wrong = self.failed_display(at, &equation, claim);
        // If its hypotheses need a name of an unreadable display, no text can be checked.
        // No other display is suspected of a position of rest, and each trial of it samples states of its own.
        // Whether it is stable, no edit decides.
        if let Some(claimed) = &claim.equilibrium {
            // Where the claim does not fit the display, an edit of the display is no way out.
            let is_decided = equation.finding.verdict == Verdict::Refuted;
            if !is_decided || matches!(claimed.value, Equilibrium::Stable | Equilibrium::Unstable) {
                return Ok(equation);
            }
            equation.repairs = self.own_repairs(at, &equation, claim, Search::Nearest)?;
            return Ok(equation);
        }
        let is_judged = self.hypotheses(claim).is_ok() && self.local(claim).is_ok();
        if is_wrong(&equation) && is_judged {
            let contradicted = self.contradicts_definitions(at)?;
            if contradicted {
                equation.repairs = self.repairs_of_definitions(run, at, alone)?;
            }
            if equation.repairs.len() < OFFERED {
                // The units of a wrong equation may be wrong as well, so none is inferred from it.
                let found = match self.lasting(claim)? {
                    Some(lasting) => {
                        let wrong = self.failed_display(at, &equation, &lasting);
                        suggestions(&self.without_units_of(at), &wrong, Search::Likely)?
                    }
                    None => Vec::new(),
                };
                let found = match found.is_empty() {
                    true => suggestions(&self.without_units_of(at), &wrong, Search::Thorough)?,
                    false => found,
                };
                for repair in as_repairs(self, &wrong, display.body.start, found) {
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

    fn failed_display<'w>(&'w self, at: usize, equation: &Equation, claim: &'w Claim) -> FailedDisplay<'w> {
        let (display, reading) = (&self.notes.equations[at], &self.readings[at]);
        let places = places(equation, display.body);
        let steps = repairable_steps(equation, reading, display.body.start);
        FailedDisplay { at, text: &display.text, reading, claim, places, steps }
    }

    /// The corrections of a wrong display in its own text.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn own_repairs(
        &self,
        at: usize,
        equation: &Equation,
        claim: &Claim,
        search: Search,
    ) -> Result<Vec<Repair>> {
        let wrong = self.failed_display(at, equation, claim);
        let found = suggestions(self, &wrong, search)?;
        Ok(as_repairs(self, &wrong, self.notes.equations[at].body.start, found))
    }
}

/// How far suggestions are sought.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Search {
    /// Edits with parts of the display.
    Nearest,
    /// Edits with parts of the document.
    Likely,
    /// Also with quantities of the prose, and with fitted terms.
    Thorough,
}

/// The places in the text of a display where an equation is refuted; none, if it cannot be read.
fn places(equation: &Equation, body: Span) -> Vec<Span> {
    let own = |part: &&Part| !part.ok && part.finding.follows_from.is_none();
    let parts = equation.parts.iter().filter(own).map(|part| &part.finding);
    let findings: Vec<_> = if equation.parts.is_empty() { vec![&equation.finding] } else { parts.collect() };
    // The solutions of a display are tested together, so the slip may be in another one than that which fails.
    let is_anywhere = |finding: &&Finding| finding.verdict == Verdict::Unreadable || finding.code == Code::NotASolution;
    if findings.iter().any(is_anywhere) {
        return Vec::new();
    }
    let within = |span: Span| body.contains(span).then(|| Span::new(span.start - body.start, span.end - body.start));
    findings.into_iter().filter_map(|finding| within(finding.span)).collect()
}

/// The suggestions for a display, the likeliest first.
///
/// # Errors
/// As for a check of the display itself.
pub(crate) fn suggestions(checker: &Checker<'_>, wrong: &FailedDisplay<'_>, search: Search) -> Result<Vec<Suggestion>> {
    let (symbols, macros) = (&checker.model.symbols, &checker.model.macros);
    let mut tried: HashSet<(Span, String)> = HashSet::new();
    // The left side of a row that goes on from the one before is a part of that one, and is judged there.
    let display = &checker.notes.equations[wrong.at];
    let own_start = display.span.start.saturating_sub(display.body.start);
    let own = || Pool::of(std::iter::once(wrong.text), symbols, macros, MISSING);
    // Without a claims file the parts come from the displays shortly before: a book has too many others.
    let first = if checker.options.deduction { wrong.at.saturating_sub(NEAR) } else { 0 };
    let end = if checker.options.deduction { wrong.at } else { usize::MAX };
    let is_near = move |at: usize| at != wrong.at && first <= at && at < end;
    let others = || checker.notes.equations.iter().enumerate().filter(move |(at, _)| is_near(*at));
    let texts = || std::iter::once(wrong.text).chain(others().map(|(_, display)| display.text.as_str()));
    let all = || Pool::of(texts(), symbols, macros, MISSING).with_members(wrong.text, symbols, macros);
    // A quantity of the prose may be missing from the only display that should contain it.
    let said = || checker.notes.inline.iter().map(|span| checker.notes.source.slice(*span).trim_matches('$'));
    let prose = || Pool::of(said(), symbols, macros, MISSING).factors_only();
    let like = || own().of_like_terms(symbols, macros);
    let pools: [&dyn Fn() -> Pool; 5] = [&|| own().factors_only(), &|| all().factors_only(), &all, &prose, &like];
    // Without a claims file few displays that do not follow are wrong, so the search is kept short.
    let is_short = checker.options.deduction;
    let few: [&dyn Fn() -> Pool; 2] = [pools[0], pools[2]];
    let pools: &[&dyn Fn() -> Pool] = if is_short { &few } else { &pools };
    let fitted = || -> Result<Vec<Suggestion>> {
        let mut edits = missing_terms::edits(checker, wrong)?;
        edits.retain(|edit| edit.span.start >= own_start);
        let mut found = passing_edits(checker, wrong, &edits)?;
        found.retain(|suggestion| !suggestion.vacuous);
        Ok(found)
    };
    let of_inequality = has_inequality(wrong.reading);
    // An edit that removes something often makes a true equation that was not meant, so the search then goes on.
    let mut removals: Vec<Suggestion> = Vec::new();
    // An edit after which the equation says nothing is offered only if there is no other.
    let mut vacuous: Vec<Suggestion> = Vec::new();
    // Parentheses around what is printed often do so too; they come after a likelier edit of a later pool.
    let mut pairs: Vec<Suggestion> = Vec::new();
    let far = match search {
        Search::Nearest => 1,
        Search::Likely => LIKELY,
        Search::Thorough => pools.len(),
    };
    for (at, pool) in pools.iter().take(far).enumerate() {
        // Fitted terms come after parts of the document, and before parts that only resemble them.
        if at == LAST {
            let found = fitted()?;
            if !found.is_empty() {
                return Ok(distinct(checker, removals.into_iter().chain(pairs).chain(found)));
            }
        }
        let mut edits = slips::corrections(wrong.text, symbols, macros, &pool());
        edits.retain(|edit| {
            edit.span.start >= own_start
                && wrong.concerns(edit)
                && !tried.contains(&(edit.span, edit.replacement.clone()))
        });
        // A ± is inserted only before a root, or where the text has another ±.
        let has_root = |edit: &Edit| match edit.slip {
            Slip::Term => edit.replacement.contains("sqrt"),
            Slip::Sign => wrong.text.contains("sqrt"),
            _ => true,
        };
        edits.retain(|edit| !has_branches(&edit.replacement) || has_branches(wrong.text) || has_root(edit));
        if of_inequality {
            edits.retain(|edit| may_be_meant(wrong.text, edit));
        }
        if is_short {
            edits.retain(|edit| !is_removal(edit));
            edits.sort_by_key(|edit| edit.slip);
            edits.truncate(MOST_EDITS);
        }
        let mut found = passing_edits(checker, wrong, &edits)?;
        tried.extend(edits.into_iter().map(|edit| (edit.span, edit.replacement)));
        found.sort_by_key(|suggestion| rank(wrong.text, &suggestion.edit, suggestion.step));
        // Of an inequality the relation is the likeliest to be reversed.
        if of_inequality {
            found.sort_by_key(|suggestion| suggestion.edit.slip != Slip::Relation);
        }
        vacuous.extend(found.extract_if(.., |suggestion| suggestion.vacuous).filter(|_| at < LAST));
        pairs.extend(found.extract_if(.., |suggestion| adds_parentheses(wrong.text, &suggestion.edit)));
        let is_less = found.iter().all(|suggestion| is_removal(&suggestion.edit));
        removals.extend(found);
        if !is_less {
            break;
        }
        let is_last = at + 1 == pools.len();
        if is_short && is_last && search == Search::Thorough && removals.is_empty() {
            removals = fitted()?;
        }
    }
    for pair in pairs {
        let key = |suggestion: &Suggestion| rank(wrong.text, &suggestion.edit, suggestion.step);
        let after = removals.iter().position(|other| key(other) > key(&pair)).unwrap_or(removals.len());
        removals.insert(after, pair);
    }
    Ok(distinct(checker, if removals.is_empty() { vacuous } else { removals }))
}

/// Whether a text has two branches, by ±.
pub(crate) fn has_branches(text: &str) -> bool {
    text.contains(r"\pm") || text.contains(r"\mp")
}

/// Whether an edit removes a term or a factor.
fn is_removal(edit: &Edit) -> bool {
    matches!(edit.slip, Slip::Term | Slip::Factor) && edit.replacement.trim().is_empty()
}

/// The first few suggestions, without those that are equal to one before them.
fn distinct(checker: &Checker<'_>, found: impl IntoIterator<Item = Suggestion>) -> Vec<Suggestion> {
    let mut distinct: Vec<Suggestion> = Vec::new();
    for suggestion in found {
        if !distinct.iter().any(|known| says_the_same(&known.reading, &suggestion.reading, checker.model)) {
            distinct.push(suggestion);
        }
    }
    distinct.truncate(OFFERED);
    distinct
}

/// The edits with which the display passes.
fn passing_edits(checker: &Checker<'_>, wrong: &FailedDisplay<'_>, edits: &[Edit]) -> Result<Vec<Suggestion>> {
    let share = edits.len().div_ceil(4 * rayon::current_num_threads()).max(SHARE);
    let found: Result<Vec<Vec<Suggestion>>> = edits
        .par_chunks(share)
        .map(|share| {
            let whole = Trial::new(checker, wrong.at, wrong.reading, wrong.claim)?;
            // Without a claims file a search that costs the full check for each edit is not worth it.
            if checker.options.deduction && whole.has_no_screen() {
                return Ok(Vec::new());
            }
            let cuts: Vec<_> = wrong.steps.iter().map(|step| (*step, step_of(wrong.reading, *step))).collect();
            let mut steps = Vec::new();
            for (step, now) in cuts.iter().filter(|_| wrong.claim.is_plain()) {
                steps.push((*step, now, Trial::new(checker, wrong.at, now, wrong.claim)?.for_step(*step)));
            }
            let mut passing = Vec::new();
            for edit in share {
                let text = edit.applied(wrong.text);
                // Exchanged names, and products of vectors, vanish too easily to be offered.
                let multiplies = ["\\times", "\\cdot"].iter().any(|operator| edit.replacement.contains(operator));
                let may_say_nothing = !is_removal(edit) && edit.slip != Slip::Name && !multiplies;
                let is_written_out = |side: &Expr| {
                    let printed = text.get(side.span.range()).unwrap_or_default();
                    let is_evaluated = ["\\int", "\\sum", "\\prod"].iter().any(|sign| printed.contains(sign));
                    is_evaluated || prints_derivative(printed, &checker.model.macros)
                };
                let mut passes = |trial: &Trial<'_, '_>, now: &Reading, step: bool| -> Result<bool> {
                    let vacuous = Cell::new(false);
                    let is_meant = |reading: &Reading| {
                        vacuous.set(makes_a_member_zero(now, reading, checker.model));
                        let says_something = match vacuous.get() {
                            true => may_say_nothing && has_a_zero_member(reading),
                            false => {
                                let is_one_way = !has_branches(wrong.text);
                                let taken_back = is_one_way && is_taken_back(now, reading);
                                let is_lost = || is_lost(now, reading, checker.model, &is_written_out);
                                !(taken_back || is_lost() || repeats_a_statement(reading))
                            }
                        };
                        says_something && !whole.has_vanishing_rate(reading)
                    };
                    let Answer::Passes(reading, parts) = trial.judge_where(&text, is_meant)? else { return Ok(false) };
                    let (edit, verdict, vacuous) = (edit.clone(), Part::worst(&parts), vacuous.get());
                    passing.push(Suggestion { edit, reading, verdict, step, vacuous });
                    Ok(true)
                };
                if passes(&whole, wrong.reading, false)? {
                    continue;
                }
                for (_, now, trial) in steps.iter().filter(|(step, ..)| is_within_member(edit, wrong.reading, *step)) {
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

/// The first wrong member of each chain with more than one failing link, as the statement and the index of the member. A
/// correction of this member need not make the rest of the chain pass. Later members are not changed to agree with it.
fn repairable_steps(equation: &Equation, reading: &Reading, offset: usize) -> Vec<(usize, usize)> {
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

/// A reading cut to one step of a chain.
fn step_of(reading: &Reading, step: (usize, usize)) -> Reading {
    let mut reading = reading.clone();
    cut_to_step(&mut reading, step);
    reading
}

/// Whether an edit changes a member.
fn is_within_member(edit: &Edit, reading: &Reading, (statement, member): (usize, usize)) -> bool {
    let statement = reading.statements.get(statement).and_then(|statement| statement.as_ref().ok());
    statement.and_then(|statement| statement.members.get(member)).is_some_and(|member| member.span.contains(edit.span))
}

/// Whether a member has become zero for all values of its symbols, and is not printed as 0.
fn makes_a_member_zero(before: &Reading, after: &Reading, model: &Model) -> bool {
    let vanishes =
        |member: &Expr| !member.is_null() && formulas::is_identity(member, &Expr::integer(0, member.span), model);
    let known: Vec<&Expr> = before.statements.iter().flatten().flat_map(|statement| &statement.members).collect();
    let mut members = after.statements.iter().flatten().flat_map(|statement| &statement.members);
    members.any(|member| vanishes(member) && !known.contains(&member))
}

/// Whether two statements of a reading are the same.
fn repeats_a_statement(reading: &Reading) -> bool {
    let mut said: Vec<&[Expr]> = Vec::new();
    reading.statements.iter().flatten().any(|statement| {
        let again = said.contains(&statement.members.as_slice());
        said.push(&statement.members);
        again
    })
}

/// Whether a member of a reading is printed as 0.
fn has_a_zero_member(reading: &Reading) -> bool {
    reading.statements.iter().flatten().any(|statement| statement.members.iter().any(Expr::is_null))
}

/// Whether two readings are equal member by member for all values of their symbols. Matrices are compared cell by cell.
fn says_the_same(a: &Reading, b: &Reading, model: &Model) -> bool {
    let has_cells = |expr: &Expr| {
        let mut found = false;
        expr.walk(&mut |inner| found |= matches!(inner.node, Node::Matrix(_)));
        found
    };
    agree_memberwise(a, b, |a, b| if has_cells(a) { is_reordered(a, b) } else { formulas::same(a, b, model) })
}

/// Whether all pairs of members of two readings are alike.
pub(crate) fn agree_memberwise(a: &Reading, b: &Reading, alike: impl Fn(&Expr, &Expr) -> bool) -> bool {
    let same = |(a, b): (&Statement, &Statement)| {
        a.members.len() == b.members.len() && a.members.iter().zip(&b.members).all(|(a, b)| alike(a, b))
    };
    let (a, b): (Vec<_>, Vec<_>) = (a.statements.iter().flatten().collect(), b.statements.iter().flatten().collect());
    a.len() == b.len() && a.into_iter().zip(b).all(same)
}

/// Whether the file has the text that an edit changes, in a display that starts at `offset`. It has not where an erratum
/// or a split display changed the text before it was read.
pub(crate) fn is_in_source(checker: &Checker<'_>, text: &str, edit: &Edit, offset: usize) -> bool {
    checker.source.slice(edit.span.shifted(offset)) == &text[edit.span.range()]
}

/// Suggestions as repairs of the file, in which the text of the display starts at `offset`.
pub(crate) fn as_repairs(
    checker: &Checker<'_>,
    wrong: &FailedDisplay<'_>,
    offset: usize,
    found: Vec<Suggestion>,
) -> Vec<Repair> {
    let repair = |Suggestion { edit, verdict, step, vacuous, .. }: Suggestion| Repair {
        span: edit.span.shifted(offset),
        replacement: edit.replacement,
        slip: edit.slip,
        verdict,
        step,
        idle: vacuous,
        shared: None,
    };
    // No author means a term with a factor of 0.
    let is_nothing = |found: &Suggestion| {
        ["\\frac0", "\\frac{0}", "\\frac 0"].iter().any(|zero| found.edit.replacement.contains(zero))
    };
    found
        .into_iter()
        .filter(|found| is_in_source(checker, wrong.text, &found.edit, offset) && !is_nothing(found))
        .map(repair)
        .collect()
}
