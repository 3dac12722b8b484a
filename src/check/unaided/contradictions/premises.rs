//! Displays that contradict what is taken for granted: whether the slip is in the premise.
//!
//! A display that is called wrong given a premise may be right, and the premise wrong. Where one common edit of the premise makes
//! the display follow, as one edit of the display does, the other displays decide: a premise from which something follows is
//! right, and one that several displays contradict with the same edit is wrong. Else one of the two is wrong, and nobody can tell
//! which.

use crate::Result;
use crate::check::repair::culprit::is_common;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::repair::suggest::is_in_source;
use crate::check::unaided::contradictions::vouched;
use crate::check::unaided::contradictions::{consistent, contradicted, open, refuted, undecided};
use crate::check::unaided::course::Course;
use crate::check::unaided::course::examples::LOST_FACTORS;
use crate::check::unaided::dimensions;
use crate::check::unaided::premises::{self, Premise, Said};
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::{Repair, Shared};
use crate::check::verdict::report::Equation;
use crate::formula::Symbols;
use crate::latex::Macros;
use crate::latex::slips::{self, Edit, Pool, Slip};
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

/// The most edits of one premise that are tried, the likeliest first.
const TRIED: usize = 80;

/// An edit of a premise with which a display follows.
struct Suspicion {
    /// The place of the display that contradicts the premise.
    by: usize,
    /// The place of the premise.
    premise: usize,
    /// The edit of the premise.
    repair: Repair,
    /// Whether the edit is a slip that authors often make. A lost number counts only where several displays show it.
    is_common: bool,
}

/// Weighs the displays that were called wrong given premises.
///
/// # Errors
/// As for a check of an equation.
pub(in crate::check::unaided) fn weighed(course: &Course<'_, '_>, found: &mut [Equation]) -> Result<()> {
    let first = course.scope.carried;
    let is_wrong = |at: usize, found: &[Equation]| {
        let equation = at.checked_sub(first).and_then(|place| found.get(place));
        equation.is_some_and(|equation| equation.finding.verdict == Verdict::Refuted)
    };
    let mut suspicions = Vec::new();
    // What is constant is weighed against what else is; a law that would do with another exponent is none the worse for that.
    let says_constant = |at: usize| {
        course.checker.readings[at].statements.iter().flatten().any(|statement| statement.constant.is_some())
    };
    for (at, set) in course.blamed.iter().filter(|(at, _)| is_wrong(*at, found)) {
        let is_common_here = found[at - first].repairs.iter().any(|repair| is_common(repair.slip));
        for premise in set {
            let is_alike = matches!(premise.said, Said::Constant(_)) || !says_constant(*at);
            let is_open =
                is_alike && !premise.is_inline && premise.at >= first && !course.confirmed.contains(&premise.at);
            if let Some(repair) = is_open.then(|| edited(course, *at, set, premise)).transpose()?.flatten() {
                let is_common = is_common(repair.slip);
                suspicions.push((is_common_here, Suspicion { by: *at, premise: premise.at, repair, is_common }));
            }
        }
    }
    for (_, suspicion) in &suspicions {
        let is_same = |other: &&Suspicion| {
            other.premise == suspicion.premise
                && other.repair.span == suspicion.repair.span
                && other.repair.replacement == suspicion.repair.replacement
        };
        let alike: Vec<usize> =
            suspicions.iter().map(|(_, other)| other).filter(is_same).map(|other| other.by).collect();
        let premise = suspicion.premise - first;
        if alike.len() < 2 || !alike.iter().all(|at| is_wrong(*at, found)) {
            continue;
        }
        let ids: Vec<String> = alike.iter().map(|at| format!("({})", found[at - first].id)).collect();
        found[premise] = refuted(&found[premise], &suspicion.repair, format!("{} contradict this", ids.join(" and ")));
        let name = found[premise].id.clone();
        alike.iter().for_each(|at| found[at - first] = consistent(&found[at - first], &name));
    }
    leave_open_what_shares_a_premise(course, found);
    for (is_common_here, Suspicion { by, premise, repair, is_common }) in suspicions {
        let (by, premise) = (by - first, premise - first);
        let is_taken = found[premise].finding.verdict == Verdict::Assumed;
        if is_common_here && is_common && is_taken && is_wrong(by + first, found) {
            let (id, name) = (found[by].id.clone(), found[premise].id.clone());
            found[premise] = contradicted(&found[premise], &id);
            found[by] = open(&found[by], &name, repair);
        }
    }
    Ok(())
}

