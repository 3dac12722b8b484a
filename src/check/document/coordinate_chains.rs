//! Chains that give several coordinates one function of the time: `x_1 = x_3 = f(t)`.

use crate::formula::{Expr, Statement};
use crate::latex::Reading;
use crate::source::Fault;

use crate::check::document::checker::Checker;
use crate::check::model::claim::is_equality;

impl Checker<'_> {
    /// The number of coordinates with which a chain begins.
    pub(crate) fn leading_coordinates(&self, statement: &Statement) -> usize {
        let is_coordinate = |member: &&Expr| member.as_plain_symbol().is_some_and(|id| self.model.is_coordinate(id));
        statement.members.iter().take_while(is_coordinate).count()
    }

    /// A reading in which `x_1 = x_3 = f(t)` is a statement for each coordinate; `None` where there is no such chain.
    pub(crate) fn with_each_solution(&self, reading: &Reading) -> Option<Reading> {
        let several = |statement: &Statement| {
            let names = self.leading_coordinates(statement);
            let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
            let of_time = || statement.members.get(names).is_some_and(|value| self.model.contains_time(value));
            (names > 1 && is_equal && of_time()).then_some(names)
        };
        let is_one = |statement: &std::result::Result<Statement, Fault>| {
            statement.as_ref().is_ok_and(|statement| several(statement).is_some())
        };
        if !reading.introduced.is_empty() || !reading.statements.iter().any(is_one) {
            return None;
        }
        let statements = reading.statements.iter().flat_map(|statement| {
            let Ok(whole) = statement else { return vec![statement.clone()] };
            let names = several(whole).unwrap_or(1);
            let each = |at: usize| {
                let mut one = whole.clone();
                one.members.drain(..names);
                one.members.insert(0, whole.members[at].clone());
                one.relations.drain(..names - 1);
                Ok(one)
            };
            match names {
                1 => vec![statement.clone()],
                names => (0..names).map(each).collect(),
            }
        });
        Some(Reading { statements: statements.collect(), introduced: Vec::new() })
    }
}
