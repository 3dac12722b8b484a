//! A function of one variable with many digits: its sign, its limit at a number, and whether a dip reaches zero.
//!
//! Close to a limit a double has lost its digits: (1 − cos ε)²/(ε sin³ε) is 0/0 at ε = 10⁻⁹, though it tends to ¼. And a
//! dip of 10⁻²⁰ is a root to a double. So the function is enclosed here, at distances 2⁻⁴⁰, 2⁻⁸⁰ and 2⁻¹⁶⁰ from the limit, and
//! at the place where its slope vanishes. A state that solves hypotheses is refined to the same precision first.
//!
//! # When a limit is reached
//!
//! The error f − value is c·εᵖ with smaller terms after it, or falls more slowly, as 1/ln ε does. From 2⁻⁸⁰ to 2⁻¹⁶⁰ a
//! power shows whatever its c is. Where no power shows, the values at the three distances are extrapolated. The limit is
//! missed where the function settles elsewhere, or grows. What is neither stays open.

use std::cmp::Ordering;

use num_dual::Dual;

use crate::formula::{Differentiable, Expr, SymbolId};
use crate::scalar::enclosure::{Enclosure, evaluate_to};
use crate::scalar::{Arithmetic, Primal};

use crate::check::kinds::limit::Towards;
use crate::check::kinds::shapes::shape::{Atoms, Still, Target, value_of};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;

/// The precisions that are tried in turn, in bits.
const PRECISIONS: [usize; 3] = [640, 1600, 4000];

/// The precision in which a sign is decided, in bits.
const BITS: usize = 640;

/// The number of results that one evaluation may take.
const STEPS: usize = 60_000;

/// The distances from the limit, as powers of 2; those further away are for exponentials of 1/ε, which are too large nearer by.
const DISTANCES: [[i32; 3]; 2] = [[40, 80, 160], [6, 12, 24]];

/// The power of the distance from which an error falls, or a value grows.
const POWER: f64 = 0.25;

/// A value whose bounds contain 0 is 0 if it is below this power of 2 of the other values.
const VANISHED: f64 = -200.0;

/// Steps below this power of 2 end an iteration.
const SOLVED: f64 = -400.0;

/// The share of the bits to which a hypothesis is met.
const MET: f64 = 0.6;

/// The largest number of steps of an iteration.
const ITERATIONS: usize = 24;

/// A function of one variable, with its other symbols at the numbers of a state.
pub(crate) struct EnclosedFunction<'a> {
    pub model: &'a Model,
    pub function: &'a Expr,
    pub variable: SymbolId,
    pub atoms: &'a Atoms,
    /// The symbols for which hypotheses were solved, each with its hypothesis.
    pub solved: &'a [(SymbolId, Hypothesis)],
}

/// Whether a function tends to a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course {
    /// It does.
    Reached,
    /// It tends to another value, or diverges.
    Missed,
    /// Neither is certain.
    Open,
}

type Numbers = Vec<(SymbolId, Enclosure)>;

