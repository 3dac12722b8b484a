//! Parentheses in which a further statement stands: `(\Rightarrow a = b)`, `(\text{with } a = b)`.

use super::super::layout::{Delimiter, Item, Layout};
use super::super::rows::COLUMN;
use super::separators::separates;

/// The items, where such a parenthesis is open, so that its statement is one of its own.
pub(super) fn opened(items: Vec<&Item>) -> Vec<&Item> {
    let mut found = Vec::with_capacity(items.len());
    for item in items {
        match &item.layout {
            Layout::Fence(Delimiter::Round, inside) if begins_a_statement(inside) => {
                found.push(&COLUMN);
                found.extend(inside);
                found.push(&COLUMN);
            }
            _ => found.push(item),
        }
    }
    found
}

fn begins_a_statement(inside: &[Item]) -> bool {
    let first = inside.iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    // `(\hat a|0\rangle = 0)`
    let equal = inside.iter().position(|item| item.layout == Layout::Other('='));
    let is_state = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::Ket, _));
    if equal.is_some_and(|equal| inside[..equal].iter().any(is_state)) {
        return true;
    }
    first.is_some_and(|first| matches!(first.layout, Layout::Command(_) | Layout::Text(_)) && separates(first))
}
