//! Constants of integration: names that only a printed solution of the motion contains, as θ_0 in `\theta(t) = \theta_0 \cos(…)`.
//!
//! A solution holds for every value of its constants, so nothing need be said of them in a claims file. A name that stands
//! beside the time, as ω does in `\cos\omega t`, is no such constant: its value decides whether the solution is one.

use crate::formula::{Expr, Kind, Node, SymbolId, Symbols, text};
use crate::latex::{Reading, names, read_display};
use crate::notes::claims::Range;
use crate::source::{Fault, Missing};

use crate::check::document::unreadable::faults;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::{Meaning, Variable};

/// The largest number of constants that a solution adds.
const MOST: usize = 6;

/// Declares the constants of integration of a display that lacks nothing else; returns whether it has some.
pub(crate) fn declare(text: &str, reading: &Reading, model: &mut Model) -> bool {
    let missing = |reading: &Reading| -> Option<String> {
        let names = faults(reading).map(|fault: &Fault| match &fault.missing {
            Some(Missing::Name(name)) => Some(name.clone()),
            _ => None,
        });
        names.collect::<Option<Vec<_>>>()?.into_iter().next()
    };
    let mut symbols = model.symbols.clone();
    let mut new: Vec<SymbolId> = Vec::new();
    let mut reading = reading.clone();
    while let Some(name) = missing(&reading) {
        let Some((name, 0)) = names::parse(&name) else { return false };
        let Some(id) = symbols.add(name, Kind::Scalar).filter(|_| new.len() < MOST) else { return false };
        new.push(id);
        reading = read_display(text, &mut symbols.clone(), &model.macros);
    }
    let is_solution = reading.introduced.is_empty() && reading.statements.len() == 1;
    let Some(Ok(statement)) = reading.statements.first().filter(|_| is_solution && !new.is_empty()) else {
        return false;
    };
    let [left, rest @ ..] = statement.members.as_slice() else { return false };
    let is_coordinate = left.as_plain_symbol().is_some_and(|id| model.is_coordinate(id));
    let fits = |member: &Expr| member.symbols().iter().all(|(id, _)| new.contains(id) || is_known(*id, model));
    let all_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
    let in_time = rest.iter().any(|member| contains_time(member, &symbols));
    let beside_time = |id: &SymbolId| rest.iter().any(|member| stands_beside_time(member, *id, false, &symbols));
    if !is_coordinate || !all_equal || !in_time || !rest.iter().all(fits) || new.iter().any(beside_time) {
        return false;
    }
    let coordinate = left.as_plain_symbol().map(|id| text::plain(&model.name(id))).unwrap_or_default();
    model.symbols = symbols;
    for id in new {
        model.mean(id, Meaning::Constant(model.constants.len()));
        model.constants.push(Variable::number(id, Range::Any));
        let name = text::plain(&model.name(id));
        model
            .inferred
            .push(format!("{name} is a constant of integration, any number, in the solution for {coordinate}"));
    }
    true
}

/// Whether a symbol of the model is a constant, the time, or defined by these.
fn is_known(id: SymbolId, model: &Model) -> bool {
    match model.meaning(id) {
        Some(Meaning::Constant(_) | Meaning::Time) => true,
        Some(Meaning::Defined(formula)) => formula.symbols().iter().all(|(id, _)| is_known(*id, model)),
        _ => false,
    }
}

fn contains_time(formula: &Expr, symbols: &Symbols) -> bool {
    formula.symbols().iter().any(|(id, _)| symbols.time.as_ref() == Some(&symbols.entry(*id).name))
}

/// Whether a symbol is a factor of the time, or divides it, in the argument of a function or in an exponent.
fn stands_beside_time(formula: &Expr, id: SymbolId, within: bool, symbols: &Symbols) -> bool {
    let has_it = |part: &Expr| part.symbols().iter().any(|(other, _)| *other == id);
    let again = |part: &Expr, within: bool| stands_beside_time(part, id, within, symbols);
    let in_time = |part: &Expr| contains_time(part, symbols);
    let meet = |parts: &[&Expr]| {
        within && parts.iter().any(|part| has_it(part) && !in_time(part)) && parts.iter().any(|part| in_time(part))
    };
    match &formula.node {
        Node::Product(factors) => {
            meet(&factors.iter().collect::<Vec<_>>()) || factors.iter().any(|factor| again(factor, within))
        }
        Node::Quotient(above, below) => meet(&[above, below]) || again(above, within) || again(below, within),
        Node::Power(base, exponent) => again(base, within) || again(exponent, true),
        Node::Call(_, argument) => again(argument, true),
        _ => formula.children().into_iter().any(|child| again(child, within)),
    }
}
