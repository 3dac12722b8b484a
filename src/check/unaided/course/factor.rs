//! A display of which one side is the other one but for a number.
//!
//! No law and no special case says `2x = 3x`. So where the sides, with what the notes define put in, have the same ratio in all
//! states, the display is wrong, whether an edit of it is found or not. A name beside a formula is left out, since that may be another
//! definition of it.

use crate::Result;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::repair::suggest::Search;
use crate::check::unaided::course::Course;
use crate::check::unaided::{dimensions, gate};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Equation;
use crate::formula::Value;
use crate::formula::units::in_si::has_units;
use crate::formula::{Expr, Node, Relation, Statement};
use crate::notes::claims::Claim;
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
    pub(super) fn uses_definitions(&self, at: usize) -> bool {
        let model = self.checker.model;
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let mut symbols = members.flat_map(Expr::symbols);
        symbols.any(|(id, _)| matches!(model.meaning(id), Some(Meaning::Defined(_))))
    }

    /// The finding that a display is wrong, if one side is the other one but for a number. `quick` is the finding that it does not
    /// hold.
    pub(super) fn off_by_a_factor(&self, at: usize, claim: &Claim, quick: &Equation) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        // Of log nobody knows the base.
        if display.text.contains("\\log") {
            return Ok(None);
        }
        let mut off = None;
        let statements = &checker.readings[at].statements;
        for statement in statements.iter().flatten() {
            if off.is_none() {
                off = self.pair_that_is_off(at, statement)?.map(|pair| pair.shifted(display.body.start));
            }
        }
        let Some(off) = off else { return Ok(None) };
        let mut repairs = checker.own_repairs(at, quick, claim, Search::Likely)?;
        repairs.retain(|repair| {
            matches!(repair.verdict, Verdict::Certified | Verdict::Verified)
                && !repair.idle
                && repair.shared.is_none()
                && display.body.contains(repair.span)
                && !dimensions::are_spoilt(checker, at, repair)
        });
        let found = Equation { repairs, ..self.equation(checker, at, claim)? };
        let is_alone = statements.len() == 1;
        Ok(only_within(&found, off).or(is_alone.then_some(found)))
    }

    /// Two members of a statement, one after the other, that are the same but for a number.
    fn pair_that_is_off(&self, at: usize, statement: &Statement) -> Result<Option<Span>> {
        if !statement.conditions.is_empty() || statement.branch.is_some() {
            return Ok(None);
        }
        for (pair, (relation, _)) in statement.members.windows(2).zip(&statement.relations) {
            let may_be = is_equality(*relation) && pair.iter().all(may_be_off);
            if may_be && self.ratio_is_wrong(at, &pair[0], &pair[1])? {
                return Ok(Some(pair[0].span.to(pair[1].span)));
            }
        }
        Ok(None)
    }

    /// Whether the ratio of two sides is a number other than 1, in all states.
    fn ratio_is_wrong(&self, at: usize, lhs: &Expr, rhs: &Expr) -> Result<bool> {
        // What differs by a sign may be about the other direction.
        let may_turn = !self.uses_definitions(at);
        let least = if [lhs, rhs].into_iter().any(has_decimals) { ROUNDED } else { EQUAL };
        let Some(ratio) = self.constant_ratio(lhs, rhs)?.filter(|ratio| *ratio > 0.0 || may_turn) else {
            return Ok(false);
        };
        Ok((ratio - 1.0).abs() > least)
    }

    /// The ratio of two formulas, if it is one number in all states.
    pub(super) fn constant_ratio(&self, lhs: &Expr, rhs: &Expr) -> Result<Option<f64>> {
        let Ok(link) = self.checker.link(lhs, Relation::Equal, rhs) else { return Ok(None) };
        let context = self.context(&[]);
        let mode = context.mode(false, &[&link.lhs, &link.rhs]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        let mut ratios = Vec::new();
        for state in &ensemble.states {
            let sides = (state.now(&link.lhs, &[]), state.now(&link.rhs, &[]));
            // A root may have no value in a state.
            let (Ok(a), Ok(b)) = sides else { continue };
            let (Value::Scalar(a), Value::Scalar(b)) = (a, b) else { return Ok(None) };
            if a.value.is_finite() && b.value.is_finite() {
                ratios.push(a.value / b.value);
            }
        }
        let first = ratios.first().copied().filter(|first| first.is_finite() && ratios.len() >= FEWEST);
        let is_same = |ratio: &f64| first.is_some_and(|first| (ratio / first - 1.0).abs() < EQUAL);
        Ok(first.filter(|_| ratios.iter().all(is_same)))
    }
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
