//! A sampled state: values for all symbols of a document, in which formulas are evaluated.
//!
//! A state is fixed by its *base*: the time, the constants, and the values and derivatives of everything that varies.
//! Off shell the base holds all derivatives up to the order in use. On shell it holds q and q̇, and the Euler–Lagrange
//! equations give the rest. The same code runs over measured numbers (to test claims), dual numbers (to solve
//! hypotheses), symbols (to show a difference) and the numbers of a prime field (to certify).
//!
//! This file holds the state and its parts. [`super::evaluate`] gives the value of each symbol.

use std::sync::Arc;

use crate::Result;
use crate::check::hypotheses::rule::Rule;
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Mode;
use crate::check::state::generic_body::GenericBody;
use crate::check::state::memo::{Key, Memo};
use crate::check::state::numbers::{Base, Layout};
use crate::check::state::particles::{Particles, Substitutes};
use crate::check::state::system_values::SystemValues;
use crate::check::state::turning_frame::TurningFrame;
use crate::formula::{IndexId, SymbolId, Value};
use crate::mechanics::{LinearSolver, Quantities};
use crate::scalar::{Number, Series};

/// A sampled state over numbers of type `B`.
pub struct SampledState<'m, B: Number> {
    pub(crate) model: &'m Model,
    /// The number of terms of drawn functions: the value and its known derivatives.
    terms: usize,
    pub(crate) base: Base<B>,
    pub(crate) rules: Arc<[Rule]>,
    overrides: Vec<(SymbolId, Value<Series<B>>)>,
    pub(crate) system: SystemValues<'m, B>,
    pub(crate) frame: TurningFrame<B>,
    pub(crate) substitutes: Substitutes<B>,
    pub(crate) memo: Memo<B>,
}

impl<'m, B: Number> SampledState<'m, B> {
    /// The state with this base.
    ///
    /// # Errors
    /// If the mass matrix is singular at this state.
    pub fn new(model: &'m Model, mode: Mode, base: &[B], rules: &Arc<[Rule]>) -> Result<Self> {
        SampledState::by(
            LinearSolver::PartialPivoting,
            mode.order + 1,
            model,
            mode,
            (&Layout::of(model, mode), base),
            rules,
        )
    }

    /// The state with this base, with this number of terms and this way of inverting the mass matrix.
    ///
    /// # Errors
    /// If the mass matrix is singular at this state.
    pub fn by(
        solver: LinearSolver,
        terms: usize,
        model: &'m Model,
        mode: Mode,
        (layout, base): (&Arc<Layout>, &[B]),
        rules: &Arc<[Rule]>,
    ) -> Result<Self> {
        let base = Base::of(layout, base);
        Ok(SampledState {
            model,
            terms,
            rules: rules.clone(),
            overrides: Vec::new(),
            system: SystemValues::new(model, mode, &base, solver, terms)?,
            frame: TurningFrame::new(model.frame, terms),
            substitutes: Substitutes::default(),
            memo: Memo::default(),
            base,
        })
    }

    /// Replaces particles whose principal axes occur by a generic body.
    pub(crate) fn set_body(&mut self, body: Option<GenericBody<B>>) {
        self.substitutes.body = body;
        self.memo.forget();
    }

    /// The model of the state.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// Overrides the values of these symbols, and removes all earlier overrides.
    pub fn set_only(&mut self, overrides: &[(SymbolId, Series<B>)]) {
        self.overrides = overrides.iter().map(|(id, value)| (*id, Value::Scalar(*value))).collect();
        self.memo.forget();
    }

    /// Overrides the value of one symbol of any shape, and removes all earlier overrides.
    pub fn replace(&mut self, id: SymbolId, value: Value<Series<B>>) {
        self.overrides = vec![(id, value)];
        self.memo.forget();
    }

    /// Replaces a family by these particles from now on; `None` restores the family.
    pub fn substitute(&self, particles: Option<Particles<B>>) {
        self.substitutes.set(particles);
        self.memo.forget();
    }

    /// The coordinates as functions of time.
    pub fn coordinates(&self) -> &[Series<B>] {
        self.system.coordinates()
    }

    /// The quantities of the system at this state, if there is a system.
    pub fn quantities(&self) -> Option<&Quantities<Series<B>>> {
        self.system.series()
    }

    /// The Euler–Lagrange residuals of the system at this state, one for each coordinate.
    pub fn euler_lagrange(&self) -> Option<Vec<B>> {
        self.system.euler_lagrange()
    }

    /// A constant as a series with all terms known.
    pub(crate) fn constant(&self, value: B) -> Series<B> {
        Series::constant(value).truncated(self.terms)
    }

    /// The place of a member among all members of a family.
    pub(crate) fn place_of(&self, id: SymbolId, indices: &[u8]) -> usize {
        let symbols = &self.model.symbols;
        let upper = |letter: &IndexId| usize::from(symbols.indices[letter.0].upper);
        let slots = &symbols.entry(id).slots;
        indices.iter().zip(slots).fold(0, |at, (i, (_, letter))| at * upper(letter) + usize::from(*i) - 1)
    }

    /// The number of terms of drawn functions: the value and its known derivatives.
    pub(crate) fn terms(&self) -> usize {
        self.terms
    }

    /// The override of a symbol's value, if there is one.
    pub(crate) fn replaced(&self, id: SymbolId) -> Option<&Value<Series<B>>> {
        self.overrides.iter().find(|(known, _)| *known == id).map(|(_, value)| value)
    }

    /// Whether a symbol has neither an override nor a rule.
    pub(crate) fn is_free(&self, id: SymbolId) -> bool {
        self.replaced(id).is_none() && !self.rules.iter().any(|rule| rule.symbol == id)
    }

    /// Whether the value of a symbol may be cached.
    fn keeps(&self, id: SymbolId) -> bool {
        let costly =
            matches!(self.model.meaning(id), Some(Meaning::Defined(_) | Meaning::Particles(..) | Meaning::Rigid(_)))
                || self.rules.iter().any(|rule| rule.symbol == id);
        costly && self.substitutes.is_nowhere()
    }

    /// The cache key of a symbol, if its value is cached.
    pub(crate) fn key(&self, id: SymbolId, indices: &[u8]) -> Option<Key> {
        if indices.len() > 3 || self.replaced(id).is_some() || !self.keeps(id) {
            return None;
        }
        let mut values = [0; 3];
        values[..indices.len()].copy_from_slice(indices);
        Some(((id, values), self.substitutes.are_meant()))
    }

    /// Whether its symbols have the values that its base gives them: no overrides, and no substitutes.
    pub(crate) fn is_as_drawn(&self) -> bool {
        self.overrides.is_empty() && self.substitutes.is_empty() && self.substitutes.body.is_none()
    }

    /// Whether there are no substitutes, and no equation of motion is being solved.
    pub(crate) fn is_alone(&self) -> bool {
        self.substitutes.is_empty() && !self.memo.is_following()
    }
}
