//! Ranges of an index beside other statements, which state nothing.

use super::super::layout::{Item, Layout};
use super::piece::Piece;

/// Leaves out the range of an index beside other statements, `k = 1, \dots, n` or `n = 1, 2, 3`, which states nothing.
pub(in super::super) fn without_ranges(pieces: &mut Vec<Piece<'_>>) {
    let mut first = 1;
    while first < pieces.len() {
        match range_length(&pieces[first..]) {
            Some(length) => drop(pieces.drain(first..first + length)),
            None => first += 1,
        }
    }
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
