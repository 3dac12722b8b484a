//! Values at a place: `\left. f \right|_{x=a}`, `\left. F \right|_a^b`, `\left[F\right]_a^b`.

use crate::formula::calculus::places::{End, at};
use crate::formula::tree::{Expr, Node, Variable};
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents};
use super::super::state::{Read, Reader};
use super::sums::as_step;

/// What stands below and above a bar.
pub(in super::super) type Place<'i> = (Option<&'i Item>, Option<&'i Item>);

impl Reader<'_> {
    /// A formula at a place, or its difference between two places.
    pub(in super::super) fn at_place(&mut self, inner: &Expr, (below, above): Place<'_>, span: Span) -> Read<Expr> {
        let refused = |what: &str| {
            Fault::unsupported(span, what).help("name the variable at the bar, as in |_{x=a} or |_{x=0}^{x=1}")
        };
        let below = below.ok_or_else(|| refused("this bar does not say at which place the formula is taken"))?;
        let Some((letter, lower)) = self.placement(below)? else {
            // Without a letter, the formula must have one variable only.
            let Some(above) = above else { return Err(refused("this bar does not say which variable has this value")) };
            let symbols = inner.symbols();
            let ends = (self.end(below)?, self.end(above)?);
            let ([(letter, 0)], (End::At(lower), End::At(upper))) = (symbols.as_slice(), ends) else {
                return Err(refused("this bar does not say which variable has these values"));
            };
            let inner = self.written_out(inner, *letter)?;
            return Ok(as_step(at(&inner, *letter, &upper).minus(at(&inner, *letter, &lower))));
        };
        let upper = match above {
            None => None,
            Some(above) => Some(match self.placement(above)? {
                Some((other, upper)) if other == letter => upper,
                Some(_) => return Err(refused("the two places at this bar have different variables")),
                None => self.sum(contents(above), above.span)?,
            }),
        };
        let inner = self.written_out(inner, letter.id)?;
        let mut placed = at(&inner, letter.id, &lower);
        placed.move_to(span);
        Ok(as_step(match upper {
            None => placed,
            Some(upper) => {
                let mut upper = at(&inner, letter.id, &upper);
                upper.move_to(span);
                upper.minus(placed)
            }
        }))
    }

    /// `x = a`: the letter and its value.
    fn placement(&mut self, item: &Item) -> Read<Option<(Variable, Expr)>> {
        let items = contents(item);
        let Some(equals) = items.iter().position(|item| item.layout == Layout::Other('=')) else { return Ok(None) };
        let letter = self.sum(&items[..equals], item.span)?;
        let Node::Symbol { id, indices, dots: 0 } = &letter.node else {
            return Err(Fault::unsupported(letter.span, "the place at a bar must give one letter its value")
                .help("write one letter before the =, as in |_{x=a}"));
        };
        let letter = Variable { id: *id, indices: indices.clone(), dots: 0 };
        if !letter.indices.is_empty() || self.symbols.entry(letter.id).definition.is_some() {
            return Err(Fault::unsupported(
                item.span,
                "a bar is supported only for a variable that has no definition and no index",
            )
            .help("write the value at this place in a display of its own"));
        }
        Ok(Some((letter, self.sum(&items[equals + 1..], item.span)?)))
    }
}
