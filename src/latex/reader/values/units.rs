//! Units after numbers, as products of powers.

use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::formula::units::Unit;
use crate::source::Span;

use super::super::super::layout::{Item, Layout, Units};
use super::super::super::names;
use super::super::items::beside;
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// Units after a number. Where what is printed is the name of a symbol, it is that symbol.
    pub(in super::super) fn units(&mut self, units: &Units, span: Span) -> Read<Expr> {
        if units.plain.iter().any(|item| self.names_a_symbol(item)) {
            return self.sum(&units.plain, span);
        }
        if let Some(fault) = &units.fault {
            return Err(fault.clone());
        }
        let part = |above: bool| -> Vec<Expr> {
            let chosen = units.factors.iter().filter(|(_, exponent)| (*exponent > 0) == above);
            chosen.map(|(unit, exponent)| power(*unit, exponent.unsigned_abs(), false, span)).collect()
        };
        let (above, below) = (part(true), part(false));
        Ok(match (above.is_empty(), below.is_empty()) {
            (_, true) => beside(above),
            (true, _) => {
                let factors = units.factors.iter();
                beside(factors.map(|(unit, exponent)| power(*unit, exponent.unsigned_abs(), true, span)).collect())
            }
            _ => Expr::new(Node::Quotient(Box::new(beside(above)), Box::new(beside(below))), span),
        })
    }

    fn names_a_symbol(&self, item: &Item) -> bool {
        let item = match &item.layout {
            Layout::Scripts { nucleus, sub: None, .. } => nucleus,
            _ => item,
        };
        names::printed(item, self.branch).is_some_and(|printed| self.symbols.find(&printed.name).is_some())
    }
}

fn power(unit: Unit, exponent: u32, is_negative: bool, span: Span) -> Expr {
    let base = Expr::new(Node::Unit(unit), span);
    let digits = Expr::new(Node::Number(exponent.to_string()), span);
    let exponent = match (is_negative, exponent) {
        (false, 1) => return base,
        (false, _) => digits,
        (true, _) => Expr::new(Node::Sum(vec![Term { sign: Sign::Minus, sign_span: None, expr: digits }]), span),
    };
    Expr::new(Node::Power(Box::new(base), Box::new(exponent)), span)
}
