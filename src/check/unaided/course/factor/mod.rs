//! A display of which one side is the other one but for a number.
//!
//! No law and no special case says `2x = 3x`. So where the sides, with what the notes define put in, have the same ratio in all
//! states, the display is wrong, whether an edit of it is found or not. A name beside a formula is left out, since that may be another
//! definition of it, unless the words say that it follows from the relations before it: `mgh = \frac12 mv^2`, hence `v = \sqrt{gh}`.

mod stated_case;

use crate::Result;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::repair::suggest::{Search, is_in_source};
use crate::check::state::sampled_state::SampledState;
use crate::check::trial::failed_display::OFFERED;
use crate::check::unaided::course::Course;
use crate::check::unaided::premises::{Premise, Said};
use crate::check::unaided::prose::{self, Announced, Words};
use crate::check::unaided::{dimensions, gate, inline};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::formula::Value;
use crate::formula::units::in_si::has_units;
use crate::formula::{Expr, Node, Relation};
use crate::latex::read_display;
use crate::latex::slips::{self, Edit, Pool};
use crate::notes::claims::Claim;
use crate::scalar::RunningError;
use crate::source::Span;

/// The number of states that are tried; a root has a value in some of them.
const STATES: usize = 32;

/// The fewest states that show a ratio.
const FEWEST: usize = 3;

/// The relative difference of ratios that are one number.
const EQUAL: f64 = 1e-9;

/// The relative difference from 1 of what is no rounded number.
const ROUNDED: f64 = 0.2;

impl Course<'_, '_> {
    /// Whether a display contains a name that a formula defines.
    pub(in crate::check::unaided::course) fn uses_definitions(&self, at: usize) -> bool {
        let model = self.checker.model;
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let mut symbols = members.flat_map(Expr::symbols);
        symbols.any(|(id, _)| matches!(model.meaning(id), Some(Meaning::Defined(_))))
    }

    /// Whether the words say that a display follows from premises of which the display before it is one, with nothing unread on the way,
    /// so that even a number by which it differs is wrong.
    pub(in crate::check::unaided::course) fn is_concluded(&self, at: usize, set: &[&Premise], words: &Words) -> bool {
        let (notes, readings) = (self.checker.notes, &self.checker.readings);
        let origin = self.scope.origin_of(at, notes.equations.len());
        let displays = (0..origin).filter(|place| !inline::is_inline(notes, &notes.equations[*place]));
        let last = displays.max().into_iter().chain(words.named.iter().copied()).collect::<Vec<_>>();
        let Some(first) = set.iter().map(|premise| premise.at).min() else { return false };
        words.announced == Announced::Consequence
            && !prose::speaks_of_several(notes, origin)
            && !prose::brings_another_thing(notes, origin)
            && !self.is_another_multiple(at, set)
            && set.iter().any(|premise| last.contains(&premise.at))
            && !set.iter().any(|premise| matches!(premise.said, Said::States(_)) || self.sets_a_value(premise.at))
            && readings[first..at].iter().all(|reading| reading.statements.iter().all(Result::is_ok))
    }

    /// Whether a display relates the names of its only premise by another number, and neither has a sum: the law of one spring, and that
    /// of two.
    fn is_another_multiple(&self, at: usize, set: &[&Premise]) -> bool {
        let [only] = set else { return false };
        let own = self.symbols(at).unwrap_or_default();
        let has_same = own.len() == only.symbols.len() && own.iter().all(|id| only.symbols.contains(id));
        let members = |at: usize| {
            let statements = self.checker.readings[at].statements.iter().flatten();
            statements.flat_map(|statement| &statement.members)
        };
        let has_sum = |member: &Expr| {
            let mut found = false;
            member.walk(&mut |part| found |= matches!(&part.node, Node::Sum(terms) if terms.len() > 1));
            found
        };
        has_same && !members(at).chain(members(only.at)).any(has_sum)
    }

    /// The finding that a display is wrong, if one side is the other one but for a number, by the definitions alone. `quick` is the finding
    /// that it does not hold.
    pub(in crate::check::unaided::course) fn off_by_a_factor(
        &self,
        at: usize,
        claim: &Claim,
        quick: &Equation,
    ) -> Result<Option<Equation>> {
        let Some(off) = self.pair_that_is_off(at, &[], &may_be_off)? else { return Ok(None) };
        let repairs = self.checker.own_repairs(at, quick, claim, Search::Likely)?;
        self.wrong_within(at, claim, off, repairs)
    }

