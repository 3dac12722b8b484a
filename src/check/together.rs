//! Laws that give the highest derivatives of several things together, as those of coupled bodies do.
//!
//! `(M + m)\ddot x + m l\ddot\theta\cos\theta = …` and `\ddot x\cos\theta + l\ddot\theta = …` are linear in both
//! accelerations, and neither says by itself what one of them is. Such laws are solved at each state as they are printed:
//! what they are off by with the highest derivatives zero, and with one after the other 1, is a system of linear
//! equations; the derivatives of the laws give all further ones, by the same matrix.

use std::sync::Arc;

use nalgebra::DMatrix;

use crate::formula::evaluate::{ALL, Unavailable, evaluate_to};
use crate::formula::shape::{Shape, bind};
use crate::formula::{Expr, Kind, Node, Relation, SymbolId, Value};
use crate::mechanics::solve_by;
use crate::scalar::{Number, Series};

use super::ensemble::Condition;
use super::forced;
use super::model::{Meaning, Model};
use super::motion::order;
use super::rules::{Action, Rule};
use super::scene::{Scene, Valued};

/// More laws are not solved together.
const MOST: usize = 6;

/// As many laws as unknowns.
#[derive(Debug)]
pub struct Laws {
    /// What they are solved for: a number that varies, and which of its derivatives.
    pub unknowns: Vec<(SymbolId, u8)>,
    /// The sides of each.
    pub sides: Vec<[Expr; 2]>,
}

/// A law among the hypotheses: the highest derivatives that stand in it.
struct Law {
    at: usize,
    highest: Vec<(SymbolId, u8)>,
}

/// Whether a condition says how several numbers move.
pub(super) fn joins(model: &Model, condition: &Condition) -> bool {
    let sides = [&condition.lhs, &condition.rhs];
    let moves = |symbol: &SymbolId| sides.iter().any(|side| order(model, side, *symbol).is_some_and(|order| order > 0));
    forced::drawn(&sides, model).iter().filter(|symbol| is_number(model, **symbol)).filter(|s| moves(s)).count() > 1
}

/// Whether a symbol is a free function of time, and no vector or family.
fn is_number(model: &Model, symbol: SymbolId) -> bool {
    let entry = model.symbols.entry(symbol);
    let varies = matches!(model.meaning(symbol), Some(Meaning::Varying(_)));
    varies && entry.kind == Kind::Scalar && entry.slots.is_empty()
}

/// Replaces rules that need one another in a circle, and laws that are none, by laws that are solved together. `owners` are
/// the hypotheses that the rules after the first `local` come from.
pub(super) fn couple(
    model: &Model,
    conditions: &[Condition],
    (local, rules): (usize, &mut Vec<Rule>),
    owners: &mut Vec<usize>,
    explicit: &mut [bool],
) {
    let laws = laws(model, conditions, &rules[local..], owners, explicit);
    let mut done: Vec<usize> = Vec::new();
    for law in &laws {
        if done.contains(&law.at) {
            continue;
        }
        let group = group(&laws, law);
        done.extend(group.iter().map(|law| law.at));
        let mut unknowns: Vec<(SymbolId, u8)> = group.iter().flat_map(|law| law.highest.iter().copied()).collect();
        unknowns.sort_by_key(|(symbol, _)| symbol.0);
        unknowns.dedup();
        let sides: Vec<[Expr; 2]> =
            group.iter().map(|law| &conditions[law.at]).map(|c| [c.lhs.clone(), c.rhs.clone()]).collect();
        let is_linear = |side: &Expr| degree(model, side, &unknowns).is_some_and(|degree| degree <= 1);
        // What is an unknown here must not be given by anything else.
        let is_given = |symbol: SymbolId| {
            let from = rules[local..].iter().zip(owners.iter()).find(|(rule, _)| rule.symbol == symbol);
            from.is_some_and(|(_, owner)| !group.iter().any(|law| law.at == *owner))
                || rules[..local].iter().any(|rule| rule.symbol == symbol)
        };
        let fits = (2..=MOST).contains(&group.len()) && unknowns.len() == group.len();
        if !fits || !sides.iter().flatten().all(is_linear) || unknowns.iter().any(|(symbol, _)| is_given(*symbol)) {
            continue;
        }
        // Where each follows from those before it, nothing is gained.
        if group.iter().all(|law| explicit[law.at]) && !in_a_circle(model, rules, &unknowns) {
            continue;
        }
        let mut kept = owners.iter().map(|owner| !group.iter().any(|law| law.at == *owner)).collect::<Vec<bool>>();
        let mut at = 0;
        rules.retain(|_| {
            at += 1;
            at <= local || kept[at - 1 - local]
        });
        let mut keep = kept.drain(..);
        owners.retain(|_| keep.next().unwrap_or(true));
        group.iter().for_each(|law| explicit[law.at] = true);
        let together = Arc::new(Laws { unknowns, sides });
        for (symbol, _) in &together.unknowns {
            let action = Action::Together(together.clone());
            rules.push(Rule { symbol: *symbol, letters: Vec::new(), action, throughout: true });
            owners.push(group[0].at);
        }
    }
}

