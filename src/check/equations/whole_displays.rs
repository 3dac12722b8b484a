//! Displays that test a definition as a whole: with a derivative by a symbol, or as a motion.
//!
//! The links of a plain equation are evaluated with another formula for the name ([`super::uses`]). These displays are judged in
//! another way, or their reading contains the derivative of the definition in place of the name. So they are read and judged
//! again in a model in which the name has the other formula.

use crate::Result;
use crate::formula::{Expr, Node, Statement};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::reread::forms_derivatives;
use crate::check::kinds::definitions::Approximations;
use crate::check::model::Model;
use crate::check::sample::context::Options;
use crate::check::sample::setting::FEWEST;
use crate::check::verdict::Verdict;

impl Checker<'_> {
    /// The displays that are judged as a whole, and that pass.
    pub(crate) fn whole_displays<'s>(&'s self, introduced: &'s DefinedSymbol) -> Result<WholeDisplays<'s>> {
        let mut displays = Vec::new();
        for at in 0..self.readings.len() {
            let claim = self.assigned[at];
            let is_plain = claim.is_none_or(|claim| claim.expect.is_none() && claim.errata.is_empty());
            if !is_plain || self.is_law(at) || !self.is_judged_as_a_whole(at, introduced)? {
                continue;
            }
            if self.verdicts_with(at, self.model)?.iter().all(|verdict| verdict.passes()) {
                displays.push(at);
            }
        }
        Ok(WholeDisplays { checker: self, introduced, displays })
    }

    /// Whether a display without its definitions may depend on a name in a way that its links do not show.
    pub(crate) fn is_judged_as_a_whole(&self, at: usize, introduced: &DefinedSymbol) -> Result<bool> {
        let text = &self.notes.equations[at].text;
        let name = &self.model.symbols.entry(introduced.symbol).name.base;
        if forms_derivatives(text) && text.contains(name.as_str()) {
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
            if claim.secular_for.is_some()
                || self.solution(&link, 0, claim).is_some()
                || self.is_along_the_motion(&link)
            {
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
    pub(crate) fn verdicts_with(&self, at: usize, model: &Model) -> Result<Vec<Verdict>> {
        let none = Claim::default();
        let (display, claim) = (&self.notes.equations[at], self.assigned[at].unwrap_or(&none));
        let mut reading = self.without_definitions(at);
        if forms_derivatives(&display.text) {
            let again = Checker { model, units: None, ..*self }.as_printed(&display.text, claim, &model.macros);
            let before = &self.readings[at];
            let kept = |n: usize| !before.introduced.iter().any(|new| new.statement == n);
            let statements: Vec<_> = again.statements.into_iter().enumerate().filter(|(n, _)| kept(*n)).collect();
            let read = |(_, statement): (usize, Result<Statement, _>)| statement;
            reading.statements = statements.into_iter().map(read).collect();
        }
        let judged = |points: usize| -> Result<Vec<Verdict>> {
            let options = Options { points, explain: false, ..self.options };
            let judge = Checker { model, options, units: None, ..*self };
            let parts = judge.parts((at, display.body.start), &reading, claim, &shown(display))?;
            Ok(parts.into_iter().map(|part| part.finding.verdict).collect())
        };
        let few = judged(FEWEST.min(self.options.points))?;
        // A root may have a value at few of the states.
        match few.contains(&Verdict::Undecided) && !few.contains(&Verdict::Refuted) {
            true => judged(self.options.points),
            false => Ok(few),
        }
    }
}

/// The displays that are judged as a whole and pass.
pub(crate) struct WholeDisplays<'s> {
    checker: &'s Checker<'s>,
    introduced: &'s DefinedSymbol,
    displays: Vec<usize>,
}

impl WholeDisplays<'_> {
    /// Those without the displays of these names, which only repeat the definition. Of several statements one may repeat it, and another
    /// one use it: then the display fails with a multiple of the formula.
    pub(crate) fn without(mut self, names: &[String]) -> Self {
        let double = self.model_with(&twice(&self.introduced.formula));
        let repeats = |at: &usize| {
            names.contains(&format!("({})", shown(&self.checker.notes.equations[*at])))
                && (self.checker.without_definitions(*at).statements.len() < 2
                    || double.as_ref().is_none_or(|model| !self.fails(*at, model)))
        };
        let kept = self.displays.iter().copied().filter(|at| !repeats(at)).collect();
        self.displays = kept;
        self
    }

    /// The model in which the name has another formula; `None` if that contains the name.
    fn model_with(&self, formula: &Expr) -> Option<Model> {
        let mut model = self.checker.model.clone();
        let is_possible = !model.depends_on(formula, &[self.introduced.symbol]);
        is_possible.then(|| model.redefine(self.introduced.symbol, formula.clone()));
        is_possible.then_some(model)
    }

    /// Whether a display fails in a model. A derivative that a formula does not have, a root that has no value, and states that do not exist
    /// are failures too.
    fn fails(&self, at: usize, model: &Model) -> bool {
        !self.checker.verdicts_with(at, model).is_ok_and(|all| all.iter().all(|verdict| verdict.passes()))
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.displays.is_empty()
    }
}

impl Approximations for WholeDisplays<'_> {
    fn holding(&self) -> Result<Vec<String>> {
        Ok(self.displays.iter().map(|at| format!("({})", shown(&self.checker.notes.equations[*at]))).collect())
    }

    fn detect(&self, mutant: &Expr) -> bool {
        self.model_with(mutant).is_none_or(|model| self.displays.iter().any(|at| self.fails(*at, &model)))
    }
}

/// Two times a formula.
fn twice(formula: &Expr) -> Expr {
    Expr::new(Node::Product(vec![Expr::integer(2, formula.span), formula.clone()]), formula.span)
}
