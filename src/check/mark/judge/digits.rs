//! Numbers that are printed with so many digits.

use std::collections::HashMap;

use crate::formula::{Expr, Relation, Statement, SymbolId};
use crate::latex::rename::renamed;
use crate::latex::{Reading, foreign};
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::marked::Mark;
use crate::check::mark::rounded::{self, Known};
use crate::check::mark::status::Status;
use crate::check::mark::world::World;
use crate::check::mark::written::units::with_single_units;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;

use super::Judge;

impl Judge<'_, '_> {
    /// Whether a reading with ≈ is right to the printed digits, and its equalities hold, alone or under the conditions.
    pub(super) fn is_near(&self, display: usize, reading: &Reading) -> bool {
        let text = &self.quiet.notes.equations[display].text;
        let spanned = |(text, _): &(String, String)| Spanned::new(text.clone(), Span::default());
        let under = Claim { assume: self.conditions.iter().map(spanned).collect(), ..Claim::default() };
        let sets: Vec<_> = [&Claim::default(), &under].into_iter().map(|claim| self.quiet.hypotheses(claim)).collect();
        // Under conditions a number is rounded, though = stands before it. So is a decimal before letters.
        let is_approximate = |relation: Relation, pair: &[Expr]| {
            let is_number = pair[1].symbols().is_empty();
            let is_rounded =
                if is_number { !self.conditions.is_empty() } else { rounded::is_decimal_multiple(&pair[1]) };
            relation == Relation::Approximately || relation == Relation::Equal && is_rounded
        };
        let mut any = false;
        let all = reading.statements.iter().all(|statement| {
            let Ok(statement) = statement else { return false };
            statement.members.windows(2).zip(&statement.relations).all(|(pair, relation)| {
                if is_approximate(relation.0, pair) {
                    any = true;
                    let Some(text) = text.get(pair[1].span.range()) else { return false };
                    return sets.iter().flatten().any(|set| rounded::agrees(self.quiet, text, pair, set) == Some(true));
                }
                let alone = Statement { members: pair.to_vec(), relations: vec![*relation], ..statement.clone() };
                let alone = Reading { statements: vec![Ok(alone)], introduced: Vec::new() };
                matches!(self.status(display, &alone).0, Status::Holds(_))
            })
        });
        any && all
    }

    /// Whether a reading is right to the printed digits, with the numbers that the student gave to the quantities.
    pub(super) fn is_rounded(&self, display: usize, reading: &Reading) -> bool {
        // With guessed letters a line without a printed number is true by chance, unless the student gave numbers.
        let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let has_number = members.any(|member| member.symbols().is_empty() && !member.is_null());
        if !self.known.has_numbers() && self.world.has_other_letters() && !has_number {
            return false;
        }
        // Two formulas may agree by chance with the data of the problem.
        let known = if has_digits(reading) { self.known_with_the_problem() } else { self.known.or(&self.printed) };
        let text = &self.quiet.notes.equations[display].text;
        known.fits(self.quiet, text, reading, |link| matches!(self.status(display, link).0, Status::Holds(_)))
    }

    /// Whether the numbers that are known give the left side of a statement its value: `\frac{d_1}{k_1} = 0.4` is then no condition.
    pub(super) fn is_determined(&self, statement: &Statement) -> bool {
        let known = self.known_with_the_problem();
        statement.members.first().is_some_and(|formula| known.determines(self.quiet, formula))
    }

    /// The quantities of which a value is missing, for a line that gives a number where numbers were put in, or a measured number.
    pub(super) fn missing_values(&self, display: usize, reading: &Reading) -> Vec<String> {
        let is_measured = foreign::has_a_measured_number(&self.world.written[display - self.world.first].text);
        let missing = self.known_with_the_problem().missing(self.quiet, reading, is_measured);
        missing.into_iter().map(|id| self.world.in_own_letters(&self.quiet.model.name(id))).collect()
    }

    /// The false line, by its place, with whose formula a line that prints numbers is right.
    pub(super) fn carried_number(&self, display: usize, reading: &Reading) -> Option<usize> {
        let is_false = |at: &usize| matches!(self.lines[*at].mark, Mark::Wrong | Mark::Carried);
        let wrong: Vec<usize> = (0..self.lines.len()).filter(is_false).collect();
        let text = &self.quiet.notes.equations[display].text;
        // The student's own lines count for more than what the problem says of the same quantities.
        let fits = |from: &[usize]| {
            let said = from.iter().map(|at| &self.premises[self.world.first + at]);
            let holds = |link: &Reading| matches!(self.status(display, link).0, Status::Holds(_));
            let known = self.known.supposing(said).or(&self.data).or_of_others(&self.printed.clone().formulas());
            known.fits(self.quiet, text, reading, holds)
        };
        if !self.details || wrong.is_empty() || !fits(&wrong) {
            return None;
        }
        wrong.iter().rev().find(|at| fits(&[**at])).or(wrong.last()).copied()
    }

