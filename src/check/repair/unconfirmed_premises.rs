//! Unconfirmed premises: laws and definitions that a wrong equation uses and no passing equation uses.
//!
//! An equation that uses a wrong law or definition is refuted. If another equation that uses the same law or definition
//! passes, the premise is confirmed, and the mistake is in the equation. If none does, the mistake may be in either. The same
//! holds inside a chain that defines a name and then evaluates it.
//!
//! # Where the slip may be if one equation fails
//!
//! It is in the equation or in what it depends on, and truth does not tell which. What else holds does: a law is
//! trusted if a passing equation would fail without it, a definition if each slip in it would be noticed. That
//! something true names it is not enough. What nothing tests is named beside the suggestions, with its most likely
//! edit after the first one of the equation. `--fix` then leaves the file to the author.

use crate::formula::SymbolId;
use crate::latex::DefinedSymbol;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::setup::Run;
use crate::check::model::Model;
use crate::check::repair::items::{Item, Passing};
use crate::check::repair::ranking::insert_ranked;
use crate::check::repair::shared_edit::is_refuted;
use crate::check::sample::context::Options;
use crate::check::sample::setting::FEWEST;
use crate::check::trial::failed_display::OFFERED;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;

impl Checker<'_> {
    /// The equations of a document; those without a shared repair get the displays that may be wrong instead, and the likeliest
    /// edits of these beside their own repairs.
    pub(crate) fn with_unconfirmed_premises(
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
        // A definition that other equations test is confirmed.
        let tested: Vec<Option<bool>> = (0..self.notes.equations.len())
            .map(|display| {
                let is_definition = !self.readings[display].introduced.is_empty();
                let own = equations.iter().zip(&displays).find(|(_, at)| **at == Some(display));
                own.filter(|_| is_definition).map(|(equation, _)| equation.ok)
            })
            .collect();
        let passing = self.items_as_expected(&equations, sentences);
        let mut confirmed: Vec<Option<bool>> = vec![None; self.notes.equations.len()];
        for (equation, own) in equations.iter_mut().zip(&displays) {
            if let Some(own) = own.filter(|at| self.may_be_edited(*at) && self.is_unreadable(*at) && self.is_tried(*at))
            {
                self.reread(run, equation, own, &passing);
            }
            let is_shared = equation.repairs.iter().any(|repair| repair.shared.is_some());
            let is_alone = is_refuted(equation) && equation.finding.follows_from.is_none() && !is_shared;
            let Some(own) = own.filter(|at| is_alone && self.may_be_edited(*at)) else { continue };
            let depends_on_display =
                (0..confirmed.len()).filter(|at| self.may_be_edited(*at) && self.depends_on_display(own, *at));
            let (certain, doubtful): (Vec<usize>, Vec<usize>) = depends_on_display.partition(|at| {
                let is_confirmed = || holding.iter().any(|other| self.confirms(*other, *at));
                *confirmed[*at].get_or_insert_with(|| tested[*at].unwrap_or_else(is_confirmed))
            });
            equation.elsewhere = doubtful.iter().map(|at| shown(&self.notes.equations[*at])).collect();
            let is_unconfirmed = || !holding.iter().any(|other| self.confirms(*other, own));
            if self.defines_in_a_chain(own) && is_unconfirmed() {
                equation.elsewhere.push(shown(&self.notes.equations[own]));
            }
            if !self.options.explain {
                continue;
            }
            let found_in = |displays: Vec<usize>| -> Vec<Repair> {
                let found = displays
                    .into_iter()
                    .flat_map(|at| self.repairing_edits(run, at, (&[Item::Display(own)], 1), &passing));
                found.flat_map(|found| self.shared_repairs(found.at, &found.edit, &found.repaired)).collect()
            };
            let from_notes = |repair: &Repair| repair.is_in_the_notes(&self.notes.source.text);
            let has_own = equation.repairs.iter().any(from_notes);
            let mut repairs = found_in(doubtful);
            // In a chain that defines a name, the definition may be wrong.
            if repairs.is_empty() && equation.elsewhere.contains(&shown(&self.notes.equations[own])) {
                repairs = self.repairs_of_own_definition(run, own).unwrap_or_default();
            }
            if has_own {
                insert_ranked(&mut equation.repairs, repairs);
                continue;
            }
            // A confirmed premise may be wrong in a part that the other equations do not test.
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

    /// Adds repairs of an unreadable display, found by reading the whole document again with its names.
    fn reread(&self, run: &Run<'_>, equation: &mut Equation, at: usize, passing: &Passing) {
        if equation.ok || !equation.repairs.is_empty() || !self.options.explain {
            return;
        }
        for found in self.repairing_edits(run, at, (&[Item::Display(at)], 1), passing) {
            let repairs = self.shared_repairs(found.at, &found.edit, &found.repaired);
            equation.repairs.extend(repairs.into_iter().map(|repair| Repair { shared: None, ..repair }));
        }
        equation.repairs.truncate(OFFERED);
    }

    /// Whether a display equates a name that it introduces with two formulas, so that either may be wrong.
    fn defines_in_a_chain(&self, at: usize) -> bool {
        let reading = &self.readings[at];
        let statement =
            |new: &DefinedSymbol| reading.statements.get(new.statement).and_then(|statement| statement.as_ref().ok());
        reading.introduced.iter().any(|new| statement(new).is_some_and(|statement| statement.members.len() > 2))
    }

    /// Whether a passing equation confirms a display: it uses a name of it, or fails without the law in it.
    fn confirms(&self, equation: usize, at: usize) -> bool {
        if equation == at || !self.depends_on_display(equation, at) {
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
