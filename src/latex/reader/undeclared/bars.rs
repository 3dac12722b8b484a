//! The bar of an evaluation, `\left. f \right|_{x=a}`, `f\big|_0^1`; what is held fixed, `(\partial S/\partial V)_T`;
//! variations of an integral.

use crate::formula::symbols::Operator;
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents};
use super::super::items::{is_any_integral, whole_number};
use super::super::state::{Read, Reader};
use super::super::structure::printed;
use super::simple_text;

/// What stands below and above the bar of an evaluation.
pub(in super::super) type Limits<'i> = (Option<&'i Item>, Option<&'i Item>);

impl Reader<'_> {
    /// A formula at a place, or its difference between two places.
    pub(in super::super) fn evaluated(&mut self, inner: Expr, (below, above): Limits<'_>, span: Span) -> Read<Expr> {
        let mut name = "|".to_owned();
        for (mark, limit) in [("_", below), ("^", above)] {
            let Some(limit) = limit else { continue };
            let text = match simple_text(contents(limit)) {
                Some(text) => text,
                None if self.is_abstract() => printed(contents(limit)),
                None => {
                    return Err(Fault::unsupported(limit.span, "the place at this bar is not supported")
                        .help("write names and numbers only, such as |_{x=a}"));
                }
            };
            name.push_str(&format!("{mark}{{{text}}}"));
        }
        Ok(self.operate(&name, Operator::Same, vec![inner], span))
    }
}

impl Reader<'_> {
    /// `\delta` before an integral, and `\delta^2 S`; `None` for anything else.
    pub(in super::super) fn varied(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let is_delta = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\delta");
        let spaces = items[*cursor + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
        let at = *cursor + 1 + spaces;
        let Some(next) = items.get(at) else { return Ok(None) };
        let name = match &item.layout {
            _ if !self.symbols.infers() => return Ok(None),
            _ if is_delta(item) && is_any_integral(next) => "\\delta",
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
                if is_delta(nucleus) && whole_number(sup) == Some(2) && self.symbols.inferred.variations =>
            {
                "\\delta^{2}"
            }
            _ => return Ok(None),
        };
        *cursor = at;
        let (inner, _) = self.factor(items, cursor)?;
        let span = item.span.to(inner.span);
        Ok(Some(self.operate(name, Operator::Same, vec![inner], span)))
    }
}

/// The limits of a bar that stands alone, `|_{x=a}`.
pub(in super::super) fn bar(item: &Item) -> Option<Limits<'_>> {
    let Layout::Scripts { nucleus, sub, sup, primes: 0 } = &item.layout else { return None };
    (nucleus.layout == Layout::Other('|')).then_some((sub.as_deref(), sup.as_deref()))
}
