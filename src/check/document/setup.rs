//! The set-up of a document: options of a run, claims assigned to displays, and the [`Checker`] made of them.

use std::borrow::Cow;
use std::sync::{Arc, LazyLock};

use crate::code::Code;
use crate::formula::symbols::Name;
use crate::latex::{Macros, name_search};
use crate::notes::address::{Address, Item, Point};
use crate::notes::claims::{Claim, Claims};
use crate::notes::{Display, Form, MacroDefinition, Notes};
use crate::systems::Registry;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::document::names::repeated;
use crate::check::document::{inferred, motion_by_laws, printed_lagrangian, reading, units};
use crate::check::model::Model;
use crate::check::sample::context::Options;
use crate::check::verdict::progress::Progress;

/// The options of a run.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// The systems that claims may name.
    pub registry: &'a Registry,
    /// The seed and the number of states.
    pub options: Options,
    /// The number or label of the only equation to check; a document may lack it.
    pub only: Option<&'a str>,
    /// The receiver of progress reports.
    pub progress: &'a dyn Progress,
}

/// The displays that are to be checked, by their places.
pub(crate) fn wanted(notes: &Notes, assigned: &[Option<&Claim>], only: Option<&str>) -> Vec<usize> {
    let chosen = |display: &Display| only.is_none_or(|only| display.id() == Some(only));
    let claimed = |at: usize| notes.equations[at].id().is_some() || assigned[at].is_some();
    (0..notes.equations.len()).filter(|at| chosen(&notes.equations[*at]) && claimed(*at)).collect()
}

#[cfg(feature = "cli")]
/// The number of equations and sentences that [`check_in`](crate::check::check_in) will report.
pub fn items(claims: &Claims, notes: &Notes, only: Option<&str>) -> usize {
    equations(claims, notes, only) + if only.is_some() { 0 } else { claims.sentences.len() }
}

#[cfg(feature = "cli")]
/// The number of equations that [`check_in`](crate::check::check_in) will report; 0 if the claims do not fit the notes.
pub fn equations(claims: &Claims, notes: &Notes, only: Option<&str>) -> usize {
    assign(claims, notes).map_or(0, |assigned| wanted(notes, &assigned, only).len())
}

