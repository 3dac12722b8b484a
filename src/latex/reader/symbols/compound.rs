//! A mark and a letter that are one symbol: `\Delta x`, `\delta q`, `dx`, `d^3r`, `d\delta q`.

use crate::formula::symbols::Name;
use crate::formula::tree::Expr;
use crate::source::Fault;

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::items::{differential, differential_of_many};
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// `\Delta x` as one symbol, unless Δ itself is declared.
    pub(in super::super) fn compound(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let Some(first) = items.get(*cursor) else { return Ok(None) };
        let order = differential(first).filter(|_| self.symbols.infers() && self.symbols.inferred.differentials);
        let inexact = is_inexact(first) && self.symbols.open;
        let order = if inexact { Some(1) } else { order };
        let many = differential_of_many(first).filter(|_| self.is_abstract());
        let order = order.or(many.as_ref().map(|_| 0));
        if let Some(varied) = self.varied(items, cursor)? {
            return Ok(Some(varied));
        }
        let spaces = items[*cursor + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_)));
        let ahead = 1 + if order.is_some() { spaces.count() } else { 0 };
        let Some(second) = items.get(*cursor + ahead) else { return Ok(None) };
        // `d\delta q` is the change of the variation.
        if let (Some(1), Layout::Command(mark), Some(third)) = (order, &second.layout, items.get(*cursor + ahead + 1))
            && (mark == "\\delta" || mark == "\\Delta")
            && let Some(mut printed) = names::printed(third, self.branch)
        {
            printed.name.base = format!("d{mark} {}", printed.name.base);
            *cursor += ahead + 2;
            return self.symbol(first.span.to(third.span), printed, &[], &mut 0).map(Some);
        }
        let is_difference = matches!(&first.layout, Layout::Command(name) if name == "\\Delta" || name == "\\delta");
        if is_difference && matches!(second.layout, Layout::Root(..)) && self.symbols.infers() && !self.is_abstract() {
            return Err(Fault::ambiguous(
                first.span.to(second.span),
                "Δ or δ before a root may mean the change of the root, or a factor",
            )
            .help("put parentheses around the root for the change, and \\cdot before it for a product"));
        }
        let Some(mut printed) = names::printed(second, self.branch).filter(|_| is_difference || order.is_some()) else {
            return Ok(None);
        };
        let command = match (&first.layout, order) {
            _ if inexact => "đ".to_owned(),
            (_, Some(0)) => many.unwrap_or_default(),
            (_, Some(1)) => "d".to_owned(),
            (_, Some(order)) => format!("d^{{{order}}}"),
            (Layout::Command(command), None) => command.clone(),
            _ => return Ok(None),
        };
        let command = &command;
        if order.is_some() {
            printed.name.base = format!("{command}{}", printed.name.base);
            *cursor += 1 + ahead;
            // A parenthesis after a differential is another factor: `dx (a + b)`.
            return self.symbol(first.span.to(second.span), printed, &[], &mut 0).map(Some);
        }
        if command == "\\delta" && self.symbols.inferred.has_coefficient && (self.symbols.open || self.symbols.guessed)
        {
            return Ok(None);
        }
        if self.symbols.find(&Name::plain(command)).is_some() && !self.is_abstract() {
            match command.as_str() {
                _ if !self.symbols.guessed => return Ok(None),
                "\\delta" if !self.symbols.inferred.varies => return Ok(None),
                "\\Delta" if self.symbols.inferred.has_difference_alone => {
                    return Err(Fault::ambiguous(
                        first.span.to(second.span),
                        "\\Delta x may be a difference or the product of \\Delta and x",
                    )
                    .help("write \\Delta\\,x for the product, or another letter for the quantity \\Delta"));
                }
                _ => {}
            }
        }
        if command == "\\delta" && self.symbols.open && !self.symbols.inferred.variations {
            return Err(Fault::ambiguous(
                first.span.to(second.span),
                "\\delta x may be a variation of x or the product of \\delta and x",
            )
            .help("for a product, write \\delta \\cdot x"));
        }
        // `\delta J[y]`: the change of the value of a functional.
        if self.is_abstract()
            && self.is_inferred_function(&printed.name)
            && matches!(items.get(*cursor + 2).map(|next| &next.layout), Some(Layout::Fence(Delimiter::Square, _)))
        {
            let mut end = *cursor + 2;
            if let Some(value) = self.inferred_function(second.span, &printed, items, &mut end)? {
                *cursor = end;
                let span = first.span.to(value.span);
                return Ok(Some(self.template(&format!("{command} #"), vec![value], span)));
            }
        }
        printed.name.base = format!("{command} {}", printed.name.base);
        *cursor += 2;
        self.symbol(first.span.to(second.span), printed, items, cursor).map(Some)
    }
}

/// The mark of an inexact differential: đ, `\bar d`.
fn is_inexact(item: &Item) -> bool {
    match &item.layout {
        Layout::Other(c) => *c == 'đ',
        Layout::Accent(accent, inner) => {
            accent == "\\bar" && matches!(contents(inner), [only] if differential(only) == Some(1))
        }
        _ => false,
    }
}