    /// The same for a conclusion, by the premises of a claim. There a name may stand on one side.
    pub(in crate::check::unaided::course) fn concluded_off_by_a_factor(
        &self,
        at: usize,
        claim: &Claim,
    ) -> Result<Option<Equation>> {
        let hypotheses = self.checker.hypotheses(claim)?;
        let may_be_off = |side: &Expr| !side.is_null() && !has_units(side);
        let Some(off) = self.pair_that_is_off(at, &hypotheses, &may_be_off)? else { return Ok(None) };
        let repairs = self.lost_factors(at, &hypotheses)?;
        self.wrong_within(at, claim, off, repairs)
    }

    /// The finding that the equality in a span of a display is wrong, with those of the repairs that pass.
    fn wrong_within(&self, at: usize, claim: &Claim, off: Span, mut repairs: Vec<Repair>) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        repairs.retain(|repair| {
            matches!(repair.verdict, Verdict::Certified | Verdict::Verified)
                && !repair.idle
                && repair.shared.is_none()
                && display.body.contains(repair.span)
                && !dimensions::are_spoilt(checker, at, repair)
        });
        let found = Equation { repairs, ..self.equation(checker, at, claim)? };
        let is_alone = checker.readings[at].statements.len() == 1;
        Ok(only_within(&found, off).or(is_alone.then_some(found)))
    }

    /// Where two members, one after the other, are the same but for a number under hypotheses, and each of them `may_be_off`.
    fn pair_that_is_off(
        &self,
        at: usize,
        hypotheses: &[Hypothesis],
        may_be_off: &dyn Fn(&Expr) -> bool,
    ) -> Result<Option<Span>> {
        let display = &self.checker.notes.equations[at];
        // Of log nobody knows the base.
        if display.text.contains("\\log") {
            return Ok(None);
        }
        let statements = self.checker.readings[at].statements.iter().flatten();
        for statement in statements.filter(|statement| statement.conditions.is_empty() && statement.branch.is_none()) {
            for (pair, (relation, _)) in statement.members.windows(2).zip(&statement.relations) {
                let may_be = is_equality(*relation) && pair.iter().all(may_be_off);
                if may_be && self.ratio_is_wrong(at, hypotheses, &pair[0], &pair[1])? {
                    return Ok(Some(pair[0].span.to(pair[1].span).shifted(display.body.start)));
                }
            }
        }
        Ok(None)
    }

    /// Whether the ratio of two sides is a number other than 1, in all states.
    fn ratio_is_wrong(&self, at: usize, hypotheses: &[Hypothesis], lhs: &Expr, rhs: &Expr) -> Result<bool> {
        // What differs by a sign may be about the other direction.
        let may_turn = !self.uses_definitions(at) && hypotheses.is_empty();
        let least = if [lhs, rhs].into_iter().any(has_decimals) { ROUNDED } else { EQUAL };
        let ratio = self.ratio_where(hypotheses, lhs, rhs)?.filter(|ratio| *ratio > 0.0 || may_turn);
        Ok(ratio.is_some_and(|ratio| (ratio - 1.0).abs() > least))
    }

    /// The ratio of two formulas, if it is one number in all states.
    pub(in crate::check::unaided::course) fn constant_ratio(&self, lhs: &Expr, rhs: &Expr) -> Result<Option<f64>> {
        self.ratio_where(&[], lhs, rhs)
    }

    /// The ratio of two formulas, if it is one number in all states with some hypotheses. Where these leave the sign of a root open, it
    /// is the positive number.
    fn ratio_where(&self, hypotheses: &[Hypothesis], lhs: &Expr, rhs: &Expr) -> Result<Option<f64>> {
        let Ok(link) = self.checker.link(lhs, Relation::Equal, rhs) else { return Ok(None) };
        let context = self.context(hypotheses);
        let mode = context.mode(false, &[&link.lhs, &link.rhs]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        Ok(ratio_in(&ensemble.states, &link, !hypotheses.is_empty()))
    }

    /// The corrections by a likely slip, or by a number that was lost, with which a display of two sides follows from hypotheses.
    fn lost_factors(&self, at: usize, hypotheses: &[Hypothesis]) -> Result<Vec<Repair>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(Vec::new()) };
        let [lhs, rhs] = statement.members.as_slice() else { return Ok(Vec::new()) };
        let Ok(link) = checker.link(lhs, Relation::Equal, rhs) else { return Ok(Vec::new()) };
        let context = self.context(hypotheses);
        let mode = context.mode(false, &[&link.lhs, &link.rhs]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        let mut found: Vec<Repair> = Vec::new();
        let (symbols, macros) = (&checker.model.symbols, &checker.model.macros);
        let removes_a_number = |edit: &Edit| {
            edit.replacement.trim().is_empty() && display.text[edit.span.range()].trim().parse::<u32>().is_ok()
        };
        let mut removed = slips::corrections(&display.text, symbols, macros, &Pool::empty());
        removed.retain(|edit| removes_a_number(edit) && is_in_source(checker, &display.text, edit, display.body.start));
        for edit in removed.into_iter().chain(self.edits_with_factors(at, None)) {
            let text = edit.applied(&display.text);
            let reading = read_display(&text, &mut symbols.clone(), macros);
            let [Ok(edited)] = reading.statements.as_slice() else { continue };
            let [lhs, rhs] = edited.members.as_slice() else { continue };
            let Ok(link) = checker.link(lhs, Relation::Equal, rhs) else { continue };
            let ratio = ratio_in(&ensemble.states, &link, true);
            if ratio.is_some_and(|ratio| (ratio - 1.0).abs() < EQUAL) {
                found.push(Repair::of(edit, display.body.start, Verdict::Verified));
            }
        }
        // A number is left out rather than set to 1.
        let is_one = |repair: &Repair| repair.replacement.trim() == "1";
        if !found.iter().all(is_one) {
            found.retain(|repair| !is_one(repair));
        }
        found.sort_by_key(|repair| repair.slip);
        found.truncate(OFFERED);
        Ok(found)
    }
}