/// The hypotheses that hold at all times and say something of the highest derivative of a number; not those that are rules
/// of another kind.
fn laws(model: &Model, conditions: &[Condition], rules: &[Rule], owners: &[usize], explicit: &[bool]) -> Vec<Law> {
    let is_scalar = |expr: &Expr| {
        bind(expr.clone(), &model.symbols).is_ok_and(|(_, found)| found.shape == Shape::Scalar && found.free.is_empty())
    };
    let is_law = |at: &usize| {
        let condition = &conditions[*at];
        let is_equality = matches!(condition.relation, Relation::Equal | Relation::Identical);
        let moves = rules.iter().zip(owners).any(|(rule, owner)| {
            owner == at && rule.letters.is_empty() && matches!(rule.action, Action::Follows { .. })
        });
        condition.throughout
            && is_equality
            && (moves || !explicit[*at])
            && is_scalar(&condition.lhs)
            && is_scalar(&condition.rhs)
    };
    let orders: Vec<(usize, Vec<(SymbolId, u8)>)> = (0..conditions.len())
        .filter(is_law)
        .map(|at| {
            let sides = [&conditions[at].lhs, &conditions[at].rhs];
            let highest = |symbol: SymbolId| sides.iter().filter_map(|side| order(model, side, symbol)).max();
            let drawn = forced::drawn(&sides, model).into_iter().filter(|symbol| is_number(model, *symbol));
            (at, drawn.filter_map(|symbol| Some((symbol, highest(symbol)?))).collect())
        })
        .collect();
    let top = |symbol: SymbolId| {
        orders.iter().flat_map(|(_, found)| found).filter(|(s, _)| *s == symbol).map(|(_, o)| *o).max()
    };
    let highest = |found: &Vec<(SymbolId, u8)>| {
        let is_highest = |(symbol, order): &&(SymbolId, u8)| *order > 0 && Some(*order) == top(*symbol);
        found.iter().filter(is_highest).copied().collect::<Vec<_>>()
    };
    let laws = orders.iter().map(|(at, found)| Law { at: *at, highest: highest(found) });
    laws.filter(|law| !law.highest.is_empty()).collect()
}

/// The laws that have unknowns in common with a law, directly or by way of others.
fn group<'l>(laws: &'l [Law], first: &'l Law) -> Vec<&'l Law> {
    let mut group = vec![first];
    while let Some(next) = laws.iter().find(|law| {
        !group.iter().any(|known| known.at == law.at)
            && group.iter().any(|known| known.highest.iter().any(|unknown| law.highest.contains(unknown)))
    }) {
        group.push(next);
    }
    group.sort_by_key(|law| law.at);
    group
}

/// Whether what the rules say of unknowns depends on itself.
fn in_a_circle(model: &Model, rules: &[Rule], unknowns: &[(SymbolId, u8)]) -> bool {
    let formula = |symbol: SymbolId| {
        rules.iter().find_map(|rule| match &rule.action {
            Action::Follows { formula, .. } if rule.symbol == symbol => Some(formula),
            _ => None,
        })
    };
    let needs = |symbol: SymbolId| -> Vec<SymbolId> {
        let Some(formula) = formula(symbol) else { return Vec::new() };
        let needed = unknowns.iter().filter(|(other, top)| order(model, formula, *other).is_some_and(|n| n >= *top));
        needed.map(|(other, _)| *other).collect()
    };
    unknowns.iter().any(|(symbol, _)| {
        let mut reached = needs(*symbol);
        let mut at = 0;
        while at < reached.len() {
            for next in needs(reached[at]) {
                if !reached.contains(&next) {
                    reached.push(next);
                }
            }
            at += 1;
        }
        reached.contains(symbol)
    })
}

