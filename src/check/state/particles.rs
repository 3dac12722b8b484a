//! What stands in for families and continua at a sampled state: particles in place of a family, a part of a continuum, a
//! generic body in place of particles whose principal axes are stated of.

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use nalgebra::Vector3;

use crate::check::model::Model;
use crate::check::state::generic_body::GenericBody;
use crate::formula::{Expr, IndexId, SymbolId, Symbols, Value};
use crate::mechanics::Nodes;
use crate::scalar::{Number, Series};

/// Particles that stand in for those of some families.
pub struct Particles<B: Number> {
    members: Vec<(SymbolId, Vec<Value<Series<B>>>)>,
    /// A letter that labels them.
    pub label: IndexId,
    /// Whether they are families that were joined, and stand in only where the joined family is meant.
    joined: bool,
}

impl<B: Number> Particles<B> {
    /// Families that were joined: they are meant by what is defined through them, and nowhere else.
    pub fn joined(members: Vec<(SymbolId, Vec<Value<Series<B>>>)>, label: IndexId) -> Self {
        Particles { members, label, joined: true }
    }

    /// Point masses in place of a family of masses and one of positions.
    pub(crate) fn of(
        nodes: &Nodes<B>,
        (mass, position): (SymbolId, SymbolId),
        label: IndexId,
        constant: impl Fn(B) -> Series<B>,
    ) -> Self {
        let masses = nodes.points.iter().map(|(_, m)| Value::Scalar(constant(*m))).collect();
        let positions = nodes.points.iter().map(|(x, _)| Value::Vector(x.map(&constant))).collect();
        Particles { members: vec![(mass, masses), (position, positions)], label, joined: false }
    }

    /// How many they are.
    pub fn len(&self) -> u8 {
        self.members.first().map_or(0, |(_, members)| members.len().min(u8::MAX.into()) as u8)
    }

    /// Whether they are meant only by what is defined through them.
    pub fn is_joined(&self) -> bool {
        self.joined
    }

    /// The families that they stand in for.
    pub fn symbols(&self) -> Vec<SymbolId> {
        self.members.iter().map(|(id, _)| *id).collect()
    }

    /// The member of a family, if they stand in for it.
    pub fn member(&self, id: SymbolId, indices: &[u8]) -> Option<&Value<Series<B>>> {
        let (_, members) = self.members.iter().find(|(known, _)| *known == id)?;
        match indices {
            [at] => members.get(usize::from(*at).wrapping_sub(1)),
            _ => None,
        }
    }
}

/// Where in a continuum a formula is evaluated.
pub struct Location<B: Number> {
    /// The continuum and the point of it.
    pub(crate) point: Option<(usize, Vector3<B>)>,
    /// The part of a continuum that is cut out around its own point, and its size.
    pub part: Option<Part<B>>,
}

/// A part of a continuum.
pub struct Part<B: Number> {
    /// Of which.
    pub of: usize,
    /// The particles in it.
    pub particles: Particles<B>,
    /// Its volume, area or length.
    pub size: B,
}

impl<B: Number> Default for Location<B> {
    fn default() -> Self {
        Location { point: None, part: None }
    }
}

impl<B: Number> Location<B> {
    /// Whether it is nowhere in particular.
    pub fn is_default(&self) -> bool {
        self.point.is_none() && self.part.is_none()
    }
}

/// What stands in for others at a state, and where in a continuum the formula at hand is evaluated.
pub(crate) struct Substitutes<B: Number> {
    /// Where in a continuum the formula at hand is evaluated.
    pub(crate) location: RefCell<Location<B>>,
    /// Particles that stand in for those of a family.
    particles: RefCell<Option<Arc<Particles<B>>>>,
    /// Whether the formula at hand means them.
    meant: Cell<bool>,
    /// What stands in for particles whose principal axes are stated of.
    pub(crate) body: Option<GenericBody<B>>,
}

impl<B: Number> Default for Substitutes<B> {
    fn default() -> Self {
        Substitutes { location: RefCell::default(), particles: RefCell::default(), meant: Cell::new(false), body: None }
    }
}

impl<B: Number> Substitutes<B> {
    /// Lets these particles stand in for a family, in every formula.
    pub(crate) fn set(&self, particles: Option<Particles<B>>) {
        self.meant.set(particles.is_some());
        *self.particles.borrow_mut() = particles.map(Arc::new);
    }

    /// Lets these particles stand in for a joined family: in formulas that depend on it, and in no others.
    pub(crate) fn join(&self, particles: Particles<B>) {
        *self.particles.borrow_mut() = Some(Arc::new(particles));
    }

    /// Whether no particles stand in for those of a family.
    pub(crate) fn is_empty(&self) -> bool {
        self.particles.borrow().is_none()
    }

    /// Whether the formula at hand means the particles that stand in for others.
    pub(crate) fn are_meant(&self) -> bool {
        self.meant.get()
    }

    /// Evaluates what a definition says; within it, joined families are meant if the definition depends on them.
    pub(crate) fn within<T>(&self, definition: &Expr, model: &Model, evaluate: impl FnOnce() -> T) -> T {
        let outer = self.meant.get();
        if let Some(particles) = self.particles.borrow().as_ref().filter(|particles| particles.is_joined()) {
            self.meant.set(model.depends_on(definition, &particles.symbols()));
        }
        let value = evaluate();
        self.meant.set(outer);
        value
    }

    /// What is made of the particle that stands in for a member of a family, if one does.
    pub(crate) fn member<T>(&self, id: SymbolId, indices: &[u8], take: impl Fn(&Value<Series<B>>) -> T) -> Option<T> {
        let particles = self.particles.borrow();
        let everywhere = particles.as_ref().filter(|_| self.meant.get());
        everywhere.and_then(|particles| particles.member(id, indices)).map(&take).or_else(|| {
            let location = self.location.borrow();
            location.part.as_ref().and_then(|part| part.particles.member(id, indices)).map(&take)
        })
    }

    /// How many particles stand in for those that an index counts, if any do.
    pub(crate) fn count(&self, index: IndexId, symbols: &Symbols) -> Option<u8> {
        let particles = self.particles.borrow();
        let meant = particles.as_ref().filter(|_| self.meant.get())?;
        symbols.same_range(meant.label, index).then(|| meant.len())
    }

    /// How many particles there are in the part of a continuum at hand.
    pub(crate) fn count_within(&self, continuum: usize) -> Option<u8> {
        let location = self.location.borrow();
        location.part.as_ref().filter(|part| part.of == continuum).map(|part| part.particles.len())
    }

    /// Whether nothing is evaluated at a place in a continuum or in a part of one.
    pub(crate) fn is_nowhere(&self) -> bool {
        self.location.borrow().is_default()
    }
}
