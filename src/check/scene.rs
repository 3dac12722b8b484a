//! One state of a document's world, in which formulas are evaluated.
//!
//! A state is fixed by its *base*: numbers for the time, the constants, and the derivatives of everything that
//! varies. Off shell the base holds all derivatives up to the order in use; on shell it holds q and q̇, and the Euler–
//! Lagrange equations give the rest. Hypotheses that are rules are followed when their symbol is asked for. The same
//! code runs over measured numbers (to judge) and dual numbers (to solve conditions for a variable).

use std::cell::{Cell, OnceCell, RefCell};
use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{DMatrix, Matrix3, Vector3};
use rustc_hash::FxHashMap;

use crate::Result;
use crate::formula::evaluate::{ALL, Body, Environment, Unavailable, evaluate};
use crate::formula::{Expr, IndexId, Kind, SymbolId, Symbols, Value};
use crate::mechanics::{Elimination, Frame, Nodes, Quantities, rotations};
use crate::notes::claims::Turning;
use crate::scalar::{Instant, Number, Series, TERMS};

use super::any_body::AnyBody;
use super::base::{Base, Layout};
use super::crowd::{Crowd, Place};
use super::instant::first;
use super::model::{FrameQuantity, Meaning, Model, Quantity};
use super::rules::{Action, Rule};

/// How states are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mode {
    /// Whether the accelerations obey the Euler–Lagrange equations, and the laws hold.
    pub on_shell: bool,
    /// The highest time derivative that is known.
    pub order: usize,
}

/// A symbol and the values of its indices.
type Member = (SymbolId, [u8; 3]);

/// What a value is kept under: the member, and whether the particles that stand in for others were meant.
type Key = (Member, bool);

/// What was computed, and to how many terms.
type Memo<B> = FxHashMap<Key, (usize, Box<Value<Series<B>>>)>;

/// Masses, positions, how many terms were asked for, and the inertia tensor.
type Tensor<B> = (Expr, Expr, usize, Matrix3<Series<B>>);

/// The values of all members of a family, in order.
pub(super) type Members<B> = Vec<Value<Series<B>>>;

/// A value, or why there is none.
pub(super) type Valued<B> = Result<Value<Series<B>>, Unavailable>;

/// How fast the frame turns, if there is one.
type AngularVelocity<B> = Option<Box<Vector3<Series<B>>>>;

/// Coefficients of the axes of a frame, if there is one.
type Axes<B> = Option<Box<Matrix3<Instant<B>>>>;

/// The nodes of bodies.
type Cubatures<B> = FxHashMap<(usize, usize), Arc<Nodes<B>>>;

/// A state.
pub struct Scene<'m, B: Number> {
    pub(super) model: &'m Model,
    elimination: Elimination,
    /// How many derivatives are known of what is drawn, the value counted.
    terms: usize,
    pub(super) base: Base<B>,
    coordinates: Vec<Series<B>>,
    pub(super) rules: Arc<[Rule]>,
    overrides: Vec<(SymbolId, Value<Series<B>>)>,
    quantities: OnceCell<Option<Box<Quantities<Series<B>>>>>,
    /// The same, as values alone.
    quantities_now: OnceCell<Option<Box<Quantities<Instant<B>>>>>,
    /// The frame that turns, known to so many terms as its place here says.
    frames: [OnceCell<Option<Box<Frame<B>>>>; TERMS + 2],
    /// Its axes' coefficients of each order.
    axes: [OnceCell<Axes<B>>; TERMS],
    /// Its angular velocity at the instant.
    turns: OnceCell<Option<Vector3<Instant<B>>>>,
    /// Its angular velocity, likewise.
    angular_velocities: [OnceCell<AngularVelocity<B>>; TERMS + 1],
    /// Where in a continuum the formula at hand is evaluated.
    pub(super) place: RefCell<Place<B>>,
    /// Particles that stand in for those of a family.
    crowd: RefCell<Option<Arc<Crowd<B>>>>,
    /// Whether the formula at hand means them.
    crowded: Cell<bool>,
    /// Symbols that follow a law, with what is known of them while their next derivatives are being found.
    pub(super) following: RefCell<Vec<(SymbolId, Members<B>)>>,
    /// The same when all is found.
    pub(super) followed: RefCell<BTreeMap<SymbolId, Members<B>>>,
    /// Nodes of continua, of a degree.
    pub(super) cubatures: RefCell<Cubatures<B>>,
    /// What stands in for particles whose principal axes are spoken of.
    pub(super) body: Option<AnyBody<B>>,
    /// Inertia tensors of masses at positions.
    pub(super) tensors: RefCell<Vec<Tensor<B>>>,
    /// Values of defined and ruled symbols.
    memo: RefCell<Memo<B>>,
    /// The same where the value alone was asked for.
    values: RefCell<FxHashMap<Key, Value<Instant<B>>>>,
    /// The values of integrals.
    pub(super) integrals: RefCell<Integrals<B>>,
}

