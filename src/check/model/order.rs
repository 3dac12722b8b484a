//! The order of the highest time derivative in a formula.

use crate::formula::{Expr, Node, SymbolId};

use crate::check::model::Model;
use crate::check::model::meaning::{FrameQuantity, Meaning, Quantity};

/// The order of the highest time derivative of a coordinate in a formula.
pub fn derivatives(expr: &Expr, model: &Model) -> usize {
    let inner = expr.children().into_iter().map(|child| derivatives(child, model)).max().unwrap_or(0);
    match &expr.node {
        Node::TimeDerivative(order, _) => inner + usize::from(*order),
        Node::Symbol { id, dots, .. } => {
            let own = match model.meaning(*id) {
                Some(Meaning::System(Quantity::RotationMatrix | Quantity::BodyAxes | Quantity::SpaceAxes)) => 0,
                Some(Meaning::System(_) | Meaning::Frame(FrameQuantity::AngularVelocity)) => 1,
                Some(Meaning::Defined(formula)) => derivatives(formula, model),
                _ => 0,
            };
            own + usize::from(*dots)
        }
        _ => inner,
    }
}

/// The order of the highest derivative of a symbol in a formula, through definitions; `None` if it does not occur.
pub(crate) fn order(model: &Model, expr: &Expr, symbol: SymbolId) -> Option<u8> {
    let inner = expr.children().into_iter().filter_map(|child| order(model, child, symbol)).max();
    match &expr.node {
        Node::TimeDerivative(n, _) => inner.map(|inner| inner + n),
        Node::Symbol { id, dots, .. } if *id == symbol => Some(*dots),
        Node::Symbol { id, dots, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => order(model, formula, symbol).map(|inner| inner + dots),
            _ => None,
        },
        _ => inner,
    }
}
