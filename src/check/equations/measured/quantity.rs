//! The value of a formula of numbers and units, with the spread that the rounding of its printed numbers allows.

use std::f64::consts::PI;

use crate::formula::evaluate::constant_exponent;
use crate::formula::tree::Function;
use crate::formula::units::{Dimension, Ratio, Unit};
use crate::formula::{Expr, Node, Sign};
use crate::scalar::interval::Interval;
use crate::source::Span;

/// The largest relative spread of a whole number: of 5 kg nobody means 5.4 kg, and of 57 kg perhaps 57.4 kg.
const OF_WHOLE: f64 = 0.05;

/// A number of units of the SI.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity {
    /// The value of what is printed.
    pub value: f64,
    /// The values that are rounded to what is printed.
    pub range: Interval,
    /// The unit.
    pub dimension: Dimension,
}

/// Why a formula has no value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Trouble {
    /// The terms of a sum have two units; the place of the second.
    Misfit(Span, Dimension, Dimension),
    /// A term of a sum is a number and another has a unit, or a function has an argument with a unit.
    LacksUnit(Span),
    /// Anything else.
    NoValue,
}

/// Whether a formula has a unit for which this holds.
pub(super) fn any_unit(expr: &Expr, is_it: impl Fn(Unit) -> bool) -> bool {
    let mut found = false;
    expr.walk(&mut |part| {
        if let Node::Unit(unit) = part.node {
            found |= is_it(unit);
        }
    });
    found
}

/// Whether a formula has a number with decimals.
pub(super) fn has_decimals(expr: &Expr) -> bool {
    let mut found = false;
    expr.walk(&mut |part| found |= matches!(&part.node, Node::Number(digits) if digits.contains('.')));
    found
}

/// Whether a formula is a product of units and nothing else.
pub(super) fn is_unit(expr: &Expr) -> bool {
    match &expr.node {
        Node::Unit(_) => true,
        Node::Power(base, _) => is_unit(base),
        Node::Product(factors) => factors.iter().all(is_unit),
        Node::Quotient(above, below) => is_unit(above) && is_unit(below),
        _ => false,
    }
}

/// Whether a formula is a power of ten.
pub(super) fn is_power_of_ten(expr: &Expr) -> bool {
    match &expr.node {
        Node::Power(base, exponent) => {
            base.as_digits() == Some("10") && constant_exponent(exponent).is_some_and(|exponent| exponent.is_whole())
        }
        _ => expr.as_digits().is_some_and(|digits| digits == "10"),
    }
}

/// Half a unit of the last digit that is printed.
pub(super) fn half_a_digit(digits: &str) -> f64 {
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(0))
}

fn exact(value: f64) -> Quantity {
    Quantity { value, range: Interval::point(value), dimension: Dimension::NONE }
}

/// A printed number. A whole number counts as rounded only if a unit follows it.
fn number(digits: &str, is_measured: bool) -> Result<Quantity, Trouble> {
    let value: f64 = digits.parse().map_err(|_| Trouble::NoValue)?;
    let spread = match (digits.contains('.'), is_measured) {
        (true, _) => half_a_digit(digits),
        // One unit is one unit.
        (false, true) if value != 1.0 => (OF_WHOLE * value).min(0.5),
        _ => 0.0,
    };
    Ok(Quantity { range: Interval::new(value - spread, value + spread), ..exact(value) })
}

fn unit(unit: Unit) -> Quantity {
    let (digits, ten) = unit.size();
    let digits: f64 = digits.parse().unwrap_or(1.0);
    let value = digits * 10f64.powi(ten.into()) * if unit.is_degree() { PI / 180.0 } else { 1.0 };
    let spread = value * unit.spread();
    Quantity { value, range: Interval::new(value - spread, value + spread), dimension: unit.dimension() }
}

