//! The values at instants of a hand-in: those of the motion, and those to which a line gives a name.

use crate::formula::SymbolId;
use crate::formula::{Expr, Node};
use crate::latex::{Reading, names};

use crate::check::document::checker::Checker;
use crate::check::mark::motion::Motion;
use crate::check::mark::world::World;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;

/// A value at an instant, by the name that stands for it, with what it is if that is known.
pub(super) type Value = (SymbolId, Option<Expr>);

/// The values at instants, as far as the motion of the problem gives them.
pub(super) fn known(checker: &Checker<'_>, world: &World<'_>, motion: &Motion) -> Vec<Value> {
    let all = world.instants.iter().filter_map(|instant| {
        let (id, _) = checker.model.symbols.find(&names::parse(&instant.name)?.0)?;
        Some((id, motion.value(checker, instant)))
    });
    all.collect()
}

/// Gives the name that stands for a value at an instant, as in `u(0) = U_0`, the meaning that another line gives it, as
/// `U_0 = Q_0/C` does: the value at the instant is then what is defined.
pub(super) fn defined_elsewhere(model: &mut Model, lines: &[Reading], values: &mut Vec<Value>) {
    for (value, known) in values {
        // A value that is given by its own name is not known.
        if known.as_ref().is_some_and(|known| !model.depends_on(known, &[*value])) {
            continue;
        }
        *known = None;
        let is_it = |id: &SymbolId| match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => formula.as_plain_symbol() == Some(*value),
            _ => false,
        };
        let Some(name) = model.symbols.iter().map(|(id, _)| id).find(is_it) else { continue };
        let says = |reading: &Reading| {
            let [Ok(statement)] = reading.statements.as_slice() else { return None };
            let [first, formula, ..] = statement.members.as_slice() else { return None };
            let is_free = !model.depends_on(formula, &[name, *value]);
            let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
            (first.as_plain_symbol() == Some(name) && is_equal && is_free).then(|| formula.clone())
        };
        if let Some(formula) = lines.iter().find_map(says) {
            let span = formula.span;
            model.redefine(name, formula);
            *known = Some(Expr::new(Node::Symbol { id: name, indices: Vec::new(), dots: 0 }, span));
        }
    }
}
