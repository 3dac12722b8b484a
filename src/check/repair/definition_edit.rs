//! Repairs of definitions: edits of a display that defines a name, with which the equations that use the name pass.
//!
//! A refuted equation may be correct, and a definition that it uses wrong; or a display may define its own name wrongly.
//! Such an edit makes another model. It is tested by the equations that use the name
//! ([`DefinitionTests`](crate::check::equations::definition_tests::DefinitionTests)), then by the display itself in the
//! other model. It is offered if the whole document passes with it.
//!
//! # Where a wrong definition is corrected
//!
//! In the definition, not where it shows. Another text of the display is read, its meaning of a name is compared
//! with everything that uses the name, and it is offered if the whole document passes. Definitions that contradict
//! other uses of the name are looked for first; otherwise the rest of the display would be made to agree with the
//! slip. What is wrong teaches nothing while it is corrected: units are inferred without it.

use rayon::prelude::*;

use crate::Result;
use crate::formula::{Expr, Value};
use crate::latex::slips::{Edit, Pool, Slip};
use crate::latex::{DefinedSymbol, slips};
use crate::notes::claims::Claim;
use crate::scalar::{RunningError, TERMS};
use crate::source::Span;

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::setup::Run;
use crate::check::equations::definition_tests::DefinitionTests;
use crate::check::equations::sentences;
use crate::check::model::sampling::Spread;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::repair::suggest::{Suggestion, as_repairs, is_in_source};
use crate::check::sample::context::{Context, Options};
use crate::check::sample::setting::FEWEST;
use crate::check::state::sampled_state::SampledState;
use crate::check::trial::edited_document::{Checked, first_unexpected, with_text};
use crate::check::trial::failed_display::{FailedDisplay, MISSING, OFFERED};
use crate::check::trial::text_trial::Trial;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;

/// The largest number of edits with which the whole document is checked.
const DOCUMENTS: usize = 4;

/// The number of pools: nothing is inserted, then parts of the display, then parts of the document.
const POOLS: usize = 3;

/// The number of edits, the likeliest first, that are tried in the display itself after no equation has detected them. It is
/// large, since "is constant" alone detects few changes.
const TRIED: usize = 160;

/// The relative distance of two values that may be equal.
const CLOSE: f64 = 1e-6;

/// The same number where each trial takes longer, or where the definition is not known to be wrong.
const FEW: usize = 24;

