//! A slip that hides behind a letter: a line gives a wanted result with a slip to a name that stands nowhere else, and so it seems to
//! define a quantity of the student's own.

use crate::formula::SymbolId;
use crate::latex::rename::renamed;
use crate::latex::{Macros, names};

use crate::check::document::checker::Checker;
use crate::check::mark::judged::Found;
use crate::check::mark::marked::{Line, Mark};
use crate::check::mark::slip;
use crate::check::mark::world::World;
use crate::check::verdict::Verdict;

/// Leaves such lines open, where exactly one wanted result that no line reaches fits.
pub(super) fn leave_open(checker: &Checker<'_>, world: &World<'_>, lines: &mut [Line], found: &[Option<Found>]) {
    for (at, line) in lines.iter_mut().enumerate().filter(|(_, line)| line.mark == Mark::Given) {
        let Some(letter) = only_here(checker, world, at) else { continue };
        let missing = world.problem.wanted.iter().zip(found).filter(|(_, found)| found.is_none());
        let names = missing.filter_map(|(wanted, _)| {
            let id = defined(checker, wanted.display).filter(|id| !is_used(checker, world, *id))?;
            is_it_with_a_slip(checker, world, (at, letter), id).then_some(id)
        });
        let names: Vec<SymbolId> = names.collect();
        if let [only] = names.as_slice() {
            let own = world.in_own_letters(&checker.model.name(letter));
            let wanted = checker.model.name(*only);
            (line.mark, line.verdict) = (Mark::Open, Some(Verdict::Undecided));
            line.because =
                format!("defines {own}, which no other line uses; if {own} stands for {wanted}, this line is wrong")
                    .into();
        }
    }
}

/// The name that a display defines.
fn defined(checker: &Checker<'_>, display: usize) -> Option<SymbolId> {
    let [Ok(statement)] = checker.readings[display].statements.as_slice() else { return None };
    statement.members.first()?.as_plain_symbol()
}

/// The name of the student's own that a line defines and no other line has; all else in the line is of the problem.
fn only_here(checker: &Checker<'_>, world: &World<'_>, at: usize) -> Option<SymbolId> {
    let display = world.first + at;
    let id = defined(checker, display)?;
    let of_problem = |id: SymbolId| world.problem.names.symbols.find(&checker.model.symbols.entry(id).name).is_some();
    let own = &checker.readings[display];
    let others = own.statements.iter().flatten().flat_map(|statement| statement.members.iter().skip(1));
    let mut others = others.flat_map(|member| member.symbols()).peekable();
    let is_alone = !(0..world.written.len()).any(|other| other != at && has(checker, world.first + other, id));
    (others.peek().is_some() && others.all(|(other, _)| of_problem(other)) && !of_problem(id) && is_alone).then_some(id)
}

/// Whether the hand-in has a symbol.
fn is_used(checker: &Checker<'_>, world: &World<'_>, id: SymbolId) -> bool {
    (0..world.written.len()).any(|at| has(checker, world.first + at, id))
}

fn has(checker: &Checker<'_>, display: usize, id: SymbolId) -> bool {
    let members = checker.readings[display].statements.iter().flatten().flat_map(|statement| &statement.members);
    members.flat_map(|member| member.symbols()).any(|(other, _)| other == id)
}

/// Whether one likely edit makes a line true that has a name of the problem in the place of the student's letter.
fn is_it_with_a_slip(
    checker: &Checker<'_>,
    world: &World<'_>,
    (at, letter): (usize, SymbolId),
    wanted: SymbolId,
) -> bool {
    let name = |id: SymbolId| names::parse(&checker.model.name(id)).map(|(name, _)| name);
    let (Some(own), Some(other)) = (name(letter), name(wanted)) else { return false };
    let table = std::iter::once((own, other)).collect();
    let text = renamed(&world.display(at).text, &Macros::default(), &table).text;
    slip::is_one_edit_away(checker, world.first + at, (&text, wanted))
}
