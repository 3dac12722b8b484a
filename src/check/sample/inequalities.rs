//! Bases moved into inequalities between a number of the base and a formula: r > a, x < L/2.
//!
//! Inequalities reject states. Where several of them hold by chance at a few states only, there are too few, though each could be met
//! by one number. Such a number is mirrored at the value of the formula, or put between that and the end of its range.

use crate::formula::{Expr, Relation, Value};
use crate::notes::claims::Range;

use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::contains;

/// The number of passes over the inequalities: a number that is moved may be the bound of another.
const PASSES: usize = 3;

/// The part of the way to a bound that is left out at each end.
const MARGIN: f64 = 0.05;

/// A factor that spreads values over the rest of the way.
const SPREAD: f64 = 7.0;

impl Projection<'_> {
    /// Moves numbers of a base into the inequalities that bound them by formulas.
    pub(crate) fn move_into_inequalities(&self, base: &mut [f64]) {
        for _ in 0..PASSES {
            let mut is_met = true;
            for hypothesis in &self.hypotheses {
                let is_above = match hypothesis.relation {
                    Relation::Greater | Relation::GreaterEqual => true,
                    Relation::Less | Relation::LessEqual => false,
                    _ => continue,
                };
                let (lhs, rhs) = (&hypothesis.lhs, &hypothesis.rhs);
                // What the first number cannot meet, the second may.
                is_met &= self.is_met(base, (lhs, rhs), is_above) || self.is_met(base, (rhs, lhs), !is_above);
            }
            if is_met {
                return;
            }
        }
    }

    /// Whether a number of the base is above or below a bound; one that is not is moved there, if it can be.
    fn is_met(&self, base: &mut [f64], (number, bound): (&Expr, &Expr), is_above: bool) -> bool {
        let Some(at) = self.place(number).filter(|at| self.slots[*at].order == 0) else { return false };
        let Some(bound) = self.measured(base).ok().and_then(|state| match state.now(bound, &[]) {
            Ok(Value::Scalar(value)) => Some(value.value),
            _ => None,
        }) else {
            return false;
        };
        let value = base[at];
        let holds = if is_above { value > bound } else { value < bound };
        if holds {
            return true;
        }
        let range = &self.slots[at].range;
        let (low, high) = match range {
            Range::Positive => (0.0, f64::INFINITY),
            Range::Negative => (f64::NEG_INFINITY, 0.0),
            Range::Interval { low, high, .. } => (*low, *high),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        };
        let end = if is_above { high } else { low };
        let moved = match end.is_finite() {
            true => bound + (end - bound) * (MARGIN + (1.0 - 2.0 * MARGIN) * (SPREAD * value.abs()).fract()),
            false => 2.0 * bound - value,
        };
        if moved.is_finite() && contains(range, moved) {
            base[at] = moved;
        }
        false
    }
}
