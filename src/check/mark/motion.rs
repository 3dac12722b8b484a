//! The motion of the problem: the coordinates as functions of the time, as the model solution prints them.
//!
//! Laws leave initial values open, and the model solution has put them in. So a line may be true that no law implies, as a
//! first integral of a motion that starts from rest is. It is put to the test with the printed functions in the place of
//! the coordinates. For the same reason a function of the time that solves the laws may be false: for other initial values.

use crate::formula::calculus::definite::integral;
use crate::formula::calculus::places::{End, at};
use crate::formula::derivative::{Scope, partial};
use crate::formula::tree::{self, Definite};
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::{Reading, read_formula};
use crate::notes::claims::{Claim, Range};

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::kinds::printed_solution::{Solution, constants_of_integration};
use crate::check::kinds::solution_of_laws;
use crate::check::model::Model;
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;

use super::given::solved_for;
use super::slip;
use super::status::{Status, status};
use super::world::World;
use super::written::instants::{Instant, Kind};

/// The printed functions of the time.
pub(super) struct Motion {
    solutions: Vec<Solution>,
    /// Those of the coordinates that have initial values left to choose.
    chosen: Vec<SymbolId>,
    /// The model in which they define the coordinates, and no law is needed.
    model: Model,
    /// The coordinates and velocities at the start, where a claim of the problem gives them.
    starts: Vec<(SymbolId, u8, Expr)>,
}

/// What a line is along the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Along {
    /// It holds.
    True,
    /// It fails, and nothing in it is free but the constants of the problem.
    False,
    /// It fails, or cannot be put to the test; for other initial values it may hold.
    Open,
}

impl Motion {
    /// The motion that the displays of the problem print, as far as they were checked and hold.
    pub fn of(checker: &Checker<'_>, world: &World<'_>) -> Motion {
        let mut solutions: Vec<Solution> = Vec::new();
        for (reading, verdict) in checker.readings.iter().zip(&world.problem.verdicts) {
            let printed = reading.statements.iter().flatten().filter_map(|statement| printed(checker, statement));
            for found in printed.filter(|found| verdict.holds() && found.dots == 0) {
                if solutions.iter().all(|known| known.coordinate != found.coordinate) {
                    solutions.push(found);
                }
            }
        }
        let mut model = checker.without_system(false).model;
        for known in &solutions {
            model.redefine(known.coordinate, known.formula.clone());
        }
        let is_circular = |known: &Solution| model.depends_on(&known.formula, &[known.coordinate]);
        if solutions.iter().any(is_circular) {
            solutions.clear();
        }
        let is_chosen = |known: &&Solution| !constants_of_integration(known, checker.model).is_empty();
        let starts = starts(checker, &world.problem.contexts);
        // Where a claim gives the values at the start, no constant is left to choose.
        let is_given = |known: &&Solution| {
            let name = checker.model.name(known.coordinate);
            let is_claimed = |dots| starts.iter().any(|(id, order, _)| *id == known.coordinate && *order == dots);
            (0..known.order).all(|dots| is_claimed(dots) || says_the_start(world, &name, dots))
        };
        let is_open = |known: &&Solution| is_chosen(known) && !is_given(known);
        let chosen = solutions.iter().filter(is_open).map(|known| known.coordinate).collect();
        Motion { solutions, chosen, model, starts }
    }

