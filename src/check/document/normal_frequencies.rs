//! Normal frequencies: names for the ω with det(K − ω²M) = 0, where K and M are the second derivatives of −L and of L by the
//! coordinates and by the velocities, with all coordinates at 0 and at rest.
//!
//! The condition is a hypothesis on shell, so what is printed of ω must hold for each root.

use crate::formula::derivative::{self, Scope};
use crate::formula::tree::{MatrixFunction, Variable};
use crate::formula::{Expr, Node, Relation, SymbolId, text};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};

/// The conditions that the normal frequencies of the document obey.
///
/// # Errors
/// Where the Lagrangian has no such derivatives as formulas, or couples coordinates to velocities.
pub(crate) fn conditions(model: &Model, lagrangian: SymbolId) -> Result<Vec<Hypothesis>> {
    let Some(first) = model.normal_frequencies.first() else { return Ok(Vec::new()) };
    let name = text::plain(&model.name(*first));
    let unsupported = |what: &str| Error::new(format!("{name} is no normal frequency: {what}"));
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    let second = |a: (SymbolId, u8), b: (SymbolId, u8)| at_rest(model, lagrangian, [a, b], &coordinates);
    let mut conditions = Vec::new();
    for omega in &model.normal_frequencies {
        let mut rows = Vec::new();
        for a in &coordinates {
            let mut row = Vec::new();
            for b in &coordinates {
                let no_derivative = || unsupported("the Lagrangian has no second derivatives as formulas");
                let stiffness = second((*a, 0), (*b, 0)).ok_or_else(no_derivative)?.negated();
                let mass = second((*a, 1), (*b, 1)).ok_or_else(no_derivative)?;
                if !second((*a, 0), (*b, 1)).ok_or_else(no_derivative)?.is_zero() {
                    return Err(unsupported("the Lagrangian couples coordinates to velocities"));
                }
                let omega = symbol(*omega, 0);
                let square = node(Node::Power(Box::new(omega), Box::new(number(2))));
                row.push(stiffness.minus(node(Node::Product(vec![square, mass]))));
            }
            rows.push(row);
        }
        let lhs = match rows.as_mut_slice() {
            [row] => row.remove(0),
            _ => node(Node::OfMatrix(MatrixFunction::Determinant, Box::new(node(Node::Matrix(rows))))),
        };
        let link = Link { lhs, relation: Relation::Equal, rhs: number(0), free: Vec::new() };
        conditions.push(Hypothesis::of(link, false));
    }
    Ok(conditions)
}

/// A second derivative of the Lagrangian where all coordinates and velocities are 0.
fn at_rest(model: &Model, of: SymbolId, by: [(SymbolId, u8); 2], coordinates: &[SymbolId]) -> Option<Expr> {
    let scope = Scope { symbols: &model.symbols, fixed: &[] };
    let mut formula = symbol(of, 0);
    for (id, dots) in by {
        let by = Variable { id, indices: Vec::new(), dots };
        formula = derivative::partial(&formula, &by, scope, Span::default()).ok()?;
    }
    formula.substitute(&|part| match part {
        Node::Symbol { id, .. } if coordinates.contains(id) => Some(number(0)),
        _ => None,
    });
    Some(formula)
}

fn node(node: Node) -> Expr {
    Expr::new(node, Span::default())
}

fn number(value: u32) -> Expr {
    Expr::integer(value, Span::default())
}

fn symbol(id: SymbolId, dots: u8) -> Expr {
    node(Node::Symbol { id, indices: Vec::new(), dots })
}
