//! Letters that act on states or are multiplied in one order only, and so are no real numbers.
//!
//! | evidence | no number |
//! | --- | --- |
//! | a capital before a ket, or between a bra and a ket | the capital |
//! | `E \rho E^\dagger` | both letters |
//! | `\rho = … \vert a\rangle\langle a\vert` | the letter on the left |
//! | H beside states | H |
//! | capitals in a commutator, `[A, B]` | both |
//! | a letter with a transpose before another factor | the letter |

use crate::formula::symbols::{Inferred, Name};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::is_transpose;

/// Records these letters.
pub(in super::super::super) fn note_acting(items: &[Item], inferred: &mut Inferred) {
    let mut found = Found::default();
    found.list(items);
    if found.has_states {
        found.names.extend(found.hamiltonians);
    }
    // Where T stands elsewhere, a T above a letter may be a power.
    if !found.has_t {
        inferred.acting.extend(found.transposed);
    }
    inferred.acting.extend(found.names);
}

#[derive(Default)]
struct Found {
    names: Vec<Name>,
    transposed: Vec<Name>,
    has_t: bool,
    has_states: bool,
    hamiltonians: Vec<Name>,
}

impl Found {
    fn list(&mut self, items: &[Item]) {
        let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        for (at, item) in solid.iter().enumerate() {
            let next = solid.get(at + 1);
            if let Some(name) = name(item) {
                if is_capital(&name) && next.is_some_and(|next| is_state(next, Delimiter::Ket)) {
                    self.names.push(name.clone());
                }
                if name.base == "H" {
                    self.hamiltonians.push(name.clone());
                }
                self.has_t |= name == Name::plain("T");
                if above(item).is_some_and(is_transpose) && next.is_some_and(|next| self::name(next).is_some()) {
                    self.transposed.push(name.clone());
                }
                let last = solid.get(at + 2).filter(|last| above(last).is_some_and(is_dagger));
                if let (Some(middle), Some(last)) = (next.and_then(|next| self::name(next)), last)
                    && self::name(last).as_ref() == Some(&name)
                {
                    self.names.extend([name.clone(), middle]);
                }
                let is_first = at == 0 || relation(solid[at - 1]).is_some() || is_break(solid[at - 1]);
                let is_defined = is_first && next.is_some_and(|next| relation(next).is_some());
                let side = || solid[at + 2..].iter().take_while(|item| !is_break(item)).copied().collect::<Vec<_>>();
                if is_defined && has_projector(&side()) {
                    self.names.push(name);
                }
            }
            self.inside(item);
        }
    }

    fn inside(&mut self, item: &Item) {
        match &item.layout {
            Layout::Fence(Delimiter::Ket | Delimiter::Bra, _) => self.has_states = true,
            Layout::Fence(Delimiter::Angle, inside) => {
                let parts: Vec<&[Item]> = inside.split(|item| item.layout == Layout::Other('|')).collect();
                if let [_, operator, _] = parts.as_slice() {
                    self.has_states = true;
                    self.names.extend(operator.iter().filter_map(name).filter(is_capital));
                }
            }
            Layout::Fence(Delimiter::Square, inside) => {
                let parts: Vec<&[Item]> = inside.split(|item| item.layout == Layout::Other(',')).collect();
                if let [left, right] = parts.as_slice() {
                    let lone = |part: &[Item]| match part {
                        [only] => name(only).filter(is_capital),
                        _ => None,
                    };
                    let is_inner = |part: &[Item]| matches!(part, [Item { layout: Layout::Fence(..), .. }]);
                    let found: Vec<Name> = [left, right].into_iter().filter_map(|part| lone(part)).collect();
                    if found.len() == 2 || found.len() == 1 && (is_inner(left) || is_inner(right)) {
                        self.names.extend(found);
                    }
                }
                self.list(inside);
            }
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items),
            Layout::Fraction(a, b) => {
                self.list(contents(a));
                self.list(contents(b));
            }
            Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => self.list(contents(a)),
            Layout::Scripts { nucleus, sup, .. } => {
                if names::printed(nucleus, None).is_none() {
                    self.inside(nucleus);
                }
                if let Some(sup) = sup {
                    self.list(contents(sup));
                }
            }
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell)),
            _ => {}
        }
    }
}

/// A letter without its power, where it has no markup.
fn name(item: &Item) -> Option<Name> {
    let found = names::printed(item, None).filter(|found| found.dots == 0)?;
    let is_plain = !["\\vec{", "\\mathbf{", "\\hat{"].iter().any(|mark| found.name.base.contains(mark));
    is_plain.then_some(found.name)
}

fn above(item: &Item) -> Option<&Item> {
    match &item.layout {
        Layout::Scripts { sup: Some(sup), .. } => Some(sup),
        _ => None,
    }
}

fn is_capital(name: &Name) -> bool {
    matches!(name.base.as_bytes(), [b'A'..=b'Z'])
}

fn is_dagger(sup: &Item) -> bool {
    matches!(contents(sup), [Item { layout: Layout::Command(name), .. }] if name == "\\dagger")
}

fn is_state(item: &Item, of: Delimiter) -> bool {
    matches!(&item.layout, Layout::Fence(delimiter, _) if *delimiter == of)
}

/// Whether a ket stands before a bra.
fn has_projector(side: &[&Item]) -> bool {
    side.windows(2).any(|pair| is_state(pair[0], Delimiter::Ket) && is_state(pair[1], Delimiter::Bra))
}

fn is_break(item: &Item) -> bool {
    matches!(item.layout, Layout::Other(',' | ';') | Layout::Row | Layout::Align | Layout::Text(_))
        || relation(item).is_some()
}
