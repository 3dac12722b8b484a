//! One display called wrong in the place of what follows from it.
//!
//! A slip in the Lagrangian makes most displays fail, and one edit of it makes all of these hold. Then one slip there is far likelier than
//! one in each of them. So the display of the Lagrangian is called wrong, and the others are left open: they follow once it is corrected.
//! The same is done where a display is false itself, and an edit that corrects it corrects others too.

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::printed_lagrangian;
use crate::check::model::meaning::Variable;
use crate::check::model::order::order;
use crate::check::repair::items::SharedEdit;
use crate::check::repair::shared_edit::is_refuted;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Finding, Inherited};
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::Expr;
use crate::latex::name_search;

/// The least number of displays that call the Lagrangian wrong, where one edit of it corrects all of them. Of fewer, each may be wrong
/// by itself.
const BLAMED: usize = 4;

impl Checker<'_> {
    /// The number of equations that hold and contain an acceleration: they would fail with most edits of the Lagrangian. One that
    /// is made of its derivatives holds for any.
    pub(crate) fn confirmations_of_the_motion(&self, equations: &[Equation]) -> usize {
        let model = self.model;
        let lagrangian = model.printed_lagrangian.as_ref().map(|printed| printed.lagrangian.to_string());
        let has_acceleration = |member: &Expr| {
            let highest = |coordinate: &Variable| order(model, member, coordinate.symbol).unwrap_or(0);
            model.coordinates.iter().any(|coordinate| highest(coordinate) > 1)
        };
        let confirms = |at: usize| {
            let text = &self.notes.equations[at].text;
            let is_of_it = lagrangian.as_ref().is_some_and(|name| name_search::mentions(text, name, &model.macros));
            let mut members = self.readings[at].statements.iter().flatten().flat_map(|s| &s.members);
            !is_of_it && self.readings[at].introduced.is_empty() && members.any(has_acceleration)
        };
        let holding = equations.iter().filter(|equation| equation.finding.verdict.holds());
        holding.filter_map(|equation| self.display_of(equation)).filter(|at| confirms(*at)).count()
    }

    /// The place in the report of the one display of which edits correct several displays, where it is wrong and these are not: it is
    /// false itself, or it is a part of the Lagrangian and many displays contradict it.
    pub(crate) fn blamed(&self, best: &[SharedEdit], equations: &[Equation]) -> Option<usize> {
        let first = best.first()?;
        let nth = equations.iter().position(|equation| self.display_of(equation) == Some(first.at))?;
        let corrected: Vec<usize> = first.repaired.iter().filter_map(|(item, _)| item.display()).collect();
        let introduced = &self.readings[first.at].introduced;
        let moves = introduced.iter().any(|new| printed_lagrangian::is_part(self.model, new.symbol));
        let is_false = is_refuted(&equations[nth]) && corrected.contains(&first.at) && corrected.len() > 1;
        let is_contradicted = moves && equations[nth].ok && corrected.len() >= BLAMED;
        let is_alone = best.iter().all(|other| other.at == first.at);
        ((is_false || is_contradicted) && is_alone).then_some(nth)
    }

    /// Calls a display wrong that others contradict, and leaves these open: they follow once it is corrected.
    pub(crate) fn blame(&self, equations: &mut [Equation], nth: usize, corrected: &[usize]) {
        let id = equations[nth].id.clone();
        let names = corrected.iter().map(|at| shown(&self.notes.equations[*at]));
        let names: Vec<String> = names.filter(|name| *name != id).collect();
        let Some((first, others)) = names.split_first() else { return };
        let blamed = &mut equations[nth];
        if blamed.ok {
            let count = others.len();
            let message =
                format!("({first}) and {count} other displays contradict this, and one edit of it corrects that");
            let span = blamed.finding.span;
            blamed.finding = Finding::new(Code::DefinitionContradicted, Verdict::Refuted, span, message);
            (blamed.ok, blamed.parts) = (false, Vec::new());
        }
        for equation in equations.iter_mut().filter(|equation| names.contains(&equation.id)) {
            let message = format!("this follows once ({id}) is corrected");
            let follows_from = Some(Inherited { from: id.clone(), root: id.clone() });
            let open = Finding::new(Code::NotDecided, Verdict::Undecided, equation.finding.span, message);
            (equation.finding, equation.parts) = (Finding { follows_from, ..open }, Vec::new());
        }
    }
}
