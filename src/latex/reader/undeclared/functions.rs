//! Functions that the use of a name shows: `V(r)`, `V'(r)`, `x(0)`, `f(x + h)`, `L(q, \dot q, t)`.
//!
//! Each value is printed with its arguments. Dots and primes are a part of the name: V′(r) is the derivative of V.

use crate::formula::symbols::{Kind, Name, Operator};
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names::{self, Printed};
use super::super::items::whole_number;
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// Whether the use of a name shows a function.
    pub(in super::super) fn is_inferred_function(&self, name: &Name) -> bool {
        self.symbols.infers() && self.symbols.inferred.functions.contains_key(&Name { primes: 0, ..name.clone() })
    }

    /// The value of a function that its use shows; the cursor moves behind its arguments.
    pub(in super::super) fn inferred_function(
        &mut self,
        span: Span,
        printed: &Printed<'_>,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Option<Expr>> {
        if !self.is_inferred_function(&printed.name) {
            return Ok(None);
        }
        // `ru(1 - u)` beside u(x, 0): nothing is a function of itself.
        if let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), .. }) = items.get(*cursor)
            && inside.len() > 1
            && inside.iter().any(|item| names::printed(item, None).is_some_and(|found| found.name == printed.name))
        {
            return Ok(None);
        }
        // `f(x)_{max}`: the subscript belongs to the value.
        if let Some(Item { layout: Layout::Scripts { nucleus, sub: Some(sub), sup, primes: 0 }, span: place }) =
            items.get(*cursor)
            && matches!(nucleus.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, _))
        {
            let whole = span.to(*place);
            if !self.is_abstract() {
                return Err(Fault::unsupported(whole, "a subscript on the value of a function is not supported")
                    .help("write the subscript after the name of the function, f_{max}"));
            }
            let bare = [(**nucleus).clone()];
            let value = self.inferred_function(span, printed, &bare, &mut 0)?;
            let Some(value) = value else { return Ok(None) };
            *cursor += 1;
            let below = super::super::structure::printed(crate::latex::layout::contents(sub));
            let value = self.template(&format!("#_{{{below}}}"), vec![value], whole);
            return match sup {
                Some(sup) => self.raised(value, sup, whole).map(Some),
                None => Ok(Some(value)),
            };
        }
        let kind = if is_vectorial(&printed.name) { Kind::Vector } else { Kind::Scalar };
        let next = items.get(*cursor).and_then(|item| match &item.layout {
            Layout::Fence(Delimiter::Round | Delimiter::Square, inside) => Some((inside, None, item.span)),
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => match &nucleus.layout {
                Layout::Fence(Delimiter::Round | Delimiter::Square, inside) => Some((inside, Some(&**sup), item.span)),
                _ => None,
            },
            _ => None,
        });
        if let Some(sup) = printed.sup
            && next.is_some()
            && whole_number(sup).is_none()
            && !self.is_abstract()
        {
            return Err(Fault::ambiguous(
                span,
                "a superscript on a function may be a power or the order of a derivative",
            )
            .help("put the power after the argument, f(x)^2"));
        }
        let is_marked = self.is_abstract() && next.is_some();
        let mark = printed.sup.filter(|sup| is_marked && whole_number(sup).is_none());
        let mark = mark.map(|sup| super::super::structure::printed(crate::latex::layout::contents(sup)));
        let mut above = None;
        let mut whole = span;
        let mut value = None;
        if let Some((inside, _, place)) = next
            && self.is_at_another_place(&printed.name, inside)
        {
            let what = format!("{}(…) may be a function or a product", printed.name);
            return Err(Fault::ambiguous(span.to(place), what).help(
                "for a product, put a thin space \\, before the parenthesis; \
                 for a function, declare it under \"functions\" in a claims file",
            ));
        }
        if let Some((inside, sup, place)) = next {
            whole = span.to(place);
            above = sup;
            *cursor += 1;
            let mut arguments = Vec::new();
            for given in inside.split(|item| matches!(item.layout, Layout::Other(',' | ';'))) {
                arguments.push(match self.is_abstract() && is_probability(&printed.name) {
                    true => self.event(given, place)?,
                    false => self.sum(given, place)?,
                });
            }
            // What stands above the name, a power or an order, is shown there.
            let base = match &mark {
                Some(mark) => Name { base: format!("{}^{{{mark}}}", printed.name.base), ..printed.name.clone() },
                None => printed.name.clone(),
            };
            let name = names::with_dots(&base, printed.dots).ok_or_else(|| {
                Fault::unsupported(span, "derivatives above the fifth order are not supported")
                    .help("give a derivative of lower order a name, and differentiate the name")
            })?;
            value = Some(self.operate_by(name, kind, Operator::Function, arguments, whole));
        }
        let mut value = match value {
            Some(value) => value,
            None => {
                let id = match self.symbols.find(&printed.name) {
                    Some((id, _)) => id,
                    None => {
                        let taken = || {
                            Fault::new(span, format!("{} is already the name of another symbol", printed.name))
                                .help("use another name for one of the two")
                        };
                        self.symbols.add(printed.name.clone(), kind).ok_or_else(taken)?
                    }
                };
                self.symbols.entry_mut(id).varies = true;
                Expr::new(Node::Symbol { id, indices: Vec::new(), dots: printed.dots }, whole)
            }
        };
        // `\varepsilon^p` beside `\varepsilon(u)`: the plastic part, or a power.
        let is_alone = next.is_none() && matches!(self.symbols.inferred.functions.get(&printed.name), Some(Some(_)));
        if let Some(sup) = printed.sup.filter(|sup| is_alone && is_label(sup)) {
            let letter = super::super::structure::printed(crate::latex::layout::contents(sup));
            return Err(Fault::ambiguous(span, format!("{letter} above a function may be a label or a power"))
                .help("write a label as a subscript; write a power behind the argument, f(x)^p"));
        }
        let power = printed.sup.filter(|_| mark.is_none());
        for sup in [power, above].into_iter().flatten() {
            value = self.raised(value, sup, whole)?;
        }
        Ok(Some(value))
    }
}

