//! The readings of all displays and definitions of a document, each as soon as the names that it uses are known.
//!
//! Notes use names before they define them, and the prose defines names through those of displays. So a display that lacks
//! a name is read again when more names are known, until a round adds nothing. What still cannot be read then has a fault of
//! its own. Definitions of the claims file that need such a display are dropped with it ([`super::unreadable`]).
//!
//! # Why displays are read in rounds
//!
//! Lectures use names before they define them, and `define` may use names that displays define. A fixed order would
//! make the author sort the notes. So what cannot be read for lack of a name is read again when more names are
//! known, until nothing changes. A name that the claims file defines is never taken by an earlier display.

use std::ops::Range;
use std::sync::Arc;

use crate::formula::symbols::{Kind, Name};
use crate::formula::{Expr, IndexId, Relation, Statement, SymbolId, Symbols};
use crate::latex::{Reading, name_search, names, read_display};
use crate::notes::Notes;
use crate::notes::claims::{Claim, Claims, Components, Declaration, Erratum, Spanned};
use crate::source::{Fault, Missing};
use crate::{Error, Result};

use crate::check::document::definition::define;
use crate::check::document::inferred::early_definitions::EarlyDefinitions;
use crate::check::document::inferred::prose::Prose;
use crate::check::document::inferred::{indices, integration_constants, open_energies};
use crate::check::document::normal_frequencies;
use crate::check::document::unreadable::{UnreadableDisplays, faults};
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::{Meaning, Quantity};
use crate::check::model::{Model, functions, particles};

