//! A whole document: its displays read in order, its claims tied to them, each equation judged.

use std::collections::HashMap;
use std::path::Path;
use std::sync::{Arc, LazyLock};

use rayon::prelude::*;

use crate::formula::SymbolId;
use crate::latex::Macros;
use crate::notes::address::Address;
use crate::notes::claims::{Claim, Claims};
use crate::notes::document::{Kind, Numbered};
use crate::notes::{Display, Notes};
use crate::systems::Registry;
use crate::{Error, Result};

use crate::source::Source;

use super::desk::Desk;
use super::identity::Options;
use super::model::Model;
use super::progress::Progress;
use super::reading;
use super::repair::is_wrong;
use super::sentences;
use super::units;
use super::verdict::{Document, Equation, Finding, Verdict};

/// How a run is made, beside its documents.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// The systems that claims may name.
    pub registry: &'a Registry,
    /// The seed and the number of states.
    pub options: Options,
    /// The number or label of the one equation that is wanted; there may be none of it.
    pub only: Option<&'a str>,
    /// Who is told of every item done.
    pub progress: &'a dyn Progress,
}

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
    check_in(&Run { registry, options, only, progress: &() }, claims, notes)
}

/// Checks a document as part of a run.
///
/// # Errors
/// As [`check_document`].
pub fn check_in(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    for sentence in &claims.sentences {
        sentences::unsupported(claims, sentence)?;
    }
    with_desk(run, claims, notes, |desk| {
        let work = wanted(notes, desk.assigned, run.only);
        let sentences = if run.only.is_some() { &[] } else { claims.sentences.as_slice() };
        let path = notes.source.path.as_str();
        let told = |equation: Result<Equation>| {
            run.progress.done(path);
            equation
        };
        let derivations = desk.derivations()?;
        let judged = |at: usize| {
            let found = desk.equation(at, desk.assigned[at]).or_else(|error| desk.excused(at, error))?;
            Ok(desk.without_lost_laws(found, None))
        };
        let sentence = |(at, sentence)| {
            let found = sentences::check(&desk, at, sentence);
            let found = found.or_else(|error| desk.excused_sentence(at, sentence, error))?;
            Ok(desk.without_lost_laws(found, Some(sentence)))
        };
        let equations: Result<Vec<Equation>> = work.par_iter().with_max_len(1).map(|at| told(judged(*at))).collect();
        let sentences: Result<Vec<Equation>> =
            sentences.par_iter().enumerate().with_max_len(1).map(|s| told(sentence(s))).collect();
        let (equations, sentences) = (equations?, sentences?);
        let alone = equations.iter().filter(|equation| !equation.ok && is_wrong(equation)).count() == 1;
        // What several of them share comes first; but what a step follows from, and what it is to be mended to, depends on
        // those before it.
        let has_steps = !derivations.is_empty();
        let equations = if has_steps { equations } else { desk.with_shared_repairs(run, equations, &sentences) };
        let mended = |(at, equation): (&usize, Equation)| {
            let is_step = derivations.iter().flatten().any(|step| step == at);
            match is_step || !equation.repairs.is_empty() {
                true => Ok(equation),
                false => desk.with_repairs(run, *at, equation, alone),
            }
        };
        let equations: Result<Vec<Equation>> = work.par_iter().zip(equations).with_max_len(1).map(mended).collect();
        let equations = desk.with_steps(run, &derivations, (&work, equations?), judged)?;
        let equations = if has_steps { desk.with_shared_repairs(run, equations, &sentences) } else { equations };
        Ok(Document {
            path: notes.source.path.clone(),
            claims: Some(claims.source.path.clone()),
            source: notes.source.clone(),
            // Of one display alone nothing else is known.
            equations: if run.only.is_none() { desk.with_doubts(run, equations, &sentences) } else { equations },
            sentences,
            unnumbered: desk
                .assigned
                .iter()
                .zip(&notes.equations)
                .filter(|(claim, d)| claim.is_none() && id(d).is_none())
                .count(),
            inferred: desk.model.inferred.clone(),
        })
    })
}

/// The verdict on the first equation or sentence of a document that is not as expected, those before the others that
/// use what the `at`-th display introduces; none, if all are.
pub(super) fn first_unexpected(run: &Run<'_>, claims: &Claims, notes: &Notes, at: usize) -> Result<Option<Verdict>> {
    with_desk(run, claims, notes, |desk| {
        let introduced: Vec<SymbolId> = desk.readings[at].introduced.iter().map(|new| new.symbol).collect();
        let uses = |other: usize| {
            let members = desk.readings[other].statements.iter().flatten().flat_map(|s| &s.members);
            members.flat_map(|member| member.symbols()).any(|(symbol, _)| introduced.contains(&symbol))
        };
        let (mut order, rest): (Vec<usize>, Vec<usize>) =
            wanted(notes, desk.assigned, None).into_iter().filter(|other| *other != at).partition(|other| uses(*other));
        order.extend(rest);
        for other in order.iter().chain([&at]) {
            let found = desk.equation(*other, desk.assigned[*other])?;
            if !found.ok {
                return Ok(Some(found.finding.verdict));
            }
        }
        for (at, sentence) in claims.sentences.iter().enumerate() {
            let found = sentences::check(&desk, at, sentence)?;
            if !found.ok {
                return Ok(Some(found.finding.verdict));
            }
        }
        Ok(None)
    })
}

/// Another text of the same notes.
pub(super) fn retyped(notes: &Notes, text: String) -> Result<Notes> {
    let path = &notes.source.path;
    let kind = Kind::of(Path::new(path)).ok_or_else(|| Error::new(format!("{path} is not a kind of notes")))?;
    Notes::parse(Arc::new(Source::new(path.clone(), text)), kind)
}

