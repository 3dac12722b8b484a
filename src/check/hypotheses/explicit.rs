//! Explicit hypotheses: those that give the value of a symbol, so that they need no numerical solution.
//!
//! `\vec F_{ij} = -\vec F_{ji}` is a symmetry, `\vec F_{ij} \propto \vec r_{ij}` a direction, and Newton's second law
//! can be written as the value of one of its forces. Such a hypothesis about a vector or a family becomes a [`Rule`].
//! The state applies it whenever it evaluates the symbol: exactly, for all members, over any kind of number, and with
//! all derivatives if it holds throughout. [`super::coupled`] laws are solved together. The other hypotheses are left
//! to the constraint projection of the sampler.
//!
//! # Why some hypotheses are rules
//!
//! F_ij = −F_ji for four particles is six pairs and 18 equations. Together with a law of motion, Newton's method is
//! slow there and leaves rounding. But such a hypothesis has a solution that can be written down: the antisymmetric
//! part, the part along a vector, the value. It is exact, for all members, over any number, and with all
//! derivatives where it holds throughout. A rule keeps the part of what was drawn that obeys, so it does not choose
//! which symbol is free.

use crate::formula::{Expr, Index, IndexId, Kind, Node, Relation, Sign, SymbolId, Term};
use crate::notes::claims::Range;
use crate::source::Span;

use crate::check::hypotheses::coupled;
use crate::check::hypotheses::motion::motion;
use crate::check::hypotheses::rule::{Action, Rule, depends_through_rules, letters};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;

/// The rules that these hypotheses give, after those of the claim itself; and for each hypothesis whether it is a rule.
pub fn rules(model: &Model, local: &[Rule], hypotheses: &[Hypothesis]) -> (Vec<Rule>, Vec<bool>) {
    let mut rules: Vec<Rule> = local.to_vec();
    let mut explicit = vec![false; hypotheses.len()];
    let mut owners = Vec::new();
    // A hypothesis that fixes a whole vector goes before the laws, which can be solved for one of several symbols.
    for (at, hypothesis) in hypotheses.iter().enumerate() {
        let found = symmetry(model, hypothesis).or_else(|| parallel(model, hypothesis, &rules));
        let is_new = |rule: &Rule| !rules.iter().any(|known| known.symbol == rule.symbol);
        let moves = |hypothesis: &Hypothesis| motion(model, hypothesis).filter(is_new);
        let couples = || Some(at).filter(|_| hypothesis.throughout && coupled::is_coupled(model, hypothesis));
        let found = found.or_else(|| value(model, hypothesis, &rules, number_of(model, hypotheses, couples()?)));
        let found = found.or_else(|| moves(hypothesis).filter(|_| hypothesis.throughout && is_equality(hypothesis)));
        let found = found.or_else(|| value(model, hypothesis, &rules, |term| free_symbol(model, term)));
        if let Some(rule) = found {
            explicit[at] = true;
            rules.push(rule);
            owners.push(at);
        }
    }
    coupled::couple(model, hypotheses, (local.len(), &mut rules), &mut owners, &mut explicit);
    (rules, explicit)
}

fn is_equality(hypothesis: &Hypothesis) -> bool {
    matches!(hypothesis.relation, Relation::Equal | Relation::Identical)
}

/// A drawn vector or family, with a different letter for each index.
fn free_symbol(model: &Model, expr: &Expr) -> Option<(SymbolId, Vec<IndexId>)> {
    let Node::Symbol { id, indices, dots: 0 } = &expr.node else { return None };
    if !matches!(model.meaning(*id)?, Meaning::Varying(_) | Meaning::Constant(_)) {
        return None;
    }
    let entry = model.symbols.entry(*id);
    if entry.kind != Kind::Vector && entry.slots.is_empty() || indices.len() != entry.slots.len() {
        return None;
    }
    Some((*id, letters(indices)?))
}

/// The rule of a symmetry, `X_{ij} = ± X_{ji}`.
fn symmetry(model: &Model, hypothesis: &Hypothesis) -> Option<Rule> {
    if !is_equality(hypothesis) {
        return None;
    }
    let (symbol, letters) = free_symbol(model, &hypothesis.lhs)?;
    let (sign, other) = match &hypothesis.rhs.node {
        Node::Sum(terms) => match terms.as_slice() {
            [Term { sign, expr, .. }] => (*sign, expr),
            _ => return None,
        },
        _ => (Sign::Plus, &hypothesis.rhs),
    };
    let (image, permuted) = free_symbol(model, other)?;
    if image != symbol {
        return None;
    }
    let permutation: Option<Vec<usize>> =
        permuted.iter().map(|letter| letters.iter().position(|known| known == letter)).collect();
    let permutation = permutation?;
    let is_involution = permutation.iter().enumerate().all(|(at, to)| permutation[*to] == at);
    let moves = permutation.iter().enumerate().any(|(at, to)| at != *to);
    (is_involution && moves).then_some(Rule {
        symbol,
        letters,
        action: Action::Symmetric { permutation, sign },
        throughout: hypothesis.throughout,
    })
}