impl Checker<'_> {
    /// The edits of a definition with which the whole document passes: of the definition in a wrong equation or, if no other
    /// equation is wrong, of one that it uses.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn repairs_of_definitions(&self, run: &Run<'_>, at: usize, alone: bool) -> Result<Vec<Repair>> {
        self.repairs_from_pools(run, at, alone, POOLS)
    }

    /// The edits of the definition in a display, from parts of the display only, with which the whole document passes.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn repairs_of_own_definition(&self, run: &Run<'_>, at: usize) -> Result<Vec<Repair>> {
        self.repairs_from_pools(run, at, false, 1)
    }

    /// The same, with the first `pools` pools of parts to insert; the first pool is empty.
    fn repairs_from_pools(&self, run: &Run<'_>, at: usize, alone: bool, pools: usize) -> Result<Vec<Repair>> {
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
            let wrong = FailedDisplay { at: other, text: &display.text, reading, claim, places, steps };
            let found = self.without_units_of(other).redefinitions(run, &wrong, at, pools)?;
            if !found.is_empty() {
                return Ok(as_repairs(self, &wrong, display.body.start, found));
            }
        }
        Ok(Vec::new())
    }

    /// Whether an equation that uses a name of a display fails with its definition. Then the definition is wrong, even if the
    /// rest of the display could be made to agree with it.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn contradicts_definitions(&self, at: usize) -> Result<bool> {
        for new in &self.readings[at].introduced {
            if DefinitionTests::of(self, new, true)?.detects(&new.formula) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The edits of a display that defines names, with which the equations that use the names hold, the `failed` display passes,
    /// and nothing fails that is as expected now.
    fn redefinitions(
        &self,
        run: &Run<'_>,
        wrong: &FailedDisplay<'_>,
        failed: usize,
        most: usize,
    ) -> Result<Vec<Suggestion>> {
        let (symbols, macros) = (&self.model.symbols, &self.model.macros);
        let introduced = &wrong.reading.introduced;
        let tests: Vec<DefinitionTests<'_, '_>> =
            introduced.iter().map(|new| DefinitionTests::of(self, new, true)).collect::<Result<_>>()?;
        let own = || Pool::of(std::iter::once(wrong.text), symbols, macros, MISSING).factors_only();
        let others = self.notes.equations.iter().enumerate().filter(|(at, _)| *at != wrong.at);
        let texts = std::iter::once(wrong.text).chain(others.map(|(_, display)| display.text.as_str()));
        let all = || Pool::of(texts.clone(), symbols, macros, MISSING);
        let pools: [&dyn Fn() -> Pool; POOLS] = [&Pool::empty, &own, &all];
        let mut tried = Vec::new();
        let start = self.notes.equations[wrong.at].body.start;
        let tries = if most == POOLS && wrong.claim.solves.is_none() { TRIED } else { FEW };
        let trial = Trial::new(self, wrong.at, wrong.reading, wrong.claim).ok();
        let changes = |text: &str| {
            let reading = || self.as_printed(text, wrong.claim, macros);
            trial.as_ref().is_some_and(|trial| trial.changes_a_constant(&reading()))
        };
        let values = Values::of(self, introduced);
        for (at, pool) in pools.into_iter().take(most).enumerate() {
            let mut edits = slips::corrections(wrong.text, symbols, macros, &pool());
            // Parentheses wait for the numbers that may be lost: a lost 2 under a fraction line is likelier.
            edits.retain(|edit| at > 0 || most == 1 || !adds_parentheses(wrong.text, edit));
            edits.retain(|edit| is_in_source(self, wrong.text, edit, start) && !tried.contains(edit));
            // A factor that is a vanishing rate makes anything conserved.
            edits.retain(|edit| edit.slip != Slip::Factor || !edit.replacement.contains("\\dot"));
            let mut undetected: Vec<(&Edit, String, Vec<Expr>)> = Vec::new();
            for edit in &edits {
                let text = edit.applied(wrong.text);
                let Some(formulas) = self.new_definitions(wrong.at, wrong.claim, &text) else { continue };
                let mut changed = introduced
                    .iter()
                    .zip(&formulas)
                    .zip(&tests)
                    .filter(|((was, is), _)| was.formula != **is)
                    .peekable();
                let is_undetected =
                    changed.peek().is_some() && !changed.any(|((_, formula), tests)| tests.detects(formula));
                // Most edits of a constant of the motion change along it.
                if is_undetected && changes(&text) {
                    continue;
                }
                // 2γ = R/L gives γ a formula, but only γ = R/(2L) is a definition.
                if is_undetected && self.redefined_model(wrong.at, wrong.claim, &text, &formulas).is_some() {
                    undetected.push((edit, text, formulas));
                }
            }
            undetected.sort_by_key(|(edit, ..)| rank(wrong.text, edit, false));
            // Edits that give the same definition, or the same except for its sign, count once.
            let mut distinct: Vec<(&Edit, String, Vec<Expr>)> = Vec::new();
            for candidate in undetected {
                let same = |known: &Expr, new: &Expr| {
                    let [equal, opposite] = values.may_be_equal(known, new);
                    equal && formulas::same(known, new, self.model)
                        || opposite && formulas::same(known, &new.clone().negated(), self.model)
                };
                let is_it = |known: &Vec<Expr>| known.iter().zip(&candidate.2).all(|(known, new)| same(known, new));
                if distinct.len() < tries && !distinct.iter().any(|(.., known)| is_it(known)) {
                    distinct.push(candidate);
                }
            }
            let passes = |(edit, text, formulas): (&Edit, String, Vec<Expr>)| {
                let (edit, reading) = (edit.clone(), wrong.reading.clone());
                let verdict = self.redefined_verdict(wrong, &text, &formulas)?;
                Some(Suggestion { edit, reading, verdict, step: false, vacuous: false })
            };
            let mut candidates: Vec<Suggestion> = distinct.into_par_iter().filter_map(passes).collect();
            candidates.truncate(DOCUMENTS);
            candidates.retain(|suggestion| self.document_passes(run, wrong.at, failed, &suggestion.edit));
            candidates.truncate(OFFERED);
            if !candidates.is_empty() {
                return Ok(candidates);
            }
            tried.extend(edits);
        }
        Ok(Vec::new())
    }

    /// The verdict on a display with this text, and so with other definitions, if it is neither refuted nor unreadable: that on
    /// what it claims, or that it is a definition.
    pub(crate) fn redefined_verdict(
        &self,
        wrong: &FailedDisplay<'_>,
        text: &str,
        formulas: &[Expr],
    ) -> Option<Verdict> {
        let (model, reading) = self.redefined_model(wrong.at, wrong.claim, text, formulas)?;
        let options = Options { points: FEWEST.min(self.options.points), explain: false, ..self.options };
        let checker = Checker { model: &model, options, units: self.units.clone(), ..*self };
        let display = &self.notes.equations[wrong.at];
        let parts = checker.parts((wrong.at, display.body.start), &reading, wrong.claim, &shown(display)).ok()?;
        let verdicts = || parts.iter().map(|part| part.finding.verdict);
        if verdicts().any(|verdict| matches!(verdict, Verdict::Refuted | Verdict::Domain | Verdict::Unreadable)) {
            return None;
        }
        Some(
            verdicts()
                .filter(|verdict| verdict.holds())
                .max_by_key(|verdict| verdict.severity())
                .unwrap_or(Verdict::Definition),
        )
    }

    /// Whether with an edit of a display that display and the failed one are as expected, and all that is as expected now.
    fn document_passes(&self, run: &Run<'_>, at: usize, failed: usize, edit: &Edit) -> bool {
        let mut file = self.notes.source.text.clone();
        file.replace_range(edit.span.shifted(self.notes.equations[at].body.start).range(), &edit.replacement);
        let quick = Checker { options: Options { explain: false, ..self.options }, units: self.units.clone(), ..*self };
        // Another mistake of the document is none of this edit.
        let fails_now = |checked: Checked| match checked {
            Checked::Display(display) if display == at || display == failed => false,
            Checked::Display(display) => {
                quick.equation(display, self.assigned[display]).is_ok_and(|equation| !equation.ok)
            }
            Checked::Sentence(sentence) => {
                let claimed = &self.claims.sentences[sentence];
                sentences::check(&quick, sentence, claimed).is_ok_and(|equation| !equation.ok)
            }
        };
        let unexpected =
            with_text(self.notes, file).and_then(|notes| first_unexpected(run, self.claims, &notes, at, &fails_now));
        unexpected.is_ok_and(|unexpected| unexpected.is_none())
    }
}

