//! The frequency of small oscillations of one coordinate: a name for the ω with K − ω²M = 0, where K and M are the second
//! derivatives of −L and of L by the coordinate and by the velocity, with the coordinate at 0 and at rest.
//!
//! With several coordinates the condition det(K − ω²M) = 0 has several roots, and a state that solves it may always be at the
//! same one. What holds for one root would pass, so this is rejected.

use crate::formula::derivative::{self, Scope};
use crate::formula::tree::Variable;
use crate::formula::{Expr, Node, Relation, SymbolId, text};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};

/// The conditions that the normal frequencies of the document obey.
///
/// # Errors
/// Where the Lagrangian has several coordinates, or no such derivatives as formulas.
pub(crate) fn conditions(model: &Model, lagrangian: SymbolId) -> Result<Vec<Hypothesis>> {
    let Some(first) = model.normal_frequencies.first() else { return Ok(Vec::new()) };
    let name = text::plain(&model.name(*first));
    let unsupported = |what: &str| Error::new(format!("{name} is no normal frequency: {what}"));
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    let [only] = coordinates.as_slice() else {
        return Err(unsupported("the Lagrangian has more than one coordinate, and so several of them")
            .help("declare it as a constant, and claim that it solves the printed secular equation, with \"solves\""));
    };
    let second = |a: u8, b: u8| {
        let found = at_rest(model, lagrangian, [(*only, a), (*only, b)], &coordinates);
        found.ok_or_else(|| unsupported("the Lagrangian has no second derivatives as formulas"))
    };
    let mut conditions = Vec::new();
    for omega in &model.normal_frequencies {
        let square = node(Node::Power(Box::new(symbol(*omega, 0)), Box::new(number(2))));
        let lhs = second(0, 0)?.negated().minus(node(Node::Product(vec![square, second(1, 1)?])));
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
