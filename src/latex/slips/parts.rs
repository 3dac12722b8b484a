//! The parts of a typeset list: its formulas, their terms with signs, and the factors of a term.

use crate::formula::Kind;
use crate::formula::tree::Function;
use crate::source::Span;

use super::super::layout::{Item, Layout};
use super::super::lexer::Space;
use super::super::names;
use super::finder::Finder;

/// A term of a list: its sign, where one is printed, and its items.
pub(super) struct Term<'i> {
    pub sign: Option<&'i Item>,
    pub items: &'i [Item],
}

impl Term<'_> {
    /// The bytes of the term without its sign.
    pub fn span(&self) -> Span {
        self.items.iter().map(|item| item.span).reduce(Span::to).unwrap_or_default()
    }

    pub(super) fn whole(&self) -> Span {
        self.sign.map_or(self.span(), |sign| sign.span.to(self.span()))
    }
}

/// A factor of a term, and the operator before it, if there is one.
#[derive(Clone, Copy)]
pub(super) struct Factor<'i> {
    pub operator: Option<&'i Item>,
    pub items: &'i [Item],
}

impl Factor<'_> {
    pub fn span(&self) -> Span {
        self.items.iter().map(|item| item.span).reduce(Span::to).unwrap_or_default()
    }
}

/// Whether an item separates formulas: a relation, the end of a row or a cell, a comma, a wide space, a word.
fn separates(item: &Item) -> bool {
    match &item.layout {
        Layout::Other('=' | '<' | '>' | ',' | ';' | '≈' | '≡' | '≤' | '≥' | '≠' | ':') => true,
        Layout::Row | Layout::Align | Layout::Space(Space::Wide) | Layout::Text(_) | Layout::Fault(_) => true,
        Layout::Command(name) => matches!(
            name.as_str(),
            "\\equiv"
                | "\\coloneqq"
                | "\\lt"
                | "\\gt"
                | "\\leq"
                | "\\geq"
                | "\\neq"
                | "\\approx"
                | "\\propto"
                | "\\to"
                | "\\in"
                | "\\Rightarrow"
                | "\\Leftrightarrow"
                | "\\therefore"
        ),
        _ => false,
    }
}

fn is_sign(item: &Item) -> bool {
    match &item.layout {
        Layout::Other('+' | '-') => true,
        Layout::Command(name) => name == "\\pm" || name == "\\mp",
        _ => false,
    }
}

pub(super) fn is_space(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(_) | Layout::Other('.'))
}

/// `\cdot`, `\times`, `/`.
fn is_operator(item: &Item) -> bool {
    match &item.layout {
        Layout::Other('/' | '*' | '·' | '⋅' | '×') => true,
        Layout::Command(name) => ["\\cdot", "\\times", "\\wedge"].contains(&name.as_str()),
        _ => false,
    }
}

pub(super) fn is_times(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == "\\times" || name == "\\wedge")
        || item.layout == Layout::Other('×')
}

/// The name of a command, with or without scripts.
fn command(item: &Item) -> Option<&str> {
    match &item.layout {
        Layout::Command(name) => Some(name),
        Layout::Scripts { nucleus, .. } => command(nucleus),
        _ => None,
    }
}

/// Whether an item is Σ, ∫ or lim, which apply to all following factors.
pub(super) fn is_big(item: &Item) -> bool {
    matches!(command(item), Some("\\sum" | "\\int" | "\\lim"))
}

/// Σ alone.
pub(super) fn is_sum(item: &Item) -> bool {
    command(item) == Some("\\sum")
}

/// ∫ alone.
pub(super) fn is_integral(item: &Item) -> bool {
    command(item) == Some("\\int")
}

/// `\sin` and the like, with a power perhaps.
pub(super) fn is_function(item: &Item) -> bool {
    command(item).and_then(|name| name.strip_prefix('\\')).is_some_and(|name| Function::named(name).is_some())
}

/// The formulas of a list, each as a list of terms.
pub(super) fn formulas(items: &[Item]) -> Vec<Vec<Term<'_>>> {
    items.split(separates).map(terms).filter(|terms| !terms.is_empty()).collect()
}

