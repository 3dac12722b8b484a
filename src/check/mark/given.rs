//! What a line gives that does not follow from the problem: a condition (an initial value, a special state, a number), or
//! a relation that says what a quantity of the student's own is, as m a = m g − F says what F is.

use crate::formula::derivative::{Scope, partial};
use crate::formula::symbols::Name;
use crate::formula::tree::Variable;
use crate::formula::{Expr, Node, Sign, Statement, SymbolId};
use crate::latex::Reading;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;

/// Whether a statement may be a condition: a coordinate, a velocity or a number has a value that nothing here determines.
/// The names in `wanted` are results, and no conditions. Where the text says that it is one (`is_said`), it may say that an
/// acceleration vanishes, as in equilibrium.
pub(super) fn may_be(checker: &Checker<'_>, statement: &Statement, wanted: &[SymbolId], is_said: bool) -> bool {
    let moves = |rate: &Expr| {
        let Node::Symbol { id, .. } = &rate.node else { return false };
        matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)))
    };
    let rests = |rate: &Expr, value: &Expr| is_said && value.is_null() && moves(rate);
    // All of several rates: "at rest $\dot x = \ddot x = 0$".
    if let Some((last, rates)) = statement.members.split_last().filter(|(_, rates)| rates.len() > 1) {
        let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        return is_equal && is_said && last.is_null() && rates.iter().all(moves);
    }
    let ([first, second], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
        return false;
    };
    if !is_equality(*relation) {
        return true;
    }
    sets(checker, first, second, (wanted, is_said))
        || sets(checker, second, first, (wanted, is_said))
        || rests(first, second)
        || rests(second, first)
}

fn sets(checker: &Checker<'_>, name: &Expr, value: &Expr, (wanted, is_said): (&[SymbolId], bool)) -> bool {
    let Node::Symbol { id, dots, .. } = &name.node else { return false };
    let is_free = match checker.model.meaning(*id) {
        Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => *dots <= 1,
        Some(Meaning::Constant(_) | Meaning::Time) => *dots == 0,
        // A quantity that varies may have a value at an instant, as the velocity at the top.
        // The text may give any quantity a number.
        Some(Meaning::Defined(_) | Meaning::System(_)) => {
            let is_number = value.symbols().is_empty();
            varies(checker, name) && (is_number || is_said) || is_number && is_said && !value.is_null()
        }
        _ => false,
    };
    // The time may be said to be an instant of the problem: "if t = t_h".
    // The text may put a coordinate where the problem has a name for the place: "in the middle, x = x_0".
    let moves =
        matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_) | Meaning::Time));
    let is_place = |symbol: SymbolId| {
        let is_fixed = matches!(checker.model.meaning(symbol), Some(Meaning::Constant(_) | Meaning::Defined(_)));
        is_said && moves && *dots == 0 && value.as_plain_symbol() == Some(symbol) && is_fixed
    };
    let is_constant = |(symbol, dots): &(SymbolId, u8)| {
        let is_constant = matches!(checker.model.meaning(*symbol), Some(Meaning::Constant(_)));
        *dots == 0 && (is_constant || is_place(*symbol))
    };
    let symbols = value.symbols();
    let is_wanted = |id: &SymbolId| wanted.contains(id);
    // A result is no condition, but its rate may be said to vanish, as at the top.
    let is_rate = is_said && *dots > 0 && value.is_null();
    let is_open = (!is_wanted(id) || is_rate) && !symbols.iter().any(|(id, _)| is_wanted(id) && !is_place(*id));
    is_free && is_open && symbols.len() <= 1 && symbols.iter().all(is_constant)
}

/// Whether a statement puts what moves at a value that does not change, `v = -g \tau`: a state in which it may be, also if it is
/// wanted as a function of the time. Of another quantity that changes, which is none of the results in `wanted`, the value is one
/// symbol: a formula for an energy says what it is.
pub(super) fn is_special_state(checker: &Checker<'_>, statement: &Statement, wanted: &[SymbolId]) -> bool {
    let is_moving = |id: SymbolId| match checker.model.meaning(id) {
        Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => true,
        Some(Meaning::Defined(formula)) => checker.model.contains_time(formula),
        _ => false,
    };
    let is_fixed = |(id, dots): &(SymbolId, u8)| {
        *dots == 0 && matches!(checker.model.meaning(*id), Some(Meaning::Constant(_) | Meaning::Defined(_)))
    };
    let stays = |value: &Expr| value.symbols().iter().all(is_fixed) && !varies(checker, value);
    let (fixed, changing): (Vec<&Expr>, Vec<&Expr>) = statement.members.iter().partition(|member| stays(member));
    let moves = |member: &&Expr| member.as_plain_symbol().is_some_and(is_moving);
    let is_open = |member: &&Expr| member.as_plain_symbol().is_some_and(|id| !wanted.contains(&id));
    let is_short = || fixed.iter().all(|value| value.symbols().len() <= 1);
    statement.relations.iter().all(|(relation, _)| is_equality(*relation))
        && !fixed.is_empty()
        && !changing.is_empty()
        && (changing.iter().all(moves) || is_short() && changing.iter().all(is_open))
}