impl EnclosedFunction<'_> {
    fn evaluated<D: Differentiable>(&self, formula: &Expr, values: Vec<(SymbolId, D)>) -> Option<D> {
        value_of(formula, &Still { symbols: &self.model.symbols, values })
    }

    fn value(&self, formula: &Expr, numbers: &Numbers) -> Option<Enclosure> {
        let values = numbers.iter().map(|(id, x)| (*id, Primal(*x))).collect();
        self.evaluated(formula, values).map(|Primal(value)| value).filter(|value| value.is_known())
    }

    /// The value and the slope by one of the symbols.
    fn with_slope(&self, formula: &Expr, numbers: &Numbers, by: SymbolId) -> Option<Dual<Enclosure>> {
        let one = |is_it: bool| Enclosure::exact(if is_it { 1.0 } else { 0.0 });
        let values = numbers.iter().map(|(id, x)| (*id, Dual::new(*x, one(*id == by)))).collect();
        self.evaluated(formula, values).filter(|value| value.re.is_known() && value.eps.is_known())
    }

    /// The numbers of the state; those that solve hypotheses are refined.
    fn numbers(&self, bits: usize) -> Option<Numbers> {
        let solved = -MET * bits as f64;
        let mut numbers: Numbers = self.atoms.iter().map(|(id, x)| (*id, Enclosure::exact(*x))).collect();
        let difference = |hypothesis: &Hypothesis, numbers: &Numbers, by: SymbolId| {
            let [a, b] = [&hypothesis.lhs, &hypothesis.rhs].map(|side| self.with_slope(side, numbers, by));
            Some(a? - b?)
        };
        for (id, hypothesis) in self.solved {
            let at = numbers.iter().position(|(known, _)| known == id)?;
            for _ in 0..ITERATIONS {
                let gap = difference(hypothesis, &numbers, *id)?;
                if !gap.re.middle().excludes_zero() {
                    break;
                }
                if !gap.eps.excludes_zero() {
                    return None;
                }
                let step = gap.re.over(gap.eps);
                numbers[at].1 = numbers[at].1.minus(step).middle();
                if step.log2() < solved {
                    break;
                }
            }
        }
        let is_met = |(id, hypothesis): &(SymbolId, Hypothesis)| {
            difference(hypothesis, &numbers, *id).is_some_and(|gap| gap.re.log2() < solved)
        };
        self.solved.iter().all(is_met).then_some(numbers)
    }

    fn moved(&self, numbers: &Numbers, x: Enclosure) -> Numbers {
        numbers.iter().map(|(id, value)| (*id, if *id == self.variable { x } else { *value })).collect()
    }

    /// The sign of the function at a point, or that of its slope; `None` where nothing is certain.
    pub fn sign(&self, x: f64, is_slope: bool) -> Option<Ordering> {
        evaluate_to(BITS, STEPS, || {
            let numbers = self.moved(&self.numbers(BITS)?, Enclosure::exact(x));
            let Dual { re, eps, .. } = self.with_slope(self.function, &numbers, self.variable)?;
            let (asked, scale) = if is_slope { (eps, re.log2()) } else { (re, 0.0) };
            sign_of(asked, scale.max(0.0))
        })
    }

    /// The sign of the function where its slope vanishes, near a point at which doubles see a dip.
    pub fn sign_at_extremum(&self, near: f64) -> Option<Ordering> {
        evaluate_to(BITS, STEPS, || {
            let numbers = self.numbers(BITS)?;
            let slope = |x: Enclosure| {
                let found = self.with_slope(self.function, &self.moved(&numbers, x), self.variable)?;
                Some(found.eps.middle())
            };
            let beside = near * (1.0 + 1e-7) + if near == 0.0 { 1e-7 } else { 0.0 };
            let (mut before, mut x) = (Enclosure::exact(beside), Enclosure::exact(near));
            let mut slope_before = slope(before)?;
            for _ in 0..ITERATIONS {
                let here = slope(x)?;
                let change = here.minus(slope_before);
                if !here.excludes_zero() || !change.excludes_zero() {
                    break;
                }
                let step = here.times(x.minus(before)).over(change);
                (before, slope_before) = (x, here);
                x = x.minus(step).middle();
                if step.log2() < SOLVED {
                    break;
                }
            }
            let far = x.minus(Enclosure::exact(near)).real().abs();
            let is_near = far <= 1e-3 * near.abs().max(1e-3);
            sign_of(self.value(self.function, &self.moved(&numbers, x)).filter(|_| is_near)?, 0.0)
        })
    }

    /// Whether the function tends to a value at an end, from one side.
    pub fn limit(&self, end: &Expr, inward: f64, target: &Target) -> Course {
        for (distances, is_near) in DISTANCES.iter().zip([true, false]) {
            for bits in PRECISIONS {
                match evaluate_to(bits, STEPS, || self.course((end, inward), target, distances, bits)) {
                    Some(Course::Missed) if !is_near => return Course::Open,
                    Some(course) => return course,
                    None => {}
                }
            }
        }
        Course::Open
    }

    /// The course as three distances show it; `None` where a value has no bounds that are close enough.
    fn course(
        &self,
        (end, inward): (&Expr, f64),
        target: &Target,
        distances: &[i32; 3],
        bits: usize,
    ) -> Option<Course> {
        let numbers = self.numbers(bits)?;
        let end = self.value(end, &numbers)?;
        let wanted = match target {
            Target::Finite(formula) => self.value(formula, &numbers)?,
            Target::Infinite(_) => Enclosure::exact(0.0),
        };
        let at = |k: i32| {
            let x = end.plus(Enclosure::exact(inward * 2f64.powi(-k)));
            Some(self.value(self.function, &self.moved(&numbers, x))?.minus(wanted))
        };
        let [far, near, nearest] = distances.map(at);
        let all = [far?, near?, nearest?];
        let scale = wanted.log2().max(all[0].log2()).max(0.0);
        if all.iter().any(|gap| !gap.excludes_zero() && gap.log2() > VANISHED + scale) {
            return None;
        }
        let steps = f64::from(distances[2] - distances[1]);
        Some(match target {
            Target::Finite(_) => towards_zero(all, steps),
            Target::Infinite(Towards::MinusInfinity) => towards_infinity(all.map(Arithmetic::negated), steps),
            Target::Infinite(_) => towards_infinity(all, steps),
        })
    }
}

