//! What a line may speak of without saying so: the instant at which a speed of the problem is reached, a place of rest, and
//! small motion about rest.

use std::collections::HashMap;

use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::rename::renamed;
use crate::latex::{Reading, names};
use crate::notes::claims::{Claim, Claims, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::meaning::Meaning;

use super::status::{Status, approximate, status};

/// The special states of a problem.
#[derive(Clone, Debug, Default)]
pub(super) struct Special {
    /// What moves.
    moving: Vec<Name>,
    /// Constant speeds, where one length moves: `v_1`, the value of `\dot y` at some instant.
    speeds: Vec<Name>,
    /// Constants without which the laws are, but not the speeds: the way to the instant of a speed.
    ways: Vec<Name>,
    /// Places of rest that have a name, each with the coordinate.
    places: Vec<(Name, Name)>,
    /// Values that a coordinate keeps while others move, as the radius of a circle.
    steady: Vec<(Name, Name)>,
    /// Values that a velocity keeps beside them, as the angular velocity on a circle.
    turning: Vec<(Name, Name)>,
    /// What makes them places of rest, as LaTeX.
    conditions_of_rest: Vec<String>,
    /// Whether the problem asks for small oscillations.
    has_modes: bool,
    /// Whether it asks for small oscillations about a place that has a name.
    has_modes_at_places: bool,
    /// The names of these frequencies.
    frequencies: Vec<Name>,
}

impl Special {
    /// Those of a problem, in which each claim has the number of its equation as address.
    pub fn of(checker: &Checker<'_>, claims: &Claims) -> Special {
        let model = checker.model;
        let is_moving = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
        let moving: Vec<SymbolId> = model.symbols.iter().map(|(id, _)| id).filter(|id| is_moving(*id)).collect();
        let is_speed = |id: &SymbolId| {
            let is_named = ["v", "u", "w", "V"].contains(&model.symbols.entry(*id).name.base.as_str());
            let formula = match model.meaning(*id) {
                Some(Meaning::Defined(formula)) => formula,
                _ => return false,
            };
            is_named && !model.depends_on(formula, &moving) && !model.contains_time(formula)
        };
        let is_length = matches!(moving.as_slice(), [only] if !model.symbols.entry(*only).angle);
        let speeds: Vec<SymbolId> =
            model.symbols.iter().map(|(id, _)| id).filter(|id| is_length && is_speed(id)).collect();
        let laws = || model.laws.iter().flat_map(|law| &law.hypotheses).flat_map(|law| [&law.lhs, &law.rhs]);
        let is_way = |id: &SymbolId| {
            let symbol = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
            let is_constant = matches!(model.meaning(*id), Some(Meaning::Constant(_)));
            let in_speed = || speeds.iter().any(|speed| model.depends_on(&symbol(*speed), &[*id]));
            is_constant && in_speed() && laws().next().is_some() && !laws().any(|side| model.depends_on(side, &[*id]))
        };
        let ways = model.symbols.iter().map(|(id, _)| id).filter(is_way);
        let name = |id: SymbolId| model.symbols.entry(id).name.clone();
        let at =
            claims.equations.iter().filter(|(_, claim)| claim.equilibrium.is_some()).flat_map(|(_, claim)| &claim.at);
        let parsed = |text: &Spanned<String>| Some(names::parse(&text.value)?.0);
        let rests = |claim: &Claim| claim.equilibrium.is_some() && !claim.at.is_empty();
        let numbers = claims.equations.iter().filter(|(_, claim)| rests(claim)).map(|(address, _)| &address.text);
        let displays = &checker.notes.equations;
        let display = |number: &String| displays.iter().find(|display| display.id() == Some(number.as_str()));
        let is_asked = |what: &str| claims.means.iter().any(|(_, meaning)| meaning.value.starts_with(what));
        let is_coordinate = |name: &Name| model.symbols.find(name).is_some_and(|(id, _)| is_moving(id));
        let equality = |text: &str| {
            let (of, place) = text.split_once('=')?;
            let (of, dots) = names::parse(of.trim())?;
            let (place, _) = names::parse(place.trim())?;
            (is_coordinate(&of) && !is_coordinate(&place)).then_some((of, dots, place))
        };
        let always = claims.equations.iter().flat_map(|(_, claim)| &claim.throughout);
        let about = claims.means.iter().filter_map(|(_, meaning)| Some(meaning.value.split_once(" about ")?.1));
        let is_frequency = |meaning: &str| meaning.starts_with("frequency of small oscillations");
        let frequencies = claims.means.iter().filter(|(_, meaning)| is_frequency(&meaning.value));
        let (mut steady, mut turning) = (Vec::new(), Vec::new());
        for (of, dots, place) in always.map(|text| text.value.as_str()).chain(about).filter_map(equality) {
            match dots {
                0 => steady.push((of, place)),
                1 => turning.push((of, place)),
                _ => {}
            }
        }
        Special {
            steady,
            turning,
            frequencies: frequencies.filter_map(|(name, _)| parsed(name)).collect(),
            conditions_of_rest: numbers.filter_map(display).map(|display| display.text.clone()).collect(),
            has_modes_at_places: is_asked("frequency of small oscillations"),
            ways: ways.map(name).collect(),
            speeds: speeds.iter().copied().map(name).collect(),
            moving: moving.into_iter().map(name).collect(),
            places: at.filter_map(|(of, place)| Some((parsed(of)?, parsed(place)?))).collect(),
            has_modes: claims.means.iter().any(|(_, meaning)| meaning.value == "normal frequency"),
        }
    }

    /// The speed at whose instant a line holds.
    pub fn speed(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> Option<&Name> {
        let [moving] = self.moving.as_slice() else { return None };
        let (id, _) = checker.model.symbols.find(moving)?;
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        if !members().any(|member| checker.model.depends_on(member, &[id])) {
            return None;
        }
        self.speeds.iter().find(|speed| {
            let claim = Claim { assume: vec![said(format!("\\dot{{{moving}}} = {speed}"))], ..Claim::default() };
            matches!(status(checker, display, reading, &claim), Status::Holds(_))
        })
    }

    /// A reading in which the velocity is a speed of the problem.
    pub fn at_speed(&self, checker: &Checker<'_>, mut reading: Reading, speed: &Name) -> Reading {
        let find = |name: &Name| Some(checker.model.symbols.find(name)?.0);
        let (Some(speed), Some(moving)) = (find(speed), self.moving.first().and_then(find)) else { return reading };
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            let span = member.span;
            member.substitute(&|node| match node {
                Node::Symbol { id, dots: 1, .. } if *id == moving => {
                    Some(Expr::new(Node::Symbol { id: speed, indices: Vec::new(), dots: 0 }, span))
                }
                _ => None,
            });
        }
        reading
    }

    /// A reading that says of the coordinate and its velocity what it says of the way and the speed at an instant; `None`, if it
    /// speaks of neither.
    pub fn at_all_times(&self, checker: &Checker<'_>, reading: &Reading) -> Option<Reading> {
        let [moving] = self.moving.as_slice() else { return None };
        let find = |name: &Name| Some(checker.model.symbols.find(name)?.0);
        let (moving, mut any) = (find(moving)?, false);
        let ids = |names: &[Name]| -> Vec<SymbolId> { names.iter().filter_map(find).collect() };
        let (ways, speeds) = (ids(&self.ways), ids(&self.speeds));
        let mut reading = reading.clone();
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            any |= member.symbols().iter().any(|(id, _)| ways.contains(id) || speeds.contains(id));
            let span = member.span;
            let rate = |dots| Some(Expr::new(Node::Symbol { id: moving, indices: Vec::new(), dots }, span));
            member.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, .. } if ways.contains(id) => rate(0),
                Node::Symbol { id, dots: 0, .. } if speeds.contains(id) => rate(1),
                _ => None,
            });
        }
        any.then_some(reading)
    }

    /// Places of rest that have a name, each with the coordinate.
    pub fn places(&self) -> &[(Name, Name)] {
        &self.places
    }

    /// The places of rest, and values that a coordinate keeps while others move, each with the coordinate.
    pub fn kept(&self) -> impl Iterator<Item = &(Name, Name)> {
        self.places.iter().chain(self.steady.iter().filter(|kept| !self.places.contains(kept)))
    }

    /// Values that velocities keep, each with the coordinate.
    pub fn turning(&self) -> &[(Name, Name)] {
        &self.turning
    }

    /// What makes them places of rest, as LaTeX.
    pub fn conditions_of_rest(&self) -> &[String] {
        &self.conditions_of_rest
    }

    /// The names of frequencies of small oscillations about a place.
    pub fn frequencies(&self) -> &[Name] {
        &self.frequencies
    }

    /// Whether the problem asks for small oscillations about a place that has a name.
    pub fn has_modes_at_places(&self) -> bool {
        self.has_modes_at_places
    }

    /// Whether a line says in linear terms what holds for small motion. `is_said` if the text speaks of it.
    pub fn is_linearized(&self, checker: &Checker<'_>, display: usize, reading: &Reading, is_said: bool) -> bool {
        (self.has_modes || is_said)
            && self.is_linear(checker, reading)
            && self.holds_when_small(checker, display, reading)
    }

    /// Whether a line has an acceleration or ≈, and what moves in no function.
    pub fn is_linear(&self, checker: &Checker<'_>, reading: &Reading) -> bool {
        let find = |name: &Name| Some(checker.model.symbols.find(name)?.0);
        let moving: Vec<SymbolId> = self.moving.iter().filter_map(find).collect();
        let statements = || reading.statements.iter().flatten();
        let members = || statements().flat_map(|statement| &statement.members);
        let has_acceleration =
            |member: &Expr| member.symbols().iter().any(|(id, dots)| moving.contains(id) && *dots == 2);
        let mut is_linear = true;
        members().for_each(|member| {
            member.walk(&mut |part| {
                if let Node::Call(_, inner) = &part.node {
                    is_linear &= !checker.model.depends_on(inner, &moving);
                }
            });
        });
        let is_near = |relation: &(Relation, Span)| relation.0 == Relation::Approximately;
        is_linear && (members().any(has_acceleration) || statements().any(|s| s.relations.iter().any(is_near)))
    }

    /// Whether a line holds to first order in all that moves.
    pub fn holds_when_small(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> bool {
        let small: Vec<Spanned<String>> = self.moving.iter().map(|name| said(name.to_string())).collect();
        let claim = Claim { small, order: Some(Spanned::new(1, Span::default())), ..Claim::default() };
        !self.moving.is_empty() && matches!(status(checker, display, &approximate(reading), &claim), Status::Holds(_))
    }

    /// Whether a line says where a coordinate is at rest, in numbers: `\sin\theta_0 = 0`, beside the place that the problem
    /// asks for. `text` is the line.
    pub fn is_rest(&self, checker: &Checker<'_>, display: usize, (text, reading): (&str, &Reading)) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let symbols: Vec<(SymbolId, u8)> = statement.members.iter().flat_map(Expr::symbols).collect();
        let name = |id: SymbolId| &checker.model.symbols.entry(id).name;
        let place = |(of, place): &(Name, Name)| {
            symbols
                .iter()
                .all(|(id, dots)| *dots == 0 && (name(*id) == place || name(*id) == of))
                .then(|| (of.clone(), place.clone()))
        };
        let Some((of, place)) = self.places.iter().find_map(place).filter(|_| !symbols.is_empty()) else {
            return false;
        };
        let macros = &checker.model.macros;
        let there = renamed(text, macros, &HashMap::from([(place, of)])).text;
        let rests = self.moving.iter().map(|name| said(format!("\\dot{{{name}}} = 0")));
        let claim = Claim { assume: std::iter::once(said(there)).chain(rests).collect(), ..Claim::default() };
        self.moving.iter().all(|name| {
            let rests = checker.as_printed(&format!("\\ddot{{{name}}} = 0"), &Claim::default(), macros);
            matches!(status(checker, display, &rests, &claim), Status::Holds(_))
        })
    }
}

