//! Restatements of a definition: x = vt beside v = x/t.
//!
//! Such an equation holds by the definition, whether that is right or wrong, and so does not test it. Two equations
//! state the same here if factors and terms are moved from one side to the other, or both sides are raised to a power.
//! An equation that needs more, such as s(a − b) = a² − b² beside s = a + b, uses the definition. The time derivative
//! of the definition, such as ṗ = mẍ beside p = mẋ, is a restatement too.

use crate::formula::{Expr, Index, IndexId, Node, SymbolId, Term};

use crate::check::certificate::formulas;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::vacuity::monomials::{Monomial, SAME, terms};

/// How an equation restates a definition.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Restated {
    /// Rearranged.
    InOtherWords,
    /// Differentiated with respect to time.
    Differentiated,
}

/// Whether `link` restates `symbol = formula`, and how.
pub(crate) fn restates(link: &Link, symbol: SymbolId, formula: &Expr, model: &Model) -> Option<Restated> {
    let own: Vec<IndexId> = model.symbols.entry(symbol).slots.iter().map(|(_, letter)| *letter).collect();
    let indices = own.iter().map(|letter| Index::Letter(*letter)).collect();
    let name = Expr::new(Node::Symbol { id: symbol, indices, dots: 0 }, formula.span);
    let defines = Link { lhs: name, rhs: formula.clone(), ..link.clone() };
    let printed = printed_letters(link, symbol);
    let link = renamed(link, &printed, &own);
    if same_monomials(&link, &defines) || same_terms(&link, &defines) {
        return Some(Restated::InOtherWords);
    }
    is_rate(&link, &defines, model).then_some(Restated::Differentiated)
}

/// Whether an equation is the time derivative of a definition.
fn is_rate(link: &Link, defines: &Link, model: &Model) -> bool {
    let mut most = 0;
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |expr| match &expr.node {
            Node::Symbol { dots, .. } => most = most.max(*dots),
            Node::TimeDerivative(order, _) => most = most.max(*order),
            _ => {}
        });
    }
    let difference = link.lhs.clone().minus(link.rhs.clone());
    let mut rate = Some(defines.clone());
    (1..=most).any(|order| {
        rate = rate.as_ref().and_then(|rate| {
            Some(Link {
                lhs: differentiated(&rate.lhs, model)?,
                rhs: differentiated(&rate.rhs, model)?,
                ..rate.clone()
            })
        });
        let of = defines.lhs.clone().minus(defines.rhs.clone());
        let value = Expr::new(Node::TimeDerivative(order, Box::new(of)), link.lhs.span);
        rate.as_ref().is_some_and(|rate| same_monomials(link, rate) || same_terms(link, rate))
            || formulas::is_multiple(&difference, &value, model)
    })
}

/// The time derivative, term by term, of a sum of products in each of which at most one factor varies.
fn differentiated(expr: &Expr, model: &Model) -> Option<Expr> {
    let varies =
        |expr: &Expr| expr.symbols().iter().any(|(id, _)| !matches!(model.meaning(*id), Some(Meaning::Constant(_))));
    let node = match &expr.node {
        _ if !varies(expr) => Node::Number("0".to_owned()),
        Node::Symbol { id, indices, dots } => Node::Symbol { id: *id, indices: indices.clone(), dots: dots + 1 },
        Node::TimeDerivative(order, inner) => Node::TimeDerivative(order + 1, inner.clone()),
        Node::Sum(terms) => {
            let moving = terms.iter().filter(|term| varies(&term.expr));
            let rate = |term: &Term| Some(Term { expr: differentiated(&term.expr, model)?, ..term.clone() });
            Node::Sum(moving.map(rate).collect::<Option<_>>()?)
        }
        Node::Product(factors) => {
            let moving: Vec<usize> = (0..factors.len()).filter(|at| varies(&factors[*at])).collect();
            let [at] = moving.as_slice() else { return None };
            let mut factors = factors.clone();
            factors[*at] = differentiated(&factors[*at], model)?;
            Node::Product(factors)
        }
        Node::Quotient(a, b) if !varies(b) => Node::Quotient(Box::new(differentiated(a, model)?), b.clone()),
        _ => return None,
    };
    Some(Expr::new(node, expr.span))
}