impl Reader<'_> {
    /// `\sigma(1 - P_1)` beside `\sigma(u)`: what stands in the parenthesis has nothing of the letter of which the name is a function.
    fn is_at_another_place(&self, name: &Name, inside: &[Item]) -> bool {
        let Some(Some(argument)) = self.symbols.inferred.functions.get(name) else { return false };
        let text = super::super::structure::printed(inside);
        let starts_with_number = inside.first().is_some_and(|first| matches!(first.layout, Layout::Number(_)));
        let is_sum = inside.iter().any(|item| matches!(item.layout, Layout::Other('+' | '-')));
        let has_subscript =
            |item: &Item| names::printed(item, None).is_some_and(|found| !found.name.subscript.is_empty());
        starts_with_number && is_sum && inside.iter().any(has_subscript) && !text.contains(argument.as_str())
    }
}

/// Whether a letter that stands above is a usual label: elastic, plastic, trial, solid, fluid.
fn is_label(sup: &Item) -> bool {
    matches!(crate::latex::layout::contents(sup), [Item { layout: Layout::Letter('e' | 'p' | 't' | 's' | 'f'), .. }])
}

/// Whether a name is that of a probability.
pub(in super::super) fn is_probability(name: &Name) -> bool {
    ["P", "\\mathbb{P}", "\\mathrm{P}", "\\mathrm{Pr}"].contains(&name.base.as_str()) && name.primes == 0
}

/// Whether a name has the markup of a vector.
pub(in super::super) fn is_vectorial(name: &Name) -> bool {
    ["\\vec{", "\\mathbf{", "\\hat{"].iter().any(|mark| name.base.contains(mark))
}
