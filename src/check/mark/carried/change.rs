//! Follow-through of a false result to its change: `W = E(2r) - E(r)` with a false E, where the problem's own W is the change of
//! its own E.

use crate::formula::calculus::places::at;
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::latex::Reading;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::motion::written_out;
use crate::check::model::meaning::Meaning;

use super::numbers;

/// The multiples of a constant at which the other value may be.
const MULTIPLES: [(u32, u32); 5] = [(2, 1), (1, 2), (3, 1), (1, 3), (4, 1)];

/// The most constants of the problem that may be the other value.
const OTHERS: usize = 6;

/// Whether a line says of the false formula of a result how it changes, where the result of the problem that the line is about is
/// this change.
pub(super) fn follows(checker: &Checker<'_>, from: usize, own: &Reading) -> bool {
    let ends = |reading: &Reading| -> Option<(SymbolId, Expr)> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let name = statement.members.first()?.as_plain_symbol()?;
        matches!(checker.model.meaning(name), Some(Meaning::Defined(_)))
            .then(|| Some((name, written_out(checker, statement.members.last()?.clone()))))?
    };
    let (Some((result, false_one)), Some((other, printed))) = (ends(&checker.readings[from]), ends(own)) else {
        return false;
    };
    if result == other {
        return false;
    }
    let [true_one, true_change] = [result, other].map(|id| written_out(checker, symbol(id)));
    let is_constant = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Constant(_)));
    let constants: Vec<SymbolId> = true_one.symbols().into_iter().map(|(id, _)| id).filter(is_constant).collect();
    let all: Vec<SymbolId> = checker.model.symbols.iter().map(|(id, _)| id).filter(is_constant).collect();
    let holds = |left: &Expr, right: &Expr| {
        let link = checker.link(left, Relation::Equal, right);
        link.is_ok_and(|link| numbers::holds(checker, checker.model, &link, &[]) == Some(true))
    };
    constants.into_iter().any(|id| {
        let multiples = MULTIPLES.iter().map(|(a, b)| multiple(id, *a, *b));
        let others = all.iter().filter(|other| **other != id && !true_one.symbols().contains(&(**other, 0)));
        let values = multiples.chain(others.take(OTHERS).map(|other| symbol(*other)));
        values.into_iter().any(|value| {
            let is_known = |rate: &(SymbolId, u8)| true_one.symbols().contains(rate) || value.symbols().contains(rate);
            if !true_change.symbols().iter().all(is_known) {
                return false;
            }
            let change = |of: &Expr| at(of, id, &value).minus(of.clone());
            let is_change = holds(&true_change, &change(&true_one));
            is_change && holds(&printed, &change(&false_one))
                || !is_change
                    && holds(&true_change, &change(&true_one).negated())
                    && holds(&printed, &change(&false_one).negated())
        })
    })
}

fn symbol(id: SymbolId) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default())
}

fn multiple(id: SymbolId, above: u32, below: u32) -> Expr {
    let number = |value| Expr::integer(value, Span::default());
    let product = Expr::new(Node::Product(vec![number(above), symbol(id)]), Span::default());
    match below {
        1 => product,
        _ => Expr::new(Node::Quotient(Box::new(product), Box::new(number(below))), Span::default()),
    }
}