/// Whether a statement says that one constant of the problem is another one, as `m_1 = m_2` does. `is_own` tells the names
/// that only the hand-in has.
pub(super) fn compares_constants(
    checker: &Checker<'_>,
    statement: &Statement,
    is_own: impl Fn(SymbolId) -> bool,
) -> bool {
    let is_constant = |member: &Expr| {
        let name = member.as_plain_symbol();
        name.is_some_and(|id| matches!(checker.model.meaning(id), Some(Meaning::Constant(_))) && !is_own(id))
    };
    statement.members.len() == 2
        && statement.members.iter().all(is_constant)
        && statement.relations.iter().all(|(relation, _)| is_equality(*relation))
}

/// Each equality of a line, and the reading that says that what it is off by stays constant, where an initial value may
/// make that 0: for an equality between coordinates, velocities and constants that gives no quantity another value.
/// `before` is the number of displays that are the problem's; names that it does not define are replaced by their formulas.
pub(super) fn up_to_initial_values(
    checker: &Checker<'_>,
    before: usize,
    reading: &Reading,
) -> Vec<(Reading, Option<Reading>)> {
    let [Ok(statement)] = reading.statements.as_slice() else { return Vec::new() };
    if !statement.relations.iter().all(|(relation, _)| is_equality(*relation)) {
        return Vec::new();
    }
    let stating = |members: Vec<Expr>| {
        let relations = statement.relations[..1].to_vec();
        let statement = Statement { members, relations, ..statement.clone() };
        Reading { statements: vec![Ok(statement)], introduced: Vec::new() }
    };
    let rate = |pair: &[Expr]| {
        let difference = expanded(checker, before, pair[0].clone().minus(pair[1].clone()));
        let is_timed = difference.symbols().iter().any(|(id, _)| is_time(checker, *id));
        if !is_timed && pair.iter().any(|side| side.as_plain_symbol().is_some()) {
            return None;
        }
        about_motion(checker, &difference).map(|order| {
            let span = difference.span;
            let rate = Expr::new(Node::TimeDerivative(order, Box::new(difference)), span);
            stating(vec![rate, Expr::integer(0, span)])
        })
    };
    statement.members.windows(2).map(|pair| (stating(pair.to_vec()), rate(pair))).collect()
}

/// Whether a formula has coordinates, velocities and constants, and nothing else: the order of its rate that vanishes if
/// initial values alone decide on it. Of several velocities it is 1, as for a momentum, and of several coordinates 2, as for
/// a center of mass. A single one of these would be given a value, unless it is by the time.
fn about_motion(checker: &Checker<'_>, formula: &Expr) -> Option<u8> {
    let (mut place, mut velocity) = (false, false);
    let timed = formula.symbols().iter().any(|(id, _)| is_time(checker, *id));
    let mut moving: Vec<SymbolId> = Vec::new();
    let is_known = formula.symbols().into_iter().all(|(id, dots)| match checker.model.meaning(id) {
        Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => {
            place |= has_rate(formula, id, 0);
            velocity |= has_rate(formula, id, 1);
            moving.push(id);
            dots <= 1 || timed && dots == 2
        }
        Some(Meaning::Constant(_)) => dots == 0,
        Some(Meaning::Time) => dots == 0,
        Some(Meaning::Defined(_)) => {
            let name = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
            // An acceleration that the laws make constant: `x = \frac12 a t^2`.
            dots == 0 && (timed || !varies(checker, &name))
        }
        _ => false,
    });
    moving.dedup();
    match (place, velocity) {
        _ if !is_known => None,
        // A function of the time: `x = \frac12 a t^2` from rest.
        (true, true) if timed => None,
        (true, false) if timed => Some(2),
        (false, true) if timed => Some(1),
        (true, true) => Some(1),
        (false, true) if moving.len() > 1 => Some(1),
        (true, false) if moving.len() > 1 => Some(2),
        _ => None,
    }
}

fn is_time(checker: &Checker<'_>, id: SymbolId) -> bool {
    matches!(checker.model.meaning(id), Some(Meaning::Time))
}

