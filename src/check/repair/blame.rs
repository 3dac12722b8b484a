//! One display called wrong in the place of what follows from it.
//!
//! A slip in the Lagrangian makes most displays fail, and one edit of it makes all of these hold. Then one slip there is far likelier than
//! one in each of them. So the display of the Lagrangian is called wrong, and the others are left open: they follow once it is corrected.
//! The same is done where a display is false itself, and an edit that corrects it corrects others too, and where a definition is
//! contradicted by several displays and no edit of one of these corrects that one.
//!
//! A definition that only wrong displays use is not tested. Where edits of these displays themselves correct them, that is no failure of
//! its own: there is one slip, and it is reported once.

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::printed_lagrangian;
use crate::check::document::setup::Run;
use crate::check::model::meaning::Variable;
use crate::check::model::order::order;
use crate::check::repair::items::SharedEdit;
use crate::check::repair::shared_edit::is_refuted;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Finding, Inherited};
use crate::check::verdict::repair::Repair;
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
    pub(crate) fn blamed(&self, run: &Run<'_>, best: &[SharedEdit], equations: &[Equation]) -> Option<usize> {
        let first = best.first()?;
        let nth = equations.iter().position(|equation| self.display_of(equation) == Some(first.at))?;
        let corrected: Vec<usize> = first.repaired.iter().filter_map(|(item, _)| item.display()).collect();
        let introduced = &self.readings[first.at].introduced;
        let moves = introduced.iter().any(|new| printed_lagrangian::is_part(self.model, new.symbol));
        let is_false = is_refuted(&equations[nth]) && corrected.contains(&first.at) && corrected.len() > 1;
        let is_contradicted = moves && equations[nth].ok && corrected.len() >= BLAMED;
        let is_alone = best.iter().all(|other| other.at == first.at);
        let is_a_definition = || {
            let is_one = equations[nth].ok && !equations[nth].finding.verdict.holds();
            let is_one = is_one || self.is_used_by_wrong_displays_only(&equations[nth]);
            !introduced.is_empty() && !moves && is_one && corrected.len() > 1
        };
        let is_beyond_edits = || corrected.iter().any(|at| !self.has_own_edit(run, *at, equations));
        (is_alone && (is_false || is_contradicted || is_a_definition() && is_beyond_edits())).then_some(nth)
    }

    /// Whether an edit of a display that is wrong corrects it. Where each display that contradicts a definition has one, they may all
    /// have copied the same slip.
    fn has_own_edit(&self, run: &Run<'_>, at: usize, equations: &[Equation]) -> bool {
        let Some(equation) = equations.iter().find(|equation| self.display_of(equation) == Some(at)) else {
            return true;
        };
        self.with_repairs(run, at, equation.clone(), false)
            .map_or(true, |found| found.repairs.iter().any(|repair| self.is_edit_of(at, repair)))
    }

    /// Whether a repair edits a display, and makes no new term.
    fn is_edit_of(&self, at: usize, repair: &Repair) -> bool {
        self.notes.equations[at].body.contains(repair.span) && repair.is_in_the_notes(&self.notes.source.text)
    }

    /// Whether an equation is open only since no passing display uses the names that it defines.
    fn is_used_by_wrong_displays_only(&self, equation: &Equation) -> bool {
        let is_it = |finding: &Finding| finding.code == Code::DefinitionUsersFail;
        let is_meant = match equation.parts.is_empty() {
            true => is_it(&equation.finding),
            false => equation.parts.iter().all(|part| part.ok || is_it(&part.finding)),
        };
        !equation.ok && equation.because.is_none() && is_meant
    }

    /// Whether an equation is wrong and depends on a display.
    fn is_a_wrong_user(&self, equation: &Equation, at: usize) -> bool {
        !equation.ok && self.display_of(equation).is_some_and(|other| other != at && self.depends_on_display(other, at))
    }

    /// The equations, in which a definition is no failure that only wrong displays use, if edits of these displays themselves correct
    /// them.
    pub(crate) fn without_definitions_of_wrong_displays(&self, mut equations: Vec<Equation>) -> Vec<Equation> {
        let corrects_itself = |equation: &Equation| {
            is_refuted(equation)
                && equation.finding.follows_from.is_none()
                && self
                    .display_of(equation)
                    .zip(equation.repairs.first())
                    .is_some_and(|(at, repair)| self.is_edit_of(at, repair))
        };
        let root = |nth: usize| -> Option<String> {
            let equation = &equations[nth];
            let at = self.display_of(equation)?;
            if !self.is_used_by_wrong_displays_only(equation) {
                return None;
            }
            let mut users = equations.iter().filter(|other| self.is_a_wrong_user(other, at));
            let first = users.next().filter(|first| corrects_itself(first))?;
            users.all(corrects_itself).then(|| first.id.clone())
        };
        let roots: Vec<Option<String>> = (0..equations.len()).map(root).collect();
        for (equation, root) in equations.iter_mut().zip(roots) {
            let Some(root) = root else { continue };
            let excuse = |finding: &mut Finding, ok: &mut bool| {
                if !*ok {
                    *ok = true;
                    finding
                        .message
                        .push_str(&format!("; ({root}) will test this definition once ({root}) is corrected"));
                    finding.follows_from = Some(Inherited { from: root.clone(), root: root.clone() });
                }
            };
            excuse(&mut equation.finding, &mut equation.ok);
            equation.parts.iter_mut().for_each(|part| excuse(&mut part.finding, &mut part.ok));
        }
        equations
    }

    /// Calls a display wrong that others contradict, and leaves these open: they follow once it is corrected.
    pub(crate) fn blame(&self, equations: &mut [Equation], nth: usize, corrected: &[usize]) {
        let id = equations[nth].id.clone();
        let names = corrected.iter().map(|at| shown(&self.notes.equations[*at]));
        let names: Vec<String> = names.filter(|name| *name != id).collect();
        let Some((first, others)) = names.split_first() else { return };
        let is_open = self.is_used_by_wrong_displays_only(&equations[nth]);
        let blamed = &mut equations[nth];
        if blamed.ok || is_open {
            let message = match others {
                [] => format!(
                    "({first}) contradicts this; one edit of this display makes ({first}) follow, and no edit of \
                     ({first}) does"
                ),
                [other] => {
                    format!("({first}) and ({other}) contradict this; one edit of this display makes them follow")
                }
                _ => format!(
                    "({first}) and {} other displays contradict this; one edit of this display makes them follow",
                    others.len()
                ),
            };
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
