//! The region in which a function has the formula before it: `f(x) = 0, \quad x < a`.
//!
//! An inequality of the argument beside the formula of a function is no statement: it says where the formula holds.

use crate::formula::tree::Relation;

use super::super::layout::{Delimiter, Item, Layout, latex};
use super::super::names;
use super::super::rows::is_significant;
use super::piece::Piece;

/// Makes conditions of such regions.
pub(super) fn attach(pieces: &mut Vec<Piece<'_>>) {
    for at in (1..pieces.len()).rev() {
        let (before, after) = pieces.split_at(at);
        let (Some(formula), Some(region)) = (before.last(), after.first()) else { continue };
        if formula.row == region.row && is_region(formula, region) {
            let region = pieces.remove(at);
            let items = region.links.into_iter().flat_map(|link| link.sign.into_iter().chain(link.items)).collect();
            pieces[at - 1].conditions.push(items);
        }
    }
}

/// Whether a part compares the argument of the function to which the part before gives a formula.
fn is_region(formula: &Piece<'_>, region: &Piece<'_>) -> bool {
    let is_order = |relation: Relation| {
        matches!(relation, Relation::Less | Relation::Greater | Relation::LessEqual | Relation::GreaterEqual)
    };
    let equates = matches!(formula.links.get(1).and_then(|link| link.relation), Some((Relation::Equal, _)));
    let compares = region.links.len() > 1
        && region.links[1..].iter().all(|link| link.relation.is_some_and(|(relation, _)| is_order(relation)));
    let is_plain = [formula, region].iter().all(|piece| piece.conditions.is_empty() && piece.fault.is_none());
    let Some(argument) = formula.links.first().and_then(|link| argument(&link.items)) else { return false };
    let is_it = |items: &Vec<&Item>| matches!(solid(items).as_slice(), [only] if printed(only) == argument);
    equates && compares && is_plain && region.links.iter().any(|link| is_it(&link.items))
}

/// The letter of which a side is a function: x of `f(x)`, also where nothing but its name is known.
fn argument(side: &[&Item]) -> Option<String> {
    match solid(side).as_slice() {
        [name, Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] => {
            let [only] = inside.as_slice() else { return None };
            let is_name = |item: &Item| names::printed(item, None).is_some();
            (is_name(name) && is_name(only)).then(|| printed(only))
        }
        [Item { layout: Layout::Value(name), .. }] => {
            let (_, argument) = name.strip_suffix(')')?.rsplit_once('(')?;
            Some(argument.trim().to_owned())
        }
        _ => None,
    }
}

fn printed(item: &Item) -> String {
    latex(std::slice::from_ref(item)).trim().to_owned()
}

fn solid<'a>(side: &[&'a Item]) -> Vec<&'a Item> {
    side.iter().copied().filter(|item| is_significant(&item)).collect()
}
