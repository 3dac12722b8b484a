//! The cache of values at a sampled state.

use std::cell::RefCell;
use std::sync::Arc;

use nalgebra::Matrix3;
use rustc_hash::FxHashMap;

use crate::check::state::values::{MemberValues, first};
use crate::formula::evaluate::Unavailable;
use crate::formula::tree::Definite;
use crate::formula::{Expr, SymbolId, Value};
use crate::mechanics::Nodes;
use crate::scalar::{Number, Primal, Series};

/// A symbol and the values of its indices.
type Member = (SymbolId, [u8; 3]);

/// The key of a value: the member of a family, and whether substituted particles were used.
pub(crate) type Key = (Member, bool);

/// Values as series, each with the number of terms it was computed to.
type SeriesByKey<B> = FxHashMap<Key, (usize, Box<Value<Series<B>>>)>;

/// A continuum, an integrand, and the value of the integral.
type KnownIntegral<B> = (SymbolId, Expr, Value<Primal<B>>);

/// Quadrature nodes by continuum and by the degree up to which they are exact.
type NodesByDegree<B> = FxHashMap<(usize, usize), Arc<Nodes<B>>>;

/// Masses, positions, a number of terms, and the inertia tensor.
type KnownTensor<B> = (Expr, Expr, usize, Matrix3<Series<B>>);

/// The cached values at a state. Clearing the cache changes no result.
pub(crate) struct Memo<B: Number> {
    /// Values of defined symbols and of symbols with rules, each with its number of terms.
    pub(crate) series: RefCell<SeriesByKey<B>>,
    /// The same values without derivatives.
    values: RefCell<FxHashMap<Key, Value<Primal<B>>>>,
    /// Integrals over a continuum with their integrands and values.
    pub(crate) integrals: RefCell<Vec<KnownIntegral<B>>>,
    /// Integrals over a letter with their values.
    pub(crate) quadratures: RefCell<Vec<(Definite, Value<Primal<B>>)>>,
    /// Quadrature nodes, by the continuum and the degree up to which they are exact.
    pub(crate) nodes: RefCell<NodesByDegree<B>>,
    /// Inertia tensors by masses and positions, each with its number of terms.
    pub(crate) tensors: RefCell<Vec<KnownTensor<B>>>,
    /// Symbols with an equation of motion, with the known terms while the next ones are computed.
    pub(crate) following: RefCell<Vec<(SymbolId, MemberValues<B>)>>,
    /// The terms that are known of a symbol after it was followed while others were. They hold, and the others need no more of them yet.
    pub(crate) begun: RefCell<std::collections::BTreeMap<SymbolId, MemberValues<B>>>,
    /// The same symbols when all terms are known.
    pub(crate) followed: RefCell<std::collections::BTreeMap<SymbolId, MemberValues<B>>>,
}

impl<B: Number> Default for Memo<B> {
    fn default() -> Self {
        Memo {
            series: RefCell::default(),
            values: RefCell::default(),
            integrals: RefCell::default(),
            quadratures: RefCell::default(),
            nodes: RefCell::default(),
            tensors: RefCell::default(),
            following: RefCell::default(),
            begun: RefCell::default(),
            followed: RefCell::default(),
        }
    }
}

impl<B: Number> Memo<B> {
    /// Clears everything, after a change of the inputs.
    pub(crate) fn forget(&self) {
        self.forget_values();
        self.begun.borrow_mut().clear();
        self.followed.borrow_mut().clear();
        self.nodes.borrow_mut().clear();
        self.tensors.borrow_mut().clear();
    }

    /// Clears the values of symbols and integrals.
    pub(crate) fn forget_values(&self) {
        self.series.borrow_mut().clear();
        self.values.borrow_mut().clear();
        self.integrals.borrow_mut().clear();
        self.quadratures.borrow_mut().clear();
    }

    /// Whether an equation of motion is being solved.
    pub(crate) fn is_following(&self) -> bool {
        !self.following.borrow().is_empty()
    }

    /// The cached value, or the value that is computed now.
    ///
    /// # Errors
    /// Those of `compute`.
    pub(crate) fn remember(
        &self,
        key: Key,
        compute: impl FnOnce() -> Result<Value<Primal<B>>, Unavailable>,
    ) -> Result<Value<Primal<B>>, Unavailable> {
        if let Some(value) = self.values.borrow().get(&key) {
            return Ok(value.clone());
        }
        let known = self.series.borrow().get(&key).map(|(_, value)| first(value));
        let value = known.map_or_else(compute, Ok)?;
        self.values.borrow_mut().insert(key, value.clone());
        Ok(value)
    }
}
