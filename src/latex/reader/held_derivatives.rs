//! `\left(\frac{\partial p}{\partial V}\right)_T`, the derivative of a quantity of state at a fixed value of another one.
//!
//! The formula of p says what it depends on. If that is V and T, and neither has a formula itself, T stays fixed in the partial
//! derivative. With another formula for p, one of V and S, it would not, so what is held must stand in the formula.

use crate::formula::symbols::SymbolId;
use crate::formula::tree::Expr;
use crate::source::Span;

use super::super::layout::{Item, Layout, contents};
use super::super::names;
use super::partial_derivatives::Operator;
use super::state::{Read, Reader};

impl Reader<'_> {
    /// A derivative at a fixed value, or else a component or an entry.
    pub(super) fn held_or_part(&mut self, fence: &Item, sub: &Item, span: Span) -> Read<Expr> {
        match self.held_derivative(fence, sub, span)? {
            Some(derivative) => Ok(derivative),
            None => self.part(fence, sub, span),
        }
    }

    /// The derivative in a fence with what is held in its subscript; `None` if the notes do not say what it is.
    fn held_derivative(&mut self, fence: &Item, held: &Item, span: Span) -> Read<Option<Expr>> {
        let Layout::Fence(_, inside) = &fence.layout else { return Ok(None) };
        let is_solid = |item: &&Item| !matches!(item.layout, Layout::Space(_));
        let solid: Vec<&Item> = inside.iter().filter(is_solid).collect();
        let [Item { layout: Layout::Fraction(above, below), span: inner }] = solid.as_slice() else { return Ok(None) };
        let Some(operator) = self.operator(above, below, *inner)? else { return Ok(None) };
        let Some(function) = self.differentiated(&operator) else { return Ok(None) };
        let separates = |item: &Item| item.layout == Layout::Other(',');
        let mut fixed = Vec::new();
        for letter in contents(held).split(separates) {
            let letters: Vec<&Item> = letter.iter().filter(is_solid).collect();
            let [one] = letters.as_slice() else { return Ok(None) };
            let Some(printed) = names::printed(one, self.branch).filter(|printed| printed.sup.is_none()) else {
                return Ok(None);
            };
            let Some((id, _)) = self.symbols.find(&printed.name) else { return Ok(None) };
            fixed.push(id);
        }
        let mut variables = operator.by.iter().map(|(_, by)| by.id).chain(fixed);
        let names = self.names_below(function);
        let is_free = |id: SymbolId| names.contains(&id) && self.symbols.entry(id).definition.is_none();
        if !variables.all(is_free) {
            return Ok(None);
        }
        let mut derivative = self.apply(&operator, &[], &mut 0)?;
        derivative.span = span;
        Ok(Some(derivative))
    }

    /// The name that is differentiated, if it is one with a formula.
    fn differentiated(&self, operator: &Operator<'_>) -> Option<SymbolId> {
        let mut solid = operator.operand.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let printed = names::printed(solid.next()?, self.branch).filter(|printed| printed.sup.is_none())?;
        let (id, _) = self.symbols.find(&printed.name)?;
        (solid.next().is_none() && self.symbols.entry(id).definition.is_some()).then_some(id)
    }

    /// The names in the formula of a name, and in their formulas.
    fn names_below(&self, name: SymbolId) -> Vec<SymbolId> {
        let (mut found, mut at) = (vec![name], 0);
        while let Some(next) = found.get(at).copied() {
            at += 1;
            let Some(definition) = &self.symbols.entry(next).definition else { continue };
            for (id, _) in definition.symbols() {
                if !found.contains(&id) {
                    found.push(id);
                }
            }
        }
        found
    }
}
