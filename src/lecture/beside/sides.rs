//! The two sides of a wrong equation against the variable that separates them most.

use super::defined::Defined;
use super::{Beside, Pair, agree};
use crate::formula::{Assignment, Expr, Node, Relation, Symbols, Value, evaluate};
use crate::latex::{Macros, names, read_display, typeset};
use crate::lecture::sample::Sample;
use crate::scalar::Series;

/// The two sides as curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Sides {
    /// The variable as LaTeX.
    pub variable: String,
    /// The values of the left side.
    pub left: Vec<(f64, f64)>,
    /// The values of the right side.
    pub right: Vec<(f64, f64)>,
    /// The two sides at the state from which the others differ in the variable alone.
    pub at: [(f64, f64); 2],
}

/// The points of a curve.
const POINTS: u32 = 80;

impl Beside {
    /// The sides of the first pair of members that differ; `None` if none do, or their names are others.
    /// `definitions` are equations that give names of the notes their formulas.
    pub fn sides(&self, latex: &str, macros: &Macros, definitions: &[String]) -> Option<Sides> {
        let plain = |pair: &Pair| (pair.defined.unfolded(&pair.left), pair.defined.unfolded(&pair.right));
        let differ = |pair: &Pair| {
            let (left, right) = plain(pair);
            let both = self.values(&pair.symbols, &left).zip(self.values(&pair.symbols, &right));
            both.is_some_and(|(left, right)| {
                left.iter().zip(&right).any(|(a, b)| (a - b).abs() > 1e-6 * a.abs().max(b.abs()))
            })
        };
        let pair = self.pairs(latex, macros, definitions).into_iter().find(differ)?;
        let (left, right) = plain(&pair);
        let base = self.samples.first()?;
        let [q, v, p] = {
            let (q, v, p) = base.numbers();
            [q, v, p]
        };
        let names = |i: usize| -> String {
            let (n, system) = (q.len(), &self.system);
            match i {
                _ if i < n => system.coordinates()[i].clone(),
                _ if i < 2 * n => crate::formula::text::with_dots(&system.coordinates()[i - n], 1),
                _ => system.parameters()[i - 2 * n].clone(),
            }
        };
        let all = [q.as_slice(), &v, &p].concat();
        let value = |i: usize, x: f64| -> Option<(f64, f64)> {
            let mut moved = all.clone();
            moved[i] = x;
            let (q, rest) = moved.split_at(q.len());
            let (v, p) = rest.split_at(v.len());
            let sample = Sample::at(&self.system, base.time, [q.to_vec(), v.to_vec(), p.to_vec()]).ok()?;
            let side = |formula: &Expr| sample.value_in(&self.derivation, &pair.symbols, formula);
            Some((side(&left)?, side(&right)?))
        };
        let curves = (0..all.len()).filter_map(|i| curve(names(i), all[i], |x| value(i, x)));
        widest(curves)
    }
}

impl Sides {
    /// The sides of a relation between numbers, from a counterexample: the names with their values, and the values of the
    /// sides. `None` if the relation does not have those values, or contains rates.
    pub fn of_counterexample(
        latex: &str,
        (macros, definitions): (&Macros, &[String]),
        state: &[(String, f64)],
        sides: (f64, f64),
    ) -> Option<Sides> {
        let mut symbols = Symbols::open();
        let defined = Defined::read(definitions, &mut symbols, macros);
        let reading = read_display(latex, &mut symbols, macros);
        let places: Option<Vec<_>> = state
            .iter()
            .map(|(name, _)| {
                let (name, dots) = names::parse(name)?;
                symbols.find(&name).filter(|_| dots == 0).map(|(id, _)| id)
            })
            .collect();
        let places = places?;
        let valued = |formula: &Expr, at: &[f64]| -> Option<f64> {
            let mut known: Assignment<'_, f64> = Assignment::new(&symbols);
            places.iter().zip(at).for_each(|(id, value)| known.set(*id, 0, *value));
            let value: Value<Series<f64>> = evaluate(formula, &known, &[]).ok()?;
            match value {
                Value::Scalar(value) => Some(value.value()).filter(|value| value.is_finite()),
                _ => None,
            }
        };
        let base: Vec<f64> = state.iter().map(|(_, value)| *value).collect();
        for statement in reading.statements.into_iter().flatten() {
            let equal =
                |at: usize| statement.relations.get(at).is_some_and(|(relation, _)| *relation == Relation::Equal);
            for (at, members) in statement.members.windows(2).enumerate().filter(|(at, _)| equal(*at)) {
                let plain = |expr: &Expr| defined.unfolded(expr);
                let lefts = [&members[0], &statement.members[0]];
                // A name that a formula defines moves with what it stands for, where that is in the state.
                let unfolded = lefts.map(|left| (plain(left), plain(&members[1])));
                let printed = lefts.map(|left| (left.clone(), members[1].clone()));
                for (left, right) in unfolded.iter().chain(&printed) {
                    let both = |at: &[f64]| Some((valued(left, at)?, valued(right, at)?));
                    let is_it = both(&base).is_some_and(|(a, b)| agree(a, sides.0) && agree(b, sides.1));
                    let moves = members.iter().any(|member| matches!(&member.node, Node::TimeDerivative(..)));
                    if !is_it || moves || at > 50 {
                        continue;
                    }
                    let curves = (0..base.len()).filter_map(|i| {
                        let value = |x: f64| {
                            let mut moved = base.clone();
                            moved[i] = x;
                            both(&moved)
                        };
                        let name = &Expr::new(Node::Symbol { id: places[i], indices: Vec::new(), dots: 0 }, left.span);
                        curve(typeset(name, &symbols), base[i], value)
                    });
                    return widest(curves);
                }
            }
        }
        None
    }
}

/// The two sides against one variable around a value; `None` where a side has no value.
fn curve(variable: String, around: f64, value: impl Fn(f64) -> Option<(f64, f64)>) -> Option<Sides> {
    let (low, high) = if around == 0.0 { (-1.0, 1.0) } else { (0.25 * around, 2.0 * around) };
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for k in 0..=POINTS {
        let x = low + (high - low) * f64::from(k) / f64::from(POINTS);
        let (a, b) = value(x)?;
        left.push((x, a));
        right.push((x, b));
    }
    let (a, b) = value(around)?;
    Some(Sides { variable, left, right, at: [(around, a), (around, b)] })
}

/// The curves that are furthest apart somewhere, relative to the larger of all their values.
fn widest(curves: impl Iterator<Item = Sides>) -> Option<Sides> {
    let apart = |sides: &Sides| {
        let size = sides.left.iter().chain(&sides.right).map(|point| point.1.abs()).fold(f64::MIN_POSITIVE, f64::max);
        let gaps: Vec<f64> = sides.left.iter().zip(&sides.right).map(|(a, b)| (a.1 - b.1).abs()).collect();
        let (least, most) = gaps.iter().fold((f64::MAX, 0.0_f64), |(low, high), gap| (low.min(*gap), high.max(*gap)));
        // what changes the gap says more than what shifts both sides
        (most - least) / size
    };
    curves
        .map(|sides| (apart(&sides), sides))
        .filter(|(apart, _)| *apart > 1e-6)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, sides)| sides)
}
