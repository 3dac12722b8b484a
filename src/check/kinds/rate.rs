//! The rate at which two sides approach each other, measured with many digits.
//!
//! Where a quantity is scaled by ε, the difference of the sides is c·εᵖ with smaller terms after it. In doubles p must be
//! read off before rounding exceeds the difference, and a small c is not seen. Here the difference is enclosed at
//! ε = 2⁻²⁰⁰ and at 2⁻⁴⁰⁰, where the first term exceeds all others even if c is 10⁻⁴⁰ of theirs. The quotient of the two
//! gives p to 1/100. Offers the message that two sides differ at an order too.

use num_dual::DualStruct;

use crate::formula::{Expr, IndexId, text};
use crate::scalar::enclosure::{Enclosure, evaluate_to};
use crate::scalar::{Arithmetic, Primal};

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::sample::enclosed;
use crate::check::sample::projection::Projection;
use crate::check::state::residual;

/// The number of results that one evaluation may take.
const STEPS: usize = 60_000;

/// The difference of an entry of two sides at a state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap {
    /// An upper bound of log₂ of its size, exact to 1; −∞ where it may be 0.
    pub(crate) log2: f64,
    /// Its size, as a double.
    pub(crate) size: f64,
}

/// The difference of the sides of a link, entry by entry, at the numbers that `numbers` gives, to this number of bits;
/// relative to the right side with `is_relative`, where that is not 0. `None` where a side has no value that is known so
/// well, or hypotheses must be solved.
pub(crate) fn gaps(
    link: &Link,
    projection: &Projection<'_>,
    numbers: &dyn Fn() -> Vec<Enclosure>,
    (bits, is_relative): (usize, bool),
) -> Option<Vec<Gap>> {
    if enclosed::is_found_in_doubles(projection.model) || projection.equalities().next().is_some() {
        return None;
    }
    evaluate_to(bits, STEPS, || {
        let state = projection.state(&numbers(), projection.mode.order + 1).ok()?;
        let mut indices: Vec<(IndexId, u8)> = link.free.iter().map(|id| (*id, 1)).collect();
        let mut gaps = Vec::new();
        loop {
            let (lhs, rhs) = (state.instant(&link.lhs, &indices).ok()?, state.instant(&link.rhs, &indices).ok()?);
            let (a, b) = residual::pair(lhs, rhs);
            for (Primal(a), Primal(b)) in a.into_iter().zip(b) {
                let difference = if is_relative && b.excludes_zero() { (a - b).over(b) } else { a - b };
                if !difference.is_known() {
                    return None;
                }
                let is_clear = difference.excludes_zero();
                let log2 = if is_clear { difference.log2() } else { f64::NEG_INFINITY };
                gaps.push(Gap { log2, size: if is_clear { difference.re().abs() } else { 0.0 } });
            }
            if !residual::advance(&mut indices, &state).ok()? {
                return Some(gaps);
            }
        }
    })
}

/// The smallest power with which the entries fall from one state to another, and the entry's gaps there; `steps` is log₂
/// of the ratio of the distances. Infinite where no difference is left at the second state.
pub(crate) fn slowest(near: &[Gap], nearer: &[Gap], steps: f64) -> (f64, Option<(Gap, Gap)>) {
    let mut slowest = (f64::INFINITY, None);
    for (a, b) in near.iter().zip(nearer) {
        let power = if b.log2 == f64::NEG_INFINITY { f64::INFINITY } else { (a.log2 - b.log2) / steps };
        // A difference that is larger nearer by, and none at the first state.
        let power = if a.log2 == f64::NEG_INFINITY && power < f64::INFINITY { 0.0 } else { power };
        if power < slowest.0 {
            slowest = (power, Some((*a, *b)));
        }
    }
    slowest
}

/// What becomes of a difference that falls with no power of the distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Course {
    /// It stays, or grows.
    Stays,
    /// It falls from step to step, as 1/ln x does.
    Falls,
    /// It goes up and down.
    Unclear,
}

/// The ratio of the last difference to the first, below which it falls and above which it stays.
const FALLS: f64 = 0.8;
const STAYS: f64 = 0.95;

/// The course of a difference over steps at growing distances, by the largest entry of each step.
pub(crate) fn course(steps: &[Vec<Gap>]) -> Course {
    let largest = |gaps: &Vec<Gap>| {
        gaps.iter()
            .copied()
            .max_by(|a, b| a.log2.total_cmp(&b.log2))
            .unwrap_or(Gap { log2: f64::NEG_INFINITY, size: 0.0 })
    };
    let largest: Vec<Gap> = steps.iter().map(largest).collect();
    let (Some(first), Some(last)) = (largest.first(), largest.last()) else { return Course::Unclear };
    // A difference beyond the largest double has a logarithm still.
    if !first.size.is_finite() || !last.size.is_finite() {
        return if last.log2 >= first.log2 { Course::Stays } else { Course::Unclear };
    }
    let highest = |part: &[Gap]| part.iter().map(|gap| gap.size).fold(0.0, f64::max);
    let (before, after) = largest.split_at(largest.len() / 2);
    match () {
        () if highest(after) >= STAYS * highest(before) => Course::Stays,
        () if last.size <= FALLS * first.size && largest.windows(2).all(|pair| pair[1].size < pair[0].size) => {
            Course::Falls
        }
        () => Course::Unclear,
    }
}

/// The message that two sides differ at an order, with its power where one letter is small: "differ at order x^3 for small x".
pub(crate) fn differ_at(order: f64, small: &[Expr], model: &Model) -> String {
    match small {
        [only] if only.as_plain_symbol().is_some() => {
            let name = text::formula(only, &model.symbols);
            let order = match order.round() {
                order if order < 1.0 => "leading order".to_owned(),
                order if order < 2.0 => format!("order {name}"),
                order => format!("order {name}^{order:.0}"),
            };
            format!("the two sides differ at {order} for small {name}")
        }
        _ => format!("the two sides differ at order {order:.0} of the small quantities"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps(sizes: &[f64]) -> Vec<Vec<Gap>> {
        sizes.iter().map(|size| vec![Gap { log2: size.log2(), size: *size }]).collect()
    }

    #[test]
    fn a_difference_that_falls_slowly_is_told_from_one_that_stays_and_from_one_that_swings() {
        let slow: Vec<f64> = (0..8).map(|k| 1.0 / f64::from(100 + 14 * k)).collect();
        assert_eq!(course(&steps(&slow)), Course::Falls);
        assert_eq!(course(&steps(&[0.3; 8])), Course::Stays);
        assert_eq!(course(&steps(&[1.0, 0.2, 0.7, 0.4, 0.8, 0.1, 0.6, 0.3])), Course::Unclear);
        // A difference beyond all doubles: e^a beside a.
        let beyond = |log2| vec![Gap { log2, size: f64::INFINITY }];
        assert_eq!(course(&[beyond(6e3), beyond(4e8)]), Course::Stays);
    }
}
