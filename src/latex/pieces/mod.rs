//! The parts of a display that are statements, before they are read: chains of members with relations between them.
//!
//! Commas, `\quad`, arrows, words such as `\text{and}`, rows and columns separate statements. A row that starts with a
//! relation or a sign continues the row before. Where it is not clear what a row continues, or what a comma or a point
//! means, the part has a fault.

mod alternatives;
mod asides;
mod conditions;
mod piece;
mod ranges;
mod remarks;
mod separators;
mod value_lists;

use crate::formula::tree::Relation;
use crate::source::Fault;

use super::layout::{Delimiter, Item, Layout};
use super::lexer::Space;
use super::rows::{Row, is_operator, is_sign, is_significant, relation, rows};
use alternatives::{alternatives, are_open};
use conditions::{begins_condition, ends_condition, is_comparison, is_pause};
use remarks::{is_aside, is_remark};
use separators::{ends_a_word, joins, separates, spelled_constant};

pub(super) use piece::{Link, Piece, Printed};
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
    match is_abstract {
        true => join_lists(&mut pieces),
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

/// Divides a row into statements and appends them.
fn split<'a>(row: Row<'a>, number: usize, pieces: &mut Vec<Piece<'a>>, is_abstract: bool) {
    let mut current: Option<Piece<'a>> = None;
    let mut comma: Option<&'a Item> = None;
    let mut starts_row = true;
    let unclear = pieces.last().and_then(|before| unclear_continuation(&row, before, pieces, is_abstract));
    if continues(&row, pieces.last()) {
        current = pieces.pop();
    }
    let items = asides::opened(row.items);
    let mut at = remarks::name_of_the_row(&items);
    let alternatives = alternatives(&items);
    while at < items.len() {
        let item = items[at];
        if let Some(place) = alternatives.iter().find(|place| place.start == at) {
            pieces.extend(current.take());
            let several = one_of_several(&items[place.clone()], number, is_abstract, pieces.last_mut());
            pieces.push(several);
            (comma, starts_row, at) = (None, false, place.end);
            continue;
        }
        let is_wide = matches!(item.layout, Layout::Space(Space::Wide));
        // Before a row it indents what goes on.
        if is_wide && starts_row {
            at += 1;
            continue;
        }
        let is_thin = |item: &Item| matches!(item.layout, Layout::Space(space) if space != Space::Wide);
        let before = items[..at].iter().rev().find(|item| !is_thin(item));
        let is_fenced = matches!(item.layout, Layout::Fence(..)) && at > 0 && is_thin(items[at - 1]);
        let begins = is_fenced || before.is_none_or(|item| separates(item));
        let is_beside = current.is_some() || !pieces.is_empty();
        if let Some(length) = (begins && is_beside).then(|| value_lists::length(&items[at..])).flatten() {
            pieces.extend(current.take());
            comma = None;
            at += length;
            continue;
        }
        let of_condition = current.as_mut().filter(|piece| !piece.conditions.is_empty() && !ends_condition(&items, at));
        if let Some(condition) = of_condition.and_then(|piece| piece.conditions.last_mut()) {
            condition.push(item);
            at += 1;
            continue;
        }
        let before = current.as_mut().filter(|piece| piece.links.len() > 1 || is_abstract && piece.has_sign());
        if let (Some(piece), true) = (before, begins_condition(item)) {
            piece.conditions.push(vec![item]);
            at += 1;
            continue;
        }
        // A wide space may stand before the condition: `x = 1 \quad \text{if } …`, `x = 1 \qquad (t > 0)`.
        let is_stop = is_wide || item.layout == Layout::Other(',');
        let pauses = || items[at..].iter().take_while(|next| is_pause(next));
        let has_wide = pauses().any(|next| next.layout == Layout::Space(Space::Wide));
        let next = items.get(at + pauses().count());
        let goes_on = next.is_some_and(|next| begins_condition(next) || has_wide && is_comparison(next))
            && value_lists::length(&items[(at + pauses().count()).min(items.len())..]).is_none();
        if let (true, true, Some(piece)) = (is_stop, goes_on, current.as_mut().filter(|piece| piece.links.len() > 1)) {
            while items.get(at).is_some_and(|item| is_pause(item)) {
                at += 1;
            }
            piece.conditions.push(vec![items[at]]);
            at += 1;
            continue;
        }
        if is_arrow(item)
            && let Some(piece) = current.as_mut().filter(|piece| piece.links.len() > 1)
            && states_something(&items[at + 1..])
        {
            let what = "an arrow between equations may mean that one follows, or that one becomes the other";
            let fault =
                Fault::ambiguous(item.span, what).help("write \\Rightarrow, or each equation in a display of its own");
            piece.fault.get_or_insert(fault);
        }
        if is_abstract && is_remark(&items, at) {
            // `\Gamma \text{ is unique}`
            if let Some(name) = current.as_mut().filter(|piece| piece.links.len() == 1 && !piece.has_sign())
                && !is_aside(&items, at)
            {
                name.fault.get_or_insert_with(|| {
                    Fault::unsupported(item.span, "these words qualify the formula before them, which is not supported")
                        .help("write an equation, or a comma before words that only explain")
                });
            }
            pieces.extend(current.take());
            // What stands in parentheses after all, or says where a result is from, is no statement.
            if !is_aside(&items, at) {
                let mut remark = Piece::new(number);
                remark.links.push(Link { relation: None, items: vec![item] });
                pieces.push(remark);
            }
            comma = None;
            starts_row = false;
            at += 1;
            continue;
        }
        // `= \mathrm{const}. = b`: the point ends a word.
        if ends_a_word(&items, at) {
            at += 1;
            continue;
        }
        if separates(item) && !joins(&items, at) {
            // A wide space inside a statement is only layout: `a \quad = b`, `= 0 \quad \Rightarrow`.
            let relation_follows = items[at + 1..]
                .iter()
                .find(|next| !matches!(next.layout, Layout::Space(_)))
                .is_some_and(|next| relation(next).is_some());
            if !(is_wide && relation_follows) {
                let ends = current.is_some();
                pieces.extend(current.take());
                comma = match item.layout {
                    Layout::Other(',') if ends => Some(item),
                    _ => None,
                };
            }
            at += 1;
            continue;
        }
        let is_term = current
            .as_ref()
            .and_then(|piece| piece.links.last()?.items.iter().rev().find(is_significant))
            .is_some_and(|item| is_operator(item));
        let spelled =
            spelled_constant(&items, at).filter(|_| current.as_ref().is_some_and(Piece::ends_with_a_relation));
        if let Some(span) = says_constant(item).or(spelled.map(|(span, _)| span)).filter(|_| !is_term) {
            if let Some(piece) = &mut current {
                piece.constant = Some(span);
                if piece.links.last().is_some_and(|link| link.items.is_empty()) {
                    piece.links.pop();
                }
            }
            at += spelled.map_or(1, |(_, length)| length);
            continue;
        }
        let found = match (&item.layout, items.get(at + 1).map(|next| &next.layout)) {
            (Layout::Other(':'), Some(Layout::Other('='))) => {
                at += 1;
                Some(Relation::Identical)
            }
            _ => relation(item),
        };
        at += 1;
        if let Some(found) = found {
            let link = Link { relation: Some((found, item.span)), items: Vec::new() };
            if current.is_none() && starts_row && !pieces.is_empty() {
                current = pieces.pop();
            }
            let piece = current.get_or_insert_with(|| Piece::new(number));
            if piece.links.is_empty() {
                piece.links.push(Link { relation: None, items: Vec::new() });
            }
            // `a = \\ = b` repeats the sign at the beginning of the row.
            let is_again = starts_row
                && piece.links.last().is_some_and(|last| {
                    last.relation.is_some_and(|(before, _)| before == found)
                        && !last.items.iter().any(|item| is_significant(&item))
                });
            if !is_again {
                piece.links.push(link);
            }
            starts_row = false;
            continue;
        }
        if matches!(item.layout, Layout::Space(_)) && current.is_none() {
            continue;
        }
        let piece = current.get_or_insert_with(|| Piece { comma: comma.take(), ..Piece::new(number) });
        if piece.links.is_empty() {
            piece.links.push(Link { relation: None, items: Vec::new() });
        }
        if let Some(link) = piece.links.last_mut() {
            link.items.push(item);
        }
        if is_number_of_the_row(&items, at - 1) || is_number_before_a_row(&items, at - 1) {
            piece.fault = Some(
                Fault::ambiguous(item.span, "this may be the number of the equation or a factor")
                    .help("write \\tag{…} for the number, or \\cdot before a factor"),
            );
        }
        starts_row = false;
    }
    pieces.extend(current);
    if let (Some(fault), Some(last)) = (unclear, pieces.last_mut()) {
        last.fault = Some(fault);
    }
}

