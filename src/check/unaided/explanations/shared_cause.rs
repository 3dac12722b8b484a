//! Displays that are wrong because a definition or the Lagrangian is.
//!
//! A wrong Lagrangian makes every equation of motion wrong, and each of these has a correction with which it follows from the wrong
//! Lagrangian. The correction that makes the most displays follow is the author's slip: one of what the wrong displays use, or one of
//! a wrong display itself.
//!
//! Offers `weighed`.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::document::setup::{Run, with_checker};
use crate::check::prose_claims;
use crate::check::repair::culprit::is_common;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::repair::suggest::is_in_source;
use crate::check::sample::context::Options;
use crate::check::unaided::contradictions::{refuted, undecided};
use crate::check::unaided::dimensions;
use crate::check::unaided::explanations::Judge;
use crate::check::unaided::explanations::consequences::{corrected, with_repair};
use crate::check::unaided::guess::inference;
use crate::check::unaided::inline;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::formula::{Expr, SymbolId};
use crate::latex::slips::{self, Pool};
use crate::notes::{Claims, Notes};

/// The most definitions that are suspected, the nearest to the first wrong display first.
const SUSPECTED: usize = 4;

/// The most edits of one definition that are tried, the likeliest first.
const TRIED: usize = 40;

/// The largest number that is likely in the place of another one.
const LARGEST: u32 = 4;

/// The most edits with which the whole notes are judged again.
const JUDGED: usize = 4;

/// An edit of a definition.
struct Suspicion {
    at: usize,
    repair: Repair,
}

/// Weighs the wrong displays of notes against the definitions that they use.
///
/// # Errors
/// As for a check of the notes.
pub(super) fn weighed(run: &Run<'_>, notes: &Notes, found: &mut [Equation], judge: &Judge<'_>) -> Result<()> {
    let wrong: Vec<usize> = (0..found.len()).filter(|at| found[*at].finding.verdict == Verdict::Refuted).collect();
    // What follows with a definition as it is printed speaks for it; without a display that lost what it rests on, nothing speaks
    // against it but the wrong display.
    let is_open = |equation: &Equation| equation.finding.verdict == Verdict::Assumed;
    if wrong.is_empty() || wrong.len() < 2 && !found.iter().any(is_open) {
        return Ok(());
    }
    let quick = Run { options: Options { explain: false, deduction: true, ..run.options }, ..*run };
    let read = (judge.named)(notes);
    let claims = inference::claims(run, &read)?;
    let claims = prose_claims::with_guesses(&quick, &claims, &read);
    let suspected = with_checker(&quick, &claims, &read, |checker| Ok(suspected(&checker, &wrong, found)));
    let Ok((suspicions, tested)) = suspected else { return Ok(()) };
    let mut best: Option<(usize, Suspicion)> = None;
    let mut judged = 0;
    for suspicion in suspicions {
        if judged == JUDGED {
            break;
        }
        let Some(edited) = with_repair(notes, &suspicion.repair) else { continue };
        if !pass(&quick, &claims, &(judge.named)(&edited), &tested) {
            continue;
        }
        judged += 1;
        let again = (judge.found)(&edited)?;
        let is_right = again.len() == found.len()
            && again.iter().all(|equation| equation.ok)
            && found.iter().zip(&again).all(|(was, is)| !follows(was) || follows(is));
        let support = again.iter().filter(|equation| follows(equation)).count();
        if is_right && best.as_ref().is_none_or(|(most, _)| support > *most) {
            best = Some((support, suspicion));
        }
    }
    let Some((support, Suspicion { at, repair })) = best else { return Ok(()) };
    // One correction stands against another one.
    let mut own = found.iter().filter(|equation| follows(equation)).count() + 1;
    for at in &wrong {
        if let Some(again) = corrected(notes, &found[*at], judge.found)? {
            own = own.max(again.iter().filter(|equation| follows(equation)).count());
        }
    }
    if support <= own {
        return Ok(());
    }
    let ids: Vec<String> = wrong.iter().map(|at| format!("({})", found[*at].id)).collect();
    let message = match ids.as_slice() {
        [id] => format!("{id} contradicts this, and other displays follow once this is corrected"),
        _ => format!("{} contradict this", ids.join(" and ")),
    };
    found[at] = refuted(&found[at], &repair, message);
    for place in wrong {
        let message = format!("this is no longer wrong once ({}) is corrected", found[at].id);
        found[place] = undecided(&found[place], message);
    }
    Ok(())
}

