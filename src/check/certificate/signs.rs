//! Whether a coefficient may vanish, as far as its form shows.

use crate::formula::{Expr, Node, Sign};
use crate::notes::claims::Range;

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::sample::sampler::contains;

/// Whether a constant coefficient is different from 0 in all declared ranges, as far as its form shows.
pub fn is_never_zero(model: &Model, expr: &Expr) -> bool {
    match &expr.node {
        Node::Product(factors) => factors.iter().all(|factor| is_never_zero(model, factor)),
        Node::Quotient(above, below) => is_never_zero(model, above) && is_never_zero(model, below),
        Node::Power(base, _) => is_never_zero(model, base),
        Node::Symbol { id, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => is_never_zero(model, formula),
            Some(Meaning::Constant(_)) => !contains(&model.range(*id), 0.0),
            _ => false,
        },
        _ => is_positive(model, expr),
    }
}

fn is_positive(model: &Model, expr: &Expr) -> bool {
    match &expr.node {
        Node::Number(digits) => digits.parse::<f64>().is_ok_and(|value| value > 0.0),
        Node::Pi | Node::Unit(_) => true,
        Node::Sum(terms) => terms.iter().all(|term| term.sign == Sign::Plus && is_positive(model, &term.expr)),
        Node::SumOver { body, .. } | Node::Root(_, body) => is_positive(model, body),
        Node::Product(factors) => factors.iter().all(|factor| is_positive(model, factor)),
        Node::Quotient(above, below) => is_positive(model, above) && is_positive(model, below),
        Node::Power(base, _) => is_positive(model, base),
        Node::Symbol { id, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => is_positive(model, formula),
            Some(Meaning::Constant(_)) => match model.range(*id) {
                Range::Positive => true,
                Range::Interval { low, low_open, .. } => low > 0.0 || low == 0.0 && low_open,
                Range::Integer { low, .. } => low > 0,
                _ => false,
            },
            _ => false,
        },
        _ => false,
    }
}
