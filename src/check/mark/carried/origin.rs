//! The false line from which a false line follows: the ways are tried in turn, from the line before it backwards.

use super::Before;
use super::{about_rest, another_value, change, derived, freed, modes, numbers, redefined, step};
use crate::Result;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::{Reading, read_formula};
use crate::notes::claims::Claim;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::meaning::Meaning;
use crate::check::steps::entailment::{EarlierSteps, Entailment};

use crate::check::mark::special::Special;
use crate::check::mark::status::{Status, status};

/// The number of false lines before it that a line is compared with, the nearest first.
const LOOKED_BACK: usize = 6;

/// The false line from which a false line follows, by its display.
///
/// # Errors
/// As for a check of the line.
pub(in crate::check::mark) fn origin(
    checker: &Checker<'_>,
    (at, own): (usize, &Reading),
    before: &Before<'_>,
) -> Result<Option<usize>> {
    let pieces = checker.wrong_pieces(at, true)?;
    let pieces: Vec<&Reading> = pieces.iter().collect();
    for from in before.wrong.iter().rev().take(LOOKED_BACK) {
        if before.motion.is_carried(checker, (*from, at), own) {
            return Ok(Some(*from));
        }
        let of_problem = before.all.first().copied().unwrap_or(*from);
        let is_at_a_place = || {
            let rest = rest_of_chain(own);
            another_value::at_the_same_place(checker, *from, own, of_problem)
                && rest.is_none_or(|rest| matches!(status(checker, at, &rest, &Claim::default()), Status::Holds(..)))
        };
        if another_value::follows(checker, *from, (at, own), of_problem) || is_at_a_place() {
            return Ok(Some(*from));
        }
        if redefined::follows(checker, *from, (at, own), before) || shares_a_misreading(checker, *from, (at, own)) {
            return Ok(Some(*from));
        }
        let wrong = &checker.readings[*from];
        let is_inserted = numbers::inserted(checker, wrong, own)
            .is_some_and(|new| matches!(status(checker, at, &new, &Claim::default()), Status::Holds(..)));
        if is_inserted || follows(checker, *from, before, own) {
            return Ok(Some(*from));
        }
        if is_about_rest(checker, wrong, (at, own), before.special)
            || about_rest::follows(checker, *from, own, before)
            || change::follows(checker, *from, own)
            || modes::follows(checker, *from, own, before)
        {
            return Ok(Some(*from));
        }
        if pieces.is_empty() {
            continue;
        }
        let earlier = EarlierSteps { from: *from, before: before.all, sound: before.sound };
        let entailments = checker.entailments(&earlier, (at, &pieces), true)?;
        if entailments.iter().all(|entailment| *entailment == Entailment::Follows) {
            return Ok(Some(*from));
        }
    }
    Ok(None)
}

/// Whether a line follows from a false line by numbers, by itself or with true lines.
fn follows(checker: &Checker<'_>, from: usize, before: &Before<'_>, own: &Reading) -> bool {
    let Some(step) = step::Step::of(checker, from, before, own) else { return false };
    if step.is_motion_by_a_slope() || step.is_equation_for_what_stays() {
        return true;
    }
    let sets = step.sets();
    sets.iter().chain(&step.with_the_value()).chain(&step.beside_another()).any(|set| step.holds(&step.model, set))
        || step.is_first_integral(&sets[0])
        || freed::follows(&step, sets)
}

/// A chain without its first member; `None`, if nothing is left to say.
fn rest_of_chain(own: &Reading) -> Option<Reading> {
    let [Ok(statement)] = own.statements.as_slice() else { return None };
    (statement.members.len() > 2).then(|| {
        let (members, relations) = (statement.members[1..].to_vec(), statement.relations[1..].to_vec());
        let statement = Statement { members, relations, ..statement.clone() };
        Reading { statements: vec![Ok(statement)], introduced: Vec::new() }
    })
}

/// Whether a line says where a false equation of motion has a place of rest, or what it says for small motion.
fn is_about_rest(checker: &Checker<'_>, wrong: &Reading, (at, own): (usize, &Reading), special: &Special) -> bool {
    let places = special.places();
    let rests = || {
        let rest = derived::at_rest(checker, wrong, places)?;
        let is_place = |(id, _): &(SymbolId, u8)| {
            places.iter().any(|(_, place)| checker.model.symbols.find(place).is_some_and(|(found, _)| found == *id))
        };
        derived::symbols(own).iter().any(is_place).then(|| numbers::says(checker, own, &rest, places))
    };
    if rests() == Some(true) || is_condition_of_rest(checker, wrong, own, places) {
        return true;
    }
    let small = derived::accelerated(checker, wrong, own);
    small.is_some_and(|small| special.is_linear(checker, own) && special.holds_when_small(checker, at, &small))
}

/// Whether a line is the condition for rest that a false equation of motion gives, up to a factor: no state may obey it, as none obeys
/// a sum of positive terms that is 0.
fn is_condition_of_rest(checker: &Checker<'_>, wrong: &Reading, own: &Reading, places: &[(Name, Name)]) -> bool {
    let rest = derived::at_rest(checker, wrong, places);
    let links = |reading: &Reading| numbers::links(checker, reading).filter(|links| links.len() == 1);
    let (Some(rest), Some(own)) = (rest.as_ref().and_then(links), links(own)) else { return false };
    checker.proportional(&own[0], &rest[0], &[]).unwrap_or(false)
}

/// Whether two false lines hold if one constant is taken for another value: its negative, its double, its half, its reciprocal; or
/// an angle for what it lacks to a right angle. Then both have the same mistake.
fn shares_a_misreading(checker: &Checker<'_>, from: usize, (at, own): (usize, &Reading)) -> bool {
    let symbols = |reading: &Reading| -> Vec<SymbolId> {
        let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        members.flat_map(Expr::symbols).map(|(id, _)| id).collect()
    };
    let first = &checker.readings[from];
    let (mut shared, others) = (symbols(first), symbols(own));
    shared.sort_unstable();
    shared.dedup();
    shared.retain(|id| others.contains(id) && matches!(checker.model.meaning(*id), Some(Meaning::Constant(_))));
    let holds =
        |at: usize, reading: &Reading| matches!(status(checker, at, reading, &Claim::default()), Status::Holds(..));
    shared.into_iter().any(|id| {
        misreadings(checker, id).iter().any(|value| {
            let read = |reading: &Reading| substituted(reading, id, value);
            holds(at, &read(own)) && holds(from, &read(first))
        })
    })
}

/// What a constant may have been taken for.
fn misreadings(checker: &Checker<'_>, id: SymbolId) -> Vec<Expr> {
    let span = Span::default();
    let symbol = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span);
    let times = |text: &str| {
        let mut symbols = checker.model.symbols.clone();
        let name = checker.model.name(id);
        read_formula(&text.replace('#', &name), &mut symbols, &checker.model.macros).ok()
    };
    if checker.model.symbols.entry(id).angle {
        return times(r"\frac{\pi}{2} - #").into_iter().collect();
    }
    let mut all = vec![symbol.negated()];
    all.extend(times(r"2 \, #"));
    all.extend(times(r"\frac{1}{2} \, #"));
    all.extend(times(r"\frac{1}{#}"));
    all
}

fn substituted(reading: &Reading, id: SymbolId, value: &Expr) -> Reading {
    let mut reading = reading.clone();
    let other = |node: &Node| match node {
        Node::Symbol { id: found, dots: 0, .. } if *found == id => Some(value.clone()),
        _ => None,
    };
    for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        member.substitute(&other);
    }
    reading
}
