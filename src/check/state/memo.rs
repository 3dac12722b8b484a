//! Values that were computed at a sampled state and are kept.

use std::cell::RefCell;
use std::sync::Arc;

use nalgebra::Matrix3;
use rustc_hash::FxHashMap;

use crate::check::state::values::{MemberValues, first};
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, SymbolId, Value};
use crate::mechanics::Nodes;
use crate::scalar::{Number, Primal, Series};

/// A symbol and the values of its indices.
type Member = (SymbolId, [u8; 3]);

/// What a value is kept under: the member, and whether substituted particles were meant.
pub(crate) type Key = (Member, bool);

/// The values kept at a state. Nothing here is an input: forgetting all of it changes no result.
pub(crate) struct Memo<B: Number> {
    /// Values of defined and ruled symbols, each with the number of terms it was computed to.
    pub(crate) series: RefCell<FxHashMap<Key, (usize, Box<Value<Series<B>>>)>>,
    /// The same where the value alone was asked for.
    values: RefCell<FxHashMap<Key, Value<Primal<B>>>>,
    /// Integrals over a continuum with their integrands and values.
    pub(crate) integrals: RefCell<Vec<(SymbolId, Expr, Value<Primal<B>>)>>,
    /// Nodes of continua: of which, and exact up to which degree.
    pub(crate) nodes: RefCell<FxHashMap<(usize, usize), Arc<Nodes<B>>>>,
    /// Inertia tensors of masses at positions, with the number of terms each was computed to.
    pub(crate) tensors: RefCell<Vec<(Expr, Expr, usize, Matrix3<Series<B>>)>>,
    /// Symbols that follow a law, with what is known of them while their next derivatives are being found.
    pub(crate) following: RefCell<Vec<(SymbolId, MemberValues<B>)>>,
    /// The same when all is found.
    pub(crate) followed: RefCell<std::collections::BTreeMap<SymbolId, MemberValues<B>>>,
}

impl<B: Number> Default for Memo<B> {
    fn default() -> Self {
        Memo {
            series: RefCell::default(),
            values: RefCell::default(),
            integrals: RefCell::default(),
            nodes: RefCell::default(),
            tensors: RefCell::default(),
            following: RefCell::default(),
            followed: RefCell::default(),
        }
    }
}

impl<B: Number> Memo<B> {
    /// Forgets all that was computed for other inputs.
    pub(crate) fn forget(&self) {
        self.forget_values();
        self.followed.borrow_mut().clear();
        self.nodes.borrow_mut().clear();
        self.tensors.borrow_mut().clear();
    }

    /// Forgets the values of symbols and integrals.
    pub(crate) fn forget_values(&self) {
        self.series.borrow_mut().clear();
        self.values.borrow_mut().clear();
        self.integrals.borrow_mut().clear();
    }

    /// Whether symbols that follow a law are known in part.
    pub(crate) fn is_following(&self) -> bool {
        !self.following.borrow().is_empty()
    }

    /// The value that is kept, or else what is computed now.
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
