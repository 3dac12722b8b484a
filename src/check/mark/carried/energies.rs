//! A false Lagrangian that is T − U with energies of the student's own: then one of these is false. And energies with another zero.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Relation, Sign, SymbolId, Term};
use crate::latex::Reading;
use crate::latex::slips::{self, Pool};
use crate::notes::claims::{Claim, Holds, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::slip::fits;
use crate::check::mark::status::{Status, status};
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::{Meaning, Quantity};

/// Subscripts of E for kinetic and for potential energies.
const KINETIC_SUBSCRIPTS: [&str; 4] = ["k", "c", "kin", "cin"];
const POTENTIAL_SUBSCRIPTS: [&str; 2] = ["p", "pot"];

/// Letters for kinetic and for potential energies.
const KINETIC: [&str; 3] = ["T", "K", "\\mathcal{T}"];
const POTENTIAL: [&str; 5] = ["U", "V", "W", "\\mathcal{V}", "\\Phi"];

/// The display of the energy that makes a Lagrangian false: of those in `own`, each a display that defines a name. `at` is the
/// display with the Lagrangian.
pub(in crate::check::mark) fn false_energy(
    checker: &Checker<'_>,
    (at, reading): (usize, &Reading),
    own: &[usize],
) -> Option<usize> {
    let printed = checker.model.printed_lagrangian.as_ref()?;
    let (lagrangian, _) = checker.model.symbols.find(&printed.lagrangian)?;
    let [Ok(statement)] = reading.statements.as_slice() else { return None };
    let is_it = statement.members.first()?.as_plain_symbol() == Some(lagrangian);
    let last = statement.members.last().filter(|_| is_it)?;
    let named = |at: &usize| {
        let [new] = checker.readings[*at].introduced.as_slice() else { return None };
        matches!(checker.model.meaning(new.symbol), Some(Meaning::Defined(_))).then_some((*at, new.symbol))
    };
    let name = |id: SymbolId| &checker.model.symbols.entry(id).name;
    let defined = |letters: &[&str], others: &[&str]| {
        own.iter().filter_map(named).filter(|(_, id)| is_energy(name(*id), letters, others)).last()
    };
    let pair = (defined(&KINETIC, &KINETIC_SUBSCRIPTS), defined(&POTENTIAL, &POTENTIAL_SUBSCRIPTS));
    // One of several energies, `U_s` and `U_g`, or one beside which the other is not written: the same edit corrects it and the
    // Lagrangian.
    let off = symbol(lagrangian).minus(last.clone());
    let is_false = |(display, id): &(usize, SymbolId)| {
        let base = name(*id).base.as_str();
        let (part, wanted) = match (KINETIC.contains(&base), POTENTIAL.contains(&base)) {
            (true, _) => (symbol(*id), symbol(*id).minus(off.clone().negated())),
            (_, true) => (symbol(*id).negated(), symbol(*id).minus(off.clone())),
            _ => return false,
        };
        !holds(checker, at, &off, &Expr::integer(0, off.span))
            && is_part(checker, reading, last, &part)
            && is_corrected(checker, *display, &wanted)
    };
    let (Some(kinetic), Some(potential)) = pair else {
        return own.iter().filter_map(named).filter(is_false).map(|(display, _)| display).last();
    };
    let difference = symbol(kinetic.1).minus(symbol(potential.1));
    let same = checker.link(&difference, Relation::Equal, last).ok()?;
    if holds(checker, at, &difference, &symbol(lagrangian)) {
        return None;
    }
    if !holds(checker, at, &same.lhs, &same.rhs) {
        return own.iter().filter_map(named).filter(is_false).map(|(display, _)| display).last();
    }
    // The energy that one edit corrects; else the kinetic one, if what it leaves of the Lagrangian has velocities.
    let wanted = |own: SymbolId| match own == kinetic.1 {
        true => symbol(lagrangian).minus(symbol(potential.1).negated()),
        false => symbol(kinetic.1).minus(symbol(lagrangian)),
    };
    let corrected =
        [kinetic, potential].into_iter().find(|(display, id)| is_corrected(checker, *display, &wanted(*id)));
    if let Some((display, _)) = corrected {
        return Some(display);
    }
    let mut left = wanted(potential.1);
    let velocities: Vec<SymbolId> = checker.model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    left.substitute(&|node| match node {
        Node::Symbol { id, dots: 0, .. } => match checker.model.meaning(*id) {
            Some(Meaning::Defined(formula)) => Some((**formula).clone()),
            _ => None,
        },
        _ => None,
    });
    let mut at_rest = left.clone();
    at_rest.substitute(&|node| match node {
        Node::Symbol { id, dots, .. } if *dots > 0 && velocities.contains(id) => {
            Some(Expr::integer(0, Span::default()))
        }
        _ => None,
    });
    Some(if holds(checker, at, &left, &at_rest) { potential.0 } else { kinetic.0 })
}

/// The most terms of a Lagrangian among which an energy is sought.
const TERMS: usize = 7;

/// Whether some terms of a sum are together a formula: the student has put that into it as it stands.
fn is_part(checker: &Checker<'_>, like: &Reading, whole: &Expr, part: &Expr) -> bool {
    let Node::Sum(terms) = &whole.node else { return false };
    let chosen =
        |mask: usize| terms.iter().enumerate().filter(move |(n, _)| mask >> n & 1 == 1).map(|(_, term)| term.clone());
    let sum = |mask: usize| Expr::new(Node::Sum(chosen(mask).collect()), whole.span);
    terms.len() <= TERMS
        && (1..1 << terms.len()).any(|mask| fits(checker, &stating(like, vec![sum(mask), part.clone()])))
}

/// What an energy may be off by, as a factor above and below.
const FACTORS: [(i32, u32); 6] = [(-1, 1), (1, 2), (2, 1), (1, 3), (3, 1), (1, 4)];

/// Whether one edit of the display of an energy makes it what is wanted, or a factor does.
fn is_corrected(checker: &Checker<'_>, display: usize, wanted: &Expr) -> bool {
    let [new] = checker.readings[display].introduced.as_slice() else { return false };
    let off_by = |(above, below): &(i32, u32)| {
        let times = |n: u32, of: Expr| Expr::new(Node::Product(vec![Expr::integer(n, of.span), of]), wanted.span);
        let own = times(above.unsigned_abs(), symbol(new.symbol));
        let sides = vec![if *above < 0 { own.negated() } else { own }, times(*below, wanted.clone())];
        fits(checker, &stating(&checker.readings[display], sides))
    };
    if FACTORS.iter().any(off_by) {
        return true;
    }
    let text = &checker.notes.equations[display].text;
    let Some((name, formula)) = text.split_once('=') else { return false };
    let model = checker.model;
    let edits = slips::corrections(formula, &model.symbols, &model.macros, &Pool::default());
    edits.iter().any(|edit| {
        let new = checker.as_printed(&format!("{name}={}", edit.applied(formula)), &Claim::default(), &model.macros);
        let value = match new.statements.as_slice() {
            [Ok(statement)] if statement.members.len() == 2 => statement.members[1].clone(),
            _ => return false,
        };
        fits(checker, &stating(&new, vec![value, wanted.clone()]))
    })
}

/// Whether a line says that the Lagrangian is the sum of a kinetic and a potential energy of which no line says what they are:
/// whatever they are, the sign is wrong.
pub(in crate::check::mark) fn is_sum_of_energies(checker: &Checker<'_>, reading: &Reading) -> bool {
    let Some(printed) = checker.model.printed_lagrangian.as_ref() else { return false };
    let [Ok(statement)] = reading.statements.as_slice() else { return false };
    let [first, second] = statement.members.as_slice() else { return false };
    let lagrangian = checker.model.symbols.find(&printed.lagrangian).map(|(id, _)| id);
    let Node::Sum(terms) = &second.node else { return false };
    let [a, b] = terms.as_slice() else { return false };
    let unknown = |term: &Term, letters: &[&str], others: &[&str]| {
        term.sign == Sign::Plus
            && term.expr.as_plain_symbol().is_some_and(|id| {
                let is_said = matches!(checker.model.meaning(id), Some(Meaning::Defined(_) | Meaning::System(_)));
                (!is_said || reading.introduced.iter().any(|new| new.symbol == id))
                    && is_energy(&checker.model.symbols.entry(id).name, letters, others)
            })
    };
    let is_pair =
        |a: &Term, b: &Term| unknown(a, &KINETIC, &KINETIC_SUBSCRIPTS) && unknown(b, &POTENTIAL, &POTENTIAL_SUBSCRIPTS);
    lagrangian.is_some() && first.as_plain_symbol() == lagrangian && (is_pair(a, b) || is_pair(b, a))
}

/// Whether a line gives an energy or the Lagrangian a formula that differs from the true one by a constant: the student has put the
/// zero of the potential energy elsewhere. The difference has no rate at all, on motions or off them.
pub(in crate::check::mark) fn has_another_zero(checker: &Checker<'_>, display: usize, reading: &Reading) -> bool {
    let [Ok(statement)] = reading.statements.as_slice() else { return false };
    let ([first, second], false) = (statement.members.as_slice(), statement.constant.is_some()) else { return false };
    let printed = checker.model.printed_lagrangian.as_ref();
    let lagrangian = printed.and_then(|printed| checker.model.symbols.find(&printed.lagrangian)).map(|(id, _)| id);
    let is_meant = first.as_plain_symbol().is_some_and(|id| {
        let energies =
            [Quantity::Lagrangian, Quantity::PotentialEnergy, Quantity::Energy, Quantity::EffectivePotential];
        let is_energy =
            matches!(checker.model.meaning(id), Some(Meaning::System(quantity)) if energies.contains(quantity));
        is_energy || Some(id) == lagrangian
    });
    if !is_meant || !statement.relations.iter().all(|(relation, _)| is_equality(*relation)) {
        return false;
    }
    let difference = second.clone().minus(first.clone());
    let span = difference.span;
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(difference)), span);
    let said = stating(reading, vec![rate, Expr::integer(0, span)]);
    let always = Claim { holds: Some(Spanned::new(Holds::Always, Span::default())), ..Claim::default() };
    matches!(status(checker, display, &said, &always), Status::Holds(_))
}

fn is_energy(name: &Name, letters: &[&str], subscripts: &[&str]) -> bool {
    let sub = name.to_string();
    let sub = sub.split_once('_').map_or("", |(_, sub)| sub).trim_matches(['{', '}']);
    let sub = ["\\mathrm{", "\\text{"].iter().find_map(|style| sub.strip_prefix(*style)).unwrap_or(sub);
    letters.contains(&name.base.as_str()) && (sub.is_empty() || sub == "\\star")
        || name.base == "E" && subscripts.contains(&sub)
}

fn symbol(id: SymbolId) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default())
}

fn stating(like: &Reading, members: Vec<Expr>) -> Reading {
    let statements = like.statements.iter().flatten().take(1).map(|statement| {
        let relations = vec![(Relation::Equal, Span::default())];
        Ok(crate::formula::Statement { members: members.clone(), relations, ..statement.clone() })
    });
    Reading { statements: statements.collect(), introduced: Vec::new() }
}

fn holds(checker: &Checker<'_>, at: usize, left: &Expr, right: &Expr) -> bool {
    let said = stating(&checker.readings[at], vec![left.clone(), right.clone()]);
    matches!(status(checker, at, &said, &Claim::default()), Status::Holds(_))
}
