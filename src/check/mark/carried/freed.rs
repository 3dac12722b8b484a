//! Follow-through by algebra alone, whatever the problem says of its own quantities: that may contradict a false line.

use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::notes::claims::Range;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::{Meaning, Variable};

use super::numbers::{beside_one, holds, links, premises, twice};
use super::step::Step;
use super::{Before, derived};

/// Whether the line follows where the quantities of the problem are free, from the sets or from the false line with others.
pub(super) fn follows(step: &Step<'_, '_>, mut sets: Vec<Vec<Hypothesis>>) -> bool {
    let (checker, model, wrong) = (step.checker, &step.model, &step.wrong);
    let names = defined(step, step.wrong.iter().chain(&step.own));
    if has_the_frequency(step) {
        return true;
    }
    // A quantity that is positive in the problem need not be so in a false line: u = 0.
    let open = freed(model, &names, |_| Range::Any);
    let positive = |names: &[SymbolId]| {
        freed(model, names, |id| if is_positive(checker, id) { Range::Positive } else { Range::Any })
    };
    let near = positive(&names);
    sets.extend(step.others.iter().map(|one| premises(wrong.iter().chain(one))));
    // The rate of a false energy, with a false equation of motion.
    let rates = &step.rates;
    sets.extend(step.others.iter().filter(|_| !rates.is_empty()).map(|one| premises(rates.iter().chain(one))));
    // Which rate a quantity of the problem is, a hand-in need not say: I = \dot Q.
    let rates = rates_by_name(checker, step.before, &names);
    if !rates.is_empty() {
        sets.push(premises(wrong.iter().chain(&rates)));
    }
    let beside = step.derived.iter().flat_map(|derived| step.others.iter().map(move |other| (derived, other)));
    let beside: Vec<Vec<Hypothesis>> = beside.map(|(derived, other)| premises(derived.iter().chain(other))).collect();
    // The instant that another false line gives has that value.
    let all = [wrong, &step.own].into_iter().chain(&step.derived).chain(&step.others).flatten();
    let far = positive(&defined(step, all));
    let holds_near = |set: &Vec<Hypothesis>| step.holds(&open, set) || step.holds(&near, set);
    !names.is_empty()
        && (sets.iter().any(holds_near)
            || beside.iter().any(|set| holds_near(set) || step.holds(&far, set))
            || with_a_relation_of_the_problem(step))
}

/// The names in links that the problem defines, in its displays or in its claims.
fn defined<'l>(step: &Step<'_, '_>, links: impl Iterator<Item = &'l Link>) -> Vec<SymbolId> {
    let lines = &step.checker.readings[step.first()..];
    let of_problem = |id: SymbolId| !lines.iter().flat_map(|line| &line.introduced).any(|new| new.symbol == id);
    let mut names = Vec::new();
    for (id, _) in links.flat_map(|link| link.lhs.symbols().into_iter().chain(link.rhs.symbols())) {
        if !names.contains(&id) && of_problem(id) && matches!(step.model.meaning(id), Some(Meaning::Defined(_))) {
            names.push(id);
        }
    }
    names
}

/// Whether the line holds with the frequency of small oscillations that a false equation of motion says.
fn has_the_frequency(step: &Step<'_, '_>) -> bool {
    let (checker, model) = (step.checker, step.checker.model);
    let is_frequency = |id: &SymbolId| {
        let name = &model.symbols.entry(*id).name;
        let is_defined = matches!(model.meaning(*id), Some(Meaning::Defined(_)));
        model.normal_frequencies.contains(name) || is_defined && name.base == "\\omega"
    };
    let mut used = step.own.iter().flat_map(|link| link.lhs.symbols().into_iter().chain(link.rhs.symbols()));
    let frequency = used.find(|(id, dots)| *dots == 0 && is_frequency(id)).map(|(id, _)| id);
    let said =
        frequency.and_then(|id| derived::with_frequency(checker, &checker.readings[step.from], step.reading, id));
    let said = said.and_then(|reading| links(checker, &reading));
    said.is_some_and(|said| said.iter().all(|link| holds(checker, &step.model, link, &[]) == Some(true)))
}

