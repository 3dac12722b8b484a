//! Quantities that are put into a formula: ½ m v² = ½ (2.0 kg) (3.0 m/s)². The two have one shape, and each letter stands for
//! one quantity.

use crate::formula::{Expr, Node, SymbolId};

use super::quantity::{is_power_of_ten, is_unit};

/// The quantities that the letters of a formula have in a formula of numbers; `None`, if it has another shape.
pub(super) fn found(formula: &Expr, numbers: &Expr) -> Option<Vec<(SymbolId, Expr)>> {
    let mut values = Vec::new();
    fits(formula, numbers, &mut values).then_some(values)
}

fn fits(formula: &Expr, numbers: &Expr, values: &mut Vec<(SymbolId, Expr)>) -> bool {
    if let Some(id) = formula.as_plain_symbol() {
        return match values.iter().find(|(known, _)| *known == id) {
            Some((_, value)) => value == numbers,
            None => {
                values.push((id, numbers.clone()));
                true
            }
        };
    }
    if let Node::Product(_) = &formula.node {
        let (letters, quantities) = (factors(formula), factors(numbers));
        return letters.len() == quantities.len()
            && letters.iter().zip(&quantities).all(|(letter, quantity)| fits(letter, quantity, values));
    }
    match (&formula.node, &numbers.node) {
        (Node::Number(a), Node::Number(b)) => a == b,
        (Node::Pi, Node::Pi) | (Node::Euler, Node::Euler) => true,
        (Node::Sum(a), Node::Sum(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.sign == b.sign && fits(&a.expr, &b.expr, values))
        }
        (Node::Quotient(a, b), Node::Quotient(c, d)) | (Node::Power(a, b), Node::Power(c, d)) => {
            fits(a, c, values) && fits(b, d, values)
        }
        (Node::Root(n, a), Node::Root(m, b)) => n == m && fits(a, b, values),
        (Node::Call(f, a), Node::Call(g, b)) => f == g && fits(a, b, values),
        _ => false,
    }
}

/// The factors of a formula, in which a number with its power of ten and its unit is one.
fn factors(expr: &Expr) -> Vec<Expr> {
    let Node::Product(all) = &expr.node else { return vec![expr.clone()] };
    let mut found: Vec<Vec<Expr>> = Vec::new();
    for factor in all {
        let is_letter = factor.as_plain_symbol().is_some();
        let belongs = !is_letter && (is_unit(factor) || is_power_of_ten(factor));
        match found.last_mut() {
            Some(before) if belongs && before.iter().all(|part| part.symbols().is_empty()) => {
                before.push(factor.clone())
            }
            _ => found.push(vec![factor.clone()]),
        }
    }
    let joined = |mut parts: Vec<Expr>| match parts.as_slice() {
        [_] => parts.remove(0),
        [first, .., last] => {
            let span = first.span.to(last.span);
            Expr::new(Node::Product(parts), span)
        }
        [] => expr.clone(),
    };
    found.into_iter().map(joined).collect()
}
