//! Units after numbers: `9.8\,\text{m/s}^2`, `\mathrm{kg\,m^{-3}}`, `\text{k}\Omega`, `25\%`, `30^\circ`.
//!
//! Upright words are units where they spell units and nothing else ([`spelled`]), and stand after a number, after a closed
//! group of numbers, or in a fraction of such quantities ([`places`]). Elsewhere they stay what they are: a subscript, a
//! name, a remark. What could be read in two ways is a fault.
//!
//! Offers `word`, upright letters as units where they are some, and `settled`, which leaves units only after numbers. Knows the layout
//! and the units of `formula`.

mod places;
mod spelled;

use crate::source::{Fault, Span};

use super::item::{Item, Layout, Units};

/// The highest power of a unit that is read.
const LARGEST: i32 = 12;

pub(super) use places::settled;

impl Units {
    fn none() -> Units {
        Units { factors: Vec::new(), fault: None, plain: Vec::new(), divides: false, is_letter: false }
    }

    /// Multiplies by other units, or divides by them.
    fn join(&mut self, other: Units, by_slash: bool, span: Span) {
        if self.divides && !by_slash || by_slash && other.divides {
            self.fault.get_or_insert_with(|| {
                Fault::ambiguous(span, "the / in this unit may divide by the next unit only, or by all units after it")
                    .help(
                        "put all units below the line in parentheses, or write negative powers, as in kg\\,m\\,s^{-2}",
                    )
            });
        }
        self.fault = self.fault.take().or(other.fault);
        self.divides |= by_slash || other.divides;
        self.is_letter = self.factors.is_empty() && other.is_letter;
        let sign = if by_slash { -1 } else { 1 };
        self.factors.extend(other.factors.into_iter().map(|(unit, exponent)| (unit, sign * exponent)));
    }

    /// Raises the last unit to a power, as people read `\text{m/s}^2`.
    fn raise(&mut self, power: i32, span: Span) {
        let Some((unit, exponent)) = self.factors.last_mut() else { return };
        // In Britain `ms^{-1}` is a metre per second.
        if power < 0 && unit.symbol() == "ms" {
            self.fault = Some(
                Fault::ambiguous(span, "ms^{-1} may be a metre per second, or one per millisecond")
                    .help("write m\\,s^{-1} or (ms)^{-1}"),
            );
        }
        match exponent.checked_mul(power).filter(|product| product.abs() <= LARGEST) {
            Some(product) => *exponent = product,
            None => {
                let fault = Fault::unsupported(span, "this power of a unit is too high");
                self.fault = Some(fault.help(format!("write a power of at most {LARGEST}")));
            }
        }
    }
}

/// An upright word with its argument. It may be units, which its place decides.
pub(super) fn word(word: Layout, argument: &Item, span: Span) -> Item {
    let is_text = matches!(word, Layout::Text(_));
    let item = Item { layout: word, span };
    match spelled::candidate(&item, argument, is_text) {
        Some(found) => Item { layout: Layout::Unit(found), span },
        None => item,
    }
}

/// The whole number, with a sign perhaps, that a superscript is.
fn exponent(item: &Item) -> Option<i32> {
    let items = match &item.layout {
        Layout::Group(items) => items.as_slice(),
        _ => std::slice::from_ref(item),
    };
    let (sign, number) = match items {
        [Item { layout: Layout::Other('-' | '−'), .. }, number] => (-1, number),
        [Item { layout: Layout::Other('+'), .. }, number] | [number] => (1, number),
        _ => return None,
    };
    match &number.layout {
        Layout::Number(digits) => {
            digits.parse().ok().filter(|value| (1..=LARGEST).contains(value)).map(|value: i32| sign * value)
        }
        _ => None,
    }
}
