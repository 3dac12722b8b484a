//! Indicators, `\mathbb{1}[x > 0]`, `\mathbf{1}_A(x)`: they are 1 where something holds, and 0 elsewhere.

use crate::formula::tree::Expr;

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::whole_number;
use super::super::state::Reader;
use super::printed;

impl Reader<'_> {
    /// An indicator with what stands in its brackets, as it is printed; `None` for anything else.
    pub(super) fn indicator(&mut self, items: &[Item], cursor: &mut usize) -> Option<Expr> {
        let item = &items[*cursor];
        let (nucleus, has_set) = match &item.layout {
            Layout::Scripts { nucleus, sub: Some(_), sup: None, primes: 0 } => (&**nucleus, true),
            _ => (item, false),
        };
        let Layout::Style(style, inner) = &nucleus.layout else { return None };
        if !["\\mathbb", "\\mathbf"].contains(&style.as_str()) || whole_number(inner) != Some(1) {
            return None;
        }
        let next = items.get(*cursor + 1)?;
        let Layout::Fence(delimiter, inside) = &next.layout else { return None };
        let is_condition = inside.iter().any(|item| matches!(item.layout, Layout::Text(_)) || relation(item).is_some());
        let is_name = matches!(inside.as_slice(), [only] if names::printed(only, None).is_some());
        let is_indicator = match delimiter {
            Delimiter::Square | Delimiter::Curly => is_condition,
            Delimiter::Round => is_condition || has_set && is_name,
            _ => false,
        };
        if !is_indicator {
            return None;
        }
        let text = printed(&items[*cursor..*cursor + 2]).replacen(&printed(std::slice::from_ref(nucleus)), "𝟙", 1);
        let found = self.template(&text, Vec::new(), item.span.to(next.span));
        *cursor += 2;
        Some(found)
    }
}
