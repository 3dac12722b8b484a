//! Where the condition of a statement begins and ends: `\text{for } x > 0`, `\text{at } y = 1`.

use super::super::layout::{Delimiter, Item, Layout, contents, latex};
use super::super::lexer::Space;
use super::super::rows::relation;
use super::separators::{joins, separates};

/// Whether an item begins a condition: `\text{for}`, `\text{if}`, `\forall`.
pub(super) fn begins_condition(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\forall",
        // `{\rm in} \ \Omega`
        Layout::Style(style, inner) if style == "\\mathrm" => {
            ["in", "on", "at", "for", "if", "when"].contains(&latex(contents(inner)).trim())
        }
        Layout::Text(word) => matches!(
            word.trim_matches(|c: char| c == ',' || c == '.').to_ascii_lowercase().as_str(),
            "for"
                | "if"
                | "when"
                | "whenever"
                | "provided"
                | "providedthat"
                | "forall"
                | "forevery"
                | "foreach"
                | "forany"
                | "at"
                | "on"
                | "in"
                | "as"
                | "validfor"
                | "validif"
                | "validwhen"
                | "holdsfor"
                | "holdsif"
                | "onlyfor"
                | "onlyif"
        ),
        _ => false,
    }
}

/// Whether a condition ends here: at a wide space, or at a comma or a word before something that compares nothing.
pub(super) fn ends_condition(items: &[&Item], at: usize) -> bool {
    match &items[at].layout {
        Layout::Space(Space::Wide) => {
            // `\text{at} \quad y = 1`
            let before = items[..at].iter().rev().find(|item| !is_pause(item));
            items[at + 1..].iter().any(|next| !is_pause(next)) && !before.is_some_and(|item| begins_condition(item))
        }
        Layout::Other(';' | '.') => separates(items[at]) && !joins(items, at),
        Layout::Command(_) => separates(items[at]),
        Layout::Text(word) => separates(items[at]) && (word != "and" || is_after_a_region(items, at)),
        Layout::Other(',') => is_after_a_region(items, at),
        _ => false,
    }
}

/// Whether a place without a comparison stands before another statement: `u = 0 \text{ on } \Gamma, v = 0 \text{ in } \Omega`.
fn is_after_a_region(items: &[&Item], at: usize) -> bool {
    let Some(word) = items[..at].iter().rposition(|item| begins_condition(item)) else { return false };
    let is_place = matches!(&items[word].layout, Layout::Text(word) if matches!(word.as_str(), "at" | "on" | "in"));
    let has_relation = |items: &[&Item]| items.iter().any(|item| relation(item).is_some());
    is_place && !has_relation(&items[word..at]) && has_relation(&items[at + 1..])
}

pub(super) fn is_pause(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(_) | Layout::Other(','))
}

/// Whether an item is a parenthesis with a comparison in it. `(\hat a|0\rangle = 0)` is a result, and restricts nothing.
pub(super) fn is_comparison(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    // `(t \ll \tau)`, `(r \to \infty)`
    let compares = |item: &Item| {
        let is_sign = |name: &str| ["\\to", "\\rightarrow", "\\ll", "\\gg", "\\lesssim", "\\gtrsim"].contains(&name);
        relation(item).is_some() || matches!(&item.layout, Layout::Command(name) if is_sign(name))
    };
    let Some(at) = inside.iter().position(compares) else { return false };
    let has_state = inside[..at].iter().any(|item| matches!(item.layout, Layout::Fence(Delimiter::Ket, _)));
    !(has_state && inside[at].layout == Layout::Other('='))
}
