//! Functions without a value of their own, written out by those that have one.

use crate::formula::tree::{Expr, Function, Node, Sign, Term};

use super::super::super::layout::Item;
use super::super::items::{area_function, head_word, log_base, reciprocal};

/// A function without a value of its own, written out: coth is 1/tanh, arsinh x is ln(x + √(x² + 1)), and
/// log₁₀ x is ln x/ln 10.
pub(in super::super) fn written_out(head: &Item, call: Expr) -> Expr {
    let span = call.span;
    if let Some(base) = log_base(head) {
        return match call.node {
            Node::Power(inner, exponent) => Expr::new(Node::Power(Box::new(written_out(head, *inner)), exponent), span),
            _ => {
                let of_base = Expr::new(Node::Call(Function::Ln, Box::new(Expr::integer(base, span))), span);
                Expr::new(Node::Quotient(Box::new(call), Box::new(of_base)), span)
            }
        };
    }
    let Some(word) = head_word(head) else { return call };
    let one = || Expr::integer(1, span);
    if matches!(call.node, Node::Call(Function::Tanh | Function::Cosh | Function::Sinh, _) | Node::Power(..))
        && reciprocal(&word).is_some()
    {
        return Expr::new(Node::Quotient(Box::new(one()), Box::new(call)), span);
    }
    let Some(area) = area_function(&word) else { return call };
    match call.node {
        Node::Power(base, exponent) => Expr::new(Node::Power(Box::new(written_out(head, *base)), exponent), span),
        Node::Call(Function::Ln, x) => inverse(area, *x),
        _ => call,
    }
}

/// The inverse of a hyperbolic function.
fn inverse(area: Function, x: Expr) -> Expr {
    let span = x.span;
    let one = || Expr::integer(1, span);
    let new = |node| Expr::new(node, span);
    let plus = |expr: Expr| Term { sign: Sign::Plus, sign_span: None, expr };
    let sum = |a: Expr, b: Expr| new(Node::Sum(vec![plus(a), plus(b)]));
    let square = || new(Node::Power(Box::new(x.clone()), Box::new(Expr::integer(2, span))));
    let of = match area {
        Function::Sinh => sum(x.clone(), new(Node::Root(2, Box::new(sum(square(), one()))))),
        Function::Cosh => sum(x.clone(), new(Node::Root(2, Box::new(square().minus(one()))))),
        _ => new(Node::Quotient(Box::new(sum(one(), x.clone())), Box::new(one().minus(x.clone())))),
    };
    let logarithm = new(Node::Call(Function::Ln, Box::new(of)));
    match area {
        Function::Tanh => new(Node::Quotient(Box::new(logarithm), Box::new(Expr::integer(2, span)))),
        _ => logarithm,
    }
}
