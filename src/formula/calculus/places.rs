//! The ends of an interval, and the value of a formula at a place.

use super::super::ids::SymbolId;
use super::super::tree::{Expr, Node};
use super::build::rational;
use super::expansion::contains;

/// An end of an interval.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// A number.
    At(Expr),
    /// +∞
    Infinity,
    /// −∞
    MinusInfinity,
}

/// The value of a formula where the letter has another value.
pub fn at(formula: &Expr, letter: SymbolId, x: &Expr) -> Expr {
    let mut formula = formula.clone();
    formula.substitute(&|node| match node {
        Node::Symbol { id, dots: 0, .. } if *id == letter => Some(x.clone()),
        _ => None,
    });
    formula
}

/// A whole number that a formula of numbers is.
pub fn whole(expr: &Expr) -> Option<i64> {
    rational(expr).filter(|value| value.denominator == 1).map(|value| value.numerator)
}

/// Whether a formula contains a letter.
pub fn depends_on(expr: &Expr, letter: SymbolId) -> bool {
    contains(expr, letter)
}
