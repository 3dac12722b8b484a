//! Which special cases that the words around displays state hold: displays that fail in general pass with them, or edits make them pass.

use crate::code::Code;
use crate::notes::Notes;
use crate::notes::claims::Claims;

use crate::check::document::setup::{Run, with_checker};
use crate::check::sample::context::Options;
use crate::check::verdict::report::Document;

use super::conditions;
use super::notes_names::NotesNames;
use super::places;
use super::{ProseClaim, added, has_lagrangian, is_refuted, join};

/// The claims that displays that fail are about special cases, which the words around them state. `dropped` are claims that
/// something is conserved, which do not hold in general.
pub(super) fn special_cases(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    found: &Document,
    dropped: &[ProseClaim],
) -> Vec<ProseClaim> {
    let (mut special, mut doubtful) = cases(run, (claims, notes), found, dropped);
    let with = added(claims, notes, &special);
    let untested: Vec<ProseClaim> = doubtful.extract_if(.., |claim| claim.is_untested).collect();
    special.extend(correctable(run, (&with, notes), doubtful));
    // Nothing refutes a display about a motion that no sampled state has.
    let is_open = |claim: &ProseClaim| !special.iter().any(|other| other.displays == claim.displays);
    let untested: Vec<ProseClaim> = untested.into_iter().filter(is_open).collect();
    special.extend(untested);
    special
}

/// Adds to claims that a display contradicts the case that the words around this display state, where all displays pass with it: "for equal
/// masses the normal frequencies are". Returns whether there are some.
pub(super) fn complete(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    found: Option<&Document>,
    said: &mut [ProseClaim],
) -> bool {
    let Some(found) = found else { return false };
    let mut is_any = false;
    for at in 0..said.len() {
        let all_pass = |with: &ProseClaim| {
            let others = said.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, claim)| claim.clone());
            let all: Vec<ProseClaim> = others.chain([with.clone()]).collect();
            let pass = with_checker(run, &added(claims, notes, &all), notes, |checker| {
                let passes = |at: &usize| {
                    checker.equation(*at, checker.assigned[*at]).is_ok_and(|equation| super::passes(&equation))
                };
                Ok(with.displays.iter().all(passes))
            });
            pass.unwrap_or(false)
        };
        let completed = in_cases((claims, notes), found, &said[at]).into_iter().find(all_pass);
        if let Some(with) = completed {
            said[at] = ProseClaim { is_doubtful: false, ..with };
            is_any = true;
        }
    }
    is_any
}

/// A claim about a frequency that displays contradict, in each of the cases that the words around these displays state.
pub(super) fn in_cases((claims, notes): (&Claims, &Notes), found: &Document, said: &ProseClaim) -> Vec<ProseClaim> {
    let of_frequencies = said.means.iter().any(|(_, what)| what.contains("frequency") || what.contains("period"));
    if !said.is_doubtful || !of_frequencies {
        return Vec::new();
    }
    let names = NotesNames::of(claims, notes);
    let places = places::known(&names);
    let formula_of = |name: &str| formula_of(&names, found, name);
    let is_refuted_here = |at: usize| {
        let id = notes.equations[at].id();
        found.equations.iter().any(|equation| Some(equation.id.as_str()) == id && is_refuted(equation))
    };
    let refuted: Vec<usize> = said.displays.iter().copied().filter(|at| is_refuted_here(*at)).collect();
    let in_scope = |scope: conditions::Scope| -> Option<ProseClaim> {
        let mut with = said.clone();
        for display in &refuted {
            let case = conditions::infer(&names, *display, scope, &places, &formula_of)?;
            with.constants.extend(case.constants);
            with.claims.extend(case.claims);
            with.why = format!("{}; {}", with.why, case.why);
        }
        Some(with)
    };
    conditions::Scope::ALL.into_iter().filter_map(in_scope).collect()
}

/// The last formula of a name in a display that passes, if it is part of a chain.
fn formula_of(names: &NotesNames<'_>, found: &Document, name: &str) -> Option<String> {
    let mut displays = names.displays_with(name).into_iter().filter(|at| names.is_given_in(*at, name));
    let at = displays.next().filter(|_| displays.next().is_none())?;
    let id = names.notes.equations[at].id();
    let passes = found.equations.iter().any(|equation| Some(equation.id.as_str()) == id && equation.ok);
    let text = names.notes.equations[at].text.trim().trim_end_matches([',', '.', ';']);
    let is_plain = !["\\quad", "\\\\", "&", "\\text"].iter().any(|mark| text.contains(mark));
    let members: Vec<&str> = text.split('=').map(str::trim).collect();
    (passes && is_plain && members.len() > 2).then(|| members.last().copied().unwrap_or_default().to_owned())
}

