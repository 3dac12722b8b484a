//! An environment with values given by hand, for a formula without a document.
//!
//! The value of a dotted symbol is given separately (`\dot\theta = 0.83`), and `d/dt` uses it.

use crate::scalar::{Number, Series, TERMS};

use super::environment::{Environment, Unavailable};
use super::ids::SymbolId;
use super::symbols::{Kind, Symbols};
use super::value::Value;

/// The known values of each symbol and of its time derivatives.
#[derive(Clone, Debug)]
pub struct Assignment<'a, B> {
    symbols: &'a Symbols,
    values: Vec<[Option<B>; TERMS]>,
}

impl<'a, B: Number> Assignment<'a, B> {
    /// An assignment for the names in `symbols`, without values.
    pub fn new(symbols: &'a Symbols) -> Self {
        Assignment { symbols, values: vec![[None; TERMS]; symbols.len()] }
    }

    /// Sets the value of the `order`-th time derivative of a symbol; order 0 is the symbol itself.
    pub fn set(&mut self, id: SymbolId, order: u8, value: B) {
        if let Some(slot) = self.values.get_mut(id.0).and_then(|known| known.get_mut(usize::from(order))) {
            *slot = Some(value);
        }
    }
}

impl<B: Number> Environment<Series<B>> for Assignment<'_, B> {
    fn symbols(&self) -> &Symbols {
        self.symbols
    }

    fn symbol(&self, id: SymbolId, _indices: &[u8]) -> Result<Value<Series<B>>, Unavailable> {
        // One number is given for each name, so a vector or a matrix has no value.
        let is_number = self.symbols.entry(id).kind == Kind::Scalar;
        let known = self.values.get(id.0).filter(|_| is_number).ok_or(Unavailable::Symbol(id))?;
        let last = known.iter().rposition(Option::is_some).ok_or(Unavailable::Symbol(id))?;
        // A gap below a known derivative is not a number, and so shows wherever it is used.
        let derivatives: Vec<B> = known[..=last].iter().map(|value| value.unwrap_or(B::from(f64::NAN))).collect();
        Ok(Value::Scalar(Series::from_derivatives(&derivatives)))
    }
}
