//! Parentheses in which a further statement stands: `(\Rightarrow a = b)`, `(\text{with } a = b)`; those with a condition in words,
//! `(\text{valid for } a > b)`; and those that explain, `(\text{since } a = b)`, which are left out.

use super::super::layout::{Delimiter, Item, Layout};
use super::super::rows::{COLUMN, is_operator, relation};
use super::conditions::begins_condition;
use super::separators::separates;

/// The items, where such a parenthesis is open, so that its statement is one of its own.
pub(super) fn opened(items: Vec<&Item>) -> Vec<&Item> {
    let mut found = Vec::with_capacity(items.len());
    for (at, item) in items.iter().copied().enumerate() {
        let is_apart = at > 0 && matches!(items[at - 1].layout, Layout::Space(_) | Layout::Other(','));
        match &item.layout {
            Layout::Fence(Delimiter::Round, inside) if begins_a_statement(inside) => {
                found.push(&COLUMN);
                found.extend(inside);
                found.push(&COLUMN);
            }
            // `(\because c = d)`
            Layout::Fence(Delimiter::Round, inside) if is_apart && gives_a_reason(inside) => found.push(&COLUMN),
            Layout::Fence(Delimiter::Round, inside)
                if is_worded(inside) && (is_apart || inside.iter().any(begins_condition)) =>
            {
                if inside.iter().any(begins_condition) {
                    found.extend(inside);
                }
                found.push(&COLUMN);
            }
            _ => found.push(item),
        }
    }
    found
}

fn gives_a_reason(inside: &[Item]) -> bool {
    let first = inside.iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    first.is_some_and(|first| matches!(&first.layout, Layout::Command(name) if name == "\\because"))
}

/// Whether words stand before a relation between formulas: `\text{valid for } x > 3`.
fn is_worded(inside: &[Item]) -> bool {
    let mut solid = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let Some(Layout::Text(word)) = solid.next().map(|first| &first.layout) else { return false };
    let is_word = word.len() > 1 && word.chars().all(|c| c.is_alphabetic() || c == ',');
    let next = solid.next();
    is_word
        && next.is_some_and(|next| {
            relation(next).is_none() && !is_operator(next) && !matches!(next.layout, Layout::Fence(..))
        })
        && solid.any(|item| relation(item).is_some())
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
