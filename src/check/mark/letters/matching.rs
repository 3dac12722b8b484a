//! Other letters by the form of a line: an equation of the hand-in that is one of the problem but for its letters says what
//! those letters stand for, however many there are.

use std::collections::HashMap;

use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, Node, SymbolId, Symbols};
use crate::latex::rename::renamed_with;
use crate::latex::{Macros, read_display};

use crate::check::document::setup::define_macros;
use crate::check::mark::judge::with_dots;
use crate::check::mark::names::{Letters, Names, Role, StandsFor};
use crate::check::mark::problem::Problem;
use crate::check::mark::written::Written;

use super::likeness::{Likeness, Pairs, is_alike, is_rearranged, is_rich};

/// The most tables that are returned.
const MOST: usize = 6;

/// Tables of letters, the one that explains most letters first: those with which a line is an equation of the problem, or one with a
/// slip, by the `likeness` that is asked for. `is_own` tells the names that only the hand-in has, and `is_free` the names of the
/// problem that the hand-in does not use.
pub(super) fn tables(
    (problem, likeness): (&Problem, Likeness),
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
        // With a slip in the line it proves too little that a letter of the problem has another meaning.
        let stands = |a: &Name| is_own(a) || likeness == Likeness::Same && is_number(a);
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
        let mut is_it =
            is_alike(likeness, &line.0, &display.0, &mut pairs) && is_alike(likeness, &line.1, &display.1, &mut pairs);
        if !is_it {
            pairs.truncate(known.len());
            is_it = is_rearranged(likeness, line, display, &mut pairs);
        }
        (is_it && is_sound(&other(&pairs))).then_some(pairs)
    };
    let none = Pairs::new();
    let starts_with = |line: &&(Expr, Expr)| likeness == Likeness::Same || is_rich(line);
    let all = written.iter().filter(starts_with).flat_map(|line| of_problem.iter().map(move |display| (line, display)));
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
