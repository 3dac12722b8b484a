//! Values of a name at what stands in its parenthesis: at an instant, `x(t = 0)`, `x(0)`, `x(t_1)` where x has a formula of the
//! time, and the probability of an event, `P(T > t)`.

use crate::formula::SymbolId;
use crate::formula::calculus::places::at;
use crate::formula::symbols::{Kind, Name};
use crate::formula::tree::Expr;

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::state::{Read, Reader};
use super::super::undeclared::is_probability;
use super::inside::{is_zero, parenthesis};

/// The deepest chain of definitions of a constant.
const DEEPEST: usize = 20;

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

    /// `x(0)`, `x(t_1)`: the value at an instant of a name with a formula of the time. Nobody multiplies such a name by a lone name or
    /// by 0 in parentheses.
    pub(super) fn at_a_time(
        &mut self,
        (expr, id): (&Expr, SymbolId),
        sup: Option<&Item>,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Option<Expr>> {
        let Some((fence, inside)) = items.get(*cursor).and_then(parenthesis).filter(|_| !self.symbols.open) else {
            return Ok(None);
        };
        let time = self.symbols.time.clone();
        let Some((letter, _)) = time.as_ref().and_then(|time| self.symbols.find(time)) else { return Ok(None) };
        let is_instant = |item: &Item| match self.lone_name(item) {
            Some((name, dots)) => dots == 0 && Some(&name) != time.as_ref() && self.stays(&name),
            None => is_zero(item),
        };
        let ([instant], Item { layout: Layout::Fence(Delimiter::Round, _), .. }) = (inside.as_slice(), fence) else {
            return Ok(None);
        };
        if !is_instant(instant) || !self.hides(id, letter, 0) {
            return Ok(None);
        }
        let Ok(formula) = self.written_out(expr, letter) else { return Ok(None) };
        let instant = self.item(instant)?;
        let mut value = at(&formula, letter, &instant);
        value.span = expr.span.to(fence.span);
        let power = match &items[*cursor].layout {
            Layout::Scripts { sup: Some(above), .. } => Some(&**above),
            _ => None,
        };
        *cursor += 1;
        match sup.or(power) {
            Some(sup) => self.raised(value, sup, expr.span.to(fence.span)).map(Some),
            None => Ok(Some(value)),
        }
    }

    /// The name that an item is, without a power, and the number of its dots.
    pub(super) fn lone_name(&self, item: &Item) -> Option<(Name, u8)> {
        let printed = names::printed(item, self.branch).filter(|printed| printed.sup.is_none())?;
        Some((printed.name, printed.dots))
    }

    /// Whether a name is one of a number that does not change with the time.
    fn stays(&self, name: &Name) -> bool {
        let Some((id, indices)) = self.symbols.find(name) else { return false };
        indices.is_empty() && self.symbols.entry(id).kind == Kind::Scalar && self.is_a_constant(id, DEEPEST)
    }

    fn is_a_constant(&self, id: SymbolId, depth: usize) -> bool {
        let entry = self.symbols.entry(id);
        match &entry.definition {
            Some(formula) => {
                depth > 0
                    && formula.symbols().iter().all(|(inner, dots)| *dots == 0 && self.is_a_constant(*inner, depth - 1))
            }
            None => !entry.varies && !entry.derived && self.symbols.time.as_ref() != Some(&entry.name),
        }
    }
}
