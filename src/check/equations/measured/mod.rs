//! Results with units: `v = 9.8\,\text{m/s}^2 \times 2.0\,\text{s} = 19.6\,\text{m/s}`.
//!
//! Printed decimals are measured or rounded, so = between them means: equal to the printed digits. A result is wrong only if
//! no numbers that are rounded to the printed ones give it. Authors cut digits off, round in steps and take 3.14 for π, so
//! a little more is allowed. What lies between "agrees" and "wrong" is not decided.
//!
//! A quantity beside a letter, `m = 2.0\,\text{kg}`, gives the letter a value in an example, and says nothing about it
//! elsewhere: it is no definition, and no premise. Numbers that are put into a formula must have its shape, each letter one
//! value; where they have another one, nothing is said about them.
//!
//! Offers `measured`, the finding on a result with units, `misfit`, and `compared` for two numbers. Knows `document`, `sample` and
//! below.

mod natural;
mod printed_units;
mod quantity;
mod substitution;

use std::f64::consts::TAU;

use crate::code::Code;
use crate::formula::units::in_si::has_units;
use crate::formula::units::{Dimension, Unit, UnitCheck};
use crate::formula::{Expr, Node, Relation, Statement, text};
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

pub(crate) use printed_units::shown as shown_quantity;
use quantity::{Printed, Quantity, Trouble, has_decimals, quantity};

/// The relative distance of two results that are equal: authors round in steps, and take 3.14 for π.
const STEPS: f64 = 0.005;

/// The same for ≈.
const ROUGHLY: f64 = 0.1;

/// The same where three digits or more are printed.
const WITH_DIGITS: f64 = 0.03;

/// The same for numbers that are put into a formula.
const PUT_IN: f64 = 0.01;

/// A number of at least so many times its last digit has three digits.
const THREE_DIGITS: f64 = 100.0;

/// The relative distance from which on a conversion of units is wrong: tables round, and authors say that a year has 3·10⁷ s.
const MISCONVERTED: f64 = 0.25;

/// The relative distance of two numbers that are the same double.
const EQUAL: f64 = 1e-12;

/// The deepest chain of definitions that is written out.
const DEEPEST: usize = 8;

