//! A whole document: its displays read in order, its claims tied to them, each equation judged.

use std::collections::HashMap;

use rayon::prelude::*;

use crate::latex::{Macros, Reading, read_display};
use crate::notes::address::Address;
use crate::notes::claims::{Claim, Claims};
use crate::notes::{Display, Notes};
use crate::systems::Registry;
use crate::{Error, Result};

use super::desk::Desk;
use super::identity::Options;
use super::model::Model;
use super::sentences;
use super::verdict::{Document, Equation, Finding, Verdict};

/// Checks a document; `only` restricts the work to one equation, and there may be none of that number.
///
/// # Errors
/// For claims that do not fit the notes or the system, each at its place in the claims file.
pub fn check_document(
    claims: &Claims,
    notes: &Notes,
    registry: &Registry,
    options: Options,
    only: Option<&str>,
) -> Result<Document> {
    let mut macros = Macros::default();
    for definition in &notes.macros {
        macros.define(&definition.name, definition.arguments, &definition.body);
    }
    repeated_numbers(notes)?;
    for sentence in &claims.sentences {
        sentences::unsupported(claims, sentence)?;
    }
    if let Some((name, _)) = claims.components.first() {
        return Err(Error::at(&claims.source, name.span, "\"components\" are not supported yet"));
    }
    let mut model = Model::new(claims, macros, registry)?;
    let assigned = assign(claims, notes)?;
    let mut readings = Vec::new();
    for (display, claim) in notes.equations.iter().zip(&assigned) {
        let wanted = id(display).is_some() || claim.is_some();
        let reading = if wanted { read(&display.text, &mut model) } else { Reading::default() };
        readings.push(reading);
    }
    let desk = Desk { claims, notes, model: &model, readings: &readings, assigned: &assigned, options };
    let chosen = |display: &&Display| only.is_none_or(|only| id(display) == Some(only));
    let work: Vec<usize> = (0..notes.equations.len())
        .filter(|at| chosen(&&notes.equations[*at]) && (id(&notes.equations[*at]).is_some() || assigned[*at].is_some()))
        .collect();
    let equations: Result<Vec<Equation>> = work.par_iter().map(|at| desk.equation(*at, assigned[*at])).collect();
    let sentences: Result<Vec<Equation>> = match only {
        Some(_) => Ok(Vec::new()),
        None => claims.sentences.par_iter().enumerate().map(|(at, s)| sentences::check(&desk, at, s)).collect(),
    };
    Ok(Document {
        path: notes.source.path.clone(),
        claims: Some(claims.source.path.clone()),
        source: notes.source.clone(),
        equations: equations?,
        sentences: sentences?,
        unnumbered: assigned
            .iter()
            .zip(&notes.equations)
            .filter(|(claim, d)| claim.is_none() && id(d).is_none())
            .count(),
        inferred: model.inferred.clone(),
    })
}

/// Refuses two displays with one number: a claim about it would be about either.
fn repeated_numbers(notes: &Notes) -> Result<()> {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for display in &notes.equations {
        let Some(number) = &display.number else { continue };
        if let Some(line) = seen.insert(&number.id, display.line) {
            let message = format!("the number ({}) is used a second time, after line {line}", number.id);
            return Err(Error::at(&notes.source, number.span, message).help("give each equation a number of its own"));
        }
    }
    Ok(())
}

/// The report of notes that no claims file is about: every numbered equation is unclaimed.
pub fn unclaimed(notes: &Notes) -> Document {
    let equation = |display: &Display| {
        let message = "nothing says what this should mean: it has no claims file";
        let finding = Finding::new(Verdict::Unclaimed, display.body, message);
        Some(Equation {
            id: id(display)?.to_owned(),
            line: display.line,
            latex: notes.source.slice(display.body).to_owned(),
            reading: String::new(),
            finding,
            ok: false,
            because: None,
            parts: Vec::new(),
        })
    };
    Document {
        path: notes.source.path.clone(),
        claims: None,
        source: notes.source.clone(),
        equations: notes.equations.iter().filter_map(equation).collect(),
        sentences: Vec::new(),
        unnumbered: notes.equations.iter().filter(|display| id(display).is_none()).count(),
        inferred: Vec::new(),
    }
}

/// The number or else the first label of a display.
pub fn id(display: &Display) -> Option<&str> {
    let number = display.number.as_ref().or(display.labels.first());
    number.map(|numbered| numbered.id.as_str())
}

/// The claim of each display, where the claims file makes one.
fn assign<'c>(claims: &'c Claims, notes: &Notes) -> Result<Vec<Option<&'c Claim>>> {
    let mut assigned: Vec<Option<&Claim>> = vec![None; notes.equations.len()];
    for (address, claim) in &claims.equations {
        unsupported(claims, address, claim)?;
        for at in address.resolve(notes, &claims.source)? {
            if assigned[at].replace(claim).is_some() {
                let message = "a second claim for the same equation";
                return Err(Error::at(&claims.source, address.span, message).help("put all keys under one address"));
            }
        }
    }
    Ok(assigned)
}

/// Refuses what the format has and this version does not check yet, rather than pass it over.
fn unsupported(claims: &Claims, address: &Address, claim: &Claim) -> Result<()> {
    let spans = [
        ("where", claim.meanings.first().map(|(name, _)| name.span)),
        ("up to a constant", claim.up_to_a_constant),
        ("times", claim.times.as_ref().map(|s| s.span)),
        ("divided by", claim.divided_by.as_ref().map(|s| s.span)),
        ("defines", claim.defines.first().map(|s| s.span)),
        ("equation of motion of", claim.equation_of_motion_of.as_ref().map(|s| s.span)),
        ("from", claim.from.first().map(|a| a.span)),
    ];
    if let Some((key, span)) = spans.into_iter().find_map(|(key, span)| Some((key, span?))) {
        return Err(Error::at(&claims.source, span, format!("\"{key}\" is not supported yet")));
    }
    let partial = address.single().is_some_and(|p| p.row.is_some() || p.part.is_some() || p.step.is_some());
    if partial {
        return Err(Error::at(
            &claims.source,
            address.span,
            "claims about a part of an equation are not supported yet",
        )
        .help("claim it of the whole equation"));
    }
    Ok(())
}

/// Reads a display and gives the symbols that it introduces their meaning.
fn read(text: &str, model: &mut Model) -> Reading {
    let macros = model.macros.clone();
    let reading = read_display(text, &mut model.symbols, &macros);
    for new in &reading.introduced {
        model.define(new.symbol, new.formula.clone());
    }
    reading
}