/// The ratio of the sides of a link, if it is one number in all states; the positive one where their signs are `open`.
fn ratio_in(states: &[SampledState<'_, RunningError>], link: &Link, open: bool) -> Option<f64> {
    let mut ratios = Vec::new();
    for state in states {
        let sides = (state.now(&link.lhs, &[]), state.now(&link.rhs, &[]));
        // A root may have no value in a state.
        let (Ok(a), Ok(b)) = sides else { continue };
        let (Value::Scalar(a), Value::Scalar(b)) = (a, b) else { return None };
        if a.value.is_finite() && b.value.is_finite() {
            ratios.push(a.value / b.value);
        }
    }
    if open && ratios.iter().any(|ratio| *ratio > 0.0) {
        ratios.iter_mut().for_each(|ratio| *ratio = ratio.abs());
    }
    let first = ratios.first().copied().filter(|first| first.is_finite() && ratios.len() >= FEWEST);
    let is_same = |ratio: &f64| first.is_some_and(|first| (ratio / first - 1.0).abs() < EQUAL);
    first.filter(|_| ratios.iter().all(is_same))
}

/// The finding on a display of several equalities, of which the one in a span is wrong and the others are as they count.
fn only_within(found: &Equation, span: Span) -> Option<Equation> {
    let is_within = |finding: &Finding| finding.verdict == Verdict::Refuted && span.contains(finding.span);
    let finding = found.parts.iter().map(|part| &part.finding).find(|finding| is_within(finding))?.clone();
    let mut weighed = gate::as_it_counts(found.clone());
    for (part, printed) in weighed.parts.iter_mut().zip(&found.parts).filter(|(_, part)| is_within(&part.finding)) {
        *part = printed.clone();
    }
    let mut repairs = found.repairs.clone();
    repairs.retain(|repair| span.contains(repair.span));
    Some(Equation { finding, repairs, ok: false, ..weighed })
}

/// Whether a formula may be one side of what is off by a factor: no name beside its definition, nothing measured.
fn may_be_off(side: &Expr) -> bool {
    side.as_plain_symbol().is_none() && !side.is_null() && !has_units(side)
}

fn has_decimals(side: &Expr) -> bool {
    let mut found = false;
    side.walk(&mut |part| found |= matches!(&part.node, Node::Number(digits) if digits.contains('.')));
    found
}
