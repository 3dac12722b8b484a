//! What follows a factor and belongs to it: a factorial, further indices, a list of arguments, dots for further decimals.

use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::super::arguments::is_comma;
use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names;
use super::super::state::{Read, Reader};
use super::operators::{is_bare_script, is_one_name, is_parenthesis};
use super::printed;

impl Reader<'_> {
    /// A factor with the factorial, the further indices or the evaluation that follows it.
    pub(in super::super) fn with_what_follows(
        &mut self,
        factor: Expr,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        if !self.is_abstract() {
            return match (items.get(*cursor - 1), items.get(*cursor)) {
                (Some(before), Some(next))
                    if self.symbols.open
                        && is_parenthesis(before)
                        && is_one_name(next)
                        && factor.span.start < before.span.start
                        && before.span.end == next.span.start =>
                {
                    let span = factor.span.to(next.span);
                    Err(Fault::ambiguous(span, "f(x)(y) may be a function of y or a product")
                        .help("for a product, remove the second pair of parentheses"))
                }
                _ => Ok(factor),
            };
        }
        let mut factor = self.factorial(factor, items, cursor);
        factor = self.decimals_that_go_on(factor, items, cursor);
        factor = self.applied_by_its_scripts(factor, items, cursor)?;
        factor = self.applied_to_a_list(factor, items, cursor)?;
        while let Some(next) = items.get(*cursor)
            && is_bare_script(next)
            && next.span.start == items[*cursor - 1].span.end
            && matches!(items[*cursor - 1].layout, Layout::Scripts { .. })
        {
            *cursor += 1;
            let span = factor.span.to(next.span);
            factor = self.template(&format!("#{}", printed(std::slice::from_ref(next))), vec![factor], span);
        }
        Ok(factor)
    }

    /// `(\nabla_v g)(V, W)`: what stands in a parenthesis is a function of the list after it, which cannot be a factor.
    fn applied_to_a_list(&mut self, factor: Expr, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let before = cursor.checked_sub(1).map(|at| &items[at]).filter(|before| is_parenthesis(before));
        let (Some(before), Some(Item { layout: Layout::Fence(Delimiter::Round, inside), span })) =
            (before, items.get(*cursor))
        else {
            return Ok(factor);
        };
        // `\mathcal{L}(f)(s)`: nobody puts a single name in parentheses as a factor.
        let is_name = is_one_name(&items[*cursor]);
        let is_call = factor.span.start < before.span.start;
        if !(inside.iter().any(is_comma) || is_name && is_call) || before.span.end != span.start {
            return Ok(factor);
        }
        *cursor += 1;
        self.with_arguments(factor, (inside, *span), ("(#)(", ")"))
    }

    /// A function before the list of its arguments; `open` begins with the hole of the function.
    fn with_arguments(
        &mut self,
        function: Expr,
        (inside, span): (&[Item], Span),
        (open, close): (&str, &str),
    ) -> Read<Expr> {
        let whole = function.span.to(span);
        let mut parts = vec![function];
        for argument in inside.split(is_comma) {
            parts.push(self.sum(argument, span)?);
        }
        let holes = vec!["#"; parts.len() - 1].join(", ");
        Ok(self.template(&format!("{open}{holes}{close}"), parts, whole))
    }

    /// `n!`, at the exclamation mark.
    pub(in super::super) fn factorial(&mut self, value: Expr, items: &[Item], cursor: &mut usize) -> Expr {
        let mut value = value;
        while let Some(Item { layout: Layout::Other('!'), span }) = items.get(*cursor) {
            *cursor += 1;
            let whole = value.span.to(*span);
            value = self.template("#!", vec![value], whole);
        }
        value
    }

    /// `2.718\ldots`: the dots stand for further decimals, and are no factor.
    fn decimals_that_go_on(&mut self, factor: Expr, items: &[Item], cursor: &mut usize) -> Expr {
        let before = cursor.checked_sub(1).and_then(|at| items.get(at));
        match (before, items.get(*cursor)) {
            (Some(number), Some(dots)) if is_open_decimal(number, dots) => {
                *cursor += 1;
                let span = factor.span.to(dots.span);
                self.template("#\\dots", vec![factor], span)
            }
            _ => factor,
        }
    }

    /// `\sigma_{A^+, B}(E)`: a name with scripts of more than names, before a lone name or a list in parentheses.
    fn applied_by_its_scripts(&mut self, factor: Expr, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let before = cursor.checked_sub(1).and_then(|at| items.get(at)).filter(|before| has_other_scripts(before));
        let (Some(before), Some(Item { layout: Layout::Fence(delimiter, inside), span })) =
            (before, items.get(*cursor))
        else {
            return Ok(factor);
        };
        let is_name =
            matches!(inside.as_slice(), [only] if names::printed(only, None).is_some_and(|found| found.sup.is_none()));
        let (open, close) = match delimiter {
            Delimiter::Round => ("#(", ")"),
            Delimiter::Square if is_name => ("#[", "]"),
            _ => return Ok(factor),
        };
        if before.span.end != span.start || !is_name && !inside.iter().any(is_comma) {
            return Ok(factor);
        }
        *cursor += 1;
        self.with_arguments(factor, (inside, *span), (open, close))
    }
}

/// Whether dots touch a number with decimals.
pub(in super::super::super) fn is_open_decimal(number: &Item, dots: &Item) -> bool {
    let has_decimals = matches!(&number.layout, Layout::Number(digits) if digits.contains('.'));
    let are_dots = matches!(&dots.layout, Layout::Command(name) if name == "\\dots");
    has_decimals && are_dots && number.span.end == dots.span.start
}

/// Whether an item is a letter with a subscript that is no part of a name.
fn has_other_scripts(item: &Item) -> bool {
    let Layout::Scripts { nucleus, sub: Some(_), sup: None, primes: 0 } = &item.layout else { return false };
    names::printed(item, None).is_none() && names::printed(nucleus, None).is_some()
}