    /// Whether a line prints a function of the time for a coordinate of the motion, in nothing but constants of the problem.
    pub fn is_printed_in(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> bool {
        let mut found = reading.statements.iter().flatten().filter_map(|statement| printed(checker, statement));
        found.any(|own| self.solution(own.coordinate).is_some() && self.leaves_nothing_open(world, &own.formula))
    }

    /// Whether the model solution prints the motion of a coordinate.
    pub fn prints(&self, coordinate: SymbolId) -> bool {
        self.solution(coordinate).is_some()
    }

    /// Whether a link holds along the motion.
    pub fn has(&self, checker: &Checker<'_>, link: &Link) -> bool {
        !self.solutions.is_empty() && super::carried::numbers::holds(checker, &self.model, link, &[]) == Some(true)
    }

    /// The model solution for a coordinate.
    fn solution(&self, coordinate: SymbolId) -> Option<&Solution> {
        self.solutions.iter().find(|known| known.coordinate == coordinate)
    }

    /// A formula with the printed functions in the place of the coordinates, and with definitions written out that contain the
    /// time.
    pub fn inserted(&self, checker: &Checker<'_>, mut formula: Expr) -> Expr {
        for _ in 0..DEEPEST {
            formula.substitute(&|node| {
                let Node::Symbol { id, dots, .. } = node else { return None };
                let value = match checker.model.meaning(*id) {
                    Some(Meaning::Defined(value)) if checker.model.depends_on(value, &self.moving(checker)) => value,
                    _ => &self.solution(*id)?.formula,
                };
                let span = value.span;
                Some(match *dots {
                    0 => value.clone(),
                    dots => Expr::new(Node::TimeDerivative(dots, Box::new(value.clone())), span),
                })
            });
        }
        formula
    }

    /// What a formula is as a function of the time along the motion, with its rates taken; `None`, where it has none.
    pub fn function(&self, checker: &Checker<'_>, formula: &Expr) -> Option<Expr> {
        let mut formula = self.inserted(checker, formula.clone());
        with_rates_taken(checker, &mut formula)?;
        Some(formula)
    }

    /// The motion in which a line says what a coordinate is; `None`, if it does not.
    pub fn with(&self, checker: &Checker<'_>, own: &Reading) -> Option<Motion> {
        let [Ok(statement)] = own.statements.as_slice() else { return None };
        let own = printed(checker, statement).filter(|own| own.dots == 0)?;
        let mut model = self.model.clone();
        model.redefine(own.coordinate, own.formula.clone());
        let mut solutions = self.solutions.clone();
        solutions.retain(|known| known.coordinate != own.coordinate);
        solutions.push(own);
        Some(Motion { solutions, chosen: self.chosen.clone(), model, starts: self.starts.clone() })
    }

    /// Whether a line prints a solution of the laws for a coordinate, or for what is one but for a constant, with constants
    /// that are only said later: `y = A \cos\omega t`. `later` are the names that later lines give a value.
    pub fn is_general(&self, checker: &Checker<'_>, (at, own): (usize, &Reading), later: &[SymbolId]) -> bool {
        let [Ok(statement)] = own.statements.as_slice() else { return false };
        let [first, second] = statement.members.as_slice() else { return false };
        let constants: Vec<SymbolId> =
            second.symbols().into_iter().map(|(id, _)| id).filter(|id| later.contains(id)).collect();
        if constants.is_empty() {
            return false;
        }
        let mut model = checker.model.clone();
        for id in constants {
            model.mean(id, Meaning::Constant(model.constants.len()));
            model.constants.push(Variable::number(id, Range::Any));
        }
        let free = Checker { model: &model, units: None, ..*checker };
        let moves = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
        let definition = first.as_plain_symbol().and_then(|name| model.meaning(name));
        let formula = match definition {
            Some(Meaning::Defined(definition)) => definition.as_ref().clone(),
            _ => first.clone(),
        };
        let Some(id) = formula.symbols().into_iter().map(|(id, _)| id).find(moves) else { return false };
        let Some(value) = solved_for(&free, &formula.minus(second.clone()), (id, 0)) else { return false };
        let coordinate = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, first.span);
        let Ok(link) = free.link(&coordinate, Relation::Equal, &value) else { return false };
        let Some(solution) = Solution::of_link(&link, &model) else { return false };
        let topic = format!("{} solution", shown(&checker.notes.equations[at]));
        let context = context(checker, &model, at, &topic);
        let found = solution_of_laws::by_substitution(&solution, &[], &context).ok().flatten();
        found.is_some_and(|found| found.verdict.holds())
    }