/// Integrals over a continuum with their integrands and values.
type Integrals<B> = Vec<(SymbolId, Expr, Value<Instant<B>>)>;

impl<'m, B: Number> Scene<'m, B> {
    /// The state with this base.
    ///
    /// # Errors
    /// When the mass matrix is singular there.
    pub fn new(model: &'m Model, mode: Mode, base: &[B], rules: &Arc<[Rule]>) -> Result<Self> {
        Scene::by(Elimination::Pivots, mode.order + 1, model, mode, (&Layout::of(model, mode), base), rules)
    }

    /// The same state, of which no more than so many derivatives are known, the value counted, and the mass matrix
    /// inverted in the given way.
    ///
    /// # Errors
    /// When it cannot be.
    pub fn by(
        elimination: Elimination,
        terms: usize,
        model: &'m Model,
        mode: Mode,
        (layout, base): (&Arc<Layout>, &[B]),
        rules: &Arc<[Rule]>,
    ) -> Result<Self> {
        let base = Base::of(layout, base);
        let coordinates = match &model.world {
            Some(world) if mode.on_shell => {
                let q: Vec<B> = base.coordinates().map(|jet| jet[0]).collect();
                let v: Vec<B> = base.coordinates().map(|jet| jet[1]).collect();
                let parameters: Vec<B> = model.parameters.iter().map(|place| base.constant(*place)[0]).collect();
                let order = mode.order.min(terms - 1).max(1);
                world.motion_by(elimination, base.time, &q, &v, &parameters, order)?
            }
            _ => base.coordinates().map(|jet| Series::from_derivatives(jet).truncated(terms)).collect(),
        };
        Ok(Scene {
            model,
            elimination,
            terms,
            base,
            coordinates,
            rules: rules.clone(),
            overrides: Vec::new(),
            quantities: OnceCell::new(),
            quantities_now: OnceCell::new(),
            frames: std::array::from_fn(|_| OnceCell::new()),
            axes: std::array::from_fn(|_| OnceCell::new()),
            turns: OnceCell::new(),
            angular_velocities: std::array::from_fn(|_| OnceCell::new()),
            place: RefCell::new(Place::default()),
            crowd: RefCell::new(None),
            crowded: Cell::new(false),
            following: RefCell::new(Vec::new()),
            followed: RefCell::new(BTreeMap::new()),
            cubatures: RefCell::new(FxHashMap::default()),
            body: None,
            tensors: RefCell::new(Vec::new()),
            memo: RefCell::new(FxHashMap::default()),
            values: RefCell::new(FxHashMap::default()),
            integrals: RefCell::default(),
        })
    }

    /// Lets a body stand in for the particles whose principal axes are spoken of.
    pub(super) fn set_body(&mut self, body: Option<AnyBody<B>>) {
        self.body = body;
        self.forget();
    }

    /// How linear equations are solved here.
    pub(super) fn elimination(&self) -> Elimination {
        self.elimination
    }

    /// The model that the state belongs to.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// Gives a symbol a value of its own, whatever it means, and takes the earlier ones back.
    pub fn set_only(&mut self, overrides: &[(SymbolId, Series<B>)]) {
        self.overrides = overrides.iter().map(|(id, value)| (*id, Value::Scalar(*value))).collect();
        self.forget();
    }

    /// The same for one symbol of any shape.
    pub fn replace(&mut self, id: SymbolId, value: Value<Series<B>>) {
        self.overrides = vec![(id, value)];
        self.forget();
    }

