//! The branch points of a formula, and states on both sides of each.
//!
//! An even root, an absolute value, a logarithm and an inverse function change their branch, or lose their value, where
//! what is inside of them passes through 0 or touches it. Random states lie on one side of most such places:
//! `|x² − 9x + 20|` is x² − 9x + 20 except between 4 and 5. So the roots of each inside are isolated by interval
//! arithmetic, along lines through sampled states to far magnitudes, and sought in all numbers together; a branch that is
//! narrow is found by descent ([`super::dips`]), between the roots of two factors, or at the end of a range. The claim is
//! then judged on both sides, with many digits where the sides differ by little.
//!
//! A divisor that vanishes at isolated points takes the value of one side there. Such a claim holds, and says except where.

use crate::formula::tree::Function;
use crate::formula::{Expr, Node, text};
use crate::scalar::{Interval, Ratio, RunningError};

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::sampler::contains;
use crate::check::search::interval_bounds::{Least, Ranges, fraction};
use crate::check::search::{dips, magnitudes};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::finding::Finding;

/// The largest number of insides that are followed.
const MOST_INSIDES: usize = 8;

/// The number of states through which lines are drawn.
const FROM: usize = 2;

/// The number of states from which a formula is followed to where it is lowest.
const DESCENTS: usize = 6;

/// The largest number of states at which a claim is judged for each inside, and as many that are judged closely.
const JUDGED: usize = 16;

/// The largest number of parts of a line, and of all ranges.
const STEPS: usize = 1200;
const STEPS_TOGETHER: usize = 300;

/// The largest number of roots on a line.
const MOST_ROOTS: usize = 8;

/// The width of the part of a line that is taken for a root, relative to its numbers.
const NARROW: f64 = 1e-5;

/// The number of steps in which a part that may contain several roots is searched.
const WITHIN: u32 = 64;

/// The powers of 2 of the magnitudes at which a line is divided first.
const MAGNITUDES: [i32; 12] = [-30, -16, -8, -4, -2, 0, 2, 4, 8, 14, 22, 40];

/// What vanishes at a branch point.
#[derive(PartialEq)]
struct Inside {
    formula: Expr,
    is_divisor: bool,
}

/// The finding on an equality that passed, tested again on both sides of its branch points.
pub(crate) fn on_both_sides(
    link: &Link,
    context: &Context<'_>,
    ensemble: &mut Ensemble<'_>,
    finding: Finding,
) -> Finding {
    if !finding.verdict.holds() {
        return finding;
    }
    let mut insides = Vec::new();
    let mut of_sides = [0, 0];
    for (side, count) in [&link.lhs, &link.rhs].into_iter().zip(&mut of_sides) {
        collect(side, context.model, &mut insides);
        *count = insides.len();
    }
    if insides.iter().any(|inside| !inside.is_divisor) {
        let branches = insides.iter().take(MOST_INSIDES);
        for inside in branches {
            let name = text::formula(&inside.formula, &context.model.symbols);
            let (states, closely) = beside(&inside.formula, context, ensemble);
            let message = format!("the two sides agree for one sign of {name} and differ for the other");
            let all = (&ensemble.projection, states.as_slice());
            let clear = (all.0, &all.1[closely..]);
            let found = magnitudes::judged(link, context, clear, &message, &finding)
                .or_else(|| magnitudes::judged_closely(link, context, all, (closely, &message), &finding));
            if let Some(found) = found {
                return found;
            }
        }
    }
    excepted(link, context, ensemble, (&insides, of_sides[0]), finding)
}

