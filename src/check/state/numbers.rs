//! The numbers that fix a state, in their order, and the values that they form.

use nalgebra::{Matrix3, Vector3};
use std::cell::{OnceCell, RefCell};
use std::ops::Range;
use std::sync::Arc;

use crate::formula::SymbolId;
use crate::mechanics;
use crate::mechanics::rotations::euler_angles;
use crate::notes::claims;
use crate::scalar::{Number, Primal, Series, TERMS};

use crate::check::model::Model;
use crate::check::model::meaning::{Frame, Variable};
use crate::check::model::sampling::Mode;

/// The description of one number of a base.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The symbol whose value or derivative it is; none for the time and for numbers without a name.
    pub symbol: Option<SymbolId>,
    /// The order of the derivative.
    pub order: usize,
    /// The range from which it is drawn.
    pub range: claims::Range,
    /// Whether it is a constant.
    pub constant: bool,
    /// Whether it is one of several numbers of a vector, a family or a body.
    pub one_of_many: bool,
}

/// Numbers of one kind, each with the same number of derivatives.
struct Group<'m> {
    symbol: Option<SymbolId>,
    range: &'m claims::Range,
    constant: bool,
    numbers: usize,
    derivatives: usize,
}

/// The groups of a base, in order: time, constants, vectors fixed in the frame, the direction of the frame, continua;
/// then coordinates, free functions and the angles of the frame, each with their derivatives.
fn groups(model: &Model, mode: Mode) -> impl Iterator<Item = Group<'_>> {
    const ANY: &claims::Range = &claims::Range::Any;
    const POSITIVE: &claims::Range = &claims::Range::Positive;
    const ANGLE: &claims::Range = &claims::Range::Angle;
    const WITHIN: &claims::Range = &claims::Range::Interval { low: -0.3, high: 0.3, low_open: false, high_open: false };
    let fixed = |symbol, range, numbers| Group { symbol, range, constant: true, numbers, derivatives: 0 };
    fn moving(variable: &Variable, derivatives: usize) -> Group<'_> {
        let Variable { symbol, range, numbers, .. } = variable;
        Group { symbol: Some(*symbol), range, constant: false, numbers: *numbers, derivatives }
    }
    let time = [Group { constant: false, ..fixed(None, ANY, 1) }];
    let constants = model.constants.iter().map(move |c| fixed(Some(c.symbol), &c.range, c.numbers));
    let rigid = model.rigid.iter().map(move |rigid| fixed(Some(rigid.symbol), ANY, 3 * rigid.members));
    let direction = (model.frame == Some(Frame::FixedDirection)).then(|| fixed(None, ANY, 3));
    let continua = model.continua.iter().flat_map(move |_| {
        let ranges = [(POSITIVE, 1), (WITHIN, 9), (POSITIVE, 3), (ANY, 3), (ANGLE, 3), (WITHIN, 3)];
        ranges.map(|(range, numbers)| fixed(None, range, numbers))
    });
    let on_shell = mode.on_shell && model.system.is_some();
    let coordinates = model.coordinates.iter().map(move |v| moving(v, if on_shell { 1 } else { mode.order }));
    let varying = model.varying.iter().map(move |v| moving(v, mode.order));
    let angles = model.frame.map(|frame| Group {
        symbol: None,
        range: ANGLE,
        constant: false,
        numbers: if frame == Frame::Free { 3 } else { 1 },
        derivatives: (mode.order + 1).min(TERMS - 1),
    });
    let fixed = time.into_iter().chain(constants).chain(rigid).chain(direction).chain(continua);
    fixed.chain(coordinates).chain(varying).chain(angles)
}

/// The descriptions of the numbers of a base, in order.
pub fn slots(model: &Model, mode: Mode) -> Vec<Slot> {
    let mut slots = Vec::new();
    for Group { symbol, range, constant, numbers, derivatives } in groups(model, mode) {
        for _ in 0..numbers {
            for order in 0..=derivatives {
                let range = if order == 0 { range.clone() } else { claims::Range::Any };
                let one_of_many = numbers > 1 || symbol.is_none();
                slots.push(Slot { symbol, order, range, constant, one_of_many });
            }
        }
    }
    slots
}

