//! Where another case begins: a name that has a formula is given another one.
//!
//! Authors write `U(x) = \frac12 k x^2`, and under the next picture `U(x) = \frac14 k x^4`. The two cannot both hold, and what
//! comes later is about the second. So the letters are inferred anew from there.

use crate::check::model::meaning::Meaning;
use crate::formula::{Expr, Relation, Statement, SymbolId};

use super::Course;
use crate::check::unaided::gate;
use crate::check::unaided::premises::Said;

impl Course<'_, '_> {
    /// Whether a display that does not follow gives a name another formula: of the same letters, or as a function, `U(x)`.
    pub(super) fn begins_another_case(&self, at: usize) -> bool {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return false };
        let Some(id) = statement.members.first().and_then(Expr::as_plain_symbol) else { return false };
        if !equates(statement) || self.checker.readings[at].introduced.iter().any(|new| new.symbol == id) {
            return false;
        }
        match self.checker.model.meaning(id) {
            Some(Meaning::Defined(formula)) if self.seen.contains_key(&id) => {
                let is_same = statement.members.last().is_some_and(|last| self.letters(last) == self.letters(formula));
                is_same || self.is_applied(at, statement) && self.is_used_after(at, id)
            }
            Some(Meaning::Varying(_)) => {
                self.is_applied(at, statement) && self.moves_by_formulas_alone(id) && self.has_formula_before(at, id)
            }
            _ => false,
        }
    }

    /// The letters of a formula, in an order of their own.
    fn letters(&self, formula: &Expr) -> Vec<SymbolId> {
        let mut found = gate::leaves(formula, self.checker.model);
        found.sort_unstable_by_key(|id| id.0);
        found.dedup();
        found
    }

    /// Whether the name on the left side of a statement has its argument: `x(t)`.
    fn is_applied(&self, at: usize, statement: &Statement) -> bool {
        let text = &self.checker.notes.equations[at].text;
        let name = text.get(statement.members[0].span.range()).unwrap_or_default().trim_end();
        name.ends_with(')') || name.ends_with("\\right)}")
    }

    fn is_used_after(&self, at: usize, id: SymbolId) -> bool {
        let later = self.checker.readings[at + 1..].iter().flat_map(|reading| reading.statements.iter().flatten());
        let mut members = later.flat_map(|statement| &statement.members);
        members.any(|member| gate::names(member, self.checker.model).contains(&id))
    }

    /// Whether no relation says how a quantity moves but those that follow from its formulas. Several formulas beside an equation
    /// of motion are solutions of it.
    fn moves_by_formulas_alone(&self, id: SymbolId) -> bool {
        let mut laws = self.known.iter().filter(|premise| premise.said == Said::Whole && self.has_rates(premise.at));
        laws.all(|law| !law.symbols.contains(&id) || !law.from.is_empty())
    }

    /// Whether a display before gives a quantity a formula as a function.
    fn has_formula_before(&self, at: usize, id: SymbolId) -> bool {
        (self.scope.carried..at).any(|before| {
            let [Ok(statement)] = self.checker.readings[before].statements.as_slice() else { return false };
            let is_its = statement.members.first().and_then(Expr::as_plain_symbol) == Some(id);
            is_its && equates(statement) && self.is_applied(before, statement)
        })
    }
}

/// Whether a statement is an equality without conditions.
fn equates(statement: &Statement) -> bool {
    let mut relations = statement.relations.iter();
    statement.conditions.is_empty()
        && statement.members.len() > 1
        && relations.all(|(relation, _)| *relation == Relation::Equal)
}