    /// The value at an instant, which has the letters of the problem; `None`, if the motion is not known.
    pub fn value(&self, checker: &Checker<'_>, instant: &Instant) -> Option<Expr> {
        let mut symbols = checker.model.symbols.clone();
        let known = symbols.len();
        let mut read = |text: &str| read_formula(text, &mut symbols, &checker.model.macros).ok();
        let (of, when) = (read(&instant.of)?, read(&instant.when)?);
        let is_known = |formula: &Expr| formula.symbols().iter().all(|(id, _)| id.0 < known);
        if !is_known(&of) || !is_known(&when) {
            return None;
        }
        if let Kind::Of(letter) = &instant.kind {
            let letter = read(letter)?.as_plain_symbol().filter(|letter| letter.0 < known)?;
            let formula = written_out(checker, of);
            let is_constant = |id: SymbolId| matches!(checker.model.meaning(id), Some(Meaning::Constant(_)));
            let symbols = formula.symbols();
            let is_function = symbols.iter().all(|(id, _)| is_constant(*id)) && symbols.contains(&(letter, 0));
            return is_function.then(|| at(&formula, letter, &when));
        }
        let is_time = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Time));
        let time = checker.model.symbols.iter().map(|(id, _)| id).find(is_time)?;
        let mut formula = self.inserted(checker, of);
        differentiated(checker, &mut formula, time)?;
        let moving = self.moving(checker);
        let is_fixed = |(id, dots): &(SymbolId, u8)| {
            let name = Expr::new(Node::Symbol { id: *id, indices: Vec::new(), dots: 0 }, formula.span);
            *dots == 0
                && !checker.model.is_defined_by_itself(*id)
                && (*id == time || !checker.model.depends_on(&name, &moving) && checker.model.meaning(*id).is_some())
        };
        if !formula.symbols().iter().all(is_fixed) {
            return None;
        }
        if instant.kind != Kind::Whole {
            return Some(at(&formula, time, &when));
        }
        let (span, letter) = (formula.span, "u".to_owned());
        let ends = (End::At(Expr::integer(0, span)), End::At(when.clone()));
        if let Ok(whole) = integral(&formula, time, (&ends.0, &ends.1), span) {
            return Some(whole);
        }
        let integrand = at(&formula, time, &Expr::new(Node::Letter(letter.clone()), span));
        let whole = Definite { letter, lower: Some(Expr::integer(0, span)), upper: Some(when), integrand };
        Some(Expr::new(Node::Definite(Box::new(whole)), span))
    }

    /// What a line says of coordinates and velocities at the start, where the motion is known.
    pub fn at_start(&self, checker: &Checker<'_>, reading: &Reading) -> Option<Reading> {
        let is_time = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Time));
        let time = checker.model.symbols.iter().map(|(id, _)| id).find(is_time)?;
        let mut start = reading.clone();
        if self.solutions.is_empty() {
            return self.with_starts(reading, time);
        }
        let known: Vec<SymbolId> = self.solutions.iter().map(|known| known.coordinate).collect();
        let mut is_any = false;
        for member in start.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            let mut value = member.clone();
            if checker.model.depends_on(member, &known) {
                is_any = true;
                value = self.inserted(checker, value);
                differentiated(checker, &mut value, time)?;
            }
            *member = at(&value, time, &Expr::integer(0, member.span));
        }
        is_any.then_some(start)
    }

    /// What a line says of the coordinates and velocities that a claim gives at the start; `None`, if it says something of others.
    fn with_starts(&self, reading: &Reading, time: SymbolId) -> Option<Reading> {
        let mut start = reading.clone();
        let moving: Vec<SymbolId> = self.starts.iter().map(|(id, ..)| *id).collect();
        for member in start.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            member.substitute(&|node| {
                let Node::Symbol { id, dots, .. } = node else { return None };
                let value = self.starts.iter().find(|(known, order, _)| known == id && order == dots);
                value.map(|(.., value)| value.clone())
            });
            *member = at(member, time, &Expr::integer(0, member.span));
        }
        let members = || start.statements.iter().flatten().flat_map(|statement| &statement.members);
        let is_given = !moving.is_empty() && !members().any(|member| self.model.depends_on(member, &moving));
        is_given.then_some(start)
    }

    /// The time and the coordinates.
    fn moving(&self, checker: &Checker<'_>) -> Vec<SymbolId> {
        let all = checker.model.symbols.iter().map(|(id, _)| id);
        all.filter(|id| {
            matches!(checker.model.meaning(*id), Some(Meaning::Time | Meaning::Coordinate(_) | Meaning::Varying(_)))
        })
        .collect()
    }

    /// What a line is along the motion, under the hypotheses of a claim; `is_quick` for a few numbers alone.
    pub fn along(
        &self,
        (checker, world): (&Checker<'_>, &World<'_>),
        (display, reading): (usize, &Reading),
        (claim, is_quick): (&Claim, bool),
    ) -> Along {
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let moves: Vec<SymbolId> = self.solutions.iter().map(|known| known.coordinate).collect();
        if moves.is_empty() || !members().any(|member| checker.model.depends_on(member, &moves)) {
            return Along::Open;
        }
        let there = Checker { model: &self.model, units: checker.units.clone(), ..*checker };
        let holds = match is_quick {
            true => slip::fits(&there, reading),
            false => match status(&there, display, reading, claim) {
                Status::Holds(_) | Status::Given(..) => true,
                Status::False(_) => false,
                Status::Open(..) | Status::Unread(_) => return Along::Open,
            },
        };
        match holds {
            true => Along::True,
            false
                if members().all(|member| self.leaves_nothing_open(world, member))
                    && !members().any(|member| checker.model.depends_on(member, &self.chosen)) =>
            {
                Along::False
            }
            false => Along::Open,
        }
    }

    /// Whether the motion and the constants of the problem give a formula its value.
    fn leaves_nothing_open(&self, world: &World<'_>, formula: &Expr) -> bool {
        formula.symbols().iter().all(|(id, _)| {
            let name = &self.model.symbols.entry(*id).name;
            match self.model.meaning(*id) {
                Some(Meaning::Time) => true,
                Some(Meaning::Constant(_)) => world.problem.names.names.iter().any(|(known, ..)| known == name),
                Some(Meaning::Defined(formula)) => self.leaves_nothing_open(world, formula),
                _ => false,
            }
        })
    }

    /// Whether a false function of the time solves the laws with the false function that a line prints for another coordinate,
    /// as y = ∫ v dt does with a false v.
    pub fn is_carried(&self, checker: &Checker<'_>, (from, at): (usize, usize), own: &Reading) -> bool {
        // In a chain the last member is the function: `y = \int_0^t v \, dt = …`.
        let function = |reading: &Reading| match reading.statements.as_slice() {
            [Ok(statement)] => printed(checker, &ends(statement)?),
            _ => None,
        };
        let (Some(other), Some(own)) = (function(&checker.readings[from]), function(own)) else { return false };
        let topic = format!("{} step", shown(&checker.notes.equations[at]));
        let context = context(checker, checker.model, at, &topic);
        let solves = || solution_of_laws::by_substitution(&own, std::slice::from_ref(&other), &context).ok().flatten();
        own.coordinate != other.coordinate
            && self.starts_alike(checker, &own)
            && solves().is_some_and(|found| found.verdict.holds())
    }

    /// Whether a function of the time begins with the value that the model solution has, or nothing says what that is.
    fn starts_alike(&self, checker: &Checker<'_>, own: &Solution) -> bool {
        let Some(known) = self.solution(own.coordinate).filter(|known| known.dots == own.dots) else { return true };
        let at_first = |formula: &Expr| {
            let mut formula = written_out(checker, formula.clone());
            formula.substitute(&|node| match node {
                Node::Symbol { id, .. } if matches!(checker.model.meaning(*id), Some(Meaning::Time)) => {
                    Some(Expr::integer(0, own.formula.span))
                }
                _ => None,
            });
            formula
        };
        let link = checker.link(&at_first(&own.formula), Relation::Equal, &at_first(&known.formula));
        link.is_ok_and(|link| super::carried::numbers::holds(checker, &self.model, &link, &[]) == Some(true))
    }
}

