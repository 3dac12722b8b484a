//! The numbers that fix a state, in their order, and what they are put together to.

use std::cell::{OnceCell, RefCell};

use nalgebra::{Matrix3, Vector3};

use crate::formula::SymbolId;
use crate::mechanics;
use crate::mechanics::rotations::euler_angles;
use crate::notes::claims::Range;
use crate::scalar::{Number, Series, TERMS};

use super::model::{Frame, Model, Variable};
use super::scene::Mode;

/// One number of a base.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The symbol whose value or derivative it is; none for the time and for what has no name.
    pub symbol: Option<SymbolId>,
    /// The order of the derivative.
    pub order: usize,
    /// Where it is drawn from.
    pub range: Range,
    /// Whether it is a constant.
    pub constant: bool,
    /// Whether it is one of many of its kind: of a vector, a family, a body.
    pub one_of_many: bool,
}

/// Numbers of one kind: so many, each with so many derivatives.
struct Group {
    symbol: Option<SymbolId>,
    range: Range,
    constant: bool,
    numbers: usize,
    derivatives: usize,
}

/// The groups of a base, in order: time, constants, what is fixed in the frame and its direction, continua; coordinates,
/// free functions and the angles of the frame with their derivatives.
fn groups(model: &Model, mode: Mode) -> impl Iterator<Item = Group> {
    let fixed = |symbol, range, numbers| Group { symbol, range, constant: true, numbers, derivatives: 0 };
    let moving = |variable: &Variable, derivatives| Group {
        symbol: Some(variable.symbol),
        range: variable.range.clone(),
        constant: false,
        numbers: variable.numbers,
        derivatives,
    };
    let time = [Group { constant: false, ..fixed(None, Range::Any, 1) }];
    let constants = model.constants.iter().map(move |c| fixed(Some(c.symbol), c.range.clone(), c.numbers));
    let rigid = model.rigid.iter().map(move |rigid| fixed(Some(rigid.symbol), Range::Any, 3 * rigid.members));
    let direction = (model.frame == Some(Frame::FixedDirection)).then(|| fixed(None, Range::Any, 3));
    let continua = model.continua.iter().flat_map(move |_| {
        let within = |half: f64| Range::Interval { low: -half, high: half, low_open: false, high_open: false };
        let ranges = [
            (Range::Positive, 1),
            (within(0.3), 9),
            (Range::Positive, 3),
            (Range::Any, 3),
            (Range::Angle, 3),
            (within(0.3), 3),
        ];
        ranges.map(|(range, numbers)| fixed(None, range, numbers))
    });
    let on_shell = mode.on_shell && model.world.is_some();
    let coordinates = model.coordinates.iter().map(move |v| moving(v, if on_shell { 1 } else { mode.order }));
    let varying = model.varying.iter().map(move |v| moving(v, mode.order));
    let angles = model.frame.map(|frame| Group {
        symbol: None,
        range: Range::Angle,
        constant: false,
        numbers: if frame == Frame::Free { 3 } else { 1 },
        derivatives: (mode.order + 1).min(TERMS - 1),
    });
    let fixed = time.into_iter().chain(constants).chain(rigid).chain(direction).chain(continua);
    fixed.chain(coordinates).chain(varying).chain(angles)
}

/// The numbers of a base, one by one.
pub fn slots(model: &Model, mode: Mode) -> Vec<Slot> {
    let mut slots = Vec::new();
    for Group { symbol, range, constant, numbers, derivatives } in groups(model, mode) {
        for _ in 0..numbers {
            for order in 0..=derivatives {
                let range = if order == 0 { range.clone() } else { Range::Any };
                let one_of_many = numbers > 1 || symbol.is_none();
                slots.push(Slot { symbol, order, range, constant, one_of_many });
            }
        }
    }
    slots
}

/// Where the direction stands that the frame turns about, if it does.
pub fn direction(model: &Model) -> Option<std::ops::Range<usize>> {
    if model.frame != Some(Frame::FixedDirection) {
        return None;
    }
    let constants: usize = model.constants.iter().map(|constant| constant.numbers).sum();
    let rigid: usize = model.rigid.iter().map(|rigid| 3 * rigid.members).sum();
    let first = 1 + constants + rigid;
    Some(first..first + 3)
}

/// A base, sorted by what its numbers are.
pub struct Base<B> {
    /// The time.
    pub time: B,
    /// The numbers of each constant.
    pub constants: Vec<Vec<B>>,
    /// The components, along the frame, of what is fixed in it.
    pub rigid: Vec<Vec<B>>,
    /// The direction that the frame turns about, of any length.
    pub direction: [B; 3],
    /// What fixes each continuum.
    pub continua: Vec<Hidden<B>>,
    /// The derivatives of each coordinate: on shell no more than the first.
    pub coordinates: Vec<Vec<B>>,
    /// The free functions of time.
    pub varying: Vec<Jets<B>>,
    /// The angles of the frame.
    pub frame_angles: Vec<Series<B>>,
}

