//! What a false line says in other words, so that a step from it is found: inserted into a true line, at a place of rest, for
//! small motion, at an instant, or by the equation of Euler and Lagrange.

use crate::formula::calculus::places::at;
use crate::formula::derivative::{Scope, partial, rate};
use crate::formula::symbols::Name;
use crate::formula::tree::Variable;
use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::{Reading, names};
use crate::notes::Display;
use crate::notes::claims::Claim;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::given::solved_for;
use crate::check::mark::motion::{Motion, written_out};
use crate::check::mark::names::moving;
use crate::check::mark::special::Special;
use crate::check::model::meaning::Meaning;

/// The most constants of a line that are tried as the value of a coordinate at an instant.
const TRIED: usize = 4;

/// The readings that say what a false line says when it is inserted into others: `\dot\omega = g/R` in `I \dot\omega = S R`.
pub(super) fn insertions(checker: &Checker<'_>, wrong: &Reading, others: &[usize]) -> Vec<Reading> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return Vec::new() };
    let (Some(first), Some(value)) = (statement.members.first(), statement.members.last()) else { return Vec::new() };
    let Node::Symbol { id, dots, indices } = &first.node else { return Vec::new() };
    if !indices.is_empty() || value.symbols().iter().any(|(other, _)| other == id) || statement.members.len() < 2 {
        return Vec::new();
    }
    let has = |reading: &&Reading| symbols(reading).contains(&(*id, *dots));
    let with = |reading: &Reading| {
        replaced(reading, &|node| match node {
            Node::Symbol { id: found, dots: order, .. } if found == id && order == dots => Some(value.clone()),
            _ => None,
        })
    };
    others.iter().map(|at| &checker.readings[*at]).filter(has).map(with).collect()
}

/// The equation of motion that follows from a false slope of the Lagrangian: `\frac{\partial L}{\partial\theta} = …`.
pub(super) fn motion_by_a_slope(checker: &Checker<'_>, from: usize) -> Option<Reading> {
    let (of, by, value) = slope(&checker.notes.equations[from].text)?;
    let text = format!("\\frac{{d}}{{dt}}\\frac{{\\partial {of}}}{{\\partial\\dot{{{by}}}}} = {value}");
    let reading = checker.as_printed(&text, &Claim::default(), &checker.model.macros);
    reading.statements.iter().all(Result::is_ok).then_some(reading)
}

/// The same with the rate of the momentum written out, which is then no name.
pub(super) fn motion_written_out(checker: &Checker<'_>, from: usize) -> Option<Reading> {
    let [Ok(statement)] = checker.readings[from].statements.as_slice() else { return None };
    let (of, by, _) = slope(&checker.notes.equations[from].text)?;
    let symbols = &checker.model.symbols;
    let find = |name: &str| Some(symbols.find(&names::parse(name)?.0)?.0);
    let (of, by) = (find(of)?, find(by)?);
    let (scope, span) = (Scope { symbols, fixed: &[] }, statement.span);
    let lagrangian = Expr::new(Node::Symbol { id: of, indices: Vec::new(), dots: 0 }, span);
    let momentum = partial(&lagrangian, &Variable { id: by, indices: Vec::new(), dots: 1 }, scope, span).ok()?;
    let members = vec![rate(&momentum, scope, span).ok()?, statement.members.last()?.clone()];
    let statement = Statement { members, relations: statement.relations[..1].to_vec(), ..statement.clone() };
    Some(Reading { statements: vec![Ok(statement)], introduced: Vec::new() })
}

/// The equation of motion that follows from a false momentum: `\frac{\partial L}{\partial\dot s} = …`, of which the rate is the true slope.
pub(super) fn motion_by_a_momentum(checker: &Checker<'_>, from: usize) -> Option<Reading> {
    let [Ok(statement)] = checker.readings[from].statements.as_slice() else { return None };
    let (of, by) = momentum(&checker.notes.equations[from].text)?;
    let symbols = &checker.model.symbols;
    let find = |name: &str| Some(symbols.find(&names::parse(name)?.0)?.0);
    let (of, by) = (find(of)?, find(by)?);
    let (scope, span) = (Scope { symbols, fixed: &[] }, statement.span);
    let lagrangian = Expr::new(Node::Symbol { id: of, indices: Vec::new(), dots: 0 }, span);
    let slope = partial(&lagrangian, &Variable { id: by, indices: Vec::new(), dots: 0 }, scope, span).ok()?;
    let members = vec![rate(statement.members.last()?, scope, span).ok()?, slope];
    let statement = Statement { members, relations: statement.relations[..1].to_vec(), ..statement.clone() };
    Some(Reading { statements: vec![Ok(statement)], introduced: Vec::new() })
}

