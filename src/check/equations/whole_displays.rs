//! Displays that test a definition as a whole: with ≈, with a derivative by a symbol, or as a motion.
//!
//! The links of a plain equation are evaluated with another formula for the name ([`super::uses`]). These displays are judged in
//! another way, or their reading contains the derivative of the definition in place of the name. So they are read and judged
//! again in a model in which the name has the other formula.

use crate::Result;
use crate::formula::{Expr, Relation, Statement};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::kinds::definitions::WholeDisplays;
use crate::check::model::Model;
use crate::check::sample::context::Options;
use crate::check::sample::setting::FEWEST;
use crate::check::verdict::Verdict;

impl Checker<'_> {
    /// The displays that are judged as a whole, and that pass.
    pub(crate) fn whole_displays(&self, introduced: &DefinedSymbol) -> Result<Vec<usize>> {
        let mut found = Vec::new();
        for at in 0..self.readings.len() {
            let claim = self.assigned[at];
            let is_plain = claim.is_none_or(|claim| claim.expect.is_none() && claim.errata.is_empty());
            if !is_plain || self.is_law(at) || !self.is_judged_as_a_whole(at, introduced)? {
                continue;
            }
            let same = self.model.clone();
            if self.verdicts_with(at, &same)?.iter().all(|verdict| verdict.passes()) {
                found.push(at);
            }
        }
        Ok(found)
    }

    /// Whether a display without its definitions may depend on a name in a way that its links do not show.
    fn is_judged_as_a_whole(&self, at: usize, introduced: &DefinedSymbol) -> Result<bool> {
        let text = &self.notes.equations[at].text;
        let name = &self.model.symbols.entry(introduced.symbol).name.base;
        if (text.contains("\\partial") || text.contains("\\frac{d")) && text.contains(name.as_str()) {
            return Ok(true);
        }
        let depends = |member: &Expr| self.model.depends_on(member, &[introduced.symbol]);
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        for statement in self.without_definitions(at).statements.iter().flatten() {
            if !statement.members.iter().any(depends) || statement.relations.is_empty() {
                continue;
            }
            let link = self.link(&statement.members[0], statement.relations[0].0, &statement.members[1])?;
            let approximate = statement.relations.iter().any(|(relation, _)| *relation == Relation::Approximately);
            if approximate || self.solution(&link, 0, claim).is_some() || self.is_along_the_motion(&link) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The reading of a display without the statements that define names.
    fn without_definitions(&self, at: usize) -> Reading {
        let reading = &self.readings[at];
        let defines = |n: usize| reading.introduced.iter().any(|new| new.statement == n);
        let kept = reading.statements.iter().enumerate().filter(|(n, _)| !defines(*n));
        Reading { statements: kept.map(|(_, statement)| statement.clone()).collect(), introduced: Vec::new() }
    }

    /// The verdicts on a display in another model, in which it is read again if it contains a derivative.
    fn verdicts_with(&self, at: usize, model: &Model) -> Result<Vec<Verdict>> {
        let none = Claim::default();
        let (display, claim) = (&self.notes.equations[at], self.assigned[at].unwrap_or(&none));
        let mut reading = self.without_definitions(at);
        if display.text.contains("\\partial") || display.text.contains("\\frac{d") {
            let again = Checker { model, units: None, ..*self }.as_printed(&display.text, claim, &model.macros);
            let before = &self.readings[at];
            let kept = |n: usize| !before.introduced.iter().any(|new| new.statement == n);
            let statements: Vec<_> = again.statements.into_iter().enumerate().filter(|(n, _)| kept(*n)).collect();
            let read = |(_, statement): (usize, Result<Statement, _>)| statement;
            reading.statements = statements.into_iter().map(read).collect();
        }
        let options = Options { points: FEWEST.min(self.options.points), explain: false, ..self.options };
        let judge = Checker { model, options, units: None, ..*self };
        let parts = judge.parts((at, display.body.start), &reading, claim, &shown(display))?;
        Ok(parts.into_iter().map(|part| part.finding.verdict).collect())
    }

    /// The tests of a definition by whole displays.
    pub(crate) fn tests_by_whole_displays<'s>(
        &'s self,
        introduced: &'s DefinedSymbol,
        displays: &'s [usize],
    ) -> WholeDisplays<'s> {
        let fails = |at: usize, formula: &Expr| {
            if self.model.depends_on(formula, &[introduced.symbol]) {
                return true;
            }
            let mut model = self.model.clone();
            model.redefine(introduced.symbol, formula.clone());
            // A derivative that the other formula does not have, an ≈ that it does not explain, and a root that has no value
            // are failures too.
            self.verdicts_with(displays[at], &model).is_ok_and(|all| all.iter().any(|verdict| !verdict.passes()))
        };
        let names = displays.iter().map(|at| format!("({})", shown(&self.notes.equations[*at]))).collect();
        WholeDisplays { names, fails: Box::new(fails) }
    }
}
