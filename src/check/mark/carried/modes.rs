//! Follow-through of a false equation of motion to the modes: the secular equation that it makes.

use crate::formula::calculus::places::at;
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::Range;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::given::solved_for;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::Meaning;

use super::freed::freed;
use super::{Before, derived, numbers};

/// The most equations of motion that are put together, the nearest to a line.
const MOST: usize = 3;

/// Whether a line says of a frequency what the equations of motion say of it, with a false one among them: all coordinates oscillate
/// with this frequency, and one of them has the amplitude 1.
pub(super) fn follows(checker: &Checker<'_>, from: usize, own: &Reading, before: &Before<'_>) -> bool {
    let model = checker.model;
    let is_moving = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let symbols = derived::symbols(own);
    if symbols.iter().any(|(id, dots)| *dots > 0 || is_moving(*id)) {
        return false;
    }
    let is_sought = |id: SymbolId| {
        let mut sought = before.contexts.iter().filter_map(|claim| claim.secular_for.as_ref());
        sought.any(|omega| model.name(id) == omega.value)
    };
    let found = symbols.iter().map(|(id, _)| *id).find(|id| is_sought(*id));
    let (Some(omega), Some(own)) = (found, numbers::links(checker, own)) else { return false };
    let Some((equations, coordinates)) = at_unit_amplitude(checker, from, before, omega) else { return false };
    let free = freed(&checker.without_system(false).model, &[omega], |_| Range::Any);
    let premises = |links: &[Link]| links.iter().map(|link| Hypothesis::of(link.clone(), false)).collect::<Vec<_>>();
    let holds = |link: &Link, set: &[Hypothesis]| {
        numbers::holds(checker, &free, &numbers::beside_one(checker, link), set) == Some(true)
    };
    let fails = |link: &Link, set: &[Hypothesis]| numbers::holds(checker, &free, link, set) == Some(false);
    own.iter().all(|link| holds(link, &premises(&equations)) && fails(link, &[]))
        || is_without_amplitudes(checker, (&equations, &coordinates), omega, &own)
}

/// Whether a line is the equation that two equations of motion leave for the frequency once the amplitude is eliminated, up to a factor
/// without it: no real frequency may obey it.
fn is_without_amplitudes(
    checker: &Checker<'_>,
    (equations, coordinates): (&[Link], &[SymbolId]),
    omega: SymbolId,
    own: &[Link],
) -> bool {
    let ([one, two], [_, amplitude], [own]) = (equations, coordinates, own) else { return false };
    let off = |link: &Link| link.lhs.clone().minus(link.rhs.clone());
    let eliminated = |from: &Link, other: &Link| {
        let value = solved_for(checker, &off(from), (*amplitude, 0))?;
        Some(at(&off(other), *amplitude, &value))
    };
    let Some(known) = eliminated(one, two).or_else(|| eliminated(two, one)) else { return false };
    let own = off(own);
    let at_one = |formula: &Expr| at(formula, omega, &Expr::integer(1, formula.span));
    let product = |a: &Expr, b: Expr| Expr::new(Node::Product(vec![a.clone(), b]), a.span);
    let model = checker.without_system(false).model;
    let (left, right) = (product(&own, at_one(&known)), product(&known, at_one(&own)));
    let is_about_it = own.symbols().contains(&(omega, 0)) && known.symbols().contains(&(omega, 0));
    let same = checker.link(&left, Relation::Equal, &right);
    is_about_it && same.is_ok_and(|same| numbers::holds(checker, &model, &same, &[]) == Some(true))
}

/// The nearest equations of motion, one for each coordinate and the false one among them, with −ω² times a coordinate for its
/// acceleration, and 1 for the first coordinate; and the coordinates.
fn at_unit_amplitude(
    checker: &Checker<'_>,
    from: usize,
    before: &Before<'_>,
    omega: SymbolId,
) -> Option<(Vec<Link>, Vec<SymbolId>)> {
    let accelerated = |link: &Link| -> Option<SymbolId> {
        let mut all: Vec<SymbolId> = [&link.lhs, &link.rhs]
            .into_iter()
            .flat_map(Expr::symbols)
            .filter(|(id, dots)| *dots == 2 && checker.model.is_coordinate(*id))
            .map(|(id, _)| id)
            .collect();
        all.dedup();
        matches!(all.as_slice(), [_]).then(|| all[0])
    };
    let mut equations: Vec<(SymbolId, Link)> = Vec::new();
    let others = before.all.iter().rev().filter(|at| before.wrong.contains(at) || before.sound.contains(at));
    for at in std::iter::once(&from).chain(others) {
        for link in numbers::links(checker, &checker.readings[*at]).unwrap_or_default() {
            let Some(id) = accelerated(&link).filter(|id| equations.iter().all(|(known, _)| known != id)) else {
                continue;
            };
            equations.push((id, link));
        }
    }
    equations.truncate(MOST);
    let coordinates: Vec<SymbolId> = equations.iter().map(|(id, _)| *id).collect();
    let first = *coordinates.first().filter(|_| coordinates.len() > 1)?;
    let symbol = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
    let size = |id: SymbolId| if id == first { Expr::integer(1, Span::default()) } else { symbol(id) };
    let replaced = |side: &Expr| {
        let mut side = side.clone();
        side.substitute(&|node| match node {
            Node::Symbol { id, dots, .. } if coordinates.contains(id) && *dots != 1 => Some(match dots {
                0 => size(*id),
                _ => Expr::new(Node::Product(vec![symbol(omega), symbol(omega), size(*id)]), Span::default()).negated(),
            }),
            _ => None,
        });
        side
    };
    let link = |(_, link): &(SymbolId, Link)| {
        let has_rate = [&link.lhs, &link.rhs].iter().any(|side| side.symbols().iter().any(|(_, dots)| *dots == 1));
        let new = checker.link(&replaced(&link.lhs), Relation::Equal, &replaced(&link.rhs)).ok();
        new.filter(|_| !has_rate)
    };
    let links = equations.iter().map(link).collect::<Option<_>>()?;
    Some((links, coordinates.clone()))
}
