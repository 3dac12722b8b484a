//! Bodies as weighted nodes: a point and a weight each, so that a sum over nodes is an integral over the body.
//!
//! The nodes of a [`Body`] are a cubature: Σ w f(x) *is* ∫ f for polynomials up to a stated degree. Its [`cells`] are
//! an approximation that becomes the integral as they get smaller. Both are written for a body of unit size in `f64`
//! and scaled by numbers of any kind, so that an integral can be differentiated by the size of the body.
//!
//! Weights are elements of volume, area or length; times a density they are masses, and then [`Nodes`] are particles.
//!
//! [`cells`]: Body::cells

use nalgebra::{Matrix3, Vector3};

use super::rules::{gauss_legendre, interval, sphere};
use crate::scalar::{Number, each};

/// A uniform body in its canonical position: centred at the origin; a rod along z, a lamina and a disc in the xy plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body<D> {
    /// A solid box with edges along x, y, z; its weights are volumes.
    Box {
        /// The lengths of the edges.
        edges: [D; 3],
    },
    /// A solid ball; its weights are volumes.
    Ball {
        /// Its radius.
        radius: D,
    },
    /// A thin spherical shell; its weights are areas.
    Shell {
        /// Its radius.
        radius: D,
    },
    /// A thin rod along z; its weights are lengths.
    Rod {
        /// Its length, half of it on either side of the origin.
        length: D,
    },
    /// A thin rectangle in the xy plane; its weights are areas.
    Lamina {
        /// The lengths of the edges along x and y.
        edges: [D; 2],
    },
    /// A thin disc in the xy plane; its weights are areas.
    Disc {
        /// Its radius.
        radius: D,
    },
}

impl<D: Number> Body<D> {
    /// Over how many dimensions an integral over the body goes: 3 for volumes, 2 for areas, 1 for lengths.
    pub fn dimension(&self) -> usize {
        match self {
            Body::Box { .. } | Body::Ball { .. } => 3,
            Body::Shell { .. } | Body::Lamina { .. } | Body::Disc { .. } => 2,
            Body::Rod { .. } => 1,
        }
    }

    /// Nodes that integrate every polynomial in x, y, z up to the total degree `degree` exactly.
    pub fn nodes(&self, degree: usize) -> Nodes<D> {
        self.scaled(self.unit().unit_nodes(degree))
    }

    /// The body of this form of unit edges or radius.
    fn unit(&self) -> Body<f64> {
        match self {
            Body::Box { .. } => Body::Box { edges: [1.0; 3] },
            Body::Ball { .. } => Body::Ball { radius: 1.0 },
            Body::Shell { .. } => Body::Shell { radius: 1.0 },
            Body::Rod { .. } => Body::Rod { length: 1.0 },
            Body::Lamina { .. } => Body::Lamina { edges: [1.0; 2] },
            Body::Disc { .. } => Body::Disc { radius: 1.0 },
        }
    }

    /// The body cut into k equal cells along each of its edges (k³, k² or k cells): their midpoints, and their volume,
    /// area or length. The sum differs from the integral by O(1/k²). Only what has edges: a box, a lamina, a rod.
    pub fn cells(&self, k: usize) -> Option<Nodes<D>> {
        self.unit().unit_cells(k).map(|cells| self.scaled(cells))
    }

    /// Nodes of the body of unit edges or radius, at the size of this one.
    fn scaled(&self, unit: Vec<(Vector3<f64>, f64)>) -> Nodes<D> {
        let one = D::one();
        let (sizes, measure) = match *self {
            Body::Box { edges: [a, b, c] } => ([a, b, c], a * b * c),
            Body::Ball { radius } => ([radius; 3], radius * radius * radius),
            Body::Shell { radius } | Body::Disc { radius } => ([radius; 3], radius * radius),
            Body::Rod { length } => ([one, one, length], length),
            Body::Lamina { edges: [a, b] } => ([a, b, one], a * b),
        };
        let of = |at: &Vector3<f64>, i: usize| sizes[i] * at[i];
        let node =
            |(at, weight): &(Vector3<f64>, f64)| (Vector3::new(of(at, 0), of(at, 1), of(at, 2)), measure * *weight);
        Nodes { points: each(&unit, &node) }
    }
}