/// Reads the displays, in their order, and the definitions of the claims file, which are added to the model.
///
/// # Errors
/// For a definition that cannot be read, at its place.
pub(crate) fn read_all(
    claims: &Claims,
    notes: &Notes,
    assigned: &[Option<&Claim>],
    model: &mut Model,
) -> Result<Vec<Reading>> {
    let mut readings: Vec<Option<Reading>> = notes
        .equations
        .iter()
        .zip(assigned)
        .map(|(display, claim)| match display.id().is_some() || claim.is_some() {
            true => None,
            false => Some(Reading::default()),
        })
        .collect();
    let texts = texts(claims, notes, assigned)?;
    // What only names an energy defines it where no other display does.
    let open = match model.symbols.guessed {
        true => open_energies::only_named(texts.iter().map(String::as_str), &model.macros),
        false => Vec::new(),
    };
    let is_last = |at: usize| is_of_a_case(assigned[at]) || open.contains(&at);
    let mut pending = Pending {
        claims,
        definitions: claims.define.iter().collect(),
        of_particles: claims.means.iter().filter(|(_, meaning)| particles::quantity(meaning).is_some()).collect(),
        functions: functions::later(claims, model),
        frequencies: model.normal_frequencies.clone(),
    };
    pending.define_what_is_ready(model);
    let prose = Prose::of(notes);
    // The system is what the first display says of it, even if that needs a name of the prose.
    let waits = |at: usize, readings: &[Option<Reading>], model: &Model| {
        let lagrangian = model.printed_lagrangian.as_ref().map(|printed| printed.lagrangian.to_string());
        let hamiltonian = model.printed_hamiltonian.as_ref().map(|printed| printed.hamiltonian.to_string());
        lagrangian.or(hamiltonian).is_some_and(|name| {
            let begins = |at: usize| name_search::is_the_first_side(&texts[at], &name, &model.macros);
            begins(at) && (0..at).any(|before| readings[before].is_none() && !open.contains(&before) && begins(before))
        })
    };
    // What was added gives no name that the notes give, not even for a special case.
    let own = 0..notes.added_from.unwrap_or(readings.len());
    let added = own.end..readings.len();
    let mut early = EarlyDefinitions::default();
    loop {
        let mut read_some = |range: &Range<usize>, of_a_case: bool, model: &mut Model| {
            let mut progress = false;
            for at in range.clone().filter(|at| is_last(*at) == of_a_case) {
                if readings[at].is_none() && !waits(at, &readings, model) {
                    readings[at] = pending.read(&texts[at], assigned[at], model);
                    if readings[at].is_some() {
                        pending.define_what_is_ready(model);
                        progress = true;
                    }
                }
            }
            progress
        };
        while read_some(&own, false, model) || read_some(&own, true, model) || read_some(&added, false, model) {}
        // A display with a fault of its own still defines the names that can be read in it.
        let unread: Vec<(usize, Symbols, Reading)> = (0..readings.len())
            .filter(|at| readings[*at].is_none())
            .map(|at| {
                let (symbols, reading) = read(&texts[at], assigned[at], model);
                (at, symbols, reading)
            })
            .collect();
        // A name at the end of a chain is defined there only if neither a display that begins with it nor the prose does.
        let waiting = unread.iter().position(|(_, symbols, reading)| {
            faults(reading).next().is_none() && !pending.introduces_pending(symbols, reading)
        });
        if let Some(waiting) = waiting.filter(|_| model.tie_components()) {
            let at = unread[waiting].0;
            if !prose.define((claims, notes), unread.iter().map(|(at, _, reading)| (*at, reading)), false, model) {
                readings[at] = Some(accept(read(&texts[at], assigned[at], model), model));
            }
            pending.define_what_is_ready(model);
            continue;
        }
        let broken = |(_, symbols, reading): &(usize, Symbols, Reading)| {
            let lacks_nothing = |fault: &Fault| fault.missing.is_none();
            faults(reading).next().is_some()
                && faults(reading).all(lacks_nothing)
                && !pending.introduces_pending(symbols, reading)
        };
        if unread.iter().any(broken) && model.tie_components() {
            // The readings after one that gives no name are not changed by it.
            let known = model.symbols.iter().count();
            for (at, symbols, reading) in unread {
                let reading = (at, symbols, reading);
                if !broken(&reading) {
                    continue;
                }
                let (at, symbols, reading) = reading;
                let gives_names = !reading.introduced.is_empty() || symbols.iter().count() != known;
                readings[at] = Some(accept((symbols, reading), model));
                if gives_names {
                    break;
                }
            }
        } else if !prose.define((claims, notes), unread.iter().map(|(at, _, reading)| (*at, reading)), false, model)
            && !indices::declare(unread.iter().map(|(_, _, reading)| reading), model)
            && !unread.iter().any(|(at, _, reading)| integration_constants::declare(&texts[*at], reading, model))
            && !prose.define((claims, notes), unread.iter().map(|(at, _, reading)| (*at, reading)), true, model)
            && !early.define(&unread, &texts, model)
        {
            let read = readings.iter().enumerate().filter_map(|(at, reading)| Some((at, reading.as_ref()?)));
            let all = read.chain(unread.iter().map(|(at, _, reading)| (*at, reading)));
            if !pending.drop_unreadable(&UnreadableDisplays::of(notes, all), model)? {
                // What no formula defines, a value does.
                if model.symbols.quantities_define {
                    break;
                }
                model.symbols.quantities_define = true;
            }
        }
        pending.define_what_is_ready(model);
    }
    if let Some(function) = pending.functions.first() {
        functions::require(claims, function, model)?;
    }
    for at in 0..readings.len() {
        if readings[at].is_none() {
            readings[at] = Some(accept(read(&texts[at], assigned[at], model), model));
        }
    }
    assemble_families(model);
    let mut readings: Vec<Reading> = readings.into_iter().map(Option::unwrap_or_default).collect();
    early.restore(&mut readings);
    Ok(readings)
}

/// The texts of the displays, with the errata of their claims corrected.
fn texts(claims: &Claims, notes: &Notes, assigned: &[Option<&Claim>]) -> Result<Vec<String>> {
    notes
        .equations
        .iter()
        .zip(assigned)
        .map(|(display, claim)| match claim {
            Some(claim) => corrected(claims, &display.text, &claim.errata),
            None => Ok(display.text.clone()),
        })
        .collect()
}

/// Whether a claim is about a special case. What a display says of a name there defines it only if no other display does.
fn is_of_a_case(claim: Option<&Claim>) -> bool {
    claim.is_some_and(|claim| !claim.assume.is_empty() || !claim.throughout.is_empty())
}

/// Makes a family of symbols from members that are all declared: λ_a from λ₁, λ₂, λ₃. The claims file may then name the
/// family where no display does.
fn assemble_families(model: &mut Model) {
    let letters: Vec<String> = model.symbols.indices.iter().map(|index| index.letter.clone()).collect();
    let firsts: Vec<Name> = model.symbols.iter().map(|(_, entry)| entry.name.clone()).collect();
    for mut name in firsts {
        let Some(at) = name.subscript.iter().position(|token| token == "1") else { continue };
        for letter in &letters {
            name.subscript[at].clone_from(letter);
            model.symbols.find_or_assemble(&name);
        }
    }
}

