//! Other letters by the form of a line: an equation of the hand-in that is one of the problem but for its letters says what
//! those letters stand for, however many there are.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, SymbolId, Symbols};
use crate::latex::{Macros, read_display};
use crate::source::Span;

use crate::check::document::setup::define_macros;
use crate::check::mark::names::{Letters, Names, StandsFor};
use crate::check::mark::problem::Problem;
use crate::check::mark::written::Written;

/// The most tables that are returned.
const MOST: usize = 6;

/// Tables of letters, the one that explains most letters first. `is_own` tells the names that only the hand-in has, and
/// `is_free` the names of the problem that the hand-in does not use.
pub(super) fn tables(
    problem: &Problem,
    (lines, macros): (&[Written], &Macros),
    is_own: impl Fn(&Name) -> bool,
    is_free: impl Fn(&Name) -> bool,
) -> Vec<Letters> {
    let known: &Names = &problem.names;
    let mut symbols = known.symbols.clone();
    let displays = problem.notes.equations.iter().map(|display| display.text.as_str());
    let mut own_macros = Macros::default();
    define_macros(&problem.notes.macros, &mut own_macros);
    let of_problem = equalities(displays, &mut symbols, &own_macros);
    let mut own = Symbols::open();
    let written = equalities(lines.iter().map(|line| line.text.as_str()), &mut own, macros);
    let mut found: Vec<Letters> = Vec::new();
    for line in &written {
        for display in &of_problem {
            let mut pairs = Vec::new();
            if !is_alike(&line.0, &display.0, &mut pairs) || !is_alike(&line.1, &display.1, &mut pairs) {
                continue;
            }
            let named = pairs.iter().map(|(a, b)| (&own.entry(*a).name, &symbols.entry(*b).name));
            let other: Vec<(&Name, &Name)> = named.filter(|(a, b)| a != b).collect();
            let is_sound =
                other.iter().all(|(a, b)| is_own(a) && is_free(b) && known.names.iter().any(|(n, ..)| n == *b));
            if is_sound && !other.is_empty() {
                let stands_for = |name: &Name| StandsFor { name: name.clone(), dots: 0 };
                found.push(other.into_iter().map(|(a, b)| (a.clone(), stands_for(b))).collect());
            }
        }
    }
    found.sort_by_key(|table| std::cmp::Reverse(table.len()));
    let mut merged: Vec<Letters> = Vec::new();
    for first in &found {
        let mut table = first.clone();
        for more in found.iter().filter(|more| fit(&table, more)).cloned().collect::<Vec<_>>() {
            if fit(&table, &more) {
                table.extend(more);
            }
        }
        if !merged.contains(&table) && merged.len() < MOST {
            merged.push(table);
        }
    }
    merged.sort_by_key(|table| std::cmp::Reverse(table.len()));
    merged
}

/// Whether no letter has two meanings in both tables together, and no meaning two letters.
fn fit(a: &Letters, b: &Letters) -> bool {
    b.iter().all(|(own, other)| a.iter().all(|(known, meaning)| (known == own) == (meaning == other)))
}

/// The equalities in texts: the first member with each other one.
fn equalities<'t>(texts: impl Iterator<Item = &'t str>, symbols: &mut Symbols, macros: &Macros) -> Vec<(Expr, Expr)> {
    let mut found = Vec::new();
    for text in texts {
        for statement in read_display(text, symbols, macros).statements.into_iter().flatten() {
            let Some((first, rest)) = statement.members.split_first() else { continue };
            found.extend(rest.iter().map(|other| (first.clone(), other.clone())));
        }
    }
    found
}

/// Whether two formulas are the same but for their letters and the order of terms and factors. Letters correspond one to
/// one, as in `pairs`, to which new ones are added.
fn is_alike(a: &Expr, b: &Expr, pairs: &mut Vec<(SymbolId, SymbolId)>) -> bool {
    let start = pairs.len();
    let is_it = match (&a.node, &b.node) {
        (Node::Symbol { id: a, indices: none, dots }, Node::Symbol { id: b, indices: empty, dots: other }) => {
            let known = pairs.iter().find(|(own, meaning)| own == a || meaning == b).copied();
            if known.is_none() {
                pairs.push((*a, *b));
            }
            none.is_empty() && empty.is_empty() && dots == other && known.is_none_or(|pair| pair == (*a, *b))
        }
        (Node::Product(a), Node::Product(b)) => {
            let (a, b): (Vec<_>, Vec<_>) = (a.iter().collect(), b.iter().collect());
            in_some_order(&a, &b, pairs, &|a, b, pairs| is_alike(a, b, pairs))
        }
        (Node::Sum(a), Node::Sum(b)) => {
            let (a, b): (Vec<_>, Vec<_>) = (a.iter().collect(), b.iter().collect());
            in_some_order(&a, &b, pairs, &|a, b, pairs| a.sign == b.sign && is_alike(&a.expr, &b.expr, pairs))
        }
        _ => {
            let (parts, others) = (a.children(), b.children());
            parts.len() == others.len()
                && head(a) == head(b)
                && parts.iter().zip(&others).all(|(a, b)| is_alike(a, b, pairs))
        }
    };
    if !is_it {
        pairs.truncate(start);
    }
    is_it
}

/// Whether the members of two lists correspond in some order.
fn in_some_order<T: Copy>(
    a: &[T],
    b: &[T],
    pairs: &mut Vec<(SymbolId, SymbolId)>,
    is_same: &impl Fn(T, T, &mut Vec<(SymbolId, SymbolId)>) -> bool,
) -> bool {
    let Some((first, rest)) = a.split_first() else { return b.is_empty() };
    if a.len() != b.len() || a.len() > LONGEST {
        return false;
    }
    let start = pairs.len();
    (0..b.len()).any(|at| {
        let others: Vec<T> = b.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, item)| *item).collect();
        let found = is_same(*first, b[at], pairs) && in_some_order(rest, &others, pairs, is_same);
        if !found {
            pairs.truncate(start);
        }
        found
    })
}

/// The most terms or factors whose orders are tried.
const LONGEST: usize = 6;

/// A formula with nothing inside it.
fn head(formula: &Expr) -> Node {
    let mut head = formula.clone();
    head.children_mut().into_iter().for_each(|child| *child = Expr::integer(0, Span::default()));
    head.node
}
