//! The growth of a formula with the number of members of its families: arithmetic of bounds on a degree.
//!
//! A formula is a quotient of sums over tuples of labels. Its growth is the largest number of labels in a tuple of the
//! numerator, with the divisors and their own growths. [`super::family_growth`] says what follows from it.

use crate::formula::Expr;

/// The growth of a quotient: a sum over tuples of labels, divided by a product of sums.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Growth {
    /// The largest number of labels in a tuple of the numerator. The second number counts as well the free letters that
    /// may stand for the member that a hypothesis is solved for.
    pub(crate) numerator: [u32; 2],
    /// The denominators.
    pub(crate) denominators: Vec<Denominator>,
}

/// A divisor: its formula, its growth, and its power.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Denominator {
    formula: Expr,
    growth: u32,
    times: u32,
}

impl Growth {
    /// The growth of a formula without divisors.
    pub(crate) fn of(numerator: [u32; 2]) -> Option<Self> {
        Some(Growth { numerator, denominators: Vec::new() })
    }

    /// Whether the value does not depend on the number of members.
    pub(crate) fn is_none(&self) -> bool {
        self.numerator == [0; 2] && self.denominators.is_empty()
    }

    /// The growth after `by` labels are added to the numerator.
    pub(crate) fn raised(mut self, by: [u32; 2]) -> Self {
        self.numerator = [self.numerator[0] + by[0], self.numerator[1] + by[1]];
        self
    }

    /// The growth of the sum of two formulas, over their common denominator.
    pub(crate) fn plus(mut self, other: Self) -> Self {
        let lacks = |all: &[Denominator], of: &Denominator| {
            let has = all.iter().find(|known| known.formula == of.formula).map_or(0, |known| known.times);
            of.times.saturating_sub(has)
        };
        let more = |all: &[Denominator], others: &[Denominator]| {
            others.iter().map(|of| of.growth * lacks(all, of)).sum::<u32>()
        };
        let (own, others) =
            (more(&self.denominators, &other.denominators), more(&other.denominators, &self.denominators));
        self.numerator = [0, 1].map(|k| (self.numerator[k] + own).max(other.numerator[k] + others));
        for of in other.denominators {
            match self.denominators.iter_mut().find(|known| known.formula == of.formula) {
                Some(known) => known.times = known.times.max(of.times),
                None => self.denominators.push(of),
            }
        }
        self
    }

    /// The growth of the product of two formulas.
    pub(crate) fn times(mut self, other: Self) -> Self {
        self = self.raised(other.numerator);
        for of in other.denominators {
            match self.denominators.iter_mut().find(|known| known.formula == of.formula) {
                Some(known) => known.times += of.times,
                None => self.denominators.push(of),
            }
        }
        self
    }

    /// The growth of the quotient by a power of a formula, which has the growth `divisor`.
    pub(crate) fn over(mut self, formula: &Expr, divisor: Growth, times: u32) -> Self {
        for Denominator { formula, growth, times: often } in divisor.denominators {
            let often = often * times;
            // What divides both is cancelled.
            let shared = self.denominators.iter_mut().find(|known| known.formula == formula);
            let cancelled = shared.map_or(0, |known| {
                let cancelled = known.times.min(often);
                known.times -= cancelled;
                cancelled
            });
            self = self.raised([growth * (often - cancelled); 2]);
        }
        self.denominators.retain(|known| known.times > 0);
        // A divisor has no free letters, unless it has no growth.
        let [growth, _] = divisor.numerator;
        if growth == 0 {
            return self;
        }
        self.times(Growth {
            numerator: [0; 2],
            denominators: vec![Denominator { formula: formula.clone(), growth, times }],
        })
    }

    /// The growth of the sum over a label. A closed sum has no free letter that could stand for the member that a
    /// hypothesis is solved for.
    pub(crate) fn summed(mut self, is_closed: bool) -> Self {
        let [free, any] = self.numerator;
        let sum = (free + 1).max(any);
        self.numerator = [sum, if is_closed { sum } else { any + 1 }];
        self
    }
}
