//! Lists of the values of an index, which say nothing of a formula: `n = 1, 2, 3, \dots`, `(n = 0, 1, 2)`, `n \in \mathbb{N}`.

use super::super::layout::{Delimiter, Item, Layout};
use super::super::lexer::Space;
use super::super::names;

/// The number of items at the beginning of these that list the values of an index, if they do.
pub(super) fn length(items: &[&Item]) -> Option<usize> {
    if let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), .. }) = items.first() {
        let inside: Vec<&Item> = inside.iter().collect();
        return length(&inside).filter(|length| *length == inside.len()).map(|_| 1);
    }
    let mut at = 0;
    let next = |at: &mut usize| {
        while matches!(items.get(*at).map(|item| &item.layout), Some(Layout::Space(_))) {
            *at += 1;
        }
        *at += 1;
        items.get(*at - 1).copied()
    };
    let name = names::printed(next(&mut at)?, None)?;
    let relation = next(&mut at)?;
    if name.dots > 0 || name.sup.is_some() || !name.name.subscript.is_empty() {
        return None;
    }
    if matches!(&relation.layout, Layout::Command(command) if command == "\\in") {
        let set = next(&mut at)?;
        return matches!(&set.layout, Layout::Style(style, _) if style == "\\mathbb").then_some(at);
    }
    if relation.layout != Layout::Other('=') {
        return None;
    }
    let (mut values, mut end) = (0, at);
    loop {
        let value = next(&mut at);
        let goes_on = match value.map(|item| &item.layout) {
            Some(Layout::Number(digits)) if digits.bytes().all(|digit| digit.is_ascii_digit()) => true,
            Some(Layout::Command(dots)) if dots.ends_with("dots") && values > 0 => false,
            _ => break,
        };
        (values, end) = (values + 1, at);
        if !goes_on {
            end += last_value(&items[end..]);
            break;
        }
        if next(&mut at).is_none_or(|item| item.layout != Layout::Other(',')) {
            break;
        }
    }
    // What else is in the list is no whole number.
    let rest = items[end..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    let ends = rest.is_none_or(|item| matches!(item.layout, Layout::Other('.' | ',' | ';') | Layout::Text(_)));
    (values > 1 && ends).then_some(end)
}

/// The number of items of the last value after dots, with the comma before it: the `, n - 1` of `i = 1, 2, \dots, n - 1`.
fn last_value(items: &[&Item]) -> usize {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(space) if space != Space::Wide);
    let Some(comma) = items.iter().position(|item| !is_space(item)) else { return 0 };
    if items[comma].layout != Layout::Other(',') {
        return 0;
    }
    let is_part = |item: &Item| {
        is_space(item)
            || matches!(item.layout, Layout::Number(_) | Layout::Other('+' | '-'))
            || names::printed(item, None).is_some_and(|found| found.sup.is_none() && found.dots == 0)
    };
    let value = items[comma + 1..].iter().take_while(|item| is_part(item)).count();
    let ends = items
        .get(comma + 1 + value)
        .is_none_or(|item| matches!(item.layout, Layout::Other('.' | ',' | ';') | Layout::Text(_) | Layout::Space(_)));
    let has_value = items[comma + 1..][..value].iter().any(|item| !is_space(item));
    if ends && has_value { comma + 1 + value } else { 0 }
}
