//! The place of an extremum, and an instant that a phase gives: lines that are no identities, and say so in words or by their form.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::Reading;

use crate::check::mark::given;
use crate::check::mark::marked::{Because, Line, Mark};
use crate::check::mark::status::Status;
use crate::check::mark::written::single_letters;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::verdict::Verdict;

use super::Judge;

impl Judge<'_, '_> {
    /// Whether a line is right as the place of an extremum; it is then about the value at that place.
    pub(super) fn is_at_an_extremum(&mut self, at: usize, reading: &Reading, line: &mut Line) -> bool {
        let Some((there, because)) = self.at_an_extremum(at, reading) else { return false };
        (line.mark, line.verdict, line.because) = (Mark::Right, Some(Verdict::Verified), because);
        self.premises[self.world.first + at] = there;
        true
    }

    /// Whether a line about an extremum holds where a constant has the value that the problem names after it: `\omega^2 = \omega_0^2 -
    /// 2\gamma^2` for the largest amplitude, where the problem has ω and ω_r. The line with that value in the place of the constant.
    fn at_an_extremum(&self, at: usize, reading: &Reading) -> Option<(Reading, Because)> {
        let written = &self.world.written[at];
        let statements = || reading.statements.iter().flatten();
        let vanishes = |statement: &Statement| statement.members.last().is_some_and(Expr::is_null);
        let equates = |statement: &Statement| statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        let is_condition = written.is_extremum || written.is_after_extremum && statements().all(vanishes);
        if !self.details || !is_condition || statements().next().is_none() || !statements().all(equates) {
            return None;
        }
        // A name of the student's own may hide the constant: `s = \omega^2`.
        let of_problem = self.world.problem.notes.equations.len();
        let mut reading = reading.clone();
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            *member = given::expanded(self.quiet, of_problem, member.clone());
        }
        let statements = || reading.statements.iter().flatten();
        let model = self.quiet.model;
        let members = || statements().flat_map(|statement| &statement.members);
        let is_constant = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Constant(_))) && !self.is_own(id);
        let mut constants: Vec<SymbolId> = members().flat_map(Expr::symbols).map(|(id, _)| id).collect();
        constants.retain(|id| is_constant(*id));
        constants.sort_unstable();
        constants.dedup();
        constants.into_iter().find_map(|id| {
            let places = self.named_after(&model.symbols.entry(id).name);
            places.into_iter().find_map(|place| {
                let new = with_value(&reading, id, place);
                let holds = matches!(self.status(self.world.first + at, &new).0, Status::Holds(_));
                let name = |id| model.symbols.entry(id).name.clone();
                holds.then(|| (new, Because::AtValue(name(id), name(place))))
            })
        })
    }

    /// What the problem defines with the letter of a constant and a subscript: ω_r for ω.
    fn named_after(&self, name: &Name) -> Vec<SymbolId> {
        let model = self.quiet.model;
        let fixed = self.world.problem.names.fixed.iter().filter(|other| other.base == name.base && *other != name);
        let found = fixed.filter_map(|other| Some(model.symbols.find(other)?.0));
        found.filter(|id| matches!(model.meaning(*id), Some(Meaning::Defined(_)))).collect()
    }

    /// Whether a line in the text gives an instant by a phase, `\omega t = \delta + \pi/2`.
    pub(super) fn is_instant_of_a_phase(&self, statement: &Statement) -> bool {
        let model = self.quiet.model;
        let is_time = |id: SymbolId| {
            matches!(model.meaning(id), Some(Meaning::Time))
                || single_letters::is_instant(&model.symbols.entry(id).name)
        };
        let is_fixed = |(id, dots): &(SymbolId, u8)| {
            let name = &model.symbols.entry(*id).name;
            *dots == 0 && self.world.problem.names.fixed.contains(name)
        };
        let is_phase = |side: &Expr| {
            let Node::Product(factors) = &side.node else { return false };
            let (times, others): (Vec<&Expr>, Vec<&Expr>) =
                factors.iter().partition(|factor| factor.as_plain_symbol().is_some_and(is_time));
            times.len() == 1 && others.iter().all(|factor| factor.symbols().iter().all(is_fixed))
        };
        let is_value = |side: &Expr| side.symbols().iter().all(is_fixed);
        let [first, second] = statement.members.as_slice() else { return false };
        statement.relations.iter().all(|(relation, _)| is_equality(*relation))
            && (is_phase(first) && is_value(second) || is_phase(second) && is_value(first))
    }
}

/// A reading with one symbol in the place of another.
pub(super) fn with_value(reading: &Reading, id: SymbolId, place: SymbolId) -> Reading {
    let mut reading = reading.clone();
    for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        member.rename(&|other| if other == id { place } else { other });
    }
    reading
}
