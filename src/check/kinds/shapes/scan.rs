//! The scan of a function of one variable along its range, with the other symbols fixed.
//!
//! The grid is even inside the range and finer towards its ends, and logarithmic for an infinite range. Hypotheses about the
//! variable restrict the range, and the grid is finer towards their edges. Minima, maxima and solutions are counted on a
//! finer grid as well.

use std::cmp::Ordering;

use num_dual::Dual;

use crate::code::Code;
use crate::formula::{Expr, SymbolId};
use crate::latex::typeset;
use crate::notes::claims::Range;
use crate::scalar::RunningError;

use crate::check::kinds::limit::{Towards, sides};
use crate::check::kinds::shapes::enclosed_function::{Course, EnclosedFunction};
use crate::check::kinds::shapes::root_isolation::{count_roots_on_grid, minimum};
use crate::check::kinds::shapes::shape::{Atoms, Shape, Still, Target, difference, value_of};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::sample::sampler::last;
use crate::check::state::residual;
use crate::check::verdict::finding::Compared;

/// The ratio of the finer grid to the usual one.
const FINER: u32 = 3;

/// The number of times that the distance to a limit is halved.
const NEAREST: i32 = 32;

/// The largest absolute value at which roots are searched; the smallest is its inverse.
const ROOTS: f64 = 1e7;

/// The depth of a dip, relative to its edges, below which doubles may take it for a root.
const DIP: f64 = 1e-9;

/// The relative difference above which two values are different.
const CHANGED: f64 = 1e-9;

/// What a scan at one state shows of a claimed shape.
pub(crate) enum Observation {
    /// The function has the shape.
    Holds,
    /// The function has no value there.
    Useless,
    /// Nothing is certain, such as where a finer grid shows another number; the code and the message say why.
    Open(Code, String),
    /// The function does not have the shape.
    Fails {
        /// The value of the variable.
        at: Option<f64>,
        /// The value or number that was found.
        found: f64,
        /// The value or number that is claimed.
        wanted: f64,
        /// What these two are.
        compared: Compared,
        /// The message.
        what: String,
    },
}

/// A function of one variable, with its other atoms fixed.
pub(crate) struct Probe<'a> {
    pub model: &'a Model,
    pub function: &'a Expr,
    pub variable: SymbolId,
    pub atoms: &'a Atoms,
    /// The hypotheses that restrict the variable.
    pub bounds: &'a [&'a Hypothesis],
    /// The symbols for which hypotheses were solved, each with its hypothesis.
    pub solved: &'a [(SymbolId, Hypothesis)],
}