/// Alternatives as one part. Where the first of them is in the row before, that row is none of its own either.
fn one_of_several<'a>(items: &[&'a Item], row: usize, is_abstract: bool, before: Option<&mut Piece<'a>>) -> Piece<'a> {
    let mut piece = Piece { has_alternatives: true, ..Piece::new(row) };
    piece.links.push(Link { relation: None, items: items.to_vec() });
    let is_open = are_open(items);
    if is_open || !is_abstract {
        let what = "one of these alternatives holds, and the others may not; alternatives are not supported";
        let fault = |span| Fault::unsupported(span, what).help("write only the case that is meant");
        if let Some(before) = before.filter(|_| is_open) {
            before.fault = Some(fault(before.span()));
        }
        piece.fault = Some(fault(piece.span()));
    }
    piece
}

/// Whether a row continues the formula of the row before: that row ends with an operator, or this row starts with a
/// sign and has no relation, or with a + , or with a sign after the mark where the relations stand.
fn continues(row: &Row<'_>, before: Option<&Piece<'_>>) -> bool {
    let Some(before) = before else { return false };
    let last = before.links.last();
    let open = last.is_some_and(|link| match link.items.iter().rev().find(is_significant) {
        Some(item) => is_operator(item),
        None => link.relation.is_some(),
    });
    let first = row.items.iter().find(is_significant).copied();
    let has_relation = row.items.iter().any(|item| relation(item).is_some());
    let adds = first.is_some_and(|item| {
        item.layout != Layout::Other('-') && is_operator(item) || is_sign(item) && (!has_relation || row.is_indented)
    });
    before.constant.is_none() && (open || adds)
}

