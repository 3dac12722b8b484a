//! Dimensional analysis of a document: declared units, units inferred from equations, and terms that do not fit.
//!
//! A conflict is a type error: it is found before anything is evaluated, and its statement counts as unreadable. Units
//! that are not declared are inferred from the equations in their order; then each equation is checked against all units.
//! Nothing is inferred from an equation that is known to be wrong. An equation with `"units": "off"` is left out.

use std::collections::BTreeSet;

use crate::code::Code;
use crate::formula::units::{Affine, Dimension, Mismatch, Ratio, UnitCheck, parse};
use crate::formula::{Expr, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Claims};
use crate::notes::json::place_in_string;
use crate::source::Fault;
use crate::{Error, Result};

use crate::check::document::names;
use crate::check::model::Model;
use crate::check::model::meaning::{FrameQuantity, Meaning, ParticleQuantity, Quantity};

/// What the units of an equation are used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trust {
    /// It is checked, and the units of undeclared symbols are inferred from it.
    Sound,
    /// It is checked; nothing is inferred from it, since it has an erratum or is expected to fail.
    Doubted,
    /// It is not checked.
    Off,
}

#[cfg(test)]
/// A term of the notes with the wrong unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The index of the reading.
    pub display: usize,
    /// The index of the statement in it.
    pub statement: usize,
    /// The term, as a place in the text of the display.
    pub span: crate::source::Span,
    /// What is wrong, naming the term.
    pub message: String,
    /// The other displays that the dimensions in the message were inferred from.
    pub inferred_from: Vec<usize>,
}

/// A declared dimension that a formula of the claims file contradicts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contradiction {
    /// The defined symbol.
    pub symbol: SymbolId,
    /// What is wrong.
    pub message: String,
}

/// The units of a document.
pub struct Units<'a> {
    survey: UnitCheck<'a>,
    /// The definitions of the claims file whose formula has another unit.
    pub contradictions: Vec<Contradiction>,
}

impl<'a> Units<'a> {
    /// The units that follow from declarations, definitions and readings. A reading without an entry in `trust` is
    /// [`Trust::Sound`].
    pub fn new(
        model: &'a Model,
        declared: &[(SymbolId, Dimension)],
        readings: &[Reading],
        trust: &[Trust],
    ) -> Units<'a> {
        let mut units = Units { survey: UnitCheck::new(&model.symbols), contradictions: Vec::new() };
        units.declarations(model, declared);
        let introduced: BTreeSet<SymbolId> =
            readings.iter().flat_map(|reading| reading.introduced.iter().map(|i| i.symbol)).collect();
        for (at, meaning) in model.meanings.iter().enumerate() {
            let symbol = SymbolId(at);
            if let (Some(Meaning::Defined(formula)), false) = (meaning, introduced.contains(&symbol)) {
                units.definition(symbol, formula);
            }
        }
        for (display, reading) in readings.iter().enumerate() {
            if trust.get(display).is_none_or(|trust| *trust == Trust::Sound) {
                units.survey.inference.origin = Some(display);
                for statement in reading.statements.iter().flatten() {
                    units.survey.statement(statement);
                }
            }
        }
        units
    }

    fn declarations(&mut self, model: &Model, declared: &[(SymbolId, Dimension)]) {
        let inference = &mut self.survey.inference;
        let mut know = |symbol: SymbolId, dimension: Dimension| {
            let unit = Affine::known(dimension);
            // What is declared comes first; a default that contradicts it gives way.
            inference.require_equal(&Affine::of(symbol), &unit).is_ok()
        };
        for (symbol, dimension) in declared {
            // A name that is introduced by its square stands for the square.
            let squared = model.symbols.entry(*symbol).squared;
            know(*symbol, if squared { dimension.times(*dimension) } else { *dimension });
        }
        for (symbol, entry) in model.symbols.iter() {
            let turns = matches!(
                model.meaning(symbol),
                Some(
                    Meaning::System(Quantity::RotationMatrix | Quantity::BodyAxes | Quantity::SpaceAxes)
                        | Meaning::FixedAxis(_)
                        | Meaning::Frame(FrameQuantity::Axes | FrameQuantity::Angle)
                        | Meaning::Particles(ParticleQuantity::PrincipalAxes, ..)
                )
            );
            if entry.angle || turns {
                know(symbol, Dimension::NONE);
            }
        }
        for continuum in &model.continua {
            let exponent = Ratio::whole(continuum.dimension.into());
            know(continuum.region, Dimension::LENGTH.power(exponent));
        }
        let default = model.symbols.time.as_ref().is_some_and(|name| name.to_string() == "t");
        if let (Some(time), true) = (self.survey.time(), default) {
            let seconds = Affine::known(Dimension::TIME);
            self.survey.inference.require_equal(&Affine::of(time), &seconds).ok();
        }
        for (family, entry) in model.symbols.iter() {
            for member in &entry.members {
                // Members of different units leave the family without one.
                self.survey.inference.require_equal(&Affine::of(family), &Affine::of(*member)).ok();
            }
        }
    }

    fn definition(&mut self, symbol: SymbolId, formula: &Expr) {
        let found = match self.survey.dimension(formula) {
            Ok(Some(found)) => found,
            Ok(None) => return,
            Err(mismatch) => return self.contradictions.push(Contradiction { symbol, message: mismatch.message }),
        };
        let own = Affine::of(symbol);
        if self.survey.inference.require_equal(&own, &found).is_err() {
            let (own, found) = (self.survey.words(&own), self.survey.words(&found));
            let message = format!("the formula is {found}, and the name is {own}");
            self.contradictions.push(Contradiction { symbol, message });
        }
    }

    /// The first term of a statement that does not fit, for all that is known.
    pub fn mismatch(&self, statement: &Statement) -> Option<Mismatch> {
        let mut survey = self.survey.clone();
        survey.statement(statement).into_iter().next()
    }

    #[cfg(test)]
    /// The terms of the readings that do not fit, one to a statement at most.
    pub fn conflicts(&self, readings: &[Reading], trust: &[Trust]) -> Vec<Conflict> {
        let mut conflicts = Vec::new();
        for (display, reading) in readings.iter().enumerate() {
            if trust.get(display) == Some(&Trust::Off) {
                continue;
            }
            for (statement, read) in reading.statements.iter().enumerate() {
                let Some(Mismatch { span, message, origins }) = read.as_ref().ok().and_then(|s| self.mismatch(s))
                else {
                    continue;
                };
                let inferred_from = origins.into_iter().filter(|origin| *origin != display).collect();
                conflicts.push(Conflict { display, statement, span, message, inferred_from });
            }
        }
        conflicts
    }
}