/// Makes the checker of a document, and passes it to `work`.
///
/// # Errors
/// For claims that do not fit the notes, at their place in the claims file, and those of `work`.
pub(crate) fn with_checker<T>(
    run: &Run<'_>,
    claims: &Claims,
    notes: &Notes,
    work: impl FnOnce(Checker<'_>) -> Result<T>,
) -> Result<T> {
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    repeated_numbers(notes)?;
    let mut model = Model::new(claims, macros, run.registry)?;
    inferred::momenta::infer(claims, notes, &mut model);
    inferred::hamiltonian::infer(claims, notes, &mut model);
    let assigned = assign(claims, notes)?;
    let readings = reading::read_all(claims, notes, &assigned, &mut model)?;
    printed_lagrangian::make((claims, notes), &readings, &mut model)?;
    motion_by_laws::of_the_hamiltonian(claims, &mut model)?;
    let (source, options) = (&*notes.source, run.options);
    let plain = Checker {
        claims,
        notes,
        source,
        model: &model,
        readings: &readings,
        assigned: &assigned,
        options,
        units: None,
    };
    let (laws, lost_laws) = plain.laws()?;
    let lacks_a_name = |error: &Error| plain.cause(error.missing()).is_some();
    let known = units::declared(claims, &model, &lacks_a_name)?;
    model.laws.extend(laws);
    model.unread_laws = lost_laws;
    let units = units::of_document(claims, &model, &known, &readings, &assigned)?.map(Arc::new);
    let checker =
        Checker { claims, notes, source, model: &model, readings: &readings, assigned: &assigned, options, units };
    checker.check_units_of_hypotheses()?;
    work(checker)
}

/// Adds the commands that a text defines, in its order.
pub(crate) fn define_macros(definitions: &[MacroDefinition], macros: &mut Macros) {
    for MacroDefinition { name, arguments, form, body, .. } in definitions {
        match form {
            Form::Plain => macros.define(name, *arguments, body),
            Form::Optional(default) => macros.define_optional(name, *arguments, default, body),
            Form::Pattern(pattern) => macros.define_pattern(name, pattern, body),
            // What is not supported stays unknown, and its uses are rejected.
            Form::Types(types) => {
                macros.define_document_command(name, types, body);
            }
            Form::Pair(left, right) => macros.define_pair(name, left, right),
            Form::Alias => macros.alias(name, body),
        }
    }
}

/// Rejects two displays with the same number, since a claim about it would be ambiguous.
fn repeated_numbers(notes: &Notes) -> Result<()> {
    match repeated(notes).first() {
        None => Ok(()),
        Some((number, line)) => {
            let message = format!("the number ({}) is used twice: on line {line}, and here", number.id);
            Err(Error::at(&notes.source, number.span, message)
                .with_code(Code::NotesFile)
                .help("give each equation its own number"))
        }
    }
}

/// The claim of each display, where the claims file makes one.
pub(crate) fn assign<'c>(claims: &'c Claims, notes: &Notes) -> Result<Vec<Option<&'c Claim>>> {
    let mut assigned: Vec<Option<&Claim>> = vec![None; notes.equations.len()];
    let mut parts = Vec::new();
    for (address, claim) in &claims.equations {
        whole_only(claims, address, claim)?;
        if address.single().is_some_and(is_partial) {
            parts.extend(address.resolve(notes, &claims.source)?);
            continue;
        }
        for at in address.resolve(notes, &claims.source)? {
            if assigned[at].replace(claim).is_some() {
                let message = match notes.equations[at].id() {
                    Some(id) => format!("({id}) has two claims"),
                    None => "this equation has two claims".to_owned(),
                };
                return Err(Error::at(&claims.source, address.span, message)
                    .help("put all keys of the equation under one address"));
            }
        }
    }
    // A display with a claim about a part is checked as a whole.
    for at in parts {
        assigned[at].get_or_insert(&NOTHING_MORE);
    }
    // A step of a derivation is checked even without a claim of its own.
    for derivation in &claims.steps {
        for at in derivation.resolve(notes, &claims.source)? {
            assigned[at].get_or_insert(&NOTHING_MORE);
        }
    }
    Ok(assigned)
}

/// The claim that an equation holds.
static NOTHING_MORE: LazyLock<Claim> = LazyLock::new(Claim::default);

/// Rejects claims about a part of an equation that only a whole equation can have.
pub(crate) fn whole_only(claims: &Claims, address: &Address, claim: &Claim) -> Result<()> {
    let is_in_a_list = address.items.len() > 1
        && address.items.iter().any(|item| matches!(item, Item::One(point) if is_partial(point)));
    if is_in_a_list {
        return Err(Error::at(&claims.source, address.span, "a part of an equation cannot be in a list of equations")
            .help("write a separate claim for each part"));
    }
    if address.single().is_some_and(is_partial) && (!claim.errata.is_empty() || claim.for_each.is_some()) {
        return Err(Error::at(&claims.source, address.span, "\"erratum\" and \"for each\" are about a whole equation")
            .help("put them under the address of the equation"));
    }
    Ok(())
}

/// Whether a point names a row, a part or a step of a display.
fn is_partial(point: &Point) -> bool {
    point.row.or(point.part).or(point.step).is_some()
}

/// The notes without T − V in `L = T - V = …`, where the claims file does not say what T and V are.
pub(crate) fn without_open_energies<'n>(claims: &Claims, notes: &'n Notes) -> Cow<'n, Notes> {
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let declared = claims.declarations.iter().map(|declaration| &declaration.name);
    let named: Vec<&str> = declared
        .chain(claims.means.iter().chain(&claims.define).map(|(name, _)| name))
        .map(|name| name.value.as_str())
        .collect();
    let is_declared = |name: &Name| named.iter().any(|known| name_search::same(known, &name.to_string()));
    inferred::open_energies::without_names(notes, &macros, claims.guesses.is_some(), &is_declared)
}
