//! A formula in units of the SI: each unit becomes its size.

use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::source::Span;

use super::Unit;

/// Replaces each unit by its size in base units. The result is right for a formula whose terms have one dimension.
pub fn in_si(formula: &mut Expr) {
    formula.substitute(&|node| match node {
        Node::Unit(unit) => Some(size(*unit)),
        _ => None,
    });
}

/// Whether a formula has units in it.
pub fn has_units(formula: &Expr) -> bool {
    let mut found = false;
    formula.walk(&mut |part| found |= matches!(part.node, Node::Unit(_)));
    found
}

fn size(unit: Unit) -> Expr {
    let expr = |node: Node| Expr::new(node, Span::default());
    let number = |digits: &str| expr(Node::Number(digits.to_owned()));
    let (digits, ten) = unit.size();
    let mut factors = vec![number(digits)];
    if ten != 0 {
        let exponent = number(&ten.unsigned_abs().to_string());
        let sign = if ten < 0 { Sign::Minus } else { Sign::Plus };
        let exponent = expr(Node::Sum(vec![Term { sign, sign_span: None, expr: exponent }]));
        factors.push(expr(Node::Power(Box::new(number("10")), Box::new(exponent))));
    }
    if unit.is_degree() {
        factors.push(expr(Node::Quotient(Box::new(expr(Node::Pi)), Box::new(number("180")))));
    }
    expr(Node::Product(factors))
}
