//! A letter of the student's own for one of several values that the problem numbers: `\omega^2 = \frac km` beside ω_1 and ω_2.

use crate::formula::SymbolId;
use crate::formula::symbols::Name;
use crate::latex::Reading;

use crate::check::mark::marked::{Because, Line, Mark};
use crate::check::mark::status::Status;
use crate::check::verdict::Verdict;

use super::Judge;

impl Judge<'_, '_> {
    /// Whether a line that names a letter of the student's own holds with one of the values of the problem that have this letter and a
    /// number; each statement of the line may be about another one of them. The line is then about these values.
    pub(super) fn is_one_of_several(&mut self, at: usize, line: &mut Line) -> bool {
        let Some((there, names)) = self.one_of_several(at) else { return false };
        (line.mark, line.verdict, line.because) = (Mark::Right, Some(Verdict::Verified), Because::OneOf(names));
        self.premises[self.world.first + at] = there;
        true
    }

    fn one_of_several(&self, at: usize) -> Option<(Reading, Vec<Name>)> {
        let display = self.world.first + at;
        let own = &self.quiet.readings[display];
        let (letter, values) = self.world.letter_with_values(self.quiet, own)?;
        let mut there = Reading { statements: Vec::new(), introduced: Vec::new() };
        let mut names: Vec<Name> = Vec::new();
        for statement in own.statements.iter().flatten() {
            let with = |value: SymbolId| {
                let mut statement = statement.clone();
                statement
                    .members
                    .iter_mut()
                    .for_each(|member| member.rename(&|id| if id == letter { value } else { id }));
                Reading { statements: vec![Ok(statement)], introduced: Vec::new() }
            };
            let holds = |value: &SymbolId| matches!(self.status(display, &with(*value)).0, Status::Holds(_));
            let held: Vec<SymbolId> = values.iter().copied().filter(holds).collect();
            there.statements.extend(with(*held.first()?).statements);
            names.extend(held.into_iter().map(|value| self.quiet.model.symbols.entry(value).name.clone()));
        }
        names.dedup();
        (!names.is_empty()).then_some((there, names))
    }

    /// Whether a line speaks of a letter to which the hand-in gives several values, among those that the problem numbers.
    pub(super) fn has_a_numbered_value(&self, reading: &Reading) -> bool {
        let found = self.world.letter_with_values(self.quiet, reading);
        found.is_some_and(|(letter, _)| self.world.has_several_values(&self.quiet.model.symbols.entry(letter).name))
    }
}