/// The text of a display with its errata corrected.
///
/// # Errors
/// When the printed text of an erratum does not occur as often as the claims file says.
pub(crate) fn corrected(claims: &Claims, printed: &str, errata: &[Erratum]) -> Result<String> {
    let mut text = printed.to_owned();
    for erratum in errata {
        let found = text.matches(&erratum.printed.value).count();
        if found != erratum.times {
            if found == 0 {
                let message = format!("“{}” does not occur in this equation", erratum.printed.value);
                return Err(Error::at(&claims.source, erratum.printed.span, message)
                    .help("quote it as the notes have it, with the same spaces and backslashes"));
            }
            let times = if found == 1 { "once".to_owned() } else { format!("{found} times") };
            let message = format!("“{}” occurs {times} in this equation", erratum.printed.value);
            return Err(Error::at(&claims.source, erratum.printed.span, message)
                .help("quote it as the notes have it, quote more of it, or give the number with \"times\""));
        }
        text = text.replace(&erratum.printed.value, &erratum.read.value);
    }
    Ok(text)
}

/// The definitions of the claims file that use names which are not known yet, and the frequencies that follow from a
/// Lagrangian which no display has defined yet.
struct Pending<'a> {
    claims: &'a Claims,
    definitions: Vec<&'a (Spanned<String>, Spanned<String>)>,
    of_particles: Vec<&'a (Spanned<String>, Spanned<String>)>,
    functions: Vec<&'a Declaration>,
    frequencies: Vec<Name>,
}

impl Pending<'_> {
    /// Adds every definition whose names are all known now.
    fn define_what_is_ready(&mut self, model: &mut Model) {
        loop {
            let before = self.definitions.len() + self.of_particles.len() + self.functions.len();
            self.functions.retain(|declaration| {
                !functions::declare_later(self.claims, declaration, model).is_ok_and(|done| done)
            });
            self.definitions.retain(|(name, body)| define(self.claims, name, body, model).is_err());
            self.of_particles.retain(|(name, meaning)| particles::declare(self.claims, name, meaning, model).is_err());
            if before == self.definitions.len() + self.of_particles.len() + self.functions.len() {
                break;
            }
        }
        self.frequencies
            .retain(|name| normal_frequencies::define(model).is_err() || model.symbols.find(name).is_none());
    }

    /// The reading of a display, if all of it can be read, and it introduces no name that is still pending and none at the end of a
    /// chain.
    fn read(&self, text: &str, claim: Option<&Claim>, model: &mut Model) -> Option<Reading> {
        if !model.tie_components() {
            return None;
        }
        let found = read(text, claim, model);
        let whole = faults(&found.1).next().is_none();
        // The name of a vector or of a family at the end is no quantity that the prose gives.
        let is_number = |id: SymbolId| {
            let entry = found.0.entry(id);
            entry.kind == Kind::Scalar && entry.slots.is_empty()
        };
        let is_at_the_end =
            (found.1.introduced.iter()).any(|introduced| introduced.member > 0 && is_number(introduced.symbol));
        (whole && !is_at_the_end && !self.introduces_pending(&found.0, &found.1)).then(|| accept(found, model))
    }

    /// Whether a reading introduces a name that is still pending.
    fn introduces_pending(&self, symbols: &Symbols, reading: &Reading) -> bool {
        let reserved = |name: &Name| {
            if self.frequencies.contains(name) {
                return true;
            }
            let all = self.definitions.iter().chain(&self.of_particles);
            all.filter_map(|(latex, _)| name_search::parse_decorated(&latex.value)).any(|pending| pending == *name)
        };
        reading.introduced.iter().any(|introduced| reserved(&symbols.entry(introduced.symbol).name))
    }

    /// Rejects definitions that are defined through each other.
    ///
    /// # Errors
    /// For the first of them, at its place.
    fn reject_circular_definitions(&self, model: &Model) -> Result<()> {
        if self.definitions.is_empty() {
            return Ok(());
        }
        let mut unread = model.clone();
        let depends_on_display = |(name, body): &(Spanned<String>, Spanned<String>), unread: &mut Model| {
            let error = define(self.claims, name, body, unread).err()?;
            let Some(Missing::Name(missing)) = error.missing() else { return None };
            self.definitions.iter().position(|(other, _)| name_search::same(&other.value, missing))
        };
        let next: Vec<Option<usize>> =
            self.definitions.iter().map(|definition| depends_on_display(definition, &mut unread)).collect();
        for (start, (name, body)) in self.definitions.iter().enumerate() {
            let circle: Vec<usize> = std::iter::successors(next[start], |at| next[*at]).take(next.len()).collect();
            if let Some(length) = circle.iter().position(|at| *at == start) {
                let others: Vec<&str> =
                    circle[..length].iter().map(|at| self.definitions[*at].0.value.as_str()).collect();
                let message = match others.as_slice() {
                    [] => format!("{} is defined by itself", name.value),
                    others => format!("{} is defined by itself, through {}", name.value, others.join(", ")),
                };
                return Err(Error::at(&self.claims.source, body.span, message)
                    .help("define one of these names without the others"));
            }
        }
        Ok(())
    }

    /// Drops the definitions that need a display that cannot be read; returns whether there were any.
    ///
    /// # Errors
    /// For a definition that cannot be read for another reason, at its place.
    fn drop_unreadable(&mut self, unreadable: &UnreadableDisplays<'_>, model: &mut Model) -> Result<bool> {
        let claims = self.claims;
        self.reject_circular_definitions(model)?;
        let mut wrong = None;
        let mut lost = Vec::new();
        let mut known = |name: &Spanned<String>, found: Result<()>, model: &Model| {
            let Err(error) = found else { return false };
            match unreadable.cause(error.missing(), model) {
                Some(cause) => {
                    lost.push((name.value.clone(), cause));
                    return false;
                }
                None => wrong = wrong.take().or(Some(error)),
            }
            true
        };
        self.definitions.retain(|(name, body)| known(name, define(claims, name, body, model), model));
        self.of_particles.retain(|(name, what)| known(name, particles::declare(claims, name, what, model), model));
        let missing = |axes: &Spanned<String>| {
            names::parse(&axes.value).map(|(name, _)| name).filter(|name| model.symbols.find(name).is_none())
        };
        let mut without_axes = Vec::new();
        for (vector, components) in &claims.components {
            if let Components::Along(axes) = &components.value
                && let Some(name) = missing(axes)
                && model.components.iter().any(|(_, known)| *known == name)
            {
                let fault = Fault::undeclared(axes.span, &axes.value);
                if !known(vector, Err(Error::fault(&claims.source, fault)), model) {
                    without_axes.push(name);
                }
            }
        }
        model.components.retain(|(_, axes)| !without_axes.contains(axes));
        match (lost.is_empty(), wrong) {
            (true, Some(error)) => Err(error),
            (none, _) => {
                model.unread_names.extend(lost);
                Ok(!none)
            }
        }
    }
}

