//! Displays that contradict a definition: which of the two is called wrong.
//!
//! Where a display does not follow from a definition, the slip may be in either ([`Culprit`]). The other displays that use the
//! name decide. Where none does, one of the two is wrong and nobody can tell which: the report says so, shows an edit of each,
//! and calls neither wrong. The same is asked of relations that are taken for granted ([`premises`]), and of displays that follow
//! from nothing, but would if one of these were corrected ([`unsupported`]).
//!
//! Offers `weighed`, which changes the findings on displays that contradict each other. Knows `repair` and below.

pub(super) mod premises;
pub(super) mod unsupported;
mod vouched;

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::repair::culprit::is_common;
use crate::check::repair::suggest::Search;
use crate::check::unaided::dimensions;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Statement};
use crate::latex::slips::Slip;
use crate::notes::claims::Claim;
use crate::phrases;

/// Weighs the displays that were called wrong and use definitions; `first` is the place of the first finding.
///
/// # Errors
/// As for a check of an equation.
pub(super) fn weighed(checker: &Checker<'_>, first: usize, found: &mut [Equation]) -> Result<()> {
    for place in 0..found.len() {
        let equation = &found[place];
        // What is a multiple of the other side is wrong without an edit too.
        let is_weighed = equation.finding.code == Code::SidesDiffer || !equation.repairs.is_empty();
        let is_wrong = equation.finding.verdict == Verdict::Refuted && is_weighed;
        if !is_wrong || checker.model.system.is_some() {
            continue;
        }
        let Some(culprit) = checker.culprit(first + place)? else { continue };
        // No author means a definition whose terms have different dimensions.
        if dimensions::are_spoilt(checker, culprit.at, &culprit.repair) {
            continue;
        }
        let is_common_here = found[place].repairs.iter().any(|repair| is_common(repair.slip));
        let is_common_there = is_common(culprit.repair.slip) && !takes_a_root(checker, &culprit.repair);
        let Some(defined) = culprit.at.checked_sub(first) else { continue };
        if is_common_here && !is_common_there {
            continue;
        }
        let (id, name) = (found[place].id.clone(), found[defined].id.clone());
        // Two formulas for one name are alike: neither is more likely wrong for being the first.
        let are_alike = culprit.others.is_empty() && gives_its_name(checker, first + place, culprit.at);
        let may_be_wrong_here = || -> Result<bool> {
            let none = Claim::default();
            Ok(is_common_here || wrong_itself(checker, first + place, &none)?.is_some())
        };
        if !are_alike && is_common_there && (!culprit.others.is_empty() || !may_be_wrong_here()?) {
            let message = match culprit.others.len() {
                0 => format!("({id}) contradicts this definition, but agrees with it after the suggested edit"),
                1 => format!("({id}) and another display contradict this definition"),
                others => format!("({id}) and {others} other displays contradict this definition"),
            };
            found[defined] = refuted(&found[defined], &culprit.repair, message);
            for equation in
                found.iter_mut().filter(|equation| equation.id == id || culprit.others.contains(&equation.id))
            {
                *equation = consistent(equation, &name);
            }
        } else {
            found[defined] = contradicted(&found[defined], &id);
            found[place] = open(&found[place], &name, culprit.repair);
        }
    }
    unsupported::against_definitions(checker, first, found)
}

/// The finding that a display is wrong, if a slip of its own that authors often make explains it. What is said of another display must
/// not be said where the edits of this one were not tried.
fn wrong_itself(checker: &Checker<'_>, at: usize, claim: &Claim) -> Result<Option<Equation>> {
    let found = checker.equation(at, Some(claim))?;
    if found.finding.verdict != Verdict::Refuted {
        return Ok(None);
    }
    let mut repairs = checker.own_repairs(at, &found, claim, Search::Thorough)?;
    let is_usual = |repair: &Repair| is_common(repair.slip) || is_number(checker, repair);
    repairs.retain(|repair| is_usual(repair) && !dimensions::are_spoilt(checker, at, repair));
    Ok((!repairs.is_empty()).then_some(Equation { repairs, ..found }))
}

