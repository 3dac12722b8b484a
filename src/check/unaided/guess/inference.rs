//! The claims file that is inferred for notes: what varies, what is constant, what is an angle or positive, which
//! functions there are, and which name is the Lagrangian.
//!
//! Every guess comes from how a name stands in the displays. A name that a display defines is not declared. What is
//! still missing after that is declared as a number and the displays are read again.

use crate::Result;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Node};
use crate::latex::Macros;
use crate::notes::{Claims, Display, Notes};
use crate::source::{Missing, Span};

use crate::check::document::checker::Checker;
use crate::check::document::setup::{Run, define_macros, with_checker};
use crate::check::document::unreadable::faults;
use crate::check::model::Model;
use crate::check::model::meaning::Variable;
use crate::check::unaided::guess::declarations::{Formula, Guess};
use crate::check::unaided::guess::lagrangian;
use crate::check::unaided::guess::letters;
use crate::check::unaided::guess::order::names_in_order;
use crate::check::unaided::guess::values;
use crate::check::unaided::ordered::{self, Ordered};
use crate::check::usage::{Usage, names_of};

/// How often the displays are read again with the names that were missing.
const ROUNDS: usize = 12;

/// Of this many displays one may be lost where letters are read as vectors and matrices.
const LOST: usize = 3;

/// The claims that are inferred for notes.
///
/// # Errors
/// When not even a claims file without declarations fits the notes.
pub(crate) fn claims(run: &Run<'_>, notes: &Notes) -> Result<Claims> {
    claims_with(run, notes, &[])
}

/// The same where some names have formulas that the notes give them, though no display defines these.
///
/// # Errors
/// When not even a claims file without declarations fits the notes.
pub(crate) fn claims_with(run: &Run<'_>, notes: &Notes, formulas: &[Formula]) -> Result<Claims> {
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let mut usages = names_in_order(notes, &macros);
    let is_constant = |usage: &Usage| !usage.moves && letters::is_said_to_be_constant(notes, &usage.name);
    usages.iter_mut().filter(|usage| usage.follows).for_each(|usage| usage.follows = !is_constant(usage));
    usages.retain(|usage| !formulas.iter().any(|formula| formula.name == usage.name));
    let known = (usages.as_slice(), formulas);
    let lagrangian = lagrangian::of(notes, &usages, &macros);
    let ordered = ordered::letters(notes, &macros);
    let plain = by_letters(run, notes, (&macros, known), lagrangian, &[])?;
    if ordered.is_empty() {
        return Ok(plain);
    }
    // What stands for vectors or matrices in one display may stand for numbers in another one, which could not be read then. A
    // few that cannot be read may be wrong.
    let with_letters = by_letters(run, notes, (&macros, known), lagrangian, &ordered)?;
    let is_about = |usage: &&Usage| ordered.iter().any(|letter| letter.name == usage.name);
    let count =
        |display: &Display| names_of(std::slice::from_ref(display), &macros).iter().any(|usage| is_about(&usage));
    let lost = unread(run, notes, &with_letters).saturating_sub(unread(run, notes, &plain));
    let is_better = LOST * lost <= notes.equations.iter().filter(|display| count(display)).count();
    Ok(if is_better { with_letters } else { plain })
}

/// The number of displays that cannot be read with some claims.
fn unread(run: &Run<'_>, notes: &Notes, claims: &Claims) -> usize {
    let count =
        |checker: Checker<'_>| Ok(checker.readings.iter().filter(|reading| faults(reading).next().is_some()).count());
    with_checker(run, claims, notes, count).unwrap_or(usize::MAX)
}

/// The claims where some letters stand for vectors and matrices.
fn by_letters(
    run: &Run<'_>,
    notes: &Notes,
    (macros, (usages, formulas)): (&Macros, (&[Usage], &[Formula])),
    lagrangian: Option<&Name>,
    ordered: &[Ordered],
) -> Result<Claims> {
    for printed in [lagrangian, None] {
        let inside = printed.and_then(|name| usages.iter().find(|usage| usage.name == *name)?.introduced);
        let inside = inside.and_then(|at| notes.equations.get(at)).map(std::slice::from_ref).unwrap_or_default();
        let inside: Vec<Name> = names_of(inside, macros).into_iter().map(|usage| usage.name).collect();
        let mut whole = Guess::of(usages, (printed, &inside), ordered);
        formulas.iter().for_each(|formula| whole.define(&formula.name.to_string(), &formula.latex));
        if letters::has_both_constants_of_planck(notes, usages) {
            whole = whole.without("constants", &["\\hbar".to_owned()]);
            whole.define("\\hbar", "\\frac{h}{2\\pi}");
        }
        if letters::means_root_of_minus_one(notes, usages, macros) {
            whole.declare("constants", "i", "imaginary unit");
        }
        // A function of a name that a display defines cannot be declared. It must not take all other guesses with it.
        let functions = whole.names("functions");
        let one_less = functions.iter().map(|name| whole.without("functions", std::slice::from_ref(name)));
        let none = (!functions.is_empty()).then(|| whole.without("functions", &functions));
        for guess in std::iter::once(whole.clone()).chain(one_less).chain(none) {
            if let Some(best) = completed(run, notes, guess, (macros, usages))? {
                return Ok(best);
            }
        }
    }
    Guess::default().claims(notes)
}