/// The value of a formula of numbers and units.
///
/// # Errors
/// For terms that do not fit, and for what has no value here.
pub(super) fn quantity(expr: &Expr) -> Result<Quantity, Trouble> {
    match &expr.node {
        Node::Number(digits) => number(digits, false),
        Node::Pi => Ok(exact(PI)),
        Node::Euler => Ok(exact(std::f64::consts::E)),
        Node::Unit(named) => Ok(unit(*named)),
        Node::Sum(terms) => {
            let mut sum: Option<Quantity> = None;
            for term in terms {
                let found = quantity(&term.expr)?;
                let found = match term.sign {
                    Sign::Plus => found,
                    Sign::Minus => Quantity { value: -found.value, range: found.range.negated(), ..found },
                };
                sum = Some(match sum {
                    None => found,
                    Some(sum) => added(sum, found, term.expr.span)?,
                });
            }
            sum.ok_or(Trouble::NoValue)
        }
        Node::Product(factors) => {
            let mut product = exact(1.0);
            for (at, factor) in factors.iter().enumerate() {
                let next = if factors.get(at + 1).is_some_and(is_power_of_ten) { at + 2 } else { at + 1 };
                let is_measured = next > at + 1 || factors.get(next).is_some_and(is_unit);
                let found = match &factor.node {
                    Node::Number(digits) => number(digits, is_measured)?,
                    _ => quantity(factor)?,
                };
                product = times(product, found);
            }
            Ok(product)
        }
        Node::Quotient(above, below) => {
            let (above, below) = (quantity(above)?, quantity(below)?);
            if below.range.contains(0.0) {
                return Err(Trouble::NoValue);
            }
            Ok(Quantity {
                value: above.value / below.value,
                range: above.range.over(below.range),
                dimension: above.dimension.times(below.dimension.power(Ratio::whole(-1))),
            })
        }
        Node::Power(base, exponent) if base.node == Node::Euler => {
            let exponent = without_unit(exponent)?;
            Ok(Quantity { value: exponent.value.exp(), range: exponent.range.exp(), ..exponent })
        }
        Node::Power(base, exponent) => power(base, exponent),
        Node::Root(degree, radicand) => {
            let inner = quantity(radicand)?;
            let (low, high) = (inner.range.low, inner.range.high);
            let root = |x: f64| x.max(0.0).powf(1.0 / f64::from(*degree));
            if high < 0.0 || inner.value < 0.0 {
                return Err(Trouble::NoValue);
            }
            Ok(Quantity {
                value: root(inner.value),
                range: Interval::new(root(low), root(high)),
                dimension: inner.dimension.power(Ratio::new(1, i64::from(*degree))),
            })
        }
        Node::Norm(inner) => {
            let inner = quantity(inner)?;
            Ok(Quantity { value: inner.value.abs(), range: inner.range.abs(), ..inner })
        }
        Node::Call(function, argument) => call(*function, without_unit(argument)?),
        _ => Err(Trouble::NoValue),
    }
}

fn added(a: Quantity, b: Quantity, place: Span) -> Result<Quantity, Trouble> {
    match (a.dimension.is_none(), b.dimension.is_none()) {
        _ if a.dimension == b.dimension => {}
        // A zero needs no unit.
        (true, _) if a.value == 0.0 => return Ok(b),
        (_, true) if b.value == 0.0 => return Ok(a),
        (true, _) | (_, true) => return Err(Trouble::LacksUnit(place)),
        _ => return Err(Trouble::Misfit(place, a.dimension, b.dimension)),
    }
    Ok(Quantity { value: a.value + b.value, range: a.range.plus(b.range), ..a })
}

fn times(a: Quantity, b: Quantity) -> Quantity {
    Quantity { value: a.value * b.value, range: a.range.times(b.range), dimension: a.dimension.times(b.dimension) }
}

