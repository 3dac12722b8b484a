//! The residual of a claim at a state: whether its two sides agree.
//!
//! A residual is compared with the size of the terms on both sides ([`RunningError`]). It is rounding error, a clear
//! difference, or doubtful in between. One doubtful state is enough to withhold a pass, so a large common offset never
//! makes two sides equal.
//!
//! # When two numbers agree
//!
//! A residual is relative to the magnitudes of both sides, and falls into one of three zones: below 10⁻¹⁴ it is
//! *rounding*, some forty roundings of a double; above 10⁻¹¹ it is a *difference*; in between the state is
//! *doubtful*, and one doubtful state prevents a pass. With a single threshold, a true difference of 10⁻¹⁰ under a
//! large offset passed. An absolute tolerance would accept 10⁻³⁰ = 2·10⁻³⁰ and reject equal numbers of size 10¹².
//! Two NaN do not agree: a state where neither side has a value does not count, and one where a single side has a
//! value makes the verdict `domain`. A pass needs eight states.

use approx::{AbsDiffEq, abs_diff_eq};

use crate::formula::evaluate::{Environment, Unavailable};
use crate::formula::shape::Shape;
use crate::formula::{Expr, IndexId, Relation, Value};
use crate::scalar::{Number, RunningError};

use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::state::sampled_state::SampledState;

/// The relative size up to which a residual is rounding error: about forty roundings of a double. Identities stay far
/// below.
pub const ROUNDING: f64 = 1e-14;

/// The relative size from which a residual is a difference.
pub const DIFFERENCE: f64 = 1e-11;

/// The result of testing a link at a state.
#[derive(Clone, Debug, PartialEq)]
pub enum Point {
    /// The relation holds, with this relative residual.
    Holds(f64),
    /// The relation fails.
    Fails(Failure),
    /// One side has a value here and the other has none.
    OneSided(Failure),
    /// The sides differ by more than rounding error and by less than a clear difference.
    Doubtful,
    /// Neither side has a value here.
    Useless,
}

/// The failure of a link at a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The left side's value.
    pub lhs: f64,
    /// The right side's value.
    pub rhs: f64,
    /// The residual relative to the scale.
    pub residual: f64,
    /// The entry of a vector, matrix or family that fails.
    pub entry: Option<String>,
}

impl Failure {
    /// What is said of a failure where one side alone has a value.
    pub(crate) fn domain_message(&self) -> String {
        let side = if self.lhs.is_finite() { "right" } else { "left" };
        format!(
            "the two sides agree where both are defined, but the {side} side is not defined everywhere; restrict the \
             ranges, or state the condition under which it holds"
        )
    }
}

/// A number with its scale, compared with `approx` on that scale.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scaled {
    value: f64,
    scale: f64,
}

impl AbsDiffEq for Scaled {
    type Epsilon = f64;
    fn default_epsilon() -> f64 {
        ROUNDING
    }
    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        abs_diff_eq!(self.value, other.value, epsilon = epsilon * (self.scale + other.scale))
    }
}

/// Whether a value that should be zero is within rounding error.
pub fn vanishes(value: RunningError) -> bool {
    abs_diff_eq!(Scaled { value: value.value, scale: value.magnitude }, Scaled { value: 0.0, scale: 0.0 })
        || value.value == 0.0
}

/// Whether a difference of two sides satisfies an inequality, clearly.
pub fn holds(relation: Relation, difference: RunningError) -> bool {
    let clear = difference.value.abs() > DIFFERENCE * difference.magnitude;
    match relation {
        Relation::Less => clear && difference.value < 0.0,
        Relation::Greater => clear && difference.value > 0.0,
        Relation::LessEqual => vanishes(difference) || clear && difference.value < 0.0,
        Relation::GreaterEqual => vanishes(difference) || clear && difference.value > 0.0,
        Relation::NotEqual => clear,
        Relation::Equal | Relation::Identical | Relation::Approximately | Relation::Proportional => {
            vanishes(difference)
        }
    }
}

/// The margin of an inequality: positive where it holds, negative where it fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// The margin relative to the terms of the sides.
    pub share: f64,
    /// The margin itself.
    pub size: f64,
}

/// The values of the two sides of a link at a state, for all values of its free indices: mutants share one of them.
pub struct Sides {
    lhs: Vec<Value<RunningError>>,
    rhs: Vec<Value<RunningError>>,
}

impl Sides {
    /// Evaluates the sides of a link at a state.
    pub fn of(link: &Link, state: &SampledState<'_, RunningError>) -> Result<Self, Unavailable> {
        let mut sides = Sides { lhs: Vec::new(), rhs: Vec::new() };
        let mut indices: Vec<(IndexId, u8)> = link.free.iter().map(|id| (*id, 1)).collect();
        loop {
            sides.lhs.push(state.now(&link.lhs, &indices)?);
            sides.rhs.push(state.now(&link.rhs, &indices)?);
            if !advance(&mut indices, state)? {
                return Ok(sides);
            }
        }
    }