/// The fault of a row that may continue the row before in more than one way, or be an equation of its own.
fn unclear_continuation(row: &Row<'_>, before: &Piece<'_>, pieces: &[Piece<'_>], is_abstract: bool) -> Option<Fault> {
    let first = row.items.iter().find(is_significant).copied()?;
    let has_relation = row.items.iter().any(|item| relation(item).is_some());
    let starts_with_relation = relation(first).is_some();
    let is_own = is_zero(before) || before.row > 1 && starts_with_minus(before);
    if first.layout == Layout::Other('-') && has_relation && !row.is_indented && !row.is_aligned && !is_own {
        return Some(
            Fault::ambiguous(first.span, "this row may continue the row before or be an equation of its own")
                .help("put & before the relation of each row, or write each equation in a display of its own"),
        );
    }
    let several = pieces.iter().filter(|piece| piece.row == before.row).count() > 1;
    if several && !is_abstract && (starts_with_relation || continues(row, Some(before))) {
        return Some(
            Fault::ambiguous(first.span, "this row may continue any statement of the row before")
                .help("write the statements of that row on rows of their own"),
        );
    }
    (row.follows_stop && !starts_with_relation && is_sign(first) && continues(row, Some(before))).then(|| {
        Fault::ambiguous(first.span, "this row starts with a sign, but the row before ends with a comma or a point")
            .help("remove the comma, or write the row as an equation")
    })
}

/// Whether a statement says that something is 0: nothing goes on after it.
fn is_zero(piece: &Piece<'_>) -> bool {
    let last = piece.links.last().filter(|_| piece.links.len() > 1);
    last.is_some_and(|link| {
        let mut solid = link.items.iter().filter(is_significant);
        let zero = Layout::Number("0".to_owned());
        solid.next().is_some_and(|only| only.layout == zero) && solid.next().is_none()
    })
}

/// Whether a statement begins with a minus.
fn starts_with_minus(piece: &Piece<'_>) -> bool {
    let first = piece.links.first().and_then(|link| link.items.iter().find(is_significant));
    first.is_some_and(|first| first.layout == Layout::Other('-'))
}

/// Whether the item is a whole number in parentheses at the end of the row, after a space: `F = ma \quad (2)`.
fn is_number_of_the_row(items: &[&Item], at: usize) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &items[at].layout else { return false };
    let is_number = matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]);
    let after_space = at > 0 && matches!(items[at - 1].layout, Layout::Space(_));
    let is_last = items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('.' | ',')));
    is_number && after_space && is_last
}