/// Numbers with their derivatives, one after the other.
pub struct Jets<B> {
    numbers: Vec<B>,
    /// How many belong to one.
    jet: usize,
    /// The same as functions of time, of those that were asked for.
    series: RefCell<Vec<Option<Series<B>>>>,
}

impl<B: Number> Jets<B> {
    fn new(numbers: &[B], jet: usize) -> Self {
        Jets { numbers: numbers.to_vec(), jet, series: RefCell::new(Vec::new()) }
    }

    /// One of them as a function of time.
    pub fn series(&self, at: usize) -> Option<Series<B>> {
        self.series_to(at, TERMS)
    }

    /// The same, known to no more than so many terms.
    pub fn series_to(&self, at: usize, terms: usize) -> Option<Series<B>> {
        self.of(at, |series| Some(series.truncated(terms)))
    }

    /// The k-th derivative of one of them, if it is known.
    pub fn rate(&self, at: usize, k: usize) -> Option<B> {
        self.of(at, |series| series.rate(k))
    }

    fn of<T>(&self, at: usize, take: impl FnOnce(&Series<B>) -> Option<T>) -> Option<T> {
        let mut known = self.series.borrow_mut();
        if known.is_empty() {
            known.resize(self.numbers.len() / self.jet, None);
        }
        let slot = known.get_mut(at)?;
        if slot.is_none() {
            *slot = self.numbers.get(at * self.jet..(at + 1) * self.jet).map(Series::from_derivatives);
        }
        take(slot.as_ref()?)
    }
}

/// What fixes a continuum of which nothing is said: a density that varies, sizes, a place, an orientation.
pub struct Hidden<B> {
    /// The density in the middle, and the coefficients of what is linear and quadratic in the place.
    pub density: [B; 10],
    /// The lengths of its edges.
    pub edges: [B; 3],
    /// Where its middle is.
    pub middle: Vector3<B>,
    /// The Euler angles of its axes.
    pub angles: [B; 3],
    /// A point in it, as shares of the edges from the middle.
    pub point: [B; 3],
    /// Q, once it was asked for.
    turned: OnceCell<Matrix3<B>>,
}

impl<B: Number> Hidden<B> {
    /// Q, which turns it from its canonical position.
    pub fn turned(&self) -> &Matrix3<B> {
        let [phi, theta, psi] = self.angles;
        self.turned.get_or_init(|| euler_angles(phi, theta, psi).transpose())
    }
}

impl<B: Number> Base<B> {
    /// Sorts the numbers of a base; what is missing is not a number.
    pub fn of(model: &Model, mode: Mode, numbers: &[B]) -> Self {
        let mut groups = groups(model, mode);
        let mut rest = numbers;
        // Group after group, number after number, derivative after derivative.
        let mut next = || {
            let (count, jet) = groups.next().map_or((0, 1), |group| (group.numbers, group.derivatives + 1));
            let (numbers, more) = rest.split_at((count * jet).min(rest.len()));
            rest = more;
            Jets::new(numbers, jet)
        };
        fn few<B: Number, const N: usize>(jets: &Jets<B>) -> [B; N] {
            std::array::from_fn(|i| jets.numbers.get(i).copied().unwrap_or(B::from(f64::NAN)))
        }
        let [time] = few(&next());
        let constants = model.constants.iter().map(|_| next().numbers).collect();
        let rigid = model.rigid.iter().map(|_| next().numbers).collect();
        let direction = match model.frame {
            Some(Frame::FixedDirection) => few(&next()),
            _ => [B::zero(); 3],
        };
        let hidden = |_| {
            let (middle_density, coefficients) = (next(), next());
            let [first] = few(&middle_density);
            let others: [B; 9] = few(&coefficients);
            let density = std::array::from_fn(|k| if k == 0 { first } else { others[k - 1] });
            let (edges, middle, angles, point) = (next(), next(), next(), next());
            Hidden {
                density,
                edges: few(&edges),
                middle: Vector3::from(few(&middle)),
                angles: few(&angles),
                point: few(&point),
                turned: OnceCell::new(),
            }
        };
        let continua = model.continua.iter().map(hidden).collect();
        let coordinates = model.coordinates.iter().map(|_| next().numbers).collect();
        let varying = model.varying.iter().map(|_| next()).collect();
        let frame_angles = match model.frame {
            Some(_) => {
                let angles = next();
                (0..angles.numbers.len() / angles.jet).filter_map(|at| angles.series(at)).collect()
            }
            None => Vec::new(),
        };
        Base { time, constants, rigid, direction, continua, coordinates, varying, frame_angles }
    }

    /// The frame that turns by these numbers, its angles known to so many terms.
    pub fn frame(&self, frame: Frame, terms: usize) -> Option<mechanics::Frame<B>> {
        let angles: Vec<Series<B>> = self.frame_angles.iter().map(|angle| angle.truncated(terms)).collect();
        match (frame, angles.as_slice()) {
            (Frame::Free, [phi, theta, psi]) => Some(mechanics::Frame::freely([*phi, *theta, *psi])),
            (Frame::FixedDirection, [angle]) => mechanics::Frame::about(self.direction, *angle).ok(),
            _ => None,
        }
    }
}
