//! The bounds of formulas while their numbers run over the declared ranges, and the sign that they keep.
//!
//! A formula of drawn numbers is evaluated over [`Interval`]s. If the bounds exclude a sign, the formula never has it.
//! Else the ranges are divided, and the part with the lowest bound first, until no part is left or the budget is used.
//! What is found is a proof, or a place. A budget counts evaluations, so that the result does not depend on the clock.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::formula::tree::{Function, Sign};
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::notes::claims::Range;
use crate::scalar::{Interval, Ratio};

use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;
use crate::check::sample::projection::Projection;

/// The largest number of numbers over whose ranges a formula is followed.
const MOST: usize = 8;

/// The largest depth of definitions within definitions.
const DEEPEST: usize = 24;

/// A part narrower than this, relative to its numbers, is not divided.
const NARROWEST: f64 = 1e-12;

/// A drawn number on which a formula depends.
#[derive(Clone)]
pub(crate) struct Unknown {
    /// The symbol.
    symbol: SymbolId,
    /// The order of its derivative.
    dots: u8,
    /// Its place in a base.
    pub(crate) slot: usize,
    /// Its values.
    pub(crate) range: Interval,
    /// Whether it has whole values only, so that its range is not divided.
    pub(crate) is_whole: bool,
}

/// The numbers on which some formulas depend, each with its range, and the inequalities that restrict them.
pub(crate) struct Ranges<'a> {
    model: &'a Model,
    pub(crate) unknowns: Vec<Unknown>,
    inequalities: Vec<&'a Hypothesis>,
}

/// What dividing the ranges shows of a formula that should not be negative.
pub(crate) enum Least {
    /// It is not negative, or, if it must be positive, it is.
    Proved,
    /// It is negative here.
    Below(Vec<f64>),
    /// The budget is used.
    Open,
}

/// A part of the ranges, with a lower bound of the formula there.
struct Part {
    low: f64,
    depth: usize,
    ranges: Vec<Interval>,
}

impl Ord for Part {
    /// The part with the lowest bound is the greatest; of equal ones that which was divided least.
    fn cmp(&self, other: &Self) -> Ordering {
        other.low.total_cmp(&self.low).then(other.depth.cmp(&self.depth))
    }
}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

impl<'a> Ranges<'a> {
    /// The numbers on which formulas depend; `None` where one depends on anything but drawn single numbers: on a
    /// quantity of a system, a vector, or a number that a hypothesis fixes.
    pub(crate) fn of(formulas: &[&Expr], model: &'a Model, projection: &'a Projection<'_>) -> Option<Self> {
        let mut ranges = Ranges { model, unknowns: Vec::new(), inequalities: Vec::new() };
        for formula in formulas {
            ranges.add(formula, projection, 0)?;
        }
        ranges.inequalities = projection.hypotheses.iter().filter(|h| ranges.restricts(h)).collect();
        for at in 0..ranges.inequalities.len() {
            ranges.narrow(ranges.inequalities[at]);
        }
        let values = ranges.whole();
        formulas.iter().all(|formula| ranges.bounds(formula, &values).is_some()).then_some(ranges)
    }

    fn add(&mut self, formula: &Expr, projection: &Projection<'_>, depth: usize) -> Option<()> {
        if let Node::Symbol { id, indices, dots } = &formula.node {
            if let Some(Meaning::Defined(inner)) = self.model.meaning(*id) {
                let is_plain = indices.is_empty() && *dots == 0 && depth < DEEPEST && self.is_free(*id, projection);
                return if is_plain { self.add(inner, projection, depth + 1) } else { None };
            }
            if self.place(*id, *dots).is_some() {
                return Some(());
            }
            let slot = projection.place(formula)?;
            let is_solved = projection.record.plan.iter().any(|(_, planned)| *planned == slot);
            if is_solved || self.unknowns.len() == MOST {
                return None;
            }
            let range = &projection.slots[slot].range;
            let is_whole = matches!(range, Range::Integer { .. });
            self.unknowns.push(Unknown { symbol: *id, dots: *dots, slot, range: interval(range), is_whole });
            return Some(());
        }
        formula.children().into_iter().try_for_each(|child| self.add(child, projection, depth))
    }

    fn is_free(&self, id: SymbolId, projection: &Projection<'_>) -> bool {
        projection.rules.iter().all(|rule| rule.symbol != id)
    }

    fn place(&self, id: SymbolId, dots: u8) -> Option<usize> {
        self.unknowns.iter().position(|unknown| unknown.symbol == id && unknown.dots == dots)
    }

