//! The pool of factors and terms that may be inserted into a formula.

use crate::formula::SymbolId;

/// Factors and terms that may be put in, as their authors typed them.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    pub(super) factors: Vec<String>,
    pub(super) terms: Vec<String>,
    /// `\sin`, `\cos^2`: what may stand before a name.
    pub(super) functions: Vec<String>,
    /// `\sum_{i=1}^{n}`, `\int_V`: what may stand before factors.
    pub(super) sums: Vec<String>,
    /// The symbols that stand there.
    pub(super) names: Vec<SymbolId>,
}

impl Pool {
    /// Nothing: what was lost is not looked for.
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
