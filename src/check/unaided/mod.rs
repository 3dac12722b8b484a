//! The check of notes that have no claims file.
//!
//! The claims file is inferred (`guess`), and the notes are checked with it like any others. Then each finding is
//! weighed ([`gate`]): what holds follows, what gives a name a formula introduces it, and a relation that does not follow
//! is taken for granted. It is called wrong only if one likely slip lies between it and an equation that follows.
//! A free assumption is not one edit away from a theorem, so notes that state laws of nature are not called wrong.
//!
//! # Why nothing else is called wrong
//!
//! Without claims nobody says what the symbols mean. Most equations in notes are laws, conditions or values, and fail at
//! random states. A false "wrong" costs the trust that ten found slips earn. So the correction must be there before the
//! word is said, it must pass the check, and it must not be a triviality such as a = a.
//!
//! Offers [`unaided`], [`draft`] for the inferred claims as a file, and `guessed` for the check with such a file. Knows all
//! other folders of `check`.

mod calculus;
mod complex;
mod contradictions;
mod course;
mod dimensions;
mod explanations;
mod gate;
pub(super) mod guess;
mod indexed_states;
mod inline;
mod laws;
mod links;
mod motion;
mod nearness;
mod ordered;
mod premises;
mod printed_formulas;
mod prose;
mod remarks;
mod scope;
mod screen;
mod signs;
mod solutions;
mod special_cases;

use std::collections::{HashMap, HashSet};

#[cfg(feature = "cli")]
use std::sync::Arc;

#[cfg(feature = "cli")]
use crate::Error;
use crate::Result;
use crate::check::document::inferred::open_energies;
use crate::check::document::setup::{Run, define_macros, with_checker};
use crate::check::prose_claims;
use crate::check::run::check_in;
use crate::check::unaided::course::Judged;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::{Document, Equation};
use crate::latex::{Macros, lines};
#[cfg(feature = "cli")]
use crate::mechanics::System;
use crate::notes::{Claims, Display, Notes, Numbered};
use crate::source::Span;

use guess::corrections::Corrections;
use guess::declarations::Formula;
#[cfg(feature = "cli")]
pub use guess::draft::draft;
use guess::{arguments, inference, scopes};

/// Checks notes without a claims file.
///
/// # Errors
/// When no claims file makes sense of the notes.
#[cfg(feature = "cli")]
pub fn unaided(run: &Run<'_>, notes: &Notes) -> Result<Document> {
    let (mut equations, mut inferred) = by_scopes(run, notes, None)?;
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    inferred.extend(open_energies::left_out(notes, &open_energies::without_names(notes, &macros, true, &|_| false)));
    let judge = |edited: &Notes| Ok(by_scopes(run, edited, None)?.0);
    explanations::weighed(run, notes, &mut equations, &explanations::Judge { named: &with_ids, found: &judge })?;
    Ok(Document { claims: None, ..document(run, &with_ids(notes), (equations, Vec::new(), inferred)) })
}

/// The findings on the displays of notes, and the conclusions about symbols, where the author made some corrections of these.
fn by_scopes(run: &Run<'_>, notes: &Notes, corrections: Option<&Corrections>) -> Result<(Vec<Equation>, Vec<String>)> {
    let notes = with_ids(notes);
    let outline = scopes::Outline::of(&notes);
    let (mut equations, mut inferred) = (Vec::new(), Vec::new());
    // A letter that a later section uses for something else is another letter, so a new scope begins there.
    while equations.len() < notes.equations.len() {
        let (part, scope) = scopes::from(&notes, equations.len(), &outline);
        let infer = |formulas: &[Formula]| {
            let claims = inference::claims_with(run, &part, formulas)?;
            corrections.map_or(Ok(claims.clone()), |corrections| corrections.applied(claims))
        };
        let claims = infer(&[])?;
        let (mut found, concluded) = judged(run, &claims, &part, &scope)?;
        with_formulas(run, (&claims, &infer), &part, &scope, &mut found)?;
        equations.extend(found);
        let new: Vec<String> = concluded.into_iter().filter(|known| !inferred.contains(known)).collect();
        inferred.extend(new);
    }
    Ok((equations, inferred))
}

/// The system of the first part of notes without a claims file that defines a Lagrangian.
///
/// # Errors
/// When no claims file makes sense of the notes.
#[cfg(feature = "cli")]
pub fn system(run: &Run<'_>, notes: &Notes) -> Result<Option<Arc<System>>> {
    let notes = with_ids(notes);
    let outline = scopes::Outline::of(&notes);
    let mut seen = 0;
    while seen < notes.equations.len() {
        let (part, scope) = scopes::from(&notes, seen, &outline);
        let claims = inference::claims(run, &part)?;
        if let Some(system) = traced(run, &claims, &part)? {
            return Ok(Some(system));
        }
        seen += part.equations.len().saturating_sub(scope.carried).max(1);
    }
    Ok(None)
}

