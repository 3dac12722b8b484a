//! Displays that hold, or do not, only by a reading that the author may not have meant: energies without a formula are no
//! constants, derivatives of what has no formula are not 0, vectors and matrices are no numbers, and the Euler–Lagrange equation in
//! a general q is not about the Lagrangian of one system, which contains no q.
//!
//! Offers `unclear`, the finding on such a display. Knows the course, and LaTeX.

mod derivatives;
mod differentiated;
mod ended_cases;
mod general_laws;
mod integrals;
mod natural_units;
mod starts;

use crate::check::document::inferred::open_energies::is_energy;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::ordered::Ordered;
use crate::check::usage::names_of;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Kind, Node, SymbolId, text};

impl Course<'_, '_> {
    /// Whether an environment in a display was read as one name: `\begin{array}{ll} … \end{array}` behind a brace.
    pub(super) fn has_unread_rows(&self, at: usize) -> bool {
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let mut names = members.flat_map(Expr::symbols);
        names.any(|(id, _)| self.checker.model.symbols.entry(id).name.base.contains("\\begin{"))
    }

    /// The finding on a display of which the reading may not be what is meant.
    pub(in crate::check::unaided::course) fn unclear(&self, at: usize, found: &Equation) -> Option<Equation> {
        if self.is_general_law(at) {
            let message = "this is a general law for a coordinate that the Lagrangian does not contain, so it was not \
                           checked";
            return Some(gate::settled(found, (Verdict::Definition, Code::Introduced), message.to_owned()));
        }
        if found.finding.verdict == Verdict::Refuted && !self.is_by_itself(at) && self.restores_a_unit(at) {
            return Some(gate::as_it_counts(found.clone()));
        }
        let passes = found.finding.verdict.passes() && found.finding.verdict != Verdict::Definition;
        if (passes || found.finding.verdict == Verdict::Refuted) && self.uses_a_general_law(at) {
            return Some(gate::left_open(found.clone()));
        }
        let passes_in_part = || found.parts.iter().any(|part| is_passed(&part.finding));
        if (passes || passes_in_part()) && self.rests_on_lost_derivatives(at) {
            return Some(gate::left_open(found.clone()));
        }
        if passes && let Some(letter) = self.rests_on_hidden_letters(at) {
            let message =
                format!("nothing says how {letter} depends on the variable of the integral, so this was not decided");
            return Some(gate::settled(found, (Verdict::Undecided, Code::NotDecided), message));
        }
        if passes && self.differentiates_an_open_energy(at) {
            return Some(gate::left_open(found.clone()));
        }
        if passes && self.uses_an_unclear_derivative(at) {
            return Some(gate::left_open(found.clone()));
        }
        let letters = self.taken_for_numbers(at);
        if letters.is_empty() {
            return None;
        }
        if found.finding.verdict == Verdict::Refuted {
            return Some(gate::as_it_counts(found.clone()));
        }
        let message = format!(
            "{} may be vectors or matrices, whose products depend on their order, so this was not decided",
            letters.join(", ")
        );
        passes.then(|| gate::settled(found, (Verdict::Undecided, Code::NotDecided), message))
    }

    /// Whether a derivative was read as 0 that is one of an energy for which no display has a formula.
    fn differentiates_an_open_energy(&self, at: usize) -> bool {
        let (checker, model) = (self.checker, self.checker.model);
        if !self.lost_derivative(at) {
            return false;
        }
        let display = std::slice::from_ref(&checker.notes.equations[at]);
        let is_open = |id: SymbolId| {
            matches!(model.meaning(id), Some(Meaning::Constant(_))) && is_energy(&model.symbols.entry(id).name)
        };
        names_of(display, &model.macros).iter().filter_map(|usage| model.symbols.find(&usage.name)).any(|(id, _)| {
            let name = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, display[0].body);
            gate::names(&name, model).into_iter().any(is_open)
        })
    }

    /// The letters of a display that may be vectors or matrices and were read as numbers, where several of them stand in it.
    fn taken_for_numbers(&self, at: usize) -> Vec<String> {
        let (checker, model) = (self.checker, self.checker.model);
        let has_cross = |at: usize| checker.notes.equations[at].text.contains("\\times");
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let used: Vec<SymbolId> = members.flat_map(|member| gate::names(member, model)).collect();
        let is_of_a_cross = |at: usize| checker.readings[at].introduced.iter().any(|new| used.contains(&new.symbol));
        let is_crossed = has_cross(at) || (0..at).any(|before| has_cross(before) && is_of_a_cross(before));
        let is_number = |letter: &&Ordered| {
            let found = model.symbols.find(&letter.name).map(|(id, _)| id);
            found.is_some_and(|id| used.contains(&id) && model.symbols.entry(id).kind == Kind::Scalar)
                && (is_crossed || !letter.is_vector)
        };
        let letters: Vec<&Ordered> = self.ordered.iter().filter(is_number).collect();
        let shown = letters.iter().map(|letter| text::plain(&letter.name.to_string())).collect();
        if letters.len() > 1 { shown } else { Vec::new() }
    }

    /// Whether a display has letters that are guessed to be matrices. Those of another size, or symmetric ones, obey other
    /// equations, so none is called wrong.
    pub(in crate::check::unaided::course) fn is_about_guessed_matrices(&self, at: usize) -> bool {
        let model = self.checker.model;
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let used: Vec<SymbolId> = members.flat_map(|member| gate::names(member, model)).collect();
        let mut matrices = self.ordered.iter().filter(|letter| !letter.is_vector && letter.range.is_some());
        matrices.any(|letter| model.symbols.find(&letter.name).is_some_and(|(id, _)| used.contains(&id)))
    }
}

/// Whether a finding is that something holds, and no definition.
fn is_passed(finding: &Finding) -> bool {
    finding.verdict.passes() && finding.verdict != Verdict::Definition
}
