//! Constants of integration: names that only a printed solution of the motion contains, as θ_0 in `\theta(t) = \theta_0 \cos(…)`.
//!
//! A solution holds for every value of its constants, so nothing need be said of them in a claims file. A name that stands
//! beside the time, as ω does in `\cos\omega t`, is no such constant: its value decides whether the solution is one.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, Node, Statement, SymbolId, Symbols, text};
use crate::latex::{Reading, names, read_display};
use crate::notes::claims::Range;
use crate::source::{Fault, Missing};

use crate::check::document::unreadable::faults;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::{Meaning, Quantity, Variable};

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
    let (mut reading, mut with_introduced) = (reading.clone(), symbols.clone());
    while let Some(name) = missing(&reading) {
        // An upright word, as in \operatorname{erfi}, is a function that is not known here.
        let is_word = |name: &Name| {
            let upright = ["\\mathrm{", "\\operatorname{", "\\text{"];
            let word = upright.iter().find_map(|style| name.base.strip_prefix(style)?.strip_suffix('}'));
            let word = word.unwrap_or(&name.base);
            !word.starts_with('\\') && word.chars().count() > 1
        };
        let Some((name, 0)) = names::parse(&name).filter(|(name, _)| !is_word(name)) else { return false };
        let Some(id) = symbols.add(name, Kind::Scalar).filter(|_| new.len() < MOST) else { return false };
        new.push(id);
        with_introduced = symbols.clone();
        reading = read_display(text, &mut with_introduced, &model.macros);
    }
    if new.is_empty() || reading.introduced.iter().any(|introduced| new.contains(&introduced.symbol)) {
        return false;
    }
    let statements: Option<Vec<&Statement>> =
        reading.statements.iter().map(|statement| statement.as_ref().ok()).collect();
    let Some(statements) = statements else { return false };
    // The parts of a display without a constant of integration say something else: `\omega = \sqrt{g/l}`.
    let has_new = |member: &Expr| member.symbols().iter().any(|(id, _)| new.contains(id));
    let with_new = statements.into_iter().filter(|statement| statement.members.iter().any(has_new));
    let solved: Option<Vec<SymbolId>> =
        with_new.map(|statement| solved_coordinate(statement, &new, &with_introduced, &reading, model)).collect();
    let Some(solved) = solved.filter(|solved| !solved.is_empty()) else { return false };
    let solved: Vec<String> = solved.into_iter().map(|id| text::plain(&model.name(id))).collect();
    let coordinate = solved.join(", ");
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

/// The coordinate that a statement gives as a function of the time, of known constants and of new ones.
fn solved_coordinate(
    statement: &Statement,
    new: &[SymbolId],
    symbols: &Symbols,
    reading: &Reading,
    model: &Model,
) -> Option<SymbolId> {
    let [left, rest @ ..] = statement.members.as_slice() else { return None };
    let coordinate = left.as_plain_symbol().filter(|id| model.is_coordinate(*id))?;
    // `x_1 = -x_3 = f(t)` gives each of them.
    let is_another = |member: &Expr| match &member.node {
        Node::Sum(terms) => matches!(terms.as_slice(), [only] if is_a_coordinate(&only.expr, model)),
        _ => is_a_coordinate(member, model),
    };
    let rest = &rest[rest.iter().take_while(|member| is_another(member)).count()..];
    let is_known = |id: SymbolId| new.contains(&id) || is_known(id, reading, model);
    let fits = |member: &Expr| member.symbols().iter().all(|(id, _)| is_known(*id));
    let all_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
    let in_time = rest.iter().any(|member| contains_time(member, symbols));
    let beside_time = |id: &SymbolId| rest.iter().any(|member| stands_beside_time(member, *id, false, symbols));
    (all_equal && in_time && rest.iter().all(fits) && !new.iter().any(beside_time)).then_some(coordinate)
}

fn is_a_coordinate(member: &Expr, model: &Model) -> bool {
    member.as_plain_symbol().is_some_and(|id| model.is_coordinate(id))
}

/// Whether a symbol is a constant, the time, or defined by these, in the model or by the display itself.
fn is_known(id: SymbolId, reading: &Reading, model: &Model) -> bool {
    let all_known = |formula: &Expr| formula.symbols().iter().all(|(id, _)| is_known(*id, reading, model));
    match model.meaning(id) {
        // A momentum may keep its value. Where it does not, the solution is refuted or not decided.
        Some(Meaning::Constant(_) | Meaning::Time | Meaning::System(Quantity::Momentum(_))) => true,
        Some(Meaning::Defined(formula)) => all_known(formula),
        None => reading.introduced.iter().any(|introduced| introduced.symbol == id && all_known(&introduced.formula)),
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
