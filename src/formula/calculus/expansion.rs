//! A formula in one letter as a sum of terms c·xⁿ·e^{γx²+αx+β}·f(ωx+φ), where f is sine, cosine or 1.
//!
//! Products of sines and cosines become sums by the addition theorems, so the expansion is closed under sums, products
//! and whole powers.

use crate::scalar::Ratio;

use super::super::ids::SymbolId;
use super::super::tree::{Expr, Function, Node, Sign};
use super::build::{Build, is_zero};

/// The most terms of an expansion.
const MOST: usize = 600;

/// The most terms among which opposite ones are looked for.
const MOST_COMPARED: usize = 24;

/// A sine or a cosine of `rate`·x + `phase`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Wave {
    pub is_sine: bool,
    pub rate: Expr,
    pub phase: Expr,
}

/// One term.
#[derive(Clone, Debug)]
pub(super) struct Monomial {
    pub factor: Expr,
    pub power: u32,
    /// γ, α, β of the exponent.
    pub square: Expr,
    pub rate: Expr,
    pub shift: Expr,
    pub wave: Option<Wave>,
}

/// The letter of an expansion, and where its results stand.
#[derive(Clone, Copy)]
pub(super) struct In {
    pub letter: SymbolId,
    pub build: Build,
}

/// Whether a formula contains a symbol. A definition that contains it must have been written out before.
pub(super) fn contains(expr: &Expr, letter: SymbolId) -> bool {
    let mut found = false;
    expr.walk(&mut |part| found |= matches!(part.node, Node::Symbol { id, .. } if id == letter));
    found
}

impl In {
    fn constant(self, factor: Expr) -> Monomial {
        let zero = || self.build.whole(0);
        Monomial { factor, power: 0, square: zero(), rate: zero(), shift: zero(), wave: None }
    }

    /// The terms of a formula; `None` if it is of another form.
    pub fn expand(self, expr: &Expr) -> Option<Vec<Monomial>> {
        let one = || self.build.whole(1);
        if !contains(expr, self.letter) {
            return Some(vec![self.constant(expr.clone())]);
        }
        let terms = match &expr.node {
            Node::Symbol { dots: 0, indices, .. } if indices.is_empty() => {
                vec![Monomial { power: 1, ..self.constant(one()) }]
            }
            Node::Sum(terms) => {
                let mut all = Vec::new();
                for term in terms {
                    for mut monomial in self.expand(&term.expr)? {
                        if term.sign == Sign::Minus {
                            monomial.factor = self.build.negative(monomial.factor);
                        }
                        all.push(monomial);
                    }
                }
                self.without_opposites(all)
            }
            Node::Product(factors) => factors
                .iter()
                .try_fold(vec![self.constant(one())], |all, next| self.times(&all, &self.expand(next)?))?,
            Node::Quotient(a, b) => {
                let below = match self.expand(b)?.as_slice() {
                    [only] if only.power == 0 && only.wave.is_none() => only.clone(),
                    _ => return None,
                };
                let inverse = Monomial {
                    factor: self.build.quotient(one(), below.factor),
                    square: self.build.negative(below.square),
                    rate: self.build.negative(below.rate),
                    shift: self.build.negative(below.shift),
                    ..self.constant(one())
                };
                self.times(&self.expand(a)?, &[inverse])?
            }
            Node::Power(base, exponent) if base.node == Node::Euler => self.exponential(exponent)?,
            Node::Power(base, exponent) => {
                let times = exponent.as_digits()?.parse::<u32>().ok().filter(|n| *n <= 12)?;
                let base = self.expand(base)?;
                (0..times).try_fold(vec![self.constant(one())], |all, _| self.times(&all, &base))?
            }
            Node::Call(Function::Exp, argument) => self.exponential(argument)?,
            Node::Call(function @ (Function::Sin | Function::Cos), argument) => {
                let [phase, rate, ..] = &self.polynomial(argument, 1)?[..] else { return None };
                let wave = Wave { is_sine: *function == Function::Sin, rate: rate.clone(), phase: phase.clone() };
                vec![Monomial { wave: Some(wave), ..self.constant(one()) }]
            }
            Node::Call(function @ (Function::Sinh | Function::Cosh), argument) => {
                let half = Ratio { numerator: 1, denominator: 2 };
                let mut both = self.exponential(argument)?;
                let opposite = self.build.negative(argument.as_ref().clone());
                both.extend(self.exponential(&opposite)?);
                for (at, monomial) in both.iter_mut().enumerate() {
                    let sign = if at == 1 && *function == Function::Sinh { half.negated()? } else { half };
                    monomial.factor = self.build.ratio(sign);
                }
                both
            }
            _ => return None,
        };
        (terms.len() <= MOST).then_some(terms)
    }

    /// The terms but for pairs of a term and its opposite: of T − T₀ with T = T₀ + A e^{−kt} the constant goes, and so an integral to
    /// infinity exists.
    fn without_opposites(self, mut terms: Vec<Monomial>) -> Vec<Monomial> {
        if terms.len() > MOST_COMPARED {
            return terms;
        }
        let is_opposite = |a: &Monomial, b: &Monomial| {
            let negative = |factor: &Expr| self.build.negative(factor.clone());
            let is_alike = a.power == b.power && a.wave == b.wave;
            is_alike
                && [(&a.square, &b.square), (&a.rate, &b.rate), (&a.shift, &b.shift)].iter().all(|(a, b)| a == b)
                && (negative(&a.factor) == b.factor || a.factor == negative(&b.factor))
        };
        let mut at = 0;
        while at < terms.len() {
            match (at + 1..terms.len()).find(|other| is_opposite(&terms[at], &terms[*other])) {
                Some(other) => {
                    terms.remove(other);
                    terms.remove(at);
                }
                None => at += 1,
            }
        }
        terms
    }