/// The places of the direction about which the frame turns, if it turns about a fixed direction.
pub fn direction(model: &Model) -> Option<std::ops::Range<usize>> {
    if model.frame != Some(Frame::FixedDirection) {
        return None;
    }
    let constants: usize = model.constants.iter().map(|constant| constant.numbers).sum();
    let rigid: usize = model.rigid.iter().map(|rigid| 3 * rigid.members).sum();
    let first = 1 + constants + rigid;
    Some(first..first + 3)
}

/// The places of the numbers of each symbol in a base: the same for all states of a mode.
pub struct Layout {
    time: Range<usize>,
    constants: Vec<Range<usize>>,
    rigid: Vec<Range<usize>>,
    direction: Option<Range<usize>>,
    continua: Vec<[Range<usize>; 6]>,
    coordinates: Vec<Range<usize>>,
    varying: Vec<Jets>,
    angles: Option<Jets>,
    /// The number of numbers, and the number of free functions of time.
    counts: (usize, usize),
}

/// The places of numbers with their derivatives.
struct Jets {
    /// The places in the base.
    numbers: Range<usize>,
    /// The number of places for one number with its derivatives.
    jet: usize,
    /// The place of the first of them among all functions of time.
    first: usize,
}

impl Layout {
    /// The layout of the states of a mode.
    pub fn of(model: &Model, mode: Mode) -> Arc<Self> {
        let mut groups = groups(model, mode);
        let (mut done, mut functions) = (0, 0);
        // Group after group, number after number, derivative after derivative.
        let mut jets = || {
            let (count, jet) = groups.next().map_or((0, 1), |group| (group.numbers, group.derivatives + 1));
            done += count * jet;
            Jets { numbers: done - count * jet..done, jet, first: 0 }
        };
        let mut next = || jets().numbers;
        let time = next();
        let constants = model.constants.iter().map(|_| next()).collect();
        let rigid = model.rigid.iter().map(|_| next()).collect();
        let direction = (model.frame == Some(Frame::FixedDirection)).then(&mut next);
        let continua = model.continua.iter().map(|_| std::array::from_fn(|_| next())).collect();
        let coordinates = model.coordinates.iter().map(|_| next()).collect();
        let function = |variable: &Variable| {
            let first = functions;
            functions += variable.numbers;
            Jets { first, ..jets() }
        };
        let varying = model.varying.iter().map(function).collect();
        let angles = model.frame.map(|_| jets());
        let counts = (done, functions);
        Arc::new(Layout { time, constants, rigid, direction, continua, coordinates, varying, angles, counts })
    }
}

/// A base: the numbers that fix a state, sorted by meaning.
pub struct Base<B> {
    /// All numbers, in their order.
    numbers: Vec<B>,
    layout: Arc<Layout>,
    /// The time.
    pub time: B,
    /// The direction about which the frame turns, of any length.
    pub direction: [B; 3],
    /// The numbers of each continuum.
    pub continua: Vec<UnspecifiedContinuum<B>>,
    /// The free functions of time that have been evaluated.
    series: RefCell<Vec<Option<Series<B>>>>,
    /// The angles of the frame.
    pub frame_angles: Vec<Series<B>>,
}

/// The random numbers of a continuum without a declared shape: a varying density, sizes, a position, an orientation.
pub struct UnspecifiedContinuum<B> {
    /// The density in the middle, then the linear and quadratic coefficients of the density in the position.
    pub density: [B; 10],
    /// The lengths of the edges.
    pub edges: [B; 3],
    /// The position of the middle.
    pub middle: Vector3<B>,
    /// The Euler angles of the axes.
    pub angles: [B; 3],
    /// A point in it, as fractions of the edges from the middle.
    pub point: [B; 3],
    /// The rotation, once it has been computed.
    turned: OnceCell<Matrix3<B>>,
}

/// An array of the numbers, padded with NaN.
fn padded<B: Number, const N: usize>(numbers: &[B]) -> [B; N] {
    std::array::from_fn(|i| numbers.get(i).copied().unwrap_or(B::from(f64::NAN)))
}

impl<B: Number> UnspecifiedContinuum<B> {
    /// The continuum of these groups of numbers.
    fn of([density, coefficients, edges, middle, angles, point]: [&[B]; 6]) -> Self {
        let ([first], others): ([B; 1], [B; 9]) = (padded(density), padded(coefficients));
        UnspecifiedContinuum {
            density: std::array::from_fn(|k| if k == 0 { first } else { others[k - 1] }),
            edges: padded(edges),
            middle: Vector3::from(padded(middle)),
            angles: padded(angles),
            point: padded(point),
            turned: OnceCell::new(),
        }
    }

