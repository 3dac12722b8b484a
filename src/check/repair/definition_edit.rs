//! The edits of a display that defines a name after which everything that uses the name holds.
//!
//! Such an edit makes another model. It is compared with the equations that use the name, then with the display
//! itself in the other model. It is offered if the whole document passes with it.
//!
//! # Where a wrong definition is corrected
//!
//! In the definition, not where it shows. Another text of the display is read, its meaning of a name is compared
//! with everything that uses the name, and it is offered if the whole document passes. Definitions that contradict
//! other uses of the name are looked for first; otherwise the rest of the display would be made to agree with the
//! slip. What is wrong teaches nothing while it is corrected: units are inferred without it.

use rayon::prelude::*;

use crate::Result;
use crate::formula::Expr;
use crate::latex::slips::{Edit, Pool, Slip};
use crate::latex::{DefinedSymbol, slips};
use crate::notes::claims::Claim;

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::setup::Run;
use crate::check::equations::noticed::Pins;
use crate::check::repair::suggest::{Suggestion, in_file, is_real, likelihood};
use crate::check::sample::context::Options;
use crate::check::sample::setting::FEWEST;
use crate::check::trial::document::{first_unexpected, retyped};
use crate::check::trial::wrong::{MISSING, OFFERED, Wrong};
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;

/// With so many edits the whole document is checked at most.
const DOCUMENTS: usize = 4;

/// Nothing is put in, then what stands in the display, then what stands in the document.
const POOLS: usize = 3;

/// So many of the likeliest that nothing notices are tried in the display itself: much goes unnoticed of what its constancy
/// alone tests.
const TRIED: usize = 160;

/// The same where each takes longer, as solutions are counted, or where the display is not known to be wrong there.
const FEW: usize = 24;

