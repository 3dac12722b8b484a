//! The letter e: Euler's number with an exponent, or a symbol.

use crate::formula::symbols::Name;
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};
use crate::suggest::declaration;

use super::super::super::layout::{Item, Layout, contents};
use super::super::super::lexer::Space;
use super::super::super::names::Printed;
use super::super::super::rows::relation;
use super::super::items::is_numeric_item;
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// `e^{x}` as a power of Euler's number; `None`, where the name is another one, or a symbol. `next` is the item behind it.
    ///
    /// # Errors
    /// Where the letter may be either.
    pub(super) fn eulers_number(
        &mut self,
        printed: &Printed<'_>,
        span: Span,
        next: Option<&Item>,
    ) -> Read<Option<Expr>> {
        let name = &printed.name;
        if name.base != "e" && name.base != "\\mathrm{e}" {
            return Ok(None);
        }
        let declared = self.symbols.find(name).is_some();
        // No letter is raised to a decimal number.
        let is_figure = |sup: &Item| is_figure(sup) && !is_decimal(sup) && !self.symbols.inferred.e_is_number;
        let is_power = |sup: &Item| self.symbols.inferred.charge && is_figure(sup);
        if let (false, true, Some(sup), 0) = (declared, name.subscript.is_empty(), printed.sup, printed.dots)
            && !is_power(sup)
        {
            // In notes a symbol is hardly ever printed with a negative power.
            if name.base == "e" && is_figure(sup) && (self.symbols.open || !is_negative(sup)) {
                return Err(Fault::ambiguous(span, "e^2 may be the exponential exp(2) or the square of a symbol e")
                    .help(format!("write \\exp(2) for the exponential, or {}", declaration("e", 0))));
            }
            let is_known = self.symbols.imaginary.contains(&Name::plain("j")) || self.symbols.imaginary_j_here;
            if self.symbols.open && !is_known && mentions_j(sup) {
                return Err(Fault::ambiguous(sup.span, "j in an exponent of e may be √−1 or a symbol")
                    .help("write i for √−1, or declare j as \"imaginary unit\" in a claims file; for a symbol, use another letter"));
            }
            let exponent = self.exponent_of_e(sup)?;
            let euler = Expr::new(Node::Euler, span);
            return Ok(Some(Expr::new(Node::Power(Box::new(euler), Box::new(exponent)), span)));
        }
        let by_display = self.symbols.find(name).is_some_and(|(id, _)| self.symbols.entry(id).definition.is_some());
        if let (true, Some(sup)) = (by_display, printed.sup)
            && !is_figure(sup)
        {
            return Err(Fault::ambiguous(span, "e may be Euler’s number here, or the symbol that a display defines")
                .help("write \\exp(…) for the exponential, or another letter for the symbol"));
        }
        if let (true, false, Some(sup)) = (self.is_abstract(), declared, printed.sup)
            && name.base == "e"
            && is_figure(sup)
            && !self.symbols.inferred.charge
        {
            return Err(Fault::ambiguous(span, "e^2 may be the exponential exp(2) or the square of a symbol e")
                .help("write \\exp(2) for the exponential; for a charge, use a letter such as q"));
        }
        let is_charge = self.symbols.inferred.charge && name.base == "e";
        let is_eccentricity = is_charge || self.symbols.open && name.base == "e" && next.is_some_and(is_cosine);
        if !declared && name.subscript.is_empty() && !is_eccentricity {
            // `1e3`, `3e-5`: a power of ten, as programs write it.
            let is_exponent = |item: &&Item| {
                item.span.start == span.end && matches!(item.layout, Layout::Number(_) | Layout::Other('-'))
            };
            if self.symbols.open && next.as_ref().is_some_and(is_exponent) {
                return Err(Fault::ambiguous(
                    span,
                    "e between two numbers may mark a power of ten, or be Euler’s number or a symbol",
                )
                .help("write 1 \\cdot 10^{3} for the power of ten, and \\exp(1) for Euler’s number"));
            }
            return Err(Fault::ambiguous(span, "e may be Euler’s number, 2.718…, or a symbol").help(
                match self.symbols.open {
                    true => "write \\exp(1) for the number, and another letter for a symbol".to_owned(),
                    false => format!("write \\exp(1) for the number, or {}", declaration("e", 0)),
                },
            ));
        }
        Ok(None)
    }
}

