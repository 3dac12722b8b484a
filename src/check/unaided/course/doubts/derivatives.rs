//! Derivatives that were read as 0, since nothing says how what is differentiated depends on the variable.
//!
//! `\partial u/\partial x` is 0 by such a reading where no display gives u a formula, and so is `\partial L/\partial q` where L has
//! a formula in θ. Any equation between such derivatives would hold. A derivative is 0 indeed where the formula contains the variable or
//! its rate, or where the variable is the time or a coordinate of the motion.

use crate::check::model::meaning::Meaning;
use crate::check::unaided::calculus::derivatives::{self, Derivative};
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, SymbolId};
use crate::latex::layout::typeset_items;
use crate::source::Span;

impl Course<'_, '_> {
    /// Whether a derivative that was read as 0 without a reason stands in a display, or in a formula that it uses.
    pub(super) fn rests_on_lost_derivatives(&self, at: usize) -> bool {
        gate::with_definitions(self.checker, at).into_iter().any(|place| self.has_lost_derivative(place))
    }

    fn has_lost_derivative(&self, at: usize) -> bool {
        let (checker, model) = (self.checker, self.checker.model);
        let text = &checker.notes.equations[at].text;
        let mut zeros: Vec<Span> = Vec::new();
        for member in checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members) {
            member.walk(&mut |part| zeros.extend(part.is_null().then_some(part.span)));
        }
        zeros
            .retain(|zero| text.get(zero.range()).is_some_and(|text| text.contains(|c: char| c.is_ascii_alphabetic())));
        if zeros.is_empty() {
            return false;
        }
        let Ok(items) = typeset_items(text, &model.macros) else { return false };
        let mut printed = Vec::new();
        derivatives::collect(&items, &mut printed);
        let is_read_as_zero =
            |one: &Derivative| zeros.iter().any(|zero| zero.start == one.span.start && zero.end >= one.span.end);
        printed.iter().filter(|one| is_read_as_zero(one)).any(|one| !self.is_zero(one))
    }

    /// Whether a derivative is 0 by the formula of what is differentiated.
    fn is_zero(&self, derivative: &Derivative) -> bool {
        let model = self.checker.model;
        let ids = |names: &[Name]| -> Vec<SymbolId> {
            names.iter().filter_map(|name| model.symbols.find(name).map(|(id, _)| id)).collect()
        };
        let (of, by) = (ids(&derivative.of), ids(&derivative.by));
        if derivative.of.is_empty() {
            return true;
        }
        let name = |id: SymbolId| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, derivative.span);
        let contains = |variable: &SymbolId| of.iter().any(|id| gate::names(&name(*id), model).contains(variable));
        let is_function = |id: &SymbolId| {
            let entry = model.symbols.entry(*id);
            entry.coefficient.is_some() || !entry.arguments.is_empty()
        };
        let has_formula = |id: &SymbolId| {
            matches!(model.meaning(*id), Some(Meaning::Defined(_) | Meaning::System(_))) || is_function(id)
        };
        let is_known = of.iter().any(has_formula);
        let runs = |variable: &SymbolId| {
            matches!(model.meaning(*variable), Some(Meaning::Time))
                || model.coordinates.iter().any(|coordinate| coordinate.symbol == *variable)
        };
        let time = model.symbols.time.as_ref();
        let is_by_time = derivative.by.iter().all(|variable| Some(variable) == time);
        is_known && is_by_time
            || !by.is_empty() && by.iter().all(|variable| contains(variable) || is_known && runs(variable))
    }
}
