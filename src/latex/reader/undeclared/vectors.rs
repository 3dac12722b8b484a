//! Dots between bold letters of which one is a matrix: `\mathbf{t} = \boldsymbol\sigma\cdot\mathbf{n}`; and what is refused,
//! `\vec a\cdot\vec b\,\vec c` and `\nabla\times\vec a\times\vec b`.
//!
//! The dot product of two vectors is a number. Where it equals a vector, or is a term beside one, its first letter is a matrix. So
//! is a capital between two dots.

use crate::source::Fault;

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::lexer::Space;
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::{Joint, joint};

/// What a term is.
enum Term {
    /// One vector with factors.
    Vector,
    /// A dot between two vectors, with the name of the first one.
    Dot(String),
    Other,
}

/// The letters that are matrices by the dots behind them.
pub(in super::super::super) fn matrices(items: &[Item]) -> Vec<String> {
    let mut found = Vec::new();
    each_list(items, &mut |list| {
        for equation in list.split(|item| divides(item)) {
            let terms: Vec<&[&Item]> = equation.split(|item| is_sign(item)).collect();
            let kinds: Vec<Term> = terms.iter().map(|term| kind(term)).collect();
            if kinds.iter().any(|kind| matches!(kind, Term::Vector)) {
                found.extend(kinds.into_iter().filter_map(|kind| match kind {
                    Term::Dot(first) => Some(first),
                    _ => None,
                }));
            }
            found.extend(terms.iter().flat_map(|term| between_dots(term)));
        }
    });
    found
}

/// The fault of `\vec a\cdot\vec b\,\vec c` and of `\nabla\times\vec a\times\vec b`.
pub(in super::super::super) fn unclear_product(items: &[Item]) -> Option<Fault> {
    let mut found = None;
    each_list(items, &mut |list| {
        let solid: Vec<&&Item> = list.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        let unclear = solid.windows(4).find(|four| {
            let is_small = |item: &Item| vector(item).is_some_and(|name| is_small(&name));
            is_small(four[0]) && joint(four[1]) == Some(Joint::CDot) && is_small(four[2]) && is_small(four[3])
        });
        if let Some(four) = unclear {
            let span = four[0].span.to(four[3].span);
            found.get_or_insert_with(|| {
                Fault::ambiguous(span, "a·b c may be (a·b) c or a·(b c)").help("use parentheses")
            });
        }
        let curl = solid.windows(4).find(|four| {
            let is_times = |item: &Item| joint(item) == Some(Joint::Times);
            let is_nabla = matches!(&four[0].layout, Layout::Command(name) if name == "\\nabla");
            is_nabla && is_times(four[1]) && names::printed(four[2], None).is_some() && is_times(four[3])
        });
        if let Some(four) = curl {
            let span = four[0].span.to(four[3].span);
            found.get_or_insert_with(|| {
                Fault::ambiguous(span, "∇ × a × b may be (∇ × a) × b or ∇ × (a × b)").help("use parentheses")
            });
        }
    });
    found
}

/// Calls `look` with each list of items; the cells of a row are one list.
fn each_list(items: &[Item], look: &mut dyn FnMut(&[&Item])) {
    look(&items.iter().collect::<Vec<_>>());
    for item in items {
        match &item.layout {
            Layout::Group(inside) | Layout::Fence(Delimiter::Round | Delimiter::Square | Delimiter::Curly, inside) => {
                each_list(inside, look);
            }
            Layout::Environment(_, rows) => {
                for row in rows {
                    look(&row.iter().flatten().collect::<Vec<_>>());
                }
            }
            _ => {}
        }
    }
}

/// Whether an item ends an equation.
fn divides(item: &Item) -> bool {
    match &item.layout {
        Layout::Row | Layout::Text(_) | Layout::Space(Space::Wide) | Layout::Other(',' | ';' | '.') => true,
        Layout::Command(name) => name.ends_with("arrow") || name == "\\therefore" || name == "\\in",
        _ => false,
    }
}

fn is_sign(item: &Item) -> bool {
    relation(item).is_some() || matches!(item.layout, Layout::Other('+' | '-'))
}

/// The name of a letter in bold or with an arrow, without a power.
fn vector(item: &Item) -> Option<String> {
    let found = names::printed(item, None).filter(|found| found.sup.is_none())?;
    ["\\mathbf{", "\\vec{"].iter().any(|mark| found.name.base.contains(mark)).then_some(found.name.base)
}

/// The letter below the marks of a name.
fn letter(name: &str) -> &str {
    name.rsplit('{').next().map_or(name, |inner| inner.trim_end_matches('}'))
}

fn is_small(name: &str) -> bool {
    letter(name).starts_with(|c: char| c.is_lowercase())
}

/// Whether vectors may stand in an item that is no name itself.
fn may_hold_vectors(item: &Item) -> bool {
    match &item.layout {
        Layout::Fraction(..) | Layout::Number(_) | Layout::Space(_) | Layout::Align => false,
        Layout::Command(name) => name == "\\nabla" || name == "\\partial",
        _ => names::printed(item, None).is_none(),
    }
}

fn kind(term: &[&Item]) -> Term {
    let solid: Vec<&Item> =
        term.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Align)).copied().collect();
    let joints: Vec<(usize, Joint)> =
        solid.iter().enumerate().filter_map(|(at, item)| joint(item).map(|joint| (at, joint))).collect();
    let vectors: Vec<(usize, String)> =
        solid.iter().enumerate().filter_map(|(at, item)| vector(item).map(|name| (at, name))).collect();
    let is_plain = solid.iter().all(|item| joint(item).is_some() || !may_hold_vectors(item));
    match (vectors.as_slice(), joints.as_slice()) {
        ([_], []) if is_plain => Term::Vector,
        ([(first, name), (second, _)], [(dot, Joint::CDot)])
            if is_plain && first + 1 == *dot && dot + 1 == *second && name.contains("\\mathbf{") =>
        {
            Term::Dot(name.clone())
        }
        _ => Term::Other,
    }
}

/// Bold capitals between two dots that stand between vectors: the I of `\omega\cdot I\cdot\omega`.
fn between_dots(term: &[&Item]) -> Vec<String> {
    let solid: Vec<&Item> = term.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).copied().collect();
    let is_dot = |item: &Item| joint(item) == Some(Joint::CDot);
    solid
        .windows(5)
        .filter(|five| is_dot(five[1]) && is_dot(five[3]) && vector(five[0]).is_some() && vector(five[4]).is_some())
        .filter_map(|five| vector(five[2]))
        .filter(|name| name.contains("\\mathbf{") && !is_small(name))
        .collect()
}
