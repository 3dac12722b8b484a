//! The statements of a display as lists of items, before they are read.

use super::super::super::super::layout::{Item, Layout};
use super::super::super::super::lexer::Space;
use super::super::super::super::rows::relation;

/// The statements in a display: what rows, commas and wide spaces part. Spaces and alignment marks are left out.
pub(super) fn statements(items: &[Item]) -> Vec<Vec<&Item>> {
    let mut found = vec![Vec::new()];
    add(items, &mut found);
    found.retain(|statement| !statement.is_empty());
    found
}

fn add<'a>(items: &'a [Item], found: &mut Vec<Vec<&'a Item>>) {
    for item in items {
        match &item.layout {
            Layout::Environment(name, rows) if prints_rows(name) => {
                for row in rows {
                    found.push(Vec::new());
                    row.iter().for_each(|cell| add(cell, found));
                }
                found.push(Vec::new());
            }
            Layout::Row | Layout::Other(',' | ';') | Layout::Space(Space::Wide) => found.push(Vec::new()),
            Layout::Space(_) | Layout::Align => {}
            _ => found.last_mut().into_iter().for_each(|last| last.push(item)),
        }
    }
}

fn prints_rows(name: &str) -> bool {
    let plain = name.trim_end_matches('*');
    ["align", "split", "gather", "eqnarray", "multline"].iter().any(|rows| plain.starts_with(rows))
}

/// What stands before the first relation of a statement, and what stands between it and the next one.
pub(super) fn first_sides<'a, 'i>(statement: &'a [&'i Item]) -> Option<(&'a [&'i Item], &'a [&'i Item])> {
    let mut sides = statement.split(|item| relation(item).is_some());
    let (left, right) = (sides.next()?, sides.next()?);
    (!left.is_empty() && !right.is_empty()).then_some((left, right))
}
