//! The wanted results in a hand-in: recognised by what a line says, not by its number or its form.
//!
//! A true line reaches a result if the result follows from the line alone, without the motion and the laws, and not
//! without the line. So any form of an equation of motion is the equation of motion. A line that names further quantities
//! of the problem, as L = T − U, is a step on the way; it counts where other lines say what these are and no line goes on.

mod goal;

use crate::Result;
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Lost};

use crate::check::document::checker::Checker;
use crate::check::model::claim::Link;
use crate::check::verdict::Verdict;

use super::judged::Found;
use super::marked::{Because, Line, Mark, Slipped};
use super::problem::Problem;
use super::status::composed;
use super::world::World;
use goal::{Goal, links};

/// The names that the wanted results give a formula for.
pub(super) fn names(checker: &Checker<'_>, problem: &Problem) -> Vec<SymbolId> {
    let statements =
        problem.wanted.iter().flat_map(|wanted| checker.readings[wanted.display].statements.iter().flatten());
    statements.filter_map(|statement| statement.members.first()?.as_plain_symbol()).collect()
}

/// For each wanted result, the line that reaches it: the first right one, or else the last one with a slip.
///
/// # Errors
/// As for states of the problem.
pub(super) fn found(
    checker: &Checker<'_>,
    world: &World<'_>,
    lines: &mut [Line],
    (premises, corrected): (&[Reading], Option<&[Option<String>]>),
) -> Result<Vec<Option<Found>>> {
    let is_at = |line: &Line| {
        let because = &line.because;
        matches!(because, Because::AtSpeed(_) | Because::AtValue(..) | Because::OtherOrder | Because::OneOf(_))
    };
    let is_at_value: Vec<bool> = lines.iter().map(is_at).collect();
    let readings = |at: usize| {
        let display = world.first + at;
        let own = &checker.readings[display];
        let mut both = vec![own.clone()];
        if world.written[at].continues.is_some() || is_at_value[at] {
            both.push(premises[display].clone());
        }
        both.extend(with_named_rates(checker, own));
        both
    };
    let is_false = |at: usize| matches!(lines[at].mark, Mark::Wrong | Mark::Carried);
    let meant: Vec<Vec<Reading>> = (0..lines.len())
        .map(|at| if is_false(at) { with_numbered_values(checker, world, &readings(at)[0]) } else { Vec::new() })
        .collect();
    let readings = |at: usize| readings(at).into_iter().chain(meant[at].iter().cloned()).collect::<Vec<_>>();
    let search =
        |wanted| Goal::of(checker, world, wanted).map(|goal| Search { checker, world, goal, readings: &readings });
    let searches: Vec<Option<Search<'_, '_, _>>> = world.problem.wanted.iter().map(search).collect();
    let right = |search: &Option<Search<'_, '_, _>>| search.as_ref().and_then(|search| search.right(lines));
    let mut all: Vec<Option<Found>> = searches.iter().map(right).collect();
    // A false line is meant as one result: first as that whose left side it has.
    let mut taken: Vec<usize> = Vec::new();
    for only_its_own in [true, false] {
        for (at, search) in searches.iter().enumerate().filter(|_| corrected.is_some()) {
            if let (None, Some(search), Some(corrected)) = (&all[at], search, corrected) {
                all[at] = search.with_slip(lines, corrected, (&taken, only_its_own));
                taken.extend(all[at].as_ref().map(|found| found.line));
            }
        }
    }
    for (at, search) in searches.iter().enumerate() {
        if let (None, Some(search)) = (&all[at], search) {
            all[at] = search.in_other_quantities(lines);
        }
    }
    Ok(all)
}

/// The search for one wanted result.
struct Search<'s, 'c, R> {
    checker: &'s Checker<'c>,
    world: &'s World<'s>,
    goal: Goal,
    /// What a line says, by its place.
    readings: R,
}