    /// The rotation Q that turns it from its canonical orientation.
    pub fn turned(&self) -> &Matrix3<B> {
        let [phi, theta, psi] = self.angles;
        self.turned.get_or_init(|| euler_angles(phi, theta, psi).transpose())
    }
}

impl<B: Number> Base<B> {
    /// Sorts the numbers of a base; missing numbers are NaN.
    pub fn of(layout: &Arc<Layout>, numbers: &[B]) -> Self {
        let mut numbers = numbers.to_vec();
        numbers.resize(layout.counts.0, B::from(f64::NAN));
        let part = |range: &Range<usize>| &numbers[range.clone()];
        let [time] = padded(part(&layout.time));
        let direction = layout.direction.as_ref().map_or([B::zero(); 3], |range| padded(part(range)));
        let continua =
            layout.continua.iter().map(|ranges| UnspecifiedContinuum::of(ranges.each_ref().map(part))).collect();
        let series =
            |angles: &Jets| part(&angles.numbers).chunks_exact(angles.jet).map(Series::from_derivatives).collect();
        let frame_angles = layout.angles.as_ref().map_or(Vec::new(), series);
        let (layout, series) = (layout.clone(), RefCell::new(Vec::new()));
        Base { numbers, layout, time, direction, continua, series, frame_angles }
    }

    /// All numbers, in their order.
    pub fn numbers(&self) -> &[B] {
        &self.numbers
    }

    /// The numbers of a constant.
    pub fn constant(&self, i: usize) -> &[B] {
        &self.numbers[self.layout.constants[i].clone()]
    }

    /// The components, along the frame, of a vector that is fixed in it.
    pub fn rigid(&self, i: usize) -> &[B] {
        &self.numbers[self.layout.rigid[i].clone()]
    }

    /// The value and derivatives of each coordinate: on shell up to the first derivative.
    pub fn coordinates(&self) -> impl Iterator<Item = &[B]> {
        self.layout.coordinates.iter().map(|jet| &self.numbers[jet.clone()])
    }

    /// One of the numbers of a free function of time, as a series of at most this number of terms.
    pub fn varying(&self, i: usize, at: usize, terms: usize) -> Option<Series<B>> {
        self.as_series(i, at, |series| Some(series.truncated(terms)))
    }

    /// The k-th derivative of one of the numbers of a free function of time, if it is known.
    pub fn rate(&self, i: usize, at: usize, k: usize) -> Option<B> {
        self.as_series(i, at, |series| series.rate(k))
    }

    fn as_series<T>(&self, i: usize, at: usize, take: impl FnOnce(&Series<B>) -> Option<T>) -> Option<T> {
        let Jets { numbers, jet, first } = &self.layout.varying[i];
        let derivatives = self.numbers[numbers.clone()].get(at * jet..(at + 1) * jet)?;
        let mut known = self.series.borrow_mut();
        known.resize(self.layout.counts.1, None);
        take(known.get_mut(first + at)?.get_or_insert_with(|| Series::from_derivatives(derivatives)))
    }

    /// The axes of the turning frame at the instant.
    pub fn axes(&self, frame: Frame) -> Option<Matrix3<Primal<B>>> {
        let angle = |angle: &Series<B>| Primal(angle.value());
        match (frame, self.frame_angles.as_slice()) {
            (Frame::Free, [phi, theta, psi]) => Some(euler_angles(angle(phi), angle(theta), angle(psi))),
            (Frame::FixedDirection, [by]) => mechanics::axes_about(self.direction, angle(by), Primal).ok(),
            _ => None,
        }
    }

    /// The turning frame, with angles to this number of terms.
    pub fn frame(&self, frame: Frame, terms: usize) -> Option<mechanics::Frame<B>> {
        let angles: Vec<Series<B>> = self.frame_angles.iter().map(|angle| angle.truncated(terms)).collect();
        match (frame, angles.as_slice()) {
            (Frame::Free, [phi, theta, psi]) => Some(mechanics::Frame::from_euler_angles([*phi, *theta, *psi])),
            (Frame::FixedDirection, [angle]) => mechanics::Frame::about(self.direction, *angle).ok(),
            _ => None,
        }
    }
}
