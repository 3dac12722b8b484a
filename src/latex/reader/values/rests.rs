//! Terms that are left out at the end of a sum, `+ \dots` and `+ O(x^3)`: the powers that an order names.

use crate::formula::SymbolId;
use crate::formula::symbols::Name;
use crate::formula::tree::{Expr, Node};
use crate::source::Fault;

use super::super::super::layout::Item;
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// What stands for terms that are left out, with what stands in its `O(…)`.
    pub(in super::super) fn rest(&mut self, item: &Item, order: Option<&[Item]>) -> Read<Expr> {
        let span = item.span;
        // For reading only it may stand beside vectors and operators.
        if self.symbols.open {
            return Ok(self.label(std::slice::from_ref(item), span));
        }
        let Some(order) = order else { return Ok(Expr::new(Node::Rest(Vec::new()), span)) };
        if self.symbols.find(&Name::plain("O")).is_some() {
            return Err(Fault::ambiguous(span, "O(…) may be an order of magnitude, or the declared symbol O")
                .help("rename the symbol O"));
        }
        let order = self.sum(order, span)?;
        let mut powers = Vec::new();
        match collect(&order, 1, &mut powers) {
            Some(()) => Ok(Expr::new(Node::Rest(powers), span)),
            None => Err(Fault::unsupported(span, "O(…) must contain a product of whole powers of symbols")
                .help("write, for example, O(x^3)")),
        }
    }
}

/// The whole powers of the symbols of a product.
fn collect(expr: &Expr, times: i32, powers: &mut Vec<(SymbolId, i32)>) -> Option<()> {
    match &expr.node {
        Node::Number(_) | Node::Pi => Some(()),
        Node::Symbol { id, indices, dots: 0 } if indices.is_empty() => {
            match powers.iter_mut().find(|(known, _)| known == id) {
                Some((_, power)) => *power = power.checked_add(times)?,
                None => powers.push((*id, times)),
            }
            Some(())
        }
        Node::Product(factors) => factors.iter().try_for_each(|factor| collect(factor, times, powers)),
        Node::Quotient(above, below) => {
            collect(above, times, powers)?;
            collect(below, times.checked_neg()?, powers)
        }
        Node::Power(base, exponent) => {
            let exponent: i32 = exponent.as_digits()?.parse().ok()?;
            collect(base, times.checked_mul(exponent)?, powers)
        }
        _ => None,
    }
}