    /// Lets these particles stand in for a family from now on.
    pub fn populate(&self, crowd: Crowd<B>) {
        *self.crowd.borrow_mut() = Some(Arc::new(crowd));
        self.crowded.set(true);
        self.forget();
    }

    /// Takes the particles that stand in for a family back.
    pub fn depopulate(&self) {
        *self.crowd.borrow_mut() = None;
        self.crowded.set(false);
        self.forget();
    }

    /// The coordinates as functions of time.
    pub fn coordinates(&self) -> &[Series<B>] {
        &self.coordinates
    }

    /// What the world determines here, if there is one.
    pub fn quantities(&self) -> Option<&Quantities<Series<B>>> {
        let compute = || {
            let world = self.model.world.as_ref()?;
            let (q, v) = (&self.coordinates, self.velocities());
            Some(Box::new(world.quantities(self.time(), q, &v, &self.parameters())))
        };
        self.quantities.get_or_init(compute).as_deref()
    }

    /// The same as values alone.
    fn quantities_now(&self) -> Option<&Quantities<Instant<B>>> {
        let compute = || {
            let world = self.model.world.as_ref()?;
            let derivative = |order: usize| -> Option<Vec<_>> {
                self.coordinates.iter().map(|q| q.rate(order).map(Instant)).collect()
            };
            let parameters: Vec<_> =
                self.model.parameters.iter().map(|place| Instant(self.base.constant(*place)[0])).collect();
            let time = Instant(self.base.time);
            Some(Box::new(world.quantities(time, &derivative(0)?, &derivative(1)?, &parameters)))
        };
        self.quantities_now.get_or_init(compute).as_deref()
    }

    /// What the world says of a quantity, as a value alone, where it is one of those that it gives all at once.
    pub(super) fn quantity_now(&self, quantity: Quantity, indices: &[u8]) -> Option<Value<Instant<B>>> {
        match quantity {
            Quantity::SpaceAxes | Quantity::EffectivePotential => None,
            quantity => one_of(self.quantities_now()?, quantity, indices),
        }
    }

    /// The Euler–Lagrange residuals of the world at this state, one a coordinate.
    pub fn euler_lagrange(&self) -> Option<Vec<B>> {
        let world = self.model.world.as_ref()?;
        let derivative = |order: usize| -> Option<Vec<B>> {
            self.coordinates.iter().map(|q| q.nth_derivative_value(order)).collect()
        };
        let parameters: Vec<B> = self.model.parameters.iter().map(|place| self.base.constant(*place)[0]).collect();
        let (q, v, a) = (derivative(0)?, derivative(1)?, derivative(2)?);
        Some(world.euler_lagrange(self.base.time, &q, &v, &parameters, &a))
    }

    fn time(&self) -> Series<B> {
        Series::time(self.base.time).truncated(self.terms)
    }

    /// What does not vary, known as far as what does.
    pub(super) fn constant(&self, value: B) -> Series<B> {
        Series::constant(value).truncated(self.terms)
    }

    /// The k-th unit vector.
    fn unit(&self, k: usize) -> Vector3<Series<B>> {
        Vector3::from_fn(|i, _| self.constant(if i == k { B::one() } else { B::zero() }))
    }

    fn velocities(&self) -> Vec<Series<B>> {
        self.coordinates.iter().map(Series::derivative).collect()
    }

    fn parameters(&self) -> Vec<Series<B>> {
        self.model.parameters.iter().map(|place| self.constant(self.base.constant(*place)[0])).collect()
    }

    /// The document's frame, of which so many terms are used; there may be more.
    fn frame(&self, terms: usize) -> Option<&Frame<B>> {
        let terms = terms.min(self.terms + 1);
        let known = || self.frames.get(terms..)?.iter().find_map(OnceCell::get);
        let compute = || self.base.frame(self.model.frame?, terms).map(Box::new);
        match known() {
            Some(known) => known.as_deref(),
            None => self.frames.get(terms)?.get_or_init(compute).as_deref(),
        }
    }