    /// A chain without the number at its end, where that is the value of the formula before it: whether the line is carried, the formula
    /// says.
    pub(super) fn before_a_true_number(&self, display: usize, reading: &Reading) -> Option<Reading> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let [.., formula, number] = statement.members.as_slice() else { return None };
        let length = statement.members.len();
        if length < 3 || !self.details || !number.symbols().is_empty() || formula.symbols().is_empty() {
            return None;
        }
        let part = |from: usize, to: usize| {
            let (members, relations) = (&statement.members[from..to], &statement.relations[from..to - 1]);
            let part = Statement { members: members.to_vec(), relations: relations.to_vec(), ..statement.clone() };
            Reading { statements: vec![Ok(part)], introduced: Vec::new() }
        };
        let text = &self.quiet.notes.equations[display].text;
        let is_value = self.known_with_the_problem().fits(self.quiet, text, &part(length - 2, length), |_| false);
        is_value.then(|| part(0, length - 1))
    }

    /// What is known of numbers, by the lines before a line, by the data of the hand-in and of the problem, and by what the problem
    /// prints.
    pub(super) fn known_with_the_problem(&self) -> Known {
        self.known.or(&self.data).or(&self.printed)
    }
}

/// Whether a number of at least two digits stands in a reading, or a member of it is a number.
fn has_digits(reading: &Reading) -> bool {
    let mut found = false;
    for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
        found |= member.symbols().is_empty() && !member.is_null();
        member.walk(&mut |part| found |= part.as_digits().is_some_and(|digits| digits.len() > 1));
    }
    found
}

/// What the problem prints, and what its claims file says that a name stands for.
pub(super) fn printed(checker: &Checker<'_>, world: &World<'_>) -> Known {
    let mut printed = Known::default();
    let model = checker.model;
    for (id, entry) in model.symbols.iter() {
        if let Some(Meaning::Defined(formula)) = model.meaning(id)
            && world.problem.names.symbols.find(&entry.name).is_some()
        {
            printed.add_formula(id, formula.as_ref().clone());
        }
    }
    for at in 0..world.problem.notes.equations.len() {
        printed.add(&checker.readings[at], false);
    }
    printed.with_numbers_last()
}

/// The numbers that the text of the problem and all of a hand-in give to constants: also those that come after the line in which
/// they are used. What a hand-in gives several values is no datum.
pub(super) fn data(checker: &Checker<'_>, world: &World<'_>) -> Known {
    let notes = &world.problem.notes;
    let stated = notes.inline.iter().filter_map(|span| notes.source.text.get(span.range())).map(|text| {
        let text = with_single_units(text.trim_matches('$'));
        let text = renamed(&text, &checker.model.macros, &HashMap::new()).text;
        checker.as_printed(&text, &Claim::default(), &checker.model.macros)
    });
    // What the model solution gives a formula, or what its laws are about, is no datum.
    let of_problem = &checker.readings[..notes.equations.len()];
    let is_sought = |id: SymbolId| {
        let mut first = of_problem.iter().flat_map(|reading| reading.statements.iter().flatten());
        first.any(|statement| statement.members.first().and_then(Expr::as_plain_symbol) == Some(id))
    };
    // `T_1 - T_2 = 20\,\text{K}`
    let relates = |reading: &Reading| {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let [formula, value] = statement.members.as_slice() else { return false };
        let is_datum = |(id, dots): &(SymbolId, u8)| {
            *dots == 0 && matches!(checker.model.meaning(*id), Some(Meaning::Constant(_))) && !is_sought(*id)
        };
        let symbols = formula.symbols();
        let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        is_equal && value.symbols().is_empty() && symbols.len() > 1 && symbols.iter().all(is_datum)
    };
    let number = |reading: &Reading| -> Option<(SymbolId, Expr)> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let [name, value] = statement.members.as_slice() else { return None };
        let name = name.as_plain_symbol().filter(|_| value.symbols().is_empty())?;
        Some((name, value.clone()))
    };
    let gives = |reading: &Reading| -> Option<(SymbolId, Expr)> {
        let (name, value) = number(reading)?;
        let is_constant = matches!(checker.model.meaning(name), Some(Meaning::Constant(_)));
        (is_constant && !is_sought(name)).then_some((name, value))
    };
    let stated: Vec<Reading> = stated.collect();
    let relations: Vec<&Reading> = stated.iter().filter(|reading| relates(reading)).collect();
    let numbers: Vec<&Reading> = stated.iter().filter(|reading| number(reading).is_some()).collect();
    let stated: Vec<&Reading> = numbers.iter().copied().filter(|reading| gives(reading).is_some()).collect();
    // A later line that something is 0 is a condition of its own, and proves nothing of the lines before it.
    let is_datum = |reading: &&Reading| gives(reading).is_some_and(|(_, value)| !value.is_null());
    let own: Vec<&Reading> = checker.readings[world.first..].iter().filter(is_datum).collect();
    let is_single = |reading: &&&Reading| {
        let found = gives(reading);
        own.iter()
            .filter_map(|other| gives(other))
            .all(|other| found.as_ref().is_some_and(|(name, value)| other.0 != *name || other.1 == *value))
    };
    let mut known = Known::default();
    stated.into_iter().chain(own.iter().filter(is_single).copied()).for_each(|reading| known.add(reading, true));
    relations.into_iter().for_each(|reading| known.add_relation(checker, reading));
    // What the model solution gives a formula may be a datum of the part with numbers: "for $r_0 = 2\,\text{m}$".
    let is_defined = |id: SymbolId| matches!(checker.model.meaning(id), Some(Meaning::Defined(_)));
    let sought = numbers.iter().copied().filter(|reading| gives(reading).is_none()).filter_map(number);
    sought
        .filter(|(id, value)| is_defined(*id) && !value.is_null())
        .for_each(|(id, value)| known.add_at_last(id, value));
    known
}
