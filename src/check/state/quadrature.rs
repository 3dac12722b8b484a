//! Quadrature at a sampled state: integrals over continua, sums over cells, limits of shrinking parts, inertia tensors.
//!
//! An integral over a continuum is a sum over the nodes of a cubature. At each node the point and the density are those
//! of the node. The same continuum can be divided into cells, which are particles. The sum over the particles
//! approaches the integral as the cells get smaller; a claim of this kind is checked so. A density is the limit of a
//! shrinking *part* of the continuum around a point.

use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

use crate::formula::evaluate::Body as Integrand;
use crate::formula::evaluate::{Environment, Unavailable, evaluate, evaluate_to};
use crate::formula::{Expr, IndexId, SymbolId, Value};
use crate::mechanics::inertia::{inertia_tensor, principal_axes};
use crate::mechanics::{Body, Nodes};
use crate::notes::claims::SolidKind;
use crate::scalar::{Number, Series};

use crate::check::model::meaning::{Continuum, Meaning, ParticleQuantity};
use crate::check::state::generic_body::GenericBody;
use crate::check::state::numbers::UnspecifiedContinuum;
use crate::check::state::particles::{Part, Particles};
use crate::check::state::sampled_state::SampledState;
use crate::check::state::values::matrix;

/// The degree of the integrand up to which an integral is exact.
const DEGREE: usize = 5;

/// The higher degree at which integrals over declared solids are computed again. If the two differ, neither is exact.
const FINER: usize = 11;

/// A value, or the reason why there is none.
type Valued<B> = Result<Value<Series<B>>, Unavailable>;

impl<B: Number> UnspecifiedContinuum<B> {
    fn place(&self, shares: [B; 3]) -> Vector3<B> {
        self.turned() * Vector3::from_fn(|i, _| shares[i] * self.edges[i]) + self.middle
    }

    /// The density at a point: a polynomial of degree 2 in the position, in units of the edges.
    fn density(&self, x: &Vector3<B>, dimension: u8) -> B {
        let local = self.turned().transpose() * (x - self.middle);
        let u: [B; 3] =
            std::array::from_fn(|i| if i < dimension.into() { local[i] / self.edges[i] } else { B::zero() });
        let c = &self.density;
        let linear = c[1] * u[0] + c[2] * u[1] + c[3] * u[2];
        let squares = c[4] * u[0] * u[0] + c[5] * u[1] * u[1] + c[6] * u[2] * u[2];
        let mixed = c[7] * u[0] * u[1] + c[8] * u[1] * u[2] + c[9] * u[2] * u[0];
        c[0] * (linear + squares + mixed + B::one())
    }

    /// A box, a rectangle or a segment of this fraction of the edges, in canonical position, where a rod lies along z.
    fn body(&self, dimension: u8, share: f64) -> Body<B> {
        let edges = self.edges.map(|edge| edge * share);
        match dimension {
            3 => Body::Box { edges },
            2 => Body::Lamina { edges: [edges[0], edges[1]] },
            _ => Body::Rod { length: edges[0] },
        }
    }

    /// Nodes moved from canonical position to the continuum, around a point of it.
    fn set(&self, nodes: Nodes<B>, dimension: u8, around: &Vector3<B>) -> Nodes<B> {
        let along_x = |x: Vector3<B>| if dimension == 1 { Vector3::new(x.z, x.x, x.y) } else { x };
        let points = nodes.points.into_iter().map(|(x, w)| (along_x(x), w)).collect();
        Nodes { points }.turned(self.turned()).moved(around)
    }
}

/// The positions and masses of `count` particles; `None` if they are not vectors and scalars.
fn masses_at<D: Number>(
    count: u8,
    at: impl Fn(u8) -> Result<(Value<D>, Value<D>), Unavailable>,
) -> Result<Option<Nodes<D>>, Unavailable> {
    let mut points = Vec::new();
    for value in 1..=count {
        match at(value)? {
            (Value::Vector(x), Value::Scalar(m)) => points.push((x, m)),
            _ => return Ok(None),
        }
    }
    Ok(Some(Nodes { points }))
}

