//! Units in italic letters behind a small number: `t = 3 s`, `v = 3 m/s`.
//!
//! A letter after a number is a unit rather than a factor, if the left side is a quantity that has this unit, and if the letter stands
//! nowhere else in the display.

use crate::source::Fault;

use super::super::super::super::layout::{Item, Layout, parts, typed};
use super::super::super::super::names;
use super::sides::{first_sides, statements};

/// Quantities, and the units in which their values are given.
const UNITS: [(&str, &[&str]); 12] = [
    ("t \\tau", &["s", "h"]),
    ("x y z h d l L r R s H D \\lambda", &["m"]),
    ("m M", &["g"]),
    ("E W U K Q", &["J"]),
    ("P", &["W"]),
    ("V U \\mathcal{E}", &["V"]),
    ("I i", &["A"]),
    ("q Q", &["C"]),
    ("T \\theta", &["K"]),
    ("B", &["T"]),
    ("v u c", &["m/s"]),
    ("a g", &["m/s^2", "m/s^{2}"]),
];

/// The fault of such a unit in a display.
pub(super) fn unclear_unit(items: &[Item]) -> Option<Fault> {
    let all = statements(items);
    all.iter().find_map(|statement| {
        let ([name], [number, unit @ ..]) = first_sides(statement)? else { return None };
        let Layout::Number(_) = number.layout else { return None };
        let base = names::printed(name, None).filter(|found| found.sup.is_none() && found.dots == 0)?.name.base;
        let owned: Vec<Item> = unit.iter().map(|item| (*item).clone()).collect();
        let (first, last) = (owned.first()?, owned.last()?);
        let shown = typed(&owned);
        let is_its_own = UNITS
            .iter()
            .any(|(bases, units)| bases.split(' ').any(|known| known == base) && units.contains(&shown.as_str()));
        let letter = match &first.layout {
            Layout::Letter(letter) => *letter,
            _ => return None,
        };
        let count = items.iter().map(|item| occurrences(item, letter)).sum::<usize>();
        // `V = 5 V`: nothing is five times itself.
        let others = usize::from(base == letter.to_string());
        (is_its_own && count == 1 + others).then(|| {
            Fault::ambiguous(first.span.to(last.span), format!("{shown} may be a unit or a quantity"))
                .help(format!("write \\mathrm{{{shown}}} for the unit, and \\cdot before a quantity"))
        })
    })
}

fn occurrences(item: &Item, letter: char) -> usize {
    let inside = || parts(item).into_iter().flatten().map(|part| occurrences(part, letter)).sum();
    if item.layout == Layout::Letter(letter) { 1 } else { inside() }
}
