//! Displays that follow from nothing, and would follow if one likely slip in what they rest on were corrected.
//!
//! A consequence is no law of nature, so one that does not follow has a slip, or what it rests on has one. Where no slip in the
//! display explains that, one in a definition or in a premise may. A premise from which something else follows is right.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::repair::culprit::is_common;
use crate::check::unaided::contradictions::premises::edited;
use crate::check::unaided::contradictions::{
    consistent, contradicted, contradicted_by_several, gives_its_name, open, open_beside_several, refuted, wrong_itself,
};
use crate::check::unaided::course::Course;
use crate::check::unaided::dimensions;
use crate::check::unaided::gate;
use crate::check::unaided::inline;
use crate::check::unaided::premises::{self, Premise, Said};
use crate::check::unaided::prose;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Equation;
use crate::formula::{Expr, Statement, SymbolId};
use crate::latex::slips::{self, Pool, Slip};
use crate::notes::claims::Claim;
use crate::source::Span;

/// Weighs the displays that follow from nothing against the definitions that they use.
///
/// # Errors
/// As for a check of an equation.
pub(super) fn against_definitions(checker: &Checker<'_>, first: usize, found: &mut [Equation]) -> Result<()> {
    for place in 0..found.len() {
        let at = first + place;
        if checker.model.system.is_some() || !is_open(&found[place]) {
            continue;
        }
        let words = prose::before(checker.notes, at);
        if words.other_case || words.announced.is_supposed() {
            continue;
        }
        if !fails_by_definitions(checker, at)? {
            continue;
        }
        let Some(culprit) = checker.culprit(at)? else { continue };
        let Some(defined) = culprit.at.checked_sub(first).filter(|defined| *defined < found.len()) else { continue };
        let is_about_another = prose::object(checker.notes, at) != prose::object(checker.notes, culprit.at);
        let is_untouched = matches!(found[defined].finding.verdict, Verdict::Definition | Verdict::Assumed);
        if culprit.at > at
            || is_about_another
            || !is_untouched
            || !is_plain(culprit.repair.slip)
            || gives_its_name(checker, at, culprit.at)
            || dimensions::are_spoilt(checker, culprit.at, &culprit.repair)
        {
            continue;
        }
        let message = explained(&found[place].id, "definition");
        let (id, name) = (found[place].id.clone(), found[defined].id.clone());
        if let Some(wrong) = wrong_itself(checker, at, &Claim::default())? {
            found[defined] = contradicted(&found[defined], &id);
            found[place] = open(&wrong, &name, culprit.repair);
            continue;
        }
        found[defined] = refuted(&found[defined], &culprit.repair, message);
        found[place] = consistent(&found[place], &name);
    }
    Ok(())
}

/// Weighs the displays that the words call consequences, and that follow from nothing, against their premises.
///
/// # Errors
/// As for a check of an equation.
pub(in crate::check::unaided) fn against_premises(course: &Course<'_, '_>, found: &mut [Equation]) -> Result<()> {
    let first = course.scope.carried;
    for (at, set) in &course.unsupported {
        let Some(place) = at.checked_sub(first).filter(|place| found.get(*place).is_some_and(is_open)) else {
            continue;
        };
        // In a special case a law may look otherwise.
        if set.iter().any(|premise| course.sets_a_value(premise.at)) || !course.left_open_by_a_case(*at).is_empty() {
            continue;
        }
        for premise in set {
            let Some(premised) = premise.at.checked_sub(first) else { continue };
            let is_free = premise.said == Said::Whole
                && !premise.is_inline
                && !course.confirmed.contains(&premise.at)
                && found[premised].finding.verdict == Verdict::Assumed
                && !(uses_a_later_formula(course.checker, premise.at)
                    || set.len() == 1 && is_alike(course.checker, *at, premise));
            if !is_free {
                continue;
            }
            let Some(repair) = edited(course, *at, set, premise)?.filter(|repair| is_plain(repair.slip)) else {
                continue;
            };
            let (id, name) = (found[place].id.clone(), found[premised].id.clone());
            let beside = beside(course, (*at, set, premise), found)?;
            if !beside.is_empty() {
                let others = |own: &String| [std::slice::from_ref(own), &beside].concat();
                found[premised] = contradicted_by_several(&found[premised], &others(&id));
                found[place] = open_beside_several(&found[place], &others(&name), repair);
                break;
            }
            let claim = premises::claim(&set.iter().collect::<Vec<&Premise>>());
            if let Some(wrong) = wrong_itself(course.checker, *at, &claim)? {
                found[premised] = contradicted(&found[premised], &id);
                found[place] = open(&wrong, &name, repair);
                break;
            }
            found[premised] = refuted(&found[premised], &repair, explained(&id, "relation"));
            found[place] = consistent(&found[place], &name);
            break;
        }
    }
    Ok(())
}

