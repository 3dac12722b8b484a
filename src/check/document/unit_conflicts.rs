//! Dimensional analysis of one statement against the units of the document.

use std::sync::Arc;

use crate::code::Code;
use crate::formula::Statement;
use crate::notes::claims::Claim;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::document::units::{Trust, Units, declared, trust};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

impl<'a> Checker<'a> {
    /// The same checker, with units that are inferred without the `at`-th display.
    pub fn without_units_of(&self, at: usize) -> Checker<'a> {
        let units = self.units.clone().and_then(|units| {
            let known = declared(self.claims, self.model, &|_| true).ok()?;
            let of = |claim: &Option<&Claim>| claim.map_or(Trust::Sound, trust);
            let mut trust: Vec<Trust> = self.assigned.iter().map(of).collect();
            if trust[at] == Trust::Sound {
                trust[at] = Trust::Doubted;
                return Some(Arc::new(Units::new(self.model, &known, self.readings, &trust)));
            }
            Some(units)
        });
        Checker { units, ..*self }
    }
}

impl Checker<'_> {
    /// The finding on the first term of a statement with the wrong unit; such a statement is not evaluated. The text of the
    /// display starts at `offset` of the file.
    pub(crate) fn unit_conflict(
        &self,
        (display, offset): (usize, usize),
        statement: &Statement,
        claim: &Claim,
    ) -> Option<Finding> {
        let units = self.units.as_ref().filter(|_| claim.units_off.is_none())?;
        let mismatch = units.mismatch(statement)?;
        let others = mismatch.origins.iter().filter(|origin| **origin != display);
        let names: Vec<String> = others
            .map(|origin| &self.notes.equations[*origin])
            .map(|other| other.id().map_or_else(|| format!("line {}", other.line), |id| format!("({id})")))
            .collect();
        let message = match names.as_slice() {
            [] => misfit(&mismatch.message),
            names => format!("{}; units inferred from {}", misfit(&mismatch.message), names.join(", ")),
        };
        Some(Finding::new(Code::UnitMismatch, Verdict::Unreadable, mismatch.span.shifted(offset), message))
    }
}

/// The message for a term with the wrong unit.
fn misfit(what: &str) -> String {
    format!("the units do not fit: {what}")
}

impl Checker<'_> {
    /// The message for the first term with the wrong unit in a statement of the claims file.
    pub(crate) fn unit_conflict_of_claim(&self, statement: &Statement) -> Option<String> {
        Some(misfit(&self.units.as_ref()?.mismatch(statement)?.message))
    }

    /// Checks the units of the hypotheses in the claims file, and of the laws that it writes out, except for claims with
    /// `"units": "off"`.
    ///
    /// # Errors
    /// For the first term with the wrong unit, at the place of its LaTeX.
    pub(crate) fn check_units_of_hypotheses(&self) -> Result<()> {
        let claims = self.claims;
        let all = claims.equations.iter().map(|(_, claim)| claim).chain(claims.sentences.iter().map(|s| &s.claim));
        let checked = all.filter(|claim| claim.units_off.is_none());
        let of_claims = checked
            .flat_map(|claim| claim.assume.iter().chain(&claim.throughout).chain(claim.exactly_when.iter().flatten()));
        let named = claims.conditions.iter().flat_map(|(_, all)| all);
        let laws = claims.laws.iter().map(|(_, what)| what).filter(|what| !self.is_printed(what));
        for latex in claims.assume.iter().chain(named).chain(of_claims).chain(laws) {
            // The name of a hypothesis or the number of an equation is no LaTeX of its own.
            let Ok(statements) = self.statements(latex) else { continue };
            if let Some(message) = statements.iter().find_map(|statement| self.unit_conflict_of_claim(statement)) {
                let message = format!("in “{}”: {message}", latex.value);
                return Err(Error::at(&claims.source, latex.span, message).with_code(Code::UnitMismatch));
            }
        }
        Ok(())
    }
}