/// What is inside of roots, absolute values, logarithms and inverse functions of a formula, and its divisors, through
/// definitions too.
fn collect(expr: &Expr, model: &Model, into: &mut Vec<Inside>) {
    let mut add = |formula: Expr, is_divisor: bool| {
        // The square of what changes its sign does not: √(x − 5)² is x − 5 on one side only.
        let parts: Vec<Expr> = if is_divisor { Vec::new() } else { factors(&formula).into_iter().cloned().collect() };
        for formula in std::iter::once(formula).chain(parts) {
            let inside = Inside { formula, is_divisor };
            if !inside.formula.symbols().is_empty() && !into.contains(&inside) {
                into.push(inside);
            }
        }
    };
    let call = |function, inner: &Expr| Expr::new(Node::Call(function, Box::new(inner.clone())), inner.span);
    match &expr.node {
        Node::Root(degree, inner) if degree % 2 == 0 => add((**inner).clone(), false),
        Node::Norm(inner) | Node::Call(Function::Ln, inner) => add((**inner).clone(), false),
        Node::Call(Function::Arcsin | Function::Arccos, inner) => {
            let one = Expr::integer(1, inner.span);
            add(one.clone().minus((**inner).clone()), false);
            add(one.minus((**inner).clone().negated()), false);
        }
        // The angle jumps where its tangent is infinite.
        Node::Call(Function::Arctan, inner) => {
            let mut within = Vec::new();
            collect(inner, model, &mut within);
            within.into_iter().filter(|inside| inside.is_divisor).for_each(|inside| add(inside.formula, false));
        }
        Node::Call(Function::Tan | Function::Sec, inner) => add(call(Function::Cos, inner), true),
        Node::Call(Function::Cot | Function::Csc, inner) => add(call(Function::Sin, inner), true),
        Node::Quotient(_, under) => add((**under).clone(), true),
        Node::Power(base, exponent) => match fraction(exponent) {
            Some(Ratio { numerator, denominator }) => {
                if numerator < 0 {
                    add((**base).clone(), true);
                }
                if denominator % 2 == 0 {
                    add((**base).clone(), false);
                }
            }
            None if base.node != Node::Euler => add((**base).clone(), false),
            None => {}
        },
        Node::Symbol { id, .. } => {
            if let Some(Meaning::Defined(formula)) = model.meaning(*id) {
                collect(formula, model, into);
            }
        }
        _ => {}
    }
    expr.children().into_iter().for_each(|child| collect(child, model, into));
}

/// States on both sides of the places where a formula of drawn numbers vanishes, and the number of those, from the first,
/// at which its sign changes by little.
fn beside<'m>(
    formula: &Expr,
    context: &Context<'_>,
    ensemble: &mut Ensemble<'m>,
) -> (Vec<SampledState<'m, RunningError>>, usize) {
    let nothing = (Vec::new(), 0);
    let (mut close, mut bases): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    {
        let Some(ranges) = Ranges::of(&[formula], context.model, &ensemble.projection) else { return nothing };
        let value = |values: &[Interval]| ranges.bounds(formula, values).unwrap_or(Interval::ALL);
        if !value(&ranges.whole()).contains(0.0) {
            return nothing;
        }
        let clear = ensemble.bases.iter().find(|base| !value(&ranges.point(base)).contains(0.0));
        if let Some(base) = clear {
            let is_positive = value(&ranges.point(base)).low > 0.0;
            let from_here = |values: &[Interval]| if is_positive { value(values) } else { value(values).negated() };
            match ranges.least(&from_here, false, STEPS_TOGETHER, &mut |_: &[f64]| true) {
                Least::Below(values) => bases.push(ranges.moved(base, &values)),
                Least::Proved | Least::Open => {}
            }
        }
        let lines = if ranges.unknowns.len() == 1 { 1 } else { FROM };
        for base in ensemble.bases.iter().take(lines) {
            for (at, unknown) in ranges.unknowns.iter().enumerate() {
                let point = ranges.point(base);
                let on_line = |of: &Expr, x: Interval| {
                    let mut moved = point.clone();
                    moved[at] = x;
                    ranges.bounds(of, &moved).unwrap_or(Interval::ALL)
                };
                let along = |x: Interval| on_line(formula, x);
                let moved = |x: f64| {
                    let mut moved = base.clone();
                    moved[unknown.slot] = x;
                    moved
                };
                bases.extend(around(&along, &roots(&along, unknown.range), unknown.range).into_iter().map(moved));
                // Between the roots of two factors the sign may differ, however close they are.
                let of_factor = |factor: &Expr| {
                    let along = |x: Interval| on_line(factor, x);
                    roots(&along, unknown.range).into_iter().filter_map(|root| crossing(&along, root)).collect()
                };
                let mut crossings: Vec<f64> = factors(formula).into_iter().flat_map::<Vec<f64>, _>(of_factor).collect();
                crossings.sort_by(f64::total_cmp);
                let between = crossings.windows(2).map(|two| 0.5 * two[0] + 0.5 * two[1]);
                close.extend(between.map(moved));
            }
        }
        for base in ensemble.bases.iter().take(DESCENTS) {
            let start: Vec<f64> = ranges.unknowns.iter().map(|unknown| base[unknown.slot]).collect();
            let here = value(&ranges.point(base));
            let height = |at: &[f64]| {
                let found = value(&at.iter().map(|x| Interval::point(*x)).collect::<Vec<_>>());
                if here.low > 0.0 { found } else { found.negated() }
            };
            if !here.contains(0.0)
                && let Some(found) = dips::below_zero(&height, &ranges, start)
            {
                close.push(ranges.moved(base, &found));
            }
        }
        // A branch may begin just before the end of a range.
        for (base, unknown) in
            ensemble.bases.iter().take(1).flat_map(|base| ranges.unknowns.iter().map(move |u| (base, u)))
        {
            for end in [unknown.range.low, unknown.range.high].into_iter().filter(|end| end.is_finite()) {
                let mut moved = base.clone();
                moved[unknown.slot] = end;
                close.push(moved);
            }
        }
    }
    close.truncate(JUDGED);
    let mut states = Vec::new();
    let mut closely = 0;
    let count = close.len();
    for (at, base) in close.into_iter().chain(bases.into_iter().take(JUDGED)).enumerate() {
        let slots = &ensemble.projection.slots;
        // Some of these states have no motion, such as a particle with the speed of light: they say nothing.
        if slots.iter().zip(&base).all(|(slot, x)| contains(&slot.range, *x))
            && let Ok(Some((_, state))) = ensemble.projection.project(base)
        {
            states.push(state);
            closely += usize::from(at < count);
        }
    }
    (states, closely)
}