/// The degree of a formula in derivatives none of which is exceeded in it; `None` where it is no polynomial of them.
fn degree(model: &Model, expr: &Expr, unknowns: &[(SymbolId, u8)]) -> Option<u32> {
    if !unknowns.iter().any(|(symbol, top)| order(model, expr, *symbol).is_some_and(|order| order >= *top)) {
        return Some(0);
    }
    let of = |inner: &Expr| degree(model, inner, unknowns);
    match &expr.node {
        // What a derivative ends in is the highest derivative, times something lower.
        Node::TimeDerivative(..) => Some(1),
        Node::Symbol { id, dots, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) if *dots == 0 => of(formula),
            _ => Some(1),
        },
        Node::Sum(terms) => terms.iter().map(|term| of(&term.expr)).try_fold(0, |most, degree| Some(most.max(degree?))),
        Node::Product(factors) => factors.iter().map(of).try_fold(0, |sum, degree| Some(sum + degree?)),
        Node::Quotient(above, below) => of(above).filter(|_| of(below) == Some(0)),
        _ => None,
    }
}

impl<B: Number> Scene<'_, B> {
    /// A symbol that laws give together with others.
    pub(super) fn together(&self, laws: &Laws, id: SymbolId) -> Valued<B> {
        let none = || Unavailable::Symbol(id);
        let known = |known: &[(SymbolId, Vec<Value<Series<B>>>)]| {
            known.iter().find(|(symbol, _)| *symbol == id).and_then(|(_, members)| members.first().cloned())
        };
        if let Some(partial) = known(&self.following.borrow()) {
            return Ok(partial);
        }
        if let Some(found) = self.followed.borrow().get(&id).and_then(|members| members.first().cloned()) {
            return Ok(found);
        }
        let (mut jets, mut terms) = (Vec::new(), usize::MAX);
        for (symbol, order) in &laws.unknowns {
            let own = self.rules.iter().position(|rule| rule.symbol == *symbol).ok_or_else(none)?;
            let Value::Scalar(free) = self.ruled(*symbol, &[], own, ALL)? else { return Err(none()) };
            terms = terms.min(free.known().saturating_sub(usize::from(*order)));
            let lower = (0..usize::from(*order)).map(|n| free.nth_derivative_value(n).ok_or_else(none));
            jets.push(lower.collect::<Result<Vec<B>, _>>()?);
        }
        let mut matrix = None;
        for level in 0..terms {
            let with = |unknown: Option<usize>| {
                let next = |at| if unknown == Some(at) { B::one() } else { B::zero() };
                let jets: Vec<Vec<B>> =
                    jets.iter().enumerate().map(|(at, jet)| [jet.as_slice(), &[next(at)]].concat()).collect();
                self.off_by(laws, &jets, level)
            };
            let rest = with(None)?;
            if matrix.is_none() {
                let columns = (0..rest.len()).map(|at| with(Some(at))).collect::<Result<Vec<_>, _>>()?;
                matrix = Some(DMatrix::from_fn(rest.len(), rest.len(), |i, j| columns[j][i] - rest[i]));
            }
            let right = rest.iter().map(|value| -*value).collect();
            let next = matrix.clone().and_then(|matrix| solve_by(self.elimination(), "laws", matrix, right).ok());
            jets.iter_mut().zip(next.ok_or_else(none)?).for_each(|(jet, next)| jet.push(next));
        }
        let series = |jet: &Vec<B>| Value::Scalar(Series::from_derivatives(jet));
        let at = laws.unknowns.iter().position(|(symbol, _)| *symbol == id).ok_or_else(none)?;
        if self.following.borrow().is_empty() {
            let found = laws.unknowns.iter().zip(&jets).map(|((symbol, _), jet)| (*symbol, vec![series(jet)]));
            self.followed.borrow_mut().extend(found);
        }
        Ok(series(&jets[at]))
    }

    /// What the derivatives of laws of some order are off by, with these derivatives of the unknowns.
    fn off_by(&self, laws: &Laws, jets: &[Vec<B>], order: usize) -> Result<Vec<B>, Unavailable> {
        let wrong = || Unavailable::Operation("a law that is no equation between numbers");
        let others = self.following.borrow().len();
        let known = laws.unknowns.iter().zip(jets);
        let known = known.map(|((symbol, _), jet)| (*symbol, vec![Value::Scalar(Series::from_derivatives(jet))]));
        self.following.borrow_mut().extend(known);
        self.forget_values();
        let side = |side: &Expr| match evaluate_to(order + 1, side, self, &[])? {
            Value::Scalar(value) => value.nth_derivative_value(order).ok_or_else(wrong),
            _ => Err(wrong()),
        };
        let found = laws.sides.iter().map(|[lhs, rhs]| Ok(side(lhs)? - side(rhs)?)).collect();
        self.following.borrow_mut().truncate(others);
        self.forget_values();
        found
    }
}
