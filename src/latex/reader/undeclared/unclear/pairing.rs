//! Differentials behind several integral signs, `\int_0^{2\pi} \int_0^R r\,dr\,d\phi`.
//!
//! The inner integral takes the first differential. Many authors write the differentials in the order of the signs instead, so a
//! display is refused where the usual order gives a variable a limit that it cannot have, a radius π or an angle R, or where a
//! factor between the differentials, `dr\sin\theta\,d\theta`, shows that each sign has its own part of the integrand.

use crate::formula::symbols::Name;
use crate::source::{Fault, Span};

use super::super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::super::names;
use super::super::super::super::rows::relation;
use super::super::super::items::{differential, is_any_integral, is_integral};

/// The fault of such integrals in a display.
pub(super) fn unclear_pairing(items: &[Item]) -> Option<Fault> {
    let is_end = |item: &Item| matches!(item.layout, Layout::Row | Layout::Align) || relation(item).is_some();
    let here = items.split(is_end).find_map(of_a_side);
    here.or_else(|| items.iter().find_map(|item| parts(item).into_iter().find_map(unclear_pairing)))
}

/// A differential with its name, and where it stands.
struct Differential {
    name: Name,
    at: usize,
}

fn of_a_side(items: &[Item]) -> Option<Fault> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let first = solid.windows(2).position(|pair| pair.iter().all(|item| is_integral(item)))?;
    let signs = &solid[first..first + solid[first..].iter().take_while(|item| is_integral(item)).count()];
    let rest = &solid[first + signs.len()..];
    let length = rest.iter().take_while(|item| !is_any_integral(item)).count();
    let found = differentials(&rest[..length]);
    if found.len() != signs.len() {
        return None;
    }
    let (from, to) = (found.first()?.at, found.last()?.at);
    let is_apart = found.windows(2).any(|pair| pair[1].at != pair[0].at + 2);
    let limits: Option<Vec<(&Item, &Item)>> = signs.iter().map(|sign| limits(sign)).collect();
    let limits = limits?;
    let is_misfit = || {
        let pairs: Vec<(&Name, (&Item, &Item))> =
            found.iter().map(|one| &one.name).zip(limits.iter().rev().copied()).collect();
        pairs.iter().any(|(name, (below, above))| {
            mentions(below, name) || mentions(above, name) || cannot_end(name, above) || is_swapped(name, above, &pairs)
        })
    };
    (is_apart || is_misfit()).then(|| fault(rest[from].span.to(rest[to + 1].span)))
}

fn fault(span: Span) -> Fault {
    Fault::ambiguous(span, "these differentials may belong to the integral signs in this order or in the reverse order")
        .help("write each differential behind its sign, as in \\int_0^{2\\pi} d\\phi \\int_0^R r\\,dr")
}

fn limits(sign: &Item) -> Option<(&Item, &Item)> {
    match &sign.layout {
        Layout::Scripts { sub: Some(below), sup: Some(above), .. } => Some((below, above)),
        _ => None,
    }
}

fn differentials(items: &[&Item]) -> Vec<Differential> {
    (0..items.len().saturating_sub(1))
        .filter(|at| differential(items[*at]) == Some(1))
        .filter_map(|at| {
            let found = names::printed(items[at + 1], None).filter(|found| found.sup.is_none())?;
            Some(Differential { name: found.name, at })
        })
        .collect()
}

fn mentions(limit: &Item, name: &Name) -> bool {
    names::printed(limit, None).is_some_and(|found| found.name == *name)
        || contents(limit).iter().any(|item| names::printed(item, None).is_some_and(|found| found.name == *name))
}

fn is_angle(name: &Name) -> bool {
    ["\\theta", "\\vartheta", "\\phi", "\\varphi", "\\alpha"].contains(&name.base.as_str())
}

/// Whether a limit is a number of turns: π, 2π, π/2.
fn is_turn(limit: &Item) -> bool {
    let is_pi = |item: &Item| item.layout == Layout::Command("\\pi".to_owned());
    let has_pi = |item: &Item| match &item.layout {
        Layout::Fraction(above, _) => contents(above).iter().any(is_pi),
        _ => is_pi(item),
    };
    contents(limit).iter().any(has_pi)
}

/// Whether an upper limit is none of a variable: a turn of a radius, a length of an angle.
fn cannot_end(name: &Name, above: &Item) -> bool {
    let is_radius = ["r", "R", "s", "z", "p", "v"].contains(&name.base.as_str());
    let is_length = |item: &Item| {
        matches!(&item.layout, Layout::Letter(c) if "RrLlahHbd".contains(*c))
            || item.layout == Layout::Command("\\infty".to_owned())
    };
    is_radius && is_turn(above) || is_angle(name) && matches!(contents(above), [only] if is_length(only))
}

/// Whether θ goes around and φ half around.
fn is_swapped(name: &Name, above: &Item, pairs: &[(&Name, (&Item, &Item))]) -> bool {
    let is_azimuth = |name: &Name| ["\\phi", "\\varphi"].contains(&name.base.as_str());
    let is_whole =
        |limit: &Item| is_turn(limit) && matches!(&contents(limit)[0].layout, Layout::Number(digits) if digits == "2");
    let is_half = |limit: &Item| is_turn(limit) && contents(limit).len() == 1;
    name.base == "\\theta"
        && is_whole(above)
        && pairs.iter().any(|(other, (_, limit))| is_azimuth(other) && is_half(limit))
}