impl<R: Fn(usize) -> Vec<Reading>> Search<'_, '_, R> {
    /// The right line that reaches the result.
    fn right(&self, lines: &[Line]) -> Option<Found> {
        let (checker, world, goal) = (self.checker, self.world, &self.goal);
        let is_true = |line: &Line| matches!(line.mark, Mark::Right | Mark::Given);
        let reached = |at: usize| {
            let more = (self.readings)(at).into_iter().filter_map(|reading| goal.reached(checker, world, &reading));
            Some((more.min().filter(|_| is_true(&lines[at]))?, at))
        };
        let found = |line: usize| self.right_at(line);
        // A line without names of the student's own says it best.
        if let Some((_, line)) = (0..lines.len()).filter_map(reached).min() {
            return Some(found(line));
        }
        // The statements of a result may stand on lines of their own; the last of them reaches it.
        let says = |part: usize, at: &usize| {
            let mut own = (self.readings)(*at).into_iter();
            is_true(&lines[*at]) && own.any(|reading| goal.part(checker, world, &reading, part).is_some())
        };
        let parts = (0..goal.links.len()).map(|part| (0..lines.len()).find(|at| says(part, at)));
        let parts = parts.collect::<Option<Vec<usize>>>().filter(|_| goal.links.len() > 1);
        if let Some(line) = parts.as_ref().and_then(|parts| parts.iter().copied().max()) {
            return Some(Found { parts: parts.unwrap_or_default(), ..found(line) });
        }
        // A right number for what is wanted, where no line has the formula.
        let computed = |at: &usize| lines[*at].mark == Mark::Right && self.is_number(*at);
        (0..lines.len()).find(computed).map(found)
    }

    /// The right line that has the form of the model solution on the way, where lines say what its other quantities are.
    fn in_other_quantities(&self, lines: &[Line]) -> Option<Found> {
        let is_true = |line: &Line| {
            line.mark == Mark::Right || line.mark == Mark::Given && line.verdict == Some(Verdict::Assumed)
        };
        let says = |at: &usize| {
            let mut own = (self.readings)(*at).into_iter();
            is_true(&lines[*at])
                && own
                    .any(|reading| self.goal.is_with_known_quantities(self.checker, self.world, (*at, &reading), lines))
        };
        let line = (0..lines.len()).find(says)?;
        Some(self.right_at(line))
    }

    /// The result, as a right line reaches it.
    fn right_at(&self, line: usize) -> Found {
        Found { line, is_right: true, lost: None, parts: Vec::new(), is_motion: self.goal.is_motion() }
    }

    /// Whether a line gives a number for what is wanted.
    fn is_number(&self, at: usize) -> bool {
        let own = links(self.checker, &self.checker.readings[self.world.first + at]);
        own.iter().any(|link| self.goal.is_computed(self.checker, link))
    }

    /// The line that reaches the result with a slip. `corrected` are the texts of lines without their slips.
    /// `taken` are lines that were meant as other results; `only_its_own` if the line must have the left side of the result.
    fn with_slip(
        &self,
        lines: &mut [Line],
        corrected: &[Option<String>],
        (taken, only_its_own): (&[usize], bool),
    ) -> Option<Found> {
        let is_false = |line: &Line| matches!(line.mark, Mark::Wrong | Mark::Carried);
        let has_its_side = |at: usize| (self.readings)(at).iter().any(|own| self.goal.has_its_side(self.checker, own));
        let mut with_slip = None;
        for at in (0..lines.len()).rev().filter(|at| is_false(&lines[*at]) && !taken.contains(at)) {
            if only_its_own && !has_its_side(at) {
                continue;
            }
            let Some(off) = self.attempt(at, corrected[at].as_deref()) else { continue };
            // A number that was put in says less than the formula before it.
            let is_number = self.is_number(at);
            if with_slip.is_none() || !is_number {
                with_slip = Some((at, off));
            }
            if !is_number {
                break;
            }
        }
        let (at, off) = with_slip?;
        let mut root = at;
        while let Some(before) = lines[root].follows_from {
            root = before;
        }
        if let (None, Some(lost), Mark::Wrong) = (&lines[root].slip, off, lines[root].mark) {
            let span = lines[root].span;
            lines[root].slip = Some(Slipped { lost, span, replacement: None });
        }
        // What the result is off by says more than which edit is the likeliest, if the slip is in its own line.
        let slip = lines[root].slip.as_ref().map(|slip| slip.lost);
        let lost = if root == at { off.or(slip) } else { slip.or(off) };
        Some(Found { is_right: false, lost, ..self.right_at(at) })
    }