#[cfg(test)]
/// The terms of a document that do not fit the declared units and one another.
pub fn conflicts(model: &Model, declared: &[(SymbolId, Dimension)], readings: &[Reading]) -> Vec<Conflict> {
    Units::new(model, declared, readings, &[]).conflicts(readings, &[])
}

/// The units of a document under its claims; `None` where it declares none, and nothing is checked.
///
/// # Errors
/// For a definition that contradicts the units, at its place in the claims file.
pub(crate) fn of_document<'a>(
    claims: &Claims,
    model: &'a Model,
    declared: &[(SymbolId, Dimension)],
    readings: &[Reading],
    assigned: &[Option<&Claim>],
) -> Result<Option<Units<'a>>> {
    if claims.units.is_empty() {
        return Ok(None);
    }
    let trust: Vec<Trust> = assigned.iter().map(|claim| claim.map_or(Trust::Sound, trust)).collect();
    let units = Units::new(model, declared, readings, &trust);
    if let Some(Contradiction { symbol, message }) = units.contradictions.first() {
        let name = model.name(*symbol);
        let define = claims.define.iter().find(|(latex, _)| names::symbol(claims, model, latex).ok() == Some(*symbol));
        let span = define.map_or(claims.notes.span, |(_, formula)| formula.span);
        let message = format!("the definition of {name}: {message}");
        return Err(Error::at(&claims.source, span, message).with_code(Code::UnitMismatch));
    }
    Ok(Some(units))
}

pub(crate) fn trust(claim: &Claim) -> Trust {
    match (claim.units_off, &claim.expect, &claim.skip) {
        (Some(_), ..) => Trust::Off,
        (None, None, None) if claim.errata.is_empty() => Trust::Sound,
        _ => Trust::Doubted,
    }
}

/// The declared units, symbol by symbol; a symbol that is not there may be excused.
///
/// # Errors
/// For a unit that cannot be read, and a symbol that is not there or has two units, at its place in the claims file.
pub(crate) fn declared(
    claims: &Claims,
    model: &Model,
    excused: &dyn Fn(&Error) -> bool,
) -> Result<Vec<(SymbolId, Dimension)>> {
    let mut declared: Vec<(SymbolId, Dimension)> = Vec::new();
    for (latex, unit) in &claims.units {
        let symbol = match names::symbol(claims, model, latex) {
            Err(error) if excused(&error) => continue,
            symbol => symbol?,
        };
        let dimension = parse(&unit.value).map_err(|fault| {
            let place = place_in_string(&claims.source.text, unit.span, fault.span);
            let span = if place.start < place.end { place } else { unit.span };
            Error::fault(&claims.source, Fault { span, ..fault })
        })?;
        let earlier = declared.iter().find(|(known, _)| *known == symbol);
        if let Some((_, other)) = earlier.filter(|(_, other)| *other != dimension) {
            let message = format!("{} already has the unit {other}", model.name(symbol));
            return Err(Error::at(&claims.source, latex.span, message)
                .with_code(Code::UnitMismatch)
                .help("declare one unit for a name; all members of a family have the same unit"));
        }
        declared.push((symbol, dimension));
    }
    Ok(declared)
}