    /// The coefficients, of an order, of the axes of the document's frame, as rows: of order 0 the axes at the instant.
    pub(super) fn axes(&self, order: usize) -> Option<&Matrix3<Instant<B>>> {
        let known = || self.frames[1..].iter().find_map(|frame| frame.get()?.as_ref());
        let compute = || {
            let frame = match order {
                0 if known().is_none() => return self.base.axes(self.model.frame?).map(Box::new),
                0 => known()?,
                order if order < self.terms => self.frame(order + 1)?,
                _ => return None,
            };
            let all = frame.orientation();
            let is_there = all.iter().all(|entry| entry.coefficient(order).is_some());
            is_there.then(|| Box::new(all.map(|entry| Instant(entry.coefficient(order).unwrap_or(B::zero())))))
        };
        self.axes.get(order)?.get_or_init(compute).as_deref()
    }

    /// The angular velocity of the document's frame at the instant.
    pub(super) fn turns(&self) -> Option<Vector3<Instant<B>>> {
        let compute = || {
            let frame = self.frame(2)?;
            let rate = self.axes(1)?.map(|entry| Instant(Series::rate_of(entry.0, 1)));
            Some(rotations::angular_velocity(&frame.orientation().map(|entry| Instant(entry.value())), &rate))
        };
        *self.turns.get_or_init(compute)
    }

    /// Whether no particles stand in for those of a family.
    pub(super) fn is_uncrowded(&self) -> bool {
        self.crowd.borrow().is_none()
    }

    /// The angular velocity of the document's frame, of which so many terms are used; there may be more.
    fn angular_velocity(&self, terms: usize) -> Option<Vector3<Series<B>>> {
        let terms = terms.min(self.terms);
        let compute = || self.frame(terms + 1).map(|frame| Box::new(frame.angular_velocity()));
        self.angular_velocities.get(terms)?.get_or_init(compute).as_deref().copied()
    }

    fn quantity(&self, quantity: Quantity, id: SymbolId, indices: &[u8]) -> Valued<B> {
        let none = || Unavailable::Symbol(id);
        let place = |at: usize| indices.get(at).map(|index| usize::from(*index) - 1).ok_or_else(none);
        if quantity == Quantity::SpaceAxes {
            return Ok(Value::Vector(self.unit(place(0)?)));
        }
        if quantity == Quantity::EffectivePotential {
            let world = self.model.world.as_ref().ok_or_else(none)?;
            let v = self.velocities();
            let (time, parameters) = (self.time(), self.parameters());
            let value = match self.elimination {
                Elimination::Pivots => world.effective_potential(time, &self.coordinates, &v, &parameters),
                Elimination::Cramer => world.effective_potential_exactly(time, &self.coordinates, &v, &parameters),
            };
            return value.map(Value::Scalar).map_err(|_| none());
        }
        self.quantities().and_then(|all| one_of(all, quantity, indices)).ok_or_else(none)
    }

    /// Forgets what was computed for other values.
    fn forget(&self) {
        self.forget_values();
        self.followed.borrow_mut().clear();
        self.cubatures.borrow_mut().clear();
        self.tensors.borrow_mut().clear();
    }

    pub(super) fn forget_values(&self) {
        self.memo.borrow_mut().clear();
        self.values.borrow_mut().clear();
        self.integrals.borrow_mut().clear();
    }

    /// Where a member of a family stands among the others.
    pub(super) fn place_of(&self, id: SymbolId, indices: &[u8]) -> usize {
        let symbols = &self.model.symbols;
        let upper = |letter: &IndexId| usize::from(symbols.indices[letter.0].upper);
        let slots = &symbols.entry(id).slots;
        indices.iter().zip(slots).fold(0, |at, (i, (_, letter))| at * upper(letter) + usize::from(*i) - 1)
    }

    /// A symbol whose numbers stand one after the other.
    fn numbers(&self, id: SymbolId, indices: &[u8], pick: impl Fn(usize) -> Option<Series<B>>) -> Valued<B> {
        let place = self.place_of(id, indices);
        if self.model.symbols.entry(id).kind != Kind::Vector {
            return pick(place).map(Value::Scalar).ok_or(Unavailable::Symbol(id));
        }
        match (pick(3 * place), pick(3 * place + 1), pick(3 * place + 2)) {
            (Some(x), Some(y), Some(z)) => Ok(Value::Vector(Vector3::new(x, y, z))),
            _ => Err(Unavailable::Symbol(id)),
        }
    }