impl Probe<'_> {
    /// Whether the hypotheses allow a value of the variable.
    fn runs_through(&self, x: f64) -> bool {
        if self.bounds.is_empty() {
            return true;
        }
        let atom = |(id, value): &(SymbolId, f64)| (*id, if *id == self.variable { x } else { *value });
        let atoms: Atoms = self.atoms.iter().map(atom).collect();
        self.bounds.iter().all(|hypothesis| {
            difference::<RunningError>(&atoms, hypothesis, self.model, RunningError::new)
                .is_some_and(|difference| residual::holds(hypothesis.relation, difference))
        })
    }

    /// The grid points that the hypotheses allow, interval by interval; `finer` times as many as usual.
    fn pieces(&self, range: &Range, finer: u32) -> Vec<Vec<f64>> {
        let mut points = grid(range, finer);
        if self.bounds.is_empty() {
            return vec![points];
        }
        points.extend(self.atoms.iter().filter(|(id, _)| *id == self.variable).map(|(_, x)| *x));
        points.sort_by(f64::total_cmp);
        let mut pieces: Vec<Vec<f64>> = vec![Vec::new()];
        let mut before: Option<(f64, bool)> = None;
        for x in points {
            let inside = self.runs_through(x);
            if let (Some((last, was_inside)), Some(piece)) =
                (before.filter(|(_, was)| *was != inside), pieces.last_mut())
            {
                let (within, beyond) = if was_inside { (last, x) } else { (x, last) };
                let edge = self.edge(within, beyond);
                let mut near: Vec<f64> =
                    (0..=24).map(|k| edge + (within - edge) * 10f64.powf(-f64::from(k) / 3.0)).collect();
                near.push(edge);
                if !was_inside {
                    near.reverse();
                }
                piece.extend(near.into_iter().filter(|x| *x != within && self.runs_through(*x)));
                if was_inside {
                    pieces.push(Vec::new());
                }
            }
            if let (true, Some(piece)) = (inside, pieces.last_mut()) {
                piece.push(x);
            }
            before = Some((x, inside));
        }
        pieces
    }

    /// The last allowed value between an allowed one and a forbidden one, by bisection.
    fn edge(&self, mut inside: f64, mut outside: f64) -> f64 {
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if self.runs_through(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        inside
    }

    /// The value and the slope at a point, if both are finite.
    fn at(&self, x: f64) -> Option<(RunningError, RunningError)> {
        let atom = |(id, value): &(SymbolId, f64)| match *id == self.variable {
            true => (*id, Dual::new(RunningError::new(x), RunningError::new(1.0))),
            false => (*id, Dual::from_re(RunningError::new(*value))),
        };
        let still = Still { symbols: &self.model.symbols, values: self.atoms.iter().map(atom).collect() };
        let value: Dual<RunningError> = value_of(self.function, &still)?;
        (value.re.value.is_finite() && value.eps.value.is_finite()).then_some((value.re, value.eps))
    }

    /// The value at a point; NaN where it is not defined.
    fn value(&self, x: f64) -> f64 {
        let atom = |(id, value): &(SymbolId, f64)| (*id, if *id == self.variable { x } else { *value });
        let still = Still { symbols: &self.model.symbols, values: self.atoms.iter().map(atom).collect() };
        value_of(self.function, &still).unwrap_or(f64::NAN)
    }

    /// The observation of a shape along the range.
    pub(crate) fn observe(&self, shape: &Shape, range: &Range) -> Observation {
        let name = typeset_name(self.model, self.variable);
        match shape {
            Shape::Solutions(wanted) => {
                let found = count_roots_on_grid(range, |x| self.value(x), |x| self.enclosed().sign_at_extremum(x));
                let ordinary = |x: &f64| (ROOTS.recip()..ROOTS).contains(&x.abs());
                let finer = grid(range, FINER).into_iter().filter(ordinary);
                let values: Vec<f64> = finer.map(|x| self.value(x)).collect();
                let changes = values.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
                if changes > found {
                    return Observation::Open(Code::TooClose, counts_differ(&name, "solutions", found, changes));
                }
                if found == *wanted {
                    return Observation::Holds;
                }
                let what = match found {
                    1 => format!("there is 1 real solution for {name}, not {wanted}"),
                    _ => format!("there are {found} real solutions for {name}, not {wanted}"),
                };
                let compared = Compared::Counts("real solutions");
                Observation::Fails { at: None, found: found as f64, wanted: *wanted as f64, compared, what }
            }
            Shape::TendsTo { end, formula, target } => self.tends((*end, formula), target, range),
            _ => self.along(shape, range, &name),
        }
    }

    fn along(&self, shape: &Shape, range: &Range, name: &str) -> Observation {
        if let Shape::Minima(wanted) | Shape::Maxima(wanted) = shape {
            return self.extrema_as_wanted(matches!(shape, Shape::Minima(_)), *wanted, range, name);
        }
        let (mut last_slope, mut first) = (0.0_f64, None);
        let (mut positive, mut negative, mut seen) = (false, false, 0);
        let mut signs: Vec<(f64, f64, f64, f64)> = Vec::new();
        let mut last_value = None;
        let clear = |m: RunningError| if residual::vanishes(m) { 0.0 } else { m.value.signum() };
        // What would refute the claim is no rounding error.
        let enclosed = self.enclosed();
        let is_certain = |x: f64, is_slope: bool, sign: f64| match enclosed.sign(x, is_slope) {
            Some(Ordering::Less) => sign < 0.0,
            Some(Ordering::Equal) => false,
            Some(Ordering::Greater) => sign > 0.0,
            None => true,
        };
        for (x, is_first) in self.pieces(range, 1).into_iter().flat_map(beginning) {
            if is_first {
                last_value = None;
            }
            let Some((value, slope)) = self.at(x) else { continue };
            seen += 1;
            let first: RunningError = *first.get_or_insert(value);
            let (sign, slope_sign) = (clear(value), clear(slope));
            positive |= sign > 0.0;
            negative |= sign < 0.0;
            let fails = |found: f64, what: &str| {
                let (compared, what) = (Compared::AtAPlace, what.to_owned());
                Observation::Fails { at: Some(x), found, wanted: 0.0, compared, what }
            };
            let step = last_value.map(|last: RunningError| clear(value - last));
            last_value = Some(value);
            match shape {
                Shape::Rises if step.is_some_and(|step| step < 0.0) => {
                    return fails(value.value, "the function falls before this state");
                }
                Shape::Falls if step.is_some_and(|step| step > 0.0) => {
                    return fails(value.value, "the function rises before this state");
                }
                Shape::Positive if sign < 0.0 && is_certain(x, false, sign) => {
                    return fails(value.value, "the function is negative at this state");
                }
                Shape::Negative if sign > 0.0 && is_certain(x, false, sign) => {
                    return fails(value.value, "the function is positive at this state");
                }
                Shape::Rises if slope_sign < 0.0 && is_certain(x, true, slope_sign) => {
                    return fails(
                        slope.value,
                        "the function falls at this state: below, its derivative is compared with 0",
                    );
                }
                Shape::Falls if slope_sign > 0.0 && is_certain(x, true, slope_sign) => {
                    return fails(
                        slope.value,
                        "the function rises at this state: below, its derivative is compared with 0",
                    );
                }
                Shape::Independent if slope_sign != 0.0 && is_certain(x, true, slope_sign) => {
                    return fails(
                        slope.value,
                        "the function changes at this state: below, its derivative is compared with 0",
                    );
                }
                Shape::Independent if has_changed(first, value) => {
                    let what = "the function has another value at this state".to_owned();
                    let compared = Compared::AtAPlace;
                    return Observation::Fails { at: Some(x), found: value.value, wanted: first.value, compared, what };
                }
                _ => {}
            }
            if sign != 0.0 {
                signs.push((x, sign * value.value, slope_sign * sign, sign));
            }
            if slope_sign != 0.0 {
                last_slope = slope_sign;
            }
        }
        if seen == 0 {
            return Observation::Useless;
        }
        if matches!(shape, Shape::Positive | Shape::Negative)
            && let Some(fails) = self.zero_between(&signs, &enclosed)
        {
            return fails;
        }
        let compared = Compared::Nothing;
        let fails = |what: String| Observation::Fails { at: None, found: 0.0, wanted: 0.0, compared, what };
        match shape {
            Shape::ChangesSign if !positive => fails(format!("the function is nowhere positive along {name}")),
            Shape::ChangesSign if !negative => fails(format!("the function is nowhere negative along {name}")),
            Shape::Positive if !positive => fails(format!("the function is 0 for every {name}")),
            Shape::Negative if !negative => fails(format!("the function is 0 for every {name}")),
            Shape::Rises | Shape::Falls if last_slope == 0.0 => {
                fails(format!("the function does not change along {name}"))
            }
            _ => Observation::Holds,
        }
    }

    /// Whether the function has as many minima or maxima as claimed.
    fn extrema_as_wanted(&self, minima: bool, wanted: usize, range: &Range, name: &str) -> Observation {
        let what = if minima { "minima" } else { "maxima" };
        let Some(found) = self.extrema(range, 1, minima) else { return Observation::Useless };
        match self.extrema(range, FINER, minima) {
            Some(finer) if finer != found => Observation::Open(Code::TooClose, counts_differ(name, what, found, finer)),
            _ if found == wanted => Observation::Holds,
            _ => {
                let compared = Compared::Counts(what);
                let what = format!("the number of {what} of the function along {name} is {found}, not {wanted}");
                Observation::Fails { at: None, found: found as f64, wanted: wanted as f64, compared, what }
            }
        }
    }

    /// The observation that a function of one sign reaches zero between two of the points, where it falls towards zero and rises
    /// again. Of each point: its place, the value and the slope times the sign, and the sign.
    fn zero_between(&self, signs: &[(f64, f64, f64, f64)], enclosed: &EnclosedFunction<'_>) -> Option<Observation> {
        let dip = |pair: &&[(f64, f64, f64, f64)]| pair[0].3 == pair[1].3 && pair[0].2 < 0.0 && pair[1].2 > 0.0;
        for pair in signs.windows(2).filter(dip) {
            let (least, x) = minimum(pair[0].0, pair[1].0, |x| pair[0].3 * self.value(x));
            let is_close = least.abs() <= DIP * pair[0].1.max(pair[1].1);
            let sign = if is_close { enclosed.sign_at_extremum(x) } else { None };
            let reaches = match sign {
                Some(sign) => (sign == Ordering::Greater) != (pair[0].3 > 0.0),
                None => least <= 1e-13 * pair[0].1.max(pair[1].1),
            };
            if reaches {
                let what = "the function reaches zero at this state".to_owned();
                let (found, compared) = (pair[0].3 * least, Compared::AtAPlace);
                return Some(Observation::Fails { at: Some(x), found, wanted: 0.0, compared, what });
            }
        }
        None
    }

    /// The number of minima or maxima inside the range; `None`, where the function has no value.
    fn extrema(&self, range: &Range, finer: u32, minima: bool) -> Option<usize> {
        let (mut seen, mut found) = (false, 0);
        let towards = if minima { 1.0 } else { -1.0 };
        for piece in self.pieces(range, finer) {
            let mut last = 0.0_f64;
            for (_, slope) in piece.into_iter().filter_map(|x| self.at(x)) {
                seen = true;
                if !residual::vanishes(slope) {
                    let slope = slope.value.signum() * towards;
                    found += usize::from(last < 0.0 && slope > 0.0);
                    last = slope;
                }
            }
        }
        seen.then_some(found)
    }

    fn tends(&self, (end, formula): (f64, &Expr), target: &Target, range: &Range) -> Observation {
        let near = |inward: &&f64| self.runs_through(end + *inward * 0.5f64.powi(NEAREST));
        let mut look = Observation::Useless;
        for inward in sides(range, end).iter().filter(near) {
            look = self.tends_from((end, formula), *inward, target);
            if !matches!(look, Observation::Holds) {
                break;
            }
        }
        look
    }

    /// The observation of a limit from one side.
    fn tends_from(&self, (end, formula): (f64, &Expr), inward: f64, target: &Target) -> Observation {
        let wanted = match target {
            Target::Infinite(Towards::MinusInfinity) => f64::NEG_INFINITY,
            Target::Infinite(_) => f64::INFINITY,
            Target::Finite(formula) => {
                let still = Still { symbols: &self.model.symbols, values: self.atoms.clone() };
                match value_of(formula, &still) {
                    Some(value) => value,
                    None => return Observation::Useless,
                }
            }
        };
        let shown = (2..=NEAREST).rev().find_map(|k| {
            let x = end + inward * 0.5f64.powi(k);
            let (value, _) = self.at(x)?;
            (value.value.abs() > 1e-6 * value.magnitude || value.magnitude < 1e-7).then_some((x, value.value))
        });
        let Some((at, found)) = shown else { return Observation::Useless };
        match self.enclosed().limit(formula, inward, target) {
            Course::Reached => Observation::Holds,
            Course::Missed => {
                let what = match wanted.is_infinite() {
                    true => "the function does not diverge there",
                    false => "the function does not tend to this value",
                };
                let (compared, what) = (Compared::AtAPlace, what.to_owned());
                Observation::Fails { at: Some(at), found, wanted, compared, what }
            }
            Course::Open => {
                let name = typeset_name(self.model, self.variable);
                let message = format!(
                    "the values of the function close to the limit do not decide this; assume more about its symbols, \
                     or declare another range for {name}"
                );
                Observation::Open(Code::NotDecided, message)
            }
        }
    }

    /// The same function with many digits.
    fn enclosed(&self) -> EnclosedFunction<'_> {
        let Probe { model, function, variable, atoms, solved, .. } = *self;
        EnclosedFunction { model, function, variable, atoms, solved }
    }
}

