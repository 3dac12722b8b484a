//! Small motion about a place of rest that has a name: `\ddot\varepsilon = -\omega^2\sin^2\theta_0\,\varepsilon`, where ε is
//! the small deviation θ − θ_0. A line may say what ε is, or only the words beside it.

use crate::formula::derivative::{Scope, rate};
use crate::formula::{Expr, Node, Relation, Sign, SymbolId, Term};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::meaning::Meaning;

use super::carried::numbers;
use super::given;
use super::special::Special;
use super::status::{Status, approximate, status};
use super::world::World;

/// Whether a line says in linear terms what holds to first order about a place of rest.
pub(super) fn holds(checker: &Checker<'_>, world: &World<'_>, display: usize, reading: &Reading) -> bool {
    let special = &world.problem.special;
    if special.places().is_empty() {
        return false;
    }
    let own: Vec<SymbolId> =
        world.declared.iter().filter_map(|name| Some(checker.model.symbols.find(name)?.0)).collect();
    // The line is about the place if it names it, or a deviation from it; else it is about any motion.
    let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    let places: Vec<SymbolId> =
        special.places().iter().filter_map(|(_, place)| Some(checker.model.symbols.find(place)?.0)).collect();
    let is_about_it = |(id, _): &(SymbolId, u8)| places.contains(id) || own.contains(id);
    if !members.any(|member| member.symbols().iter().any(is_about_it)) {
        return false;
    }
    let of_problem = world.problem.notes.equations.len();
    let said = |text: String| Spanned::new(text, Span::default());
    let small = special.places().iter().map(|(of, place)| said(format!("{of} - {place}")));
    let rates = special.places().iter().map(|(of, _)| said(format!("\\dot{{{of}}}")));
    let claim = Claim {
        assume: special.conditions_of_rest().iter().cloned().map(said).collect(),
        small: small.chain(rates).collect(),
        order: Some(Spanned::new(1, Span::default())),
        ..Claim::default()
    };
    about_places(checker, special, (of_problem, &own), reading).iter().any(|reading| {
        special.is_linear(checker, reading)
            && matches!(status(checker, display, &approximate(reading), &claim), Status::Holds(_))
    })
}

/// What a line with an acceleration says of the coordinates: with definitions of the student's own written out, and with θ − θ_0
/// for a name in `own` that moves and of which no line says what it is. `before` is the number of displays that are the
/// problem's.
pub(super) fn about_places(
    checker: &Checker<'_>,
    special: &Special,
    (before, own): (usize, &[SymbolId]),
    reading: &Reading,
) -> Vec<Reading> {
    let find = |name| Some(checker.model.symbols.find(name)?.0);
    let written_out = |reading: &Reading| {
        let mut reading = reading.clone();
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            *member = given::expanded(checker, before, member.clone());
            with_rates(checker, member);
            given::without_zeros(member);
        }
        reading
    };
    let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    let is_unknown =
        |(id, _): &(SymbolId, u8)| own.contains(id) && matches!(checker.model.meaning(*id), Some(Meaning::Varying(_)));
    let Some((unknown, _)) = members().flat_map(Expr::symbols).find(is_unknown) else {
        return vec![written_out(reading)];
    };
    let places = special.places().iter().filter_map(|(of, place)| Some((find(of)?, find(place)?)));
    let deviation = |(of, place): (SymbolId, SymbolId)| {
        let value = symbol(of).minus(symbol(place));
        let mut reading = reading.clone();
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            member.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, .. } if *id == unknown => Some(value.clone()),
                Node::Symbol { id, dots, .. } if *id == unknown => {
                    Some(Expr::new(Node::TimeDerivative(*dots, Box::new(value.clone())), value.span))
                }
                _ => None,
            });
        }
        written_out(&reading)
    };
    places.map(deviation).collect()
}