    /// A symbol by its meaning alone, of which so many terms are used.
    pub(super) fn raw(&self, id: SymbolId, indices: &[u8], terms: usize) -> Valued<B> {
        let none = || Unavailable::Symbol(id);
        let entry = self.model.symbols.entry(id);
        if let Some(member) = self.stand_in(id, indices, Value::clone) {
            return Ok(member);
        }
        let fixed = |numbers: &[B]| self.numbers(id, indices, |at| numbers.get(at).map(|x| self.constant(*x)));
        match self.model.meaning(id).ok_or_else(none)? {
            Meaning::Coordinate(i) => Ok(Value::Scalar(self.coordinates[*i])),
            Meaning::Constant(i) => fixed(self.base.constant(*i)),
            Meaning::Varying(i) => {
                let known = self.terms.min(terms);
                self.numbers(id, indices, |at| self.base.varying(*i, at, known))
            }
            Meaning::Time => Ok(Value::Scalar(self.time())),
            Meaning::World(quantity) => self.quantity(*quantity, id, indices),
            Meaning::Defined(formula) => {
                let free: Vec<(IndexId, u8)> =
                    entry.slots.iter().map(|(_, letter)| *letter).zip(indices.iter().copied()).collect();
                let outer = self.crowded.get();
                if let Some(crowd) = self.crowd.borrow().as_ref().filter(|crowd| crowd.stands_in_partly()) {
                    self.crowded.set(self.model.depends_on(formula, &crowd.symbols()));
                }
                let value = self.formula_to(terms, formula, &free);
                self.crowded.set(outer);
                value
            }
            Meaning::Rotation(..) => Err(none()),
            Meaning::FixedAxis(k) => Ok(Value::Vector(self.unit(*k))),
            Meaning::Frame(FrameQuantity::Angle) => self
                .base
                .frame_angles
                .first()
                .map(|angle| angle.truncated(self.terms))
                .map(Value::Scalar)
                .ok_or_else(none),
            Meaning::Frame(FrameQuantity::AngularVelocity) => {
                Ok(Value::Vector(self.angular_velocity(terms).ok_or_else(none)?))
            }
            Meaning::Frame(FrameQuantity::Axes) => {
                let at = indices.first().map(|index| usize::from(*index) - 1).ok_or_else(none)?;
                Ok(Value::Vector(self.frame(terms).ok_or_else(none)?.orientation().row(at).transpose()))
            }
            Meaning::Rigid(i) => {
                let Value::Vector(fixed) = fixed(self.base.rigid(*i))? else { return Err(none()) };
                let orientation = self.frame(terms).ok_or_else(none)?.orientation().map(|entry| entry.truncated(terms));
                let turned = orientation.transpose() * fixed;
                match self.model.rigid[*i].about {
                    None => Ok(Value::Vector(turned)),
                    Some(about) => {
                        let sum = self.symbol_to(about, &[], terms)?.plus(Value::Vector(turned));
                        sum.ok_or(Unavailable::Operation("a sum of different shapes"))
                    }
                }
            }
            Meaning::Particles(quantity, label, masses, positions) => {
                self.of_particles(*quantity, (*label, masses, positions), (id, indices), terms)
            }
            Meaning::Region(at) => self.size_of_part(*at).map(Value::Scalar).ok_or_else(none),
            Meaning::Density(at) => self.density(*at).map(Value::Scalar).ok_or_else(none),
            Meaning::Point => self.point().map(Value::Vector).ok_or_else(none),
        }
    }

    /// Whether what a symbol stands for may be kept for the next time that it is asked for.
    fn keeps(&self, id: SymbolId) -> bool {
        let costly =
            matches!(self.model.meaning(id), Some(Meaning::Defined(_) | Meaning::Particles(..) | Meaning::Rigid(_)))
                || self.rules.iter().any(|rule| rule.symbol == id);
        costly && self.place.borrow().is_default()
    }

    /// What a symbol is kept under, if it is.
    pub(super) fn key(&self, id: SymbolId, indices: &[u8]) -> Option<Key> {
        if indices.len() > 3 || self.is_replaced(id) || !self.keeps(id) {
            return None;
        }
        let mut values = [0; 3];
        values[..indices.len()].copy_from_slice(indices);
        Some(((id, values), self.crowded.get()))
    }

