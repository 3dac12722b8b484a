//! A statement as items.

use crate::formula::operators::Function;
use crate::formula::tree::Relation;
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout};
use super::super::names;
use super::super::reader::structure::{is_extremum, states};
use super::super::rows::{is_operator, is_significant};

/// A statement as items: each member with the relation before it; the first has none.
pub(in super::super) struct Piece<'a> {
    pub(in super::super) links: Vec<Link<'a>>,
    pub(in super::super) constant: Option<Span>,
    /// What stands after "for", "if" or "when", from that word on; and what stands in parentheses after a wide space.
    pub(in super::super) conditions: Vec<Vec<&'a Item>>,
    pub(in super::super) row: usize,
    /// Whether it holds alternatives, of which one holds: its only member has all of their items.
    pub(in super::super) has_alternatives: bool,
    /// Why it cannot be read, whatever its items say.
    pub(in super::super) fault: Option<Fault>,
    /// Whether it stands behind a wide space alone: a remark, or another column.
    pub(super) is_inserted: bool,
    /// The comma that separates it from the part before it.
    pub(super) comma: Option<&'a Item>,
}

/// The relation before a member and its place; `None` before the first.
pub(in super::super) type Printed = Option<(Relation, Span)>;

pub(in super::super) struct Link<'a> {
    pub(in super::super) relation: Printed,
    /// What prints the relation.
    pub(super) sign: Option<&'a Item>,
    pub(in super::super) items: Vec<&'a Item>,
}

impl Piece<'_> {
    pub(super) fn new(row: usize) -> Self {
        Piece {
            links: Vec::new(),
            constant: None,
            conditions: Vec::new(),
            row,
            has_alternatives: false,
            fault: None,
            is_inserted: false,
            comma: None,
        }
    }

    /// Whether a sign such as ∈ or → states something in it.
    pub(super) fn has_sign(&self) -> bool {
        self.links.iter().flat_map(|link| &link.items).any(|item| states(item))
    }

    /// Whether words in parentheses or in `\text{…}` are all there is.
    pub(super) fn is_a_remark(&self) -> bool {
        let [Link { relation: None, items, .. }] = self.links.as_slice() else { return false };
        let mut solid = items.iter().filter(is_significant);
        solid.next().is_some_and(|first| matches!(first.layout, Layout::Text(_))) && solid.next().is_none()
    }

    /// Whether `\min_x` or the like is all there is, so that what follows belongs to it: `\min_x \quad f(x)`.
    pub(super) fn is_an_extremum(&self) -> bool {
        let [Link { relation: None, items, .. }] = self.links.as_slice() else { return false };
        let mut solid = items.iter().filter(is_significant);
        solid.next().is_some_and(|first| is_extremum(first)) && solid.next().is_none()
    }

    /// The space of `\sin x = a \; \csc x = b`, which may separate two statements: a function of a name stands behind it, as
    /// on the left side.
    pub(super) fn unclear_space(&self) -> Option<Span> {
        let is_application = |items: &[&Item]| match items {
            [Item { layout: Layout::Command(name), .. }, argument] => {
                name.strip_prefix('\\').is_some_and(|name| Function::named(name).is_some())
                    && names::printed(argument, None).is_some_and(|found| found.sup.is_none())
            }
            _ => false,
        };
        let [first, middle @ .., _] = self.links.as_slice() else { return None };
        // `a = b ~~ c = d`: two spaces between two factors, each of which is beside a relation.
        let double = middle.iter().find_map(|link| {
            let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
            let at = link.items.windows(2).position(|pair| is_space(pair[0]) && is_space(pair[1]))?;
            let ends = |item: Option<&&Item>| item.is_some_and(|item| !is_operator(item));
            let before = link.items[..at].iter().rev().find(is_significant);
            let after = link.items[at..].iter().find(is_significant);
            (ends(before) && ends(after)).then(|| link.items[at].span)
        });
        if double.is_some() {
            return double;
        }
        let left: Vec<&Item> = first.items.iter().copied().filter(|item| is_significant(&item)).collect();
        middle.iter().filter(|_| is_application(&left)).find_map(|link| {
            let end = link.items.iter().rposition(|item| is_significant(&item)).map_or(0, |last| last + 1);
            let at = link.items[..end].iter().rposition(|item| matches!(item.layout, Layout::Space(_)))?;
            let is_after_a_factor =
                link.items[..at].iter().rev().find(is_significant).is_some_and(|item| !is_operator(item));
            (is_after_a_factor && is_application(&link.items[at + 1..end])).then(|| link.items[at].span)
        })
    }

    pub(super) fn ends_with_a_relation(&self) -> bool {
        self.links.last().is_some_and(|link| link.relation.is_some() && link.items.is_empty())
    }

    /// Where it stands.
    pub(in super::super) fn span(&self) -> Span {
        let spans = self.links.iter().flat_map(|link| {
            link.relation.iter().map(|(_, span)| *span).chain(link.items.iter().map(|item| item.span))
        });
        spans.reduce(Span::to).unwrap_or_default()
    }
}
