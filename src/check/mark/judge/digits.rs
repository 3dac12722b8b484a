//! Numbers that are printed with so many digits.

use crate::formula::{Expr, Relation, Statement};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::mark::rounded::{self, Known};
use crate::check::mark::status::Status;

use super::Judge;

impl Judge<'_, '_> {
    /// Whether a reading with ≈ is right to the printed digits, and its equalities hold, alone or under the conditions.
    pub(super) fn is_near(&self, display: usize, reading: &Reading) -> bool {
        let text = &self.quiet.notes.equations[display].text;
        let spanned = |(text, _): &(String, String)| Spanned::new(text.clone(), Span::default());
        let under = Claim { assume: self.conditions.iter().map(spanned).collect(), ..Claim::default() };
        let sets: Vec<_> = [&Claim::default(), &under].into_iter().map(|claim| self.quiet.hypotheses(claim)).collect();
        // Under conditions a number is rounded, though = stands before it.
        let is_approximate = |relation: Relation, pair: &[Expr]| {
            let is_number = !self.conditions.is_empty() && pair[1].symbols().is_empty();
            relation == Relation::Approximately || relation == Relation::Equal && is_number
        };
        let mut any = false;
        let all = reading.statements.iter().all(|statement| {
            let Ok(statement) = statement else { return false };
            statement.members.windows(2).zip(&statement.relations).all(|(pair, relation)| {
                if is_approximate(relation.0, pair) {
                    any = true;
                    let Some(text) = text.get(pair[1].span.range()) else { return false };
                    return sets.iter().flatten().any(|set| rounded::agrees(self.quiet, text, pair, set) == Some(true));
                }
                let alone = Statement { members: pair.to_vec(), relations: vec![*relation], ..statement.clone() };
                let alone = Reading { statements: vec![Ok(alone)], introduced: Vec::new() };
                matches!(self.status(display, &alone).0, Status::Holds(_))
            })
        });
        any && all
    }

    /// Whether a reading is right to the printed digits, with the numbers that the student gave to the quantities.
    pub(super) fn is_rounded(&self, display: usize, reading: &Reading) -> bool {
        let known = self.known_with_the_problem();
        let text = &self.quiet.notes.equations[display].text;
        known.fits(self.quiet, text, reading, |link| matches!(self.status(display, link).0, Status::Holds(_)))
    }

    /// The quantities of which a value is missing, for a line that gives a number where numbers were put in.
    pub(super) fn missing_values(&self, reading: &Reading) -> Vec<String> {
        let missing = self.known_with_the_problem().missing(self.quiet, reading);
        missing.into_iter().map(|id| self.world.in_own_letters(&self.quiet.model.name(id))).collect()
    }

    fn known_with_the_problem(&self) -> Known {
        let mut known = self.known.clone();
        for at in 0..self.world.problem.notes.equations.len() {
            known.add(&self.quiet.readings[at], false);
        }
        known
    }
}