    /// The value that is kept, or else what is computed now.
    pub(super) fn remember(
        &self,
        key: Key,
        compute: impl FnOnce() -> Result<Value<Instant<B>>, Unavailable>,
    ) -> Result<Value<Instant<B>>, Unavailable> {
        if let Some(value) = self.values.borrow().get(&key) {
            return Ok(value.clone());
        }
        let known = self.memo.borrow().get(&key).map(|(_, value)| first(value));
        let value = known.map_or_else(compute, Ok)?;
        self.values.borrow_mut().insert(key, value.clone());
        Ok(value)
    }

    /// The value of a symbol after all rules.
    pub(super) fn ruled_value(&self, id: SymbolId, indices: &[u8]) -> Result<Value<Instant<B>>, Unavailable> {
        let direct = if self.is_free(id) { self.drawn(id, indices, 0) } else { None };
        direct.map_or_else(|| Ok(first(&self.ruled(id, indices, self.rules.len(), 1)?)), Ok)
    }

    fn is_replaced(&self, id: SymbolId) -> bool {
        self.overrides.iter().any(|(known, _)| *known == id)
    }

    /// Whether a symbol was given no value of its own, and no rule says what it is.
    pub(super) fn is_free(&self, id: SymbolId) -> bool {
        !self.is_replaced(id) && !self.rules.iter().any(|rule| rule.symbol == id)
    }

    /// What is made of the particle that stands in for a member of a family, if one does.
    pub(super) fn stand_in<T>(&self, id: SymbolId, indices: &[u8], take: impl Fn(&Value<Series<B>>) -> T) -> Option<T> {
        let crowd = self.crowd.borrow();
        let everywhere = crowd.as_ref().filter(|_| self.crowded.get());
        everywhere.and_then(|crowd| crowd.member(id, indices)).map(&take).or_else(|| {
            let place = self.place.borrow();
            place.part.as_ref().and_then(|part| part.crowd.member(id, indices)).map(&take)
        })
    }

    /// How many derivatives are known of what is drawn, the value counted.
    pub(super) fn terms(&self) -> usize {
        self.terms
    }

    /// The matrix that an elementary rotation's symbol stands for.
    pub(super) fn turned<D: Number>(&self, id: SymbolId, angle: D) -> Result<Matrix3<D>, Unavailable> {
        match self.model.meaning(id) {
            Some(Meaning::Rotation(axis, Turning::Axes)) => Ok(rotations::of_the_axes(*axis, angle)),
            Some(Meaning::Rotation(axis, Turning::Vectors)) => Ok(rotations::of_the_vectors(*axis, angle)),
            _ => Err(Unavailable::Symbol(id)),
        }
    }

    /// Whether no particles stand in for others, and none are being followed.
    pub(super) fn is_alone(&self) -> bool {
        self.crowd.borrow().is_none() && !self.is_following()
    }

    /// Whether symbols that follow a law are known in part.
    pub(super) fn is_following(&self) -> bool {
        !self.following.borrow().is_empty()
    }

    /// Lets the rules that join families take effect: their members stand in for the family that is joined.
    pub(super) fn join(&self) -> Result<(), Unavailable> {
        let unions: Vec<&Rule> = self.rules.iter().filter(|rule| matches!(rule.action, Action::Union(_))).collect();
        if unions.is_empty() {
            return Ok(());
        }
        let mut members = Vec::new();
        let mut label = None;
        for rule in unions {
            let (Action::Union(parts), [letter]) = (&rule.action, rule.letters.as_slice()) else { continue };
            label = Some(*letter);
            let mut joined = Vec::new();
            for part in parts {
                for value in 1..=self.count(*letter)? {
                    joined.push(evaluate(part, self, &[(*letter, value)])?);
                }
            }
            members.push((rule.symbol, joined));
        }
        if let Some(label) = label {
            *self.crowd.borrow_mut() = Some(Arc::new(Crowd::joined(members, label)));
            self.forget();
        }
        Ok(())
    }
}

