//! Definite integrals of powers of linear and quadratic formulas: ∫(αx+β)^p, ∫x(Ax²+C)^p, ∫1/(Ax²+C),
//! ∫(Ax²+C)^{−1/2}, ∫(Ax²+C)^{−3/2}, ∫(C−Ax²)^{1/2}.
//!
//! Such integrands may have poles. So the result has a value only where there is none between the ends.

use crate::scalar::Ratio;

use super::super::tree::{Expr, Function, Node};
use super::NoFormula;
use super::build::{Build, Guard, is_zero, rational};
use super::expansion::{In, contains};
use super::places::{End, at};

/// An integrand c·xⁿ·uᵖ, where u is linear or quadratic.
struct Powers {
    factor: Vec<Expr>,
    power: u32,
    base: Expr,
    exponent: Ratio,
}

/// The integral of c·xⁿ·uᵖ between two ends.
pub(super) fn integral(ring: In, integrand: &Expr, ends: (&End, &End)) -> Result<Expr, NoFormula> {
    let build = ring.build;
    let mut found = Powers { factor: Vec::new(), power: 0, base: build.whole(1), exponent: Ratio::whole(0) };
    collect(ring, integrand, Ratio::whole(1), &mut found).ok_or(NoFormula::Unknown)?;
    let Powers { factor, power, base, exponent } = found;
    let coefficients = ring.polynomial(&base, 2).ok_or(NoFormula::Unknown)?;
    let [constant, linear, square] = &coefficients[..] else { return Err(NoFormula::Unknown) };
    let values = match (power, is_zero(square), is_zero(linear)) {
        (0, true, _) => of_linear(build, (linear, &base), exponent, ring, ends)?,
        (1, false, true) => of_inner_derivative(build, (square, constant, &base), exponent, ring, ends)?,
        (0, false, true) => of_quadratic(build, (square, constant, &base), exponent, ring, ends)?,
        _ => return Err(NoFormula::Unknown),
    };
    let mut factors = factor;
    factors.push(values);
    Ok(build.product(factors))
}

/// Collects the factors of a product; `None` for a second base.
fn collect(ring: In, expr: &Expr, to: Ratio, found: &mut Powers) -> Option<()> {
    let build = ring.build;
    if !contains(expr, ring.letter) {
        let one = Ratio::whole(1);
        let factor = match to {
            _ if to == one => expr.clone(),
            _ if Some(to) == one.negated() => build.quotient(build.whole(1), expr.clone()),
            _ => build.power(expr.clone(), build.ratio(to)),
        };
        found.factor.push(factor);
        return Some(());
    }
    match &expr.node {
        Node::Product(factors) => factors.iter().try_for_each(|factor| collect(ring, factor, to, found)),
        Node::Quotient(a, b) => {
            collect(ring, a, to, found)?;
            collect(ring, b, to.negated()?, found)
        }
        Node::Root(degree, radicand) => {
            raised(ring, radicand, (Ratio { numerator: 1, denominator: u64::from(*degree) }, to), found)
        }
        Node::Power(base, exponent) => raised(ring, base, (rational(exponent)?, to), found),
        Node::Symbol { .. } if to == Ratio::whole(1) && found.power == 0 => {
            found.power = 1;
            Some(())
        }
        Node::Sum(_) | Node::Symbol { .. } if found.exponent.numerator == 0 => {
            found.base = expr.clone();
            found.exponent = to;
            Some(())
        }
        _ => None,
    }
}

/// Collects a power of a power. (x²)^{1/2} is |x|, and (√x)² has no value for x < 0: neither is a power of x.
fn raised(ring: In, base: &Expr, (inner, outer): (Ratio, Ratio), found: &mut Powers) -> Option<()> {
    let both = inner.times(outer)?;
    let is_safe = outer.is_whole() && (inner.is_whole() || !both.is_whole());
    if is_safe { collect(ring, base, both, found) } else { None }
}

/// The difference of a function at two ends, where its value at infinity is given.
fn difference(
    build: Build,
    at: impl Fn(&Expr) -> Expr,
    at_infinity: impl Fn(bool) -> Result<Expr, NoFormula>,
    (lower, upper): (&End, &End),
) -> Result<Expr, NoFormula> {
    let value = |end: &End| match end {
        End::At(x) => Ok(at(x)),
        End::Infinity => at_infinity(true),
        End::MinusInfinity => at_infinity(false),
    };
    Ok(build.minus(value(upper)?, value(lower)?))
}

fn placed(ring: In, base: &Expr, x: &Expr) -> Expr {
    ring.build.again(&at(base, ring.letter, x))
}

