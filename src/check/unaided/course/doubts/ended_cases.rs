//! Displays that state a special case: "For equal masses, $$m_1 = m_2$$", "Without friction $$\mu = 0$$".
//!
//! Such a relation holds for the displays that follow from it one after the other. After other words, as "In general again", and after
//! a heading it holds no more, and neither does what followed from it. Authors do not say where a case ends.

use crate::check::document::inferred::prose::{sentence_start, words_between};
use crate::check::unaided::course::Course;
use crate::check::unaided::inline;
use crate::check::unaided::premises::Premise;
use crate::formula::{Expr, Node};

/// Words with which the sentence of a special case begins or that stand in it.
const CASES: [&str; 22] = [
    "for", "in", "at", "if", "when", "without", "let", "case", "state", "suppose", "assume", "assuming", "special",
    "now", "take", "set", "on", "für", "ohne", "pour", "sans", "per",
];

impl Course<'_, '_> {
    /// Leaves out the special cases that hold no more at a display, and what followed from them. The words may name them.
    pub(in crate::check::unaided::course) fn leave_out_ended_cases(
        &self,
        at: usize,
        named: &[usize],
        before: &mut Vec<Premise>,
    ) {
        let has_ended = |place: usize| !named.contains(&place) && self.states_a_case(place) && !self.goes_on(place, at);
        before.retain(|premise| {
            named.contains(&premise.at)
                || !std::iter::once(&premise.at).chain(&premise.from).any(|place| has_ended(*place))
        });
    }

    /// Whether a display states a special case: the words say so, or it gives a name a number.
    fn states_a_case(&self, at: usize) -> bool {
        let notes = self.checker.notes;
        let display = &notes.equations[at];
        if inline::is_inline(notes, display) || !self.sets_a_value(at) {
            return false;
        }
        // A blank line may stand between the words and the display.
        let end = notes.source.text.get(..display.span.start).unwrap_or_default().trim_end().len();
        let words = words_between(notes, sentence_start(notes, end), end);
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let has_number = members.into_iter().any(|member| member.symbols().is_empty());
        has_number || words.iter().any(|word| CASES.contains(&word.as_str()))
    }

    /// Whether a display, or a formula in a sentence, gives a name that stands before it the value of another name or of a number.
    pub(in crate::check::unaided) fn sets_a_value(&self, at: usize) -> bool {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return false };
        let [first, others @ ..] = statement.members.as_slice() else { return false };
        let is_known = first.as_plain_symbol().is_some_and(|id| self.seen.get(&id).is_some_and(|place| *place < at));
        let is_value = |value: &Expr| match &value.node {
            Node::Sum(terms) => terms.len() == 1 && is_name_or_number(&terms[0].expr),
            _ => is_name_or_number(value),
        };
        is_known && !others.is_empty() && others.iter().all(is_value)
    }

    /// Whether each display after a special case, up to another one, follows with no other words than those of a consequence.
    fn goes_on(&self, case: usize, at: usize) -> bool {
        let displays = &self.checker.notes.equations;
        (case + 1..=at).all(|next| {
            let words = words_between(self.checker.notes, displays[next - 1].span.end, displays[next].span.start);
            words.iter().all(|word| inline::connects(word))
        })
    }
}

fn is_name_or_number(value: &Expr) -> bool {
    value.as_plain_symbol().is_some() || value.symbols().is_empty()
}
