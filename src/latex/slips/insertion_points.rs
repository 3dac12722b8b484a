//! The places in a text where a term or a factor may be missing: after the last term of a sum, and after the last
//! factor of a product.

use crate::formula::Symbols;
use crate::source::Span;

use super::super::layout::{Item, Layout, typeset_items};
use super::super::macros::Macros;
use super::edit::{Edit, Slip, bold};
use super::finder::Finder;
use super::parts::{formulas, insides};

/// A place where a term or a factor may be missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InsertionPoint {
    /// The byte of the place.
    pub at: usize,
    /// [`Slip::Term`] or [`Slip::Factor`].
    pub slip: Slip,
    /// The number of terms or factors beside the place.
    pub beside: usize,
    /// The span of those terms or factors.
    pub whole: Span,
}

impl InsertionPoint {
    /// The edit that inserts a term with this sign, or a factor, for which the sign is not used.
    pub fn filled(&self, sign: char, formula: &str) -> Edit {
        let replacement = match self.slip {
            Slip::Term => format!(" {sign} {formula}"),
            _ => format!(" \\, {formula}"),
        };
        Edit { span: Span::at(self.at), replacement: bold(replacement), slip: self.slip }
    }
}

/// The places in a text where a term or a factor may be missing. There are none beside a zero.
pub fn insertion_points(text: &str, symbols: &Symbols, macros: &Macros) -> Vec<InsertionPoint> {
    let Ok(items) = typeset_items(text, macros) else { return Vec::new() };
    let finder = Finder::new(text, symbols, None);
    let mut holes = Vec::new();
    finder.holes(&items, &mut holes);
    holes
}

impl Finder<'_> {
    fn holes(&self, items: &[Item], holes: &mut Vec<InsertionPoint>) {
        let mut add = |whole: Span, slip, beside| {
            let hole = InsertionPoint { at: whole.end, slip, beside, whole };
            if !holes.iter().any(|known| known.at == hole.at && known.slip == slip) {
                holes.push(hole);
            }
        };
        for terms in formulas(items) {
            if terms.iter().any(|term| self.is_null(term)) {
                continue;
            }
            for term in &terms {
                let factors = self.factors(term.items);
                if let (Some(first), Some(last)) = (factors.first(), factors.last()) {
                    add(first.span().to(last.span()), Slip::Factor, factors.len());
                }
            }
            if let (Some(first), Some(last)) = (terms.first(), terms.last()) {
                add(first.span().to(last.span()), Slip::Term, terms.len());
            }
        }
        for item in items {
            // The parts of a name are no formulas.
            if !matches!(item.layout, Layout::Accent(..) | Layout::Style(..)) {
                insides(item).into_iter().for_each(|inner| self.holes(inner, holes));
            }
        }
    }
}
