//! Whether an equation is a definition in other words: x = vt beside v = x/t.
//!
//! Such an equation holds by the definition, whatever that says, and so pins nothing. Two equations say the same in other
//! words here if factors and terms went from one side to the other, or both sides to one power. What needs more than that,
//! as s(a − b) = a² − b² beside s = a + b, is a use of the definition. What is the definition differentiated by time, as
//! ṗ = mẍ beside p = mẋ, says the same too.

use crate::formula::tree::{Function, Sign};
use crate::formula::{Expr, Index, IndexId, Node, SymbolId, Term};

use super::formal;
use super::judge::Link;
use super::model::{Meaning, Model};

/// Equations of more terms, multiplied out, are not compared.
const MOST_TERMS: usize = 64;

/// Exponents and coefficients nearer than this are one.
const SAME: f64 = 1e-9;

/// How an equation says a definition again.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Restated {
    /// In other words.
    InOtherWords,
    /// Differentiated by time.
    Differentiated,
}

/// Whether `link` says `symbol = formula` again, and how.
pub(super) fn restates(link: &Link, symbol: SymbolId, formula: &Expr, model: &Model) -> Option<Restated> {
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

/// Whether an equation is a definition differentiated by time: it holds whatever the definition says.
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
            || formal::is_multiple(&difference, &value, model)
    })
}

/// The rate of a sum of products in each of which one factor varies at most, term by term.
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

/// The letters that a symbol of an equation has where it stands first.
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

/// Whether two equations are one but for the letters of their free indices, taken in the order in which they stand.
pub(super) fn same_but_for_letters(a: &Link, b: &Link) -> bool {
    let (from, to) = (free_letters(b), free_letters(a));
    let named = |from: &[IndexId]| from.iter().map(|letter| Index::Letter(*letter)).collect::<Vec<_>>();
    let renamed = renamed(b, &named(&from), &to);
    from.len() == to.len() && renamed.lhs == a.lhs && renamed.rhs == a.rhs && renamed.relation == a.relation
}

/// The free indices of an equation in the order in which they stand on its symbols.
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

/// An equation with other letters in the places of some.
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

/// A product of powers with a coefficient.
#[derive(Clone, Debug)]
pub(super) struct Monomial {
    /// The coefficient.
    pub coefficient: f64,
    /// The bases with their exponents.
    pub factors: Vec<(Expr, f64)>,
}

impl Monomial {
    fn one() -> Self {
        Monomial { coefficient: 1.0, factors: Vec::new() }
    }

    fn times(mut self, base: &Expr, exponent: f64) -> Self {
        match self.factors.iter_mut().find(|(known, _)| known == base) {
            Some((_, known)) => *known += exponent,
            None => self.factors.push((base.clone(), exponent)),
        }
        self.factors.retain(|(_, exponent)| exponent.abs() > SAME);
        self
    }

    /// This times a power of another.
    fn with(self, other: &Monomial, power: f64) -> Self {
        let coefficient = self.coefficient * other.coefficient.powf(power);
        let start = Monomial { coefficient, ..self };
        other.factors.iter().fold(start, |product, (base, exponent)| product.times(base, power * exponent))
    }

    /// Of a formula, its sums taken for letters.
    pub fn of(expr: &Expr) -> Monomial {
        match &expr.node {
            Node::Number(digits) => match digits.parse::<f64>() {
                Ok(coefficient) => Monomial { coefficient, ..Monomial::one() },
                Err(_) => Monomial::one().times(expr, 1.0),
            },
            Node::Sum(terms) if terms.len() == 1 => {
                let inner = Monomial::of(&terms[0].expr);
                let sign = if terms[0].sign == Sign::Minus { -1.0 } else { 1.0 };
                Monomial { coefficient: sign * inner.coefficient, ..inner }
            }
            Node::Product(factors) => {
                factors.iter().fold(Monomial::one(), |product, factor| product.with(&Monomial::of(factor), 1.0))
            }
            Node::Quotient(a, b) => Monomial::of(a).with(&Monomial::of(b), -1.0),
            Node::Power(base, exponent) => match number(exponent) {
                Some(power) => Monomial::one().with(&Monomial::of(base), power),
                None => Monomial::one().times(expr, 1.0),
            },
            Node::Root(degree, inner) => Monomial::one().with(&Monomial::of(inner), 1.0 / f64::from(*degree)),
            // cos 0 is 1, whatever else is made of it.
            Node::Call(Function::Cos, angle) if angle.is_zero() => Monomial::one(),
            _ => Monomial::one().times(expr, 1.0),
        }
    }

    /// Whether it has the same powers of the same bases.
    pub fn is_like(&self, other: &Monomial) -> bool {
        let has = |(base, exponent): &(Expr, f64)| {
            other.factors.iter().any(|(known, of)| known == base && (of - exponent).abs() < SAME)
        };
        self.factors.len() == other.factors.len() && self.factors.iter().all(has)
    }
}

