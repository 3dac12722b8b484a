//! Quantities in messages: a number, a space, and the units with their powers, `0.0253 kg m s⁻¹`, as a dimension is written too.

use crate::formula::symbols::Symbols;
use crate::formula::units::power_of_unit;
use crate::formula::{Expr, Node, Sign, text};

use super::quantity::{self, Printed, quantity};

/// A quantity as it is printed, with its units in this notation; any other formula as formulas are written.
pub(crate) fn shown(expr: &Expr, symbols: &Symbols) -> String {
    let whole = || text::formula(expr, symbols);
    let Some(printed) = Printed::of(expr) else { return whole() };
    with_units(printed.digits.to_owned(), &printed.rest, symbols).unwrap_or_else(whole)
}

/// A number with its powers of ten and its units; `None` where a factor is neither.
pub(super) fn with_units(number: String, rest: &[&Expr], symbols: &Symbols) -> Option<String> {
    let (powers, units): (Vec<&Expr>, Vec<&Expr>) =
        rest.iter().copied().partition(|part| quantity::is_power_of_ten(part));
    let mut text = number;
    powers.iter().for_each(|power| text.push_str(&format!("·{}", text::formula(power, symbols))));
    let mut factors: Vec<(String, bool, i32)> = Vec::new();
    for unit in units {
        collect(unit, 1, &mut factors)?;
    }
    for (unit, is_sign, power) in factors.iter().filter(|(_, _, power)| *power != 0) {
        // A degree or a percent sign stands close to its number.
        let space = if *is_sign { "" } else { " " };
        text.push_str(&format!("{space}{}", power_of_unit(unit, *power)));
    }
    Some(text)
}

/// Adds the units of a formula with their powers, each unit once.
fn collect(expr: &Expr, power: i32, into: &mut Vec<(String, bool, i32)>) -> Option<()> {
    match &expr.node {
        Node::Unit(unit) => {
            let symbol = unit.symbol();
            match into.iter_mut().find(|(known, ..)| *known == symbol) {
                Some((_, _, known)) => *known += power,
                None => into.push((symbol, unit.is_sign(), power)),
            }
            Some(())
        }
        Node::Product(factors) => factors.iter().try_for_each(|factor| collect(factor, power, into)),
        Node::Quotient(above, below) => {
            collect(above, power, into)?;
            collect(below, -power, into)
        }
        Node::Power(base, exponent) => {
            let exponent = quantity(exponent).ok()?.value;
            (exponent.fract() == 0.0 && exponent.abs() < 100.0).then_some(())?;
            collect(base, power * exponent as i32, into)
        }
        Node::Sum(terms) => match terms.as_slice() {
            [only] if only.sign == Sign::Plus => collect(&only.expr, power, into),
            _ => None,
        },
        Node::Number(digits) if digits == "1" => Some(()),
        _ => None,
    }
}