/// The factors of a product, and the bases of powers among them; of anything else none.
fn factors(formula: &Expr) -> Vec<&Expr> {
    let parts = |inner| {
        let parts = factors(inner);
        if parts.is_empty() { vec![inner] } else { parts }
    };
    match &formula.node {
        Node::Product(factors) => factors.iter().flat_map(parts).collect(),
        Node::Power(base, _) => parts(base),
        _ => Vec::new(),
    }
}

/// The double next to a root at which a function changes its sign, by bisection.
fn crossing(along: &dyn Fn(Interval) -> Interval, root: Interval) -> Option<f64> {
    let sign = |x: f64| {
        let value = along(Interval::point(x));
        if value.low > 0.0 {
            1.0
        } else if value.high < 0.0 {
            -1.0
        } else {
            0.0
        }
    };
    let (mut low, mut high) = (root.low, root.high);
    let (below, above) = (sign(low), sign(high));
    if below * above >= 0.0 {
        return None;
    }
    for _ in 0..64 {
        let middle = 0.5 * low + 0.5 * high;
        match sign(middle) {
            _ if middle <= low || middle >= high => break,
            0.0 => return Some(middle),
            same if same == below => low = middle,
            _ => high = middle,
        }
    }
    Some(low)
}

/// Parts of a line that contain all roots of a function, in their order; narrow ones, as far as the budget suffices. A
/// root at an end of the range has one side only and is left out.
fn roots(along: &dyn Fn(Interval) -> Interval, range: Interval) -> Vec<Interval> {
    let edges: Vec<f64> = MAGNITUDES.iter().map(|k| 2f64.powi(*k)).collect();
    let first = Interval::new(-edges[0], edges[0]);
    let pieces = edges.windows(2).flat_map(|edge| {
        let piece = Interval::new(edge[0], edge[1]);
        [piece, piece.negated()]
    });
    let mut waiting: std::collections::VecDeque<Interval> = std::iter::once(first)
        .chain(pieces)
        .map(|piece| piece.intersection(range))
        .filter(|piece| !piece.is_empty())
        .collect();
    let mut found: Vec<Interval> = Vec::new();
    for _ in 0..STEPS {
        let Some(part) = waiting.pop_front() else { break };
        if !along(part).contains(0.0) {
            continue;
        }
        let size = part.low.abs().max(part.high.abs()).max(edges[0]);
        if part.width() > NARROW * size {
            waiting.extend(part.halves());
            continue;
        }
        found.push(part);
    }
    found.extend(waiting.into_iter().filter(|part| along(*part).contains(0.0)));
    found.sort_by(|a, b| a.low.total_cmp(&b.low));
    let mut roots: Vec<Interval> = Vec::new();
    for part in found {
        match roots.last_mut() {
            Some(last) if part.low <= last.high => last.high = last.high.max(part.high),
            _ => roots.push(part),
        }
    }
    let is_at_the_end = |root: &Interval| root.low <= range.low || root.high >= range.high;
    roots.retain(|root| !is_at_the_end(root) || root.width() > NARROW * root.low.abs().max(root.high.abs()).max(1.0));
    let distance = |root: &Interval| root.low.abs().min(root.high.abs());
    roots.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    roots.truncate(MOST_ROOTS);
    roots.sort_by(|a, b| a.low.total_cmp(&b.low));
    roots
}

