//! A sampled state: values for all symbols of a document, in which formulas are evaluated.
//!
//! A state is fixed by its *base*: numbers for the time, the constants, and the derivatives of everything that
//! varies. Off shell the base holds all derivatives up to the order in use; on shell it holds q and q̇, and the
//! Euler–Lagrange equations give the rest. The same code runs over measured numbers (to judge), dual numbers (to
//! project) and the numbers of a prime field (to certify).
//!
//! This file holds the state and its parts. [`super::evaluate`] gives each symbol its value.

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

/// A state.
pub struct SampledState<'m, B: Number> {
    pub(crate) model: &'m Model,
    /// How many derivatives are known of what is drawn, the value counted.
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
    /// When the mass matrix is singular there.
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

    /// The same state, of which no more than so many derivatives are known, the value counted, and the mass matrix
    /// inverted in the given way.
    ///
    /// # Errors
    /// When it cannot be.
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

    /// Lets a body stand in for the particles whose principal axes are stated of.
    pub(crate) fn set_body(&mut self, body: Option<GenericBody<B>>) {
        self.substitutes.body = body;
        self.memo.forget();
    }

    /// The model that the state belongs to.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// Gives a symbol a value of its own, whatever it means, and takes the earlier ones back.
    pub fn set_only(&mut self, overrides: &[(SymbolId, Series<B>)]) {
        self.overrides = overrides.iter().map(|(id, value)| (*id, Value::Scalar(*value))).collect();
        self.memo.forget();
    }

    /// The same for one symbol of any shape.
    pub fn replace(&mut self, id: SymbolId, value: Value<Series<B>>) {
        self.overrides = vec![(id, value)];
        self.memo.forget();
    }

    /// Lets these particles stand in for a family from now on; without them the family itself is meant again.
    pub fn substitute(&self, particles: Option<Particles<B>>) {
        self.substitutes.set(particles);
        self.memo.forget();
    }

    /// The coordinates as functions of time.
    pub fn coordinates(&self) -> &[Series<B>] {
        self.system.coordinates()
    }

    /// What the system determines here, if there is one.
    pub fn quantities(&self) -> Option<&Quantities<Series<B>>> {
        self.system.series()
    }

    /// The Euler–Lagrange residuals of the system at this state, one a coordinate.
    pub fn euler_lagrange(&self) -> Option<Vec<B>> {
        self.system.euler_lagrange()
    }

    /// What does not vary, known as far as what does.
    pub(crate) fn constant(&self, value: B) -> Series<B> {
        Series::constant(value).truncated(self.terms)
    }

    /// Where a member of a family stands among the others.
    pub(crate) fn place_of(&self, id: SymbolId, indices: &[u8]) -> usize {
        let symbols = &self.model.symbols;
        let upper = |letter: &IndexId| usize::from(symbols.indices[letter.0].upper);
        let slots = &symbols.entry(id).slots;
        indices.iter().zip(slots).fold(0, |at, (i, (_, letter))| at * upper(letter) + usize::from(*i) - 1)
    }

    /// How many derivatives are known of what is drawn, the value counted.
    pub(crate) fn terms(&self) -> usize {
        self.terms
    }

    /// The value that a symbol was given of its own, if it was.
    pub(crate) fn replaced(&self, id: SymbolId) -> Option<&Value<Series<B>>> {
        self.overrides.iter().find(|(known, _)| *known == id).map(|(_, value)| value)
    }

    /// Whether a symbol was given no value of its own, and no rule says what it is.
    pub(crate) fn is_free(&self, id: SymbolId) -> bool {
        self.replaced(id).is_none() && !self.rules.iter().any(|rule| rule.symbol == id)
    }

    /// Whether what a symbol stands for may be kept for the next time that it is asked for.
    fn keeps(&self, id: SymbolId) -> bool {
        let costly =
            matches!(self.model.meaning(id), Some(Meaning::Defined(_) | Meaning::Particles(..) | Meaning::Rigid(_)))
                || self.rules.iter().any(|rule| rule.symbol == id);
        costly && self.substitutes.is_nowhere()
    }

    /// What a symbol is kept under, if it is.
    pub(crate) fn key(&self, id: SymbolId, indices: &[u8]) -> Option<Key> {
        if indices.len() > 3 || self.replaced(id).is_some() || !self.keeps(id) {
            return None;
        }
        let mut values = [0; 3];
        values[..indices.len()].copy_from_slice(indices);
        Some(((id, values), self.substitutes.are_meant()))
    }

    /// Whether no particles stand in for others, and no law is being followed.
    pub(crate) fn is_alone(&self) -> bool {
        self.substitutes.is_empty() && !self.memo.is_following()
    }
}