/// Whether the hypotheses of a claim say what an acceleration in a reading is: the line then says less than it seems to.
pub(super) fn is_degenerate(checker: &Checker<'_>, claim: &Claim, reading: &Reading) -> bool {
    // The acceleration of what is defined by a coordinate is one of the coordinate.
    let defined = |(id, dots): (SymbolId, u8)| match checker.model.meaning(id) {
        Some(Meaning::Defined(formula)) => {
            let of_formula = formula.symbols().into_iter().map(|(id, more)| (id, dots + more));
            std::iter::once((id, dots)).chain(of_formula).collect::<Vec<_>>()
        }
        _ => vec![(id, dots)],
    };
    let members = |reading: &Reading| -> Vec<(SymbolId, u8)> {
        let all = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        all.flat_map(Expr::symbols).flat_map(defined).filter(|(_, dots)| *dots > 1).collect()
    };
    let own = members(reading);
    let read = |text: &Spanned<String>| checker.as_printed(&text.value, &Claim::default(), &checker.model.macros);
    let says_a_rate =
        !own.is_empty() && claim.assume.iter().any(|text| members(&read(text)).iter().any(|rate| own.contains(rate)));
    says_a_rate || claim.throughout.iter().any(|text| is_at_rest(checker, &read(text), reading))
}