fn terms(items: &[Item]) -> Vec<Term<'_>> {
    let mut terms: Vec<Term<'_>> = Vec::new();
    let mut start = 0;
    let mut sign = None;
    for at in 0..=items.len() {
        let ends = at == items.len() || is_sign(&items[at]);
        if !ends {
            continue;
        }
        let inner = trimmed(&items[start..at]);
        // The items of one macro call have one place and stay together.
        let real = sign.is_none_or(|sign: &Item| !inner.iter().any(|item| item.span == sign.span));
        if !inner.is_empty() && real {
            terms.push(Term { sign, items: inner });
        }
        sign = items.get(at);
        start = at + 1;
    }
    terms
}

fn trimmed(mut items: &[Item]) -> &[Item] {
    while let [first, rest @ ..] = items
        && is_space(first)
    {
        items = rest;
    }
    while let [rest @ .., last] = items
        && is_space(last)
    {
        items = rest;
    }
    items
}

impl Finder<'_> {
    /// The factors of a term. A function with its argument is one factor, and so is a rotation with its angle.
    pub(super) fn factors<'i>(&self, items: &'i [Item]) -> Vec<Factor<'i>> {
        let mut factors: Vec<Factor<'i>> = Vec::new();
        let mut operator = None;
        let mut at = 0;
        while at < items.len() {
            let item = &items[at];
            if is_space(item) {
                at += 1;
                continue;
            }
            if is_operator(item) {
                operator = Some(item);
                at += 1;
                continue;
            }
            let start = at;
            at += 1;
            let takes = is_function(item)
                || self.is_rotation(item) && matches!(items.get(at), Some(Item { layout: Layout::Fence(..), .. }));
            if takes {
                at += items[at..].iter().take_while(|next| is_space(next)).count();
                at = (at + 1).min(items.len());
            }
            // A macro is one factor, whatever it expands to.
            while items.get(at).is_some_and(|next| next.span == items[at - 1].span) {
                at += 1;
            }
            factors.push(Factor { operator: operator.take(), items: &items[start..at] });
        }
        factors
    }

    pub(super) fn kind(&self, item: &Item) -> Option<Kind> {
        let printed = names::printed(item, None)?;
        let found = self.symbols.find(&printed.name).map(|(id, _)| id);
        found.or_else(|| self.symbols.find_whole(&printed.name.base)).map(|id| self.symbols.entry(id).kind)
    }

    fn is_rotation(&self, item: &Item) -> bool {
        self.kind(item) == Some(Kind::Rotation)
    }

    pub(super) fn is_matrix(&self, factor: &Factor<'_>) -> bool {
        let item = &factor.items[0];
        matches!(item.layout, Layout::Environment(..))
            || matches!(self.kind(item), Some(Kind::Matrix(..) | Kind::Rotation))
    }

    /// Whether a factor is a matrix by its entries, `R_{ab}`. A single entry, `R_{12}`, has no inverse in print.
    pub(super) fn is_entry(&self, factor: &Factor<'_>) -> bool {
        let Some(printed) = names::printed(&factor.items[0], None) else { return false };
        let found = self.symbols.find(&printed.name);
        found.is_some_and(|(id, _)| self.symbols.entry(id).slots.len() == 2)
            && !printed.name.subscript.concat().contains(char::is_numeric)
    }
}

/// Whether a factor is a number or a fraction of numbers.
pub(super) fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix("\\frac").unwrap_or(text);
    digits.chars().all(|c| c.is_ascii_digit() || matches!(c, '{' | '}' | ' '))
}

/// The lists that an item holds.
pub(super) fn insides(item: &Item) -> Vec<&[Item]> {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => vec![items],
        Layout::Fraction(a, b) => [a, b].into_iter().flat_map(|inner| insides(inner)).collect(),
        Layout::Root(_, inner) | Layout::Scripts { nucleus: inner, .. } => insides(inner),
        Layout::Environment(_, rows) => rows.iter().flatten().map(Vec::as_slice).collect(),
        _ => Vec::new(),
    }
}
