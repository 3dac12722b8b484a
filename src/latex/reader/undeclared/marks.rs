//! Whether δ before a letter is a variation or a factor, and whether Δ is a quantity of its own.
//!
//! In `\delta q` the δ is a variation far more often than a factor. It is a factor where the statement has a term without it
//! that begins with another small Greek letter before a name, as in −δ v − α x, and nothing shows a variation.

use crate::formula::symbols::{Inferred, Name};

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::lexer::Space;
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::{is_any_integral, is_number, is_numeric_item};

/// Small Greek letters that are coefficients before a name.
const COEFFICIENTS: [&str; 10] =
    ["\\alpha", "\\beta", "\\gamma", "\\epsilon", "\\varepsilon", "\\kappa", "\\lambda", "\\eta", "\\zeta", "\\mu"];

/// What is varied: an action, a Lagrangian, an energy, work, heat.
const VARIED: [&str; 12] = ["S", "L", "H", "W", "Q", "I", "E", "U", "T", "V", "F", "J"];

/// Records what a display shows about δ and Δ.
pub(in super::super::super) fn note_marks(items: &[Item], inferred: &mut Inferred) {
    let mut found = Marks::default();
    found.statements(items);
    inferred.varies = found.varies;
    inferred.has_coefficient = found.is_factor && !found.varies;
    inferred.has_difference_alone = found.has_difference_alone;
    inferred.has_partials = has_partials(items);
}

/// Whether ∂ stands anywhere in items.
fn has_partials(items: &[Item]) -> bool {
    let is_mark = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\partial");
    items.iter().any(|item| is_mark(item) || parts(item).into_iter().any(has_partials))
}

/// Whether δ before a letter is a factor in a display.
pub(in super::super::super) fn has_coefficient(items: &[Item]) -> bool {
    let mut inferred = Inferred::default();
    note_marks(items, &mut inferred);
    inferred.has_coefficient
}

#[derive(Default)]
struct Marks {
    varies: bool,
    is_factor: bool,
    has_difference_alone: bool,
}

impl Marks {
    /// Items with statements in them: the parts between rows, commas and wide spaces.
    fn statements(&mut self, items: &[Item]) {
        let separates =
            |item: &Item| matches!(item.layout, Layout::Row | Layout::Other(',' | ';') | Layout::Space(Space::Wide));
        for statement in items.split(separates) {
            let solid: Vec<&Item> =
                statement.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Align)).collect();
            for item in &solid {
                if let Layout::Environment(_, rows) = &item.layout {
                    let rows = rows.iter().map(|row| row.concat());
                    rows.collect::<Vec<_>>().iter().for_each(|row| self.statements(row));
                }
            }
            self.list(&solid);
            self.statement(&solid);
        }
    }

    /// One statement: whether δ stands in each of its terms, or beside terms with other coefficients.
    fn statement(&mut self, solid: &[&Item]) {
        let is_sign = |item: &&Item| matches!(item.layout, Layout::Other('+' | '-')) || relation(item).is_some();
        let is_zero = |term: &[&Item]| matches!(term, [only] if is_number(only));
        let terms: Vec<&[&Item]> = solid.split(is_sign).filter(|term| !term.is_empty() && !is_zero(term)).collect();
        let (with, without): (Vec<&[&Item]>, Vec<&[&Item]>) =
            terms.into_iter().partition(|term| has_varied_name(term.iter().copied()));
        if with.is_empty() {
            return;
        }
        self.varies |= without.is_empty();
        self.is_factor |= without.iter().any(|term| begins_with_a_coefficient(term));
    }

    /// Neighbours: δ before an action or an integral, q + δq, Δ alone.
    fn list(&mut self, solid: &[&Item]) {
        let printed = |at: usize| solid.get(at).and_then(|item| names::printed(item, None)).map(|found| found.name);
        for (at, item) in solid.iter().enumerate() {
            let next = solid.get(at + 1);
            if is_command(item, "\\delta") {
                self.varies |= next.is_some_and(|next| is_any_integral(next));
                if let Some(name) = printed(at + 1) {
                    let is_before = at > 1 && matches!(solid[at - 1].layout, Layout::Other('+' | '-'));
                    let before = if is_before { printed(at - 2) } else { None };
                    self.varies |= before.is_some_and(|before| before.base == name.base) || is_varied(&name);
                }
            }
            self.has_difference_alone |= is_command(item, "\\Delta") && printed(at + 1).is_none();
            self.inside(item);
        }
    }

    fn inside(&mut self, item: &Item) {
        match &item.layout {
            Layout::Group(items) | Layout::Fence(_, items) => self.list(&solid(items)),
            Layout::Fraction(above, below) => {
                let starts = |part: &Item| contents(part).first().is_some_and(|first| is_command(first, "\\delta"));
                self.varies |= starts(above) && starts(below);
                self.list(&solid(contents(above)));
                self.list(&solid(contents(below)));
            }
            Layout::Scripts { nucleus, sup, .. } => {
                self.inside(nucleus);
                self.has_difference_alone |= is_command(nucleus, "\\Delta");
                if let Some(sup) = sup {
                    self.list(&solid(contents(sup)));
                }
            }
            Layout::Root(_, inner) => self.list(&solid(contents(inner))),
            _ => {}
        }
    }
}

fn solid(items: &[Item]) -> Vec<&Item> {
    items.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Align)).collect()
}

fn is_command(item: &Item, command: &str) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == command)
}

fn is_varied(name: &Name) -> bool {
    VARIED.contains(&name.base.as_str()) || name.base.starts_with("\\mathcal{")
}

/// Whether δ stands before a name anywhere in some items.
fn has_varied_name<'i>(items: impl IntoIterator<Item = &'i Item>) -> bool {
    let mut after_delta = false;
    for item in items {
        if after_delta && names::printed(item, None).is_some() {
            return true;
        }
        after_delta = is_command(item, "\\delta");
        let inside = match &item.layout {
            Layout::Group(items) | Layout::Fence(_, items) => has_varied_name(items),
            Layout::Fraction(above, below) => has_varied_name(contents(above)) || has_varied_name(contents(below)),
            Layout::Scripts { nucleus, .. } | Layout::Root(_, nucleus) => has_varied_name([&**nucleus]),
            _ => false,
        };
        if inside {
            return true;
        }
    }
    false
}

/// Whether a term is a coefficient before a name, with a number before it perhaps: `\alpha x`, `\frac12\epsilon z^2`.
fn begins_with_a_coefficient(term: &[&Item]) -> bool {
    let rest = match term {
        [first, rest @ ..] if is_number(first) || is_numeric_item(first) => rest,
        term => term,
    };
    let is_coefficient = |item: &Item| {
        names::printed(item, None)
            .is_some_and(|found| found.sup.is_none() && COEFFICIENTS.contains(&found.name.base.as_str()))
    };
    matches!(rest, [first, second, ..] if is_coefficient(first) && names::printed(second, None).is_some())
}