    /// The smallest margin of an inequality between scalars, over the free indices.
    pub fn margin(self, relation: Relation) -> Option<Margin> {
        let mut least: Option<Margin> = None;
        for (lhs, rhs) in self.lhs.into_iter().zip(self.rhs) {
            let (Value::Scalar(a), Value::Scalar(b)) = (lhs, rhs) else { return None };
            let difference = match relation {
                Relation::Less | Relation::LessEqual => b.value - a.value,
                Relation::Greater | Relation::GreaterEqual => a.value - b.value,
                Relation::NotEqual => (a.value - b.value).abs(),
                _ => return None,
            };
            let scale = a.magnitude + b.magnitude;
            let share = if scale > 0.0 { difference / scale } else { 0.0 };
            if !share.is_finite() {
                return None;
            }
            if least.is_none_or(|least| share < least.share) {
                least = Some(Margin { share, size: difference });
            }
        }
        least
    }
}

/// Tests a link at a state whose sides are known.
pub fn test_sides(link: &Link, sides: &Sides, state: &SampledState<'_, RunningError>) -> Result<Point, Unavailable> {
    test_knowing(link, state, (Some(&sides.lhs), Some(&sides.rhs)), false)
}

/// Tests a link at a state, for all values of its free indices and entry by entry.
pub fn test(link: &Link, state: &SampledState<'_, RunningError>) -> Result<Point, Unavailable> {
    test_knowing(link, state, (None, None), false)
}

/// Tests a mutant of a link at a state, where the sides of the link may be known. The test stops at the first entry
/// that fails, so the failure need not be the clearest one.
pub fn test_mutant(
    mutant: &Link,
    link: &Link,
    sides: Option<&Sides>,
    state: &SampledState<'_, RunningError>,
) -> Result<Point, Unavailable> {
    let lhs = sides.filter(|_| mutant.lhs == link.lhs).map(|sides| sides.lhs.as_slice());
    let rhs = sides.filter(|_| mutant.rhs == link.rhs).map(|sides| sides.rhs.as_slice());
    test_knowing(mutant, state, (lhs, rhs), true)
}

/// The known values of a side, in the order of the values of the free indices.
type Known<'a> = Option<&'a [Value<RunningError>]>;

fn test_knowing(
    link: &Link,
    state: &SampledState<'_, RunningError>,
    (known_lhs, known_rhs): (Known<'_>, Known<'_>),
    to_the_first: bool,
) -> Result<Point, Unavailable> {
    let mut worst = Point::Holds(0.0);
    let mut indices: Vec<(IndexId, u8)> = link.free.iter().map(|id| (*id, 1)).collect();
    for at in 0.. {
        let side = |expr: &Expr, known: Known<'_>, indices: &[(IndexId, u8)]| match known.and_then(|all| all.get(at)) {
            Some(value) => Ok(value.clone()),
            None => state.now(expr, indices),
        };
        let (lhs, rhs) = (side(&link.lhs, known_lhs, &indices)?, side(&link.rhs, known_rhs, &indices)?);
        let shape = if link.lhs.is_zero() { rhs.shape() } else { lhs.shape() };
        let (a, b) = pair(lhs, rhs);
        for (k, (a, b)) in a.into_iter().zip(b).enumerate() {
            let found = compare(link.relation, a, b, || entry_label(state, &indices, shape, k));
            worst = worse(worst, found);
            if to_the_first && !matches!(worst, Point::Holds(_) | Point::Useless) {
                return Ok(worst);
            }
        }
        if !advance(&mut indices, state)? {
            break;
        }
    }
    Ok(worst)
}

/// The name of an entry of a side for these values of the free indices: `i = 1, component 2`.
pub(crate) fn entry_label<B: Number>(
    state: &SampledState<'_, B>,
    indices: &[(IndexId, u8)],
    shape: Shape,
    k: usize,
) -> Option<String> {
    let letters = indices.iter().map(|(id, value)| format!("{} = {value}", state.model().symbols.indices[id.0].letter));
    let all: Vec<String> = letters.chain(Value::<f64>::entry_name(shape, k)).collect();
    (!all.is_empty()).then(|| all.join(", "))
}

