//! Which display is wrong, where one contradicts a definition that it uses.
//!
//! One edit of the definition may make the display hold, as one edit of the display does. The other displays that use the
//! name decide: where one of them holds with the definition as printed and not with the edited one, the display is wrong;
//! where one of them fails as printed and holds with the edited one, the definition is. Where there is no such display,
//! nobody can tell.

use crate::Result;
use crate::formula::{Expr, Node, Symbols, text};
use crate::latex::DefinedSymbol;
use crate::latex::slips::{self, Edit, Pool, Slip};
use crate::notes::claims::Claim;

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::equations::definition_tests::DefinitionTests;
use crate::check::model::Model;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::repair::suggest::is_in_source;
use crate::check::trial::failed_display::{FailedDisplay, MISSING};
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::{Repair, Shared};

/// The most edits of one definition that are tried, the likeliest first.
const TRIED: usize = 320;

/// The most definitions that are suspected, the nearest to the display first.
const SUSPECTED: usize = 4;

/// Another definition that a display could contradict by a slip in it.
pub(crate) struct Culprit {
    /// The place of the definition.
    pub at: usize,
    /// The edit with which the display holds.
    pub repair: Repair,
    /// The names of the other displays that fail as printed and hold with the edit.
    pub others: Vec<String>,
}

impl Checker<'_> {
    /// The definition that may be wrong in the place of a failed display; `None`, if the slip is in the display.
    ///
    /// # Errors
    /// As for a check of the equation.
    pub(crate) fn culprit(&self, failed: usize) -> Result<Option<Culprit>> {
        let members = || self.readings[failed].statements.iter().flatten().flat_map(|statement| &statement.members);
        let uses = |new: &DefinedSymbol| members().any(|member| self.model.depends_on(member, &[new.symbol]));
        let uses_it = |new: &DefinedSymbol| uses(new) || self.is_judged_as_a_whole(failed, new).unwrap_or(false);
        let defining = |at: &usize| *at != failed && self.readings[*at].introduced.iter().any(uses_it);
        let mut found: Option<Culprit> = None;
        // An equation may stand before the display that gives its solution.
        let later = failed + 1..self.readings.len();
        for at in (0..failed).rev().chain(later).filter(defining).take(SUSPECTED) {
            let Some(culprit) = self.edited_definition(at, failed)? else { continue };
            if found.as_ref().is_none_or(|known| known.others.len() < culprit.others.len()) {
                found = Some(culprit);
            }
        }
        Ok(found)
    }

    /// The likeliest edit of a definition with which a failed display holds, and nothing fails that holds.
    fn edited_definition(&self, at: usize, failed: usize) -> Result<Option<Culprit>> {
        let (symbols, macros) = (&self.model.symbols, &self.model.macros);
        let display = &self.notes.equations[at];
        let introduced = &self.readings[at].introduced;
        let tests: Vec<DefinitionTests<'_, '_>> =
            introduced.iter().map(|new| DefinitionTests::of(self, new, true)).collect::<Result<_>>()?;
        let name = format!("({})", shown(&self.notes.equations[failed]));
        let parts = Pool::of(std::iter::once(display.text.as_str()), symbols, macros, MISSING).factors_only();
        let mut edits = slips::corrections(&display.text, symbols, macros, &Pool::empty());
        let more = slips::corrections(&display.text, symbols, macros, &parts);
        let more: Vec<Edit> = more.into_iter().filter(|edit| !edits.contains(edit)).collect();
        edits.extend(more);
        edits.retain(|edit| {
            is_slip(edit)
                && !adds_parentheses(&display.text, edit)
                && is_in_source(self, &display.text, edit, display.body.start)
        });
        edits.sort_by_key(|edit| rank(&display.text, edit, false));
        let (reading, claim) = (&self.readings[at], &Claim::default());
        let (places, steps) = (Vec::new(), Vec::new());
        let own = FailedDisplay { at, text: &display.text, reading, claim, places, steps };
        // A display that fails in another part fails with every edit.
        let printed: Vec<Expr> = introduced.iter().map(|new| new.formula.clone()).collect();
        let passes_now = self.redefined_verdict(&own, &display.text, &printed).is_some();
        let whole = match introduced.as_slice() {
            [new] => WholeUsers::of(self, new, failed)?,
            _ => None,
        };
        let mut best: Option<Culprit> = None;
        for edit in edits.into_iter().take(TRIED) {
            let text = edit.applied(&display.text);
            let Some(formulas) = self.new_definitions(at, claim, &text) else { continue };
            let is_same =
                introduced.iter().zip(&formulas).all(|(was, is)| formulas::same(&was.formula, is, self.model));
            if is_same || formulas.iter().any(|formula| cancels(formula, symbols)) {
                continue;
            }
            let (mut holds, mut breaks, mut others) = (true, false, Vec::new());
            let changed = introduced.iter().zip(&formulas).zip(&tests).filter(|((was, is), _)| was.formula != **is);
            let mut is_tested = false;
            for ((_, formula), tests) in changed {
                let Some(outcomes) = tests.outcomes(formula) else {
                    breaks = true;
                    continue;
                };
                for outcome in outcomes {
                    match outcome.of == name {
                        true => (is_tested, holds) = (true, holds && outcome.holds),
                        false => {
                            breaks |= outcome.held && !outcome.holds;
                            let of = outcome.of.trim_matches(['(', ')']).to_owned();
                            if !outcome.held && outcome.holds && !others.contains(&of) {
                                others.push(of);
                            }
                        }
                    }
                }
            }
            if let Some(whole) = whole.as_ref().filter(|_| !is_tested && !breaks) {
                is_tested = true;
                let found = whole.with(&formulas[0]);
                (holds, breaks) = (found.holds, found.breaks);
                others.extend(found.others.into_iter().filter(|of| !others.contains(of)).collect::<Vec<_>>());
            }
            let is_better = best.as_ref().is_none_or(|known| known.others.len() < others.len());
            let passes = || !passes_now || self.redefined_verdict(&own, &text, &formulas).is_some();
            if is_tested && holds && !breaks && is_better && passes() {
                let shared = Some(Shared { of: shown(display), mends: vec![shown(&self.notes.equations[failed])] });
                let repair = Repair { shared, ..Repair::of(edit, display.body.start, Verdict::Verified) };
                best = Some(Culprit { at, repair, others });
            }
        }
        Ok(best)
    }
}

