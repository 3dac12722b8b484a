//! The energies T and U beside a Lagrangian that is written out.
//!
//! Where L is natural, T is its kinetic and U its potential energy, but for a constant. If one edit lies between them and a print of
//! them, one of the two prints is wrong. The displays that follow from L, or do not, say which.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::kinds::identified;
use crate::check::unaided::contradictions::{contradicted, open, refuted, undecided};
use crate::check::unaided::gate;
use crate::check::unaided::motion::are_equal;
use crate::check::unaided::motion::given::{Given, corrected};
use crate::check::unaided::scope::Scope;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::formula::{Expr, Node, SymbolId};
use crate::source::Span;

/// The letters of the kinetic and of the potential energy.
const KINETIC: [&str; 2] = ["T", "K"];
const POTENTIAL: [&str; 2] = ["U", "V"];

/// Compares T and U with L.
pub(super) fn weighed(checker: &Checker<'_>, scope: &Scope, found: &mut [Equation]) -> Result<()> {
    let model = checker.model;
    let printed = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let is_natural = model.system.as_ref().is_some_and(|system| system.is_natural());
    let (Some((l, _)), true) = (printed, is_natural) else { return Ok(()) };
    let end = scope.carried + found.len();
    let Some(lagrangian) = given(checker, end, &|id| id == l) else { return Ok(()) };
    let is_near =
        |given: &Given| scope.section_of(given.at) == scope.section_of(lagrangian.at) && given.at >= scope.carried;
    let moves = |formula: &Expr| formula.symbols().iter().any(|(_, dots)| *dots > 0);
    let is_one_of = |letters: [&'static str; 2]| {
        move |id: SymbolId| {
            let name = &model.symbols.entry(id).name;
            letters.contains(&name.base.as_str()) && name.subscript.is_empty()
        }
    };
    let kinetic = given(checker, end, &is_one_of(KINETIC)).filter(|given| is_near(given) && moves(&given.formula));
    let potential = given(checker, end, &is_one_of(POTENTIAL)).filter(|given| is_near(given) && !moves(&given.formula));
    // `L = T - U` prints nothing twice.
    let used = gate::names(&lagrangian.formula, model);
    if !is_near(&lagrangian) || [&kinetic, &potential].into_iter().flatten().any(|given| used.contains(&given.id)) {
        return Ok(());
    }
    let Some([of_kinetic, of_potential]) = identified::energies(model) else { return Ok(()) };
    let pairs = [(&kinetic, of_kinetic), (&potential, of_potential)];
    let mut differing = Vec::new();
    for (given, quantity) in pairs.iter().filter_map(|(given, quantity)| Some((given.as_ref()?, quantity))) {
        if !is_constant(checker, &quantity.clone().minus(given.formula.clone()))? {
            differing.push((given, quantity));
        }
    }
    let [(energy, quantity)] = differing.as_slice() else { return Ok(()) };
    let of_energy =
        corrected(checker, energy, &|_| true, &|formula| is_constant(checker, &(*quantity).clone().minus(formula)))?;
    let of_lagrangian = match (&kinetic, &potential) {
        (Some(kinetic), Some(potential)) => {
            let difference = |formula: Expr| formula.minus(kinetic.formula.clone().minus(potential.formula.clone()));
            corrected(checker, &lagrangian, &|_| true, &|formula| is_constant(checker, &difference(formula)))?
        }
        _ => None,
    };
    decide(checker, scope.carried, (&lagrangian, of_lagrangian), (energy, of_energy), found);
    Ok(())
}