impl Checker<'_> {
    /// The finding on the link of a statement that begins at member `at`, if units stand in it and it compares numbers, or
    /// gives a letter a value. `is_introduced` says that the link defines the letter. `None` where it is judged as any other.
    pub(crate) fn measured(
        &self,
        statement: &Statement,
        (at, is_introduced): (usize, bool),
        claim: &Claim,
        context: &Context<'_>,
    ) -> Option<Finding> {
        if is_introduced {
            let [name, value] = [&statement.members[at], &statement.members[at + 1]];
            let is_value = at == 0 && has_units(value) && self.is_value(value, 0) && name.as_plain_symbol().is_some();
            return is_value.then(|| self.value(name, value, context));
        }
        let relation = statement.relations[at].0;
        let is_approximate = relation == Relation::Approximately;
        let says_more = !claim.assume.is_empty() || !claim.small.is_empty() || claim.limit.is_some();
        if !is_equality(relation) && !is_approximate || says_more {
            return None;
        }
        let sides = [self.with_values(&statement.members[at]), self.with_values(&statement.members[at + 1])];
        let is_number = sides.each_ref().map(|side| side.symbols().is_empty());
        let has_unit = sides.each_ref().map(has_units);
        let is_rounded = sides.iter().any(has_decimals) && (is_approximate || context.options.deduction);
        let [left, right] = &sides;
        match (is_number, has_unit) {
            ([true, true], [false, false]) if !is_rounded => None,
            // The uncertainty of a measurement is no sign that may be chosen.
            ([true, true], _) if statement.branch.is_some() => {
                Some(undecided(context, "numbers with ± are not compared"))
            }
            // What has no unit and is no rounded number, such as a matrix, is judged as any other formula.
            ([true, true], [false, false]) if sides.iter().any(|side| quantity(side).is_err()) || agree(&sides) => None,
            ([true, true], _) => Some(judged(left, right, is_approximate, context)),
            ([false, true], [_, true]) | ([true, false], [true, _]) => {
                let (formula, printed) = if is_number[1] { (0, right) } else { (1, left) };
                Some(self.value(&statement.members[at + formula], printed, context))
            }
            _ => None,
        }
    }

    /// The finding on the first term with the wrong unit of a statement with units and letters, where no units are declared.
    pub(crate) fn misfit(&self, statement: &Statement, offset: usize) -> Option<Finding> {
        let has_letters = statement.members.iter().any(|member| !member.symbols().is_empty());
        if self.units.is_some() || !has_letters || !statement.members.iter().any(has_units) {
            return None;
        }
        // Numbers alone are compared by themselves.
        let parts = statement.members.iter().filter(|member| !member.symbols().is_empty());
        let mut check = UnitCheck::new(&self.model.symbols);
        let mismatch = parts.filter_map(|part| check.dimension(part).err()).next()?;
        let message = format!("the units do not fit: {}", mismatch.message);
        Some(Finding::new(Code::UnitMismatch, Verdict::Unreadable, mismatch.span.shifted(offset), message))
    }

    /// A quantity for a letter or for a formula.
    fn value(&self, formula: &Expr, printed: &Expr, context: &Context<'_>) -> Finding {
        if let Err(trouble) = quantity(printed)
            && let Some(found) = misfit_of_terms(&trouble, printed, context)
        {
            return found;
        }
        let shown = text::formula(formula, &self.model.symbols);
        if formula.as_plain_symbol().is_some() {
            return context.finding(Code::Introduced, Verdict::Definition, format!("gives {shown} a value"));
        }
        match substitution::found(formula, printed) {
            Some(values) => {
                let name = |id| text::plain(&self.model.name(id));
                let shown_value = |value: &Expr| printed_units::shown(value, &self.model.symbols);
                let values: Vec<String> =
                    values.iter().map(|(id, value)| format!("{} = {}", name(*id), shown_value(value))).collect();
                context.finding(Code::Introduced, Verdict::Definition, format!("inserts {}", values.join(", ")))
            }
            None => {
                let message = format!(
                    "the numbers for {shown} were not checked; write {shown} with the value of each letter in its place"
                );
                context.finding(Code::Assumed, Verdict::Assumed, message)
            }
        }
    }

    /// A formula with the values of the names that formulas of numbers define.
    fn with_values(&self, formula: &Expr) -> Expr {
        let mut formula = formula.clone();
        for _ in 0..DEEPEST {
            let value = |id| match self.model.meaning(id) {
                Some(Meaning::Defined(value)) if self.is_value(value, DEEPEST) => Some((id, value.as_ref().clone())),
                _ => None,
            };
            let values: Vec<_> = formula.symbols().into_iter().filter_map(|(id, _)| value(id)).collect();
            if values.is_empty() {
                break;
            }
            formula.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, .. } => {
                    values.iter().find(|(known, _)| known == id).map(|(_, value)| value.clone())
                }
                _ => None,
            });
        }
        formula
    }

    /// Whether a formula is a number with units, by definitions perhaps.
    fn is_value(&self, formula: &Expr, depth: usize) -> bool {
        let is_one = |id| match self.model.meaning(id) {
            Some(Meaning::Defined(inner)) => depth > 0 && self.is_value(inner, depth - 1),
            _ => false,
        };
        formula.symbols().into_iter().all(|(id, _)| is_one(id))
    }
}

/// How two formulas of numbers and units compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Comparison {
    /// They are equal to the printed digits, or to one part in a hundred: authors round what they put in.
    Agree,
    /// No rounding explains the difference.
    Differ,
    /// Nobody can tell.
    Open,
}

