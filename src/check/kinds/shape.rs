//! The shapes of functions that sentences claim: minima, divergences, monotonicity, signs.

use crate::formula::Expr;

use crate::check::kinds::limit::Towards;

/// A claim about the shape of a function.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Positive everywhere along the variable.
    Positive,
    /// Negative everywhere.
    Negative,
    /// Of both signs.
    ChangesSign,
    /// So many minima inside the range.
    Minima(usize),
    /// So many maxima inside the range.
    Maxima(usize),
    /// Rises everywhere.
    Rises,
    /// Falls everywhere.
    Falls,
    /// Does not change at all.
    Independent,
    /// Tends to a value (or diverges) as the variable approaches an end.
    TendsTo {
        /// The end.
        end: f64,
        /// The formula of the end, which is a number.
        formula: Box<Expr>,
        /// What the function tends to.
        target: Target,
    },
    /// As an equation set to zero, has so many real solutions for the variable.
    Solutions(usize),
}

/// What a function tends to.
#[derive(Clone, Debug)]
pub enum Target {
    /// It diverges.
    Infinite(Towards),
    /// The value of a formula.
    Finite(Box<Expr>),
}
