//! What readings of a hand-in say before they are judged: rates with dots, what the problem leaves open, and conditions that it
//! does not meet.

use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::Reading;

use crate::check::document::checker::Checker;
use crate::check::mark::motion::Motion;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;

/// A reading in which each rate of a name has dots: `\frac{dQ}{dt}` is `\dot Q`.
pub(in crate::check::mark) fn with_dots(mut reading: Reading) -> Reading {
    fn dotted(formula: &mut Expr) {
        formula.children_mut().into_iter().for_each(dotted);
        if let Node::TimeDerivative(order, inner) = &formula.node
            && let Node::Symbol { id, indices, dots } = &inner.node
        {
            formula.node = Node::Symbol { id: *id, indices: indices.clone(), dots: dots.saturating_add(*order) };
        }
    }
    reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members).for_each(dotted);
    reading
}

/// What moves in the problem, and neither a system nor a law nor the printed motion determines.
pub(super) fn free_of(checker: &Checker<'_>, motion: &Motion) -> Vec<SymbolId> {
    let model = checker.model;
    let laws = || model.laws.iter().flat_map(|law| &law.hypotheses).flat_map(|law| [&law.lhs, &law.rhs]);
    let is_free = |id: &SymbolId| {
        matches!(model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)))
            && model.system.is_none()
            && !motion.prints(*id)
            && !laws().any(|side| model.depends_on(side, &[*id]))
    };
    model.symbols.iter().map(|(id, _)| id).filter(is_free).collect()
}

/// The name and the line of a condition that the problem does not meet.
pub(super) type Break = (SymbolId, String);

/// Whether a statement says that a quantity is 0 that the problem determines otherwise: the text may speak of what comes
/// later, as of a string that is slack. The quantity.
pub(super) fn vanishes(checker: &Checker<'_>, statements: &[&Statement]) -> Option<SymbolId> {
    let [statement] = statements else { return None };
    let ([first, second], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
        return None;
    };
    let name = first.as_plain_symbol().filter(|_| is_equality(*relation) && second.is_null())?;
    matches!(checker.model.meaning(name), Some(Meaning::Defined(_))).then_some(name)
}
