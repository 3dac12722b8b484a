//! Letters whose products depend on their order: vectors beside ×, and matrices, where neither an arrow nor bold type marks
//! them.
//!
//! A product of numbers is the only thing that plain letters say. So a letter is a vector or a matrix here only by what the displays
//! and the words show, and what cannot be read so is not decided: read as numbers, r × F and F × r would be the same.
//!
//! Offers `letters`. Knows layout and notes.

mod matrices;
mod vectors;

use crate::formula::symbols::Name;
use crate::latex::layout::{Item, Layout, typeset_items};
use crate::latex::{Macros, names};
use crate::notes::Notes;

/// A letter whose products depend on their order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ordered {
    /// The letter.
    pub name: Name,
    /// How it is declared, as a `3x1 matrix`; `None`, if a display gives it.
    pub range: Option<String>,
    /// Whether it is a vector beside ×, and no matrix.
    pub is_vector: bool,
}

/// The letters of notes whose products depend on their order.
pub(crate) fn letters(notes: &Notes, macros: &Macros) -> Vec<Ordered> {
    let read = |text: &str| typeset_items(text, macros).unwrap_or_default();
    let displays: Vec<Vec<Item>> = notes.equations.iter().map(|display| read(&display.text)).collect();
    let mut found = vectors::letters(notes, &displays);
    for letter in matrices::letters(notes, &displays, macros) {
        if found.iter().all(|known| known.name != letter.name) {
            found.push(letter);
        }
    }
    found
}

/// The items of a list that are printed.
fn solid(items: &[Item]) -> Vec<&Item> {
    let is_printed = |item: &&Item| !matches!(item.layout, Layout::Space(_) | Layout::Align);
    items.iter().filter(is_printed).collect()
}

/// The lists of items inside an item.
fn inside(item: &Item) -> Vec<&[Item]> {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => vec![items],
        Layout::Fraction(a, b) => vec![std::slice::from_ref(&**a), std::slice::from_ref(&**b)],
        Layout::Root(_, a) => vec![std::slice::from_ref(&**a)],
        Layout::Scripts { nucleus, .. } => vec![std::slice::from_ref(&**nucleus)],
        Layout::Environment(_, rows) => rows.iter().flatten().map(Vec::as_slice).collect(),
        _ => Vec::new(),
    }
}

/// Calls a function with each list of items, the inner ones too.
fn each_list<'i>(items: &'i [Item], visit: &mut dyn FnMut(&[&'i Item])) {
    visit(&solid(items));
    for part in items.iter().flat_map(inside) {
        each_list(part, visit);
    }
}

/// The name that an item prints, if it is a plain letter, with an index or a dot perhaps.
fn plain(item: &Item) -> Option<Name> {
    let name = names::printed(item, None)?.name;
    let is_letter = !name.base.contains('{') && !["\\pi", "d", "e", "i"].contains(&name.base.as_str());
    is_letter.then_some(name)
}