    /// Whether a hypothesis is an inequality of these numbers alone.
    fn restricts(&self, hypothesis: &Hypothesis) -> bool {
        let is_inequality = matches!(
            hypothesis.relation,
            Relation::Less | Relation::LessEqual | Relation::Greater | Relation::GreaterEqual
        );
        let values = self.whole();
        let is_known = |side: &Expr| self.bounds(side, &values).is_some();
        is_inequality && hypothesis.free.is_empty() && is_known(&hypothesis.lhs) && is_known(&hypothesis.rhs)
    }

    /// Narrows the range of a number that a hypothesis compares with a constant.
    fn narrow(&mut self, hypothesis: &Hypothesis) {
        let is_upper = matches!(hypothesis.relation, Relation::Less | Relation::LessEqual);
        for (side, other, is_upper) in
            [(&hypothesis.lhs, &hypothesis.rhs, is_upper), (&hypothesis.rhs, &hypothesis.lhs, !is_upper)]
        {
            let (Node::Symbol { id, dots, .. }, true) = (&side.node, other.symbols().is_empty()) else { continue };
            let (Some(at), Some(bound)) = (self.place(*id, *dots), self.bounds(other, &[])) else { continue };
            let range = &mut self.unknowns[at].range;
            if is_upper {
                range.high = range.high.min(bound.high);
            } else {
                range.low = range.low.max(bound.low);
            }
        }
    }

    /// The whole ranges.
    pub(crate) fn whole(&self) -> Vec<Interval> {
        self.unknowns.iter().map(|unknown| unknown.range).collect()
    }

    /// The numbers of a base.
    pub(crate) fn point(&self, base: &[f64]) -> Vec<Interval> {
        self.unknowns.iter().map(|unknown| Interval::point(base[unknown.slot])).collect()
    }

    /// A base with these values in place of its own.
    pub(crate) fn moved(&self, base: &[f64], values: &[f64]) -> Vec<f64> {
        let mut moved = base.to_vec();
        for (unknown, value) in self.unknowns.iter().zip(values) {
            moved[unknown.slot] = *value;
        }
        moved
    }

    /// Whether the inequalities exclude all of a part.
    fn excludes(&self, values: &[Interval]) -> bool {
        self.inequalities.iter().any(|hypothesis| {
            let sides = self.bounds(&hypothesis.lhs, values).zip(self.bounds(&hypothesis.rhs, values));
            sides.is_some_and(|(a, b)| match hypothesis.relation {
                Relation::Less => a.low >= b.high,
                Relation::LessEqual => a.low > b.high,
                Relation::Greater => a.high <= b.low,
                _ => a.high < b.low,
            })
        })
    }

    /// Follows `value` over all ranges, the lowest bounds first, and tests whether it is ever negative. `steps` is the
    /// number of parts that are looked at. With `is_strict` it may not be 0 either. A place where it is negative is one
    /// at which `is_found` agrees.
    pub(crate) fn least(
        &self,
        value: &dyn Fn(&[Interval]) -> Interval,
        is_strict: bool,
        steps: usize,
        is_found: &mut dyn FnMut(&[f64]) -> bool,
    ) -> Least {
        let is_closed = |low: f64| if is_strict { low > 0.0 } else { low >= 0.0 };
        let part = |ranges: Vec<Interval>, depth: usize| Part { low: value(&ranges).low, depth, ranges };
        let mut parts = BinaryHeap::from([part(self.whole(), 0)]);
        for _ in 0..steps {
            let Some(Part { depth, ranges, .. }) = parts.pop().filter(|part| !is_closed(part.low)) else {
                return Least::Proved;
            };
            if self.excludes(&ranges) {
                continue;
            }
            let middle: Vec<f64> = ranges.iter().map(|range| range.middle()).collect();
            let at: Vec<Interval> = middle.iter().map(|x| Interval::point(*x)).collect();
            if value(&at).high < 0.0 && !self.excludes(&at) && is_found(&middle) {
                return Least::Below(middle);
            }
            let Some(widest) = self.widest(&ranges, depth) else { return Least::Open };
            for half in ranges[widest].halves() {
                let mut halved = ranges.clone();
                halved[widest] = half;
                parts.push(part(halved, depth + 1));
            }
        }
        Least::Open
    }

    /// The number whose range is divided next: in turn those with infinite ranges, then the widest range relative to the
    /// declared one.
    fn widest(&self, ranges: &[Interval], depth: usize) -> Option<usize> {
        let count = ranges.len();
        let share = |at: usize| {
            let (range, whole) = (ranges[at], self.unknowns[at].range);
            let size = range.low.abs().max(range.high.abs());
            match (self.unknowns[at].is_whole, range.width().is_finite(), whole.width().is_finite()) {
                (true, ..) => 0.0,
                (_, false, _) => f64::INFINITY,
                _ if range.width() <= NARROWEST * size => 0.0,
                (_, _, true) => range.width() / whole.width(),
                _ => range.width(),
            }
        };
        let mut widest: Option<(usize, f64)> = None;
        for at in (0..count).map(|k| (k + depth) % count) {
            let share = share(at);
            if share > widest.map_or(0.0, |(_, share)| share) {
                widest = Some((at, share));
            }
        }
        widest.map(|(at, _)| at)
    }