/// The names in the momentum that a text gives: `L` and `s` in `\frac{\partial L}{\partial\dot s} = …`.
fn momentum(text: &str) -> Option<(&str, &str)> {
    let rest = text.trim_start().strip_prefix("\\frac{\\partial")?;
    let (of, rest) = rest.split_once("}{\\partial")?;
    let rest = rest.trim_start().strip_prefix("\\dot")?;
    let (by, rest) = match rest.strip_prefix('{') {
        Some(inside) => inside.split_once('}').map(|(by, rest)| (by, rest.strip_prefix('}').unwrap_or_default()))?,
        None => rest.split_once('}')?,
    };
    let is_name = |text: &str| text.len() < 40 && !text.contains(['=', '{', '}']);
    (rest.trim_start().starts_with('=') && is_name(of) && is_name(by)).then(|| (of.trim(), by.trim()))
}

/// The names in the slope of a function that a text gives, and its value: `L`, `\theta` and what is right of the last =.
fn slope(text: &str) -> Option<(&str, &str, &str)> {
    let rest = text.trim_start().strip_prefix("\\frac{\\partial")?;
    let (of, rest) = rest.split_once("}{\\partial")?;
    let (by, rest) = rest.split_once('}')?;
    let value = rest.trim_start().strip_prefix('=')?.rsplit('=').next()?;
    let is_name = |text: &str| text.len() < 40 && !text.contains(['=', '{', '}']);
    (is_name(of) && is_name(by) && !by.contains("\\dot")).then(|| (of.trim(), by.trim(), value))
}

/// A false line where the coordinates are at a place of rest: `(\theta, \theta_0)` for each that has a name.
pub(super) fn at_rest(checker: &Checker<'_>, wrong: &Reading, places: &[(Name, Name)]) -> Option<Reading> {
    let find = |name: &Name| Some(checker.model.symbols.find(name)?.0);
    let places: Vec<(SymbolId, SymbolId)> = places.iter().filter_map(|(a, b)| Some((find(a)?, find(b)?))).collect();
    let is_moving =
        |id: SymbolId| matches!(checker.model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let has_rate = symbols(wrong).iter().any(|(id, dots)| *dots == 2 && places.iter().any(|(of, _)| of == id));
    has_rate.then(|| {
        replaced(wrong, &|node| match node {
            Node::Symbol { id, dots, .. } if *dots > 0 && is_moving(*id) => Some(Expr::integer(0, Default::default())),
            Node::Symbol { id, dots: 0, indices } => {
                let (_, place) = places.iter().find(|(of, _)| of == id)?;
                Some(Expr::new(Node::Symbol { id: *place, indices: indices.clone(), dots: 0 }, Default::default()))
            }
            _ => None,
        })
    })
}

/// A line with the acceleration that a false line gives in the place of that acceleration.
pub(super) fn accelerated(checker: &Checker<'_>, wrong: &Reading, own: &Reading) -> Option<Reading> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return None };
    let [first, .., last] = statement.members.as_slice() else { return None };
    let is_shared = |rate: &&(SymbolId, u8)| rate.1 == 2 && symbols(own).contains(rate);
    let (id, dots) = *symbols(wrong).iter().find(is_shared)?;
    let value = solved_for(checker, &first.clone().minus(last.clone()), (id, dots))?;
    Some(replaced(own, &|node| match node {
        Node::Symbol { id: found, dots: order, .. } if *found == id && *order == dots => Some(value.clone()),
        _ => None,
    }))
}

/// A line with the frequency that a false linear equation of motion has in the place of a frequency of the problem:
/// −q̈/q for its square.
pub(super) fn with_frequency(
    checker: &Checker<'_>,
    wrong: &Reading,
    own: &Reading,
    frequency: SymbolId,
) -> Option<Reading> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return None };
    let [first, .., last] = statement.members.as_slice() else { return None };
    let (id, dots) = *symbols(wrong).iter().find(|(_, dots)| *dots == 2)?;
    let value = solved_for(checker, &first.clone().minus(last.clone()), (id, dots))?;
    let span = value.span;
    let place = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span);
    let square = Expr::new(Node::Quotient(Box::new(value.negated()), Box::new(place)), span);
    Some(with_square(own, frequency, &square))
}