/// Compares two formulas of numbers and units.
pub(crate) fn compared(left: &Expr, right: &Expr, is_approximate: bool, context: &Context<'_>) -> Comparison {
    let is_near = match (quantity(left), quantity(right)) {
        (Ok(a), Ok(b)) => {
            let size = a.value.abs().max(b.value.abs());
            a.dimension == b.dimension && (a.value - b.value).abs() < PUT_IN * size
        }
        _ => false,
    };
    match judged(left, right, is_approximate, context).verdict {
        _ if is_near => Comparison::Agree,
        Verdict::Verified => Comparison::Agree,
        Verdict::Refuted => Comparison::Differ,
        _ => Comparison::Open,
    }
}

/// The unit of a formula of numbers and units and that of a printed value, if they do not fit.
pub(crate) fn other_units(formula: &Expr, printed: &Expr, context: &Context<'_>) -> Option<[String; 2]> {
    let [a, b] = [quantity(formula).ok()?, quantity(printed).ok()?];
    let differ = a.dimension != b.dimension && judged(formula, printed, false, context).verdict == Verdict::Refuted;
    differ.then(|| [a.dimension.to_string(), b.dimension.to_string()])
}

/// Whether a formula of numbers and units gives the printed value to its last digit.
pub(crate) fn agree_to_the_digits(formula: &Expr, printed: &Expr, context: &Context<'_>) -> bool {
    judged(formula, printed, false, context).verdict == Verdict::Verified
}

/// The value of a formula of numbers and units in the unit of a printed value, and that value, for messages; `None` if their units
/// differ.
pub(crate) fn in_words(formula: &Expr, printed: &Expr, context: &Context<'_>) -> Option<(String, String)> {
    let value = quantity(formula).ok()?;
    quantity(printed).ok().filter(|other| other.dimension == value.dimension)?;
    let shown = printed_units::shown(printed, &context.model.symbols);
    let computed = match Printed::of(printed) {
        Some(unit) => in_unit(value.value, &unit, context),
        None => in_si(&value),
    };
    Some((computed, shown))
}

/// Whether a number is exactly one of a unit, as in `1\,\text{h} = 3600\,\text{s}`.
fn is_one_unit(side: &Expr) -> bool {
    Printed::of(side).is_some_and(|printed| printed.digits == "1" && !printed.rest.is_empty())
}

/// Whether two numbers are the same.
fn agree(sides: &[Expr; 2]) -> bool {
    let [Ok(a), Ok(b)] = sides.each_ref().map(quantity) else { return false };
    (a.value - b.value).abs() <= EQUAL * a.value.abs().max(b.value.abs())
}

fn undecided(context: &Context<'_>, message: impl Into<String>) -> Finding {
    context.finding(Code::NotDecided, Verdict::Undecided, message)
}

fn misfit_of_terms(trouble: &Trouble, side: &Expr, context: &Context<'_>) -> Option<Finding> {
    let Trouble::Misfit(units) = trouble else { return None };
    let [first, second] = units.as_ref();
    if quantity::any_unit(side, |unit| unit.is_natural()) {
        return Some(undecided(
            context,
            "the units of the terms fit only if constants of nature are 1, so this was not decided",
        ));
    }
    let message = format!("the units do not fit: {first} and {second} are added");
    Some(context.finding(Code::NumbersDiffer, Verdict::Refuted, message))
}