    /// The bounds of a formula; `None` where it is no formula of these numbers.
    pub(crate) fn bounds(&self, formula: &Expr, values: &[Interval]) -> Option<Interval> {
        let of = |inner: &Expr| self.bounds(inner, values);
        Some(match &formula.node {
            Node::Number(digits) => Interval::decimal(digits)?,
            Node::Pi => Interval::pi(),
            Node::Euler => Interval::point(1.0).exp(),
            Node::Symbol { id, indices, dots } if indices.is_empty() => match self.place(*id, *dots) {
                Some(at) => *values.get(at)?,
                None => match self.model.meaning(*id) {
                    Some(Meaning::Defined(inner)) if *dots == 0 => of(inner)?,
                    _ => return None,
                },
            },
            Node::Sum(terms) => {
                let mut sum = Interval::point(0.0);
                for term in terms {
                    let value = of(&term.expr)?;
                    sum = if term.sign == Sign::Plus { sum.plus(value) } else { sum.minus(value) };
                }
                sum
            }
            Node::Product(factors) => {
                let mut product = Interval::point(1.0);
                for (at, factor) in factors.iter().enumerate() {
                    // A factor that is repeated is a power, of which the bounds are sharper.
                    if factors[..at].contains(factor) {
                        continue;
                    }
                    let count = factors.iter().filter(|other| *other == factor).count() as i32;
                    let value = of(factor)?;
                    let value = if count == 1 { value } else { value.power(count) };
                    product = if product == Interval::point(1.0) { value } else { product.times(value) };
                }
                product
            }
            Node::Quotient(over, under) => of(over)?.over(of(under)?),
            Node::Power(base, exponent) => match (&base.node, fraction(exponent)) {
                (Node::Euler, _) => of(exponent)?.exp(),
                (_, Some(Ratio { numerator, denominator: 1 })) => of(base)?.power(i32::try_from(numerator).ok()?),
                (_, Some(Ratio { numerator: 1, denominator: 2 })) => of(base)?.sqrt(),
                // An odd root of a negative number has a value.
                (_, Some(Ratio { denominator, .. })) if denominator % 2 == 1 => return None,
                _ => of(base)?.real_power(of(exponent)?),
            },
            Node::Root(2, inner) => of(inner)?.sqrt(),
            Node::Norm(inner) => of(inner)?.abs(),
            Node::Call(function, inner) => called(*function, of(inner)?)?,
            _ => return None,
        })
    }
}

fn called(function: Function, x: Interval) -> Option<Interval> {
    let one = Interval::point(1.0);
    Some(match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.sin().over(x.cos()),
        Function::Cot => x.cos().over(x.sin()),
        Function::Sec => one.over(x.cos()),
        Function::Csc => one.over(x.sin()),
        Function::Arcsin => x.asin(),
        Function::Arccos => x.acos(),
        Function::Arctan => x.rising(f64::atan),
        Function::Sinh => x.rising(f64::sinh),
        Function::Tanh => x.rising(f64::tanh),
        Function::Cosh => x.abs().rising(f64::cosh).intersection(Interval { low: 1.0, ..Interval::POSITIVE }),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
    })
}

/// The fraction that an exponent is, if it is written as a number.
pub(crate) fn fraction(exponent: &Expr) -> Option<Ratio> {
    match &exponent.node {
        Node::Number(digits) => Ratio::from_decimal(digits),
        Node::Quotient(over, under) => {
            let (over, under) = (fraction(over)?, fraction(under)?);
            let product = |a: i64, b: u64| i128::from(a) * i128::from(b);
            Ratio::new(product(over.numerator, under.denominator), product(under.numerator, over.denominator))
        }
        Node::Sum(terms) if terms.len() == 1 => {
            let Ratio { numerator, denominator } = fraction(&terms[0].expr)?;
            let is_negative = terms[0].sign == Sign::Minus;
            Some(Ratio { numerator: if is_negative { numerator.checked_neg()? } else { numerator }, denominator })
        }
        _ => None,
    }
}

/// The values of a range.
fn interval(range: &Range) -> Interval {
    match range {
        Range::Positive => Interval::POSITIVE,
        Range::Negative => Interval::NEGATIVE,
        Range::Interval { low, high, .. } => Interval::new(*low, *high),
        Range::Integer { low, .. } => Interval::new(*low as f64, f64::INFINITY),
        _ => Interval::ALL,
    }
}