impl Checker<'_> {
    /// The edits of what a wrong equation defines, or, if it is alone in being wrong, of a definition that it stands on,
    /// with which the whole document passes.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn repairs_of_definitions(&self, run: &Run<'_>, at: usize, alone: bool) -> Result<Vec<Repair>> {
        self.redefined_by(run, at, alone, POOLS)
    }

    /// The edits of what a display defines itself, of what stands in it, with which the whole document passes.
    ///
    /// # Errors
    /// As there.
    pub(crate) fn repairs_of_own_definition(&self, run: &Run<'_>, at: usize) -> Result<Vec<Repair>> {
        self.redefined_by(run, at, false, 1)
    }

    /// The same with so many pools of what may be put in, the first of which is empty.
    fn redefined_by(&self, run: &Run<'_>, at: usize, alone: bool, pools: usize) -> Result<Vec<Repair>> {
        let members = || self.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let used = |new: &DefinedSymbol| members().any(|member| self.model.depends_on(member, &[new.symbol]));
        let others = (0..self.notes.equations.len()).filter(|other| alone && *other != at);
        for other in std::iter::once(at).chain(others) {
            let display = &self.notes.equations[other];
            let (reading, none) = (&self.readings[other], Claim::default());
            let claim = self.assigned[other].unwrap_or(&none);
            let introduces = |new: &DefinedSymbol| other == at || used(new);
            if claim.expect.is_some() || !claim.errata.is_empty() || !reading.introduced.iter().any(introduces) {
                continue;
            }
            let (places, steps) = (Vec::new(), Vec::new());
            let wrong = Wrong { at: other, text: &display.text, reading, claim, places, steps };
            let found = self.doubting(other).redefinitions(run, &wrong, pools)?;
            if !found.is_empty() {
                return Ok(in_file(self, &wrong, display.body.start, found));
            }
        }
        Ok(Vec::new())
    }

    /// Whether something that stands on a name fails with what a display says of the name: then it is there that it is
    /// wrong, though the rest of the display could be made to agree.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn contradicts_definitions(&self, at: usize) -> Result<bool> {
        for new in &self.readings[at].introduced {
            if Pins::of(self, new, true)?.notice(&new.formula) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The edits of a display that defines something, with which all that uses the name holds, and the document passes.
    fn redefinitions(&self, run: &Run<'_>, wrong: &Wrong<'_>, most: usize) -> Result<Vec<Suggestion>> {
        let (symbols, macros) = (&self.model.symbols, &self.model.macros);
        let introduced = &wrong.reading.introduced;
        let pins: Vec<Pins<'_, '_>> = introduced.iter().map(|new| Pins::of(self, new, true)).collect::<Result<_>>()?;
        let own = || Pool::of(std::iter::once(wrong.text), symbols, macros, MISSING).factors_only();
        let others = self.notes.equations.iter().enumerate().filter(|(at, _)| *at != wrong.at);
        let texts = std::iter::once(wrong.text).chain(others.map(|(_, display)| display.text.as_str()));
        let all = || Pool::of(texts.clone(), symbols, macros, MISSING);
        let pools: [&dyn Fn() -> Pool; POOLS] = [&Pool::empty, &own, &all];
        let mut tried = Vec::new();
        let start = self.notes.equations[wrong.at].body.start;
        let tries = if most == POOLS && wrong.claim.solves.is_none() { TRIED } else { FEW };
        for pool in pools.into_iter().take(most) {
            let mut edits = slips::corrections(wrong.text, symbols, macros, &pool());
            edits.retain(|edit| is_real(self, wrong.text, edit, start) && !tried.contains(edit));
            // With a rate that is 0 by a law all is conserved.
            edits.retain(|edit| edit.slip != Slip::Factor || !edit.replacement.contains("\\dot"));
            let mut unnoticed: Vec<(&Edit, String, Vec<Expr>)> = Vec::new();
            for edit in &edits {
                let text = edit.applied(wrong.text);
                let Some(formulas) = self.redefines(wrong.at, wrong.claim, &text) else { continue };
                let mut changed =
                    introduced.iter().zip(&formulas).zip(&pins).filter(|((was, is), _)| was.formula != **is).peekable();
                if changed.peek().is_some() && !changed.any(|((_, formula), holds)| holds.notice(formula)) {
                    unnoticed.push((edit, text, formulas));
                }
            }
            unnoticed.sort_by_key(|(edit, ..)| likelihood(wrong.text, edit, false));
            // A factor put in at two places is one edit; and where a sign is noticed by nothing, so are the two signs.
            let mut distinct: Vec<(&Edit, String, Vec<Expr>)> = Vec::new();
            for candidate in unnoticed {
                let same = |known: &Expr, new: &Expr| {
                    formulas::same(known, new, self.model) || formulas::same(known, &new.clone().negated(), self.model)
                };
                let is_it = |known: &Vec<Expr>| known.iter().zip(&candidate.2).all(|(known, new)| same(known, new));
                if distinct.len() < tries && !distinct.iter().any(|(.., known)| is_it(known)) {
                    distinct.push(candidate);
                }
            }
            let passes = |(edit, text, formulas): (&Edit, String, Vec<Expr>)| {
                let (edit, reading) = (edit.clone(), wrong.reading.clone());
                let suggestion =
                    || Suggestion { edit, reading, verdict: Verdict::Definition, step: false, idle: false };
                self.passes_redefined(wrong, &text, &formulas).then(suggestion)
            };
            let mut candidates: Vec<Suggestion> = distinct.into_par_iter().filter_map(passes).collect();
            candidates.truncate(DOCUMENTS);
            candidates.retain(|suggestion| self.document_passes(run, wrong.at, &suggestion.edit));
            candidates.truncate(OFFERED);
            if !candidates.is_empty() {
                return Ok(candidates);
            }
            tried.extend(edits);
        }
        Ok(Vec::new())
    }

    /// Whether nothing in a display is refuted, or cannot be read, where it has this text and so defines other things.
    fn passes_redefined(&self, wrong: &Wrong<'_>, text: &str, formulas: &[Expr]) -> bool {
        let Some((model, reading)) = self.redefined(wrong.at, wrong.claim, text, formulas) else { return false };
        let options = Options { points: FEWEST.min(self.options.points), explain: false, ..self.options };
        let checker = Checker { model: &model, options, units: self.units.clone(), ..*self };
        let display = &self.notes.equations[wrong.at];
        let parts = checker.parts((wrong.at, display.body.start), &reading, wrong.claim, &shown(display));
        let is_wrong = |verdict| matches!(verdict, Verdict::Refuted | Verdict::Domain | Verdict::Unreadable);
        parts.is_ok_and(|parts| !parts.iter().any(|part| is_wrong(part.finding.verdict)))
    }

    /// Whether all of the document is as it should be with an edit of a display.
    fn document_passes(&self, run: &Run<'_>, at: usize, edit: &Edit) -> bool {
        let mut file = self.notes.source.text.clone();
        file.replace_range(edit.span.shifted(self.notes.equations[at].body.start).range(), &edit.replacement);
        let unexpected = retyped(self.notes, file).and_then(|notes| first_unexpected(run, self.claims, &notes, at));
        unexpected.is_ok_and(|unexpected| unexpected.is_none())
    }
}