/// The system that the claims of notes name, or whose Lagrangian the notes define.
///
/// # Errors
/// For claims that do not fit the notes.
#[cfg(feature = "cli")]
pub fn system_of(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Option<Arc<System>>> {
    match claims.guesses {
        // Guesses are about the notes as they are read without a claims file.
        Some(_) => {
            let notes = with_ids(notes);
            traced(run, &prose_claims::with_guesses(run, claims, &notes), &notes)
        }
        None => traced(run, claims, &crate::check::document::setup::without_open_energies(claims, notes)),
    }
}

#[cfg(feature = "cli")]
fn traced(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Option<Arc<System>>> {
    with_checker(run, claims, notes, |checker| {
        let model = checker.model;
        let function = |at: &usize| model.symbols.entry(model.constants[*at].symbol).coefficient.as_ref();
        let unknown = model.parameters.iter().find_map(function).filter(|_| model.printed_lagrangian.is_some());
        if let Some(function) = unknown {
            let name = crate::formula::text::plain(&function.name.to_string());
            return Err(Error::new(format!(
                "the Lagrangian of the notes contains {name}, a function without a formula"
            ))
            .help(format!("write a formula in the place of {name}, such as -k/r for a potential V(r)")));
        }
        Ok(model.system.clone())
    })
}

/// Checks notes whose claims file has guesses. A display with a claim of its own is judged by it; the others are weighed.
///
/// # Errors
/// For claims that do not fit the notes.
pub(super) fn guessed(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    weighed(run, claims, notes)
}

/// The findings on the displays of a scope, and the conclusions about symbols. Where the notes solve an equation of motion, what
/// does not follow by itself is judged once more with that equation as a law.
fn judged(run: &Run<'_>, claims: &Claims, notes: &Notes, scope: &scope::Scope) -> Result<(Vec<Equation>, Vec<String>)> {
    let claims = &prose_claims::with_guesses(run, claims, notes);
    let (judged, laws, inferred) = with_checker(run, claims, notes, |checker| {
        let mut judged = course::judged(run, &checker, scope)?;
        dimensions::blame(&checker, scope.carried, &mut judged.found);
        let laws = laws::laws(&checker, scope.carried, &judged.found);
        Ok((judged, laws, checker.model.inferred.clone()))
    })?;
    let lawful = laws.added_to(claims)?;
    let judged = match &lawful {
        Some(lawful) => judged_with_laws(run, lawful, notes, (scope, &laws), judged)?,
        None => judged,
    };
    let claims = lawful.as_ref().unwrap_or(claims);
    let mut found = with_links(run, claims, notes, scope, judged)?;
    with_checker(run, claims, notes, |checker| {
        motion::weighed(&checker, scope, &mut found)?;
        contradictions::weighed(&checker, scope.carried, &mut found)?;
        for (equation, reading) in found.iter_mut().zip(checker.readings.iter().skip(scope.carried)) {
            if let Some(open) = gate::not_computed(equation, reading, checker.model) {
                *equation = open;
            }
        }
        Ok(())
    })?;
    Ok((found, inferred))
}

/// What infers the claims of notes in which some names have formulas.
type Infer<'a> = dyn Fn(&[Formula]) -> Result<Claims> + 'a;

/// Judges the displays once more that differentiate or integrate names with printed formulas, with these as definitions.
fn with_formulas(
    run: &Run<'_>,
    (claims, infer): (&Claims, &Infer<'_>),
    notes: &Notes,
    scope: &scope::Scope,
    found: &mut [Equation],
) -> Result<()> {
    let claims = prose_claims::with_guesses(run, claims, notes);
    let formulas = with_checker(run, &claims, notes, |checker| Ok(printed_formulas::sought(&checker, scope, found)))?;
    if formulas.given.is_empty() {
        return Ok(());
    }
    // The formulas help where they can be read, and take nothing away.
    let again = infer(&formulas.given).and_then(|claims| {
        let claims = prose_claims::with_guesses(run, &claims, notes);
        let scope = &scope::Scope {
            carried: scope.carried,
            sections: scope.sections.clone(),
            evaluated: formulas.evaluated.clone(),
            ..scope::Scope::whole()
        };
        let known =
            |at: usize| found.get(at.checked_sub(scope.carried)?).filter(|_| !formulas.concern(at, scope)).cloned();
        with_checker(run, &claims, notes, |checker| course::judged_again(run, &checker, scope, (&known, &[])))
    });
    if let Ok(again) = again {
        formulas.merged(found, &again.found, notes);
    }
    Ok(())
}

/// The findings, where the equalities of each chain that is taken for granted are judged one by one.
fn with_links(
    run: &Run<'_>,
    claims: &Claims,
    notes: &Notes,
    scope: &scope::Scope,
    judged: Judged,
) -> Result<Vec<Equation>> {
    let Judged { mut found, premises } = judged;
    let chains = with_checker(run, claims, notes, |checker| Ok(links::apart(&checker, scope.carried, &found)))?;
    let Some(apart) = chains else { return Ok(found) };
    let known = |at: usize| match at.checked_sub(scope.carried) {
        Some(place) => found.get(place).cloned(),
        None => None,
    };
    let longer = scope::Scope { carried: scope.carried, links: apart.links.clone(), ..scope::Scope::whole() };
    let judged = with_checker(run, claims, &apart.notes, |checker| {
        course::judged_again(run, &checker, &longer, (&known, &premises))
    });
    // The equalities help where they can be read, and take nothing away.
    if let Ok(judged) = judged {
        let links = judged.found.get(found.len()..).unwrap_or_default().to_vec();
        // An equality may contradict a display, and so be weighed against it.
        found.iter_mut().zip(judged.found).for_each(|(before, now)| *before = now);
        links::merged(&mut found, scope.carried, &apart, &links);
    }
    Ok(found)
}

/// The findings where the equations of motion that the notes solve are laws.
fn judged_with_laws(
    run: &Run<'_>,
    lawful: &Claims,
    notes: &Notes,
    (scope, laws): (&scope::Scope, &laws::Laws),
    judged: Judged,
) -> Result<Judged> {
    let known = |at: usize| {
        let equation = judged.found.get(at.checked_sub(scope.carried)?)?;
        let is_open = matches!(equation.finding.verdict, Verdict::Assumed | Verdict::Undecided);
        (!is_open || !laws.may_give(at, scope)).then(|| equation.clone())
    };
    let again = with_checker(run, lawful, notes, |checker| {
        course::judged_again(run, &checker, scope, (&known, &judged.premises))
    });
    // The laws help where they can be read, and take nothing away.
    Ok(again.ok().filter(|again| again.found.len() == judged.found.len()).unwrap_or(judged))
}

/// Checks notes with claims that nobody has confirmed.
fn weighed(run: &Run<'_>, claims: &Claims, printed: &Notes) -> Result<Document> {
    let notes = &with_ids(printed);
    let claimed = |equation: &Equation| -> Result<Option<Equation>> {
        let only = Run { only: Some(equation.id.as_str()), ..*run };
        Ok(check_in(&only, claims, notes)?.equations.into_iter().next())
    };
    let sentences = if claims.sentences.is_empty() { Vec::new() } else { check_in(run, claims, notes)?.sentences };
    let corrections = Corrections::of(run, claims, notes)?;
    let whole = |notes: &Notes| match &corrections {
        Some(corrections) => Ok(by_scopes(run, notes, Some(corrections))?.0),
        None => Ok(judged(run, claims, &with_ids(notes), &scope::Scope::whole())?.0),
    };
    let mut equations = whole(printed)?;
    explanations::weighed(run, printed, &mut equations, &explanations::Judge { named: &with_ids, found: &whole })?;
    with_checker(run, claims, notes, |checker| {
        for (at, equation) in equations.iter_mut().enumerate() {
            if checker.assigned[at].is_some()
                && let Some(found) = claimed(equation)?
            {
                *equation = found;
            }
        }
        let document = document(run, notes, (equations, sentences, checker.model.inferred.clone()));
        let definitions = checker.model.definitions();
        Ok(Document { claims: Some(claims.source.path.clone()), definitions, ..document })
    })
}

/// The report on notes with these findings on equations and sentences, and these conclusions about symbols.
fn document(
    run: &Run<'_>,
    notes: &Notes,
    (mut equations, sentences, inferred): (Vec<Equation>, Vec<Equation>, Vec<String>),
) -> Document {
    if let Some(only) = run.only {
        equations.retain(|equation| equation.id == only);
    }
    let inferred = [inferred, taken_from_sentences(notes, &mut equations)].concat();
    for equation in &mut equations {
        if let Some(rejected) = prose::rejected::found(notes, equation) {
            *equation = rejected;
        }
    }
    let defines = |equation: &&Equation| equation.finding.verdict == Verdict::Definition;
    let definitions = equations.iter().filter(defines).map(|equation| equation.latex.clone()).collect();
    Document {
        definitions,
        path: notes.source.path.clone(),
        claims: None,
        is_guessed: true,
        source: notes.source.clone(),
        equations: equations.into_iter().map(Equation::with_one_proposal).collect(),
        sentences,
        unnumbered: 0,
        inferred,
        automatic_numbers: notes.automatic_numbers(),
    }
}

/// Takes the formulas in sentences out of the findings; returns what they define.
fn taken_from_sentences(notes: &Notes, equations: &mut Vec<Equation>) -> Vec<String> {
    let inline = notes.equations.iter().filter(|display| inline::is_inline(notes, display));
    let lines: HashMap<&str, (usize, &str)> =
        inline.filter_map(|display| Some((display.id()?, (display.line, display.text.trim())))).collect();
    let mut found = Vec::new();
    equations.retain(|equation| {
        let Some((line, text)) = lines.get(equation.id.as_str()) else { return true };
        if matches!(equation.finding.verdict, Verdict::Definition | Verdict::Assumed) {
            found.push(format!("{text}, as the sentence in line {line} says"));
        }
        false
    });
    found
}

/// The notes, in which each statement of a display without a number is a display of its own, each display without a number
/// has the name `L` and its line, and no number is there twice.
fn with_ids(notes: &Notes) -> Notes {
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let mut notes = open_energies::without_names(notes, &macros, true, &|_| false).into_owned();
    if !complex::are_spoken_of(&notes) {
        notes.equations.iter_mut().for_each(|display| display.text = complex::without_stars(&display.text));
    }
    let rejected: Vec<bool> = (0..notes.equations.len()).map(|at| prose::rejected::is_rejected(&notes, at)).collect();
    for (display, is_rejected) in notes.equations.iter_mut().zip(rejected) {
        if is_rejected {
            display.text = prose::rejected::blank(&display.text);
            continue;
        }
        if let Some(text) = remarks::blanked(&display.text) {
            display.text = text;
        }
        if let Some(text) = arguments::blanked(&display.text) {
            display.text = text;
        }
    }
    let displays = notes.equations.iter().flat_map(|display| statements_of(display, &notes, &macros)).collect();
    notes.equations = inline::with_definitions(&notes, displays, &macros);
    let mut known: HashSet<String> = HashSet::new();
    for display in &mut notes.equations {
        let own = display.id().filter(|id| !known.contains(*id)).map(str::to_owned);
        let id = own.clone().unwrap_or_else(|| {
            let line = format!("L{}", display.line);
            let more = (2..).map(|n| format!("{line}.{n}"));
            std::iter::once(line.clone()).chain(more).find(|id| !known.contains(id)).unwrap_or(line)
        });
        if own.is_none() {
            display.number = Some(Numbered { id: id.clone(), span: display.body });
            display.labels.clear();
        }
        known.insert(id);
    }
    notes
}

/// The statements of a display as displays: each row of one without a number has a verdict of its own, and so has what stands
/// on either side of an arrow. The last of them has the number; in `align`, the row in which it is printed.
fn statements_of(display: &Display, notes: &Notes, macros: &Macros) -> Vec<Display> {
    let spans = match display.parts.len() {
        0 | 1 => lines::apart(&display.text, macros, display.id().is_some() && !display.numbers_rows),
        _ => None,
    };
    let Some(spans) = spans else { return vec![display.clone()] };
    let last = spans.len() - 1;
    let is_of = |numbered: &Numbered, at: usize| {
        let starts = |span: &Span| span.start + display.body.start <= numbered.span.start;
        let row = if display.numbers_rows { spans.iter().rposition(starts).unwrap_or(0) } else { last };
        row == at
    };
    let one = |(at, span): (usize, &Span)| {
        // An arrow at the beginning is a word about the first statement.
        let has_arrow = at == 0 && lines::implication(&display.text).is_some();
        let span = if has_arrow { Span::new(0, span.end) } else { *span };
        let body = span.shifted(display.body.start);
        let start = if at == 0 { display.span.start } else { body.start };
        let end = if at == last { display.span.end } else { body.end };
        // A row that goes on from the one before begins there, and is counted from its own line.
        let before = notes.source.text.get(display.span.start..body.start).unwrap_or_default();
        let line = display.line + before.matches('\n').count();
        Display {
            span: Span::new(start, end),
            body,
            parts: vec![body],
            text: display.text[span.start..span.end].to_owned(),
            number: display.number.clone().filter(|number| is_of(number, at)),
            labels: display.labels.iter().filter(|label| is_of(label, at)).cloned().collect(),
            automatic: display
                .automatic
                .get(at)
                .filter(|_| display.automatic.len() == spans.len())
                .cloned()
                .into_iter()
                .collect(),
            numbers_rows: false,
            line,
        }
    };
    spans.iter().enumerate().map(one).collect()
}
