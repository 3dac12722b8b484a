//! Sums over a whole number, from a lower limit to a letter or to infinity: polynomials, and geometric sums.

use crate::scalar::Ratio;
use crate::source::Span;

use super::super::ids::SymbolId;
use super::super::tree::{Expr, Node};
use super::NoFormula;
use super::build::{Build, Guard, is_zero, rational};

use super::expansion::{In, contains};
use super::places::{End, at};

/// The largest power of the index that is summed.
const LARGEST: u32 = 12;

/// `\sum_{letter=lower}^{upper} summand`. Every node of the result has the place `span`. The upper limit stands for a whole
/// number that is not below the lower one by more than 1.
///
/// # Errors
/// Where the summand is neither a polynomial nor geometric, or the sum certainly diverges.
pub fn sum(summand: &Expr, letter: SymbolId, lower: &Expr, upper: &End, span: Span) -> Result<Expr, NoFormula> {
    let build = Build { span };
    let ring = In { letter, build };
    let mut summand = summand.clone();
    summand.move_to(span);
    if let (End::At(upper), Some(coefficients)) = (upper, ring.polynomial(&summand, LARGEST)) {
        let total = indefinite(build, &coefficients);
        let before = build.minus(lower.clone(), build.whole(1));
        return Ok(build.minus(value(build, &total, upper), value(build, &total, &before)));
    }
    geometric(ring, &summand, lower, upper)
}

/// The coefficients of S with S(n) − S(n − 1) = p(n) and S(0) = 0.
fn indefinite(build: Build, coefficients: &[Expr]) -> Vec<Expr> {
    let mut total: Vec<Vec<Expr>> = vec![Vec::new(); coefficients.len() + 1];
    for (power, coefficient) in coefficients.iter().enumerate() {
        for (at, part) in of_power(power).into_iter().enumerate().filter(|(_, part)| part.numerator != 0) {
            total[at].push(build.product(vec![build.ratio(part), coefficient.clone()]));
        }
    }
    total.into_iter().map(|terms| build.sum(terms)).collect()
}

/// The coefficients of the sum of k^p for k from 1 to n, as a polynomial in n; empty where a fraction does not fit.
fn of_power(p: usize) -> Vec<Ratio> {
    // From (n+1)^{p+1} − 1 = Σ_j C(p+1, j) S_j, solved for S_p.
    let binomial = |n: usize, k: usize| (0..k).fold(1_i64, |value, i| value * (n - i) as i64 / (i as i64 + 1));
    let mut known: Vec<Vec<Ratio>> = Vec::new();
    for m in 0..=p {
        let mut next = vec![Ratio::whole(0); m + 2];
        for (j, place) in next.iter_mut().enumerate().skip(1) {
            *place = Ratio::whole(binomial(m + 1, j));
        }
        for (j, lower) in known.iter().enumerate() {
            for (at, part) in lower.iter().enumerate() {
                let lost = part.times(Ratio::whole(-binomial(m + 1, j))).and_then(|lost| next[at].plus(lost));
                let Some(left) = lost else { return Vec::new() };
                next[at] = left;
            }
        }
        for place in &mut next {
            let Some(part) = place.over(Ratio::whole(m as i64 + 1)) else { return Vec::new() };
            *place = part;
        }
        known.push(next);
    }
    known.pop().unwrap_or_default()
}

fn value(build: Build, coefficients: &[Expr], n: &Expr) -> Expr {
    let terms = coefficients.iter().enumerate().filter(|(_, coefficient)| !is_zero(coefficient));
    let term = |(power, coefficient): (usize, &Expr)| {
        build.product(vec![coefficient.clone(), build.whole_power(n, power as u32)])
    };
    build.sum(terms.map(term).collect())
}

/// Σ c·r^{mk+s}, with the ratio q = r^m.
fn geometric(ring: In, summand: &Expr, lower: &Expr, upper: &End) -> Result<Expr, NoFormula> {
    let build = ring.build;
    let ratio = ratio(ring, summand).ok_or(NoFormula::Unknown)?;
    let first = at(summand, ring.letter, lower);
    let below = build.minus(build.whole(1), ratio.clone());
    match upper {
        End::At(upper) => {
            let after = build.sum(vec![upper.clone(), build.whole(1)]);
            let last = at(summand, ring.letter, &after);
            Ok(build.quotient(build.minus(first, last), below))
        }
        End::Infinity => {
            let size = build.node(Node::Norm(Box::new(ratio.clone())));
            let size = match rational(&ratio) {
                Some(known) => build.ratio(Ratio { numerator: known.numerator.abs(), ..known }),
                None => size,
            };
            let converges = vec![Guard { above: build.whole(1), below: size }];
            build.guarded(build.quotient(first, below), converges).ok_or(NoFormula::Diverges)
        }
        End::MinusInfinity => Err(NoFormula::Diverges),
    }
}

/// The ratio of two neighbouring terms of a geometric sum; `None` for any other, and for a ratio of 1.
fn ratio(ring: In, summand: &Expr) -> Option<Expr> {
    let build = ring.build;
    if !contains(summand, ring.letter) {
        return Some(build.whole(1));
    }
    let found = match &summand.node {
        Node::Product(factors) => {
            let factors: Option<Vec<Expr>> = factors.iter().map(|factor| ratio(ring, factor)).collect();
            build.product(factors?)
        }
        Node::Quotient(a, b) => build.quotient(ratio(ring, a)?, ratio(ring, b)?),
        Node::Power(base, exponent) if !contains(base, ring.letter) => {
            let [_, slope] = &ring.polynomial(exponent, 1)?[..] else { return None };
            let is_whole = rational(slope).is_some_and(Ratio::is_whole);
            // The power of a number by a fraction has no value for a negative one.
            (base.node == Node::Euler || is_whole).then(|| build.power(base.as_ref().clone(), slope.clone()))?
        }
        Node::Power(base, exponent) if !contains(exponent, ring.letter) => {
            let inner = ratio(ring, base)?;
            let whole = rational(exponent).filter(|n| n.is_whole())?;
            build.power(inner, build.ratio(whole))
        }
        _ => return None,
    };
    let is_one = rational(&found) == Some(Ratio::whole(1));
    (!is_one).then_some(found)
}