/// The value of an exponent that is a number.
fn number(expr: &Expr) -> Option<f64> {
    let Monomial { coefficient, factors } = Monomial::of(expr);
    factors.is_empty().then_some(coefficient)
}

/// Whether both equations say that a product is a number, and the one product is a power of the other.
fn same_monomials(a: &Link, b: &Link) -> bool {
    let product = |link: &Link| Monomial::of(&link.lhs).with(&Monomial::of(&link.rhs), -1.0);
    let (a, b) = (product(a), product(b));
    let Some((first, exponent)) = b.factors.first() else { return false };
    let Some((_, other)) = a.factors.iter().find(|(base, _)| base == first) else { return false };
    Monomial::one().with(&b, other / exponent).is_like(&a)
}

/// A sum of monomials over another.
struct Fraction {
    above: Vec<Monomial>,
    below: Vec<Monomial>,
}

/// The product of two sums; none, if it is too long.
fn product(a: &[Monomial], b: &[Monomial]) -> Option<Vec<Monomial>> {
    let mut terms: Vec<Monomial> = Vec::new();
    for (x, y) in a.iter().flat_map(|x| b.iter().map(move |y| (x, y))) {
        add(&mut terms, x.clone().with(y, 1.0));
    }
    (terms.len() <= MOST_TERMS).then_some(terms)
}

/// Adds a term to a sum, to one like it if there is one.
pub(super) fn add(terms: &mut Vec<Monomial>, term: Monomial) {
    match terms.iter().position(|known| known.is_like(&term)) {
        Some(at) => {
            terms[at].coefficient += term.coefficient;
            if terms[at].coefficient.abs() < SAME {
                terms.remove(at);
            }
        }
        None => terms.push(term),
    }
}

impl Fraction {
    /// Of a formula, multiplied out.
    fn of(expr: &Expr) -> Option<Fraction> {
        let whole = |term: Monomial| Some(Fraction { above: vec![term], below: vec![Monomial::one()] });
        match &expr.node {
            Node::Sum(terms) => {
                let mut sum = Fraction { above: Vec::new(), below: vec![Monomial::one()] };
                for term in terms {
                    let Fraction { mut above, below } = Fraction::of(&term.expr)?;
                    if term.sign == Sign::Minus {
                        above.iter_mut().for_each(|term| term.coefficient = -term.coefficient);
                    }
                    let mut all = product(&sum.above, &below)?;
                    product(&above, &sum.below)?.into_iter().for_each(|term| add(&mut all, term));
                    sum = Fraction { above: all, below: product(&sum.below, &below)? };
                }
                Some(sum)
            }
            Node::Product(factors) => factors.iter().try_fold(
                Fraction { above: vec![Monomial::one()], below: vec![Monomial::one()] },
                |so_far, factor| {
                    let factor = Fraction::of(factor)?;
                    let above = product(&so_far.above, &factor.above)?;
                    Some(Fraction { above, below: product(&so_far.below, &factor.below)? })
                },
            ),
            Node::Quotient(a, b) => {
                let (a, b) = (Fraction::of(a)?, Fraction::of(b)?);
                Some(Fraction { above: product(&a.above, &b.below)?, below: product(&a.below, &b.above)? })
            }
            _ => whole(Monomial::of(expr)),
        }
    }
}

/// The terms of an equation, multiplied out and brought to one side: over a denominator, if it has one, without factors
/// that are in all of them.
fn terms(lhs: &Expr, rhs: &Expr) -> Option<Vec<Monomial>> {
    let (lhs, rhs) = (Fraction::of(lhs)?, Fraction::of(rhs)?);
    let mut terms = product(&lhs.above, &rhs.below)?;
    for mut term in product(&rhs.above, &lhs.below)? {
        term.coefficient = -term.coefficient;
        add(&mut terms, term);
    }
    let is_whole = |below: &[Monomial]| below.iter().all(|term| term.factors.is_empty());
    if is_whole(&lhs.below) && is_whole(&rhs.below) {
        return Some(terms);
    }
    let common: Vec<(Expr, f64)> = terms.first()?.factors.clone();
    for (base, _) in common {
        let exponent = |term: &Monomial| term.factors.iter().find(|(known, _)| *known == base).map_or(0.0, |(_, n)| *n);
        let least = terms.iter().map(exponent).fold(f64::INFINITY, f64::min);
        terms = terms.into_iter().map(|term| term.times(&base, -least)).collect();
    }
    Some(terms)
}

/// Whether nothing is left of an equation whose terms are multiplied out and brought to one side.
pub(super) fn cancels(lhs: &Expr, rhs: &Expr) -> bool {
    terms(lhs, rhs).is_some_and(|terms| terms.iter().all(|term| term.coefficient == 0.0))
}

/// Whether the terms of two equations are the same but for a number. A factor of another kind that only one of them has,
/// as in bp = b² + bc beside p = b + c, is a step.
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
