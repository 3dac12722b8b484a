//! Formulas as sums of monomials, compared independently of their order.

use crate::formula::tree::{Function, Sign};
use crate::formula::{Expr, Node};

/// The largest number of terms of an expanded equation that is compared.
const MOST_TERMS: usize = 64;

/// The difference below which exponents and coefficients are equal.
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

    /// The product with a power of another monomial.
    pub(crate) fn with(self, other: &Monomial, power: f64) -> Self {
        let coefficient = self.coefficient * other.coefficient.powf(power);
        let start = Monomial { coefficient, ..self };
        other.factors.iter().fold(start, |product, (base, exponent)| product.times(base, power * exponent))
    }

    /// The monomial of a formula, with sums as indivisible factors.
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
            // cos 0 is 1.
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

/// A quotient of two sums of monomials.
struct Fraction {
    numerator: Vec<Monomial>,
    denominator: Vec<Monomial>,
}

/// The product of two sums; `None` if it has too many terms.
pub(crate) fn product(a: &[Monomial], b: &[Monomial]) -> Option<Vec<Monomial>> {
    let mut terms: Vec<Monomial> = Vec::new();
    for (x, y) in a.iter().flat_map(|x| b.iter().map(move |y| (x, y))) {
        add(&mut terms, x.clone().with(y, 1.0));
    }
    (terms.len() <= MOST_TERMS).then_some(terms)
}

/// Adds a term to a sum, and combines like terms.
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
    /// The expanded quotient of a formula.
    fn of(expr: &Expr) -> Option<Fraction> {
        let whole = |term: Monomial| Some(Fraction { numerator: vec![term], denominator: vec![Monomial::one()] });
        match &expr.node {
            Node::Sum(terms) => {
                let mut sum = Fraction { numerator: Vec::new(), denominator: vec![Monomial::one()] };
                for term in terms {
                    let Fraction { mut numerator, denominator } = Fraction::of(&term.expr)?;
                    if term.sign == Sign::Minus {
                        numerator.iter_mut().for_each(|term| term.coefficient = -term.coefficient);
                    }
                    let mut all = product(&sum.numerator, &denominator)?;
                    product(&numerator, &sum.denominator)?.into_iter().for_each(|term| add(&mut all, term));
                    sum = Fraction { numerator: all, denominator: product(&sum.denominator, &denominator)? };
                }
                Some(sum)
            }
            Node::Product(factors) => factors.iter().try_fold(
                Fraction { numerator: vec![Monomial::one()], denominator: vec![Monomial::one()] },
                |so_far, factor| {
                    let factor = Fraction::of(factor)?;
                    let numerator = product(&so_far.numerator, &factor.numerator)?;
                    Some(Fraction { numerator, denominator: product(&so_far.denominator, &factor.denominator)? })
                },
            ),
            Node::Quotient(a, b) => {
                let (a, b) = (Fraction::of(a)?, Fraction::of(b)?);
                Some(Fraction {
                    numerator: product(&a.numerator, &b.denominator)?,
                    denominator: product(&a.denominator, &b.numerator)?,
                })
            }
            _ => whole(Monomial::of(expr)),
        }
    }
}

/// The expanded terms of an equation, brought to one side. Denominators are multiplied out, and common factors removed.
pub(crate) fn terms(lhs: &Expr, rhs: &Expr) -> Option<Vec<Monomial>> {
    let (lhs, rhs) = (Fraction::of(lhs)?, Fraction::of(rhs)?);
    let mut terms = product(&lhs.numerator, &rhs.denominator)?;
    for mut term in product(&rhs.numerator, &lhs.denominator)? {
        term.coefficient = -term.coefficient;
        add(&mut terms, term);
    }
    let is_whole = |denominator: &[Monomial]| denominator.iter().all(|term| term.factors.is_empty());
    if is_whole(&lhs.denominator) && is_whole(&rhs.denominator) {
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

/// Whether all expanded terms of an equation cancel.
pub(crate) fn cancels(lhs: &Expr, rhs: &Expr) -> bool {
    terms(lhs, rhs).is_some_and(|terms| terms.iter().all(|term| term.coefficient == 0.0))
}
