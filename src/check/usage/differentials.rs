//! Differentials in displays: which items are the d of something, and which are marks before a name.

use crate::formula::symbols::Name;
use crate::latex::layout::{Delimiter, Item, Layout};
use crate::latex::names;

/// Whether a numerator or denominator begins with d or ∂.
pub(super) fn is_differential(item: &Item) -> bool {
    let is_d = |item: &Item| match &item.layout {
        Layout::Letter('d') => true,
        Layout::Command(name) => name == "\\partial",
        Layout::Style(style, inner) => {
            style == "\\mathrm" && matches!(contents(inner), [Item { layout: Layout::Letter('d'), .. }])
        }
        _ => false,
    };
    match contents(item) {
        [first, ..] => match &first.layout {
            Layout::Scripts { nucleus, .. } => is_d(nucleus),
            _ => is_d(first) && (contents(item).len() > 1 || matches!(&first.layout, Layout::Command(_))),
        },
        [] => false,
    }
}

/// The name of which a numerator or a denominator is the differential with d, and nothing else: x of dx, d²x and dx².
pub(super) fn differential_of(item: &Item) -> Option<Name> {
    let [_, only] = contents(item) else { return None };
    let is_partial = |item: &Item| match &item.layout {
        Layout::Command(_) => true,
        Layout::Scripts { nucleus, .. } => matches!(nucleus.layout, Layout::Command(_)),
        _ => false,
    };
    let is_straight = is_differential(item) && !is_partial(&contents(item)[0]);
    names::printed(only, None).filter(|printed| is_straight && printed.dots == 0).map(|printed| printed.name)
}

/// Whether an item is the letter d alone, as above dt in d/dt.
pub(super) fn is_letter_d(item: &Item) -> bool {
    matches!(contents(item), [Item { layout: Layout::Letter('d'), .. }])
}

/// Whether d before an item is a differential: before a name or a parenthesis.
pub(super) fn is_factor(item: &Item) -> bool {
    names::printed(item, None).is_some() || matches!(item.layout, Layout::Fence(Delimiter::Round, _))
}

/// Whether an item is a Δ before a name, or a δ before one that has no dots, where the display does not use δ as a factor.
pub(super) fn is_mark(item: &Item, next: Option<&Item>, has_coefficient: bool) -> bool {
    let Some(next) = next.and_then(|next| names::printed(next, None)) else { return false };
    match &item.layout {
        Layout::Command(name) if name == "\\Delta" => true,
        Layout::Command(name) if name == "\\delta" => next.dots == 0 && !has_coefficient,
        _ => false,
    }
}

/// The quantity `\Delta x`, which is one name.
pub(super) fn difference(item: &Item, next: Option<&Item>) -> Option<Name> {
    let is_delta = matches!(&item.layout, Layout::Command(name) if name == "\\Delta");
    let printed = names::difference(item, next?, None).filter(|printed| is_delta && printed.dots == 0)?;
    Some(printed.name)
}

pub(super) fn is_by_time(below: &Item) -> bool {
    let time = |item: &Item| names::printed(item, None).is_some_and(|printed| printed.name == Name::plain("t"));
    is_differential(below) && contents(below).get(1).is_some_and(time)
}

/// The items of a group, or one item as a group of itself.
pub(super) fn contents(item: &Item) -> &[Item] {
    match &item.layout {
        Layout::Group(items) => items,
        _ => std::slice::from_ref(item),
    }
}
