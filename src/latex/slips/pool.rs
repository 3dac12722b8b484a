//! The pool of factors and terms that may be inserted into a formula.

use crate::formula::SymbolId;

/// Factors and terms that may be inserted, as their authors typed them.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    pub(super) factors: Vec<String>,
    pub(super) terms: Vec<String>,
    /// Functions that may precede a name: `\sin`, `\cos^2`.
    pub(super) functions: Vec<String>,
    /// Operators that may precede factors: `\sum_{i=1}^{n}`, `\int_V`.
    pub(super) sums: Vec<String>,
    /// The symbols of the texts.
    pub(super) names: Vec<SymbolId>,
}

impl Pool {
    /// An empty pool.
    pub fn empty() -> Pool {
        Pool::default()
    }

    /// The factors, the commonest first.
    pub fn factors(&self) -> &[String] {
        &self.factors
    }

    /// The factors alone.
    pub fn factors_only(mut self) -> Pool {
        self.terms.clear();
        self
    }
}
