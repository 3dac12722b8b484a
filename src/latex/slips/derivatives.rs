//! Corrections of the marks of a partial derivative: a lost ∂, and d for ∂.

use super::super::layout::{Item, Layout};
use super::super::names;
use super::edit::Slip;
use super::finder::Finder;
use crate::source::Span;

/// What a numerator or a denominator begins with.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    Partial(Span),
    Total(Span),
    None(usize),
}

impl Finder<'_> {
    /// `\frac{dL}{\partial x}` and `\frac{L}{\partial x}` lack a ∂.
    pub(super) fn marks(&mut self, above: &Item, below: &Item) {
        if self.pool.is_none() {
            return;
        }
        let partial = || "\\partial ".to_owned();
        match (mark(above), mark(below)) {
            (Mark::Total(at), Mark::Partial(_)) | (Mark::Partial(_), Mark::Total(at)) => {
                self.edit(Slip::Symbol, at, partial());
            }
            (Mark::None(at), Mark::Partial(_)) | (Mark::Partial(_), Mark::None(at)) => {
                self.edit(Slip::Factor, Span { start: at, end: at }, partial());
            }
            _ => {}
        }
    }
}

fn mark(item: &Item) -> Mark {
    let (first, start) = match &item.layout {
        Layout::Group(items) => match items.iter().find(|inner| !matches!(inner.layout, Layout::Space(_))) {
            Some(first) => (first, first.span.start),
            None => (item, item.span.end),
        },
        _ => (item, item.span.start),
    };
    let nucleus = match &first.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => first,
    };
    let is_d = names::printed(nucleus, None)
        .is_some_and(|printed| printed.dots == 0 && ["d", "\\mathrm{d}"].contains(&printed.name.to_string().as_str()));
    match &nucleus.layout {
        Layout::Command(name) if name == "\\partial" => Mark::Partial(nucleus.span),
        _ if is_d => Mark::Total(nucleus.span),
        _ => Mark::None(start),
    }
}