/// The entries of two sides. A literal 0 or 1 takes the shape of the other side.
pub fn pair<B: Number>(lhs: Value<B>, rhs: Value<B>) -> (Vec<B>, Vec<B>) {
    let (a_shape, b_shape) = (lhs.shape(), rhs.shape());
    let (a, b) = (lhs.entries(), rhs.entries());
    let spread = |literal: B, shape: Shape| -> Vec<B> {
        match shape {
            Shape::Scalar | Shape::Abstract => vec![literal],
            Shape::Vector => vec![literal; 3],
            Shape::Complex => vec![literal, B::zero()],
            Shape::Matrix(rows, columns) => {
                (0..rows * columns).map(|k| if k / columns == k % columns { literal } else { B::zero() }).collect()
            }
        }
    };
    match (a_shape, b_shape) {
        (Shape::Scalar, other) if other != Shape::Scalar => (spread(a[0], other), b),
        (other, Shape::Scalar) if other != Shape::Scalar => (a, spread(b[0], other)),
        _ => (a, b),
    }
}

fn compare(relation: Relation, a: RunningError, b: RunningError, entry: impl Fn() -> Option<String>) -> Point {
    let finite = (a.value.is_finite(), b.value.is_finite());
    let scale = a.magnitude + b.magnitude;
    let residual = if scale > 0.0 { (a.value - b.value).abs() / scale } else { 0.0 };
    let failure = || Failure { lhs: a.value, rhs: b.value, residual, entry: entry() };
    match finite {
        _ if a.is_unknown() || b.is_unknown() => Point::Useless,
        (true, true) if !scale.is_finite() => Point::Useless,
        (true, true) => {
            let difference = RunningError { value: a.value - b.value, magnitude: scale };
            match relation {
                Relation::Equal | Relation::Identical | Relation::Approximately | Relation::Proportional => {
                    if vanishes(difference) {
                        Point::Holds(residual)
                    } else if residual > DIFFERENCE {
                        Point::Fails(failure())
                    } else {
                        Point::Doubtful
                    }
                }
                relation if holds(relation, difference) => Point::Holds(0.0),
                _ if residual > DIFFERENCE || vanishes(difference) => Point::Fails(failure()),
                _ => Point::Doubtful,
            }
        }
        (false, false) => Point::Useless,
        _ => Point::OneSided(failure()),
    }
}

fn worse(a: Point, b: Point) -> Point {
    let rank = |point: &Point| match point {
        Point::Holds(_) => 0,
        Point::Useless => 1,
        Point::Doubtful => 2,
        Point::OneSided(_) => 3,
        Point::Fails(_) => 4,
    };
    match (&a, &b) {
        (Point::Holds(x), Point::Holds(y)) => Point::Holds(x.max(*y)),
        (Point::Fails(x), Point::Fails(y)) if y.residual > x.residual => b,
        _ if rank(&b) > rank(&a) => b,
        _ => a,
    }
}

/// Advances the free indices to their next values; returns false after the last.
pub fn advance<B: Number>(indices: &mut [(IndexId, u8)], state: &SampledState<'_, B>) -> Result<bool, Unavailable> {
    for (id, value) in indices.iter_mut() {
        if *value < state.count(*id)? {
            *value += 1;
            return Ok(true);
        }
        *value = 1;
    }
    Ok(false)
}

/// Whether all defined names of a claim have a value at a state. A claim says nothing where a quantity that it names does not
/// exist.
pub(crate) fn has_its_names(link: &Link, state: &SampledState<'_, RunningError>) -> bool {
    let mut names: Vec<&Expr> = Vec::new();
    let mut all = true;
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |part| {
            let is_defined = |id| matches!(state.model().meaning(id), Some(Meaning::Defined(_)));
            if part.as_plain_symbol().is_some_and(is_defined) && !names.contains(&part) {
                names.push(part);
                let value = state.now(part, &[]);
                all &= value.is_ok_and(|value| value.entries().iter().all(|entry| entry.value.is_finite()));
            }
        });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_offset_makes_a_state_doubtful_and_never_equal() {
        let one = RunningError::new(1e12) + RunningError::new(3.0);
        let other = RunningError::new(1e12) + RunningError::new(2.9);
        assert_eq!(compare(Relation::Equal, one, other, || None), Point::Doubtful);
        assert!(matches!(compare(Relation::Equal, one, one, || None), Point::Holds(_)));
    }

    #[test]
    fn two_sides_without_a_value_do_not_agree() {
        let nan = RunningError::new(f64::NAN);
        assert_eq!(compare(Relation::Equal, nan, nan, || None), Point::Useless);
        assert!(matches!(compare(Relation::Equal, nan, RunningError::new(1.0), || None), Point::OneSided(_)));
    }

    #[test]
    fn tiny_numbers_are_told_apart() {
        let (a, b) = (RunningError::new(1e-30), RunningError::new(2e-30));
        assert!(matches!(compare(Relation::Equal, a, b, || None), Point::Fails(_)));
    }
}