/// Whether a display follows from others.
fn follows(equation: &Equation) -> bool {
    matches!(equation.finding.verdict, Verdict::Certified | Verdict::Verified)
}

/// The edits of what wrong displays use, the likeliest of each first, and the wrong displays that fail by themselves.
fn suspected(checker: &Checker<'_>, wrong: &[usize], found: &[Equation]) -> (Vec<Suspicion>, Vec<usize>) {
    let none = Default::default();
    let fails = |at: &&usize| {
        let equation = checker.equation(**at, checker.assigned[**at].or(Some(&none)));
        equation.is_ok_and(|equation| equation.finding.verdict == Verdict::Refuted)
    };
    let tested: Vec<usize> = wrong.iter().filter(fails).copied().collect();
    let (model, notes) = (checker.model, checker.notes);
    let Some(first) = tested.first() else { return (Vec::new(), tested) };
    let lagrangian = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let lagrangian = lagrangian.map(|(whole, _)| whole);
    let members: Vec<&Expr> =
        checker.readings[*first].statements.iter().flatten().flat_map(|statement| &statement.members).collect();
    let is_used = |id: SymbolId| {
        let in_lagrangian = lagrangian.is_some_and(|whole| whole == id || model.symbol_depends_on(whole, &[id]));
        in_lagrangian || members.iter().any(|member| model.depends_on(member, &[id]))
    };
    let is_suspect = |at: &usize| {
        let is_definition = matches!(found[*at].finding.verdict, Verdict::Definition | Verdict::Assumed);
        let display = &notes.equations[*at];
        is_definition
            && !inline::is_inline(notes, display)
            && checker.readings[*at].introduced.iter().any(|new| is_used(new.symbol))
    };
    let places = (0..*first).rev().chain(first + 1..notes.equations.len()).filter(is_suspect).take(SUSPECTED);
    let (symbols, macros) = (&model.symbols, &model.macros);
    let mut all = Vec::new();
    for at in places {
        let display = &notes.equations[at];
        let mut edits = slips::corrections(&display.text, symbols, macros, &Pool::empty());
        edits.retain(|edit| {
            is_common(edit.slip)
                && !edit.replacement.parse::<u32>().is_ok_and(|number| number > LARGEST)
                && !["\\pm", "\\mp"].contains(&edit.replacement.trim())
                && !adds_parentheses(&display.text, edit)
                && is_in_source(checker, &display.text, edit, display.body.start)
        });
        edits.sort_by_key(|edit| rank(&display.text, edit, false));
        edits.truncate(TRIED);
        let repairs = edits.into_iter().map(|edit| Repair::of(edit, display.body.start, Verdict::Verified));
        let meant = repairs.filter(|repair| !dimensions::are_spoilt(checker, at, repair));
        all.extend(meant.map(|repair| Suspicion { at, repair }));
    }
    (all, tested)
}

/// Whether displays pass by themselves in edited notes.
fn pass(run: &Run<'_>, claims: &Claims, edited: &Notes, tested: &[usize]) -> bool {
    let none = Default::default();
    let all = |checker: Checker<'_>| {
        let passes = |at: &usize| {
            let claim = checker.assigned.get(*at).copied().flatten().or(Some(&none));
            *at < checker.readings.len()
                && checker.equation(*at, claim).is_ok_and(|equation| equation.finding.verdict.passes())
        };
        Ok(tested.iter().all(passes))
    };
    with_checker(run, claims, edited, all).unwrap_or(false)
}
