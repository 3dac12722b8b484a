//! All displays and definitions of a document, each read as soon as what it stands on is known.
//!
//! Notes use names before they introduce them, and the prose defines names through those of displays. So what cannot be
//! read for want of a name is read again when more are known, until nothing new comes out; what then cannot be read is
//! what is wrong with it.

use crate::formula::shape::{Shape, bind};
use crate::formula::symbols::Name;
use crate::formula::{IndexId, Kind};
use crate::latex::{Reading, names, read_display, read_formula};
use crate::notes::Notes;
use crate::notes::claims::{Claim, Claims, Erratum, Spanned};
use crate::{Error, Result};

use super::document::id;
use super::model::{Model, formula_error};
use super::particles;

/// Reads what is wanted: the displays, by their places, and the claims file's definitions, which go into the model.
///
/// # Errors
/// For a definition that cannot be read, at its place.
pub(super) fn read_all(
    claims: &Claims,
    notes: &Notes,
    assigned: &[Option<&Claim>],
    model: &mut Model,
) -> Result<Vec<Reading>> {
    let mut readings: Vec<Option<Reading>> = notes
        .equations
        .iter()
        .zip(assigned)
        .map(|(display, claim)| match id(display).is_some() || claim.is_some() {
            true => None,
            false => Some(Reading::default()),
        })
        .collect();
    let texts: Vec<String> = notes
        .equations
        .iter()
        .zip(assigned)
        .map(|(display, claim)| match claim {
            Some(claim) => corrected(claims, &display.text, &claim.errata),
            None => Ok(display.text.clone()),
        })
        .collect::<Result<_>>()?;
    let mut definitions: Vec<&(Spanned<String>, Spanned<String>)> = claims.define.iter().collect();
    let mut of_particles: Vec<_> =
        claims.means.iter().filter(|(_, meaning)| particles::quantity(meaning).is_some()).collect();
    loop {
        let before =
            of_particles.len() + definitions.len() + readings.iter().filter(|reading| reading.is_none()).count();
        definitions.retain(|(name, body)| define(claims, name, body, model).is_err());
        of_particles.retain(|(name, meaning)| particles::declare(claims, name, meaning, model).is_err());
        for at in 0..readings.len() {
            if readings[at].is_none() {
                readings[at] = read(&texts[at], assigned[at], model, false)?;
            }
        }
        if before
            == of_particles.len() + definitions.len() + readings.iter().filter(|reading| reading.is_none()).count()
        {
            break;
        }
    }
    for (name, body) in definitions {
        define(claims, name, body, model)?;
    }
    for (name, meaning) in of_particles {
        particles::declare(claims, name, meaning, model)?;
    }
    for at in 0..readings.len() {
        if readings[at].is_none() {
            readings[at] = read(&texts[at], assigned[at], model, true)?;
        }
    }
    assemble(model);
    Ok(readings.into_iter().map(Option::unwrap_or_default).collect())
}

/// Puts together every family whose members all have names of their own, so that the claims file may name it where no
/// display does: λ_a beside λ₁, λ₂, λ₃.
fn assemble(model: &mut Model) {
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

/// The text of a display, its errata mended: what is wrong as printed is known as corrected.
fn corrected(claims: &Claims, printed: &str, errata: &[Erratum]) -> Result<String> {
    let mut text = printed.to_owned();
    for erratum in errata {
        let found = text.matches(&erratum.printed.value).count();
        if found != erratum.times {
            let message = format!("“{}” stands {found} times in this equation", erratum.printed.value);
            return Err(Error::at(&claims.source, erratum.printed.span, message)
                .help("quote more of it, or say how often with \"times\""));
        }
        text = text.replace(&erratum.printed.value, &erratum.read.value);
    }
    Ok(text)
}

/// Reads a display and gives the symbols that it introduces their meaning; nothing comes of one that is not wholly read,
/// unless it is the last attempt.
fn read(text: &str, claim: Option<&Claim>, model: &mut Model, last: bool) -> Result<Option<Reading>> {
    let mut symbols = model.symbols.clone();
    symbols.for_each = for_each(claim, model);
    let mut reading = read_display(text, &mut symbols, &model.macros);
    if !last && reading.statements.iter().any(std::result::Result::is_err) {
        return Ok(None);
    }
    symbols.for_each = None;
    model.symbols = symbols;
    for introduced in &mut reading.introduced {
        model.define(introduced.symbol, introduced.formula.clone());
    }
    Ok(Some(reading))
}

/// The label that a claim gives to the names of its equation.
pub(super) fn for_each(claim: Option<&Claim>, model: &Model) -> Option<IndexId> {
    let letter = claim?.for_each.as_ref()?;
    let (name, _) = names::parse(&letter.value)?;
    model.symbols.index(&name.to_string())
}

/// Adds what the claims file defines.
fn define(claims: &Claims, latex: &Spanned<String>, body: &Spanned<String>, model: &mut Model) -> Result<()> {
    let error = |message: String| Error::at(&claims.source, latex.span, message);
    let name = names::parse_decorated(&latex.value).ok_or_else(|| {
        error(format!("{} is not the name of a symbol", latex.value))
            .help("a name is a letter or a Greek command, with accents, a subscript, primes: \\hat{e}_a, p_\\psi")
    })?;
    let mut symbols = model.symbols.clone();
    let formula =
        read_formula(&body.value, &mut symbols, &model.macros).map_err(|fault| formula_error(claims, body, fault))?;
    let (formula, found) = bind(formula, &symbols).map_err(|fault| formula_error(claims, body, fault))?;
    let shown = name.to_string();
    let kind = match found.shape {
        Shape::Scalar => Kind::Scalar,
        Shape::Vector => Kind::Vector,
        Shape::Matrix(3, 3) => Kind::Matrix,
        Shape::Matrix(..) => return Err(error(format!("{shown} cannot be defined as a matrix of this size"))),
    };
    let id = symbols
        .add(name, kind)
        .ok_or_else(|| error(format!("{shown} is declared twice")).help("keep one of the two"))?;
    let own: Vec<IndexId> = symbols.entry(id).slots.iter().map(|(_, letter)| *letter).collect();
    if let Some(stray) = found.free.iter().find(|letter| !own.contains(letter)) {
        let letter = &symbols.indices[stray.0].letter;
        return Err(error(format!("{letter} is free in this definition, and {shown} does not have it")));
    }
    symbols.entry_mut(id).varies = true;
    model.symbols = symbols;
    model.define(id, formula);
    Ok(())
}