/// A model in which names of the problem are free.
pub(super) fn freed(model: &Model, names: &[SymbolId], range: impl Fn(SymbolId) -> Range) -> Model {
    let mut free = model.clone();
    for id in names {
        free.mean(*id, Meaning::Varying(free.varying.len()));
        free.varying.push(Variable::number(*id, range(*id)));
    }
    free
}

/// Whether a line follows from a false one with a true line and a relation of the problem that the student did not write, whatever
/// else the problem says of its quantities: `K = E - m c^2`.
fn with_a_relation_of_the_problem(step: &Step<'_, '_>) -> bool {
    let (checker, model, first) = (step.checker, &step.model, step.first());
    let (wrong, own, sound) = (&step.wrong[..], &step.own[..], &step.sound);
    let is_own =
        |id: SymbolId| checker.readings[first..].iter().flat_map(|r| &r.introduced).any(|new| new.symbol == id);
    let quantities = |links: &[Link]| -> Vec<SymbolId> {
        let all = links.iter().flat_map(|link| link.lhs.symbols().into_iter().chain(link.rhs.symbols()));
        let is_defined = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Defined(_))) && !is_own(*id);
        all.map(|(id, _)| id).filter(is_defined).collect()
    };
    let share = |a: &[Link], b: &[Link]| {
        let of_b = quantities(b);
        quantities(a).iter().any(|id| of_b.contains(id))
    };
    let ends = [wrong, own].concat();
    let displays: Vec<Vec<Link>> = (0..first)
        .filter_map(|at| links(checker, &checker.readings[at]))
        .filter(|display| share(display, &ends))
        .collect();
    let pairs = sound.iter().filter(|line| share(line, wrong)).flat_map(|line| displays.iter().map(move |d| (line, d)));
    pairs.filter(|(line, display)| share(line, display)).any(|(line, display)| {
        let all = [wrong, line, display].concat();
        let mut names = quantities(&[&all, own].concat());
        names.sort_unstable();
        names.dedup();
        let free = freed(model, &names, |id| if is_positive(checker, id) { Range::Positive } else { Range::Any });
        let says = |links: &[Link]| links.iter().map(|link| Hypothesis::of(link.clone(), false)).collect::<Vec<_>>();
        let (with, without) = (says(&all), says(&[line.as_slice(), display].concat()));
        own.iter().all(|link| {
            holds(checker, &free, &beside_one(checker, link), &with) == Some(true)
                && holds(checker, &free, link, &without) != Some(true)
                && twice(checker, link).is_none_or(|twice| holds(checker, &free, &twice, &with) == Some(false))
        })
    })
}

/// The quantities among `names` that are rates of a coordinate along the motion of the problem, as links.
fn rates_by_name(checker: &Checker<'_>, before: &Before<'_>, names: &[SymbolId]) -> Vec<Link> {
    let moves =
        |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let moving: Vec<SymbolId> = checker.model.symbols.iter().map(|(id, _)| id).filter(moves).collect();
    let pairs = names.iter().flat_map(|name| moving.iter().map(move |of| (*name, *of)));
    let symbol = |id, dots| Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, Span::default());
    let links = pairs.filter_map(|(name, of)| {
        let rate = symbol(of, 1);
        [rate.clone(), rate.negated()].into_iter().find_map(|rate| {
            let link = checker.link(&symbol(name, 0), Relation::Equal, &rate).ok()?;
            before.motion.has(checker, &link).then_some(link)
        })
    });
    links.collect()
}

/// Whether a quantity of the problem is positive in all its states.
fn is_positive(checker: &Checker<'_>, id: SymbolId) -> bool {
    let symbol = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
    let link = checker.link(&symbol, Relation::Greater, &Expr::integer(0, Span::default()));
    link.is_ok_and(|link| holds(checker, checker.model, &link, &[]) == Some(true))
}
