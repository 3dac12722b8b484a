//! Displays that hold, or do not, only by a reading that the author may not have meant: energies without a formula are no
//! constants, vectors and matrices are no numbers, and the Euler–Lagrange equation in a general q is not about the Lagrangian of
//! one system, which contains no q.

use crate::check::document::inferred::open_energies::is_energy;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::ordered::Ordered;
use crate::check::usage::{Usage, names_of};
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Kind, Node, SymbolId, text};

impl Course<'_, '_> {
    /// The finding on a display of which the reading may not be what is meant.
    pub(super) fn unclear(&self, at: usize, found: &Equation) -> Option<Equation> {
        if self.is_general_law(at) {
            let message = "a general law in a coordinate that the Lagrangian does not contain, so it was not checked";
            return Some(gate::settled(found, (Verdict::Definition, Code::Introduced), message.to_owned()));
        }
        let passes = found.finding.verdict.passes() && found.finding.verdict != Verdict::Definition;
        if (passes || found.finding.verdict == Verdict::Refuted) && self.uses_a_general_law(at) {
            return Some(gate::left_open(found.clone()));
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

    /// Whether a display differentiates the Lagrangian of the notes by a coordinate that it does not contain: q in the Euler–Lagrange equation.
    fn is_general_law(&self, at: usize) -> bool {
        let (model, display) = (self.checker.model, &self.checker.notes.equations[at]);
        let Some(printed) = &model.printed_lagrangian else { return false };
        if !display.text.contains("\\partial") && !display.text.contains("\\pdv") {
            return false;
        }
        let contains = |id: SymbolId| {
            let lagrangian = model.symbols.find(&printed.lagrangian).map(|(id, _)| id);
            let node = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, display.body);
            lagrangian.is_some_and(|lagrangian| model.depends_on(&node(lagrangian), &[id]))
        };
        let is_known = |id: SymbolId| {
            model.coordinates.iter().any(|coordinate| coordinate.symbol == id)
                || matches!(model.meaning(id), Some(Meaning::Time | Meaning::Defined(_) | Meaning::System(_)))
                || contains(id)
        };
        let usages = names_of(std::slice::from_ref(display), &model.macros);
        let is_absent = |usage: &Usage| {
            let is_time = model.symbols.time.as_ref() == Some(&usage.name);
            !is_time && model.symbols.find(&usage.name).is_none_or(|(id, _)| !is_known(id))
        };
        usages.iter().any(|usage| usage.name == printed.lagrangian)
            && usages.iter().any(|usage| usage.differentiates && is_absent(usage))
    }

    /// Whether a display uses a name that a general law before it gives a formula, `p = \partial L/\partial\dot q`, which was read as 0.
    fn uses_a_general_law(&self, at: usize) -> bool {
        let (checker, model) = (self.checker, self.checker.model);
        let laws = (0..at).filter(|law| !checker.readings[*law].introduced.is_empty() && self.is_general_law(*law));
        let introduced: Vec<SymbolId> =
            laws.flat_map(|law| &checker.readings[law].introduced).map(|new| new.symbol).collect();
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        !introduced.is_empty()
            && members.flat_map(|member| gate::names(member, model)).any(|id| introduced.contains(&id))
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
    pub(super) fn is_about_guessed_matrices(&self, at: usize) -> bool {
        let model = self.checker.model;
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let used: Vec<SymbolId> = members.flat_map(|member| gate::names(member, model)).collect();
        let mut matrices = self.ordered.iter().filter(|letter| !letter.is_vector && letter.range.is_some());
        matrices.any(|letter| model.symbols.find(&letter.name).is_some_and(|(id, _)| used.contains(&id)))
    }
}