/// arcsin(x/radius). Where the base is 0 it is a quarter of a turn, of the sign of x.
fn angle(ring: In, base: &Expr, x: &Expr, radius: &Expr) -> Expr {
    let build = ring.build;
    let part = build.quotient(x.clone(), radius.clone());
    match () {
        () if is_zero(x) => build.whole(0),
        () if is_zero(&placed(ring, base, x)) => {
            build.product(vec![build.quotient(build.node(Node::Pi), build.whole(2)), part])
        }
        () => build.call(Function::Arcsin, part),
    }
}

/// ∫(αx+β)^p. For p ≤ −1 the base must not change its sign; other powers than whole ones have no value for a negative base.
fn of_linear(
    build: Build,
    (slope, base): (&Expr, &Expr),
    p: Ratio,
    ring: In,
    ends: (&End, &End),
) -> Result<Expr, NoFormula> {
    let minus_one = Ratio::whole(-1);
    let (lower, upper) = ends;
    let is_steep = p.value() <= -1.0;
    let finite = |end: &End| if let End::At(x) = end { Some(placed(ring, base, x)) } else { None };
    let mut guards = Vec::new();
    match (finite(lower), finite(upper)) {
        (Some(a), Some(b)) if p == minus_one => {
            // ln(b/a) has a value where both have one sign.
            let ratio = build.quotient(b, a);
            return Ok(build.quotient(build.call(Function::Ln, ratio), slope.clone()));
        }
        (Some(a), Some(b)) if is_steep => {
            guards.push(Guard { above: build.product(vec![a, b]), below: build.whole(0) });
        }
        (Some(_), Some(_)) => {}
        // Up to infinity the base must have one sign, that of its slope.
        (Some(end), None) | (None, Some(end)) if p.value() < -1.0 => {
            let is_upper = matches!(upper, End::Infinity) && matches!(lower, End::At(_));
            let is_lower = matches!(lower, End::MinusInfinity) && matches!(upper, End::At(_));
            if !is_upper && !is_lower {
                return Err(NoFormula::Unknown);
            }
            let product = build.product(vec![end, slope.clone()]);
            let product = if is_upper { product } else { build.negative(product) };
            guards.push(Guard { above: product, below: build.whole(0) });
        }
        _ => return Err(NoFormula::Diverges),
    }
    let next = p.plus(Ratio::whole(1)).ok_or(NoFormula::Unknown)?;
    let below = build.product(vec![slope.clone(), build.ratio(next)]);
    let at = |x: &Expr| power(build, placed(ring, base, x), next);
    let above = difference(build, at, |_| Ok(build.whole(0)), ends)?;
    build.guarded(build.quotient(above, below), guards).ok_or(NoFormula::Diverges)
}

fn power(build: Build, base: Expr, exponent: Ratio) -> Expr {
    match exponent {
        Ratio { numerator: 1, denominator: 2 } => build.root(base),
        Ratio { numerator: -1, denominator: 2 } => build.quotient(build.whole(1), build.root(base)),
        Ratio { numerator: n @ ..=-1, denominator: 1 } => {
            build.quotient(build.whole(1), build.power(base, build.ratio(Ratio::whole(-n))))
        }
        _ => build.power(base, build.ratio(exponent)),
    }
}

/// The condition that Ax²+C is positive between the ends: C > 0 and A > 0, or both ends where A < 0. A power above −1 may be
/// 0 at an end, and has no value beyond.
fn positive(
    build: Build,
    (square, constant, base): (&Expr, &Expr, &Expr),
    p: Ratio,
    ring: In,
    (lower, upper): (&End, &End),
) -> Result<Vec<Guard>, NoFormula> {
    let zero = || build.whole(0);
    match rational(square) {
        Some(square) if square.numerator < 0 && p.value() > -1.0 => Ok(Vec::new()),
        Some(square) if square.numerator < 0 => {
            let at = |end: &End| match end {
                End::At(x) => Ok(Guard { above: placed(ring, base, x), below: zero() }),
                _ => Err(NoFormula::Unknown),
            };
            Ok(vec![at(lower)?, at(upper)?])
        }
        _ => Ok(vec![Guard { above: constant.clone(), below: zero() }, Guard { above: square.clone(), below: zero() }]),
    }
}

/// The same where the rule does not depend on the sign of A, which may be a letter's: between two numbers it is enough that Ax²+C
/// is positive at both, and C is.
fn positive_between(
    build: Build,
    parts: (&Expr, &Expr, &Expr),
    p: Ratio,
    ring: In,
    ends: (&End, &End),
) -> Result<Vec<Guard>, NoFormula> {
    let (square, constant, base) = parts;
    let (End::At(lower), End::At(upper), None) = (ends.0, ends.1, rational(square)) else {
        return positive(build, parts, p, ring, ends);
    };
    let above = [constant.clone(), placed(ring, base, lower), placed(ring, base, upper)];
    Ok(above.into_iter().map(|above| Guard { above, below: build.whole(0) }).collect())
}

