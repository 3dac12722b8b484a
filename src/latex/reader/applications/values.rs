//! Values that a relation in the parenthesis tells: at an instant, `x(t = 0)`, and the probability of an event, `P(T > t)`.

use crate::formula::SymbolId;
use crate::formula::tree::Expr;

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::state::{Read, Reader};
use super::super::undeclared::is_probability;

impl Reader<'_> {
    /// `x(t = 0)`: the value where the argument is the one that is given. No factor holds an equation.
    pub(super) fn at_an_instant(
        &mut self,
        expr: &Expr,
        sup: Option<&Item>,
        fence: &Item,
        cursor: &mut usize,
    ) -> Read<Option<Expr>> {
        let Layout::Fence(Delimiter::Round, inside) = &fence.layout else { return Ok(None) };
        let sides: Vec<&[Item]> = inside.split(|item| item.layout == Layout::Other('=')).collect();
        let ([argument, value], None) = (sides.as_slice(), sup) else { return Ok(None) };
        let is_name = |item: &Item| names::printed(item, None).is_some_and(|found| found.sup.is_none());
        let mut solid = argument.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        if !solid.next().is_some_and(is_name) || solid.next().is_some() {
            return Ok(None);
        }
        *cursor += 1;
        let (left, right) = (self.sum(argument, fence.span)?, self.sum(value, fence.span)?);
        let span = expr.span.to(fence.span);
        Ok(Some(self.template("#(#=#)", vec![expr.clone(), left, right], span)))
    }

    /// `P(T > t)`: no factor holds a comparison.
    pub(super) fn of_an_event(
        &mut self,
        expr: &Expr,
        id: SymbolId,
        sup: Option<&Item>,
        fence: &Item,
        cursor: &mut usize,
    ) -> Read<Option<Expr>> {
        let (Layout::Fence(Delimiter::Round, inside), None) = (&fence.layout, sup) else { return Ok(None) };
        let compares = inside.iter().any(|item| relation(item).is_some());
        if !compares || !is_probability(&self.symbols.entry(id).name) {
            return Ok(None);
        }
        *cursor += 1;
        let event = self.event(inside, fence.span)?;
        self.is_shown_as_a_function(id);
        Ok(Some(self.template("#(#)", vec![expr.clone(), event], expr.span.to(fence.span))))
    }
}
