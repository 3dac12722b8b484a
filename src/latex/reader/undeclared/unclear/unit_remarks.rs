//! The unit of a quantity in parentheses behind its name, `f(\text{in m})`: no argument.

use crate::formula::units::Unit;
use crate::source::Fault;

use super::super::super::super::layout::{Delimiter, Item, Layout, parts};
use super::super::super::super::names;

/// The fault of such a parenthesis in a display.
pub(super) fn unclear_unit(items: &[Item]) -> Option<Fault> {
    let here = items.windows(2).find(|pair| names::printed(&pair[0], None).is_some() && says_a_unit(&pair[1]));
    match here {
        Some(pair) => Some(
            Fault::unsupported(pair[1].span, "words about the unit of a quantity are not supported in a formula")
                .help("remove them, and write the unit after the number"),
        ),
        None => items.iter().find_map(|item| parts(item).into_iter().find_map(unclear_unit)),
    }
}

/// A text has lost its spaces: `inm`, `inkg`.
fn says_a_unit(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    let [Item { layout: Layout::Text(word), .. }] = inside.as_slice() else { return false };
    word.strip_prefix("in").is_some_and(|unit| Unit::named(unit).is_some())
}