fn has_rate(formula: &Expr, id: SymbolId, order: u8) -> bool {
    let mut found = false;
    let is_it = |node: &Node| matches!(node, Node::Symbol { id: other, dots, .. } if *other == id && *dots == order);
    formula.walk(&mut |expr| found |= is_it(&expr.node));
    found
}

/// The most definitions that stand within one another.
const DEEPEST: usize = 8;

/// A formula in which the student's own names are replaced by what they stand for.
pub(super) fn expanded(checker: &Checker<'_>, before: usize, mut formula: Expr) -> Expr {
    let of_problem = |id: SymbolId| {
        checker.readings[..before].iter().flat_map(|reading| &reading.introduced).any(|new| new.symbol == id)
    };
    for _ in 0..DEEPEST {
        let mut is_new = false;
        let own: Vec<(SymbolId, Expr)> = formula
            .symbols()
            .into_iter()
            .filter(|(id, _)| !of_problem(*id) && matches!(checker.model.meaning(*id), Some(Meaning::Defined(_))))
            .filter_map(|(id, _)| Some((id, checker.model.symbols.entry(id).definition.as_deref()?.clone())))
            .collect();
        for (id, value) in own {
            is_new = true;
            formula.substitute(&|node| match node {
                Node::Symbol { id: found, dots, .. } if *found == id => Some(rate_of(&value, *dots)),
                _ => None,
            });
        }
        if !is_new {
            break;
        }
    }
    formula
}

/// A formula, or its rate of some order.
fn rate_of(value: &Expr, order: u8) -> Expr {
    match (&value.node, order) {
        (_, 0) => value.clone(),
        (Node::Symbol { id, indices, dots }, _) => {
            Expr::new(Node::Symbol { id: *id, indices: indices.clone(), dots: dots + order }, value.span)
        }
        _ => Expr::new(Node::TimeDerivative(order, Box::new(value.clone())), value.span),
    }
}

/// What a quantity of the student's own is, or its rate, by a relation that is linear in it.
#[derive(Clone, Debug)]
pub(super) struct Implied {
    id: SymbolId,
    dots: u8,
    value: Expr,
}

impl Implied {
    /// What a reading says of a quantity among `own`, the names that only the hand-in has, or among those of the problem that
    /// are left `open` there.
    pub fn by(checker: &Checker<'_>, (own, open): (&[Name], &[SymbolId]), reading: &Reading) -> Option<Implied> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let own = own.iter().filter_map(|name| Some(checker.model.symbols.find(name)?.0));
        let own: Vec<SymbolId> = own.chain(open.iter().copied()).collect();
        let is_free = |id: SymbolId| {
            let is_number = matches!(checker.model.meaning(id), Some(Meaning::Constant(_) | Meaning::Varying(_)));
            own.contains(&id) && is_number || open.contains(&id)
        };
        let links = statement.members.windows(2).zip(&statement.relations);
        links.filter(|(_, (relation, _))| is_equality(*relation)).find_map(|(pair, _)| {
            let difference = pair[0].clone().minus(pair[1].clone());
            let symbols = difference.symbols();
            let mut free = symbols.iter().filter(|(id, _)| is_free(*id));
            free.find_map(|(id, dots)| solved(checker, &difference, (*id, *dots)).or_else(|| below(pair, (*id, *dots))))
        })
    }

    /// What a reading says of one quantity, if it is an equality of two members that is linear in it.
    pub fn of(checker: &Checker<'_>, id: SymbolId, reading: &Reading) -> Option<Implied> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let ([left, right], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
            return None;
        };
        let difference = left.clone().minus(right.clone());
        if is_equality(*relation) { solved(checker, &difference, (id, 0)) } else { None }
    }

    /// The quantity.
    pub fn symbol(&self) -> SymbolId {
        self.id
    }

    /// The name of the quantity.
    pub fn name(&self, checker: &Checker<'_>) -> String {
        checker.model.name(self.id)
    }

    /// The symbols of its value.
    pub fn symbols(&self) -> Vec<(SymbolId, u8)> {
        self.value.symbols()
    }

    /// Whether its value depends on one of some symbols.
    pub fn depends_on(&self, model: &Model, symbols: &[SymbolId]) -> bool {
        self.dots == 0 && model.depends_on(&self.value, symbols)
    }

    /// A reading with the value in the place of the quantity, which it no longer defines then.
    pub fn applied(&self, mut reading: Reading) -> Reading {
        reading.introduced.retain(|new| self.dots > 0 || new.symbol != self.id);
        let other = |node: &Node| match node {
            Node::Symbol { id, dots, .. } if *id == self.id && *dots >= self.dots => {
                Some(rate_of(&self.value, dots - self.dots))
            }
            _ => None,
        };
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            member.substitute(&other);
        }
        reading
    }
}

