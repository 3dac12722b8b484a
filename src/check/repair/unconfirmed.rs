//! The displays that a wrong equation depends on and that no passing equation tests: the slip may be there.
//!
//! The same is asked within a chain that defines a name and then transforms it.
//!
//! # Where the slip may be if one equation fails
//!
//! It is in the equation or in what it depends on, and truth does not tell which. What else holds does: a law is
//! trusted if a passing equation would fail without it, a definition if each slip in it would be noticed. That
//! something true names it is not enough. What nothing tests is named beside the suggestions, with its most likely
//! edit after the first one of the equation. `--fix` then leaves the file to the author.

use crate::formula::SymbolId;
use crate::latex::DefinedSymbol;
use crate::latex::slips::Slip;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::setup::Run;
use crate::check::model::Model;
use crate::check::repair::shared_edit::{Held, Item, is_refuted};
use crate::check::sample::context::Options;
use crate::check::sample::setting::FEWEST;
use crate::check::trial::wrong::OFFERED;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;

impl Checker<'_> {
    /// The equations of a document, those that no edit mends together with others with the displays that may be wrong
    /// instead, and with the likeliest edit of these beside their own.
    pub(crate) fn with_doubts(
        &self,
        run: &Run<'_>,
        mut equations: Vec<Equation>,
        sentences: &[Equation],
    ) -> Vec<Equation> {
        let displays: Vec<Option<usize>> = equations.iter().map(|equation| self.display_of(equation)).collect();
        let holds = |equation: &Equation| {
            equation.ok && matches!(equation.finding.verdict, Verdict::Certified | Verdict::Verified)
        };
        let holding: Vec<usize> =
            equations.iter().zip(&displays).filter(|(equation, _)| holds(equation)).filter_map(|(_, at)| *at).collect();
        // A definition that is pinned is vouched for; of one that is loose nobody knows.
        let pinned: Vec<Option<bool>> = (0..self.notes.equations.len())
            .map(|display| {
                let is_definition = !self.readings[display].introduced.is_empty();
                let own = equations.iter().zip(&displays).find(|(_, at)| **at == Some(display));
                own.filter(|_| is_definition).map(|(equation, _)| equation.ok)
            })
            .collect();
        let held = self.held(&equations, sentences);
        let mut vouched: Vec<Option<bool>> = vec![None; self.notes.equations.len()];
        for (equation, own) in equations.iter_mut().zip(&displays) {
            if let Some(own) = own.filter(|at| self.is_open(*at) && self.is_damaged(*at)) {
                self.reread(run, equation, own, &held);
            }
            let is_shared = equation.repairs.iter().any(|repair| repair.shared.is_some());
            let is_alone = is_refuted(equation) && equation.finding.follows_from.is_none() && !is_shared;
            let Some(own) = own.filter(|at| is_alone && self.is_open(*at)) else { continue };
            let stands_on = (0..vouched.len()).filter(|at| self.is_open(*at) && self.stands_on(own, *at));
            let (certain, doubtful): (Vec<usize>, Vec<usize>) = stands_on.partition(|at| {
                let vouch = || holding.iter().any(|other| self.vouches_for(*other, *at));
                *vouched[*at].get_or_insert_with(|| pinned[*at].unwrap_or_else(vouch))
            });
            equation.elsewhere = doubtful.iter().map(|at| shown(&self.notes.equations[*at])).collect();
            let is_loose = || !holding.iter().any(|other| self.vouches_for(*other, own));
            if self.defines_in_a_chain(own) && is_loose() {
                equation.elsewhere.push(shown(&self.notes.equations[own]));
            }
            if !self.options.explain {
                continue;
            }
            let found_in = |displays: Vec<usize>| -> Vec<Repair> {
                let found =
                    displays.into_iter().flat_map(|at| self.edits_that_mend(run, at, &[Item::Display(own)], &held));
                found.flat_map(|found| self.shared_repairs(found.at, &found.edit, &found.mended)).collect()
            };
            let from_notes = |repair: &Repair| repair.is_in_the_notes(&self.notes.source.text);
            let has_own = equation.repairs.iter().any(from_notes);
            let mut repairs = found_in(doubtful);
            // The other end of a chain is the definition.
            if repairs.is_empty() && equation.elsewhere.contains(&shown(&self.notes.equations[own])) {
                repairs = self.repairs_of_own_definition(run, own).unwrap_or_default();
            }
            if has_own {
                merge(&mut equation.repairs, repairs);
                continue;
            }
            // What is vouched for may be wrong where the others do not look.
            if repairs.is_empty() {
                repairs = found_in(certain);
            }
            if !repairs.is_empty() {
                equation.parts.iter_mut().for_each(|part| part.finding.fit = None);
                equation.finding.fit = None;
            }
            repairs.append(&mut equation.repairs);
            repairs.truncate(OFFERED);
            equation.repairs = repairs;
        }
        equations
    }

    /// Offers what makes a display readable that introduces names, which are lost with it: the document is read anew.
    fn reread(&self, run: &Run<'_>, equation: &mut Equation, at: usize, held: &Held) {
        if equation.ok || !equation.repairs.is_empty() || !self.options.explain {
            return;
        }
        for found in self.edits_that_mend(run, at, &[Item::Display(at)], held) {
            let repairs = self.shared_repairs(found.at, &found.edit, &found.mended);
            equation.repairs.extend(repairs.into_iter().map(|repair| Repair { shared: None, ..repair }));
        }
        equation.repairs.truncate(OFFERED);
    }

    /// Whether a display says more than once what a name is that it introduces: then it may be wrong on either side.
    fn defines_in_a_chain(&self, at: usize) -> bool {
        let reading = &self.readings[at];
        let statement =
            |new: &DefinedSymbol| reading.statements.get(new.statement).and_then(|statement| statement.as_ref().ok());
        reading.introduced.iter().any(|new| statement(new).is_some_and(|statement| statement.members.len() > 2))
    }

    /// Whether an equation that holds would not, if a display were not what it is.
    fn vouches_for(&self, equation: usize, at: usize) -> bool {
        if equation == at || !self.stands_on(equation, at) {
            return false;
        }
        let introduced: Vec<SymbolId> = self.readings[at].introduced.iter().map(|new| new.symbol).collect();
        let members = || self.readings[equation].statements.iter().flatten().flat_map(|statement| &statement.members);
        if members().any(|member| self.model.depends_on(member, &introduced)) {
            return true;
        }
        let mut model: Model = self.model.clone();
        model.laws.retain(|law| law.printed.iter().all(|(display, _)| *display != at));
        let options = Options { points: FEWEST.min(self.options.points), explain: false, ..self.options };
        let without = Checker { model: &model, options, units: self.units.clone(), ..*self };
        !without.equation(equation, self.assigned[equation]).is_ok_and(|found| found.ok)
    }
}

/// Repairs with those of another place. The likeliest of that comes before what is next here; and first, where here
/// something must be put in or left out, and there a slip of a likelier kind is undone.
fn merge(own: &mut Vec<Repair>, mut others: Vec<Repair>) {
    let is_known = |repair: &Repair| own.iter().any(|o| (o.span, &o.replacement) == (repair.span, &repair.replacement));
    others.retain(|repair| !is_known(repair));
    others.truncate(OFFERED - 1);
    // What was no fraction has no numerator and denominator to exchange.
    let kind = |repair: &Repair| if repair.replacement.starts_with(r"\frac{1}{") { Slip::Factor } else { repair.slip };
    let is_weak = |kind: Slip| matches!(kind, Slip::Factor | Slip::Term);
    let kinds = own.first().map(kind).zip(others.first().map(kind));
    let likelier = kinds.is_some_and(|(own, other)| is_weak(own) && other < own);
    let (at, next) = if likelier { (0, 1) } else { (1, usize::from(own.len() > 1)) };
    others.truncate(OFFERED - at - next);
    own.splice(at..at, others);
    own.truncate(OFFERED);
}