/// The claims of a guess, to which the names are added that the displays lack, and then the formulas that stand for one
/// name; `None`, if the guess does not fit the notes.
fn completed(
    run: &Run<'_>,
    notes: &Notes,
    mut guess: Guess,
    (macros, usages): (&Macros, &[Usage]),
) -> Result<Option<Claims>> {
    let mut best = None;
    let directions = letters::hats_are_directions(notes);
    for _ in 0..ROUNDS {
        let claims = guess.claims(notes)?;
        let look = |checker: Checker<'_>| {
            let values = values::values(checker.readings, notes, macros, usages);
            let misshapen = values::misshapen(checker.readings, notes, &checker.model.macros);
            let lacking: Vec<bool> = checker.readings.iter().map(lacks_a_name).collect();
            Ok((missing(checker.readings), lacking, foreign(checker.model), values, misshapen))
        };
        let Ok((missing, lacking, foreign, values, misshapen)) = with_checker(run, &claims, notes, look) else {
            // Differentials that are no rates here are quantities of their own.
            if guess.without_rates() {
                continue;
            }
            break;
        };
        best = Some(claims);
        // What a display gives a formula is declared only if that display does not become readable otherwise.
        let is_given = |name: &String| usages.iter().any(|usage| usage.given && usage.name.to_string() == *name);
        let (mut given, others): (Vec<String>, Vec<String>) = missing.into_iter().partition(is_given);
        given.retain(|name| !guess.declares(name));
        let is_new = guess.add(&others, directions);
        let goes_on = guess.release(&foreign)
            || is_new
            || guess.take_given(&given)
            || guess.take_given(&others)
            || guess.add_values(&values)
            || guess.reshape(&misshapen)
            || guess.add(&first_of(&given, usages, &lacking), directions)
            || guess.add(&given, directions);
        if !goes_on {
            break;
        }
    }
    Ok(best)
}

/// Those of the names with a formula that are the first to be declared: their displays cannot be read for another reason than
/// a missing name. What lacks only these may be read with them.
fn first_of(given: &[String], usages: &[Usage], lacking: &[bool]) -> Vec<String> {
    let is_first = |name: &&String| {
        let usage = usages.iter().find(|usage| usage.name.to_string() == **name);
        usage.and_then(|usage| usage.introduced).and_then(|at| lacking.get(at)).is_none_or(|lacks| !lacks)
    };
    let first: Vec<String> = given.iter().filter(is_first).cloned().collect();
    if first.is_empty() { given.iter().take(1).cloned().collect() } else { first }
}

/// Whether a display cannot be read for lack of a name.
fn lacks_a_name(reading: &crate::latex::Reading) -> bool {
    faults(reading).any(|fault| matches!(fault.missing, Some(Missing::Name(_))))
}

/// The coordinates that the Lagrangian of the notes does not contain.
fn foreign(model: &Model) -> Vec<String> {
    let printed = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let Some((id, _)) = printed else { return Vec::new() };
    let lagrangian = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
    let is_foreign = |coordinate: &&Variable| !model.depends_on(&lagrangian, &[coordinate.symbol]);
    model.coordinates.iter().filter(is_foreign).map(|coordinate| model.name(coordinate.symbol)).collect()
}

/// The names that readings lack.
fn missing(readings: &[crate::latex::Reading]) -> Vec<String> {
    let of = |fault: &crate::source::Fault| match &fault.missing {
        Some(Missing::Name(name)) => Some(name.clone()),
        _ => None,
    };
    readings.iter().flat_map(|reading| faults(reading).filter_map(of).collect::<Vec<_>>()).collect()
}
