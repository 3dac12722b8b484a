//! Conditions that a hand-in states: an initial value, a special state, a number that is given.

use crate::formula::{Expr, Node, Statement, SymbolId};

use crate::check::document::checker::Checker;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;

/// Whether a statement may be a condition: a coordinate, a velocity or a number has a value that nothing here determines.
/// The names in `wanted` are results, and no conditions.
pub(super) fn may_be(checker: &Checker<'_>, statement: &Statement, wanted: &[SymbolId]) -> bool {
    let ([first, second], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
        return false;
    };
    if !is_equality(*relation) {
        return true;
    }
    sets(checker, first, second, wanted) || sets(checker, second, first, wanted)
}

fn sets(checker: &Checker<'_>, name: &Expr, value: &Expr, wanted: &[SymbolId]) -> bool {
    let Node::Symbol { id, dots, .. } = &name.node else { return false };
    let is_free = match checker.model.meaning(*id) {
        Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => *dots <= 1,
        Some(Meaning::Constant(_) | Meaning::Time) => *dots == 0,
        // A quantity that varies may have a value at an instant, as the velocity at the top.
        Some(Meaning::Defined(_) | Meaning::System(_)) => value.symbols().is_empty() && varies(checker, name),
        _ => false,
    };
    let is_constant = |(symbol, dots): &(SymbolId, u8)| {
        *dots == 0 && matches!(checker.model.meaning(*symbol), Some(Meaning::Constant(_)))
    };
    let symbols = value.symbols();
    is_free && !wanted.contains(id) && symbols.len() <= 1 && symbols.iter().all(is_constant)
}

/// Whether a formula changes with time.
fn varies(checker: &Checker<'_>, formula: &Expr) -> bool {
    let moving = checker.model.symbols.iter().map(|(id, _)| id).filter(|id| {
        matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_) | Meaning::Time))
    });
    checker.model.depends_on(formula, &moving.collect::<Vec<_>>())
}
