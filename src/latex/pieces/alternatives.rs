//! The parts of a row in which "or" stands between statements or values: `x = 4 \quad\text{or}\quad x = -1`.
//!
//! One of them holds, and perhaps not the others. So none of them is a statement of its own: what would be read of them is
//! "and". They are kept together, from the last arrow or wide space before them to the next one.

use std::ops::Range;

use super::super::layout::{Item, Layout};
use super::super::lexer::Space;
use super::super::rows::{is_operator, relation};
use super::conditions::begins_condition;

/// The places of the alternatives in a row, in order. A place that begins with the word has its first alternative in a row
/// before.
pub(super) fn alternatives(items: &[&Item]) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    for at in (0..items.len()).filter(|at| is_or(items, *at)) {
        if found.last().is_some_and(|last| last.contains(&at)) {
            continue;
        }
        let start = items[..at].iter().rposition(|item| ends(item) || begins_condition(item));
        let Some(start) = start_after(items, at, start) else { continue };
        let mut end = at + 1;
        while end < items.len() && !(is_break(items, end) || ends(items[end])) {
            end += 1;
        }
        found.push(start..end);
    }
    found
}

/// Whether alternatives begin with the word, so that the first of them stands before these items.
pub(super) fn are_open(items: &[&Item]) -> bool {
    !items.is_empty() && is_or(items, 0)
}

/// Where the alternatives before a word begin; `None` where the word belongs to a condition.
fn start_after(items: &[&Item], at: usize, last: Option<usize>) -> Option<usize> {
    let mut start = at;
    while start > last.map_or(0, |last| last + 1) && !is_break(items, start - 1) {
        start -= 1;
    }
    let reaches = last.filter(|last| start == last + 1);
    reaches.is_none_or(|last| !begins_condition(items[last])).then_some(start)
}

/// Whether an arrow or a word begins another thought here.
fn ends(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => matches!(name.as_str(), "\\Rightarrow" | "\\Leftrightarrow" | "\\therefore"),
        Layout::Text(word) => matches!(bare(word), "so" | "hence" | "thus" | "therefore" | "sothat" | "where" | "with"),
        _ => false,
    }
}

/// Whether a wide space ends the alternatives: it stands neither beside "or", "and" or a comma, nor inside of a statement.
fn is_break(items: &[&Item], at: usize) -> bool {
    if items[at].layout != Layout::Space(Space::Wide) {
        return false;
    }
    let is_solid = |item: &&&Item| !matches!(item.layout, Layout::Space(_));
    let joins = |item: &Item| match &item.layout {
        Layout::Other(',') => true,
        Layout::Text(word) => is_word(word) || bare(word) == "and",
        Layout::Command(name) => name == "\\lor" || name == "\\vee",
        _ => relation(item).is_some() || is_operator(item),
    };
    let before = items[..at].iter().rev().find(is_solid);
    let after = items[at..].iter().find(is_solid);
    !before.is_some_and(|item| joins(item)) && !after.is_some_and(|item| joins(item) || begins_condition(item))
}

/// Whether an item says that one of several holds: the word, or ∨ between statements.
fn is_or(items: &[&Item], at: usize) -> bool {
    let has_relation = |items: &[&Item]| items.iter().any(|item| relation(item).is_some());
    match &items[at].layout {
        Layout::Text(word) => is_word(word),
        Layout::Command(name) => {
            (name == "\\lor" || name == "\\vee") && has_relation(&items[..at]) && has_relation(&items[at + 1..])
        }
        _ => false,
    }
}

fn is_word(word: &str) -> bool {
    matches!(bare(word), "or" | "oder" | "ou")
}

fn bare(word: &str) -> &str {
    word.trim_matches(|c: char| c == ',' || c == '.')
}
