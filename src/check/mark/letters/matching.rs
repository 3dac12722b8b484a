//! Other letters by the form of a line: an equation of the hand-in that is one of the problem but for its letters says what
//! those letters stand for, however many there are.

use std::collections::HashMap;

use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, Node, Sign, SymbolId, Symbols};
use crate::latex::rename::renamed_with;
use crate::latex::{Macros, read_display};
use crate::source::Span;

use crate::check::document::setup::define_macros;
use crate::check::mark::judge::with_dots;
use crate::check::mark::names::{Letters, Names, Role, StandsFor};
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
    let none = HashMap::new();
    let texts: Vec<String> =
        lines.iter().map(|line| renamed_with(&line.text, macros, &none, &line.edits).text).collect();
    let mut written = equalities(texts.iter().map(String::as_str), &mut own, macros);
    let is_known = |name: &Name| known.symbols.find(name).is_some();
    let with_rates: Vec<(Expr, Expr)> =
        written.iter().filter_map(|line| with_primes_as_rates(line, &mut own, is_known)).collect();
    written.extend(with_rates);
    let other = |pairs: &Pairs| -> Letters {
        let named = pairs.iter().map(|(a, b)| (&own.entry(*a).name, &symbols.entry(*b).name));
        let stands_for = |name: &Name| StandsFor { name: name.clone(), dots: 0 };
        named.filter(|(a, b)| a != b).map(|(a, b)| (a.clone(), stands_for(b))).collect()
    };
    let is_number = |name: &Name| known.names.iter().any(|(known, ..)| known == name);
    // A letter of the problem may be one of its other quantities in the hand-in, if its own meaning goes to another letter or
    // to none: ω for Ω, and ν for ω.
    let is_sound = |table: &Letters| {
        let stands = |a: &Name| is_own(a) || is_number(a);
        let is_open = |b: &Name| is_free(b) || table.contains_key(b);
        // What moves stays what moves: `\xi = x - x_0` is no Lagrangian T − U.
        let moves = |name: &Name| known.names.iter().any(|(known, role, _)| known == name && *role == Role::Moving);
        let keeps = |a: &Name, b: &Name| !is_number(a) || moves(a) == moves(b);
        let fits = |a: &Name, b: &Name| {
            stands(a) && is_open(b) && is_number(b) && keeps(a, b) && may_stand_for(a, b) && !is_any_mode(known, a, b)
        };
        table.iter().all(|(a, b)| fits(a, &b.name)) && !is_exchange(table)
    };
    // The letters with which a line is an equation of the problem, beside those that are known.
    let more = |known: &Pairs, line: &(Expr, Expr), display: &(Expr, Expr)| -> Option<Pairs> {
        let mut pairs = known.clone();
        let mut is_it = is_alike(&line.0, &display.0, &mut pairs) && is_alike(&line.1, &display.1, &mut pairs);
        if !is_it {
            pairs.truncate(known.len());
            is_it = is_rearranged(line, display, &mut pairs);
        }
        (is_it && is_sound(&other(&pairs))).then_some(pairs)
    };
    let none = Pairs::new();
    let all = written.iter().flat_map(|line| of_problem.iter().map(move |display| (line, display)));
    let mut starts: Vec<Pairs> = all.filter_map(|(line, display)| more(&none, line, display)).collect();
    starts.sort_by_key(|pairs| std::cmp::Reverse(pairs.len()));
    let mut found: Vec<Letters> = Vec::new();
    for start in starts.into_iter().take(2 * MOST) {
        let mut pairs = start;
        for line in &written {
            if let Some(new) = of_problem.iter().find_map(|display| more(&pairs, line, display)) {
                pairs = new;
            }
        }
        let table = other(&pairs);
        if !table.is_empty() && !found.contains(&table) {
            found.push(table);
        }
    }
    found.sort_by_key(|table| std::cmp::Reverse(table.len()));
    found.truncate(MOST);
    found
}

/// Whether letters of the problem only change places among themselves, as m and k do in `e^{-mt/k}`: that is a mistake.
fn is_exchange(table: &Letters) -> bool {
    table.keys().any(|start| {
        let mut at = start;
        for _ in 0..table.len() {
            match table.get(at) {
                Some(next) => at = &next.name,
                None => return false,
            }
            if at == start {
                return true;
            }
        }
        false
    })
}

/// Letters of the hand-in with those of the problem to which they correspond.
type Pairs = Vec<(SymbolId, SymbolId)>;

/// The equalities in texts: the first member with each other one.
fn equalities<'t>(texts: impl Iterator<Item = &'t str>, symbols: &mut Symbols, macros: &Macros) -> Vec<(Expr, Expr)> {
    let mut found = Vec::new();
    for text in texts {
        for statement in with_dots(read_display(text, symbols, macros)).statements.into_iter().flatten() {
            let Some((first, rest)) = statement.members.split_first() else { continue };
            found.extend(rest.iter().map(|other| (first.clone(), other.clone())));
        }
    }
    found
}

/// An equality in which primes are rates, `x'' = \ddot x`; `None`, if no name has any. `is_known` tells the names of the problem.
fn with_primes_as_rates(
    (left, right): &(Expr, Expr),
    own: &mut Symbols,
    is_known: impl Fn(&Name) -> bool,
) -> Option<(Expr, Expr)> {
    let primed = |(id, _): (SymbolId, u8)| {
        let name = own.entry(id).name.clone();
        (name.primes > 0 && !is_known(&name)).then_some((id, name))
    };
    let primed: Vec<(SymbolId, Name)> = [left, right].into_iter().flat_map(Expr::symbols).filter_map(primed).collect();
    let mut rates: Vec<(SymbolId, SymbolId, u8)> = Vec::new();
    for (id, name) in primed {
        let plain = Name { primes: 0, ..name.clone() };
        let of = own.find(&plain).map(|(of, _)| of).or_else(|| own.add(plain, Kind::Scalar))?;
        rates.push((id, of, name.primes));
    }
    let dotted = |side: &Expr| {
        let mut side = side.clone();
        let span = side.span;
        side.substitute(&|node| match node {
            Node::Symbol { id, indices, dots } => {
                let (_, of, primes) = rates.iter().find(|(primed, ..)| primed == id)?;
                let dots = dots.saturating_add(*primes);
                Some(Expr::new(Node::Symbol { id: *of, indices: indices.clone(), dots }, span))
            }
            _ => None,
        });
        side
    };
    (!rates.is_empty()).then(|| (dotted(left), dotted(right)))
}