/// The indices of a symbol at its first occurrence in an equation.
fn printed_letters(link: &Link, symbol: SymbolId) -> Vec<Index> {
    let mut found = None;
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |expr| {
            if let Node::Symbol { id, indices, .. } = &expr.node
                && *id == symbol
            {
                found.get_or_insert_with(|| indices.clone());
            }
        });
    }
    found.unwrap_or_default()
}

#[cfg(feature = "cli")]
/// Whether two equations are the same up to the letters of their free indices, in the order of occurrence.
pub(crate) fn same_but_for_letters(a: &Link, b: &Link) -> bool {
    let (from, to) = (free_letters(b), free_letters(a));
    let named = |from: &[IndexId]| from.iter().map(|letter| Index::Letter(*letter)).collect::<Vec<_>>();
    let renamed = renamed(b, &named(&from), &to);
    from.len() == to.len() && renamed.lhs == a.lhs && renamed.rhs == a.rhs && renamed.relation == a.relation
}

#[cfg(feature = "cli")]
/// The free indices of an equation, in the order of occurrence.
fn free_letters(link: &Link) -> Vec<IndexId> {
    let mut found: Vec<IndexId> = Vec::new();
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |expr| {
            let Node::Symbol { indices, .. } = &expr.node else { return };
            for index in indices {
                match index {
                    Index::Letter(letter) if link.free.contains(letter) && !found.contains(letter) => {
                        found.push(*letter)
                    }
                    _ => {}
                }
            }
        });
    }
    found
}

/// An equation with some letters replaced.
fn renamed(link: &Link, from: &[Index], to: &[IndexId]) -> Link {
    fn rename(expr: &mut Expr, swap: &impl Fn(Index) -> Index) {
        if let Node::Symbol { indices, .. } = &mut expr.node {
            indices.iter_mut().for_each(|index| *index = swap(*index));
        }
        match &mut expr.node {
            Node::Component(_, index) => *index = swap(*index),
            Node::Entry(_, a, b) => (*a, *b) = (swap(*a), swap(*b)),
            Node::Delta(all) => all.iter_mut().for_each(|index| *index = swap(*index)),
            Node::Epsilon(all) => all.iter_mut().for_each(|index| *index = swap(*index)),
            _ => {}
        }
        expr.children_mut().into_iter().for_each(|child| rename(child, swap));
    }
    let swap = |index: Index| match from.iter().position(|known| *known == index) {
        Some(at) => to.get(at).map_or(index, |letter| Index::Letter(*letter)),
        None => index,
    };
    let mut link = link.clone();
    rename(&mut link.lhs, &swap);
    rename(&mut link.rhs, &swap);
    link
}

/// Whether both equations set a product to a constant, and one product is a power of the other.
fn same_monomials(a: &Link, b: &Link) -> bool {
    let product = |link: &Link| Monomial::of(&link.lhs).with(&Monomial::of(&link.rhs), -1.0);
    let (a, b) = (product(a), product(b));
    let Some((first, exponent)) = b.factors.first() else { return false };
    let Some((_, other)) = a.factors.iter().find(|(base, _)| base == first) else { return false };
    Monomial::one().with(&b, other / exponent).is_like(&a)
}

/// Whether the terms of two equations are proportional with a constant factor. A common factor with symbols, such as in
/// bp = b² + bc beside p = b + c, is a step.
fn same_terms(a: &Link, b: &Link) -> bool {
    let (Some(a), Some(b)) = (terms(&a.lhs, &a.rhs), terms(&b.lhs, &b.rhs)) else { return false };
    let Some(first) = b.first() else { return false };
    let Some(image) = a.iter().find(|term| term.is_like(first)) else { return false };
    let ratio = image.coefficient / first.coefficient;
    let same = |x: &Monomial, y: &Monomial| {
        x.is_like(y) && (x.coefficient - ratio * y.coefficient).abs() < SAME * x.coefficient.abs()
    };
    a.len() == b.len() && b.iter().all(|y| a.iter().any(|x| same(x, y)))
}
