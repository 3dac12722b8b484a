//! Corrections of a chain that are no evidence of a slip: they break an equality of it that holds, or take the letter of an integral
//! out of the integrand, so that an equality says nothing any more.

use crate::Result;
use crate::check::unaided::course::Course;
use crate::check::unaided::course::special_values::ROUNDING;
use crate::check::verdict::repair::Repair;
use crate::formula::{Expr, Statement};
use crate::latex::read_display;

impl Course<'_, '_> {
    /// Whether a correction of a display, or of an equality of a chain, spoils the chain.
    pub(super) fn spoils_its_chain(&self, at: usize, repair: &Repair) -> bool {
        let (notes, model) = (self.checker.notes, self.checker.model);
        let chain = self.scope.origin_of(at, notes.equations.len());
        let display = &notes.equations[chain];
        if !display.body.contains(repair.span) {
            return false;
        }
        let corrected = self.corrected(chain, repair);
        let hides = |text: &str| self.hides_a_letter_in(text);
        if hides(&corrected) && !hides(&display.text) {
            return true;
        }
        // All of a display that is judged as a whole holds with its correction.
        if chain == at {
            return false;
        }
        let reading = read_display(&corrected, &mut model.symbols.clone(), &model.macros);
        let pairs = |statements: &[Result<Statement, crate::source::Fault>]| -> Vec<[Expr; 2]> {
            let statements = statements.iter().flatten();
            let pairs = statements.flat_map(|statement| statement.members.windows(2));
            pairs.map(|pair| [pair[0].clone(), pair[1].clone()]).collect()
        };
        let (before, after) = (pairs(&self.checker.readings[chain].statements), pairs(&reading.statements));
        // A name that the chain itself defines has the formula that is corrected.
        let defines = |pair: &[Expr; 2]| {
            let name = pair[0].as_plain_symbol();
            name.is_some_and(|id| self.checker.readings[chain].introduced.iter().any(|new| new.symbol == id))
        };
        before.len() != after.len()
            || before
                .iter()
                .zip(&after)
                .any(|(before, after)| !defines(before) && self.are_equal(before) && !self.are_equal(after))
    }

    /// Whether two formulas are equal in all states.
    fn are_equal(&self, [a, b]: &[Expr; 2]) -> bool {
        let ratio = self.constant_ratio(a, b).ok().flatten();
        ratio.is_some_and(|ratio| (ratio - 1.0).abs() < ROUNDING)
    }
}
