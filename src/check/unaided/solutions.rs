//! Displays that print the solutions of an earlier relation for one of its symbols, as x = −p ± √(p² − q) after
//! x² + 2px + q = 0.
//!
//! Each printed branch, substituted for the symbol, must satisfy the relation. Notes may give one of several solutions, so it
//! is not asked whether there are others.

use crate::check::document::checker::Checker;
use crate::check::kinds::solves::contains_rate;
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::premises::{Premise, Said};
use crate::check::verdict::report::Equation;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::Address;
use crate::notes::claims::{Claim, Solved, Solves, Spanned};
use crate::source::Span;

/// The most relations that a display is taken to solve.
const MOST: usize = 3;

/// A relation that a display may solve.
pub(super) struct Solution<'p> {
    /// The relation.
    pub of: &'p Premise,
    /// The claim that the display solves it.
    pub claim: Claim,
    /// Whether the display relates the same symbols, and the relation is no formula for the unknown already. What relates
    /// fewer may be a special case.
    pub same_symbols: bool,
    /// Whether the relation has all symbols of the display, and more that may drop out of it, and is no formula for the unknown.
    pub more_symbols: bool,
}

/// The last relations before a display that contain the one symbol for which it gives a formula. `symbols` are those of the
/// display; `readings` are the readings of all displays.
pub(super) fn solved<'p>(
    (at, symbols): (usize, &[SymbolId]),
    known: &'p [Premise],
    readings: &[Reading],
    model: &Model,
) -> Vec<Solution<'p>> {
    let Some(unknown) = unknown(&readings[at], model).or_else(|| root(&readings[at], model)) else { return Vec::new() };
    let name = model.name(unknown);
    let roots = roots(&readings[at]);
    let is_about =
        |premise: &&Premise| premise.symbols.contains(&unknown) && !has_rate(&readings[premise.at], unknown, model);
    // Where the relation has ± too, each of its signs goes with one root.
    let has_branches = |premise: &&Premise| {
        let mut statements = readings[premise.at].statements.iter().flatten();
        !roots.contains(&unknown) && statements.any(|statement| statement.branch.is_some())
    };
    let about = known.iter().rev().filter(|premise| premise.said == Said::Whole && !has_branches(premise));
    let about = about.filter(is_about);
    about
        .take(MOST)
        .map(|of| {
            let address = Address { text: of.id.clone(), span: Span::default(), items: Vec::new() };
            let unknowns = vec![Spanned::new(name.clone(), Span::default())];
            let solves = Some(Solves { of: Solved::Equation(address), unknowns, complete: false });
            let is_other = |id: &&SymbolId| **id != unknown && !roots.contains(id);
            let others: Vec<&SymbolId> = symbols.iter().filter(is_other).collect();
            let related: Vec<&SymbolId> = of.symbols.iter().filter(is_other).collect();
            let is_same = related.len() == others.len() && related.iter().all(|id| others.contains(id));
            let is_relation = !is_formula(&readings[of.at], unknown);
            let has_more = related.len() > others.len() && others.iter().all(|id| related.contains(id));
            Solution {
                of,
                claim: Claim { solves, ..Claim::default() },
                same_symbols: is_same && is_relation,
                more_symbols: has_more && is_relation,
            }
        })
        .collect()
}

/// Whether a display contains a rate of a symbol. A value that is put in for the symbol alone says nothing of it.
fn has_rate(reading: &Reading, id: SymbolId, model: &Model) -> bool {
    let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    members.into_iter().any(|member| contains_rate(member, id, model))
}

/// Whether a display gives a formula for a symbol.
fn is_formula(reading: &Reading, id: SymbolId) -> bool {
    let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    members.filter_map(Expr::as_plain_symbol).any(|member| member == id)
}

/// The symbol for which each statement of a display gives a formula that does not contain it.
fn unknown(reading: &Reading, model: &Model) -> Option<SymbolId> {
    let mut found = None;
    for statement in &reading.statements {
        let Ok(Statement { members, relations, .. }) = statement else { return None };
        let (first, others) = members.split_first()?;
        let id = first.as_plain_symbol()?;
        let is_free = matches!(model.meaning(id), Some(Meaning::Constant(_) | Meaning::Varying(_)));
        let contains = |member: &Expr| member.symbols().iter().any(|(other, _)| *other == id);
        let is_equality = relations.iter().all(|(relation, _)| *relation == Relation::Equal);
        if !is_free
            || !is_equality
            || others.is_empty()
            || others.iter().any(contains)
            || found.is_some_and(|f| f != id)
        {
            return None;
        }
        found = Some(id);
    }
    found
}

/// The names to which the statements of a display give a formula.
fn roots(reading: &Reading) -> Vec<SymbolId> {
    let statements = reading.statements.iter().flatten();
    statements.filter_map(|statement| statement.members.first().and_then(Expr::as_plain_symbol)).collect()
}

/// The unknown of which a display prints the values with indices: s for `s_{1,2} = -\gamma \pm \dots`, and ω for
/// `\omega_\pm = \dots`.
pub(super) fn root(reading: &Reading, model: &Model) -> Option<SymbolId> {
    let mut found = None;
    for statement in &reading.statements {
        let Ok(Statement { members, relations, .. }) = statement else { return None };
        let (first, others) = members.split_first()?;
        let entry = model.symbols.entry(first.as_plain_symbol()?);
        // `\omega_m^2 = \dots` gives the square of the root.
        if entry.squared {
            return None;
        }
        let name = &entry.name;
        let without = |length: usize| Name { subscript: name.subscript[..length].to_vec(), ..name.clone() };
        let (unknown, _) = (0..name.subscript.len()).rev().find_map(|length| model.symbols.find(&without(length)))?;
        let is_free = matches!(model.meaning(unknown), Some(Meaning::Constant(_) | Meaning::Varying(_)));
        let contains = |member: &Expr| member.symbols().iter().any(|(other, _)| *other == unknown);
        let is_equality = relations.iter().all(|(relation, _)| *relation == Relation::Equal);
        let is_another = found.is_some_and(|found| found != unknown);
        if !is_free || !is_equality || others.is_empty() || others.iter().any(contains) || is_another {
            return None;
        }
        found = Some(unknown);
    }
    found
}

impl Solution<'_> {
    /// The finding, with what is solved.
    pub fn found(&self, mut found: Equation) -> Equation {
        found.finding.message = format!("solves ({})", self.of.id);
        found
    }
}

/// Whether a display prints a solution of an equation of motion.
pub(super) fn is_printed(checker: &Checker<'_>, at: usize, claim: &Claim) -> bool {
    checker.readings[at].statements.iter().flatten().any(|statement| {
        let ([lhs, rhs, ..], [(relation, _), ..]) = (statement.members.as_slice(), statement.relations.as_slice())
        else {
            return false;
        };
        let link = checker.link(lhs, *relation, rhs);
        link.is_ok_and(|link| checker.solution(&link, 0, claim).is_some())
    })
}
