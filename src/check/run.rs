//! The check of one document by its claims: each equation and sentence, then the steps of derivations, then repairs.

use rayon::prelude::*;

use crate::Result;
use crate::notes::Notes;
use crate::notes::claims::Claims;

use crate::check::document::names::is_wrong;
use crate::check::document::setup::{Run, wanted, with_checker};
use crate::check::equations::sentences;
use crate::check::verdict::report::{Document, Equation};

/// Checks a document as part of a run.
///
/// # Errors
/// For claims that do not fit the notes or the system, each at its place in the claims file.
pub fn check_in(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    for sentence in &claims.sentences {
        sentences::unsupported(claims, sentence)?;
    }
    with_checker(run, claims, notes, |checker| {
        let work = wanted(notes, checker.assigned, run.only);
        let sentences = if run.only.is_some() { &[] } else { claims.sentences.as_slice() };
        let path = notes.source.path.as_str();
        let reported = |equation: Result<Equation>| {
            run.progress.done(path);
            equation
        };
        let derivations = checker.derivations()?;
        let judged = |at: usize| {
            let found =
                checker.equation(at, checker.assigned[at]).or_else(|error| checker.equation_left_open(at, error))?;
            Ok(checker.without_unreadable_laws(found, None))
        };
        let sentence = |(at, sentence)| {
            let found = sentences::check(&checker, at, sentence);
            let found = found.or_else(|error| checker.sentence_left_open(at, sentence, error))?;
            Ok(checker.without_unreadable_laws(found, Some(sentence)))
        };
        let equations: Result<Vec<Equation>> =
            work.par_iter().with_max_len(1).map(|at| reported(judged(*at))).collect();
        let sentences: Result<Vec<Equation>> =
            sentences.par_iter().enumerate().with_max_len(1).map(|s| reported(sentence(s))).collect();
        let (equations, sentences) = (equations?, sentences?);
        let alone = equations.iter().filter(|equation| !equation.ok && is_wrong(equation)).count() == 1;
        // Shared repairs come first, except where there are steps: a step that follows from a false one gets no repair.
        let has_steps = !derivations.is_empty();
        let equations = if has_steps { equations } else { checker.with_shared_repairs(run, equations, &sentences) };
        let repaired = |(at, equation): (&usize, Equation)| {
            let is_step = derivations.iter().flatten().any(|step| step == at);
            match is_step || !equation.repairs.is_empty() {
                true => Ok(equation),
                false => checker.with_repairs(run, *at, equation, alone),
            }
        };
        let equations: Result<Vec<Equation>> = work.par_iter().zip(equations).with_max_len(1).map(repaired).collect();
        let equations = checker.with_steps(run, &derivations, (&work, equations?), judged)?;
        let equations = if has_steps { checker.with_shared_repairs(run, equations, &sentences) } else { equations };
        // With only one equation checked, no other can confirm its premises.
        let equations = match run.only {
            None => {
                let equations = checker.with_unconfirmed_premises(run, equations, &sentences);
                checker.without_definitions_of_wrong_displays(equations)
            }
            Some(_) => equations,
        };
        Ok(Document {
            path: notes.source.path.clone(),
            claims: Some(claims.source.path.clone()),
            is_guessed: false,
            source: notes.source.clone(),
            equations: equations.into_iter().map(Equation::with_one_proposal).collect(),
            automatic_numbers: notes.automatic_numbers(),
            sentences,
            unnumbered: checker
                .assigned
                .iter()
                .zip(&notes.equations)
                .filter(|(claim, d)| claim.is_none() && d.id().is_none())
                .count(),
            inferred: checker.model.inferred.clone(),
            definitions: checker.model.definitions(),
        })
    })
}
