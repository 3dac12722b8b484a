//! Vectors in plain letters: `\tau = r \times F`.
//!
//! In a school's `F = m \times a` the cross stands between numbers. So it says that its factors are vectors only where `\cdot` or
//! another cross stands beside it, which nobody writes between numbers, or where the words speak of vectors.

use super::{Ordered, each_list, plain, solid};
use crate::formula::symbols::Name;
use crate::latex::layout::{Delimiter, Item, Layout};
use crate::notes::Notes;

/// Words of notes about products of vectors, in small letters.
const WORDS: [&str; 12] = [
    "vector",
    "cross product",
    "torque",
    "angular momentum",
    "angular velocity",
    "\\mathbb{r}^3",
    "triple product",
    "vektor",
    "kreuzprodukt",
    "drehmoment",
    "vecteur",
    "produit vectoriel",
];

/// The vectors in the displays of notes.
pub(super) fn letters(notes: &Notes, displays: &[Vec<Item>]) -> Vec<Ordered> {
    let crossed = displays.iter().filter(|items| has_cross(items));
    let crossed: Vec<&Vec<Item>> = crossed.collect();
    if crossed.is_empty() {
        return Vec::new();
    }
    let text = notes.source.text.to_lowercase();
    let is_said = WORDS.iter().any(|word| text.contains(word));
    let in_display = |items: &[Item]| {
        let mut names = Vec::new();
        each_list(items, &mut |list| factors(list, &mut names));
        names
    };
    let (mut sure, mut others): (Vec<&[Item]>, Vec<&[Item]>) =
        crossed.into_iter().map(Vec::as_slice).partition(|items| is_said || shows(items));
    let mut found: Vec<Name> = Vec::new();
    // What stands beside × and a vector is one too.
    while !sure.is_empty() {
        found.extend(sure.drain(..).flat_map(in_display));
        let known = std::mem::take(&mut others).into_iter();
        (sure, others) = known.partition(|items| in_display(items).iter().any(|name| found.contains(name)));
    }
    let mut distinct: Vec<Ordered> = Vec::new();
    for name in found {
        let range = Some("3x1 matrix".to_owned());
        let letter = Ordered { name, range, is_vector: true };
        if !distinct.contains(&letter) {
            distinct.push(letter);
        }
    }
    distinct
}

fn is_cross(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\times",
        Layout::Other(c) => *c == '×',
        _ => false,
    }
}

fn is_dot(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\cdot",
        Layout::Other(c) => matches!(c, '·' | '⋅'),
        _ => false,
    }
}

/// The parenthesis that an item is.
fn parenthesis(item: &Item) -> Option<&[Item]> {
    match &item.layout {
        Layout::Fence(Delimiter::Round | Delimiter::Square, inside) => Some(inside),
        _ => None,
    }
}

/// Whether an item may be a vector: a plain letter, or a parenthesis with letters.
fn may_be(item: &Item) -> bool {
    plain(item).is_some() || parenthesis(item).is_some_and(|inside| inside.iter().any(may_be))
}

/// Whether × stands between what may be vectors.
fn has_cross(items: &[Item]) -> bool {
    let mut found = false;
    each_list(items, &mut |list| found |= joined(list, is_cross));
    found
}

fn joined(list: &[&Item], is_joint: fn(&Item) -> bool) -> bool {
    list.windows(3).any(|part| is_joint(part[1]) && may_be(part[0]) && may_be(part[2]))
}

/// Whether a display shows that its crosses stand between vectors: a dot beside them, or a cross in a parenthesis beside one.
fn shows(items: &[Item]) -> bool {
    let mut found = false;
    each_list(items, &mut |list| {
        let is_nested = |item: &&Item| parenthesis(item).is_some_and(has_cross);
        found |= joined(list, is_dot)
            || list
                .windows(2)
                .any(|part| is_cross(part[0]) && is_nested(&part[1]) || is_cross(part[1]) && is_nested(&part[0]));
    });
    found
}

/// Notes the letters beside × and ·: those that are a factor, or a term of one.
fn factors(list: &[&Item], found: &mut Vec<Name>) {
    for part in list.windows(3).filter(|part| is_cross(part[1]) || is_dot(part[1])) {
        if may_be(part[0]) && may_be(part[2]) {
            for side in [part[0], part[2]] {
                found.extend(plain(side));
                if let Some(inside) = parenthesis(side) {
                    found.extend(terms(inside));
                }
            }
        }
    }
}

/// The letters of which a parenthesis holds the sum.
fn terms(inside: &[Item]) -> Vec<Name> {
    let solid = solid(inside);
    let is_sign = |item: &&Item| matches!(item.layout, Layout::Other('+' | '-'));
    let lone = |term: &[&Item]| match term {
        [only] => plain(only),
        _ => None,
    };
    solid.split(is_sign).filter_map(lone).collect()
}
