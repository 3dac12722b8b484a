//! What separates statements, and the words that a side is constant.

use crate::source::Span;

use super::super::layout::{Item, Layout, contents, latex};
use super::super::lexer::Space;
use super::super::names;
use super::super::rows::relation;

/// Whether a comma or a point does not separate statements: `1,000`, `a.b`, `x + ... + y`.
pub(super) fn joins(items: &[&Item], at: usize) -> bool {
    let before = at.checked_sub(1).map(|before| items[before]);
    let after = items.get(at + 1).copied();
    let is_number = |item: Option<&Item>| item.is_some_and(|item| matches!(item.layout, Layout::Number(_)));
    let is_point = |item: Option<&Item>| item.is_some_and(|item| item.layout == Layout::Other('.'));
    match items[at].layout {
        Layout::Other(',') => {
            let touches = after.is_some_and(|next| next.span.start == items[at].span.end);
            touches && is_number(before) && is_number(after)
        }
        Layout::Other('.') => {
            let rest = items[at + 1..].iter().find(|next| !matches!(next.layout, Layout::Space(Space::Thin)));
            is_point(before) || is_point(after) || rest.is_some_and(|next| !separates(next))
        }
        _ => false,
    }
}

/// Whether a point stands between a word and a relation.
pub(super) fn ends_a_word(items: &[&Item], at: usize) -> bool {
    let is_word = |item: &Item| {
        matches!(&item.layout, Layout::Text(_))
            || matches!(&item.layout, Layout::Style(style, _) if style == "\\mathrm")
    };
    let next = items[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    items[at].layout == Layout::Other('.')
        && at.checked_sub(1).is_some_and(|before| is_word(items[before]))
        && next.is_some_and(|next| relation(next).is_some())
}

pub(super) fn separates(item: &Item) -> bool {
    match &item.layout {
        Layout::Other(',' | ';' | '.') | Layout::Space(Space::Wide) => true,
        Layout::Command(name) => matches!(name.as_str(), "\\Rightarrow" | "\\Leftrightarrow" | "\\therefore"),
        Layout::Text(word) => is_separator(word),
        Layout::Style(style, inner) if style == "\\mathrm" => {
            ["where", "so", "hence", "thus", "therefore", "with"].contains(&latex(contents(inner)).trim())
        }
        _ => false,
    }
}

fn is_separator(word: &str) -> bool {
    let bare = word.trim_matches([',', '.']);
    matches!(
        bare.strip_suffix(':').filter(|word| !word.is_empty()).unwrap_or(bare),
        "and" | "so" | "hence" | "thus" | "therefore" | "sothat" | "where" | "with" | ""
    )
}

/// The letters of `constant` or `const` at the end of a side, with their number.
pub(super) fn spelled_constant(items: &[&Item], at: usize) -> Option<(Span, usize)> {
    let letter = |item: &&Item| match item.layout {
        Layout::Letter(c) => Some(c),
        _ => None,
    };
    let word: String = items[at..].iter().map_while(letter).collect();
    let last = items.get(at + word.len().checked_sub(1)?)?;
    let ends = items.get(at + word.len()).is_none_or(|next| separates(next) || matches!(next.layout, Layout::Space(_)));
    (ends && ["constant", "const", "Constant", "Const", "cte", "cste", "cst", "konst"].contains(&word.as_str()))
        .then(|| (items[at].span.to(last.span), word.len()))
}

/// The place of the words that a side is constant: `\text{ is constant}`, `\mathrm{const}`.
pub fn says_constant(item: &Item) -> Option<Span> {
    let word = match &item.layout {
        Layout::Text(word) => word.clone(),
        Layout::Style(style, _) if style == "\\mathrm" => names::printed(item, None)?.name.base,
        Layout::Scripts { .. } => return None,
        _ => return None,
    };
    let word = word.trim_start_matches("\\mathrm{").trim_end_matches(['}', '.', ',', ';', ' ']);
    let is_foreign = || matches!(word, "cte" | "cste" | "constante" | "costante" | "konst" | "konstant" | "konstante");
    (matches!(word, "isconstant" | "isconserved" | "const" | "constant" | "=const") || is_foreign())
        .then_some(item.span)
}
