//! Relations of another system, or of another case, that say nothing here: the frequency of a pendulum beside that of a spring, and what
//! follows from a law that the words replace by another one.

use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::premises::Premise;
use crate::check::unaided::prose;
use crate::formula::SymbolId;

/// Words that put another law in the place of one.
const REPLACED: [&str; 7] =
    ["is replaced by", "are replaced by", "replaces (", "instead of (", "wird durch", "est remplacé", "se reemplaza"];

impl Course<'_, '_> {
    /// Whether a display gives a name that has a formula another one, and stands under a label or is about another thing than the first
    /// formula: "Pendulum:".
    pub(super) fn is_of_another_system(&self, at: usize) -> bool {
        let Some(id) = self.named_again(at) else { return false };
        let Some(first) = self.seen.get(&id) else { return false };
        let notes = self.checker.notes;
        let origin = self.scope.origin_of(at, notes.equations.len());
        let (own, other) = (prose::object(notes, origin), prose::object(notes, *first));
        prose::is_labelled(notes, origin) || own.is_some() && other.is_some() && own != other
    }

    /// Leaves out the premises of which the words before a display say that others hold in their place. What they name is kept.
    pub(super) fn leave_out_replaced(&self, at: usize, named: &[usize], premises: &mut Vec<Premise>) {
        let notes = self.checker.notes;
        let text = &notes.source.text;
        // The words before each display are looked up only where one of them may say so.
        if !["replac", "instead", "wird durch", "remplac", "reemplaz"].iter().any(|word| text.contains(word)) {
            return;
        }
        for place in 0..=at {
            let words = prose::words_since_last(notes, place);
            if !REPLACED.iter().any(|word| words.contains(word)) {
                continue;
            }
            for law in prose::before(notes, place).named.into_iter().filter(|law| *law < place) {
                let moving = self.moving(law);
                let is_about_it = |premise: &Premise| premise.symbols.iter().any(|id| moving.contains(id));
                premises.retain(|premise| {
                    let is_replaced = (law..place).contains(&premise.at) && is_about_it(premise);
                    !is_replaced || named.contains(&premise.at)
                });
            }
        }
    }

    /// The names in a display that vary.
    fn moving(&self, at: usize) -> Vec<SymbolId> {
        let mut found = self.symbols(at).unwrap_or_default();
        found.retain(|id| matches!(self.checker.model.meaning(*id), Some(Meaning::Varying(_))));
        found
    }
}
