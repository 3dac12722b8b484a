//! The names that a display, or a formula that it uses, differentiates, integrates or takes at an instant.

use crate::check::document::checker::Checker;
use crate::check::document::setup::define_macros;
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::calculus::{derivatives, integrals};
use crate::check::unaided::gate;
use crate::formula::symbols::Name;
use crate::formula::{Expr, SymbolId};
use crate::latex::layout::values::parts_of;
use crate::latex::layout::{Delimiter, Item, Layout, typeset_items};
use crate::latex::{Macros, names};

/// A derivative of a name, an integral over a formula with it, or its value at an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Change {
    /// The name.
    pub of: SymbolId,
    /// The variable; `None` for the time.
    pub by: Option<SymbolId>,
}

/// Whether derivatives or integrals stand in a formula, or it cannot be typeset.
pub(super) fn has_calculus(latex: &str, model: &Model) -> bool {
    let Ok(items) = typeset_items(latex, &model.macros) else { return true };
    let (mut fractions, mut integrands) = (Vec::new(), Vec::new());
    derivatives::collect(&items, &mut fractions);
    integrals::collect(&items, &mut integrands);
    !fractions.is_empty() || !integrands.is_empty()
}

/// The changes in a display, and in the formulas of the names in it.
pub(super) fn changes(checker: &Checker<'_>, at: usize) -> Vec<Change> {
    gate::with_definitions(checker, at).into_iter().flat_map(|place| own(checker, place)).collect()
}

/// The changes that a display prints.
pub(super) fn own(checker: &Checker<'_>, at: usize) -> Vec<Change> {
    let mut found = Vec::new();
    rates(checker, at, &mut found);
    printed(checker, at, &mut found);
    found
}

/// The rates in what was read.
fn rates(checker: &Checker<'_>, at: usize, found: &mut Vec<Change>) {
    let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
    let moving = members.flat_map(Expr::symbols).filter(|(_, dots)| *dots > 0);
    found.extend(moving.map(|(of, _)| Change { of, by: None }));
}

/// The derivatives and integrals in print.
fn printed(checker: &Checker<'_>, at: usize, found: &mut Vec<Change>) {
    let model = checker.model;
    // Derivatives that stand for one name are no derivatives by the macros of the model.
    let mut macros = Macros::default();
    define_macros(&checker.notes.macros, &mut macros);
    let Ok(items) = typeset_items(&checker.notes.equations[at].text, &macros) else { return };
    let id = |name: &Name| model.symbols.find(name).map(|(id, _)| id);
    let by = |name: &Name| match id(name) {
        Some(variable) if matches!(model.meaning(variable), Some(Meaning::Time)) => Some(None),
        None if model.symbols.time.as_ref() == Some(name) => Some(None),
        found => found.map(Some),
    };
    let mut add = |of: &[Name], variable: &Name| {
        let Some(by) = by(variable) else { return };
        found.extend(of.iter().filter_map(id).map(|of| Change { of, by }));
    };
    let (mut fractions, mut integrands) = (Vec::new(), Vec::new());
    derivatives::collect(&items, &mut fractions);
    integrals::collect(&items, &mut integrands);
    for fraction in &fractions {
        fraction.by.iter().for_each(|variable| add(&fraction.of, variable));
    }
    integrands.iter().for_each(|integral| add(&integral.names, &integral.letter));
    let mut instants = Vec::new();
    applied(&items, &mut instants);
    found.extend(instants.iter().filter_map(id).map(|of| Change { of, by: None }));
}

/// The names before a parenthesis with a 0 or a lone name, which may be taken at an instant: `T(0)`, `\dot T(t_1)`.
fn applied(items: &[Item], found: &mut Vec<Name>) {
    for pair in items.windows(2) {
        let Layout::Fence(Delimiter::Round, inside) = &pair[1].layout else { continue };
        let is_instant = |item: &Item| {
            matches!(&item.layout, Layout::Number(digits) if digits == "0") || names::printed(item, None).is_some()
        };
        if let (Some(printed), [only]) = (names::printed(&pair[0], None), inside.as_slice())
            && is_instant(only)
        {
            found.push(printed.name);
        }
    }
    items.iter().flat_map(parts_of).for_each(|part| applied(part, found));
}