/// Whether an exponent has no letters: `2`, `-1`, `0.5`, `1/3`.
fn is_figure(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(_) => true,
        Layout::Other(c) => matches!(c, '-' | '+' | '/'),
        Layout::Group(items) => items.iter().all(is_figure),
        Layout::Fraction(above, below) => is_figure(above) && is_figure(below),
        _ => false,
    }
}

/// Whether an exponent begins with a minus.
fn is_negative(item: &Item) -> bool {
    matches!(&item.layout, Layout::Group(items) if matches!(items.first(), Some(Item { layout: Layout::Other('-'), .. })))
}

/// Whether an exponent is a decimal number or a fraction, and no half.
fn is_decimal(item: &Item) -> bool {
    let is_two = |item: &Item| item.layout == Layout::Number("2".to_owned());
    let divides = |pair: &[Item]| pair[0].layout == Layout::Other('/') && !is_two(&pair[1]);
    match &item.layout {
        Layout::Number(digits) => digits.split_once('.').is_some_and(|(_, decimals)| decimals != "5"),
        Layout::Fraction(_, below) => !matches!(contents(below), [two] if is_two(two)),
        Layout::Group(items) => items.iter().any(is_decimal) || items.windows(2).any(divides),
        _ => false,
    }
}

/// Whether a side of an equation has numbers and powers of e and nothing else, and a number stands beside the power or on a side next to
/// it, `1 - e^{-2} \approx 0.86`: there e is Euler's number.
pub fn is_a_number(items: &[Item]) -> bool {
    let ends = |item: &Item| {
        relation(item).is_some()
            || matches!(
                item.layout,
                Layout::Other(',' | ';') | Layout::Row | Layout::Text(_) | Layout::Space(Space::Wide)
            )
    };
    let is_power = |item: &Item| {
        matches!(&item.layout, Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
            if nucleus.layout == Layout::Letter('e') && is_figure(sup))
    };
    let is_figure = |item: &Item| {
        matches!(item.layout, Layout::Number(_) | Layout::Other('+' | '-' | '.'))
            || is_numeric_item(item)
            || is_power(item)
    };
    let is_blank = |item: &Item| matches!(item.layout, Layout::Space(_) | Layout::Align);
    let sides: Vec<Vec<&Item>> =
        items.split(ends).map(|side| side.iter().filter(|item| !is_blank(item)).collect()).collect();
    let is_decimal = |side: Option<&Vec<&Item>>| {
        side.and_then(|side| side.first())
            .is_some_and(|first| matches!(&first.layout, Layout::Number(digits) if digits.contains('.')))
    };
    let here = (0..sides.len()).any(|at| {
        let side = &sides[at];
        let is_sum = side.iter().any(|item| matches!(item.layout, Layout::Number(_)))
            && side.iter().any(|item| matches!(item.layout, Layout::Other('+' | '-')));
        let is_negative =
            |item: &Item| matches!(&item.layout, Layout::Scripts { sup: Some(sup), .. } if is_negative(sup));
        side.iter().any(|item| is_power(item))
            && side.iter().all(|item| is_figure(item))
            && (is_sum && side.iter().any(|item| is_negative(item)) || is_decimal(sides.get(at + 1)))
    });
    here || items.iter().any(|item| match &item.layout {
        Layout::Environment(_, rows) => rows.iter().any(|row| is_a_number(&row.concat())),
        _ => false,
    })
}

/// Whether the letter j stands in an exponent, outside of subscripts.
fn mentions_j(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter(c) => *c == 'j',
        Layout::Group(items) | Layout::Fence(_, items) => items.iter().any(mentions_j),
        Layout::Fraction(above, below) => mentions_j(above) || mentions_j(below),
        _ => false,
    }
}

/// `\cos`, before which an e is an eccentricity.
fn is_cosine(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == "\\cos")
}
