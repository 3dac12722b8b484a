//! The members of families with the index letters that a text has: what was lost may stand nowhere else with these.

use std::collections::BTreeSet;

use crate::formula::{Index, IndexId, Kind, SymbolId};

use super::super::layout::{Item, Layout};
use super::super::names;
use super::super::reader::unaccented;
use super::Finder;
use super::atoms::spelled;
use super::insertions::insides;

/// So many members are put in.
const MOST: usize = 60;

impl Finder<'_> {
    /// Each family with each choice of the letters of these items, the components of vectors, and δ and ε.
    pub(super) fn members(&self, items: &[Item]) -> Vec<String> {
        let mut letters = BTreeSet::new();
        self.letters(items, &mut letters);
        let all: Vec<IndexId> = letters.into_iter().map(IndexId).collect();
        let axes: Vec<IndexId> = all.iter().copied().filter(|letter| self.is_axis(*letter)).collect();
        let mut members = Vec::new();
        for (id, entry) in self.symbols.iter().filter(|(_, entry)| !entry.squared && entry.measure.is_none()) {
            let like = |own: IndexId| all.iter().copied().filter(move |other| self.symbols.same_range(own, *other));
            let slots: Vec<Vec<IndexId>> = entry.slots.iter().map(|(_, own)| like(*own).collect()).collect();
            let mut choices = choices(&slots);
            choices.retain(|choice| are_distinct(choice));
            // A whole vector beside one that is printed is a number that may well be right.
            if !slots.is_empty() && entry.kind != Kind::Vector {
                members.extend(choices.iter().filter_map(|choice| self.member(id, choice)));
            }
            if entry.kind == Kind::Vector {
                let mut name = unaccented(&entry.name);
                for (choice, axis) in choices.iter().flat_map(|choice| axes.iter().map(move |axis| (choice, axis))) {
                    name.subscript = choice.iter().chain([axis]).map(|letter| self.letter(*letter)).collect();
                    members.push(name.to_string());
                }
            }
        }
        for (tensor, count) in [("\\delta", 2), ("\\epsilon", 3)] {
            for choice in choices(&vec![axes.clone(); count]).into_iter().filter(|choice| are_distinct(choice)) {
                let letters: String = choice.iter().map(|letter| self.letter(*letter)).collect();
                members.push(format!("{tensor}_{{{letters}}}"));
            }
        }
        members.truncate(MOST);
        members
    }

    fn member(&self, id: SymbolId, choice: &[IndexId]) -> Option<String> {
        let indices: Vec<Index> = choice.iter().map(|letter| Index::Letter(*letter)).collect();
        spelled(self.symbols.entry(id), &indices, 0, self.symbols)
    }

    fn letter(&self, letter: IndexId) -> String {
        self.symbols.indices[letter.0].letter.clone()
    }

    fn is_axis(&self, letter: IndexId) -> bool {
        let index = &self.symbols.indices[letter.0];
        !index.labels && index.count.is_none() && index.upper == 3
    }

    /// The index letters in the subscripts of some items.
    fn letters(&self, items: &[Item], letters: &mut BTreeSet<usize>) {
        for item in items {
            let tokens = names::printed(item, None).map(|printed| printed.name.subscript).unwrap_or_default();
            letters.extend(tokens.iter().filter_map(|token| self.symbols.index(token)).map(|letter| letter.0));
            if let Layout::Scripts { sub: Some(sub), .. } = &item.layout {
                let inside = match &sub.layout {
                    Layout::Group(inner) => inner.as_slice(),
                    _ => std::slice::from_ref(&**sub),
                };
                let tokens = inside.iter().filter_map(|item| self.symbols.index(self.slice(item.span)));
                letters.extend(tokens.map(|letter| letter.0));
            }
            insides(item).into_iter().for_each(|inner| self.letters(inner, letters));
        }
    }
}

/// One of each list, in every way.
fn choices(lists: &[Vec<IndexId>]) -> Vec<Vec<IndexId>> {
    lists.iter().fold(vec![Vec::new()], |made, list| {
        let longer = |choice: &Vec<IndexId>| {
            let choice = choice.clone();
            list.iter().map(move |letter| choice.iter().copied().chain([*letter]).collect()).collect::<Vec<_>>()
        };
        made.iter().flat_map(longer).collect()
    })
}

fn are_distinct(choice: &[IndexId]) -> bool {
    let letters: BTreeSet<usize> = choice.iter().map(|letter| letter.0).collect();
    letters.len() == choice.len()
}
