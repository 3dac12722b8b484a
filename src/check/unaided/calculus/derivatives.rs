//! Derivatives in print.

use crate::formula::symbols::Name;
use crate::latex::layout::values::{ends_term, is_d_or_partial, parts_of};
use crate::latex::layout::{Item, Layout, contents};
use crate::latex::names;
use crate::source::Span;

/// A derivative in print.
pub(in crate::check::unaided) struct Derivative {
    /// Where it stands.
    pub span: Span,
    /// The names in what is differentiated.
    pub of: Vec<Name>,
    /// The variables.
    pub by: Vec<Name>,
}

/// The derivatives in items: `\frac{\partial u}{\partial x}`, `\frac{\partial}{\partial x} u`, `\partial_x u`.
pub(in crate::check::unaided) fn collect(items: &[Item], found: &mut Vec<Derivative>) {
    for (at, item) in items.iter().enumerate() {
        let rest = &items[at + 1..];
        match &item.layout {
            Layout::Fraction(above, below) => {
                let (above, below) = (contents(above), contents(below));
                let is_mark = |items: &[Item]| items.first().is_some_and(|first| is_d_or_partial(nucleus(first)));
                if is_mark(above) && is_mark(below) {
                    let mut by = names_in(below);
                    by.dedup();
                    let operand = solid(&above[1..]);
                    let of = if operand.is_empty() { names_in(next_term(rest)) } else { names_in(&above[1..]) };
                    found.push(Derivative { span: item.span, of, by });
                }
            }
            Layout::Scripts { nucleus, sub: Some(sub), .. } if matches!(&nucleus.layout, Layout::Command(name) if name == "\\partial") =>
            {
                found.push(Derivative { span: item.span, of: names_in(next_term(rest)), by: names_in(contents(sub)) });
            }
            _ => {}
        }
        parts_of(item).into_iter().for_each(|part| collect(part, found));
    }
}

/// The item without its scripts.
fn nucleus(item: &Item) -> &Item {
    match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    }
}

fn solid(items: &[Item]) -> Vec<&Item> {
    items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect()
}

/// The items up to the end of a term.
fn next_term(items: &[Item]) -> &[Item] {
    &items[..items.iter().position(ends_term).unwrap_or(items.len())]
}

/// The names in items.
pub(in crate::check::unaided) fn names_in(items: &[Item]) -> Vec<Name> {
    let mut found = Vec::new();
    for item in items.iter().filter(|item| !is_d_or_partial(nucleus(item))) {
        match names::printed(item, None) {
            Some(printed) => found.push(printed.name),
            None => parts_of(item).into_iter().for_each(|part| found.extend(names_in(part))),
        }
    }
    found
}
