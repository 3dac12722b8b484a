//! What a formula needs in order to be evaluated: the values of its symbols, and numbers that may know their time
//! derivative.
//!
//! [`Environment`] supplies the values. [`Differentiable`] is a number that may be a Taylor series in time ([`Series`]). A
//! derivative that nobody supplied is [`Unavailable`], never zero.

use nalgebra::Matrix3;
use num_dual::Dual;

use crate::scalar::{Instant, Measured, Number, Series};

use super::ids::{IndexId, SymbolId};
use super::symbols::Symbols;
use super::tree::Expr;
use super::value::Value;

/// Why a formula has no value at a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unavailable {
    /// Nothing gives this symbol a value.
    Symbol(SymbolId),
    /// A derivative of this order is not known.
    Derivative(u8),
    /// An operation that is not defined: the inverse of a matrix of more than three rows.
    Operation(&'static str),
}

/// A number that may know its own time derivative.
pub trait Differentiable: Number {
    /// The time derivative, if it is known.
    fn rate(&self) -> Option<Self> {
        None
    }
    /// Forgets all but so many terms: the value and its derivatives.
    fn truncate(&mut self, _terms: usize) {}
}

impl<B: Number> Differentiable for Series<B> {
    fn rate(&self) -> Option<Self> {
        (self.known() > 1).then(|| self.derivative())
    }
    fn truncate(&mut self, terms: usize) {
        Series::truncate(self, terms);
    }
}

impl<B: Number> Differentiable for Instant<B> {}
impl Differentiable for f64 {}
impl Differentiable for Measured {}
impl<B: Number> Differentiable for Dual<B> {}

/// Where symbols get their values.
pub trait Environment<D: Differentiable> {
    /// The table that the formula was read with.
    fn symbols(&self) -> &Symbols;
    /// The value of a symbol, for given values of its indices.
    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Result<Value<D>, Unavailable>;
    /// The same where no more than so many terms of it are used; there may be more.
    fn symbol_to(&self, id: SymbolId, indices: &[u8], _terms: usize) -> Result<Value<D>, Unavailable> {
        self.symbol(id, indices)
    }
    /// The derivative of a symbol, of an order above 0, of which no more than so many terms are used.
    fn rate_to(&self, id: SymbolId, indices: &[u8], order: u8, terms: usize) -> Result<Value<D>, Unavailable> {
        let mut value = self.symbol_to(id, indices, terms.saturating_add(order.into()))?;
        differentiate(&mut value, order)?;
        Ok(value)
    }
    /// The derivative of a formula, where numbers know none of their own and this knows how to get it.
    fn derivative(
        &self,
        _order: u8,
        _formula: &Expr,
        _indices: &[(IndexId, u8)],
    ) -> Option<Result<Value<D>, Unavailable>> {
        None
    }
    /// How many values an index takes here.
    fn count(&self, index: IndexId) -> Result<u8, Unavailable> {
        let entry = &self.symbols().indices[index.0];
        entry.count.map_or(Ok(entry.upper), |count| Err(Unavailable::Symbol(count)))
    }
    /// The integral over a continuum of what `body` gives at the point at hand. The integrand itself comes with it where it
    /// has no letter that stands for an index.
    fn integral(
        &self,
        region: SymbolId,
        _integrand: Option<&Expr>,
        _body: Body<'_, D>,
    ) -> Result<Value<D>, Unavailable> {
        Err(Unavailable::Symbol(region))
    }
    /// What `body` tends to as the part of a continuum at hand shrinks to its point.
    fn shrinking(&self, region: SymbolId, _body: Body<'_, D>) -> Result<Value<D>, Unavailable> {
        Err(Unavailable::Symbol(region))
    }
    /// How many particles lie in the part of a continuum at hand.
    fn count_within(&self, region: SymbolId) -> Result<u8, Unavailable> {
        Err(Unavailable::Symbol(region))
    }
    /// The matrix that an elementary rotation's symbol stands for, at an angle.
    fn rotation(&self, id: SymbolId, _angle: D) -> Result<Matrix3<D>, Unavailable> {
        Err(Unavailable::Symbol(id))
    }
}

/// A formula to be evaluated at one place after another.
pub type Body<'b, D> = &'b mut dyn FnMut() -> Result<Value<D>, Unavailable>;

/// Takes the time derivative so many times.
pub fn differentiate<D: Differentiable>(value: &mut Value<D>, order: u8) -> Result<(), Unavailable> {
    for _ in 0..order {
        let mut known = true;
        value.for_each(|entry| match entry.rate() {
            Some(rate) => *entry = rate,
            None => known = false,
        });
        if !known {
            return Err(Unavailable::Derivative(order));
        }
    }
    Ok(())
}