/// Whether a correction puts in or leaves out a number as a factor.
pub(super) fn is_number(checker: &Checker<'_>, repair: &Repair) -> bool {
    let printed = checker.source.slice(repair.span);
    let has_letter = |text: &str| {
        let marks = ["\\frac", "\\tfrac", "\\dfrac", "\\cdot", "\\left", "\\right"];
        marks.iter().fold(text.to_owned(), |text, mark| text.replace(mark, "")).contains(char::is_alphabetic)
    };
    repair.slip == Slip::Factor && !has_letter(printed) && !has_letter(&repair.replacement)
}

/// Whether a display gives a formula to a name that another one defines.
fn gives_its_name(checker: &Checker<'_>, at: usize, definition: usize) -> bool {
    let first = |statement: &Statement| statement.members.first().and_then(Expr::as_plain_symbol);
    let named = checker.readings[at].statements.iter().flatten().filter_map(first);
    named.into_iter().any(|id| checker.readings[definition].introduced.iter().any(|new| new.symbol == id))
}

/// Whether an edit puts a root around what has none, and by that gives a name another dimension.
fn takes_a_root(checker: &Checker<'_>, repair: &Repair) -> bool {
    let printed = checker.source.slice(repair.span).trim();
    repair
        .replacement
        .trim()
        .strip_prefix("\\sqrt{")
        .is_some_and(|inner| inner.trim_end_matches('}').trim_end() == printed.trim_end_matches('}').trim_end())
}

/// A definition or a premise, called wrong.
pub(super) fn refuted(equation: &Equation, repair: &Repair, message: String) -> Equation {
    let mut repair = repair.clone();
    repair.shared = None;
    let finding = Finding::new(Code::DefinitionContradicted, Verdict::Refuted, equation.finding.span, message);
    Equation { finding, parts: Vec::new(), repairs: vec![repair], ok: false, ..equation.clone() }
}

/// A display that follows once another one is corrected.
fn consistent(equation: &Equation, other: &str) -> Equation {
    undecided(equation, format!("this follows once ({other}) is corrected"))
}

/// A display that another one contradicts, where nobody can tell which of the two is wrong.
pub(super) fn contradicted(equation: &Equation, other: &str) -> Equation {
    undecided(equation, format!("({other}) contradicts this, and one of the two is wrong"))
}

/// A display that others contradict together, where nobody can tell which of them is wrong.
pub(super) fn contradicted_by_several(equation: &Equation, others: &[String]) -> Equation {
    undecided(
        equation,
        format!("{} contradict this together, and one of these displays is wrong", phrases::displays(others, "and")),
    )
}

/// A display that is left open, for the reason that the message gives.
pub(super) fn undecided(equation: &Equation, message: String) -> Equation {
    let finding = Finding::new(Code::NotDecided, Verdict::Undecided, equation.finding.span, message);
    Equation { finding, parts: Vec::new(), repairs: Vec::new(), elsewhere: Vec::new(), ok: true, ..equation.clone() }
}

/// A display that contradicts another one, where nobody can tell which of the two is wrong; `repair` is an edit of the other.
pub(super) fn open(equation: &Equation, other: &str, repair: Repair) -> Equation {
    open_beside(equation, format!("this contradicts ({other}), and one of the two is wrong"), repair)
}

/// The same where several displays contradict it together; `repair` is an edit of one of them.
pub(super) fn open_beside_several(equation: &Equation, others: &[String], repair: Repair) -> Equation {
    let message = format!("this contradicts {}, and one of these displays is wrong", phrases::displays(others, "and"));
    open_beside(equation, message, repair)
}

fn open_beside(equation: &Equation, message: String, repair: Repair) -> Equation {
    let finding =
        Finding { verdict: Verdict::Undecided, code: Code::Contradiction, message, ..equation.finding.clone() };
    let repairs = equation.repairs.iter().take(1).cloned().chain([repair]).collect();
    Equation { finding, parts: Vec::new(), repairs, ok: false, ..equation.clone() }
}
