//! Coupled laws: those that give the highest derivatives of several symbols together, as for coupled bodies.
//!
//! `(M + m)\ddot x + m l\ddot\theta\cos\theta = …` and `\ddot x\cos\theta + l\ddot\theta = …` are linear in both
//! accelerations, and neither gives one of them by itself. Such laws are solved at each state as they are printed.
//! Their residuals with all highest derivatives 0, and with one after the other 1, make a system of linear equations.
//! The time derivatives of the laws give all further derivatives, with the same matrix.

use std::sync::Arc;

use crate::formula::shape::{Shape, bind};
use crate::formula::{Expr, Kind, Node, Relation, SymbolId};

use crate::check::hypotheses::rule::{Action, CoupledLaws, Rule};
use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;
use crate::check::model::order::order;
use crate::check::model::{Model, free_symbols};

/// The largest number of laws that are solved together.
const MOST: usize = 6;

/// A law among the hypotheses, by its place, with the highest derivatives in it.
struct Law {
    at: usize,
    highest: Vec<(SymbolId, u8)>,
}

/// Whether a hypothesis contains time derivatives of several symbols.
pub(crate) fn is_coupled(model: &Model, hypothesis: &Hypothesis) -> bool {
    let sides = [&hypothesis.lhs, &hypothesis.rhs];
    let moves = |symbol: &SymbolId| sides.iter().any(|side| order(model, side, *symbol).is_some_and(|order| order > 0));
    free_symbols::drawn(&sides, model).iter().filter(|symbol| is_number(model, **symbol)).filter(|s| moves(s)).count()
        > 1
}

/// Whether a symbol is a scalar free function of time, and not a family.
fn is_number(model: &Model, symbol: SymbolId) -> bool {
    let entry = model.symbols.entry(symbol);
    let varies = matches!(model.meaning(symbol), Some(Meaning::Varying(_)));
    varies && entry.kind == Kind::Scalar && entry.slots.is_empty()
}

/// Replaces rules that depend on each other in a circle, and laws that are not rules, by coupled laws. `owners` are the
/// hypotheses from which the rules after the first `local` come.
pub(crate) fn couple(
    model: &Model,
    hypotheses: &[Hypothesis],
    (local, rules): (usize, &mut Vec<Rule>),
    owners: &mut Vec<usize>,
    explicit: &mut [bool],
) {
    let laws = laws(model, hypotheses, &rules[local..], owners, explicit);
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
            group.iter().map(|law| &hypotheses[law.at]).map(|c| [c.lhs.clone(), c.rhs.clone()]).collect();
        let is_linear = |side: &Expr| degree(model, side, &unknowns).is_some_and(|degree| degree <= 1);
        // No other rule may give an unknown of this group.
        let is_given = |symbol: SymbolId| {
            let from = rules[local..].iter().zip(owners.iter()).find(|(rule, _)| rule.symbol == symbol);
            from.is_some_and(|(_, owner)| !group.iter().any(|law| law.at == *owner))
                || rules[..local].iter().any(|rule| rule.symbol == symbol)
        };
        let fits = (2..=MOST).contains(&group.len()) && unknowns.len() == group.len();
        if !fits || !sides.iter().flatten().all(is_linear) || unknowns.iter().any(|(symbol, _)| is_given(*symbol)) {
            continue;
        }
        // Rules that can be evaluated one after the other stay as they are.
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
        let together = Arc::new(CoupledLaws { unknowns, sides });
        for (symbol, _) in &together.unknowns {
            let action = Action::Coupled(together.clone());
            rules.push(Rule { symbol: *symbol, letters: Vec::new(), action, throughout: true });
            owners.push(group[0].at);
        }
    }
}

/// The hypotheses that hold at all times and contain the highest derivative of a symbol, without those that are rules
/// of another kind.
fn laws(model: &Model, hypotheses: &[Hypothesis], rules: &[Rule], owners: &[usize], explicit: &[bool]) -> Vec<Law> {
    let is_scalar = |expr: &Expr| {
        bind(expr.clone(), &model.symbols).is_ok_and(|(_, found)| found.shape == Shape::Scalar && found.free.is_empty())
    };
    let is_law = |at: &usize| {
        let hypothesis = &hypotheses[*at];
        let is_equality = matches!(hypothesis.relation, Relation::Equal | Relation::Identical);
        let moves = rules.iter().zip(owners).any(|(rule, owner)| {
            owner == at && rule.letters.is_empty() && matches!(rule.action, Action::EquationOfMotion { .. })
        });
        hypothesis.throughout
            && is_equality
            && (moves || !explicit[*at])
            && is_scalar(&hypothesis.lhs)
            && is_scalar(&hypothesis.rhs)
    };
    let orders: Vec<(usize, Vec<(SymbolId, u8)>)> = (0..hypotheses.len())
        .filter(is_law)
        .map(|at| {
            let sides = [&hypotheses[at].lhs, &hypotheses[at].rhs];
            let highest = |symbol: SymbolId| sides.iter().filter_map(|side| order(model, side, symbol)).max();
            let drawn = free_symbols::drawn(&sides, model).into_iter().filter(|symbol| is_number(model, *symbol));
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

/// The laws that share unknowns with a law, directly or through others.
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

/// Whether the rules of the unknowns depend on each other in a circle.
fn in_a_circle(model: &Model, rules: &[Rule], unknowns: &[(SymbolId, u8)]) -> bool {
    let formula = |symbol: SymbolId| {
        rules.iter().find_map(|rule| match &rule.action {
            Action::EquationOfMotion { formula, .. } if rule.symbol == symbol => Some(formula),
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

/// The degree of a formula in the unknown derivatives, which are the highest in it; `None` if it is not a polynomial.
fn degree(model: &Model, expr: &Expr, unknowns: &[(SymbolId, u8)]) -> Option<u32> {
    if !unknowns.iter().any(|(symbol, top)| order(model, expr, *symbol).is_some_and(|order| order >= *top)) {
        return Some(0);
    }
    let of = |inner: &Expr| degree(model, inner, unknowns);
    match &expr.node {
        // A time derivative is linear in the highest derivative.
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