impl<B: Number> SampledState<'_, B> {
    fn continuum(&self, region: SymbolId) -> Result<(usize, &Continuum), Unavailable> {
        match self.model.meaning(region) {
            Some(Meaning::Region(at)) => Ok((*at, &self.model.continua[*at])),
            _ => Err(Unavailable::Symbol(region)),
        }
    }

    /// The nodes of a continuum; their weights are volumes, areas or lengths.
    fn nodes(&self, at: usize, degree: usize) -> Result<Nodes<B>, Unavailable> {
        let (continuum, hidden) = (&self.model.continua[at], &self.base.continua[at]);
        if continuum.solids.is_empty() {
            let nodes = hidden.body(continuum.dimension, 1.0).nodes(degree);
            return Ok(hidden.set(nodes, continuum.dimension, &hidden.middle));
        }
        let mut all = Nodes { points: Vec::new() };
        for solid in &continuum.solids {
            let mut sizes = Vec::new();
            for size in &solid.sizes {
                match evaluate(size, self, &[])? {
                    Value::Scalar(size) => sizes.push(size.value()),
                    _ => return Err(Unavailable::Operation("a size that is not a scalar")),
                }
            }
            let body = match (solid.kind, sizes.as_slice()) {
                (SolidKind::Ball, [radius]) => Body::Ball { radius: *radius },
                (SolidKind::Shell, [radius]) => Body::Shell { radius: *radius },
                (SolidKind::Disc, [radius]) => Body::Disc { radius: *radius },
                (SolidKind::Rod, [length]) => Body::Rod { length: *length },
                (SolidKind::Lamina, [a, b]) => Body::Lamina { edges: [*a, *b] },
                (SolidKind::Box, [a, b, c]) => Body::Box { edges: [*a, *b, *c] },
                _ => return Err(Unavailable::Operation("a solid with this number of sizes")),
            };
            let mut nodes = body.nodes(degree);
            if let Some(center) = &solid.at {
                match evaluate(center, self, &[])? {
                    Value::Vector(center) => nodes = nodes.moved(&center.map(|x| x.value())),
                    _ => return Err(Unavailable::Operation("a center that is not a vector")),
                }
            }
            all = if solid.hollow { all.without(nodes) } else { all.united(nodes) };
        }
        Ok(all)
    }

    fn density_at(&self, at: usize, x: &Vector3<B>) -> B {
        let (continuum, hidden) = (&self.model.continua[at], &self.base.continua[at]);
        match continuum.uniform {
            true => hidden.density[0],
            false => hidden.density(x, continuum.dimension),
        }
    }

    /// The point of a continuum at which a formula outside of integrals is evaluated.
    fn own_point(&self, at: usize) -> Vector3<B> {
        let (continuum, hidden) = (&self.model.continua[at], &self.base.continua[at]);
        let shares = std::array::from_fn(|i| if i < continuum.dimension.into() { hidden.point[i] } else { B::zero() });
        hidden.place(shares)
    }

    /// The density of a continuum at the current point.
    pub(crate) fn density(&self, at: usize) -> Option<Series<B>> {
        let x = match &self.substitutes.location.borrow().point {
            Some((of, x)) if *of == at => *x,
            Some(_) => return None,
            None => self.own_point(at),
        };
        Some(self.constant(self.density_at(at, &x)))
    }

    /// The current point.
    pub(crate) fn point(&self) -> Option<Vector3<Series<B>>> {
        let x = match (&self.substitutes.location.borrow().point, self.base.continua.len()) {
            (Some((_, x)), _) => *x,
            (None, 1) => self.own_point(0),
            _ => return None,
        };
        Some(x.map(|x| self.constant(x)))
    }

    /// The volume, area or length of the current part.
    pub(crate) fn size_of_part(&self, at: usize) -> Option<Series<B>> {
        self.substitutes
            .location
            .borrow()
            .part
            .as_ref()
            .filter(|part| part.of == at)
            .map(|part| self.constant(part.size))
    }

    /// Whether no place in a continuum is set and there are no substitutes.
    pub(crate) fn is_nowhere(&self) -> bool {
        self.substitutes.is_nowhere() && self.is_alone()
    }

    /// An integral over a continuum.
    pub(crate) fn integrate<D: Number>(
        &self,
        region: SymbolId,
        integrand: Integrand<'_, D>,
        constant: &dyn Fn(B) -> D,
    ) -> Result<Value<D>, Unavailable> {
        let (at, continuum) = self.continuum(region)?;
        let (value, _) = self.sum_over_nodes((at, DEGREE), integrand, constant)?;
        if !continuum.solids.is_empty() {
            let (finer, scale) = self.sum_over_nodes((at, FINER), integrand, constant)?;
            let same = |(a, b): (&D, &D)| (a.re() - b.re()).abs() <= 1e-10 * scale;
            if !value.entries().iter().zip(&finer.entries()).all(same) {
                return Err(Unavailable::Operation(
                    "an integral over a solid whose integrand is not a polynomial of the coordinates up to degree 5",
                ));
            }
        }
        Ok(value)
    }

    /// The sum over the nodes of a degree, and the sum of the magnitudes of the terms.
    fn sum_over_nodes<D: Number>(
        &self,
        (at, degree): (usize, usize),
        integrand: Integrand<'_, D>,
        constant: &dyn Fn(B) -> D,
    ) -> Result<(Value<D>, f64), Unavailable> {
        let known = self.memo.nodes.borrow().get(&(at, degree)).cloned();
        let nodes = match known {
            Some(nodes) => nodes,
            None => {
                let nodes = Arc::new(self.nodes(at, degree)?);
                if !self.memo.is_following() {
                    self.memo.nodes.borrow_mut().insert((at, degree), nodes.clone());
                }
                nodes
            }
        };
        let outer = self.substitutes.location.borrow_mut().point.take();
        let mut total: Option<Value<D>> = None;
        let mut scale = 0.0;
        let mut failure = None;
        for &(x, weight) in &nodes.points {
            self.substitutes.location.borrow_mut().point = Some((at, x));
            match integrand() {
                Ok(value) => {
                    let term = value.map(|y| y * constant(weight));
                    scale += term.entries().iter().map(|entry| entry.re().abs()).sum::<f64>();
                    total = match total {
                        None => Some(term),
                        Some(total) => total.plus(term),
                    };
                }
                Err(reason) => {
                    failure = Some(reason);
                    break;
                }
            }
        }
        self.substitutes.location.borrow_mut().point = outer;
        match failure {
            Some(reason) => Err(reason),
            None => Ok((total.ok_or(Unavailable::Operation("an integral over an empty region"))?, scale)),
        }
    }

    /// The limit of a formula as the part of a continuum around its own point shrinks to that point: Richardson
    /// extrapolation from three sizes, which removes the errors of the second and the fourth power of the size.
    pub(crate) fn shrink(&self, region: SymbolId, formula: Integrand<'_, Series<B>>) -> Valued<B> {
        let (at, continuum) = self.continuum(region)?;
        let (mass, position) = continuum.particles.ok_or(Unavailable::Symbol(region))?;
        let label = self.label_of(mass)?;
        let hidden = &self.base.continua[at];
        let around = self.own_point(at);
        let mut values = Vec::new();
        for share in [0.2, 0.1, 0.05] {
            let part = hidden.body(continuum.dimension, share);
            let cells = part.cells(3).ok_or(Unavailable::Operation("a sum over the cells of a body without edges"))?;
            let size = cells.total();
            let cells = hidden.set(cells, continuum.dimension, &around).with_density(|x| self.density_at(at, x));
            let particles = Particles::of(&cells, (mass, position), label, |x| self.constant(x));
            self.substitutes.location.borrow_mut().part = Some(Part { of: at, particles, size });
            let value = formula();
            self.substitutes.location.borrow_mut().part = None;
            values.push(value?);
        }
        let better = |fine: &Value<Series<B>>, coarse: &Value<Series<B>>, power: f64| {
            let (fine, coarse) = (fine.clone().map(|x| x * power), coarse.clone().map(|x| -x));
            fine.plus(coarse).map(|sum| sum.map(|x| x * (1.0 / (power - 1.0))))
        };
        let wrong = || Unavailable::Operation("a sum of numbers and vectors, or of matrices of different sizes");
        let first = better(&values[1], &values[0], 4.0).ok_or_else(wrong)?;
        let second = better(&values[2], &values[1], 4.0).ok_or_else(wrong)?;
        better(&second, &first, 16.0).ok_or_else(wrong)
    }

    fn label_of(&self, family: SymbolId) -> Result<IndexId, Unavailable> {
        let slots = &self.model.symbols.entry(family).slots;
        slots.first().map(|(_, letter)| *letter).ok_or(Unavailable::Symbol(family))
    }

    /// A continuum divided into k cells along each edge, as particles in place of its family.
    pub(crate) fn cut(&self, at: usize, k: usize) -> Result<Particles<B>, Unavailable> {
        let (continuum, hidden) = (&self.model.continua[at], &self.base.continua[at]);
        let families = continuum.particles.ok_or(Unavailable::Symbol(continuum.region))?;
        let label = self.label_of(families.0)?;
        let body = hidden.body(continuum.dimension, 1.0);
        let cells = body.cells(k).ok_or(Unavailable::Operation("a sum over the cells of a body without edges"))?;
        let cells = hidden.set(cells, continuum.dimension, &hidden.middle);
        let cells = cells.with_density(|x| self.density_at(at, x));
        Ok(Particles::of(&cells, families, label, |x| self.constant(x)))
    }

    /// The inertia tensor of point masses to this number of terms, computed once for each family and state.
    fn tensor(
        &self,
        (label, masses, positions): (IndexId, &Expr, &Expr),
        id: SymbolId,
        terms: usize,
    ) -> Result<Matrix3<Series<B>>, Unavailable> {
        let alone = self.substitutes.is_nowhere() && self.is_alone();
        let same = |(m, x, known, _): &&(Expr, Expr, usize, _)| *known >= terms && m == masses && x == positions;
        let known = self.memo.tensors.borrow().iter().find(same).map(|known| known.3);
        if let (Some(known), true) = (known, alone) {
            return Ok(known);
        }
        let count = self.count(label)?;
        let tensor = match terms {
            1 => {
                let now = |formula: &Expr, at: &[_]| self.instant(formula, at);
                let points =
                    masses_at(count, |value| Ok((now(positions, &[(label, value)])?, now(masses, &[(label, value)])?)));
                inertia_tensor(&points?.ok_or(Unavailable::Symbol(id))?).map(|x| Series::of_value(x.0))
            }
            terms => {
                let series = |formula: &Expr, at: &[_]| evaluate_to(terms, formula, self, at);
                let points = masses_at(count, |value| {
                    Ok((series(positions, &[(label, value)])?, series(masses, &[(label, value)])?))
                });
                inertia_tensor(&points?.ok_or(Unavailable::Symbol(id))?)
            }
        };
        if alone {
            self.memo.tensors.borrow_mut().push((masses.clone(), positions.clone(), terms, tensor));
        }
        Ok(tensor)
    }

    /// A quantity of point masses about the origin.
    pub(crate) fn of_particles(
        &self,
        quantity: ParticleQuantity,
        (label, masses, positions): (IndexId, &Expr, &Expr),
        (id, indices): (SymbolId, &[u8]),
        terms: usize,
    ) -> Valued<B> {
        let none = || Unavailable::Symbol(id);
        // Axes and moments have a value only, and no derivatives.
        let terms = if quantity == ParticleQuantity::InertiaTensor { terms } else { 1 };
        let place = |at: usize| indices.get(at).map(|index| usize::from(*index) - 1).ok_or_else(none);
        let of_body = self.substitutes.body.as_ref().and_then(GenericBody::tensor);
        let tensor = match of_body {
            Some(tensor) => tensor.map(Series::of_value),
            None => self.tensor((label, masses, positions), id, terms)?,
        };
        if quantity == ParticleQuantity::InertiaTensor {
            return Ok(match indices {
                [] => matrix(&tensor),
                _ => Value::Scalar(tensor[(place(0)?, place(1)?)]),
            });
        }
        if let Some(body) = &self.substitutes.body {
            return match quantity {
                ParticleQuantity::PrincipalMoments => {
                    body.moment(place(0)?).map(|moment| Value::Scalar(Series::of_value(moment))).ok_or_else(none)
                }
                _ => Ok(Value::Vector(body.axis(place(0)?).map(Series::of_value))),
            };
        }
        // Eigenvectors are computed for plain numbers, so their derivatives are not known.
        let found = principal_axes(&tensor.map(|entry| entry.value().re())).map_err(|_| none())?;
        let known = |x: f64| Series::from_derivatives(&[B::from(x)]);
        // The order of the axes is arbitrary. Each state has another order, so that no claim depends on it.
        const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
        let which = (self.base.time.re().to_bits() >> 20) as usize % ORDERS.len();
        let named = ORDERS[which][place(0)?];
        // An odd order would make the axes left-handed.
        let sign = if which >= 3 && place(0)? == 2 { -1.0 } else { 1.0 };
        Ok(match quantity {
            ParticleQuantity::PrincipalMoments => Value::Scalar(known(found.moments[named])),
            _ => Value::Vector(found.axes.row(named).transpose().map(|x| known(sign * x))),
        })
    }
}
