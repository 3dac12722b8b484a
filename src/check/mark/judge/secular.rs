//! Lines about the frequency of a secular equation: the equation in another form, and its roots.

use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};
use crate::source::{Fault, Span};

use crate::check::document::checker::Checker;
use crate::check::mark::carried::numbers;
use crate::check::mark::given;
use crate::check::mark::marked::Mark;
use crate::check::mark::status::{Status, status};
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;

use super::Judge;

impl Judge<'_, '_> {
    /// What a line says of the frequency itself: names of the student's own are written out, `\lambda = \omega^2`, and two signs
    /// are two factors of one equation.
    pub(super) fn of_the_frequency(&self, reading: &Reading) -> Reading {
        let of_problem = self.world.problem.notes.equations.len();
        let mut reading = reading.clone();
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            *member = given::expanded(self.quiet, of_problem, member.clone());
        }
        one_equation(&reading).unwrap_or(reading)
    }

    /// Whether a line says what the frequency in a secular equation of the problem is: with it the equation holds.
    pub(super) fn is_a_root(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> bool {
        let is_equation = reading.statements.iter().flatten().all(|statement| statement.relations.len() == 1);
        let text = &self.world.display(display - self.world.first).text;
        let branches = text.contains("\\pm") || text.contains("\\mp");
        self.details
            && is_equation
            && self.world.problem.secular.iter().any(|(secular, omega)| {
                let is_there = |member: &Expr| {
                    checker
                        .model
                        .symbols
                        .iter()
                        .any(|(id, entry)| entry.name == *omega && checker.model.depends_on(member, &[id]))
                };
                let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
                let signs: &[&str] = if branches { &["+", "-"] } else { &[""] };
                members.any(is_there)
                    && signs.iter().all(|sign| {
                        let other = if *sign == "+" { "-" } else { "+" };
                        let text = text.replace("\\pm", sign).replace("\\mp", other);
                        let claim = Claim { assume: vec![Spanned::new(text, Span::default())], ..Claim::default() };
                        matches!(status(checker, display, &self.trusted[*secular], &claim), Status::Holds(_))
                    })
            })
    }
}

impl Judge<'_, '_> {
    /// What a line says with its two signs in the other order, if that is true: the problem may number the values the other way round.
    pub(super) fn in_the_other_order(&self, display: usize) -> Option<Reading> {
        let text = &self.quiet.notes.equations[display].text;
        if !self.details || !text.contains("_{1,2}") || !text.contains("\\pm") {
            return None;
        }
        let pieces: Vec<String> = text.split("\\pm").map(|piece| piece.replace("\\mp", "\\pm")).collect();
        let other = self.quiet.as_printed(&pieces.join("\\mp"), &Claim::default(), &self.quiet.model.macros);
        matches!(self.status(display, &other).0, Status::Holds(_)).then_some(other)
    }

    /// Whether a line with two signs gives what moves both values that it has under hypotheses of the problem: the turning points, where
    /// the velocity vanishes.
    pub(super) fn are_the_roots(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> bool {
        let is_moving = |statement: &Statement| {
            let id = statement.members.first().and_then(Expr::as_plain_symbol);
            id.is_some_and(|id| matches!(checker.model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_))))
        };
        if !self.details || !reading.statements.iter().flatten().all(is_moving) {
            return false;
        }
        let Some(product) = one_equation(reading) else { return false };
        let mut contexts = self.world.problem.contexts.iter().filter(|claim| !claim.assume.is_empty());
        contexts.any(|claim| self.holds_under(checker, display, &product, claim))
    }

    /// The false equation, by its place among the lines, of which a line gives the roots: it holds with each of them in the place of the
    /// power that the line gives.
    pub(super) fn carried_root(&self, reading: &Reading) -> Option<usize> {
        let is_false = |at: &usize| matches!(self.lines[*at].mark, Mark::Wrong | Mark::Carried);
        let model = self.quiet.without_system(false).model;
        let roots: Vec<(SymbolId, u32, &Expr)> = reading.statements.iter().map(root).collect::<Option<_>>()?;
        let vanishes = |link: &Link| {
            let with = |(id, power, value): &(SymbolId, u32, &Expr)| {
                let sides = [&link.lhs, &link.rhs].map(|side| with_root(side, (*id, *power), value));
                let [Some(left), Some(right)] = sides else { return false };
                let Ok(new) = self.quiet.link(&left, Relation::Equal, &right) else { return false };
                numbers::holds(self.quiet, &model, &numbers::beside_one(self.quiet, &new), &[]) == Some(true)
            };
            roots.iter().all(with)
        };
        let links = |at: usize| numbers::links(self.quiet, &self.quiet.readings[self.world.first + at]);
        let is_it = |at: &usize| {
            let has_it = |link: &Link| {
                let symbols = [link.lhs.symbols(), link.rhs.symbols()].concat();
                roots.iter().all(|(id, ..)| symbols.contains(&(*id, 0)))
            };
            links(*at).is_some_and(|links| links.iter().all(|link| has_it(link) && vanishes(link)))
        };
        (0..self.lines.len()).rev().filter(is_false).filter(|_| self.details && !roots.is_empty()).find(is_it)
    }
}

/// The symbol of which a statement gives a power, the power, and its value: `\omega^2 = \frac km`.
fn root(statement: &Result<Statement, Fault>) -> Option<(SymbolId, u32, &Expr)> {
    let Ok(Statement { members, .. }) = statement else { return None };
    let [first, value] = members.as_slice() else { return None };
    let (id, power) = power_of(first)?;
    value.symbols().iter().all(|(other, _)| *other != id).then_some((id, power, value))
}

fn power_of(formula: &Expr) -> Option<(SymbolId, u32)> {
    match &formula.node {
        Node::Power(base, power) => Some((base.as_plain_symbol()?, power.as_digits()?.parse().ok()?)),
        _ => Some((formula.as_plain_symbol()?, 1)),
    }
}

/// A formula in which a power of a symbol has a value; `None`, if the symbol is there with another power that this does not give.
fn with_root(formula: &Expr, (id, power): (SymbolId, u32), value: &Expr) -> Option<Expr> {
    let mut new = formula.clone();
    let span = formula.span;
    new.substitute(&|node| {
        let (_, own) = power_of(&Expr::new(node.clone(), span)).filter(|(of, _)| *of == id)?;
        let times = own.checked_div(power).filter(|times| *times > 0 && times * power == own)?;
        let exponent = Expr::integer(times, span);
        Some(Expr::new(Node::Power(Box::new(value.clone()), Box::new(exponent)), span))
    });
    new.symbols().iter().all(|(other, _)| *other != id).then_some(new)
}

/// Two statements that differ in the sign of `±` as one, the product of which vanishes.
fn one_equation(reading: &Reading) -> Option<Reading> {
    let [Ok(first), Ok(second)] = reading.statements.as_slice() else { return None };
    let off = |statement: &Statement| match statement.members.as_slice() {
        [left, right] => Some(left.clone().minus(right.clone())),
        _ => None,
    };
    (first.branch.is_some() && second.branch.is_some()).then_some(())?;
    let product = Expr::new(Node::Product(vec![off(first)?, off(second)?]), first.span);
    let members = vec![product, Expr::integer(0, first.span)];
    let relations = vec![(Relation::Equal, first.span)];
    let statement = Statement { members, relations, branch: None, ..first.clone() };
    Some(Reading { statements: vec![Ok(statement)], introduced: Vec::new() })
}
