//! What a formula needs in order to be evaluated: the values of its symbols, and numbers that may know their time
//! derivative.
//!
//! [`Environment`] supplies the values. [`Differentiable`] is a number that may be a Taylor series in time ([`Series`]). A
//! derivative that nobody supplied is [`Unavailable`], never zero.

use nalgebra::Matrix3;
use num_dual::Dual;

use crate::scalar::{Number, Primal, RunningError, Series};

use super::ids::{IndexId, SymbolId};
use super::symbols::Symbols;
use super::tree::{Definite, Expr};
use super::value::Value;

/// Why a formula has no value at a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unavailable {
    /// This symbol has no value.
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
}

impl<B: Number> Differentiable for Series<B> {
    fn rate(&self) -> Option<Self> {
        (self.known() > 1).then(|| self.derivative())
    }
}

impl<B: Number> Differentiable for Primal<B> {}
impl Differentiable for f64 {}
impl Differentiable for RunningError {}
impl<B: Number> Differentiable for Dual<B> {}

/// The values of symbols, and the operations on continua that a formula may need.
pub trait Environment<D: Differentiable> {
    /// The symbol table that the formula was read with.
    fn symbols(&self) -> &Symbols;
    /// The value of a symbol for these values of its indices.
    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Result<Value<D>, Unavailable>;
    /// As [`Environment::symbol`], where at most `terms` terms of the value are used; the result may have more.
    fn symbol_to(&self, id: SymbolId, indices: &[u8], _terms: usize) -> Result<Value<D>, Unavailable> {
        self.symbol(id, indices)
    }
    /// The derivative of a symbol, of an order above 0, where at most `terms` terms of it are used.
    fn rate_to(&self, id: SymbolId, indices: &[u8], order: u8, terms: usize) -> Result<Value<D>, Unavailable> {
        let mut value = self.symbol_to(id, indices, terms.saturating_add(order.into()))?;
        differentiate(&mut value, order)?;
        Ok(value)
    }
    /// The derivative of a formula, from an environment that computes it itself; `None` if the numbers carry
    /// derivatives.
    fn derivative(
        &self,
        _order: u8,
        _formula: &Expr,
        _indices: &[(IndexId, u8)],
    ) -> Option<Result<Value<D>, Unavailable>> {
        None
    }
    /// The number of values of an index.
    fn count(&self, index: IndexId) -> Result<u8, Unavailable> {
        let entry = &self.symbols().indices[index.0];
        entry.count.map_or(Ok(entry.upper), |count| Err(Unavailable::Symbol(count)))
    }
    /// The integral of `body` over a continuum; `body` evaluates the integrand at the current point. `integrand` is the
    /// integrand as a formula, if it has no free index.
    fn integral(
        &self,
        region: SymbolId,
        _integrand: Option<&Expr>,
        _body: Body<'_, D>,
    ) -> Result<Value<D>, Unavailable> {
        Err(Unavailable::Symbol(region))
    }
    /// The value of an integral over a letter, which `body` computes. It may be kept where it depends on nothing around it.
    fn quadrature(&self, _of: &Definite, _is_closed: bool, body: Body<'_, D>) -> Result<Value<D>, Unavailable> {
        body()
    }
    /// The limit of `body` as the current part of a continuum shrinks to a point.
    fn shrinking(&self, region: SymbolId, _body: Body<'_, D>) -> Result<Value<D>, Unavailable> {
        Err(Unavailable::Symbol(region))
    }
    /// The number of particles in the current part of a continuum.
    fn count_within(&self, region: SymbolId) -> Result<u8, Unavailable> {
        Err(Unavailable::Symbol(region))
    }
    /// The matrix of an elementary rotation by `angle`, in radians.
    fn rotation(&self, id: SymbolId, _angle: D) -> Result<Matrix3<D>, Unavailable> {
        Err(Unavailable::Symbol(id))
    }
}

/// A formula that is evaluated repeatedly, at one point after another.
pub type Body<'b, D> = &'b mut dyn FnMut() -> Result<Value<D>, Unavailable>;

/// Replaces a value by its `order`-th time derivative.
///
/// # Errors
/// [`Unavailable::Derivative`] if a number does not know that derivative.
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