/// A state at which formulas for a name are compared: most differ there.
struct Values<'m>(Option<SampledState<'m, RunningError>>);

impl<'m> Values<'m> {
    /// A state for formulas like those that a display has.
    fn of(checker: &Checker<'m>, introduced: &[DefinedSymbol]) -> Self {
        let context = Context {
            model: checker.model,
            options: checker.options,
            hypotheses: &[],
            on_shell: Some(false),
            topic: "formulas for a name",
            span: Span::default(),
            spread: Spread::Declared,
            local: &[],
        };
        let formulas: Vec<&Expr> = introduced.iter().map(|new| &new.formula).collect();
        let mut mode = context.mode(false, &formulas);
        // Another formula may have a dot more.
        mode.order = (mode.order + 1).min(TERMS - 1);
        Values(context.ensemble(mode, false, 1).ok().and_then(|ensemble| ensemble.states.into_iter().next()))
    }

    /// Whether two formulas may be equal, and whether they may be opposite, as far as their values say.
    fn may_be_equal(&self, a: &Expr, b: &Expr) -> [bool; 2] {
        let value = |of: &Expr| match self.0.as_ref()?.now(of, &[]) {
            Ok(Value::Scalar(value)) if value.value.is_finite() => Some(value.value),
            _ => None,
        };
        let Some((a, b)) = value(a).zip(value(b)) else { return [true, true] };
        [a - b, a + b].map(|difference| difference.abs() <= CLOSE * (a.abs() + b.abs()))
    }
}
