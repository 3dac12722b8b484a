//! Laws in each of several states: `pV = nRT` says `p_1V_1 = nRT_1` and `p_2V_2 = nRT_2` too.
//!
//! A relation between quantities without indices, some of which a display has with an index, holds for each index of the
//! display: of the states 1 and 2 of a gas, of the bodies A and B. What has no index there, as n and R, is the same in all of
//! them.

use std::collections::{BTreeSet, HashMap};

use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::premises::{Premise, Said};
use crate::check::usage::names_of;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Statement, SymbolId};
use crate::latex::read_display;
use crate::latex::rename::renamed;
use crate::notes::Display;

/// The most states of a display.
const MOST_STATES: usize = 4;

impl Course<'_, '_> {
    /// The premises that hold in each of the states that a display names, as premises of their own.
    pub(super) fn in_states(&self, at: usize, known: &[Premise]) -> Vec<Premise> {
        let used = self.names(&self.checker.notes.equations[at], None);
        let indices: BTreeSet<&String> = used.iter().filter_map(index).collect();
        if indices.is_empty() || indices.len() > MOST_STATES {
            return Vec::new();
        }
        known.iter().filter_map(|premise| self.in_each(premise, &indices, &used)).collect()
    }

    /// A premise in each of some states; `None`, if its quantities have no such indices.
    fn in_each(&self, premise: &Premise, indices: &BTreeSet<&String>, used: &[Name]) -> Option<Premise> {
        let (checker, model) = (self.checker, self.checker.model);
        let display = &checker.notes.equations[premise.at];
        let text = match &premise.said {
            Said::Whole if checker.readings[premise.at].statements.len() == 1 => &display.text,
            Said::Part(part) => part,
            _ => return None,
        };
        let own = self.names(display, Some(text));
        let mut symbols: Vec<SymbolId> = Vec::new();
        let (mut said, mut equalities) = (Vec::new(), 0);
        for state in indices {
            let indexed = |name: &Name| Name { subscript: vec![(*state).clone()], ..name.clone() };
            let is_quantity = |name: &&Name| {
                let indexed = indexed(name);
                name.subscript.is_empty() && !own.contains(&indexed) && model.symbols.find(&indexed).is_some()
            };
            let table: HashMap<Name, Name> =
                own.iter().filter(is_quantity).map(|name| (name.clone(), indexed(name))).collect();
            // Most of its quantities belong to a state.
            if 2 * table.len() <= own.len() || !table.values().any(|name| used.contains(name)) {
                continue;
            }
            let text = renamed(text, &model.macros, &table).text;
            let mut names = model.symbols.clone();
            let reading = read_display(&text, &mut names, &model.macros);
            let [Ok(statement)] = reading.statements.as_slice() else { continue };
            // A rate belongs to a process, and not to a state.
            let moves = |member: &Expr| member.symbols().iter().any(|(_, dots)| *dots > 0);
            if names.len() > model.symbols.len() || statement.constant.is_some() || statement.members.iter().any(moves)
            {
                continue;
            }
            equalities += statement.relations.len();
            symbols.extend(leaves(statement, self));
            said.push(text);
        }
        symbols.sort_unstable_by_key(|id| id.0);
        symbols.dedup();
        (!said.is_empty()).then(|| Premise { said: Said::States(said), symbols, equalities, ..premise.clone() })
    }

    /// The names in a display, or in a part of it.
    fn names(&self, display: &Display, part: Option<&str>) -> Vec<Name> {
        let text = part.unwrap_or(&display.text).to_owned();
        let only = Display { text, ..display.clone() };
        names_of(&[only], &self.checker.model.macros).into_iter().map(|usage| usage.name).collect()
    }
}

/// The index of a name that has one, of one token.
fn index(name: &Name) -> Option<&String> {
    match name.subscript.as_slice() {
        [only] => Some(only),
        _ => None,
    }
}

fn leaves(statement: &Statement, course: &Course<'_, '_>) -> Vec<SymbolId> {
    statement.members.iter().flat_map(|member| gate::leaves(member, course.checker.model)).collect()
}
