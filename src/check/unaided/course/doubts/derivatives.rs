//! Derivatives that were read as 0, since nothing says how what is differentiated depends on the variable.
//!
//! `\partial u/\partial x` is 0 by such a reading where no display gives u a formula, and so is `\partial L/\partial q` where L has
//! a formula in θ. Any equation between such derivatives would hold. A derivative is 0 indeed where the formula contains the variable or
//! its rate, or where the variable is the time or a coordinate of the motion.

use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, SymbolId};
use crate::latex::layout::values::{ends_term, is_d_or_partial, parts_of};
use crate::latex::layout::{Item, Layout, contents, typeset_items};
use crate::latex::names;
use crate::source::Span;

/// A derivative in print.
struct Printed {
    span: Span,
    /// The names in what is differentiated.
    of: Vec<Name>,
    /// The variables.
    by: Vec<Name>,
}

impl Course<'_, '_> {
    /// Whether a derivative that was read as 0 without a reason stands in a display, or in a formula that it uses.
    pub(super) fn rests_on_lost_derivatives(&self, at: usize) -> bool {
        self.with_definitions(at).into_iter().any(|place| self.has_lost_derivative(place))
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
        collect(&items, &mut printed);
        let is_read_as_zero =
            |one: &Printed| zeros.iter().any(|zero| zero.start == one.span.start && zero.end >= one.span.end);
        printed.iter().filter(|one| is_read_as_zero(one)).any(|one| !self.is_zero(one))
    }

    /// Whether a derivative is 0 by the formula of what is differentiated.
    fn is_zero(&self, derivative: &Printed) -> bool {
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

/// The derivatives in items: `\frac{\partial u}{\partial x}`, `\frac{\partial}{\partial x} u`, `\partial_x u`.
fn collect(items: &[Item], found: &mut Vec<Printed>) {
    for (at, item) in items.iter().enumerate() {
        let rest = &items[at + 1..];
        match &item.layout {
            Layout::Fraction(above, below) => {
                let (above, below) = (contents(above), contents(below));
                let is_mark = |items: &[Item]| items.first().is_some_and(|first| is_d_or_partial(nucleus(first)));
                if is_mark(above) && is_mark(below) {
                    let mut by = names_in(below);
                    by.dedup();
                    let operand = solid(&above[1..]);
                    let of = if operand.is_empty() { names_in(next_term(rest)) } else { names_in(&above[1..]) };
                    found.push(Printed { span: item.span, of, by });
                }
            }
            Layout::Scripts { nucleus, sub: Some(sub), .. } if matches!(&nucleus.layout, Layout::Command(name) if name == "\\partial") =>
            {
                found.push(Printed { span: item.span, of: names_in(next_term(rest)), by: names_in(contents(sub)) });
            }
            _ => {}
        }
        parts_of(item).into_iter().for_each(|part| collect(part, found));
    }
}

/// The item without its scripts.
fn nucleus(item: &Item) -> &Item {
    match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    }
}

fn solid(items: &[Item]) -> Vec<&Item> {
    items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect()
}

/// The items up to the end of a term.
fn next_term(items: &[Item]) -> &[Item] {
    &items[..items.iter().position(ends_term).unwrap_or(items.len())]
}

/// The names in items.
fn names_in(items: &[Item]) -> Vec<Name> {
    let mut found = Vec::new();
    for item in items.iter().filter(|item| !is_d_or_partial(nucleus(item))) {
        match names::printed(item, None) {
            Some(printed) => found.push(printed.name),
            None => parts_of(item).into_iter().for_each(|part| found.extend(names_in(part))),
        }
    }
    found
}
