//! Whether a row continues the row before, and where that is not clear.

use crate::source::Fault;

use super::super::layout::Layout;
use super::super::rows::{Row, is_operator, is_sign, is_significant, relation};
use super::piece::Piece;

/// Whether a row continues the formula of the row before: that row ends with an operator, or this row starts with a
/// sign and has no relation, or with a + , or with a sign after the mark where the relations stand.
pub(super) fn continues(row: &Row<'_>, before: Option<&Piece<'_>>) -> bool {
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
    let adds = adds && !(row.is_of_a_system && has_relation);
    before.constant.is_none() && (open || adds)
}

/// The fault of a row that may continue the row before in more than one way, or be an equation of its own.
pub(super) fn unclear_continuation(
    row: &Row<'_>,
    before: &Piece<'_>,
    pieces: &[Piece<'_>],
    is_abstract: bool,
) -> Option<Fault> {
    let first = row.items.iter().find(is_significant).copied()?;
    let has_relation = row.items.iter().any(|item| relation(item).is_some());
    let starts_with_relation = relation(first).is_some();
    let is_own = row.is_of_a_system || is_zero(before) || before.row > 1 && starts_with_minus(before);
    if first.layout == Layout::Other('-') && has_relation && !row.is_indented && !row.is_aligned && !is_own {
        return Some(
            Fault::ambiguous(
                first.span,
                "a row that starts with − may continue the row before, or be an equation of its own",
            )
            .help("put & before the = of each row, or write each equation in a display of its own"),
        );
    }
    let of_row = || pieces.iter().filter(|piece| piece.row == before.row);
    let several = of_row().count() > 1;
    // A remark behind a wide space, as in `W = \int p\,dx \quad p = mv`, is not what the next row goes on with.
    let is_inserted = before.is_inserted && of_row().next().is_some_and(|first| first.links.len() > 1);
    if several && (!is_abstract || is_inserted) && (starts_with_relation || continues(row, Some(before))) {
        return Some(
            Fault::ambiguous(
                first.span,
                "the row before has several statements, and this row may continue any of them",
            )
            .help("write each of these statements on a row of its own"),
        );
    }
    (row.follows_stop && !starts_with_relation && is_sign(first) && continues(row, Some(before))).then(|| {
        Fault::ambiguous(first.span, "this row starts with a sign, but the row before ends with a comma or a point")
            .help("remove the comma or point, or write this row as an equation")
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
