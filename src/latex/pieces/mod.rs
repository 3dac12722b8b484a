//! The parts of a display that are statements, before they are read: chains of members with relations between them.
//!
//! Commas, `\quad`, arrows, words such as `\text{and}`, rows and columns separate statements. A row that starts with a
//! relation or a sign continues the row before. Where it is not clear what a row continues, or what a comma or a point
//! means, the part has a fault.
//!
//! Offers `pieces`, the statements of a display as items. Knows the layout, and no symbols.

mod alternatives;
mod asides;
mod conditions;
mod continuation;
mod numbers;
mod piece;
mod premises;
mod ranges;
mod regions;
mod remarks;
mod separators;
mod split;
mod unclear_members;
mod value_lists;

use crate::source::Fault;

use super::layout::{Item, Layout, typed};
use super::rows::{is_significant, rows};
use piece::Link;
use split::split;

pub(super) use piece::{Piece, Printed};
pub(super) use ranges::without_ranges;
pub use separators::says_constant;

/// The statements of a display.
///
/// In a display that is read for its structure, words are parts of their own, and what stands alone beside a comma is a part
/// of a list.
pub(super) fn pieces(items: &[Item], is_abstract: bool) -> Vec<Piece<'_>> {
    let mut pieces: Vec<Piece<'_>> = Vec::new();
    for (at, row) in rows(items, is_abstract).into_iter().enumerate() {
        split(row, at + 1, &mut pieces, is_abstract);
    }
    drop_captions(&mut pieces);
    regions::attach(&mut pieces);
    match is_abstract {
        true => {
            join_lists(&mut pieces);
            let faults: Vec<_> = (0..pieces.len()).map(|at| unclear_members::unclear_member(&pieces, at)).collect();
            for (piece, fault) in pieces.iter_mut().zip(faults) {
                piece.fault = piece.fault.take().or(fault);
            }
        }
        false => reject_lone_values(&mut pieces),
    }
    share_conditions(&mut pieces);
    pieces
}

/// Gives what stands before a comma the condition of what stands behind it: both hold in `u = 1, v = 0 \text{ at } y = 1`
/// under it, or nothing says that the first holds elsewhere.
fn share_conditions(pieces: &mut [Piece<'_>]) {
    for at in (1..pieces.len()).rev() {
        let (before, after) = pieces.split_at_mut(at);
        let (Some(before), Some(after)) = (before.last_mut(), after.first()) else { continue };
        if after.comma.is_some() && before.row == after.row && before.conditions.is_empty() && before.links.len() > 1 {
            before.conditions.clone_from(&after.conditions);
        }
    }
}

/// Joins what stands alone beside a comma with its neighbour: `i = 1, 2, 3` and `x, y > 0` have lists as members.
fn join_lists(pieces: &mut Vec<Piece<'_>>) {
    let is_whole = |piece: &Piece<'_>| piece.links.len() > 1 || piece.constant.is_some() || piece.has_sign();
    let mut joined: Vec<Piece<'_>> = Vec::with_capacity(pieces.len());
    for mut here in std::mem::take(pieces) {
        let fits = |before: &Piece<'_>| {
            let is_plain = before.conditions.is_empty() && before.fault.is_none() && before.constant.is_none();
            let is_part = !is_whole(&here) && here.conditions.is_empty() || !is_whole(before);
            here.comma.is_some() && before.row == here.row && here.fault.is_none() && is_plain && is_part
        };
        let Some(before) = joined.last_mut().filter(|before| fits(before)) else {
            joined.push(here);
            continue;
        };
        if let (Some(last), false) = (before.links.last_mut(), here.links.is_empty()) {
            last.items.extend(here.comma);
            last.items.append(&mut here.links.remove(0).items);
        }
        before.links.append(&mut here.links);
        before.conditions.append(&mut here.conditions);
        before.constant = here.constant;
    }
    *pieces = joined;
}

/// Leaves out words with a colon that announce a statement: `\text{equal masses } (M = m): \quad \Omega = …`.
fn drop_captions(pieces: &mut Vec<Piece<'_>>) {
    let is_caption = |piece: &Piece<'_>| {
        let [Link { relation: None, items, .. }] = piece.links.as_slice() else { return false };
        let mut significant = items.iter().filter(is_significant);
        let is_text = matches!(significant.next().map(|item| &item.layout), Some(Layout::Text(_)));
        is_text && significant.next_back().is_some_and(|item| item.layout == Layout::Other(':'))
    };
    let rows: Vec<usize> = pieces.iter().filter(|piece| !is_caption(piece)).map(|piece| piece.row).collect();
    pieces.retain(|piece| !is_caption(piece) || !rows.contains(&piece.row));
}

/// The advice on a value or a name that stands alone.
const AS_AN_EQUATION: &str = "write an equation for each value and for each name, as in x = 2";

/// Marks statements without a relation beside statements with one: the values of `i = 1, 2, 3`, the x of `x, y > 0`.
fn reject_lone_values(pieces: &mut [Piece<'_>]) {
    let is_whole = |piece: &Piece<'_>| piece.links.len() > 1 || piece.constant.is_some();
    if !pieces.iter().any(is_whole) {
        return;
    }
    for piece in pieces.iter_mut().filter(|piece| !is_whole(piece) && piece.fault.is_none()) {
        let items: Vec<Item> = piece.links.iter().flat_map(|link| &link.items).map(|item| (*item).clone()).collect();
        let (what, help) = match items.as_slice() {
            [] => ("a part of this display has no = or other relation".to_owned(), AS_AN_EQUATION),
            // A text has lost its spaces.
            [Item { layout: Layout::Text(_), .. }] => (
                "words stand alone in this display, without = or another relation".to_owned(),
                "write the words outside of the display",
            ),
            _ => (format!("“{}” stands alone, without = or another relation", typed(&items)), AS_AN_EQUATION),
        };
        piece.fault = Some(Fault::ambiguous(piece.span(), what).help(help));
    }
}