// The rules are doubles whatever the number of the size is.
impl Body<f64> {
    fn unit_nodes(&self, degree: usize) -> Vec<(Vector3<f64>, f64)> {
        match self {
            Body::Box { .. } | Body::Lamina { .. } | Body::Rod { .. } => {
                let segment: Vec<_> = gauss_legendre(degree / 2 + 1).iter().map(|(x, w)| (x / 2.0, w / 2.0)).collect();
                grid(&segment, self.edges())
            }
            Body::Ball { .. } => {
                // odd powers of r vanish in the angles, so that ∫₀¹ r² dr is half of ∫₋₁¹: an even number of nodes
                let radii = gauss_legendre(2 * ((degree + 3).div_ceil(4)));
                let (sphere, radii) = (sphere(degree), radii.into_iter().filter(|(r, _)| *r > 0.0));
                radii.flat_map(|(r, w)| sphere.iter().map(move |(x, area)| (x * r, area * w * r * r))).collect()
            }
            Body::Shell { .. } => sphere(degree),
            Body::Disc { .. } => {
                // the same in s = r²: ∫₀¹ r dr = ½ ∫₀¹ ds
                let (squares, turns) = (interval(degree / 4 + 1), degree + 1);
                let angles = (0..turns).map(|j| std::f64::consts::TAU * j as f64 / turns as f64);
                angles
                    .flat_map(|angle| {
                        let step = std::f64::consts::TAU / turns as f64;
                        let along = Vector3::new(angle.cos(), angle.sin(), 0.0);
                        squares.iter().map(move |(s, w)| (along * s.sqrt(), 0.5 * w * step))
                    })
                    .collect()
            }
        }
    }

    fn unit_cells(&self, k: usize) -> Option<Vec<(Vector3<f64>, f64)>> {
        let segment: Vec<_> = (0..k).map(|i| ((i as f64 + 0.5) / k as f64 - 0.5, 1.0 / k as f64)).collect();
        let edges = self.edges();
        (!edges.is_empty()).then(|| grid(&segment, edges))
    }

    /// The coordinate axes along which it has edges; none if it is round.
    fn edges(&self) -> &'static [usize] {
        match self {
            Body::Box { .. } => &[0, 1, 2],
            Body::Lamina { .. } => &[0, 1],
            Body::Rod { .. } => &[2],
            Body::Ball { .. } | Body::Shell { .. } | Body::Disc { .. } => &[],
        }
    }
}

/// The product of a rule for a segment with itself, along each of the coordinate axes named.
fn grid(segment: &[(f64, f64)], axes: &[usize]) -> Vec<(Vector3<f64>, f64)> {
    let mut nodes = vec![(Vector3::zeros(), 1.0)];
    for &axis in axes {
        let further = |&(at, weight): &(Vector3<f64>, f64)| {
            segment.iter().map(move |&(x, w)| (at + Vector3::ith(axis, x), weight * w))
        };
        nodes = nodes.iter().flat_map(further).collect();
    }
    nodes
}

/// Points with weights: a body for integrals, or particles with masses. A weight may be negative, as in a bubble.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nodes<D> {
    /// The points in fixed axes, each with its weight.
    pub points: Vec<(Vector3<D>, D)>,
}

impl<D: Number> Nodes<D> {
    /// Σ w f(x).
    pub fn integral(&self, f: impl Fn(&Vector3<D>) -> D) -> D {
        let mut sum = D::zero();
        for (x, w) in &self.points {
            sum += *w * f(x);
        }
        sum
    }

    /// Σ w: the volume, area, length or mass.
    pub fn total(&self) -> D {
        self.integral(|_| D::one())
    }

    /// The same points, each weight times a density there.
    pub fn with_density(mut self, density: impl Fn(&Vector3<D>) -> D) -> Self {
        for (x, weight) in &mut self.points {
            *weight *= density(x);
        }
        self
    }

    /// Every point x moved to x + d.
    pub fn moved(mut self, by: &Vector3<D>) -> Self {
        for (x, _) in &mut self.points {
            *x += by;
        }
        self
    }

    /// Every point x turned to Q x about the origin. Q turns vectors: for a frame it is the transpose of its R.
    pub fn turned(mut self, by: &Matrix3<D>) -> Self {
        for (x, _) in &mut self.points {
            *x = by * *x;
        }
        self
    }

    /// This and the other together. Where they overlap, both count.
    pub fn united(mut self, other: Nodes<D>) -> Self {
        self.points.extend(other.points);
        self
    }

    /// This with the other taken away: its weights count negative. It should lie within.
    pub fn without(mut self, other: Nodes<D>) -> Self {
        self.points.extend(each(&other.points, &|(x, weight)| (*x, -*weight)));
        self
    }
}