/// Numbers on both sides of each root: close to it, between it and the next, and within it, if it is wide.
fn around(along: &dyn Fn(Interval) -> Interval, roots: &[Interval], range: Interval) -> Vec<f64> {
    let mut numbers = Vec::new();
    let middle = |low: f64, high: f64| 0.5 * low + 0.5 * high;
    for (at, root) in roots.iter().enumerate() {
        let size = root.low.abs().max(root.high.abs()).max(0.1);
        let before = at.checked_sub(1).map_or(range.low, |before| roots[before].high);
        let after = roots.get(at + 1).map_or(range.high, |after| after.low);
        let is_near = |x: &f64| before < *x && *x < after;
        numbers.extend([root.low - 1e-3 * size, root.high + 1e-3 * size].into_iter().filter(is_near));
        numbers.extend([middle(before, root.low), middle(root.high, after)].into_iter().filter(|x| x.is_finite()));
        numbers.extend([root.low - 0.3 * size, root.high + 0.3 * size].into_iter().filter(is_near));
        // Where the budget did not suffice, the clearest number of each sign.
        let (mut above, mut below) = ((0.0, None), (0.0, None));
        for k in (0..=WITHIN).filter(|_| root.width() > NARROW * size) {
            let x = root.low + root.width() * f64::from(k) / f64::from(WITHIN);
            let value = along(Interval::point(x));
            if value.low > above.0 {
                above = (value.low, Some(x));
            }
            if value.high < below.0 {
                below = (value.high, Some(x));
            }
        }
        numbers.extend(above.1.into_iter().chain(below.1));
    }
    numbers
}

/// The finding with the places where one side alone has no value, because a divisor vanishes at isolated points.
fn excepted(
    link: &Link,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    (insides, left): (&[Inside], usize),
    finding: Finding,
) -> Finding {
    let mut places: Vec<String> = Vec::new();
    for (at, inside) in insides.iter().enumerate().filter(|(_, inside)| inside.is_divisor) {
        let other = if at < left { &link.rhs } else { &link.lhs };
        let mut of_other = Vec::new();
        collect(other, context.model, &mut of_other);
        let is_shared = of_other.contains(inside);
        if !is_shared && vanishes_alone(&inside.formula, other, context, ensemble) {
            places.push(format!("{} = 0", text::formula(&inside.formula, &context.model.symbols)));
        }
    }
    if places.is_empty() {
        return finding;
    }
    let message = format!("{}, except where {}", finding.message, places.join(" or "));
    Finding { message, ..finding }
}

/// Whether a divisor vanishes at an allowed place where the other side has a value.
fn vanishes_alone(divisor: &Expr, other: &Expr, context: &Context<'_>, ensemble: &Ensemble<'_>) -> bool {
    let Some(ranges) = Ranges::of(&[divisor, other], context.model, &ensemble.projection) else { return false };
    let value = |formula: &Expr, values: &[Interval]| ranges.bounds(formula, values).unwrap_or(Interval::ALL);
    let Some(base) = ensemble.bases.first() else { return false };
    if !value(divisor, &ranges.whole()).contains(0.0) {
        return false;
    }
    let point = ranges.point(base);
    ranges.unknowns.iter().enumerate().any(|(at, unknown)| {
        let place = |x: Interval| {
            let mut moved = point.clone();
            moved[at] = x;
            moved
        };
        let along = |x: Interval| value(divisor, &place(x));
        roots(&along, unknown.range).into_iter().any(|root| {
            let (low, high) = (along(Interval::point(root.low)), along(Interval::point(root.high)));
            let crosses = low.low > 0.0 && high.high < 0.0 || low.high < 0.0 && high.low > 0.0;
            let touches = || along(Interval::point((root.middle() * 1e6).round() / 1e6)) == Interval::point(0.0);
            let range = &ensemble.projection.slots[unknown.slot].range;
            let is_inside = contains(range, root.low) && contains(range, root.high);
            let beside = value(other, &place(root));
            is_inside && (crosses || touches()) && !beside.is_empty() && beside.width().is_finite()
        })
    })
}