/// The sign of a number; 0 where its bounds contain 0 and are close.
fn sign_of(value: Enclosure, scale: f64) -> Option<Ordering> {
    match value.excludes_zero() {
        true => value.order(Enclosure::exact(0.0)),
        false => (value.log2() < VANISHED + scale).then_some(Ordering::Equal),
    }
}

/// The quotient of two numbers as a double; 0 where the second may be 0.
fn ratio(a: Enclosure, b: Enclosure) -> f64 {
    if b.excludes_zero() { a.over(b).real() } else { 0.0 }
}

/// Whether errors at three distances tend to 0.
fn towards_zero([far, near, nearest]: [Enclosure; 3], steps: f64) -> Course {
    if !nearest.excludes_zero() || (near.log2() - nearest.log2()) / steps >= POWER {
        return Course::Reached;
    }
    let (first, second) = (near.minus(far), nearest.minus(near));
    let last = ratio(second, nearest).abs();
    // What is left, where the steps shrink by a factor: second · shrinks / (1 − shrinks).
    let shrinks = ratio(second, first);
    let left = 1.0 + ratio(second, nearest) * shrinks / (1.0 - shrinks);
    if last < 1e-6 || ratio(nearest, near).abs() > 1.2 || last < 0.1 && shrinks.abs() < 0.7 {
        return Course::Missed;
    }
    if (0.0..0.9).contains(&shrinks) && left.abs() < 0.3 { Course::Reached } else { Course::Open }
}

/// Whether values at three distances tend to +∞.
fn towards_infinity([far, near, nearest]: [Enclosure; 3], steps: f64) -> Course {
    let is_above = nearest.order(Enclosure::exact(0.0)) == Some(Ordering::Greater);
    if near.excludes_zero() && (nearest.log2() - near.log2()) / steps >= POWER {
        return if is_above { Course::Reached } else { Course::Missed };
    }
    let (first, second) = (near.minus(far), nearest.minus(near));
    let rises = second.order(Enclosure::exact(0.0)) == Some(Ordering::Greater);
    let shrinks = ratio(second, first);
    match (second.excludes_zero(), rises) {
        (false, _) => Course::Missed,
        (_, true) if shrinks >= 0.9 => Course::Reached,
        (_, false) if shrinks >= 0.9 => Course::Missed,
        _ if shrinks.abs() < 0.7 => Course::Missed,
        _ => Course::Open,
    }
}
