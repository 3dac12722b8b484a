//! Terms that are left out at the end of a sum: `+ \dots`, `+ O(x^3)`, `+ \mathcal{O}(x^3)`.
//!
//! After a sign and before the end of a sum, dots are no name, and neither is the O of an order. In the middle of a sum or in a
//! list they stay what they were.

use super::item::{Delimiter, Item, Layout};
use super::values::ends_term;

/// The items, in which what stands for terms that are left out is one item.
pub(crate) fn with_rests(items: Vec<Item>) -> Vec<Item> {
    let mut found: Vec<Item> = Vec::with_capacity(items.len());
    let all: Vec<Item> = items.into_iter().map(inside).collect();
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let mut at = 0;
    while at < all.len() {
        let after_sign = found.iter().rev().find(|item| !is_space(item)).is_some_and(is_sign);
        let length = if after_sign { length_of(&all[at..]) } else { None };
        let ends = |length: usize| {
            let next = all[at + length..].iter().find(|item| !is_space(item));
            next.is_none_or(|next| ends_term(next) && !is_sign(next))
        };
        match length.filter(|length| ends(*length)) {
            Some(length) => {
                let span = all[at].span.to(all[at + length - 1].span);
                let order = match &all[at + length - 1].layout {
                    Layout::Fence(_, inner) => Some(inner.clone()),
                    _ => None,
                };
                found.push(Item { layout: Layout::Rest(order), span });
                at += length;
            }
            None => {
                found.push(all[at].clone());
                at += 1;
            }
        }
    }
    found
}

fn is_sign(item: &Item) -> bool {
    matches!(item.layout, Layout::Other('+' | '-'))
}

/// The number of items that stand for what is left out, if items begin with it.
fn length_of(items: &[Item]) -> Option<usize> {
    match &items.first()?.layout {
        Layout::Command(name) if name == "\\dots" => Some(1),
        _ if is_order(&items[0]) => {
            let spaces = items[1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
            let argument = items.get(1 + spaces)?;
            let is_fence = matches!(argument.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, _));
            is_fence.then_some(2 + spaces)
        }
        _ => None,
    }
}

/// Whether an item is the O of an order.
fn is_order(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter('O') => true,
        Layout::Style(_, inner) => is_order(inner),
        Layout::Group(items) => matches!(items.as_slice(), [only] if is_order(only)),
        _ => false,
    }
}

/// An item, in whose parts what is left out is one item.
fn inside(item: Item) -> Item {
    let one = |item: Box<Item>| Box::new(inside(*item));
    let layout = match item.layout {
        Layout::Group(items) => Layout::Group(with_rests(items)),
        Layout::Fence(delimiter, items) => Layout::Fence(delimiter, with_rests(items)),
        Layout::Fraction(above, below) => Layout::Fraction(one(above), below),
        Layout::Scripts { nucleus, sub, sup, primes } => Layout::Scripts { nucleus: one(nucleus), sub, sup, primes },
        Layout::Environment(name, rows) => {
            let cells = |row: Vec<Vec<Item>>| row.into_iter().map(with_rests).collect();
            Layout::Environment(name, rows.into_iter().map(cells).collect())
        }
        other => other,
    };
    Item { layout, span: item.span }
}

/// Whether terms are left out in items.
pub(crate) fn has_rest(items: &[Item]) -> bool {
    items.iter().any(|item| match &item.layout {
        Layout::Rest(_) => true,
        Layout::Group(items) | Layout::Fence(_, items) => has_rest(items),
        Layout::Fraction(above, _) => has_rest(std::slice::from_ref(above)),
        Layout::Scripts { nucleus, .. } => has_rest(std::slice::from_ref(nucleus)),
        Layout::Environment(_, rows) => rows.iter().flatten().any(|cell| has_rest(cell)),
        _ => false,
    })
}
