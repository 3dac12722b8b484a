//! Ranges of an index beside other statements, which state nothing.

use crate::formula::tree::Relation;

use super::super::layout::{Item, Layout};
use super::super::names;
use super::piece::Piece;

/// Leaves out the range of an index beside other statements, `k = 1, \dots, n` or `n = 1, 2, 3`, which states nothing. So it does with
/// a name that shares the range of the next one, `\alpha, n > 0`.
pub(in super::super) fn without_ranges(pieces: &mut Vec<Piece<'_>>) {
    let mut first = 1;
    while first < pieces.len() {
        match range_length(&pieces[first..]).or(names_before_a_range(&pieces[first..])) {
            Some(length) => drop(pieces.drain(first..first + length)),
            None => first += 1,
        }
    }
}

/// The number of names that begin here and share the range of the name after them.
fn names_before_a_range(pieces: &[Piece<'_>]) -> Option<usize> {
    let only = |items: &[&Item]| {
        let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        solid.next().copied().cloned().filter(|_| solid.next().is_none())
    };
    let is_name = |items: &[&Item]| {
        let printed =
            only(items).and_then(|item| names::printed(&item, None).map(|found| (found.dots, found.sup.is_some())));
        printed == Some((0, false))
    };
    let is_alone = |piece: &&Piece<'_>| matches!(piece.links.as_slice(), [link] if is_name(&link.items));
    let length = pieces.iter().take_while(is_alone).count();
    let [name, bound] = pieces.get(length)?.links.as_slice() else { return None };
    let bounds = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
    let is_range = is_name(&name.items)
        && only(&bound.items).is_some_and(|item| matches!(item.layout, Layout::Number(_)))
        && bound.relation.is_some_and(|(relation, _)| bounds.contains(&relation));
    (is_range && length > 0).then_some(length)
}

/// The number of pieces of the range that begins here: whole numbers in their order, or dots, which a last value may follow.
fn range_length(pieces: &[Piece<'_>]) -> Option<usize> {
    let only = |items: &[&Item]| match items {
        [Item { layout: Layout::Number(digits), .. }] => digits.parse::<u32>().ok(),
        _ => None,
    };
    let [name, value] = pieces.first()?.links.as_slice() else { return None };
    let is_index = matches!(name.items.as_slice(), [Item { layout: Layout::Letter(_), .. }]);
    let mut last = only(&value.items).filter(|_| is_index)?;
    let mut length = 1;
    let mut has_dots = false;
    for piece in &pieces[1..] {
        let [link] = piece.links.as_slice() else { break };
        let is_dots = matches!(link.items.as_slice(), [Item { layout: Layout::Command(name), .. }] if name == "\\dots");
        let next = only(&link.items);
        match (has_dots, next) {
            (false, _) if is_dots => has_dots = true,
            (false, Some(number)) if number == last + 1 => last = number,
            // `\dots, n`
            (true, _) => {
                length += 1;
                break;
            }
            _ => break,
        }
        length += 1;
    }
    (has_dots || length > 1).then_some(length)
}
