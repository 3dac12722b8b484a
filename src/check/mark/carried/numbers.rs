//! Follow-through between numbers: whether a false line holds wherever a false line before it holds, with true lines beside it,
//! whatever else the problem says.
//!
//! States are drawn that obey these lines, as equations between numbers, and nothing else. A step that inserts one line into
//! another, or solves for something else, is found in this way, and so is a differentiated conservation law.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Range};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::sample::outcome;

use super::super::status::{Status, status};

/// The states at which equations are compared, and how many of them must decide.
pub(in crate::check::mark) const STATES: usize = 8;
/// The states where fewer give too few numbers.
const MORE_STATES: usize = 4 * STATES;
/// The fewest states that decide.
pub(in crate::check::mark) const FEWEST: usize = 3;

/// The number of true lines from which a line may follow under a condition, the nearest.
const FARTHEST: usize = 12;

/// Whether a link holds at states of a model that obey hypotheses; `None`, if there are too few.
pub(in crate::check::mark) fn holds(
    checker: &Checker<'_>,
    model: &Model,
    link: &Link,
    hypotheses: &[Hypothesis],
) -> Option<bool> {
    let context = Context {
        model,
        options: checker.options,
        hypotheses,
        on_shell: Some(false),
        topic: "a wanted result",
        span: Span::default(),
        spread: Spread::Declared,
        local: &[],
    };
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let tried = |states: usize| {
        let ensemble = context.ensemble(mode, false, states).ok()?;
        let outcome = outcome::run(link, &ensemble.states).ok()?;
        Some((outcome.failure.is_some(), outcome.points))
    };
    // Where a side has a value only in some states, as a root has, more are drawn.
    let (fails, points) = tried(STATES)?;
    let is_short = !fails && points < FEWEST && (points > 0 || has_root(&link.lhs) || has_root(&link.rhs));
    let (fails, points) = if is_short { tried(MORE_STATES)? } else { (fails, points) };
    match (fails, points >= FEWEST) {
        (true, _) => Some(false),
        (false, true) => Some(true),
        (false, false) => None,
    }
}

fn has_root(formula: &Expr) -> bool {
    let mut found = false;
    formula.walk(&mut |part| found |= matches!(part.node, Node::Root(..)));
    found
}

/// Links as hypotheses.
pub(super) fn premises<'l>(links: impl IntoIterator<Item = &'l Link>) -> Vec<Hypothesis> {
    links.into_iter().map(|link| Hypothesis::of(link.clone(), false)).collect()
}

/// The model without the equations of motion, in which what is conserved is constant. `display` is one of the links' own.
pub(super) fn without_motion(checker: &Checker<'_>, display: usize, links: &[Link]) -> Model {
    let mut model = checker.without_system(false).model;
    for id in conserved(checker, display, links.iter()) {
        model.mean(id, Meaning::Constant(model.constants.len()));
        model.constants.push(Variable::number(id, Range::Any));
    }
    model
}

/// Whether an equation of motion holds where a line says what a coordinate is at all times: `Q = C U_0` in
/// `R C \dot Q = C U_0 - Q`. Both are displays.
pub(in crate::check::mark) fn solves_at_rest(checker: &Checker<'_>, line: usize, motion: usize) -> bool {
    let (own, motion) = (&checker.readings[line], &checker.readings[motion]);
    let (Some(own), [Ok(statement)], Some(motion)) =
        (links(checker, own), own.statements.as_slice(), links(checker, motion))
    else {
        return false;
    };
    let moves =
        |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let Some(id) = statement.members.first().and_then(Expr::as_plain_symbol).filter(moves) else { return false };
    let rate = |dots| {
        let rate = Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, statement.span);
        checker.link(&rate, Relation::Equal, &Expr::integer(0, statement.span))
    };
    let rates = [rate(1), rate(2)].into_iter().flatten();
    let premises: Vec<Hypothesis> = own.into_iter().chain(rates).map(|link| Hypothesis::of(link, false)).collect();
    let model = checker.without_system(false).model;
    motion.iter().all(|link| {
        let has_rate = [&link.lhs, &link.rhs]
            .iter()
            .any(|side| side.symbols().iter().any(|(other, dots)| *other == id && *dots > 0));
        has_rate
            && holds(checker, &model, &beside_one(checker, link), &premises) == Some(true)
            && holds(checker, &model, link, &[]) == Some(false)
    })
}

/// Whether a line follows from a condition and one of the true lines before it, by algebra alone.
pub(in crate::check::mark) fn follows_under(
    checker: &Checker<'_>,
    condition: &Reading,
    sound: &[usize],
    own: &Reading,
) -> bool {
    let (Some(condition), Some(own)) = (links(checker, condition), links(checker, own)) else { return false };
    let model = checker.without_system(false).model;
    let near = sound.iter().rev().take(FARTHEST).filter_map(|at| links(checker, &checker.readings[*at]));
    near.into_iter().any(|known| {
        let premises = |with: &[Link]| -> Vec<Hypothesis> {
            with.iter().chain(&known).map(|link| Hypothesis::of(link.clone(), false)).collect()
        };
        let (both, one) = (premises(&condition), premises(&[]));
        own.iter().all(|link| {
            holds(checker, &model, &beside_one(checker, link), &both) == Some(true)
                && holds(checker, &model, link, &one) == Some(false)
                && twice(checker, link).is_none_or(|twice| holds(checker, &model, &twice, &both) == Some(false))
        })
    })
}

