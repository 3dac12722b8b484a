//! Which special cases that the words around displays state hold: displays that fail in general pass with them, or edits make them pass.

use crate::notes::Notes;
use crate::notes::claims::Claims;

use crate::check::document::setup::{Run, with_checker};
use crate::check::sample::context::Options;
use crate::check::verdict::report::Document;

use super::conditions;
use super::notes_names::NotesNames;
use super::{ProseClaim, added, has_lagrangian, is_refuted, join};

/// The claims that displays that fail are about special cases, which the words around them state. `dropped` are claims that
/// something is conserved, which do not hold in general.
pub(super) fn special_cases(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    found: &Document,
    dropped: &[ProseClaim],
) -> Vec<ProseClaim> {
    let (mut special, doubtful) = cases(run, (claims, notes), found, dropped);
    let with = added(claims, notes, &special);
    special.extend(correctable(run, (&with, notes), doubtful));
    special
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
    let options = Options { explain: false, ..run.options };
    let brief = Run { options, ..*run };
    for scope in conditions::Scope::ALL {
        let about = |at: usize| {
            let mut case = conditions::infer(&names, at, scope)?;
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

/// Which of some claims hold: their displays pass with them, and which are refuted. Those that do not fit their displays are neither.
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
                Some((equation.ok, is_refuted(&equation)))
            };
            Ok(said.iter().map(|claim| claim.displays.first().and_then(verdict)).collect::<Vec<_>>())
        });
        let Ok(found) = found else { break };
        if found.iter().all(|verdict| matches!(verdict, Some((true, _)))) {
            return (said, refuted);
        }
        let mut kept = Vec::new();
        for (claim, verdict) in said.into_iter().zip(found) {
            match verdict {
                Some((true, _)) => kept.push(claim),
                Some((false, true)) => refuted.push(claim),
                Some((false, false)) | None => {}
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
