//! The condition before an arrow: `x > 0 \Rightarrow |x| = x` says nothing about x, but what holds where x > 0.
//!
//! So does `\text{if } x = 0 \text{ then } y = 0`. In a derivation what stands before the arrow holds too. It is a condition where it is a comparison
//! or says of what set something is and what follows is no comparison, or where "for all" stands after what follows. It is one too
//! where "for all" stands before it: `\forall x \in A,\; f(x) = 0`.

use crate::formula::tree::Relation;

use super::super::layout::{Item, Layout};
use super::super::rows::{is_significant, relation};
use super::separators::separates;

/// The items of a condition at the beginning of a row, and the items that it concerns; no items where there is none.
pub(super) fn divided<'a>(items: &[&'a Item]) -> (Vec<&'a Item>, Vec<&'a Item>) {
    let word = |item: &Item| match &item.layout {
        Layout::Text(word) => Some(word.trim_matches([',', ' ']).to_ascii_lowercase()),
        _ => None,
    };
    let is = |item: &Item, wanted: &str| word(item).is_some_and(|word| word == wanted);
    if let Some(first) = items.iter().position(|item| is_significant(&item)).filter(|first| is(items[*first], "if"))
        && let Some(then) = items.iter().position(|item| is(item, "then"))
    {
        return (items[first..then].to_vec(), items[then + 1..].to_vec());
    }
    if let Some(found) = for_all(items) {
        return found;
    }
    let is_arrow = |item: &&Item| matches!(&item.layout, Layout::Command(name) if name == "\\Rightarrow");
    let whole = || (Vec::new(), items.to_vec());
    let mut arrows = items.iter().enumerate().filter(|(_, item)| is_arrow(item));
    let (Some((at, _)), None) = (arrows.next(), arrows.next()) else { return whole() };
    let (before, after) = (&items[..at], &items[at + 1..]);
    let relations: Vec<Relation> = before.iter().filter_map(|item| relation(item)).collect();
    let compares = |relation: &Relation| {
        matches!(
            relation,
            Relation::Less | Relation::Greater | Relation::LessEqual | Relation::GreaterEqual | Relation::NotEqual
        )
    };
    // `x \in A \Rightarrow f(x) = 0`
    let is_sign = |item: &&&Item| {
        let signs = ["\\in", "\\notin", "\\subset"];
        matches!(&item.layout, Layout::Command(name) if signs.contains(&name.as_str()))
    };
    let restricts = match relations.as_slice() {
        [only] => compares(only),
        [] if before.iter().filter(is_sign).count() == 1 => true,
        _ => return whole(),
    };
    // Of one inequality another one is a consequence: N \le \mu F \Rightarrow \mu \ge N/F.
    let is_comparison = restricts && !after.iter().filter_map(|item| relation(item)).any(|other| compares(&other));
    let is_for_all = after.iter().any(|item| matches!(&item.layout, Layout::Command(name) if name == "\\forall"));
    let is_whole = !before.iter().any(|item| separates(item) && is_significant(&item));
    let starts_with_a_side = before.iter().find(is_significant).is_some_and(|first| relation(first).is_none());
    let states = after.iter().any(|item| relation(item).is_some());
    match is_whole && starts_with_a_side && states && (is_comparison || is_for_all) {
        true => (before.to_vec(), after.to_vec()),
        false => whole(),
    }
}

/// What stands between a ∀ at the beginning and the statement that holds for all of it. The parts before the statement are those
/// without a relation, `\forall x, y \in A,\; f(x, y) = 0`.
fn for_all<'a>(items: &[&'a Item]) -> Option<(Vec<&'a Item>, Vec<&'a Item>)> {
    let first = items.iter().position(|item| is_significant(&item))?;
    let is_quantifier = matches!(&items[first].layout, Layout::Command(name) if name == "\\forall");
    let ends = |item: &Item| separates(item) || item.layout == Layout::Other(':');
    let states = |from: usize| {
        let part = items[from..].iter().take_while(|item| !ends(item));
        part.filter_map(|item| relation(item)).next().is_some()
    };
    let end = (first + 1..items.len()).find(|at| ends(items[*at]) && states(at + 1)).filter(|_| is_quantifier)?;
    Some((items[first..end].to_vec(), items[end + 1..].to_vec()))
}