/// A line with a formula in the place of the square of a frequency.
pub(super) fn with_square(own: &Reading, frequency: SymbolId, square: &Expr) -> Reading {
    let is_frequency = |expr: &Expr| expr.as_plain_symbol() == Some(frequency);
    replaced(own, &|node| match node {
        Node::Power(base, power) if is_frequency(base) && matches!(&power.node, Node::Number(two) if two == "2") => {
            Some(square.clone())
        }
        Node::Symbol { id, dots: 0, .. } if *id == frequency => {
            Some(Expr::new(Node::Root(2, Box::new(square.clone())), square.span))
        }
        _ => None,
    })
}

/// What a false function of the time says where the problem says what the value at an instant is: `v(t_h) = \frac12 v_\infty`
/// gives `\frac{m g}{k}(1 - e^{-k t_h/m}) = \frac12 v_\infty`. `first` is the number of displays that are the problem's.
pub(super) fn at_instants_of_the_problem(checker: &Checker<'_>, wrong: &Reading, first: usize) -> Vec<Reading> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return Vec::new() };
    let [name, .., formula] = statement.members.as_slice() else { return Vec::new() };
    let model = checker.model;
    let is_time = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Time));
    let Some(time) = model.symbols.iter().map(|(id, _)| id).find(is_time) else { return Vec::new() };
    let moving: Vec<SymbolId> = moving(model).into_iter().filter(|id| *id != time).collect();
    let Some(id) = name.as_plain_symbol().filter(|_| model.depends_on(name, &moving)) else { return Vec::new() };
    if !formula.symbols().contains(&(time, 0)) {
        return Vec::new();
    }
    let shown = model.name(id);
    let value = |display: &Display| {
        let rest = display.text.trim_start().strip_prefix(shown.as_str())?.trim_start().strip_prefix('(')?;
        let (when, rest) = rest.split_once(')')?;
        let value = rest.trim_start().strip_prefix('=')?.rsplit('=').next()?;
        let said = checker.as_printed(&format!("{when} = {value}"), &Claim::default(), &model.macros);
        let [Ok(said)] = said.statements.as_slice() else { return None };
        let [when, value] = said.members.as_slice() else { return None };
        // At the time itself it is no instant.
        when.as_plain_symbol().filter(|when| *when != time)?;
        let members = vec![at(formula, time, when), value.clone()];
        let relations = statement.relations[..1].to_vec();
        let statement = Statement { members, relations, ..statement.clone() };
        Some(Reading { statements: vec![Ok(statement)], introduced: Vec::new() })
    };
    checker.notes.equations[..first].iter().filter_map(value).collect()
}