/// The displays that are to be checked, by their places.
pub(super) fn wanted(notes: &Notes, assigned: &[Option<&Claim>], only: Option<&str>) -> Vec<usize> {
    let chosen = |display: &Display| only.is_none_or(|only| id(display) == Some(only));
    let claimed = |at: usize| id(&notes.equations[at]).is_some() || assigned[at].is_some();
    (0..notes.equations.len()).filter(|at| chosen(&notes.equations[*at]) && claimed(*at)).collect()
}

/// How many equations and sentences [`check_in`] will report.
pub fn items(claims: &Claims, notes: &Notes, only: Option<&str>) -> usize {
    equations(claims, notes, only) + if only.is_some() { 0 } else { claims.sentences.len() }
}

/// How many equations [`check_in`] will report; 0 where the claims do not fit the notes.
pub fn equations(claims: &Claims, notes: &Notes, only: Option<&str>) -> usize {
    assign(claims, notes).map_or(0, |assigned| wanted(notes, &assigned, only).len())
}

/// Lays all that a document's equations need on a desk, and has them worked on.
pub(super) fn with_desk<T>(
    run: &Run<'_>,
    claims: &Claims,
    notes: &Notes,
    work: impl FnOnce(Desk<'_>) -> Result<T>,
) -> Result<T> {
    let mut macros = Macros::default();
    define_macros(notes, &mut macros);
    repeated_numbers(notes)?;
    let mut model = Model::new(claims, macros, run.registry)?;
    let assigned = assign(claims, notes)?;
    let readings = reading::read_all(claims, notes, &assigned, &mut model)?;
    let (source, options) = (&*notes.source, run.options);
    let plain =
        Desk { claims, notes, source, model: &model, readings: &readings, assigned: &assigned, options, units: None };
    let (laws, lost_laws) = plain.laws()?;
    let lacks_a_name = |error: &Error| plain.cause(error.missing()).is_some();
    let known = units::declared(claims, &model, &lacks_a_name)?;
    (model.laws, model.lost_laws) = (laws, lost_laws);
    let units = units::of_document(claims, &model, &known, &readings, &assigned)?.map(Arc::new);
    let desk = Desk { claims, notes, source, model: &model, readings: &readings, assigned: &assigned, options, units };
    desk.granted_conflicts()?;
    work(desk)
}

/// Adds the commands that notes define.
pub(super) fn define_macros(notes: &Notes, macros: &mut Macros) {
    for definition in &notes.macros {
        macros.define(&definition.name, definition.arguments, &definition.body);
    }
}

/// Refuses two displays with one number: a claim about it would be about either.
fn repeated_numbers(notes: &Notes) -> Result<()> {
    match repeated(notes).first() {
        None => Ok(()),
        Some((number, line)) => {
            let message = format!("the number ({}) is used a second time, after line {line}", number.id);
            Err(Error::at(&notes.source, number.span, message).help("give each equation a number of its own"))
        }
    }
}

/// The numbers that stood on a display before, each with the line of the first.
pub(super) fn repeated(notes: &Notes) -> Vec<(&Numbered, usize)> {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    let mut repeated = Vec::new();
    for display in &notes.equations {
        let Some(number) = &display.number else { continue };
        match seen.get(number.id.as_str()) {
            Some(line) => repeated.push((number, *line)),
            None => drop(seen.insert(&number.id, display.line)),
        }
    }
    repeated
}

/// The report of notes that no claims file is about: every numbered equation is unclaimed.
pub fn unclaimed(notes: &Notes) -> Document {
    let equation = |display: &Display| {
        let message = "nothing says what this should mean: it has no claims file";
        let finding = Finding::new(Verdict::Unclaimed, display.body, message);
        Some(unjudged(notes, id(display)?, display.line, finding))
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

/// An equation of which no more is said than that it cannot be judged.
pub(super) fn unjudged(notes: &Notes, id: &str, line: usize, finding: Finding) -> Equation {
    Equation {
        id: id.to_owned(),
        line,
        latex: notes.source.slice(finding.span).to_owned(),
        reading: String::new(),
        finding,
        ok: false,
        because: None,
        parts: Vec::new(),
        repairs: Vec::new(),
        elsewhere: Vec::new(),
    }
}

/// What a message calls a display: its number or label, or the line that it is on.
pub(super) fn shown(display: &Display) -> String {
    id(display).map_or_else(|| format!("line {}", display.line), str::to_owned)
}

/// The number or else the first label of a display.
pub fn id(display: &Display) -> Option<&str> {
    let number = display.number.as_ref().or(display.labels.first());
    number.map(|numbered| numbered.id.as_str())
}

/// The claim of each display, where the claims file makes one.
pub(super) fn assign<'c>(claims: &'c Claims, notes: &Notes) -> Result<Vec<Option<&'c Claim>>> {
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
    // What is a step is tested, also where nothing more is claimed of it.
    for derivation in &claims.steps {
        for at in derivation.resolve(notes, &claims.source)? {
            assigned[at].get_or_insert(&NOTHING_MORE);
        }
    }
    Ok(assigned)
}

/// The claim that an equation holds.
static NOTHING_MORE: LazyLock<Claim> = LazyLock::new(Claim::default);

/// Refuses what the format has and this version does not check yet, rather than pass it over.
fn unsupported(claims: &Claims, address: &Address, claim: &Claim) -> Result<()> {
    let spans = [
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
