//! The shapes of functions that sentences claim: minima, divergences, monotonicity, signs; and the values of such a
//! function, of which each symbol is an independent number.

use crate::formula::{Differentiable, Environment, Expr, SymbolId, Symbols, Unavailable, Value, evaluate};

use crate::check::kinds::limit::Towards;
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;

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

/// The values of the atoms of a state.
pub(crate) type Atoms = Vec<(SymbolId, f64)>;

/// An environment in which atoms are numbers without rates.
pub(crate) struct Still<'a, D> {
    pub symbols: &'a Symbols,
    pub values: Vec<(SymbolId, D)>,
}

impl<D: Differentiable> Environment<D> for Still<'_, D> {
    fn symbols(&self) -> &Symbols {
        self.symbols
    }

    fn symbol(&self, id: SymbolId, _indices: &[u8]) -> Result<Value<D>, Unavailable> {
        let found = self.values.iter().find(|(known, _)| *known == id);
        found.map(|(_, value)| Value::Scalar(*value)).ok_or(Unavailable::Symbol(id))
    }
}

/// The left side minus the right side of a hypothesis at a state.
pub(crate) fn difference<D: Differentiable>(
    state: &Atoms,
    hypothesis: &Hypothesis,
    model: &Model,
    mut number: impl FnMut(f64) -> D,
) -> Option<D> {
    let values = state.iter().map(|(id, x)| (*id, number(*x))).collect();
    let still = Still { symbols: &model.symbols, values };
    Some(value_of(&hypothesis.lhs, &still)? - value_of(&hypothesis.rhs, &still)?)
}

pub(crate) fn value_of<D: Differentiable>(expr: &Expr, environment: &dyn Environment<D>) -> Option<D> {
    match evaluate(expr, environment, &[]) {
        Ok(Value::Scalar(value)) => Some(value),
        _ => None,
    }
}
