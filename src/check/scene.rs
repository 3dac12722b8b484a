//! One state of a document's world, in which formulas are evaluated.
//!
//! A state is fixed by its *base*: numbers for the time, the constants, and the derivatives of everything that
//! varies. Off shell the base holds all derivatives up to the order in use; on shell it holds q and q̇, and the Euler–
//! Lagrange equations give the rest. The same code runs over measured numbers (to judge) and dual numbers (to solve
//! conditions for a variable).

use std::cell::OnceCell;

use nalgebra::Matrix3;

use crate::Result;
use crate::formula::evaluate::{Environment, Unavailable, evaluate};
use crate::formula::{SymbolId, Symbols, Value};
use crate::mechanics::{Quantities, rotations};
use crate::notes::claims::{Range, Turning};
use crate::scalar::{Number, Series};

use super::model::{Meaning, Model, Quantity};

/// How states are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mode {
    /// Whether the accelerations obey the Euler–Lagrange equations.
    pub on_shell: bool,
    /// The highest time derivative that is known.
    pub order: usize,
}

/// One number of a base.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The symbol whose value or derivative it is; none for the time.
    pub symbol: Option<SymbolId>,
    /// The order of the derivative.
    pub order: usize,
    /// Where it is drawn from.
    pub range: Range,
    /// Whether it is a constant.
    pub constant: bool,
}

/// The numbers of a base, in order: time, constants, coordinates, free functions with their derivatives.
pub fn slots(model: &Model, mode: Mode) -> Vec<Slot> {
    let mut slots = vec![Slot { symbol: None, order: 0, range: Range::Any, constant: false }];
    for constant in &model.constants {
        let (symbol, range) = (Some(constant.symbol), constant.range.clone());
        slots.push(Slot { symbol, order: 0, range, constant: true });
    }
    let coordinates = model.coordinates.iter().map(|v| (v, if mode.on_shell { 1 } else { mode.order }));
    for (variable, highest) in coordinates.chain(model.varying.iter().map(|v| (v, mode.order))) {
        for order in 0..=highest {
            let range = if order == 0 { variable.range.clone() } else { Range::Any };
            slots.push(Slot { symbol: Some(variable.symbol), order, range, constant: false });
        }
    }
    slots
}

/// A state.
pub struct Scene<'m, B: Number> {
    model: &'m Model,
    time: Series<B>,
    constants: Vec<B>,
    coordinates: Vec<Series<B>>,
    varying: Vec<Series<B>>,
    overrides: Vec<(SymbolId, Series<B>)>,
    quantities: OnceCell<Option<Quantities<Series<B>>>>,
}

impl<'m, B: Number> Scene<'m, B> {
    /// The state with this base.
    ///
    /// # Errors
    /// When the mass matrix is singular there.
    pub fn new(model: &'m Model, mode: Mode, base: &[B]) -> Result<Self> {
        let missing = B::from(f64::NAN);
        let mut base = base.iter().copied();
        let mut take = || base.next().unwrap_or(missing);
        let time = take();
        let constants: Vec<B> = model.constants.iter().map(|_| take()).collect();
        let mut jets = |count: usize, highest: usize| -> Vec<Vec<B>> {
            (0..count).map(|_| (0..=highest).map(|_| take()).collect()).collect()
        };
        let on_shell = mode.on_shell && model.world.is_some();
        let coordinates = jets(model.coordinates.len(), if mode.on_shell { 1 } else { mode.order });
        let varying = jets(model.varying.len(), mode.order);
        let coordinates = match &model.world {
            Some(world) if on_shell => {
                let q: Vec<B> = coordinates.iter().map(|jet| jet[0]).collect();
                let v: Vec<B> = coordinates.iter().map(|jet| jet[1]).collect();
                let parameters: Vec<B> = model.parameters.iter().map(|place| constants[*place]).collect();
                world.motion(time, &q, &v, &parameters, mode.order.max(1))?
            }
            _ => coordinates.iter().map(|jet| Series::from_derivatives(jet)).collect(),
        };
        Ok(Scene {
            model,
            time: Series::time(time),
            constants,
            coordinates,
            varying: varying.iter().map(|jet| Series::from_derivatives(jet)).collect(),
            overrides: Vec::new(),
            quantities: OnceCell::new(),
        })
    }