    /// The coefficients of a polynomial of at most this degree, the constant first; always `degree` + 1 of them.
    pub fn polynomial(self, expr: &Expr, degree: u32) -> Option<Vec<Expr>> {
        let mut coefficients: Vec<Vec<Expr>> = vec![Vec::new(); degree as usize + 1];
        for term in self.expand(expr)? {
            let is_plain = term.wave.is_none() && is_zero(&term.square) && is_zero(&term.rate) && is_zero(&term.shift);
            coefficients.get_mut(term.power as usize).filter(|_| is_plain)?.push(term.factor);
        }
        Some(coefficients.into_iter().map(|terms| self.build.sum(terms)).collect())
    }

    fn exponential(self, exponent: &Expr) -> Option<Vec<Monomial>> {
        let [shift, rate, square] = &self.polynomial(exponent, 2)?[..] else { return None };
        let one = self.constant(self.build.whole(1));
        Some(vec![Monomial { square: square.clone(), rate: rate.clone(), shift: shift.clone(), ..one }])
    }

    fn times(self, a: &[Monomial], b: &[Monomial]) -> Option<Vec<Monomial>> {
        if a.len() * b.len() > MOST {
            return None;
        }
        let mut all = Vec::new();
        for a in a {
            for b in b {
                let build = self.build;
                let joined = |a: &Expr, b: &Expr| build.sum(vec![a.clone(), b.clone()]);
                let product = Monomial {
                    factor: build.product(vec![a.factor.clone(), b.factor.clone()]),
                    power: a.power + b.power,
                    square: joined(&a.square, &b.square),
                    rate: joined(&a.rate, &b.rate),
                    shift: joined(&a.shift, &b.shift),
                    wave: None,
                };
                match (&a.wave, &b.wave) {
                    (Some(a), Some(b)) => all.extend(self.beats(&product, a, b)?),
                    (wave, other) => all.push(Monomial { wave: wave.clone().or(other.clone()), ..product }),
                }
            }
        }
        Some(all)
    }

    /// The product of two waves as a sum of two.
    fn beats(self, product: &Monomial, a: &Wave, b: &Wave) -> Option<[Monomial; 2]> {
        let build = self.build;
        let half = Ratio { numerator: 1, denominator: 2 };
        let of = |is_sine: bool, is_sum: bool, sign: Ratio| {
            let join = |a: &Expr, b: &Expr| match is_sum {
                true => build.sum(vec![a.clone(), b.clone()]),
                false => build.minus(a.clone(), b.clone()),
            };
            let wave = Wave { is_sine, rate: join(&a.rate, &b.rate), phase: join(&a.phase, &b.phase) };
            let factor = build.product(vec![build.ratio(sign), product.factor.clone()]);
            self.settled(Monomial { factor, wave: Some(wave), ..product.clone() })
        };
        let minus = half.negated()?;
        Some(match (a.is_sine, b.is_sine) {
            // sin a sin b = ½ cos(a − b) − ½ cos(a + b)
            (true, true) => [of(false, false, half), of(false, true, minus)],
            (false, false) => [of(false, false, half), of(false, true, half)],
            (true, false) => [of(true, false, half), of(true, true, half)],
            // cos a sin b = ½ sin(a + b) − ½ sin(a − b)
            (false, true) => [of(true, true, half), of(true, false, minus)],
        })
    }

    /// A wave of rate 0 is a constant.
    fn settled(self, monomial: Monomial) -> Monomial {
        match &monomial.wave {
            Some(wave) if is_zero(&wave.rate) => {
                let function = if wave.is_sine { Function::Sin } else { Function::Cos };
                let value = match (is_zero(&wave.phase), wave.is_sine) {
                    (true, true) => self.build.whole(0),
                    (true, false) => self.build.whole(1),
                    _ => self.build.call(function, wave.phase.clone()),
                };
                let factor = self.build.product(vec![monomial.factor.clone(), value]);
                Monomial { factor, wave: None, ..monomial }
            }
            _ => monomial,
        }
    }

    /// A term at some value of the letter.
    pub fn at(self, term: &Monomial, x: &Expr) -> Expr {
        let build = self.build;
        let exponent = build.sum(vec![
            build.product(vec![term.square.clone(), build.whole_power(x, 2)]),
            build.product(vec![term.rate.clone(), x.clone()]),
            term.shift.clone(),
        ]);
        let mut factors = vec![term.factor.clone()];
        if term.power > 0 {
            factors.push(build.whole_power(x, term.power));
        }
        if !is_zero(&exponent) {
            factors.push(build.exp(exponent));
        }
        if let Some(wave) = &term.wave {
            let angle = build.sum(vec![build.product(vec![wave.rate.clone(), x.clone()]), wave.phase.clone()]);
            factors.push(match (is_zero(&angle), wave.is_sine) {
                (true, true) => build.whole(0),
                (true, false) => build.whole(1),
                (_, true) => build.call(Function::Sin, angle),
                (_, false) => build.call(Function::Cos, angle),
            });
        }
        build.product(factors)
    }
}
