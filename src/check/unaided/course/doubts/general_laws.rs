//! The Euler–Lagrange equation in a general q, which the Lagrangian of one system does not contain: derivatives by q are 0, and no law.

use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::usage::{Usage, names_of};
use crate::formula::{Expr, Node, SymbolId};

impl Course<'_, '_> {
    /// Whether a display differentiates the Lagrangian of the notes by a coordinate that it does not contain: q in the Euler–Lagrange equation.
    pub(super) fn is_general_law(&self, at: usize) -> bool {
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
    pub(super) fn uses_a_general_law(&self, at: usize) -> bool {
        let (checker, model) = (self.checker, self.checker.model);
        let laws = (0..at).filter(|law| !checker.readings[*law].introduced.is_empty() && self.is_general_law(*law));
        let introduced: Vec<SymbolId> =
            laws.flat_map(|law| &checker.readings[law].introduced).map(|new| new.symbol).collect();
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        !introduced.is_empty()
            && members.flat_map(|member| gate::names(member, model)).any(|id| introduced.contains(&id))
    }
}