    /// What a false line that was meant as the result is off by, if that is a number; `None`, if it was not meant as the result.
    fn attempt(&self, at: usize, corrected: Option<&str>) -> Option<Option<Lost>> {
        let (checker, world, goal) = (self.checker, self.world, &self.goal);
        let is_corrected = corrected.is_some_and(|text| {
            let reading = checker.as_printed(text, &Claim::default(), &checker.model.macros);
            let start = world.written[at].continues;
            let whole = start.and_then(|start| composed(&checker.readings[world.first + start], &reading));
            let whole = whole.as_ref().and_then(|whole| goal.reached(checker, world, whole));
            whole.or_else(|| goal.reached(checker, world, &reading)).is_some()
        });
        let attempt = (self.readings)(at).iter().rev().find_map(|reading| goal.attempt(checker, world, reading));
        attempt.or_else(|| is_corrected.then_some(None))
    }
}

/// What a false line says with each value of the problem in the place of a letter to which the hand-in gives several of them.
fn with_numbered_values(checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> Vec<Reading> {
    let Some((letter, values)) = world.letter_with_values(checker, reading) else { return Vec::new() };
    if !world.has_several_values(&checker.model.symbols.entry(letter).name) {
        return Vec::new();
    }
    let with = |value: SymbolId| {
        let mut new = reading.clone();
        let members = new.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members);
        members.for_each(|member| member.rename(&|id| if id == letter { value } else { id }));
        new
    };
    values.into_iter().map(with).collect()
}

/// A reading with the name that a law gives to a rate in the place of the rate: `a` for `\ddot x`.
fn with_named_rates(checker: &Checker<'_>, reading: &Reading) -> Option<Reading> {
    let laws = checker.model.laws.iter().flat_map(|law| &law.hypotheses);
    let named = laws.filter_map(|law| match (&law.lhs.node, law.rhs.as_plain_symbol()) {
        (Node::Symbol { id, dots, .. }, Some(name)) if *dots > 0 && law.relation == Relation::Equal => {
            Some(((*id, *dots), name))
        }
        _ => None,
    });
    let named: Vec<((SymbolId, u8), SymbolId)> = named.collect();
    let mut new = reading.clone();
    for member in new.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        let span = member.span;
        member.substitute(&|node| match node {
            Node::Symbol { id, dots, .. } => {
                let (_, name) = named.iter().find(|(rate, _)| rate == &(*id, *dots))?;
                Some(Expr::new(Node::Symbol { id: *name, indices: Vec::new(), dots: 0 }, span))
            }
            _ => None,
        });
    }
    (!named.is_empty()).then_some(new)
}

/// Whether a line prints a law of the problem as the problem does, in either order of its sides.
pub(super) fn prints_a_law(checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> bool {
    let own = links(checker, reading);
    let laws: Vec<Link> = world.problem.laws.iter().flat_map(|law| links(checker, &checker.readings[*law])).collect();
    let is_it = |own: &Link, law: &Link| {
        own.relation == law.relation
            && (own.lhs == law.lhs && own.rhs == law.rhs || own.lhs == law.rhs && own.rhs == law.lhs)
    };
    !own.is_empty() && own.iter().all(|own| laws.iter().any(|law| is_it(own, law)))
}
