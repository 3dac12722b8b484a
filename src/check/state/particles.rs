//! Substitutes at a sampled state: particles in place of a family, a part of a continuum, or a generic body in place of
//! particles whose principal axes occur in a claim.

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use nalgebra::Vector3;

use crate::check::model::Model;
use crate::check::state::generic_body::GenericBody;
use crate::formula::{Expr, IndexId, SymbolId, Symbols, Value};
use crate::mechanics::Nodes;
use crate::scalar::{Number, Series, each};

/// Particles that replace the members of some families.
pub struct Particles<B: Number> {
    members: Vec<(SymbolId, Vec<Value<Series<B>>>)>,
    /// The letter that labels them.
    pub label: IndexId,
    /// Whether they are joined families, which replace others only in formulas that depend on the joined family.
    joined: bool,
}

impl<B: Number> Particles<B> {
    /// The members of joined families. Only formulas that depend on them use them.
    pub fn joined(members: Vec<(SymbolId, Vec<Value<Series<B>>>)>, label: IndexId) -> Self {
        Particles { members, label, joined: true }
    }

    /// Point masses in place of a family of masses and a family of positions.
    pub(crate) fn of(
        nodes: &Nodes<B>,
        (mass, position): (SymbolId, SymbolId),
        label: IndexId,
        constant: impl Fn(B) -> Series<B>,
    ) -> Self {
        let masses = each(&nodes.points, &|(_, m)| Value::Scalar(constant(*m)));
        let positions = each(&nodes.points, &|(x, _)| Value::Vector(x.map(&constant)));
        Particles { members: vec![(mass, masses), (position, positions)], label, joined: false }
    }

    /// The number of particles.
    pub fn len(&self) -> u8 {
        self.members.first().map_or(0, |(_, members)| members.len().min(u8::MAX.into()) as u8)
    }

    /// Whether they are joined families.
    pub fn is_joined(&self) -> bool {
        self.joined
    }

    /// The families that they replace.
    pub fn symbols(&self) -> Vec<SymbolId> {
        self.members.iter().map(|(id, _)| *id).collect()
    }

    /// The member of a family, if they replace that family.
    pub fn member(&self, id: SymbolId, indices: &[u8]) -> Option<&Value<Series<B>>> {
        let (_, members) = self.members.iter().find(|(known, _)| *known == id)?;
        match indices {
            [at] => members.get(usize::from(*at).wrapping_sub(1)),
            _ => None,
        }
    }
}

/// The place in a continuum at which a formula is evaluated.
pub struct Location<B: Number> {
    /// The continuum and the point of it.
    pub(crate) point: Option<(usize, Vector3<B>)>,
    /// The part of a continuum around its own point.
    pub part: Option<Part<B>>,
}

/// A part of a continuum.
pub struct Part<B: Number> {
    /// The continuum, by its place in the model.
    pub of: usize,
    /// The particles in the part.
    pub particles: Particles<B>,
    /// The volume, area or length of the part.
    pub size: B,
}

impl<B: Number> Default for Location<B> {
    fn default() -> Self {
        Location { point: None, part: None }
    }
}

impl<B: Number> Location<B> {
    /// Whether no place is set.
    pub fn is_default(&self) -> bool {
        self.point.is_none() && self.part.is_none()
    }
}

/// The substitutes at a state, and the place in a continuum at which the current formula is evaluated.
pub(crate) struct Substitutes<B: Number> {
    /// The place in a continuum at which the current formula is evaluated.
    pub(crate) location: RefCell<Location<B>>,
    /// Particles that replace the members of a family.
    particles: RefCell<Option<Arc<Particles<B>>>>,
    /// Whether the current formula uses them.
    meant: Cell<bool>,
    /// The generic body that replaces particles whose principal axes occur.
    pub(crate) body: Option<GenericBody<B>>,
}

impl<B: Number> Default for Substitutes<B> {
    fn default() -> Self {
        Substitutes { location: RefCell::default(), particles: RefCell::default(), meant: Cell::new(false), body: None }
    }
}

impl<B: Number> Substitutes<B> {
    /// Replaces a family by these particles in every formula.
    pub(crate) fn set(&self, particles: Option<Particles<B>>) {
        self.meant.set(particles.is_some());
        *self.particles.borrow_mut() = particles.map(Arc::new);
    }

    /// Replaces a joined family by these particles, only in formulas that depend on it.
    pub(crate) fn join(&self, particles: Particles<B>) {
        *self.particles.borrow_mut() = Some(Arc::new(particles));
    }

    /// Whether no particles replace a family.
    pub(crate) fn is_empty(&self) -> bool {
        self.particles.borrow().is_none()
    }

    /// Whether the current formula uses the substituted particles.
    pub(crate) fn are_meant(&self) -> bool {
        self.meant.get()
    }

    /// Evaluates a definition. Within it, joined families are used if the definition depends on them.
    pub(crate) fn within<T>(&self, definition: &Expr, model: &Model, evaluate: impl FnOnce() -> T) -> T {
        let outer = self.meant.get();
        if let Some(particles) = self.particles.borrow().as_ref().filter(|particles| particles.is_joined()) {
            self.meant.set(model.depends_on(definition, &particles.symbols()));
        }
        let value = evaluate();
        self.meant.set(outer);
        value
    }

    /// The result of `take` on the particle that replaces a member of a family, if there is one.
    pub(crate) fn member<T>(&self, id: SymbolId, indices: &[u8], take: impl Fn(&Value<Series<B>>) -> T) -> Option<T> {
        let particles = self.particles.borrow();
        let everywhere = particles.as_ref().filter(|_| self.meant.get());
        everywhere.and_then(|particles| particles.member(id, indices)).map(&take).or_else(|| {
            let location = self.location.borrow();
            location.part.as_ref().and_then(|part| part.particles.member(id, indices)).map(&take)
        })
    }

    /// The number of particles that replace those that an index counts, if there are any.
    pub(crate) fn count(&self, index: IndexId, symbols: &Symbols) -> Option<u8> {
        let particles = self.particles.borrow();
        let meant = particles.as_ref().filter(|_| self.meant.get())?;
        symbols.same_range(meant.label, index).then(|| meant.len())
    }

    /// The number of particles in the current part of a continuum.
    pub(crate) fn count_within(&self, continuum: usize) -> Option<u8> {
        let location = self.location.borrow();
        location.part.as_ref().filter(|part| part.of == continuum).map(|part| part.particles.len())
    }

    /// Whether no place in a continuum is set.
    pub(crate) fn is_nowhere(&self) -> bool {
        self.location.borrow().is_default()
    }
}