/// The other displays that may be wrong where one does not follow from a premise: the other premises, and the definitions of which
/// no display that follows uses the name, if one edit of them explains it too.
fn beside(
    course: &Course<'_, '_>,
    (at, set, premise): (usize, &[Premise], &Premise),
    found: &[Equation],
) -> Result<Vec<String>> {
    let (checker, first) = (course.checker, course.scope.carried);
    let names = |at: usize| {
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        members.flat_map(|member| gate::names(member, checker.model)).collect::<Vec<SymbolId>>()
    };
    let used = [names(at), names(premise.at)].concat();
    let is_tested = |id: SymbolId| {
        let follows = |equation: &Equation| matches!(equation.finding.verdict, Verdict::Certified | Verdict::Verified);
        (0..found.len()).any(|place| follows(&found[place]) && names(first + place).contains(&id))
    };
    let is_doubtful = |place: &usize| {
        let introduced = &checker.readings[*place].introduced;
        introduced.iter().any(|new| used.contains(&new.symbol) && !is_tested(new.symbol))
    };
    let claim = premises::claim(&set.iter().collect::<Vec<&Premise>>());
    let mut all: Vec<usize> = set.iter().map(|other| other.at).filter(|other| *other != premise.at).collect();
    for place in (0..at).filter(|place| *place != premise.at).filter(is_doubtful) {
        if definition_explains(checker, place, at, &claim)? {
            all.push(place);
        }
    }
    all.retain(|place| !inline::is_inline(checker.notes, &checker.notes.equations[*place]));
    all.sort_unstable();
    all.dedup();
    Ok(all.into_iter().filter_map(|place| checker.notes.equations[place].id().map(str::to_owned)).collect())
}

/// The most edits of a definition that are tried.
const TRIED: usize = 40;

/// Whether one likely edit of a definition makes a display pass with a claim.
fn definition_explains(checker: &Checker<'_>, definition: usize, at: usize, claim: &Claim) -> Result<bool> {
    let text = &checker.notes.equations[definition].text;
    let mut edits = slips::corrections(text, &checker.model.symbols, &checker.model.macros, &Pool::empty());
    edits.retain(|edit| is_common(edit.slip));
    for edit in edits.into_iter().take(TRIED) {
        let judge =
            |checker: &Checker<'_>| checker.equation(at, Some(claim)).map(|found| found.finding.verdict.holds());
        if checker.with_edited_text(checker.options, definition, &edit.applied(text), judge).transpose()? == Some(true)
        {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether a relation contains a name to which only a later display gives a formula, as w' before `w(\ell) = …`: the author may have
/// meant another one.
fn uses_a_later_formula(checker: &Checker<'_>, at: usize) -> bool {
    let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
    let used: Vec<SymbolId> = members.flat_map(Expr::symbols).map(|(id, _)| id).collect();
    let later = checker.readings.iter().skip(at + 1).flat_map(|reading| &reading.introduced);
    // A derivative is read as that of the formula, and the name is none of the symbols any more.
    let text = &checker.notes.equations[at].text;
    let is_differentiated = |id: SymbolId| text.contains(&format!("{}'", checker.model.name(id)));
    later.into_iter().any(|new| used.contains(&new.symbol) || is_differentiated(new.symbol))
}

/// Whether authors make slips of this kind often, and the correction puts no other letter into a relation: with another letter it may be
/// a relation between other things.
fn is_plain(slip: Slip) -> bool {
    is_common(slip) && !matches!(slip, Slip::Symbol | Slip::Index)
}

fn explained(id: &str, what: &str) -> String {
    format!("({id}) does not follow from this {what}, but it does after the suggested edit")
}

/// Whether a display is taken for granted, though it says more than what a name stands for.
fn is_open(equation: &Equation) -> bool {
    equation.finding.verdict == Verdict::Assumed
}

/// Whether a statement of a display fails of whose sides one has no name that the other has not, so that the definitions alone decide.
fn fails_by_definitions(checker: &Checker<'_>, at: usize) -> Result<bool> {
    let display = &checker.notes.equations[at];
    let statements = &checker.readings[at].statements;
    if inline::is_inline(checker.notes, display) || statements.iter().any(Result::is_err) {
        return Ok(false);
    }
    let equates = |statement: &&Statement| {
        statement.members.windows(2).all(|pair| {
            let (left, right) = (gate::leaves(&pair[0], checker.model), gate::leaves(&pair[1], checker.model));
            !left.is_empty() && !right.is_empty() && (contains(&left, &right) || contains(&right, &left))
        })
    };
    let equating: Vec<Span> = statements.iter().flatten().filter(equates).map(|statement| statement.span).collect();
    if equating.is_empty() {
        return Ok(false);
    }
    let found = checker.equation(at, Some(&Claim::default()))?;
    let parts = found.parts.iter().map(|part| &part.finding);
    let fails = |finding: &Finding| {
        let is_it = |span: &Span| span.shifted(display.body.start).contains(finding.span);
        finding.verdict == Verdict::Refuted && equating.iter().any(is_it)
    };
    Ok(parts.chain(statements.len().eq(&1).then_some(&found.finding)).any(fails))
}

/// Whether a display contains the names that a premise does: it may be the same law of another thing.
fn is_alike(checker: &Checker<'_>, at: usize, premise: &Premise) -> bool {
    let printed = |at: usize| {
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        members.flat_map(Expr::symbols).map(|(id, _)| id).collect::<Vec<SymbolId>>()
    };
    same(&printed(at), &printed(premise.at))
}

fn same(a: &[SymbolId], b: &[SymbolId]) -> bool {
    contains(a, b) && contains(b, a)
}

/// Whether a list has all names of another one.
fn contains(all: &[SymbolId], some: &[SymbolId]) -> bool {
    some.iter().all(|id| all.contains(id))
}