/// Reads a display with the names of the model; the names that come with it are those that it introduces.
fn read(text: &str, claim: Option<&Claim>, model: &Model) -> (Symbols, Reading) {
    let mut symbols = model.symbols.clone();
    symbols.for_each = for_each(claim, model);
    let mut reading = read_display(text, &mut symbols, &model.macros);
    if let Some(with) = with_own_formulas(&reading, model) {
        let for_each = symbols.for_each;
        symbols = with;
        symbols.for_each = for_each;
        reading = read_display(text, &mut symbols, &model.macros);
    }
    symbols.for_each = None;
    (symbols, reading)
}

/// The names with the formulas of energies that some statements of a display print and others differentiate: `H = …, \dot p =
/// -\partial H/\partial x`. `None` where nothing is gained.
fn with_own_formulas(reading: &Reading, model: &Model) -> Option<Symbols> {
    let is_some_read = reading.statements.iter().any(Result::is_ok);
    if !is_some_read || faults(reading).next().is_none() || !reading.introduced.is_empty() {
        return None;
    }
    let given = |model: &Model| model.symbols.iter().filter(|(_, entry)| entry.definition.is_some()).count();
    let mut with = model.clone();
    let count = model.symbols.iter().count();
    for statement in reading.statements.iter().flatten() {
        // A name that the display adds is not known before it.
        let is_known = |member: &Expr| member.symbols().iter().all(|(id, _)| id.0 < count);
        if statement.members.iter().all(is_known) {
            note_formula(statement, &mut with);
        }
    }
    (given(&with) > given(model)).then_some(with.symbols)
}

