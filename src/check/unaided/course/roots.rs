//! Displays that give a name with an index one of the roots of an earlier relation: `s_1 = -\gamma + \dots` after
//! `s^2 + 2\gamma s + \dots = 0`.

use crate::Result;
use crate::check::unaided::course::Course;
use crate::check::unaided::course::sought::SOLVED_WITH_A_SLIP;
use crate::check::unaided::gate;
use crate::check::unaided::premises::Premise;
use crate::check::unaided::prose;
use crate::check::unaided::solutions;
use crate::check::verdict::report::Equation;

impl Course<'_, '_> {
    /// The finding on a display that introduces roots of a relation that was taken for granted, if it does.
    pub(super) fn root(&mut self, at: usize) -> Result<Option<Equation>> {
        let Some(symbols) = self.symbols(at) else { return Ok(None) };
        if solutions::root(&self.checker.readings[at], self.checker.model).is_none() {
            return Ok(None);
        }
        let origin = self.scope.origin_of(at, self.checker.notes.equations.len());
        let words = prose::before(self.checker.notes, origin);
        let before: Vec<Premise> = self.known.iter().filter(|premise| premise.at < origin).cloned().collect();
        let solved = solutions::solved((at, &symbols), &before, self.checker.readings, self.checker.model);
        let solved: Vec<_> = solved.into_iter().filter(|solution| solution.same_symbols).collect();
        for solution in &solved {
            let found = self.equation(&self.quick, at, &solution.claim)?;
            if let Some(found) = gate::as_following(found) {
                return Ok(Some(gate::as_it_counts(solution.found(found))));
            }
        }
        for solution in solved.iter().take(SOLVED_WITH_A_SLIP) {
            if let Some(wrong) = self.slip(at, &solution.claim, &[solution.of], &words)? {
                return Ok(Some(wrong));
            }
        }
        Ok(None)
    }
}