/// Whether another line holds wherever a line does, and not everywhere, whatever the places of rest are.
pub(super) fn says(checker: &Checker<'_>, own: &Reading, other: &Reading, places: &[(Name, Name)]) -> bool {
    let (Some(own), Some(other)) = (links(checker, own), links(checker, other)) else { return false };
    let mut model = checker.without_system(false).model;
    for (id, _) in places.iter().filter_map(|(_, place)| checker.model.symbols.find(place)) {
        model.mean(id, Meaning::Constant(model.constants.len()));
        model.constants.push(Variable::number(id, Range::Any));
    }
    let premises: Vec<Hypothesis> = own.into_iter().map(|link| Hypothesis::of(link, false)).collect();
    other.iter().all(|link| {
        let link = beside_one(checker, link);
        holds(checker, &model, &link, &premises) == Some(true) && holds(checker, &model, &link, &[]) == Some(false)
    })
}

/// A line with the value that a false line gives to a quantity in its place; `None`, if it gives none.
pub(in crate::check::mark) fn inserted(checker: &Checker<'_>, from: &Reading, own: &Reading) -> Option<Reading> {
    let [Ok(statement)] = from.statements.as_slice() else { return None };
    let (first, value) = (statement.members.first()?, statement.members.last()?);
    let name = first.as_plain_symbol()?;
    let is_quantity =
        matches!(checker.model.meaning(name), Some(Meaning::Constant(_) | Meaning::Defined(_) | Meaning::System(_)));
    if !is_quantity || statement.members.len() < 2 || value.symbols().iter().any(|(id, _)| *id == name) {
        return None;
    }
    let mut new = own.clone();
    let mut is_there = false;
    for member in new.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        is_there |= member.symbols().iter().any(|(id, _)| *id == name);
        member.substitute(&|node| match node {
            Node::Symbol { id, dots: 0, .. } if *id == name => Some(value.clone()),
            Node::Symbol { id, dots, .. } if *id == name => {
                Some(Expr::new(Node::TimeDerivative(*dots, Box::new(value.clone())), value.span))
            }
            _ => None,
        });
    }
    is_there.then_some(new)
}

/// The equalities of a reading; `None`, if it has others, or none.
pub(in crate::check::mark) fn links(checker: &Checker<'_>, reading: &Reading) -> Option<Vec<Link>> {
    let mut found = Vec::new();
    for statement in &reading.statements {
        let statement = statement.as_ref().ok()?;
        for (pair, (relation, _)) in statement.members.windows(2).zip(&statement.relations) {
            let link = checker.link(&pair[0], Relation::Equal, &pair[1]).ok()?;
            found.push(is_equality(*relation).then_some(link)?);
        }
    }
    (!found.is_empty()).then_some(found)
}

/// The rate of a link.
pub(super) fn rate(checker: &Checker<'_>, link: &Link) -> Option<Link> {
    let of = |side: &Expr| Expr::new(Node::TimeDerivative(1, Box::new(side.clone())), side.span);
    checker.link(&of(&link.lhs), Relation::Equal, &of(&link.rhs)).ok()
}

/// A link to which 1 is added, if a side is 0: then its sides can be compared where they vanish.
pub(in crate::check::mark) fn beside_one(checker: &Checker<'_>, link: &Link) -> Link {
    let one = || Expr::integer(1, link.lhs.span).negated();
    let more = |side: &Expr| side.clone().minus(one());
    match link.lhs.is_null() || link.rhs.is_null() {
        true => checker.link(&more(&link.lhs), Relation::Equal, &more(&link.rhs)).unwrap_or_else(|_| link.clone()),
        false => link.clone(),
    }
}

/// A link with twice the right side, unless a side is 0.
pub(in crate::check::mark) fn twice(checker: &Checker<'_>, link: &Link) -> Option<Link> {
    if link.lhs.is_null() || link.rhs.is_null() {
        return None;
    }
    let double = Expr::new(Node::Product(vec![Expr::integer(2, link.rhs.span), link.rhs.clone()]), link.rhs.span);
    checker.link(&link.lhs, Relation::Equal, &double).ok()
}

/// The quantities of the system in the links of a display and of others that are constant in the problem.
fn conserved<'l>(checker: &Checker<'_>, display: usize, links: impl Iterator<Item = &'l Link>) -> Vec<SymbolId> {
    let mut found: Vec<SymbolId> = Vec::new();
    for (id, _) in links.flat_map(|link| link.lhs.symbols().into_iter().chain(link.rhs.symbols())) {
        let Some(Ok(line)) = checker.readings[display].statements.first() else { continue };
        if found.contains(&id) || !matches!(checker.model.meaning(id), Some(Meaning::System(_))) {
            continue;
        }
        let rate = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 1 }, line.span);
        let members = vec![rate, Expr::integer(0, line.span)];
        let stays = Statement { members, relations: vec![(Relation::Equal, line.span)], ..line.clone() };
        let stays = Reading { statements: vec![Ok(stays)], introduced: Vec::new() };
        if let Status::Holds(_) = status(checker, display, &stays, &Claim::default()) {
            found.push(id);
        }
    }
    found
}
