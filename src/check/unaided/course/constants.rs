//! Relations between the constants of a printed solution: `\gamma = b/2m` and `\omega^2 = k/m - \gamma^2` beside
//! x(t) = A e^{−γt} cos(ωt + α).
//!
//! Notes may use γ and ω before they say what these are, so a relation that is taken for granted gives them. A solution is meant
//! with it, whether it is printed before the solution or directly after it.

use crate::Result;
use crate::check::unaided::course::{Course, taken};
use crate::check::unaided::gate;
use crate::check::unaided::premises::{self, Premise, Said, named};
use crate::check::unaided::signs::Positive;
use crate::check::unaided::solutions;
use crate::check::verdict::report::Equation;
use crate::formula::SymbolId;
use crate::notes::claims::Claim;

/// The most relations that give the constants of a solution.
const MOST: usize = 6;

impl Course<'_, '_> {
    /// The relations for the constants of the solution that a display prints; none, if it prints none.
    pub(super) fn relations_of_constants(&self, at: usize, claim: &Claim) -> Vec<Premise> {
        if !solutions::is_printed(self.checker, at, claim) {
            return Vec::new();
        }
        let is_one = |premise: &&Premise| premise.said == Said::Whole && taken::is_static(self.checker, premise.at);
        let mut all: Vec<Premise> =
            self.known.iter().filter(|premise| premise.at < at).filter(is_one).cloned().collect();
        let after = (at + 1..self.checker.notes.equations.len()).take_while(|at| taken::is_static(self.checker, *at));
        all.extend(after.flat_map(|at| self.premises_in(at, &[])).filter(|premise| premise.said == Said::Whole));
        let mut symbols: Vec<SymbolId> = self.symbols(at).unwrap_or_default();
        let mut found: Vec<Premise> = Vec::new();
        // What gives a constant may contain another one that needs a relation.
        while let Some(next) = all.iter().position(|premise| premise.symbols.iter().any(|id| symbols.contains(id))) {
            let premise = all.remove(next);
            symbols.extend(&premise.symbols);
            found.push(premise);
        }
        found.sort_by_key(|premise| premise.at);
        found.truncate(MOST);
        found
    }

    /// The finding that a printed solution holds with the relations for its constants.
    pub(super) fn solution_with(
        &mut self,
        at: usize,
        relations: &[Premise],
        positive: Option<&Positive>,
    ) -> Result<Option<Equation>> {
        let set: Vec<&Premise> = relations.iter().collect();
        if set.is_empty() {
            return Ok(None);
        }
        let found = self.follows_from(at, &set, positive)?;
        if found.is_some() {
            let from: Vec<usize> = set.iter().map(|premise| premise.at).collect();
            self.confirmed.extend(&from);
            self.take_as_premise(at, &from);
        }
        Ok(found.map(gate::as_it_counts))
    }
}

/// The claim with relations that hold throughout.
pub(super) fn added(claim: &Claim, relations: &[Premise]) -> Claim {
    let mut claim = claim.clone();
    claim.throughout.extend(premises::claim(&relations.iter().collect::<Vec<&Premise>>()).throughout);
    claim
}

/// The finding that a solution is wrong, with the relations that were put in.
pub(super) fn given(mut wrong: Equation, relations: &[Premise]) -> Equation {
    if !relations.is_empty() {
        let set: Vec<&Premise> = relations.iter().collect();
        wrong.finding.message = format!("given {}, {}", named(&set), wrong.finding.message);
    }
    wrong
}