fn power(base: &Expr, exponent: &Expr) -> Result<Quantity, Trouble> {
    let inner = match (&base.node, is_unit(base)) {
        // The base of a power of ten is exact.
        (Node::Number(digits), false) => number(digits, false)?,
        _ => quantity(base)?,
    };
    let Some(ratio) = constant_exponent(exponent) else {
        let (base, exponent) = (inner, without_unit(exponent)?);
        if !base.dimension.is_none() || base.range.low <= 0.0 {
            return Err(Trouble::NoValue);
        }
        let range = base.range.real_power(exponent.range);
        return Ok(Quantity { value: base.value.powf(exponent.value), range, ..base });
    };
    let below = i64::try_from(ratio.denominator).map_err(|_| Trouble::NoValue)?;
    let above = i64::try_from(ratio.numerator).map_err(|_| Trouble::NoValue)?;
    let dimension = inner.dimension.power(Ratio::new(above, below));
    match i32::try_from(above) {
        Ok(above) if below == 1 => {
            if above < 0 && inner.range.contains(0.0) {
                return Err(Trouble::NoValue);
            }
            Ok(Quantity { value: inner.value.powi(above), range: inner.range.power(above), dimension })
        }
        _ if inner.range.low > 0.0 => {
            let exponent = above as f64 / below as f64;
            let range = inner.range.real_power(Interval::point(exponent));
            Ok(Quantity { value: inner.value.powf(exponent), range, dimension })
        }
        _ => Err(Trouble::NoValue),
    }
}

fn without_unit(expr: &Expr) -> Result<Quantity, Trouble> {
    let found = quantity(expr)?;
    match found.dimension.is_none() {
        true => Ok(found),
        false => Err(Trouble::LacksUnit(expr.span)),
    }
}

fn call(function: Function, of: Quantity) -> Result<Quantity, Trouble> {
    let Interval { low, high } = of.range;
    let is_in = |from: f64, to: f64| low >= from && high <= to;
    let (value, range) = match function {
        Function::Sin => (of.value.sin(), of.range.sin()),
        Function::Cos => (of.value.cos(), of.range.cos()),
        // Between two poles it rises.
        Function::Tan if (low / PI - 0.5).floor() == (high / PI - 0.5).floor() => {
            (of.value.tan(), of.range.rising(f64::tan))
        }
        Function::Arcsin if is_in(-1.0, 1.0) => (of.value.asin(), of.range.asin()),
        Function::Arccos if is_in(-1.0, 1.0) => (of.value.acos(), of.range.acos()),
        Function::Arctan => (of.value.atan(), of.range.rising(f64::atan)),
        Function::Sinh => (of.value.sinh(), of.range.rising(f64::sinh)),
        Function::Tanh => (of.value.tanh(), of.range.rising(f64::tanh)),
        Function::Exp => (of.value.exp(), of.range.exp()),
        Function::Ln if low > 0.0 => (of.value.ln(), of.range.ln()),
        _ => return Err(Trouble::NoValue),
    };
    Ok(Quantity { value, range, ..of })
}

/// How a result is printed: a number, perhaps with a power of ten, and its unit.
pub(super) struct Printed<'e> {
    /// The digits.
    pub digits: &'e str,
    /// What one of the number is, in units of the SI.
    pub scale: f64,
    /// The factors after the digits.
    pub rest: Vec<&'e Expr>,
}

impl<'e> Printed<'e> {
    /// The digits and the unit of a result; `None` for a formula.
    pub fn of(expr: &'e Expr) -> Option<Printed<'e>> {
        let inner = match &expr.node {
            Node::Sum(terms) => match terms.as_slice() {
                [only] => &only.expr,
                _ => return None,
            },
            _ => expr,
        };
        let factors = match &inner.node {
            Node::Product(factors) => factors.iter().collect(),
            _ => vec![inner],
        };
        let (first, rest) = factors.split_first()?;
        let Node::Number(digits) = &first.node else { return None };
        if !rest.iter().all(|factor| is_unit(factor) || is_power_of_ten(factor)) {
            return None;
        }
        let scale = rest.iter().try_fold(1.0, |all, factor| Some(all * quantity(factor).ok()?.value))?;
        Some(Printed { digits, scale, rest: rest.to_vec() })
    }

    /// Half a unit of the last digit.
    pub fn half_a_digit(&self) -> f64 {
        half_a_digit(self.digits) * self.scale.abs()
    }

    /// A unit of the last digit that may have been meant: of 300 the hundreds.
    pub fn digit(&self) -> f64 {
        let zeros = match self.digits.contains('.') {
            true => 0,
            false => self.digits.len() - self.digits.trim_end_matches('0').len(),
        };
        2.0 * self.half_a_digit() * 10f64.powi(i32::try_from(zeros).unwrap_or(0))
    }
}