/// Takes the rates in a formula of the time and constants.
pub(super) fn with_rates_taken(checker: &Checker<'_>, formula: &mut Expr) -> Option<()> {
    let is_time = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Time));
    let time = checker.model.symbols.iter().map(|(id, _)| id).find(is_time)?;
    differentiated(checker, formula, time)
}

/// Takes the rates in a formula of the time.
fn differentiated(checker: &Checker<'_>, formula: &mut Expr, time: SymbolId) -> Option<()> {
    for child in formula.children_mut() {
        differentiated(checker, child, time)?;
    }
    if let Node::TimeDerivative(order, inner) = &formula.node {
        let by = tree::Variable { id: time, indices: Vec::new(), dots: 0 };
        let scope = Scope { symbols: &checker.model.symbols, fixed: &[] };
        let mut rate = (**inner).clone();
        for _ in 0..*order {
            rate = partial(&rate, &by, scope, formula.span).ok()?;
        }
        *formula = rate;
    }
    Some(())
}

/// The first and the last member of a chain of equalities.
fn ends(statement: &Statement) -> Option<Statement> {
    let [first, .., last] = statement.members.as_slice() else { return None };
    let relations = statement.relations[..1].to_vec();
    let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
    is_equal.then(|| Statement { members: vec![first.clone(), last.clone()], relations, ..statement.clone() })
}