/// What a false function of the time says at an instant, for the constants of a line: `y = \frac14 g t^2` says
/// `h = \frac14 g t_1^2`, and its rate `v_1 = \frac12 g t_1`; or that it vanishes then. `others` are names that other false
/// lines give a value, as the instant.
pub(super) fn at_instants(checker: &Checker<'_>, wrong: &Reading, own: &Reading, others: &[SymbolId]) -> Vec<Reading> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return Vec::new() };
    let [first, .., formula] = statement.members.as_slice() else { return Vec::new() };
    let Node::Symbol { id, dots, .. } = &first.node else { return Vec::new() };
    let model = checker.model;
    let is_time = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Time));
    let Some(time) = model.symbols.iter().map(|(id, _)| id).find(is_time) else { return Vec::new() };
    let moves = matches!(model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    if !moves || *dots > 1 || !formula.symbols().contains(&(time, 0)) {
        return Vec::new();
    }
    let by = Variable { id: time, indices: Vec::new(), dots: 0 };
    let slope = partial(formula, &by, Scope { symbols: &model.symbols, fixed: &[] }, formula.span).ok();
    let fixed = |(id, dots): &(SymbolId, u8)| *dots == 0 && !is_time(id);
    let names: Vec<SymbolId> = symbols(own).into_iter().filter(fixed).map(|(id, _)| id).collect();
    let letter = |id: SymbolId| model.symbols.entry(id).name.base.as_str();
    let is_instant = |id: &&SymbolId| is_instant(checker, **id);
    let is_value = |id: &&SymbolId| !is_instant(id) && !formula.symbols().iter().any(|(other, _)| other == *id);
    let statement = |members: Vec<Expr>| {
        let relations = statement.relations[..1].to_vec();
        let statement = Statement { members, relations, ..statement.clone() };
        Reading { statements: vec![Ok(statement)], introduced: Vec::new() }
    };
    let mut found = Vec::new();
    let mut instants: Vec<SymbolId> = names.iter().chain(others).filter(is_instant).copied().collect();
    instants.dedup();
    for when in instants.iter().take(TRIED) {
        let there = Expr::new(Node::Symbol { id: *when, indices: Vec::new(), dots: 0 }, formula.span);
        found.push(statement(vec![at(formula, time, &there), Expr::integer(0, formula.span)]));
        for value in names.iter().filter(is_value).take(TRIED) {
            let is_speed = ["v", "u", "w", "V", "\\omega"].contains(&letter(*value));
            let Some(formula) = (if is_speed && *dots == 0 { slope.as_ref() } else { Some(formula) }) else { continue };
            let symbol = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, formula.span);
            found.push(statement(vec![symbol(*value), at(formula, time, &symbol(*when))]));
        }
    }
    found
}

/// What a false function of the time says where the true one has its value at an instant of the problem: with `q = Q e^{t/(RC)}`
/// and half of the charge at t_h it is `Q e^{t_h/(RC)} = \frac12 Q`.
pub(super) fn at_values_of_the_motion(
    checker: &Checker<'_>,
    motion: &Motion,
    wrong: &Reading,
    own: &Reading,
) -> Vec<Reading> {
    let [Ok(statement)] = wrong.statements.as_slice() else { return Vec::new() };
    let [name, .., formula] = statement.members.as_slice() else { return Vec::new() };
    let model = checker.model;
    let is_time = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Time));
    let Some(time) = model.symbols.iter().map(|(id, _)| id).find(is_time) else { return Vec::new() };
    if name.as_plain_symbol().is_none() || !formula.symbols().contains(&(time, 0)) {
        return Vec::new();
    }
    let Some(value) = motion.function(checker, name) else { return Vec::new() };
    let moving = moving(model);
    let fixed = |formula: &Expr| !model.depends_on(formula, &moving);
    let said = |(id, dots): (SymbolId, u8)| {
        let instant = match model.meaning(id) {
            Some(Meaning::Defined(instant)) if dots == 0 && id != time && fixed(instant) => instant,
            _ => return None,
        };
        let when = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, formula.span);
        let members = vec![at(formula, time, &when), at(&value, time, instant)];
        let is_known = fixed(&members[1]) && is_instant(checker, id);
        let relations = statement.relations[..1].to_vec();
        let statement = Statement { members, relations, ..statement.clone() };
        is_known.then(|| Reading { statements: vec![Ok(statement)], introduced: Vec::new() })
    };
    symbols(own).into_iter().filter_map(said).collect()
}

/// Whether a name is one for an instant.
fn is_instant(checker: &Checker<'_>, id: SymbolId) -> bool {
    ["t", "T", "\\tau"].contains(&checker.model.symbols.entry(id).name.base.as_str())
}