/// The value of a symbol that is all of a denominator: `\frac{F}{N} = \mu`.
fn below(pair: &[Expr], (id, dots): (SymbolId, u8)) -> Option<Implied> {
    let of = |side: &Expr, other: &Expr| {
        let Node::Quotient(above, under) = &side.node else { return None };
        let has = |formula: &Expr| formula.symbols().iter().any(|(found, _)| *found == id);
        let is_it = under.as_plain_symbol() == Some(id) && dots == 0 && !has(above) && !has(other);
        let value = Node::Quotient(above.clone(), Box::new(other.clone()));
        is_it.then(|| Implied { id, dots, value: Expr::new(value, side.span) })
    };
    of(&pair[0], &pair[1]).or_else(|| of(&pair[1], &pair[0]))
}

/// The value of a symbol, or of its rate, for which a formula that is linear in it vanishes.
fn solved(checker: &Checker<'_>, difference: &Expr, (id, dots): (SymbolId, u8)) -> Option<Implied> {
    Some(Implied { id, dots, value: solved_for(checker, difference, (id, dots))? })
}

/// The same as a formula.
pub(super) fn solved_for(checker: &Checker<'_>, difference: &Expr, (id, dots): (SymbolId, u8)) -> Option<Expr> {
    let variable = Variable { id, indices: Vec::new(), dots };
    // A momentum in the equation is a quantity of its own.
    let is_momentum = |other: &SymbolId| matches!(checker.model.meaning(*other), Some(Meaning::System(_)));
    // So is what the symbol does not go into.
    let is_apart = |other: &SymbolId| {
        let symbol = Expr::new(Node::Symbol { id: *other, indices: Vec::new(), dots: 0 }, difference.span);
        *other != id && !checker.model.depends_on(&symbol, &[id])
    };
    let others = difference.symbols().into_iter().map(|(other, _)| other);
    let fixed: Vec<SymbolId> = others.filter(|other| is_momentum(other) || is_apart(other)).collect();
    let scope = Scope { symbols: &checker.model.symbols, fixed: &fixed };
    let slope = partial(difference, &variable, scope, difference.span).ok()?;
    let mut rest = difference.clone();
    rest.substitute(&|node| match node {
        Node::Symbol { id: found, dots: order, .. } if *found == id && *order == dots => {
            Some(Expr::integer(0, Span::default()))
        }
        _ => None,
    });
    // A rate may stand beside what it is the rate of.
    let has = |formula: &Expr| formula.symbols().iter().any(|(found, order)| *found == id && *order >= dots);
    if slope.is_null() || has(&slope) || has(&rest) {
        return None;
    }
    without_zeros(&mut rest);
    let value = match sign_of_one(&slope) {
        Some(Sign::Plus) => rest.negated(),
        Some(Sign::Minus) => rest,
        None => Expr::new(Node::Quotient(Box::new(rest.negated()), Box::new(slope)), difference.span),
    };
    Some(value)
}

/// The sign of a formula that is 1 or −1.
fn sign_of_one(formula: &Expr) -> Option<Sign> {
    let is_one = |formula: &Expr| matches!(&formula.node, Node::Number(value) if value == "1");
    match &formula.node {
        Node::Sum(terms) => match terms.as_slice() {
            [only] if is_one(&only.expr) => Some(only.sign),
            _ => None,
        },
        _ => is_one(formula).then_some(Sign::Plus),
    }
}

/// Leaves the terms that are a literal 0 out of sums: a claim about small quantities would take each for a term of its own.
pub(super) fn without_zeros(formula: &mut Expr) {
    formula.children_mut().into_iter().for_each(without_zeros);
    let Node::Sum(terms) = &mut formula.node else { return };
    let has_others = terms.iter().any(|term| !term.expr.is_null());
    terms.retain(|term| !has_others || !term.expr.is_null());
    if let [only] = terms.as_slice()
        && only.sign == Sign::Plus
    {
        *formula = only.expr.clone();
    }
}

/// Whether a formula changes with time.
fn varies(checker: &Checker<'_>, formula: &Expr) -> bool {
    let moving = checker.model.symbols.iter().map(|(id, _)| id).filter(|id| {
        matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_) | Meaning::Time))
    });
    checker.model.depends_on(formula, &moving.collect::<Vec<_>>())
}
