//! Formulas as sums of monomials, compared without their order.

use crate::formula::tree::{Function, Sign};
use crate::formula::{Expr, Node};

/// Equations of more terms, multiplied out, are not compared.
const MOST_TERMS: usize = 64;

/// Exponents and coefficients nearer than this are one.
pub(crate) const SAME: f64 = 1e-9;

/// A product of powers with a coefficient.
#[derive(Clone, Debug)]
pub(crate) struct Monomial {
    /// The coefficient.
    pub coefficient: f64,
    /// The bases with their exponents.
    pub factors: Vec<(Expr, f64)>,
}

impl Monomial {
    pub(crate) fn one() -> Self {
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
    pub(crate) fn with(self, other: &Monomial, power: f64) -> Self {
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

/// A sum of monomials over another.
struct Fraction {
    above: Vec<Monomial>,
    below: Vec<Monomial>,
}

/// The product of two sums; none, if it is too long.
pub(crate) fn product(a: &[Monomial], b: &[Monomial]) -> Option<Vec<Monomial>> {
    let mut terms: Vec<Monomial> = Vec::new();
    for (x, y) in a.iter().flat_map(|x| b.iter().map(move |y| (x, y))) {
        add(&mut terms, x.clone().with(y, 1.0));
    }
    (terms.len() <= MOST_TERMS).then_some(terms)
}

/// Adds a term to a sum, to one like it if there is one.
pub(crate) fn add(terms: &mut Vec<Monomial>, term: Monomial) {
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
pub(crate) fn terms(lhs: &Expr, rhs: &Expr) -> Option<Vec<Monomial>> {
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
pub(crate) fn cancels(lhs: &Expr, rhs: &Expr) -> bool {
    terms(lhs, rhs).is_some_and(|terms| terms.iter().all(|term| term.coefficient == 0.0))
}