/// Says which of the Lagrangian and an energy is wrong, each with the edit that makes them agree, if there is one.
fn decide(
    checker: &Checker<'_>,
    first: usize,
    (lagrangian, of_lagrangian): (&Given, Option<Repair>),
    (energy, of_energy): (&Given, Option<Repair>),
    found: &mut [Equation],
) {
    let (at, of) = (lagrangian.at - first, energy.at - first);
    let is_open = |equation: &Equation| equation.finding.verdict == Verdict::Definition;
    if !is_open(&found[at]) || !is_open(&found[of]) {
        return;
    }
    let moves = |place: usize| {
        let members = checker.readings[first + place].statements.iter().flatten().flat_map(|one| &one.members);
        let mut names = members.flat_map(|member| gate::names(member, checker.model));
        names.any(|id| checker.model.coordinates.iter().any(|coordinate| coordinate.symbol == id))
    };
    let others: Vec<usize> = (0..found.len()).filter(|place| ![at, of].contains(place) && moves(*place)).collect();
    let has = |verdicts: &[Verdict]| others.iter().any(|place| verdicts.contains(&found[*place].finding.verdict));
    let (is_confirmed, is_contradicted) = (has(&[Verdict::Certified, Verdict::Verified]), has(&[Verdict::Refuted]));
    let (name, other) = (found[at].id.clone(), found[of].id.clone());
    let is_followed = follows_in_each_coordinate(checker, first, &energy.formula, found);
    match (of_lagrangian, of_energy, is_confirmed, is_contradicted) {
        (Some(repair), _, false, true) => {
            found[at] = refuted(
                &found[at],
                &repair,
                format!("this is not T − U with the energies of ({other}), and other displays contradict it"),
            );
        }
        (_, Some(repair), true, false) if is_followed => {
            let message = format!("this is not the energy in ({name}), from which other displays follow");
            found[of] = refuted(&found[of], &repair, message);
        }
        (of_lagrangian, of_energy, _, is_contradicted) => {
            let Some(repair) = of_energy.or(of_lagrangian) else { return };
            // What contradicts L may be right, since L may be wrong.
            for place in others.into_iter().filter(|_| is_contradicted) {
                if found[place].finding.verdict == Verdict::Refuted {
                    let message = format!(
                        "this does not follow from ({name}); ({name}) may be wrong, because ({other}) contradicts it"
                    );
                    found[place] = undecided(&found[place], message);
                }
            }
            found[of] = open(&found[of], &name, repair);
            found[at] = contradicted(&found[at], &other);
        }
    }
}

/// Whether an equation of motion that follows from L is printed for each coordinate of an energy. Then L has this energy as it should.
fn follows_in_each_coordinate(checker: &Checker<'_>, first: usize, energy: &Expr, found: &[Equation]) -> bool {
    let follows = |place: usize, q: SymbolId| {
        let finding = &found[place].finding;
        let is_on_shell = finding.verdict.passes() && finding.message.contains("on shell");
        let members = checker.readings[first + place].statements.iter().flatten().flat_map(|one| &one.members);
        is_on_shell && members.flat_map(Expr::symbols).any(|(id, dots)| id == q && dots > 1)
    };
    let names = gate::names(energy, checker.model);
    let mut coordinates = checker.model.coordinates.iter().map(|coordinate| coordinate.symbol);
    coordinates.all(|q| !names.contains(&q) || (0..found.len()).any(|place| follows(place, q)))
}

/// The only display with a formula for a name of some kind.
fn given(checker: &Checker<'_>, end: usize, is_it: &dyn Fn(SymbolId) -> bool) -> Option<Given> {
    let displays = checker.readings.iter().enumerate().take(end);
    let all = displays.flat_map(|(at, reading)| reading.introduced.iter().map(move |new| (at, new)));
    let mut found = all.filter(|(_, new)| new.member == 0 && is_it(new.symbol));
    let (at, new) = found.next()?;
    found.next().is_none().then(|| Given { at, id: new.symbol, formula: new.formula.clone() })
}

/// Whether a formula is constant for any motion.
fn is_constant(checker: &Checker<'_>, formula: &Expr) -> Result<bool> {
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(formula.clone())), Span::default());
    are_equal(checker, &rate, &Expr::integer(0, Span::default()), false)
}