/// A name as plain text.
fn typeset_name(model: &Model, id: SymbolId) -> String {
    let expr =
        Expr::new(crate::formula::Node::Symbol { id, indices: Vec::new(), dots: 0 }, crate::source::Span::default());
    crate::formula::text::plain(&typeset(&expr, &model.symbols))
}

/// The message that a finer grid shows another number.
fn counts_differ(name: &str, what: &str, found: usize, finer: usize) -> String {
    format!(
        "the number of {what} along {name} is {found} on a grid, and {finer} on a finer grid; they are too close to count, so narrow \
         the ranges"
    )
}

/// Whether two values of a function differ by more than rounding.
fn has_changed(first: RunningError, value: RunningError) -> bool {
    let difference = value - first;
    difference.value.abs() > CHANGED * difference.magnitude
}

/// The points of an interval, each with whether it is the first.
fn beginning(piece: Vec<f64>) -> impl Iterator<Item = (f64, bool)> {
    piece.into_iter().enumerate().map(|(at, x)| (x, at == 0))
}

/// The grid of a range, even inside and finer towards its ends; `finer` times as many points as usual.
fn grid(range: &Range, finer: u32) -> Vec<f64> {
    let pi = std::f64::consts::PI;
    let near = |end: f64, inward: f64, width: f64| -> Vec<f64> {
        (0..24).map(|k| end + inward * width * 10f64.powf(-1.2 - f64::from(k) / 6.0)).collect()
    };
    let interval = |low: f64, high: f64| {
        let width = high - low;
        let inside = (1..64 * finer).map(|k| low + width * f64::from(k) / f64::from(64 * finer));
        let mut points: Vec<f64> = inside.chain(near(low, 1.0, width)).chain(near(high, -1.0, width)).collect();
        points.sort_by(f64::total_cmp);
        points
    };
    match range {
        Range::Interval { low, high, .. } => interval(*low, *high),
        Range::Angle => interval(-pi, pi),
        Range::Positive => decades(finer),
        Range::Negative => decades(finer).into_iter().rev().map(|x| -x).collect(),
        Range::Any
        | Range::Rigid { .. }
        | Range::Of(_)
        | Range::FixedDirection
        | Range::Labels { .. }
        | Range::Matrix(..)
        | Range::Complex
        | Range::ImaginaryUnit
        | Range::Rate
        | Range::Given => {
            let positive = decades(finer);
            positive.iter().rev().map(|x| -x).chain(positive.iter().copied()).collect()
        }
        Range::Integer { low, high } => (*low..=last(high, *low)).map(|n| n as f64).collect(),
    }
}

/// A logarithmic grid of positive numbers, from 10⁻¹² to 10¹².
fn decades(finer: u32) -> Vec<f64> {
    let (most, a_decade) = (72 * finer as i32, f64::from(6 * finer));
    (-most..=most).map(|k| 10f64.powf(f64::from(k) / a_decade)).collect()
}