/// What a linear equation of motion of a small deviation says of the frequency: with −ω²δ for δ̈, and 1 for δ. The deviation is a name
/// that only the hand-in has. `None`, where the line is no such equation, or the problem asks for no frequency.
pub(super) fn of_the_frequency(checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> Option<Reading> {
    let model = checker.model;
    let [omega] = world.problem.special.frequencies() else { return None };
    let (omega, _) = model.symbols.find(omega)?;
    let mut reading = reading.clone();
    for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        member.substitute(&|node| rate_by_name(checker, node));
    }
    let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    let is_own = |id: SymbolId| world.problem.names.symbols.find(&model.symbols.entry(id).name).is_none();
    let (deviation, _) = members().flat_map(Expr::symbols).find(|(id, dots)| *dots == 2 && is_own(*id))?;
    if members().flat_map(Expr::symbols).any(|(id, dots)| dots == 1 || dots > 0 && id != deviation) {
        return None;
    }
    let span = Span::default();
    let square = Expr::new(Node::Power(Box::new(symbol(omega)), Box::new(Expr::integer(2, span))), span);
    let with = |member: &Expr, size: u32| {
        let mut member = member.clone();
        let moved = Expr::new(Node::Product(vec![Expr::integer(size, span), square.clone()]), span).negated();
        member.substitute(&|node| match node {
            Node::Symbol { id, dots, .. } if *id == deviation => {
                Some(if *dots == 2 { moved.clone() } else { Expr::integer(size, span) })
            }
            _ => None,
        });
        member
    };
    // Twice the deviation makes each side twice as large.
    let free = checker.without_system(false).model;
    let is_linear = members().all(|member| {
        let twice = Expr::new(Node::Product(vec![Expr::integer(2, span), with(member, 1)]), span);
        let link = checker.link(&with(member, 2), Relation::Equal, &twice);
        member.is_null()
            || link.is_ok_and(|link| {
                numbers::holds(checker, &free, &numbers::beside_one(checker, &link), &[]) == Some(true)
            })
    });
    let mut said = reading.clone();
    for member in said.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        *member = with(member, 1);
    }
    is_linear.then_some(said)
}

/// The rate for which a name such as x'' stands.
fn rate_by_name(checker: &Checker<'_>, node: &Node) -> Option<Expr> {
    let Node::Symbol { id, dots: 0, .. } = node else { return None };
    if checker.model.symbols.entry(*id).name.primes == 0 {
        return None;
    }
    match checker.model.meaning(*id) {
        Some(Meaning::Defined(formula)) if matches!(formula.node, Node::Symbol { dots: 1.., .. }) => {
            Some(formula.as_ref().clone())
        }
        _ => None,
    }
}

fn symbol(id: SymbolId) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default())
}

/// Takes the rates in a formula, as far as they are known: the second one of θ − θ_0 is that of θ.
fn with_rates(checker: &Checker<'_>, formula: &mut Expr) {
    formula.children_mut().into_iter().for_each(|child| with_rates(checker, child));
    let Node::TimeDerivative(order, inner) = &formula.node else { return };
    if let Some(rates) = rates_of_terms(checker, inner, *order) {
        *formula = rates;
        return;
    }
    let scope = Scope { symbols: &checker.model.symbols, fixed: &[] };
    let taken = (0..*order).try_fold((**inner).clone(), |of, _| rate(&of, scope, formula.span));
    if let Ok(taken) = taken {
        *formula = taken;
    }
}

/// The rate of a sum, as x − x_0 is, in which only symbols move: these have dots, and what stays falls away.
fn rates_of_terms(checker: &Checker<'_>, formula: &Expr, order: u8) -> Option<Expr> {
    let Node::Sum(terms) = &formula.node else { return None };
    let model = checker.model;
    let moves = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let moving: Vec<SymbolId> = model.symbols.iter().map(|(id, _)| id).filter(|id| moves(*id)).collect();
    let mut rates = Vec::new();
    for term in terms.iter().filter(|term| model.depends_on(&term.expr, &moving)) {
        let Node::Symbol { id, indices, dots } = &term.expr.node else { return None };
        moves(*id).then_some(())?;
        let node = Node::Symbol { id: *id, indices: indices.clone(), dots: dots.saturating_add(order) };
        rates.push(Term { expr: Expr::new(node, term.expr.span), ..term.clone() });
    }
    match rates.as_slice() {
        [] => None,
        [only] if only.sign == Sign::Plus => Some(only.expr.clone()),
        _ => Some(Expr::new(Node::Sum(rates), formula.span)),
    }
}