/// The displays whose readings have a derivative of a definition in the place of its name, among them a failed one.
struct WholeUsers<'c, 'a> {
    checker: &'c Checker<'a>,
    defined: &'c DefinedSymbol,
    failed: usize,
    /// The others, and whether each holds as printed.
    others: Vec<(usize, bool)>,
}

/// What another formula for the name makes of them.
struct WithFormula {
    holds: bool,
    breaks: bool,
    others: Vec<String>,
}

impl<'c, 'a> WholeUsers<'c, 'a> {
    /// Those of a definition; `None` where the failed display is none of them.
    fn of(checker: &'c Checker<'a>, defined: &'c DefinedSymbol, failed: usize) -> Result<Option<Self>> {
        if !checker.is_judged_as_a_whole(failed, defined)? {
            return Ok(None);
        }
        let mut users = WholeUsers { checker, defined, failed, others: Vec::new() };
        for at in (0..checker.readings.len()).filter(|at| *at != failed) {
            if checker.is_judged_as_a_whole(at, defined)? {
                let held = users.passes(at, checker.model);
                users.others.push((at, held));
            }
        }
        Ok(Some(users))
    }

    fn passes(&self, at: usize, model: &Model) -> bool {
        let verdicts = self.checker.verdicts_with(at, model).unwrap_or_default();
        !verdicts.is_empty() && verdicts.iter().all(|verdict| verdict.passes())
    }

    fn with(&self, formula: &Expr) -> WithFormula {
        let mut found = WithFormula { holds: false, breaks: false, others: Vec::new() };
        if self.checker.model.depends_on(formula, &[self.defined.symbol]) {
            return found;
        }
        let mut model = self.checker.model.clone();
        model.redefine(self.defined.symbol, formula.clone());
        found.holds = self.passes(self.failed, &model);
        if found.holds {
            for (at, held) in &self.others {
                match (held, self.passes(*at, &model)) {
                    (true, false) => found.breaks = true,
                    (false, true) => found.others.push(shown(&self.checker.notes.equations[*at])),
                    _ => {}
                }
            }
        }
        found
    }
}

/// Whether a term of a sum cancels another one, as in x − x, or a factor stands above and below a bar: nobody writes that.
pub(crate) fn cancels(formula: &Expr, symbols: &Symbols) -> bool {
    let shown = |part: &Expr| text::formula(part, symbols);
    let factors = |part: &Expr| match &part.node {
        Node::Product(factors) => factors.iter().map(shown).collect(),
        _ => vec![shown(part)],
    };
    let mut found = false;
    formula.walk(&mut |part| match &part.node {
        Node::Sum(terms) => {
            let shown: Vec<String> = terms.iter().map(|term| shown(&term.expr)).collect();
            found |= (0..terms.len())
                .any(|at| (0..at).any(|before| terms[before].sign != terms[at].sign && shown[before] == shown[at]));
        }
        Node::Quotient(above, below) => {
            let below = factors(below);
            found |= factors(above).iter().any(|factor| below.contains(factor));
        }
        _ => {}
    });
    found
}

/// Whether an edit corrects what authors often type wrongly.
fn is_slip(edit: &Edit) -> bool {
    is_common(edit.slip) || matches!(edit.slip, Slip::Factor | Slip::Name) && !edit.replacement.trim().is_empty()
}

/// Whether authors make slips of this kind often: a sign, a number, a power; they lose a factor of several letters more rarely.
pub(crate) fn is_common(slip: Slip) -> bool {
    matches!(
        slip,
        Slip::Sign | Slip::Number | Slip::Exponent | Slip::Function | Slip::Fraction | Slip::Symbol | Slip::Index
    )
}