/// Whether a hypothesis, as `r = r_0` at all times, puts a coordinate in a place, and a reading with a rate of the coordinate is
/// about any motion. That the rate is 0 is about this one.
fn is_at_rest(checker: &Checker<'_>, hypothesis: &Reading, reading: &Reading) -> bool {
    let [Ok(said)] = hypothesis.statements.as_slice() else { return false };
    let fixed: Vec<(SymbolId, u8)> = said
        .members
        .iter()
        .filter_map(|member| match &member.node {
            Node::Symbol { id, dots, .. } if checker.model.is_coordinate(*id) => Some((*id, *dots)),
            _ => None,
        })
        .collect();
    let has_rate = |member: &Expr| {
        let mut symbols = member.symbols().into_iter();
        symbols.any(|(id, dots)| fixed.iter().any(|(known, order)| *known == id && dots > *order))
    };
    let is_zero = |statement: &Statement| {
        let is_lone = |member: &Expr| member.is_null() || matches!(member.node, Node::Symbol { .. });
        statement.members.iter().any(Expr::is_null) && statement.members.iter().all(is_lone)
    };
    let statements = reading.statements.iter().flatten().filter(|statement| !is_zero(statement));
    said.members.len() == 2 && statements.flat_map(|statement| &statement.members).any(has_rate)
}

fn said(text: String) -> Spanned<String> {
    Spanned::new(text, Span::default())
}
