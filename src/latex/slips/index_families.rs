//! Candidates for insertion with index letters: the members of families with the letters of a text.

use std::collections::BTreeSet;

use crate::formula::{Index, IndexId, Kind, SymbolId};

use super::super::layout::{Item, Layout};
use super::super::names::{self, unaccented};
use super::atoms::spelled;
use super::finder::Finder;
use super::parts::insides;

/// The most members that are inserted.
const MOST: usize = 60;

/// A candidate for insertion.
struct Member {
    latex: String,
    letters: Vec<IndexId>,
}

impl Finder<'_> {
    /// Each family with each choice of the letters of these items; the components of vectors, δ, ε, and matrices
    /// without indices. Members with exactly the letters that occur once come first, since the lost factor was summed
    /// with them.
    pub(super) fn members(&self, items: &[Item]) -> Vec<String> {
        let mut letters = Vec::new();
        self.letters(items, &mut letters);
        let all: Vec<IndexId> = letters.iter().copied().collect::<BTreeSet<usize>>().into_iter().map(IndexId).collect();
        let alone: Vec<Vec<IndexId>> = self.pieces(items).map(|piece| self.alone(piece)).collect();
        let is_wanted = |choice: &[IndexId]| {
            let is_all_of =
                |alone: &Vec<IndexId>| choice.len() == alone.len() && choice.iter().all(|x| alone.contains(x));
            !choice.is_empty() && alone.iter().any(is_all_of)
        };
        let axes: Vec<IndexId> = all.iter().copied().filter(|letter| self.is_axis(*letter)).collect();
        let mut members: Vec<Member> = Vec::new();
        for (id, entry) in self.symbols.iter().filter(|(_, entry)| !entry.squared && entry.measure.is_none()) {
            let like = |own: IndexId| all.iter().copied().filter(move |other| self.symbols.same_range(own, *other));
            let slots: Vec<Vec<IndexId>> = entry.slots.iter().map(|(_, own)| like(*own).collect()).collect();
            let mut choices = choices(&slots);
            choices.retain(|choice| are_distinct(choice));
            for letters in choices.iter().filter(|choice| !choice.is_empty() || matches!(entry.kind, Kind::Matrix(..)))
            {
                let wanted = is_wanted(letters);
                // A whole vector beside a printed one makes a scalar product, which often holds by accident.
                if entry.kind == Kind::Vector && !wanted {
                    continue;
                }
                let most = u8::from(wanted && entry.varies);
                let spelled = (0..=most).filter_map(|dots| self.member(id, letters, dots));
                members.extend(spelled.map(|latex| Member { latex, letters: letters.clone() }));
            }
            if entry.kind == Kind::Vector {
                let mut name = unaccented(&entry.name);
                for (choice, axis) in choices.iter().flat_map(|choice| axes.iter().map(move |axis| (choice, axis))) {
                    let letters: Vec<IndexId> = choice.iter().copied().chain([*axis]).collect();
                    name.subscript = letters.iter().map(|letter| self.letter(*letter)).collect();
                    members.push(Member { latex: name.to_string(), letters });
                }
            }
        }
        for (tensor, count) in [("\\delta", 2), ("\\epsilon", 3)] {
            for letters in choices(&vec![axes.clone(); count]).into_iter().filter(|choice| are_distinct(choice)) {
                let subscript: String = letters.iter().map(|letter| self.letter(*letter)).collect();
                members.push(Member { latex: format!("{tensor}_{{{subscript}}}"), letters });
            }
        }
        members.sort_by_key(|member| !is_wanted(&member.letters));
        members.truncate(MOST);
        members.into_iter().map(|member| member.latex).collect()
    }

    /// The statements of a list.
    fn pieces<'i>(&self, items: &'i [Item]) -> impl Iterator<Item = &'i [Item]> {
        let between = [",", ";", "\\quad", "\\qquad", "\\Rightarrow", "\\implies", "\\\\"];
        items.split(move |item| between.contains(&self.slice(item.span).trim()))
    }

    /// The index letters that occur in a statement an odd number of times. A summed or free letter occurs twice.
    fn alone(&self, items: &[Item]) -> Vec<IndexId> {
        let mut letters = Vec::new();
        self.letters(items, &mut letters);
        let is_odd = |letter: &usize| letters.iter().filter(|other| *other == letter).count() % 2 == 1;
        let alone: BTreeSet<usize> = letters.iter().copied().filter(is_odd).collect();
        alone.into_iter().map(IndexId).collect()
    }

    fn member(&self, id: SymbolId, choice: &[IndexId], dots: u8) -> Option<String> {
        let indices: Vec<Index> = choice.iter().map(|letter| Index::Letter(*letter)).collect();
        spelled(self.symbols.entry(id), &indices, dots, self.symbols)
    }

    fn letter(&self, letter: IndexId) -> String {
        self.symbols.indices[letter.0].letter.clone()
    }

    fn is_axis(&self, letter: IndexId) -> bool {
        let index = &self.symbols.indices[letter.0];
        !index.labels && index.count.is_none() && index.upper == 3
    }

    /// The index letters in the subscripts of items, once for each occurrence.
    fn letters(&self, items: &[Item], letters: &mut Vec<usize>) {
        for item in items {
            let name = names::printed(item, None).map(|printed| printed.name.subscript).unwrap_or_default();
            let of_name: Vec<IndexId> = name.iter().filter_map(|token| self.symbols.index(token)).collect();
            letters.extend(of_name.iter().map(|letter| letter.0));
            if let (Layout::Scripts { sub: Some(sub), .. }, true) = (&item.layout, of_name.is_empty()) {
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

/// Every choice of one element from each list.
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