/// The rule of a direction, `\vec X \propto \vec Y`.
fn parallel(model: &Model, hypothesis: &Hypothesis, before: &[Rule]) -> Option<Rule> {
    if hypothesis.relation != Relation::Proportional {
        return None;
    }
    [(&hypothesis.lhs, &hypothesis.rhs), (&hypothesis.rhs, &hypothesis.lhs)].into_iter().find_map(|(a, b)| {
        let (symbol, letters) = free_symbol(model, a)?;
        (!depends_through_rules(model, before, b, symbol)).then(|| Rule {
            symbol,
            letters,
            action: Action::Parallel(b.clone()),
            throughout: hypothesis.throughout,
        })
    })
}

/// A test for a scalar that may have any value and that occurs in no other hypothesis: the force that causes a motion.
fn number_of<'c>(
    model: &'c Model,
    hypotheses: &'c [Hypothesis],
    at: usize,
) -> impl Fn(&Expr) -> Option<(SymbolId, Vec<IndexId>)> + 'c {
    move |term| {
        let symbol = term.as_plain_symbol()?;
        let entry = model.symbols.entry(symbol);
        let is_number = entry.kind == Kind::Scalar && entry.slots.is_empty();
        let may_be_any = matches!(model.meaning(symbol)?, Meaning::Varying(_)) && model.range(symbol) == Range::Any;
        let mentions = |other: &Hypothesis| [&other.lhs, &other.rhs].iter().any(|s| model.depends_on(s, &[symbol]));
        let alone = !hypotheses.iter().enumerate().any(|(other, hypothesis)| other != at && mentions(hypothesis));
        (is_number && may_be_any && alone).then(|| (symbol, Vec::new()))
    }
}

/// The rule of an equation that is solved for a term: a free symbol that occurs nowhere else in the equation.
fn value(
    model: &Model,
    hypothesis: &Hypothesis,
    before: &[Rule],
    free: impl Fn(&Expr) -> Option<(SymbolId, Vec<IndexId>)>,
) -> Option<Rule> {
    if !is_equality(hypothesis) {
        return None;
    }
    let mut terms: Vec<(Sign, Expr)> = Vec::new();
    flatten(model, &hypothesis.lhs, Sign::Plus, 0, &mut terms);
    let left = terms.len();
    flatten(model, &hypothesis.rhs, Sign::Minus, 0, &mut terms);
    // The left side goes first. Of two candidates on it the later one is used.
    let order = (0..left).rev().chain(left..terms.len());
    for at in order {
        let (sign, term) = &terms[at];
        let Some((symbol, letters)) = free(term) else { continue };
        let others: Vec<&(Sign, Expr)> =
            terms.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, term)| term).collect();
        if others.iter().any(|(_, other)| depends_through_rules(model, before, other, symbol)) {
            continue;
        }
        if before.iter().any(|rule| rule.symbol == symbol) || !same_letters(model, &letters, &others) {
            continue;
        }
        let flipped = *sign == Sign::Plus;
        let rest: Vec<Term> = others
            .into_iter()
            .map(|(sign, expr)| Term {
                sign: if flipped { sign.flipped() } else { *sign },
                sign_span: None,
                expr: expr.clone(),
            })
            .collect();
        let formula = match rest.is_empty() {
            true => Expr::integer(0, Span::default()),
            false => Expr::new(Node::Sum(rest), Span::default()),
        };
        return Some(Rule { symbol, letters, action: Action::Equals(formula), throughout: hypothesis.throughout });
    }
    None
}

/// Whether all free labels of the other terms are among the letters of the symbol.
fn same_letters(model: &Model, letters: &[IndexId], others: &[&(Sign, Expr)]) -> bool {
    others.iter().all(|(_, other)| {
        crate::formula::shape::bind(other.clone(), &model.symbols)
            .is_ok_and(|(_, found)| found.free.iter().all(|letter| letters.contains(letter)))
    })
}

/// The terms of a formula; a term that is a defined name is replaced by the terms of its definition.
fn flatten(model: &Model, expr: &Expr, sign: Sign, depth: usize, into: &mut Vec<(Sign, Expr)>) {
    match &expr.node {
        Node::Sum(terms) => {
            for term in terms {
                let sign = if term.sign == Sign::Minus { sign.flipped() } else { sign };
                flatten(model, &term.expr, sign, depth, into);
            }
        }
        Node::Symbol { id, indices, dots: 0 } if depth < 8 => {
            let entry = model.symbols.entry(*id);
            let own = entry.slots.iter().map(|(_, letter)| Index::Letter(*letter));
            match model.meaning(*id) {
                Some(Meaning::Defined(formula)) if own.eq(indices.iter().copied()) => {
                    flatten(model, formula, sign, depth + 1, into);
                }
                _ => into.push((sign, expr.clone())),
            }
        }
        _ if expr.is_null() => {}
        _ => into.push((sign, expr.clone())),
    }
}