/// What a false line says where a coordinate keeps its value, and others move: on a circle.
pub(super) fn on_a_circle(checker: &Checker<'_>, wrong: &Reading, special: &Special) -> Vec<Reading> {
    let find = |name: &Name| Some(checker.model.symbols.find(name)?.0);
    let kept = special.kept().filter_map(|(of, place)| Some((find(of)?, find(place)?)));
    let kept: Vec<(SymbolId, SymbolId)> = kept.collect();
    let turning = special.turning().iter().filter_map(|(of, rate)| Some((find(of)?, find(rate)?)));
    let turning: Vec<(SymbolId, SymbolId)> = turning.collect();
    let has_rate = |of: SymbolId| symbols(wrong).iter().any(|(id, dots)| *id == of && *dots > 0);
    let symbol = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
    // With the rates that the others keep there, also in what is defined by them: ℓ = m r_0²Ω.
    let turns = |node: &Node| {
        let Node::Symbol { id, dots, .. } = node else { return None };
        let place = kept.iter().find(|(of, _)| of == id).map(|(_, place)| *place);
        let rate = turning.iter().find(|(of, _)| of == id).map(|(_, rate)| *rate);
        match (place, rate, dots) {
            (Some(place), _, 0) => Some(symbol(place)),
            (_, Some(rate), 1) => Some(symbol(rate)),
            (Some(_), ..) | (_, Some(_), 2..) => Some(Expr::integer(0, Span::default())),
            _ => None,
        }
    };
    let mut whole = wrong.clone();
    for member in whole.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        *member = written_out(checker, member.clone());
        member.substitute(&turns);
    }
    let is_turning = !turning.is_empty() && kept.iter().any(|(of, _)| has_rate(*of));
    kept.iter()
        .copied()
        .filter(|(of, _)| has_rate(*of))
        .map(|(of, place)| {
            replaced(wrong, &|node| match node {
                Node::Symbol { id, dots: 0, indices } if *id == of => {
                    Some(Expr::new(Node::Symbol { id: place, indices: indices.clone(), dots: 0 }, Default::default()))
                }
                Node::Symbol { id, .. } if *id == of => Some(Expr::integer(0, Default::default())),
                _ => None,
            })
        })
        .chain(is_turning.then_some(whole))
        .collect()
}

/// What a false line with one coordinate and its velocity says where one of them vanishes and the other is a quantity of a
/// line: `E = k x^2 + \frac12 m \dot x^2` says `E = k A^2`.
pub(super) fn at_turns(checker: &Checker<'_>, wrong: &Reading, own: &Reading) -> Vec<Reading> {
    let model = checker.model;
    let moves = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let moving: Vec<(SymbolId, u8)> = symbols(wrong).into_iter().filter(|(id, _)| moves(*id)).collect();
    let Some(&(id, _)) = moving.first() else { return Vec::new() };
    if moving.iter().any(|(other, dots)| *other != id || *dots > 1) || !moving.contains(&(id, 1)) {
        return Vec::new();
    }
    let known: Vec<SymbolId> = symbols(wrong).into_iter().map(|(id, _)| id).collect();
    let is_value = |(id, dots): &(SymbolId, u8)| *dots == 0 && !known.contains(id) && !moves(*id);
    let values = symbols(own).into_iter().filter(is_value).take(TRIED);
    values
        .flat_map(|(value, _)| {
            [0, 1].map(|other| {
                replaced(wrong, &|node| match node {
                    Node::Symbol { id: found, dots, indices } if *found == id && *dots == other => Some(Expr::new(
                        Node::Symbol { id: value, indices: indices.clone(), dots: 0 },
                        Default::default(),
                    )),
                    Node::Symbol { id: found, .. } if *found == id => Some(Expr::integer(0, Default::default())),
                    _ => None,
                })
            })
        })
        .collect()
}

/// The symbols of a reading with their dots, each once.
pub(super) fn symbols(reading: &Reading) -> Vec<(SymbolId, u8)> {
    let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    let mut all: Vec<(SymbolId, u8)> = members.flat_map(Expr::symbols).collect();
    all.sort_unstable();
    all.dedup();
    all
}

fn replaced(reading: &Reading, other: &impl Fn(&Node) -> Option<Expr>) -> Reading {
    let mut reading = reading.clone();
    for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        member.substitute(other);
    }
    reading
}