/// Joins what stands alone beside a comma with its neighbour: `i = 1, 2, 3` and `x, y > 0` have lists as members.
fn join_lists(pieces: &mut Vec<Piece<'_>>) {
    let is_whole = |piece: &Piece<'_>| piece.links.len() > 1 || piece.constant.is_some();
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
        let [Link { relation: None, items }] = piece.links.as_slice() else { return false };
        let mut significant = items.iter().filter(is_significant);
        let is_text = matches!(significant.next().map(|item| &item.layout), Some(Layout::Text(_)));
        is_text && significant.next_back().is_some_and(|item| item.layout == Layout::Other(':'))
    };
    let rows: Vec<usize> = pieces.iter().filter(|piece| !is_caption(piece)).map(|piece| piece.row).collect();
    pieces.retain(|piece| !is_caption(piece) || !rows.contains(&piece.row));
}

/// Marks statements without a relation beside statements with one: the values of `i = 1, 2, 3`, the x of `x, y > 0`.
fn reject_lone_values(pieces: &mut [Piece<'_>]) {
    let is_whole = |piece: &Piece<'_>| piece.links.len() > 1 || piece.constant.is_some();
    if !pieces.iter().any(is_whole) {
        return;
    }
    for piece in pieces.iter_mut().filter(|piece| !is_whole(piece) && piece.fault.is_none()) {
        let what = "this part has no relation of its own: it may be one of several values, or share a relation";
        piece.fault = Some(
            Fault::ambiguous(piece.span(), what).help("write an equation for each value, and a relation for each name"),
        );
    }
}

/// Whether the item is a whole number in parentheses before a system: `(1) \begin{cases} …`.
fn is_number_before_a_row(items: &[&Item], at: usize) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &items[at].layout else { return false };
    let is_number = matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]);
    let next = items[at + 1..].iter().find(|next| !matches!(next.layout, Layout::Space(_)));
    let is_system = |next: &&&Item| matches!(&next.layout, Layout::Environment(name, _) if name.contains("cases"));
    is_number && at == 0 && next.is_some_and(|next| is_system(&next))
}

/// Whether an item is a simple arrow.
fn is_arrow(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == "\\rightarrow" || name == "\\longrightarrow")
}

/// Whether an equation stands before the next separator.
fn states_something(items: &[&Item]) -> bool {
    items.iter().take_while(|item| !separates(item)).any(|item| item.layout == Layout::Other('='))
}
