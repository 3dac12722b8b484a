//! Lines about the frequency of a secular equation: the equation in another form, and its roots.

use crate::formula::{Expr, Node, Relation, Statement};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::given;
use crate::check::mark::status::{Status, status};

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