/// Notes the formula by which the Hamiltonian or an energy is differentiated: the last member without velocities, as
/// H(q, p) is meant, or else, for what the system determines, the last one.
fn note_formula(statement: &Statement, model: &mut Model) {
    let [first, others @ ..] = statement.members.as_slice() else { return };
    let Some(id) = first.as_plain_symbol() else { return };
    let energies = [Quantity::Energy, Quantity::KineticEnergy, Quantity::PotentialEnergy, Quantity::EffectivePotential];
    let is_energy = matches!(model.meaning(id), Some(Meaning::System(quantity)) if energies.contains(quantity));
    let is_defined = matches!(model.meaning(id), Some(Meaning::Defined(_)));
    let is_known = is_energy && model.symbols.entry(id).definition.is_some();
    if is_known || !(is_energy || is_defined) || !statement.relations.iter().all(|relation| is_equality(relation.0)) {
        return;
    }
    let is_momentum = |symbol: &SymbolId| model.symbols.entry(*symbol).momentum;
    let has_momentum = |member: &&Expr| member.symbols().iter().any(|(symbol, _)| is_momentum(symbol));
    // A Routhian has the momentum of one coordinate beside the velocities of others.
    let of_its_momentum = |member: &Expr, id: SymbolId| {
        let pair = model.symbols.canonical.iter().find(|(q, _)| *q == id);
        pair.is_none_or(|(_, momenta)| member.symbols().iter().any(|(other, _)| momenta.contains(other)))
    };
    let has_velocity =
        |member: &&Expr| member.symbols().iter().any(|(id, dots)| *dots > 0 && of_its_momentum(member, *id));
    let contains_it = |member: &&Expr| member.symbols().iter().any(|(other, _)| *other == id);
    let candidates = || others.iter().filter(|member| !contains_it(member));
    let in_momenta = candidates().filter(has_momentum).rfind(|member| !has_velocity(member));
    let any = || candidates().next_back().filter(|_| is_energy);
    let found = in_momenta.or_else(|| candidates().rfind(|member| is_energy && !has_velocity(member))).or_else(any);
    if let Some(formula) = found {
        model.symbols.entry_mut(id).definition = Some(Arc::new(formula.clone()));
    }
}

/// Notes that a name is a momentum, where a display sets it equal to one: `\ell = \frac{\partial L}{\partial\dot\phi} = m r^2\dot\phi`.
fn note_momentum(statement: &Statement, model: &mut Model) {
    let ids: Vec<SymbolId> = statement.members.iter().filter_map(Expr::as_plain_symbol).collect();
    let place = ids.iter().find_map(|id| match model.meaning(*id) {
        Some(Meaning::System(Quantity::Momentum(place))) => Some(*place),
        _ => None,
    });
    let Some(place) = place.filter(|_| statement.relations.iter().all(|relation| is_equality(relation.0))) else {
        return;
    };
    let q = model.coordinates.get(place).map(|coordinate| coordinate.symbol);
    let is_defined = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Defined(_)));
    let defined: Vec<SymbolId> = ids.into_iter().filter(is_defined).collect();
    for id in defined {
        model.symbols.entry_mut(id).momentum = true;
        let pairs = &mut model.symbols.canonical;
        if let Some((_, names)) = pairs.iter_mut().find(|(known, names)| Some(*known) == q && !names.contains(&id)) {
            names.push(id);
        }
    }
}

/// Adds the names that a reading introduces to the model, and returns the reading.
fn accept((symbols, reading): (Symbols, Reading), model: &mut Model) -> Reading {
    model.symbols = symbols;
    for introduced in &reading.introduced {
        model.define(introduced.symbol, introduced.formula.clone());
    }
    for statement in reading.statements.iter().flatten() {
        note_formula(statement, model);
        note_momentum(statement, model);
        if statement.constant.is_some() {
            for id in statement.members.iter().filter_map(Expr::as_plain_symbol) {
                let entry = model.symbols.entry_mut(id);
                entry.conserved |= entry.definition.is_some();
            }
        }
    }
    reading
}

/// The label that a claim gives to the names of its equation.
pub(crate) fn for_each(claim: Option<&Claim>, model: &Model) -> Option<IndexId> {
    let letter = claim?.for_each.as_ref()?;
    let (name, _) = names::parse(&letter.value)?;
    model.symbols.index(&name.to_string())
}

/// The reading with ≈ in place of each =.
pub(crate) fn approximate(reading: &Reading) -> Reading {
    let mut reading = reading.clone();
    for statement in reading.statements.iter_mut().flatten() {
        for (relation, _) in statement.relations.iter_mut().filter(|(relation, _)| is_equality(*relation)) {
            *relation = Relation::Approximately;
        }
    }
    reading
}