/// The finding on two formulas of numbers and units.
fn judged(left: &Expr, right: &Expr, is_approximate: bool, context: &Context<'_>) -> Finding {
    let mut values = Vec::new();
    for side in [left, right] {
        match quantity(side) {
            Ok(found) => values.push(found),
            Err(trouble) => {
                return misfit_of_terms(&trouble, side, context).unwrap_or_else(|| match trouble {
                    Trouble::LacksUnit => undecided(context, "one term has a unit, and another term has none"),
                    _ => undecided(context, "the value of this formula could not be computed"),
                });
            }
        }
    }
    let [a, b] = [values[0], values[1]];
    if !(a.value.is_finite() && b.value.is_finite()) {
        return undecided(context, "these numbers are too large or too small to compare");
    }
    let is_zero = |side: &Quantity| side.value == 0.0;
    // A zero without a unit may stand for any quantity.
    let is_bare_zero = |side: &Quantity| is_zero(side) && side.dimension.is_none();
    if a.dimension != b.dimension && !is_bare_zero(&a) && !is_bare_zero(&b) {
        return of_units([left, right], [a, b], context);
    }
    let printed = [Printed::of(left), Printed::of(right)];
    let off = (a.value - b.value).abs();
    let size = a.value.abs().max(b.value.abs());
    // Of 250 after ≈ the tens may be the last digit.
    let half_a_digit = |printed: &Printed<'_>| match is_approximate {
        true => 0.5 * printed.digit(),
        false => printed.half_a_digit(),
    };
    let half = printed.iter().flatten().map(half_a_digit).fold(EQUAL * size, f64::max);
    if off <= half * (1.0 + EQUAL) {
        let about = "rounded numbers";
        return context.verified("the numbers agree to the printed digits", about);
    }
    if is_zero(&a) || is_zero(&b) {
        return undecided(context, "a number that is rounded to 0 is not compared");
    }
    // Who prints three digits after ≈ does not mean a tenth more or less.
    let has_digits = printed.iter().flatten().any(|printed| size >= THREE_DIGITS * printed.digit());
    let share = match (is_approximate, has_digits) {
        (true, false) => ROUGHLY,
        (true, true) => WITH_DIGITS,
        (false, _) => STEPS,
    };
    let slack = printed.iter().flatten().map(Printed::digit).fold(share * size, f64::max);
    // After ≈ a power of ten alone is an order of magnitude.
    if is_approximate && [left, right].iter().any(|side| is_order(side)) {
        let ratio = (a.value / b.value).abs();
        return match ratio.max(1.0 / ratio) {
            ratio if ratio <= 10.0_f64.sqrt() => {
                context.verified("the numbers have the same order of magnitude", "rounded numbers")
            }
            _ => {
                undecided(context, "the numbers differ, but a power of ten may be meant as a rough order of magnitude")
            }
        };
    }
    // One of a unit is exact: a conversion that is off by more than a rough value is wrong.
    let is_conversion = printed.iter().all(Option::is_some) && [left, right].into_iter().any(is_one_unit);
    let is_apart = a.range.low - slack > b.range.high
        || b.range.low - slack > a.range.high
        || is_conversion && !is_approximate && off > MISCONVERTED * size;
    if is_apart && let Some(reason) = by_custom([left, right], [a, b]) {
        return undecided(context, reason);
    }
    let (computed, shown) = match &printed {
        [_, Some(right)] => (a.value, right),
        [Some(left), _] => (b.value, left),
        _ if !is_apart => return undecided(context, "the numbers agree only within their rounding"),
        _ => {
            let message = format!("the left side is {}, and the right side {}", in_si(&a), in_si(&b));
            return context.finding(Code::NumbersDiffer, Verdict::Refuted, message);
        }
    };
    let computed = in_unit(computed, shown, context);
    match is_apart {
        true => {
            let printed = printed_units::shown(if printed[1].is_some() { right } else { left }, &context.model.symbols);
            let message = format!("the numbers give {computed}, and {printed} is printed");
            context.finding(Code::NumbersDiffer, Verdict::Refuted, message)
        }
        false => undecided(
            context,
            format!(
                "the numbers give {computed}, and {} is printed; the numbers have too few digits to call this wrong",
                printed_units::shown(if printed[1].is_some() { right } else { left }, &context.model.symbols)
            ),
        ),
    }
}

/// Whether a side is a power of ten alone, perhaps with a unit.
fn is_order(side: &Expr) -> bool {
    let parts: Vec<&Expr> = match &side.node {
        Node::Product(factors) => factors.iter().collect(),
        _ => vec![side],
    };
    let (powers, units): (Vec<&Expr>, Vec<&Expr>) = parts.into_iter().partition(|part| quantity::is_power_of_ten(part));
    powers.len() == 1
        && units.iter().all(|part| quantity(part).is_ok_and(|unit| !unit.dimension.is_none()) && !has_number(part))
}