/// One of the quantities that a world determines.
fn one_of<D: Number>(all: &Quantities<D>, quantity: Quantity, indices: &[u8]) -> Option<Value<D>> {
    let place = |at: usize| indices.get(at).map(|index| usize::from(*index) - 1);
    Some(match quantity {
        Quantity::Lagrangian => Value::Scalar(all.lagrangian),
        Quantity::KineticEnergy => Value::Scalar(all.kinetic?),
        Quantity::PotentialEnergy => Value::Scalar(all.potential?),
        Quantity::Energy => Value::Scalar(all.energy),
        Quantity::Momentum(i) => Value::Scalar(*all.momenta.get(i)?),
        Quantity::RotationMatrix => match indices {
            [] => matrix(all.orientation.as_ref()?),
            _ => Value::Scalar(all.orientation.as_ref()?[(place(0)?, place(1)?)]),
        },
        Quantity::AngularVelocity => match indices {
            [] => Value::Vector(all.angular_velocity?),
            _ => Value::Scalar(all.body_rates.as_ref()?[place(0)?]),
        },
        Quantity::BodyAxes => Value::Vector(all.orientation.as_ref()?.row(place(0)?).transpose()),
        Quantity::EffectivePotential | Quantity::SpaceAxes => return None,
    })
}

pub(super) fn matrix<D: Number>(m: &Matrix3<D>) -> Value<D> {
    Value::Matrix(DMatrix::from_fn(3, 3, |i, j| m[(i, j)]))
}

impl<B: Number> Environment<Series<B>> for Scene<'_, B> {
    fn symbols(&self) -> &Symbols {
        &self.model.symbols
    }

    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Valued<B> {
        self.symbol_to(id, indices, ALL)
    }

    fn symbol_to(&self, id: SymbolId, indices: &[u8], terms: usize) -> Valued<B> {
        let cut = |value: &mut Value<Series<B>>| value.for_each(|x| x.truncate(terms));
        let cut_clone = |value: &Value<Series<B>>| {
            let mut value = value.clone();
            cut(&mut value);
            Ok(value)
        };
        if let Some((_, value)) = self.overrides.iter().find(|(known, _)| *known == id) {
            return cut_clone(value);
        }
        let Some(key) = self.key(id, indices) else {
            let mut value = self.ruled(id, indices, self.rules.len(), terms);
            if let Ok(value) = &mut value {
                cut(value);
            }
            return value;
        };
        if terms == 1 {
            return self.kept_value(id, indices);
        }
        if let Some((_, value)) = self.memo.borrow().get(&key).filter(|(known, _)| *known >= terms) {
            return cut_clone(value);
        }
        let mut value = self.ruled(id, indices, self.rules.len(), terms);
        if let Ok(value) = &mut value {
            cut(value);
            self.memo.borrow_mut().insert(key, (terms, Box::new(value.clone())));
        }
        value
    }

    fn count(&self, index: IndexId) -> Result<u8, Unavailable> {
        let entry = &self.model.symbols.indices[index.0];
        if self.crowded.get()
            && let Some(crowd) = self.crowd.borrow().as_ref()
            && self.model.symbols.same_range(crowd.label, index)
        {
            return Ok(crowd.len());
        }
        let Some(count) = entry.count else { return Ok(entry.upper) };
        match self.value(count)? {
            Value::Scalar(n) => Ok((n.0.re() as u8).clamp(1, entry.upper)),
            _ => Err(Unavailable::Symbol(count)),
        }
    }

    fn integral(&self, region: SymbolId, _integrand: Option<&Expr>, body: Body<'_, Series<B>>) -> Valued<B> {
        self.integrate(region, body, |x| self.constant(x))
    }

    fn shrinking(&self, region: SymbolId, body: Body<'_, Series<B>>) -> Valued<B> {
        self.shrink(region, body)
    }

    fn count_within(&self, region: SymbolId) -> Result<u8, Unavailable> {
        let Some(Meaning::Region(at)) = self.model.meaning(region) else { return Err(Unavailable::Symbol(region)) };
        let place = self.place.borrow();
        let part = place.part.as_ref().filter(|part| part.of == *at);
        part.map(|part| part.crowd.len()).ok_or(Unavailable::Symbol(region))
    }

    fn rotation(&self, id: SymbolId, angle: Series<B>) -> Result<Matrix3<Series<B>>, Unavailable> {
        self.turned(id, angle)
    }
}
