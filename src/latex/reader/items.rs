//! What a typeset item is, seen from outside: a number, an operator, a transpose mark.

use crate::source::Span;

use super::super::layout::{Item, Layout};
use super::Joint;

/// The bytes from the first item to the last.
pub(in super::super) fn extent(items: &[Item]) -> Option<Span> {
    Some(items.first()?.span.to(items.last()?.span))
}

/// How an item joins the factors on both sides of it.
pub(super) fn joint(item: &Item) -> Option<Joint> {
    match &item.layout {
        Layout::Other('/') => Some(Joint::Slash),
        Layout::Other('*' | '·' | '⋅') => Some(Joint::CDot),
        Layout::Other('×') => Some(Joint::Times),
        Layout::Command(name) => match name.as_str() {
            "\\cdot" => Some(Joint::CDot),
            "\\times" => Some(Joint::Times),
            _ => None,
        },
        _ => None,
    }
}

/// The items inside a group, or the item itself.
pub(super) fn contents(item: &Item) -> &[Item] {
    match &item.layout {
        Layout::Group(items) => items,
        _ => std::slice::from_ref(item),
    }
}

/// The whole number that an item is.
pub(super) fn whole_number(item: &Item) -> Option<u32> {
    match contents(item) {
        [Item { layout: Layout::Number(digits), .. }] => digits.parse().ok(),
        _ => None,
    }
}

/// `-1`, as the mark of an inverse.
pub(super) fn is_minus_one(item: &Item) -> bool {
    matches!(contents(item), [Item { layout: Layout::Other('-'), .. }, one] if whole_number(one) == Some(1))
}

/// `T`, as the mark of a transpose.
pub(super) fn is_transpose(item: &Item) -> bool {
    match contents(item) {
        [Item { layout: Layout::Letter('T'), .. }] => true,
        [Item { layout: Layout::Command(name), .. }] => name == "\\top",
        [Item { layout: Layout::Style(_, inner), .. }] => is_transpose(inner),
        _ => false,
    }
}

/// Whether a group holds numbers only.
pub(super) fn is_numeric(item: &Item) -> bool {
    contents(item).iter().all(|item| match &item.layout {
        Layout::Number(_) => true,
        Layout::Command(name) => name == "\\pi",
        _ => false,
    })
}

/// Whether an item is a number, with a power perhaps.
pub(super) fn is_number(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(_) => true,
        Layout::Scripts { nucleus, .. } => is_number(nucleus),
        _ => false,
    }
}

/// Whether an item is a fraction or root of numbers.
pub(super) fn is_numeric_item(item: &Item) -> bool {
    match &item.layout {
        Layout::Fraction(a, b) => is_numeric(a) && is_numeric(b),
        Layout::Root(_, a) => is_numeric(a),
        _ => false,
    }
}
