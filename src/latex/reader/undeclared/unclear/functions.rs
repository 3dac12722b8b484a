//! A letter before another one in parentheses, `E(A) = \frac{Q}{\epsilon_0}`, which the display solves for: a factor, and no function.
//!
//! The right side does not have the letter in parentheses, and the letter alone is equal to something that has it.

use crate::formula::symbols::Name;
use crate::source::Fault;

use super::super::super::super::layout::{Delimiter, Item, Layout, parts};
use super::super::super::super::names;
use super::sides::{first_sides, statements};

/// The fault of such a letter in a display.
pub(super) fn unclear_function(items: &[Item]) -> Option<Fault> {
    let all = statements(items);
    let equations = || all.iter().filter_map(|statement| first_sides(statement));
    equations().find_map(|(left, right)| {
        let [head, fence] = left else { return None };
        let (function, argument) = (plain(head)?, plain(argument(fence)?)?);
        let is_solved = equations().any(|(other, value)| {
            matches!(other, [only] if plain(only).as_ref() == Some(&function)) && mention(value, &argument)
        });
        (is_solved && !mention(right, &argument)).then(|| {
            let shown = format!("{function}({argument})");
            Fault::ambiguous(head.span.to(fence.span), format!("{shown} may be a function or a product"))
                .help("for a product, leave the parentheses out; for a function, write its argument everywhere")
        })
    })
}

fn argument(item: &Item) -> Option<&Item> {
    match &item.layout {
        Layout::Fence(Delimiter::Round, inside) => match inside.as_slice() {
            [only] => Some(only),
            _ => None,
        },
        _ => None,
    }
}

fn plain(item: &Item) -> Option<Name> {
    names::printed(item, None).filter(|found| found.sup.is_none() && found.dots == 0).map(|found| found.name)
}

fn mention(items: &[&Item], name: &Name) -> bool {
    items.iter().any(|item| mentions(item, name))
}

fn mentions(item: &Item, name: &Name) -> bool {
    names::printed(item, None).is_some_and(|found| found.name == *name)
        || parts(item).into_iter().flatten().any(|part| mentions(part, name))
}