    /// The model that the state belongs to.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// Gives a symbol a value of its own, whatever it means, and takes the earlier ones back.
    pub fn set_only(&mut self, overrides: &[(SymbolId, Series<B>)]) {
        self.overrides = overrides.to_vec();
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
            Some(world.quantities(self.time, q, &v, &self.parameters()))
        };
        self.quantities.get_or_init(compute).as_ref()
    }

    /// The Euler–Lagrange residuals of the world at this state, one a coordinate.
    pub fn euler_lagrange(&self) -> Option<Vec<B>> {
        let world = self.model.world.as_ref()?;
        let derivative = |order: usize| -> Option<Vec<B>> {
            self.coordinates.iter().map(|q| q.nth_derivative_value(order)).collect()
        };
        let parameters: Vec<B> = self.model.parameters.iter().map(|place| self.constants[*place]).collect();
        let (q, v, a) = (derivative(0)?, derivative(1)?, derivative(2)?);
        Some(world.euler_lagrange(self.time.value(), &q, &v, &parameters, &a))
    }

    fn velocities(&self) -> Vec<Series<B>> {
        self.coordinates.iter().map(Series::derivative).collect()
    }

    fn parameters(&self) -> Vec<Series<B>> {
        self.model.parameters.iter().map(|place| Series::constant(self.constants[*place])).collect()
    }

    fn quantity(&self, quantity: Quantity, id: SymbolId, indices: &[u8]) -> Result<Value<Series<B>>, Unavailable> {
        let none = || Unavailable::Symbol(id);
        let place = |at: usize| indices.get(at).map(|index| usize::from(*index) - 1).ok_or_else(none);
        let all = self.quantities().ok_or_else(none)?;
        Ok(match quantity {
            Quantity::Lagrangian => Value::Scalar(all.lagrangian),
            Quantity::KineticEnergy => Value::Scalar(all.kinetic.ok_or_else(none)?),
            Quantity::PotentialEnergy => Value::Scalar(all.potential.ok_or_else(none)?),
            Quantity::Energy => Value::Scalar(all.energy),
            Quantity::Momentum(i) => Value::Scalar(*all.momenta.get(i).ok_or_else(none)?),
            Quantity::EffectivePotential => {
                let world = self.model.world.as_ref().ok_or_else(none)?;
                let v = self.velocities();
                let value = world.effective_potential(self.time, &self.coordinates, &v, &self.parameters());
                Value::Scalar(value.map_err(|_| none())?)
            }
            Quantity::RotationMatrix => {
                let r = all.orientation.as_ref().ok_or_else(none)?;
                match indices {
                    [] => matrix(r),
                    _ => Value::Scalar(r[(place(0)?, place(1)?)]),
                }
            }
            Quantity::AngularVelocity => match indices {
                [] => Value::Vector(all.angular_velocity.ok_or_else(none)?),
                _ => Value::Scalar(all.body_rates.as_ref().ok_or_else(none)?[place(0)?]),
            },
            Quantity::BodyAxes => Value::Vector(all.orientation.as_ref().ok_or_else(none)?.row(place(0)?).transpose()),
            Quantity::SpaceAxes => {
                let at = place(0)?;
                let unit = |k: usize| Series::constant(if k == at { B::one() } else { B::zero() });
                Value::Vector(nalgebra::Vector3::new(unit(0), unit(1), unit(2)))
            }
        })
    }
}

fn matrix<B: Number>(m: &Matrix3<Series<B>>) -> Value<Series<B>> {
    Value::Matrix(nalgebra::DMatrix::from_fn(3, 3, |i, j| m[(i, j)]))
}

impl<B: Number> Environment<Series<B>> for Scene<'_, B> {
    fn symbols(&self) -> &Symbols {
        &self.model.symbols
    }

    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Result<Value<Series<B>>, Unavailable> {
        if let Some((_, value)) = self.overrides.iter().find(|(known, _)| *known == id) {
            return Ok(Value::Scalar(*value));
        }
        match self.model.meaning(id).ok_or(Unavailable::Symbol(id))? {
            Meaning::Coordinate(i) => Ok(Value::Scalar(self.coordinates[*i])),
            Meaning::Constant(i) => Ok(Value::Scalar(Series::constant(self.constants[*i]))),
            Meaning::Varying(i) => Ok(Value::Scalar(self.varying[*i])),
            Meaning::Time => Ok(Value::Scalar(self.time)),
            Meaning::World(quantity) => self.quantity(*quantity, id, indices),
            Meaning::Defined(formula) => evaluate(formula, self, &[]),
            Meaning::Rotation(..) => Err(Unavailable::Symbol(id)),
        }
    }

    fn rotation(&self, id: SymbolId, angle: Series<B>) -> Result<Matrix3<Series<B>>, Unavailable> {
        match self.model.meaning(id) {
            Some(Meaning::Rotation(axis, Turning::Axes)) => Ok(rotations::of_the_axes(*axis, angle)),
            Some(Meaning::Rotation(axis, Turning::Vectors)) => Ok(rotations::of_the_vectors(*axis, angle)),
            _ => Err(Unavailable::Symbol(id)),
        }
    }
}