/// ∫x(Ax²+C)^p
fn of_inner_derivative(
    build: Build,
    parts: (&Expr, &Expr, &Expr),
    p: Ratio,
    ring: In,
    ends: (&End, &End),
) -> Result<Expr, NoFormula> {
    let (square, _, base) = parts;
    let guards = positive_between(build, parts, p, ring, ends)?;
    let two = build.product(vec![build.whole(2), square.clone()]);
    let value = match p == Ratio::whole(-1) {
        true => {
            let at = |x: &Expr| build.call(Function::Ln, placed(ring, base, x));
            build.quotient(difference(build, at, |_| Err(NoFormula::Diverges), ends)?, two)
        }
        false => {
            let next = p.plus(Ratio::whole(1)).ok_or(NoFormula::Unknown)?;
            let at = |x: &Expr| power(build, placed(ring, base, x), next);
            let far = |_| if next.numerator < 0 { Ok(build.whole(0)) } else { Err(NoFormula::Diverges) };
            let above = difference(build, at, far, ends)?;
            build.quotient(above, build.product(vec![two, build.ratio(next)]))
        }
    };
    build.guarded(value, guards).ok_or(NoFormula::Diverges)
}

/// ∫(Ax²+C)^p for p = −1, −1/2, −3/2, and 1/2 where A < 0
fn of_quadratic(
    build: Build,
    parts: (&Expr, &Expr, &Expr),
    p: Ratio,
    ring: In,
    ends: (&End, &End),
) -> Result<Expr, NoFormula> {
    let (square, constant, base) = parts;
    let guards = match p {
        Ratio { numerator: -3, denominator: 2 } => positive_between(build, parts, p, ring, ends)?,
        _ => positive(build, parts, p, ring, ends)?,
    };
    let is_concave = rational(square).is_some_and(|square| square.numerator < 0);
    let signed = |is_up: bool, value: Expr| if is_up { value } else { build.negative(value) };
    let half = Ratio { numerator: -1, denominator: 2 };
    let value = match (p, is_concave) {
        (Ratio { numerator: -1, denominator: 1 }, false) => {
            let scale = build.root(build.product(vec![square.clone(), constant.clone()]));
            let slope = build.root(build.quotient(square.clone(), constant.clone()));
            let at = |x: &Expr| build.call(Function::Arctan, build.product(vec![slope.clone(), x.clone()]));
            let quarter = build.quotient(build.node(Node::Pi), build.whole(2));
            build.quotient(difference(build, at, |up| Ok(signed(up, quarter.clone())), ends)?, scale)
        }
        (p, true) if p == half => {
            let steep = build.negative(square.clone());
            let radius = build.root(build.quotient(constant.clone(), steep.clone()));
            let at = |x: &Expr| angle(ring, base, x, &radius);
            build.quotient(difference(build, at, |_| Err(NoFormula::Unknown), ends)?, build.root(steep))
        }
        // The area under a circle or an ellipse.
        (Ratio { numerator: 1, denominator: 2 }, true) => {
            let steep = build.negative(square.clone());
            let radius = build.root(build.quotient(constant.clone(), steep.clone()));
            let sector = build.quotient(constant.clone(), build.root(steep));
            let at = |x: &Expr| {
                let triangle = build.product(vec![x.clone(), build.root(placed(ring, base, x))]);
                build.sum(vec![triangle, build.product(vec![sector.clone(), angle(ring, base, x, &radius)])])
            };
            build.quotient(difference(build, at, |_| Err(NoFormula::Unknown), ends)?, build.whole(2))
        }
        (p, false) if p == half => {
            let scale = build.root(square.clone());
            let at = |x: &Expr| {
                let long = build.product(vec![scale.clone(), x.clone()]);
                build.call(Function::Ln, build.sum(vec![long, build.root(placed(ring, base, x))]))
            };
            build.quotient(difference(build, at, |_| Err(NoFormula::Diverges), ends)?, scale.clone())
        }
        (Ratio { numerator: -3, denominator: 2 }, _) => {
            let at = |x: &Expr| {
                let root = build.root(placed(ring, base, x));
                build.quotient(x.clone(), build.product(vec![constant.clone(), root]))
            };
            let far = build.quotient(build.whole(1), build.product(vec![constant.clone(), build.root(square.clone())]));
            difference(build, at, |up| Ok(signed(up, far.clone())), ends)?
        }
        _ => return Err(NoFormula::Unknown),
    };
    build.guarded(value, guards).ok_or(NoFormula::Diverges)
}