/// The same, as far as the displays pass, and the claims that are refuted.
pub(super) fn cases(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    found: &Document,
    dropped: &[ProseClaim],
) -> (Vec<ProseClaim>, Vec<ProseClaim>) {
    let (mut special, mut doubtful) = (Vec::new(), Vec::new());
    if !has_lagrangian(claims) {
        return (special, doubtful);
    }
    let names = NotesNames::of(claims, notes);
    let fails = |at: usize| {
        let id = notes.equations[at].id();
        let equation = found.equations.iter().find(|equation| Some(equation.id.as_str()) == id);
        equation.is_some_and(|equation| !equation.ok && !equation.finding.is_untested_definition())
    };
    let dropped = |at: usize| dropped.iter().find(|one| one.displays.contains(&at));
    let mut open: Vec<usize> =
        (0..notes.equations.len()).filter(|at| names.is_free(*at) && (fails(*at) || dropped(*at).is_some())).collect();
    let places = places::known(&names);
    let formula_of = |name: &str| formula_of(&names, found, name);
    let options = Options { explain: false, ..run.options };
    let brief = Run { options, ..*run };
    for scope in conditions::Scope::ALL {
        let about = |at: usize| {
            let mut case = conditions::infer(&names, at, scope, &places, &formula_of)?;
            if let Some(conserved) = dropped(at) {
                case.claims.iter_mut().for_each(|(_, claim)| join(claim, &conserved.claims[0].1));
            }
            Some(case)
        };
        let said: Vec<ProseClaim> = open.iter().filter_map(|at| about(*at)).collect();
        let (new, refuted) = tested(&brief, (&added(claims, notes, &special), notes), said);
        open.retain(|at| !new.iter().any(|claim| claim.displays.contains(at)));
        special.extend(new);
        // The nearest words count.
        let is_new = |claim: &ProseClaim| doubtful.iter().all(|other: &ProseClaim| other.displays != claim.displays);
        let refuted: Vec<ProseClaim> = refuted.into_iter().filter(is_new).collect();
        doubtful.extend(refuted);
        doubtful.retain(|claim| open.contains(&claim.displays[0]));
    }
    (special, doubtful)
}

/// Which of some claims hold: their displays pass with them, and which are refuted, or are about a motion whose start no sampled state has.
/// Those that do not fit their displays are neither.
fn tested(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    mut said: Vec<ProseClaim>,
) -> (Vec<ProseClaim>, Vec<ProseClaim>) {
    let mut refuted = Vec::new();
    while !said.is_empty() {
        let found = with_checker(run, &added(claims, notes, &said), notes, |checker| {
            let verdict = |at: &usize| {
                let equation = checker.equation(*at, checker.assigned[*at]).ok()?;
                Some((equation.ok, is_refuted(&equation), equation.finding.code))
            };
            Ok(said.iter().map(|claim| claim.displays.first().and_then(verdict)).collect::<Vec<_>>())
        });
        let Ok(found) = found else { break };
        if found.iter().all(|verdict| matches!(verdict, Some((true, ..)))) {
            return (said, refuted);
        }
        let mut kept = Vec::new();
        for (claim, verdict) in said.into_iter().zip(found) {
            match verdict {
                Some((true, ..)) => kept.push(claim),
                Some((false, true, _)) => refuted.push(claim),
                Some((_, _, Code::NoState)) if claim.claims_a_start() => {
                    refuted.push(ProseClaim { is_untested: true, ..claim });
                }
                Some(_) | None => {}
            }
        }
        said = kept;
    }
    (Vec::new(), refuted)
}

/// The claims that are refuted, and whose own displays an edit makes pass.
fn correctable(run: &Run<'_>, (claims, notes): (&Claims, &Notes), mut said: Vec<ProseClaim>) -> Vec<ProseClaim> {
    let found = with_checker(run, &added(claims, notes, &said), notes, |checker| {
        let has_edit = |at: &usize| {
            let equation = checker.equation(*at, checker.assigned[*at]);
            let repaired = equation.and_then(|equation| checker.with_repairs(run, *at, equation, false));
            repaired.is_ok_and(|equation| !equation.repairs.is_empty())
        };
        Ok(said.iter().map(|claim| claim.displays.iter().all(has_edit)).collect::<Vec<bool>>())
    });
    let mut found = found.unwrap_or_default().into_iter();
    said.retain(|_| found.next() == Some(true));
    said
}
