//! Products under derivatives, `\frac{d}{dr}(r^2 q)`, in which a name may vary of which the notes do not say so.
//!
//! Such a name is read as a constant. What is an identity with it may be meant so; as a premise it would be another equation.

use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::symbols::Name;
use crate::formula::{Expr, SymbolId, text};
use crate::latex::layout::values::is_d_or_partial;
use crate::latex::layout::{Item, Layout, contents, typeset_items};
use crate::latex::names;

impl Course<'_, '_> {
    /// The finding on a display that does not follow and has such a product.
    pub(in crate::check::unaided::course) fn with_unclear_derivative(
        &self,
        at: usize,
        found: &Equation,
    ) -> Option<Equation> {
        let name = self.under_a_derivative(at).into_iter().next()?;
        let message = format!("nothing says whether {name} varies under the derivative, so this was not decided");
        Some(gate::settled(found, (Verdict::Undecided, Code::NotDecided), message))
    }

    /// Whether a display uses a name whose formula has such a product.
    pub(super) fn uses_an_unclear_derivative(&self, at: usize) -> bool {
        let (checker, model) = (self.checker, self.checker.model);
        let unclear = (0..at).filter(|before| {
            !checker.readings[*before].introduced.is_empty() && !self.under_a_derivative(*before).is_empty()
        });
        let names: Vec<SymbolId> =
            unclear.flat_map(|before| &checker.readings[before].introduced).map(|new| new.symbol).collect();
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        !names.is_empty() && members.flat_map(|member: &Expr| gate::names(member, model)).any(|id| names.contains(&id))
    }

    /// The names beside the variable in what a display differentiates for which no display has a formula.
    fn under_a_derivative(&self, at: usize) -> Vec<String> {
        let model = self.checker.model;
        let display = &self.checker.notes.equations[at];
        if !display.text.contains("\\frac") {
            return Vec::new();
        }
        let Ok(items) = typeset_items(&display.text, &model.macros) else { return Vec::new() };
        let is_unknown = |name: &&Name| {
            let id = model.symbols.find(name).map(|(id, _)| id);
            id.is_some_and(|id| matches!(model.meaning(id), Some(Meaning::Constant(_))))
        };
        let mut products = Vec::new();
        collect(&items, &mut products);
        // By the time everything is differentiated that varies.
        products.retain(|(variable, names)| model.symbols.time.as_ref() != Some(variable) && names.contains(variable));
        let unknown = products.iter().filter_map(|(variable, names)| {
            names.iter().filter(|name| *name != variable).find(is_unknown).map(|name| text::plain(&name.to_string()))
        });
        unknown.collect()
    }
}

/// The variable of each derivative of a product, with the names of its factors.
fn collect(items: &[Item], found: &mut Vec<(Name, Vec<Name>)>) {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    for (at, item) in solid.iter().enumerate() {
        if let Layout::Fraction(above, below) = &item.layout
            && let Some(variable) = variable(contents(below))
        {
            let mut names = Vec::new();
            match contents(above) {
                [d] if is_d_or_partial(d) => {
                    let factor = solid.get(at + 1).filter(|next| matches!(next.layout, Layout::Fence(..)));
                    factor.into_iter().for_each(|fence| factors(inside(fence), &mut names));
                }
                [d, Item { layout: Layout::Fence(_, inside), .. }] if is_d_or_partial(d) => factors(inside, &mut names),
                _ => {}
            }
            if !names.is_empty() {
                found.push((variable, names));
            }
        }
        match &item.layout {
            Layout::Fraction(a, b) => [a, b].into_iter().for_each(|side| collect(contents(side), found)),
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| collect(cell, found)),
            _ => collect(inside(item), found),
        }
    }
}

/// The names in a formula, but not those in fractions of differentials.
fn factors(items: &[Item], names: &mut Vec<Name>) {
    for item in items {
        if let Some(printed) = names::printed(item, None) {
            names.push(printed.name);
            continue;
        }
        match &item.layout {
            Layout::Fraction(above, below) if variable(contents(below)).is_none() => {
                [above, below].into_iter().for_each(|side| factors(contents(side), names));
            }
            Layout::Fraction(..) => {}
            _ => factors(inside(item), names),
        }
    }
}

/// The x of `dx` and of `\partial x`.
fn variable(below: &[Item]) -> Option<Name> {
    let [d, rest @ ..] = below else { return None };
    let [only] = rest else { return None };
    is_d_or_partial(d).then(|| names::printed(only, None).map(|found| found.name))?
}

/// The items one level inside an item.
fn inside(item: &Item) -> &[Item] {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => items,
        Layout::Scripts { nucleus, .. } | Layout::Root(_, nucleus) => std::slice::from_ref(nucleus),
        Layout::Accent(_, inner) | Layout::Style(_, inner) => std::slice::from_ref(inner),
        _ => &[],
    }
}
