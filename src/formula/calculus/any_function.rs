//! Functions without a formula: a polynomial with free coefficients stands for each, at any arguments.
//!
//! Such a polynomial has as many independent values as it has coefficients. At more places it obeys equations that other functions
//! do not: the difference of an order above its degree vanishes. So the polynomial is written in one form only, by which
//! its places and the order of its derivatives are found again in any formula. A derivative keeps the form, and there is none of
//! the order of the degree or above.

use crate::formula::SymbolId;
use crate::formula::symbols::{AnyFunction, Symbols};
use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::source::Span;

/// The value of a function without a formula, or of a derivative of it.
#[derive(Clone, Debug)]
pub struct Value<'a> {
    /// The function.
    pub function: &'a AnyFunction,
    /// The order of the derivative by each argument.
    pub orders: Vec<u32>,
    /// The arguments.
    pub arguments: Vec<Expr>,
}

/// The derivative of these orders of the function, at these arguments.
pub fn at(function: &AnyFunction, orders: &[u32], arguments: &[Expr], span: Span) -> Expr {
    let kept = function.terms.iter().filter_map(|(coefficient, powers)| {
        let left: Option<Vec<u32>> =
            powers.iter().zip(orders).map(|(power, order)| power.checked_sub(*order)).collect();
        let expr = monomial(*coefficient, arguments, &left?, span);
        Some(Term { sign: Sign::Plus, sign_span: None, expr })
    });
    Expr::new(Node::Sum(kept.collect()), span)
}

/// The function of which a formula is a value, if it is one. A derivative of the highest order is none: its place is lost.
pub fn value_of<'a>(expr: &Expr, symbols: &'a Symbols) -> Option<Value<'a>> {
    let Node::Sum(terms) = &expr.node else { return None };
    let first = terms.first()?.expr.as_plain_symbol()?;
    let function = symbols.entry(first).coefficient.as_deref()?;
    let orders = function.terms.iter().find(|(id, _)| *id == first)?.1.clone();
    let arguments = {
        let argument = |place: usize| {
            let mut powers = orders.clone();
            powers[place] += 1;
            let wanted = function.terms.iter().find(|(_, own)| *own == powers)?.0;
            terms.iter().find_map(|term| match &term.expr.node {
                Node::Product(factors) => match factors.as_slice() {
                    [coefficient, argument] if coefficient.as_plain_symbol() == Some(wanted) => Some(argument.clone()),
                    _ => None,
                },
                _ => None,
            })
        };
        (0..orders.len()).map(argument).collect::<Option<Vec<Expr>>>()?
    };
    (at(function, &orders, &arguments, expr.span) == *expr).then_some(Value { function, orders, arguments })
}

/// `c x^a y^b / (a! b!)`, so that the terms are of like size.
fn monomial(coefficient: SymbolId, arguments: &[Expr], powers: &[u32], span: Span) -> Expr {
    let node = |node: Node| Expr::new(node, span);
    let number = |value: u32| Expr::integer(value, span);
    let mut factors = vec![node(Node::Symbol { id: coefficient, indices: Vec::new(), dots: 0 })];
    let mut below = 1;
    for (base, power) in arguments.iter().zip(powers) {
        match power {
            0 => {}
            1 => factors.push(base.clone()),
            _ => factors.push(node(Node::Power(Box::new(base.clone()), Box::new(number(*power))))),
        }
        below *= (1..=*power).product::<u32>();
    }
    let above = match factors.len() {
        1 => factors.swap_remove(0),
        _ => node(Node::Product(factors)),
    };
    match below {
        1 => above,
        _ => node(Node::Quotient(Box::new(above), Box::new(number(below)))),
    }
}
