//! What a wrong equation stands on, and nothing that holds does: the slip may be there as well.
//!
//! An equation that follows from a law or a definition is wrong if that is. Where something else holds by the same law, or
//! through the same name, the law is vouched for, and the slip is in the equation; where nothing does, it may be in either.

use crate::formula::SymbolId;

use super::desk::Desk;
use super::document::shown;
use super::identity::{FEWEST, Options};
use super::model::Model;
use super::verdict::{Equation, Verdict};

impl Desk<'_> {
    /// The equations of a document, those that are mended alone with the displays that may be wrong instead.
    pub(super) fn with_doubts(&self, mut equations: Vec<Equation>) -> Vec<Equation> {
        let displays: Vec<Option<usize>> = equations.iter().map(|equation| self.display_of(equation)).collect();
        let holds = |equation: &Equation| {
            equation.ok && matches!(equation.finding.verdict, Verdict::Certified | Verdict::Verified)
        };
        let holding: Vec<usize> =
            equations.iter().zip(&displays).filter(|(equation, _)| holds(equation)).filter_map(|(_, at)| *at).collect();
        let mut vouched: Vec<Option<bool>> = vec![None; self.notes.equations.len()];
        for (equation, own) in equations.iter_mut().zip(&displays) {
            let (Some(own), false) = (*own, equation.repairs.iter().all(|repair| repair.shared.is_some())) else {
                continue;
            };
            for at in (0..vouched.len()).filter(|at| self.is_open(*at) && self.stands_on(own, *at)) {
                let is_vouched =
                    *vouched[at].get_or_insert_with(|| holding.iter().any(|other| self.vouches_for(*other, at)));
                if !is_vouched {
                    equation.elsewhere.push(shown(&self.notes.equations[at]));
                }
            }
        }
        equations
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
        let without = Desk { model: &model, options, units: self.units.clone(), ..*self };
        !without.equation(equation, self.assigned[equation]).is_ok_and(|found| found.ok)
    }
}
