//! Follow-through of a false equation of motion to small motion about its place of rest: the frequency there, and the linear
//! equation for the deviation.

use crate::formula::calculus::places::at;
use crate::formula::derivative::{Scope, partial};
use crate::formula::tree::Variable;
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::latex::Reading;

use crate::check::document::checker::Checker;
use crate::check::mark::given::solved_for;
use crate::check::mark::near_rest;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::Meaning;

use super::{Before, derived, numbers};

/// Whether a line follows to first order from a false equation of motion, where its right side vanishes.
pub(super) fn follows(checker: &Checker<'_>, from: usize, own: &Reading, before: &Before<'_>) -> bool {
    let wrong = &checker.readings[from];
    let of_problem = before.all.first().copied().unwrap_or(from);
    let find = |name| Some(checker.model.symbols.find(name)?.0);
    let places = before.special.kept().filter_map(|(of, place)| Some((find(of)?, find(place)?)));
    let all = [wrong, own].into_iter().filter_map(|reading| numbers::links(checker, reading)).flatten();
    let model = numbers::without_motion(checker, from, &all.collect::<Vec<_>>());
    let said = near_rest::about_places(checker, before.special, (of_problem, &unknown(checker, wrong)), wrong);
    places.into_iter().any(|place| {
        said.iter().any(|wrong| {
            let Some((rest, slope)) = at_rest(checker, wrong, place) else { return false };
            frequency((checker, &model), own, &rest, &slope)
                || linear((checker, &model), (wrong, own), (place, &rest), before)
        })
    })
}

/// The names in a line that move, and of which nothing says what they are.
fn unknown(checker: &Checker<'_>, reading: &Reading) -> Vec<SymbolId> {
    let moves = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Varying(_)));
    derived::symbols(reading).into_iter().map(|(id, _)| id).filter(moves).collect()
}

/// The acceleration that a false equation of motion gives at a place of rest, and its slope there.
fn at_rest(checker: &Checker<'_>, wrong: &Reading, (of, place): (SymbolId, SymbolId)) -> Option<(Expr, Expr)> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return None };
    let [first, .., last] = statement.members.as_slice() else { return None };
    if !derived::symbols(wrong).contains(&(of, 2)) {
        return None;
    }
    let acceleration = solved_for(checker, &first.clone().minus(last.clone()), (of, 2))?;
    let slope = slope(checker, &acceleration, of)?;
    Some((placed(&acceleration, (of, place)), placed(&slope, (of, place))))
}

/// The slope of a formula; what is conserved in the problem, as a momentum, does not change with the place.
fn slope(checker: &Checker<'_>, formula: &Expr, of: SymbolId) -> Option<Expr> {
    let by = Variable { id: of, indices: Vec::new(), dots: 0 };
    let is_kept = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::System(_)));
    let fixed: Vec<SymbolId> = formula.symbols().into_iter().map(|(id, _)| id).filter(is_kept).collect();
    partial(formula, &by, Scope { symbols: &checker.model.symbols, fixed: &fixed }, formula.span).ok()
}

/// A formula at a place, at rest.
fn placed(formula: &Expr, (of, place): (SymbolId, SymbolId)) -> Expr {
    let mut formula = formula.clone();
    formula.substitute(&|node| match node {
        Node::Symbol { id, dots, .. } if *id == of && *dots > 0 => Some(Expr::integer(0, Default::default())),
        _ => None,
    });
    at(&formula, of, &Expr::new(Node::Symbol { id: place, indices: Vec::new(), dots: 0 }, formula.span))
}

/// Whether a line holds where the square of the frequency is the negative slope of the acceleration.
fn frequency((checker, model): (&Checker<'_>, &Model), own: &Reading, rest: &Expr, slope: &Expr) -> bool {
    let is_frequency = |id: &SymbolId| {
        let name = &checker.model.symbols.entry(*id).name;
        checker.model.frequencies.iter().any(|frequency| frequency.name == *name)
    };
    let Some(id) = derived::symbols(own).into_iter().map(|(id, _)| id).find(is_frequency) else { return false };
    let new = derived::with_square(own, id, &slope.clone().negated());
    let Some(links) = numbers::links(checker, &new) else { return false };
    hold_at_rest((checker, model), &links, rest)
}

/// Whether a linear line holds to first order, with the false acceleration in it.
fn linear(
    (checker, model): (&Checker<'_>, &Model),
    (wrong, own): (&Reading, &Reading),
    ((of, place), rest): ((SymbolId, SymbolId), &Expr),
    before: &Before<'_>,
) -> bool {
    let of_problem = before.all.first().copied().unwrap_or(0);
    let all = near_rest::about_places(checker, before.special, (of_problem, &unknown(checker, own)), own);
    all.iter().filter(|said| before.special.is_linear(checker, said)).any(|said| {
        let Some(said) = derived::accelerated(checker, wrong, said) else { return false };
        let Some(links) = numbers::links(checker, &said) else { return false };
        let zero = Expr::integer(0, Default::default());
        let to_first_order = links.iter().map(|link| {
            let off = link.lhs.clone().minus(link.rhs.clone());
            let slope = slope(checker, &off, of)?;
            let both = [off, slope].map(|part| checker.link(&placed(&part, (of, place)), Relation::Equal, &zero).ok());
            both.into_iter().collect::<Option<Vec<Link>>>()
        });
        let Some(links) = to_first_order.collect::<Option<Vec<Vec<Link>>>>() else { return false };
        hold_at_rest((checker, model), &links.concat(), rest)
    })
}

/// Whether links hold wherever the acceleration at the place vanishes.
fn hold_at_rest((checker, model): (&Checker<'_>, &Model), links: &[Link], rest: &Expr) -> bool {
    let zero = Expr::integer(0, rest.span);
    let Ok(rests) = checker.link(rest, Relation::Equal, &zero) else { return false };
    let premises = [Hypothesis::of(rests, false)];
    links.iter().all(|link| {
        numbers::holds(checker, model, &numbers::beside_one(checker, link), &premises) == Some(true)
            && numbers::twice(checker, link)
                .is_none_or(|twice| numbers::holds(checker, model, &twice, &premises) == Some(false))
    })
}