/// The function of the time that a statement prints for a coordinate or its rate.
pub(super) fn printed(checker: &Checker<'_>, statement: &Statement) -> Option<Solution> {
    let ([first, second, ..], [(relation, _), ..]) = (statement.members.as_slice(), statement.relations.as_slice())
    else {
        return None;
    };
    Solution::of_link(&checker.link(first, *relation, second).ok()?, checker.model)
}

/// The most definitions that stand within one another.
const DEEPEST: usize = 8;

/// A formula with all definitions written out.
pub(super) fn written_out(checker: &Checker<'_>, mut formula: Expr) -> Expr {
    for _ in 0..DEEPEST {
        formula.substitute(&|node| match node {
            Node::Symbol { id, dots: 0, .. } => match checker.model.meaning(*id) {
                Some(Meaning::Defined(value)) => Some((**value).clone()),
                _ => None,
            },
            _ => None,
        });
    }
    formula
}

/// The context of a line in a model, without hypotheses.
fn context<'c>(checker: &Checker<'_>, model: &'c Model, at: usize, topic: &'c str) -> Context<'c> {
    Context {
        model,
        options: checker.options,
        hypotheses: &[],
        on_shell: None,
        topic,
        span: checker.notes.equations[at].body,
        spread: Spread::Declared,
        local: &[],
    }
}

/// Whether the text of the problem gives a coordinate, or its rate, at the start: `$\dot x(0) = 0$`.
fn says_the_start(world: &World<'_>, name: &str, dots: u8) -> bool {
    let plain = |text: &str| text.replace(['{', '}', '$'], "").split_whitespace().collect::<String>();
    let rate = match dots {
        0 => "",
        1 => "\\dot",
        _ => "\\ddot",
    };
    let start = plain(&format!("{rate}{name}(0)="));
    let notes = &world.problem.notes;
    let mut texts = notes.inline.iter().filter_map(|span| notes.source.text.get(span.range()));
    texts.any(|text| plain(text).starts_with(&start))
}

/// The coordinates and velocities that claims give at the start, `x(0) = x_0`.
fn starts(checker: &Checker<'_>, claims: &[Claim]) -> Vec<(SymbolId, u8, Expr)> {
    let texts = claims.iter().flat_map(|claim| &claim.assume).filter_map(|text| checker.without_start(&text.value));
    let readings = texts.map(|text| checker.as_printed(&text, &Claim::default(), &checker.model.macros));
    let given = |statement: Statement| match statement.members.as_slice() {
        [Expr { node: Node::Symbol { id, dots, .. }, .. }, value] => Some((*id, *dots, value.clone())),
        _ => None,
    };
    readings.flat_map(|reading| reading.statements.into_iter().flatten()).filter_map(given).collect()
}
