//! Chains that give several coordinates one function of the time: `x_1 = x_3 = f(t)`.

use crate::formula::{Expr, Node, Sign, Statement, Term};
use crate::latex::Reading;
use crate::source::Fault;

use crate::check::document::checker::Checker;
use crate::check::model::claim::is_equality;

impl Checker<'_> {
    /// The coordinate that a member of a chain is, or of which it is the negative.
    fn coordinate_of(&self, member: &Expr) -> Option<(Expr, Sign)> {
        let is_coordinate = |member: &Expr| member.as_plain_symbol().is_some_and(|id| self.model.is_coordinate(id));
        match &member.node {
            Node::Sum(terms) => match terms.as_slice() {
                [Term { sign: Sign::Minus, expr, .. }] if is_coordinate(expr) => Some((expr.clone(), Sign::Minus)),
                _ => None,
            },
            _ => is_coordinate(member).then(|| (member.clone(), Sign::Plus)),
        }
    }

    /// The coordinates with which a chain begins, and the sign of each: x_1 and x_3 in `x_1 = -x_3 = f(t)`.
    pub(crate) fn leading_coordinates(&self, statement: &Statement) -> Vec<(Expr, Sign)> {
        let all: Vec<(Expr, Sign)> = statement.members.iter().map_while(|member| self.coordinate_of(member)).collect();
        match all.first() {
            Some((_, Sign::Plus)) => all,
            _ => Vec::new(),
        }
    }

    /// A reading in which `x_1 = x_3 = f(t)` is a statement for each coordinate; `None` where there is no such chain.
    pub(crate) fn with_each_solution(&self, reading: &Reading) -> Option<Reading> {
        let several = |statement: &Statement| {
            let names = self.leading_coordinates(statement);
            let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
            let of_time = || statement.members.get(names.len()).is_some_and(|value| self.model.contains_time(value));
            (names.len() > 1 && is_equal && of_time()).then_some(names)
        };
        let is_one = |statement: &std::result::Result<Statement, Fault>| {
            statement.as_ref().is_ok_and(|statement| several(statement).is_some())
        };
        if !reading.introduced.is_empty() || !reading.statements.iter().any(is_one) {
            return None;
        }
        let statements = reading.statements.iter().flat_map(|statement| {
            let Ok(whole) = statement else { return vec![statement.clone()] };
            let Some(names) = several(whole) else { return vec![statement.clone()] };
            let each = |(name, sign): &(Expr, Sign)| {
                let mut one = whole.clone();
                one.members.drain(..names.len());
                if *sign == Sign::Minus {
                    one.members.iter_mut().for_each(|member| *member = member.clone().negated());
                }
                one.members.insert(0, name.clone());
                one.relations.drain(..names.len() - 1);
                Ok(one)
            };
            names.iter().map(each).collect()
        });
        Some(Reading { statements: statements.collect(), introduced: Vec::new() })
    }
}