/// Whether two equalities of several terms are the same but for their letters and for the sides on which the terms stand.
fn is_rearranged(line: &(Expr, Expr), display: &(Expr, Expr), pairs: &mut Pairs) -> bool {
    let (own, other) = (terms(line), terms(display));
    let flipped = |(sign, term): &(Sign, _)| (sign.flipped(), *term);
    own.len() >= FEWEST_TERMS
        && [own.clone(), own.iter().map(flipped).collect()].iter().any(|own| {
            in_some_order(own, &other, pairs, &|a: (Sign, &Expr), b: (Sign, &Expr), pairs: &mut _| {
                a.0 == b.0 && is_alike(a.1, b.1, pairs)
            })
        })
}

/// The fewest terms of an equality that is recognised with its terms on other sides: fewer are like many others.
const FEWEST_TERMS: usize = 3;

/// The terms of an equality with their signs, as if all stood on the left side.
fn terms<'e>((left, right): &'e (Expr, Expr)) -> Vec<(Sign, &'e Expr)> {
    let of = |side: &'e Expr| match &side.node {
        Node::Sum(terms) => terms.iter().map(|term| (term.sign, &term.expr)).collect(),
        _ => vec![(Sign::Plus, side)],
    };
    let moved = of(right).into_iter().map(|(sign, term): (Sign, &Expr)| (sign.flipped(), term));
    of(left).into_iter().chain(moved).filter(|(_, term)| !term.is_null()).collect()
}

/// Whether two formulas are the same but for their letters and the order of terms and factors. Letters correspond one to
/// one, as in `pairs`, to which new ones are added.
fn is_alike(left: &Expr, right: &Expr, pairs: &mut Pairs) -> bool {
    let start = pairs.len();
    let is_it = match (&left.node, &right.node) {
        (Node::Symbol { id: a, indices: none, dots }, Node::Symbol { id: b, indices: empty, dots: other }) => {
            let known = pairs.iter().find(|(own, meaning)| own == a || meaning == b).copied();
            if known.is_none() {
                pairs.push((*a, *b));
            }
            none.is_empty() && empty.is_empty() && dots == other && known.is_none_or(|pair| pair == (*a, *b))
        }
        (Node::Product(_) | Node::Quotient(..), Node::Product(_) | Node::Quotient(..)) => {
            let ([mut a, mut below], [mut b, mut under]) = (<[Vec<&Expr>; 2]>::default(), Default::default());
            factors(left, [&mut a, &mut below]);
            factors(right, [&mut b, &mut under]);
            let same = |a: &[&Expr], b: &[&Expr], pairs: &mut Vec<_>| {
                in_some_order(a, b, pairs, &|a: &Expr, b: &Expr, pairs: &mut Vec<_>| is_alike(a, b, pairs))
            };
            same(&a, &b, pairs) && same(&below, &under, pairs)
        }
        (Node::Sum(a), Node::Sum(b)) => {
            let (a, b): (Vec<_>, Vec<_>) = (a.iter().collect(), b.iter().collect());
            in_some_order(&a, &b, pairs, &|a, b, pairs| a.sign == b.sign && is_alike(&a.expr, &b.expr, pairs))
        }
        _ => {
            let (parts, others) = (left.children(), right.children());
            parts.len() == others.len()
                && head(left) == head(right)
                && parts.iter().zip(&others).all(|(a, b)| is_alike(a, b, pairs))
        }
    };
    if !is_it {
        pairs.truncate(start);
    }
    is_it
}

/// Whether a name may stand for another one: a hat marks an operator or a direction, which is no number.
pub(super) fn may_stand_for(own: &Name, other: &Name) -> bool {
    let has_hat = |name: &Name| name.base.starts_with("\\hat{");
    has_hat(own) == has_hat(other)
}

/// Whether a name is the frequency without a number, and the other one that of one of several modes: ω in `x = A\cos\omega t` is any
/// of ω_1 and ω_2.
pub(super) fn is_any_mode(known: &Names, own: &Name, other: &Name) -> bool {
    let modes = known.numbered(own);
    own.base == "\\omega" && modes.len() > 1 && modes.contains(&other)
}

/// The factors of a formula: those above the fraction line, and those below.
fn factors<'e>(formula: &'e Expr, [above, below]: [&mut Vec<&'e Expr>; 2]) {
    match &formula.node {
        Node::Product(all) => all.iter().for_each(|factor| factors(factor, [above, below])),
        Node::Quotient(a, b) => {
            factors(a, [above, below]);
            factors(b, [below, above]);
        }
        _ => above.push(formula),
    }
}

/// Whether the members of two lists correspond in some order.
fn in_some_order<T: Copy>(a: &[T], b: &[T], pairs: &mut Pairs, is_same: &impl Fn(T, T, &mut Pairs) -> bool) -> bool {
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
pub(in crate::check::mark) fn head(formula: &Expr) -> Node {
    let mut head = formula.clone();
    head.children_mut().into_iter().for_each(|child| *child = Expr::integer(0, Span::default()));
    head.node
}