/// Leaves open the displays that contradict one premise from which nothing follows: a slip in the premise is likelier than one in each of
/// them.
fn leave_open_what_shares_a_premise(course: &Course<'_, '_>, found: &mut [Equation]) {
    let first = course.scope.carried;
    let mut shared: Vec<(usize, Vec<usize>)> = Vec::new();
    for (at, set) in &course.blamed {
        let Some(place) = at
            .checked_sub(first)
            .filter(|place| found.get(*place).is_some_and(|equation| equation.finding.verdict == Verdict::Refuted))
        else {
            continue;
        };
        for premise in set.iter().filter(|premise| !premise.is_inline && !course.confirmed.contains(&premise.at)) {
            match shared.iter_mut().find(|(at, _)| *at == premise.at) {
                Some((_, places)) => places.push(place),
                None => shared.push((premise.at, vec![place])),
            }
        }
    }
    for (premise, mut places) in shared {
        places.dedup();
        let name = course.checker.notes.equations[premise].id().unwrap_or_default().to_owned();
        for place in places.iter().filter(|_| places.len() > 1) {
            let message = format!("this and another display contradict ({name}), which may be wrong itself");
            found[*place] = undecided(&found[*place], message);
        }
    }
}

/// The small numbers that a text may have lost.
fn lost_factors(text: &str, symbols: &Symbols, macros: &Macros) -> Vec<Edit> {
    let points = slips::insertion_points(text, symbols, macros).into_iter().filter(|point| point.slip == Slip::Factor);
    let factor = |start: usize| {
        LOST_FACTORS.map(|factor| Edit { span: Span::at(start), replacement: format!("{factor} "), slip: Slip::Factor })
    };
    points.flat_map(|point| factor(point.whole.start)).collect()
}

/// The likeliest edit of a premise with which a display follows from the set; `None`, if no common one does that.
pub(super) fn edited(course: &Course<'_, '_>, at: usize, set: &[Premise], premise: &Premise) -> Result<Option<Repair>> {
    let checker = course.checker;
    let display = &checker.notes.equations[premise.at];
    let (symbols, macros) = (&checker.model.symbols, &checker.model.macros);
    let others = set.iter().filter(|other| *other != premise);
    let others: Vec<&Premise> = others.collect();
    let is_formula = matches!(premise.said, Said::Constant(_));
    let printed = vouched::printed_before(course, premise.at);
    for statement in checker.readings[premise.at].statements.iter().flatten() {
        let span = match (&premise.said, statement.members.last()) {
            (Said::Constant(_), Some(formula)) => formula.span,
            _ => statement.span,
        };
        let Some(text) = display.text.get(span.range()) else { continue };
        match &premise.said {
            Said::Part(part) | Said::Constant(part) if part != text => continue,
            // The law of which these are the states is another premise.
            Said::States(_) => return Ok(None),
            _ => {}
        }
        let offset = display.body.start + span.start;
        let beside = checker.readings[premise.at].statements.iter().flatten().filter(|other| other.span != span);
        let beside = beside.filter(|_| premise.said == Said::Whole);
        let beside: Vec<String> =
            beside.filter_map(|other| Some(display.text.get(other.span.range())?.to_owned())).collect();
        let mut edits = slips::corrections(text, symbols, macros, &Pool::empty());
        edits.retain(|edit| {
            is_common(edit.slip) && !adds_parentheses(text, edit) && is_in_source(checker, text, edit, offset)
        });
        edits.sort_by_key(|edit| rank(text, edit, false));
        edits.truncate(TRIED);
        edits.extend(
            lost_factors(text, symbols, macros).into_iter().filter(|edit| is_in_source(checker, text, edit, offset)),
        );
        for edit in edits {
            if vouched::is_reducible(text, &edit)
                || vouched::is_printed_before(course, premise.at, edit.span.shifted(span.start), &printed)
                || vouched::parts_two_sides(course, premise.at, statement, edit.span.shifted(span.start), &edit)
            {
                continue;
            }
            let edited = edit.applied(text);
            let edited = if is_formula { premises::is_constant(&edited) } else { edited };
            let said = std::iter::once(edited).chain(beside.iter().cloned());
            let said = said.map(|text| Spanned::new(text, Span::default()));
            let throughout = premises::claim(&others).throughout.into_iter().chain(said).collect();
            let claim = Claim { throughout, ..Claim::default() };
            // An edit may make nonsense of the premise.
            if checker.hypotheses(&claim).is_err() || course.passes(at, &claim)?.is_none() {
                continue;
            }
            let of = checker.notes.equations[premise.at].id().unwrap_or_default().to_owned();
            let mends = vec![checker.notes.equations[at].id().unwrap_or_default().to_owned()];
            let shared = Some(Shared { of, mends });
            let repair = Repair { shared, ..Repair::of(edit, offset, Verdict::Verified) };
            if !dimensions::are_spoilt(checker, premise.at, &repair) {
                return Ok(Some(repair));
            }
        }
    }
    Ok(None)
}