/// Whether a formula contains a printed number outside of exponents.
fn has_number(part: &Expr) -> bool {
    match &part.node {
        Node::Product(factors) => factors.iter().any(has_number),
        Node::Quotient(above, below) => has_number(above) || has_number(below),
        Node::Power(base, _) => has_number(base),
        _ => part.as_digits().is_some(),
    }
}

/// Why numbers that differ may be meant as equal: by a custom of authors that is no slip.
fn by_custom(sides: [&Expr; 2], [a, b]: [Quantity; 2]) -> Option<&'static str> {
    const NEAR: f64 = 0.02;
    let is_ratio = |wanted: f64| [a.value / b.value, b.value / a.value].iter().any(|r| (r / wanted - 1.0).abs() < NEAR);
    let any_unit = |is_it: fn(Unit) -> bool| sides.iter().any(|side| quantity::any_unit(side, is_it));
    if any_unit(|unit| unit.is_sign() && !unit.is_degree()) && is_ratio(100.0) {
        return Some("the two sides differ by a factor of 100, which may come from the percent sign");
    }
    if a.dimension == Dimension::of(0, 0, -1) && is_ratio(TAU) {
        return Some("the two sides differ by a factor of 2π: one may count turns, and the other may be an angle");
    }
    let in_degrees = any_unit(Unit::is_degree);
    (!in_degrees && sides.iter().any(|side| quantity::has_inverse(side)))
        .then_some("the numbers differ, but the angle may be in degrees without the sign °")
}

/// The finding on two quantities with different units.
fn of_units(sides: [&Expr; 2], [a, b]: [Quantity; 2], context: &Context<'_>) -> Finding {
    let is_count = |dimension: Dimension| {
        let mut others = dimension;
        others.0[5] = a.dimension.0[5];
        others == a.dimension
    };
    let is_natural = sides.iter().any(|side| quantity::any_unit(side, |unit| unit.is_natural()));
    if sides.iter().any(|side| quantity::any_unit(side, |unit| unit.is_doubtful())) {
        return undecided(
            context,
            "the units differ, but a letter may have another meaning here: C as °C, or g as the acceleration",
        );
    }
    if a.dimension.is_none() || b.dimension.is_none() {
        return undecided(context, "one side has a unit, and the other is a number without a unit");
    }
    if is_count(b.dimension) {
        return undecided(context, "the units differ only in mol, so this was not decided");
    }
    if is_natural || natural::are_equal(a, b) {
        return undecided(context, "the units agree only if constants of nature are 1, so this was not decided");
    }
    let message =
        format!("the units do not fit: the left side is in {}, the right side in {}", a.dimension, b.dimension);
    context.finding(Code::NumbersDiffer, Verdict::Refuted, message)
}

/// A value in units of the SI.
fn in_si(quantity: &Quantity) -> String {
    match quantity.dimension.is_none() {
        true => digits(quantity.value),
        false => format!("{} {}", digits(quantity.value), quantity.dimension),
    }
}

/// A value in the unit of a printed result.
fn in_unit(value: f64, printed: &Printed<'_>, context: &Context<'_>) -> String {
    let powers = printed.rest.iter().filter(|part| quantity::is_power_of_ten(part));
    let power = powers.filter_map(|part| quantity(part).ok()).fold(1.0, |all, part| all * part.value);
    // In this order, so that a very large or small power does not lose the value.
    let number = digits(value / (printed.scale / power));
    let units: Vec<&Expr> = printed.rest.iter().copied().filter(|part| !quantity::is_power_of_ten(part)).collect();
    printed_units::with_units(number.clone(), &units, &context.model.symbols).unwrap_or(number)
}

/// A number with four digits that count.
fn digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let places = 3_i32.saturating_sub(value.abs().log10().floor() as i32);
    match places {
        ..-2 | 8.. => format!("{value:.3e}"),
        places => {
            let text = format!("{value:.*}", usize::try_from(places.max(0)).unwrap_or(0));
            match text.contains('.') {
                true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
                false => text,
            }
        }
    }
}
