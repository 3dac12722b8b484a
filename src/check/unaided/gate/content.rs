//! How much an equality says: what is left of it without the terms that both sides have, in symbols and operations.

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::formula::{Expr, Node, Sign, SymbolId, Symbols, text};

/// The fewest symbols, each as often as it stands there, of a correction that is no triviality.
pub(super) const FEWEST_SYMBOLS: usize = 4;

/// Whether an equality says more than that something is equal to itself: what is left of it without the terms that both
/// sides have is no triviality.
pub(super) fn is_content(left: &Expr, right: &Expr, symbols: &Symbols, model: &Model) -> bool {
    let (mut left, mut right) = (terms(left, symbols, model), terms(right, symbols, model));
    left.retain(|(term, _)| match right.iter().position(|(other, _)| other == term) {
        Some(at) => {
            right.remove(at);
            false
        }
        None => true,
    });
    let count: usize = left.iter().chain(&right).map(|(_, count)| count).sum();
    count >= FEWEST_SYMBOLS
}

/// The terms of a formula, with their signs, and the number of symbols in each.
fn terms(formula: &Expr, symbols: &Symbols, model: &Model) -> Vec<(String, usize)> {
    let one = |sign: Sign, term: &Expr| {
        let sign = if sign == Sign::Plus { '+' } else { '-' };
        (format!("{sign}{}", canonical(term, symbols)), occurrences(term, model))
    };
    match &formula.node {
        Node::Sum(terms) => terms.iter().map(|term| one(term.sign, &term.expr)).collect(),
        _ => vec![one(Sign::Plus, formula)],
    }
}

/// The number of symbols and functions in a formula, each as often as it stands there. What a formula defines counts
/// twice, since it stands for that formula, and so does an integral.
pub(super) fn occurrences(formula: &Expr, model: &Model) -> usize {
    let mut count = 0;
    formula.walk(&mut |part| {
        count += match &part.node {
            Node::Symbol { id, .. } if stands_for_a_formula(*id, model) => 2,
            Node::Definite(_) => 2,
            // What is conserved says something of the motion.
            Node::TimeDerivative(..) if model.system.is_some() => 1,
            Node::Symbol { .. } | Node::Letter(_) | Node::Call(..) => 1,
            _ => 0,
        }
    });
    count
}

/// Whether a name has a formula: a defined name, a momentum, or a derivative of what has one.
fn stands_for_a_formula(id: SymbolId, model: &Model) -> bool {
    // An edit may bring in a name that the model does not have.
    let is_known = id.0 < model.symbols.len();
    matches!(model.meaning(id), Some(Meaning::Defined(_)))
        || is_known && model.symbols.entry(id).momentum
        || is_known && super::is_derivative(id, model)
}

/// The number of symbols, functions, roots and fractions in a formula.
pub(super) fn operations(formula: &Expr, model: &Model) -> usize {
    let mut count = occurrences(formula, model);
    formula.walk(&mut |part| {
        let is_symbolic = |inner: &Expr| !inner.symbols().is_empty();
        count += match &part.node {
            Node::Root(..) => 1,
            Node::Quotient(_, below) => usize::from(is_symbolic(below)),
            Node::Power(base, exponent) => {
                usize::from(is_symbolic(base) && matches!(exponent.node, Node::Quotient(..) | Node::Sum(_)))
            }
            _ => 0,
        };
    });
    count
}

/// A formula in which the order of terms and factors does not count.
fn canonical(expr: &Expr, symbols: &Symbols) -> String {
    match &expr.node {
        Node::Sum(terms) => {
            let sign = |sign: Sign| if sign == Sign::Plus { '+' } else { '-' };
            let mut terms: Vec<String> =
                terms.iter().map(|term| format!("{}{}", sign(term.sign), canonical(&term.expr, symbols))).collect();
            terms.sort();
            format!("({})", terms.concat())
        }
        Node::Product(factors) => {
            let mut factors: Vec<String> = factors.iter().map(|factor| canonical(factor, symbols)).collect();
            factors.sort();
            factors.join("·")
        }
        // d/dt of x is ẋ.
        Node::TimeDerivative(order, inner) => match &inner.node {
            Node::Symbol { id, indices, dots } => {
                let node = Node::Symbol { id: *id, indices: indices.clone(), dots: dots + order };
                text::formula(&Expr::new(node, expr.span), symbols)
            }
            _ => text::formula(expr, symbols),
        },
        Node::Dot(a, b) | Node::Cross(a, b) => {
            let mut both = [canonical(a, symbols), canonical(b, symbols)];
            both.sort();
            format!("[{}]", both.join(" "))
        }
        Node::Quotient(a, b) => format!("({})/({})", canonical(a, symbols), canonical(b, symbols)),
        Node::Power(a, b) => format!("({})^({})", canonical(a, symbols), canonical(b, symbols)),
        _ => text::formula(expr, symbols),
    }
}
