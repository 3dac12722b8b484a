//! Displays that state a special case: "For equal masses, $$m_1 = m_2$$", "Without friction $$\mu = 0$$".
//!
//! Such a relation holds for the displays that follow from it one after the other. After other words, as "In general again", and after
//! a heading it holds no more, and neither does what followed from it. Authors do not say where a case ends.

use crate::check::document::inferred::prose::{sentence_start, words_between};
use crate::check::unaided::course::Course;
use crate::check::unaided::inline;
use crate::check::unaided::premises::Premise;
use crate::formula::{Expr, Node, SymbolId};

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

    /// Leaves out what the words say of another case than that of a display: in parallel R is another resistance than in series. A name
    /// with a subscript is that of its case everywhere.
    pub(in crate::check::unaided::course) fn leave_out_other_cases(
        &self,
        at: usize,
        named: &[usize],
        before: &mut Vec<Premise>,
    ) {
        let is_general = |place: usize| {
            let statements = self.checker.readings[place].statements.iter().flatten();
            let mut subjects = statements.filter_map(|statement| statement.members.first()?.as_plain_symbol());
            subjects.any(|id| self.checker.model.symbols.entry(id).name.subscript.is_empty())
        };
        before.retain(|premise| {
            let mut places = std::iter::once(&premise.at).chain(&premise.from);
            named.contains(&premise.at) || !places.any(|place| is_general(*place) && self.cases.differ(*place, at))
        });
    }

    /// Leaves out the values that do not hold where a display does: after "when `r = R`" a display with r and R is about every r, and one
    /// with c is not about units in which `c = 1`. In the middle of a chain stands what is put in.
    pub(in crate::check::unaided::course) fn leave_out_other_values(&self, at: usize, before: &mut Vec<Premise>) {
        before.retain(|premise| {
            let mut places = std::iter::once(&premise.at).chain(&premise.from);
            !places.any(|place| self.has_another_value(*place, at))
        });
    }

    /// Whether the sentences directly before a display give a value that does not hold where the display does. Nobody can tell from which
    /// of them it follows then, so it is not called wrong.
    pub(in crate::check::unaided::course) fn stands_beside_another_value(&self, at: usize) -> bool {
        self.formulas_before(at).into_iter().any(|place| self.has_another_value(place, at))
    }

    /// Whether a formula in a sentence is a value that a display, with all its names at its ends, is not about.
    fn has_another_value(&self, place: usize, at: usize) -> bool {
        let (notes, readings) = (self.checker.notes, self.checker.readings);
        let [Ok(statement)] = readings[place].statements.as_slice() else { return false };
        if !inline::is_inline(notes, &notes.equations[place]) {
            return false;
        }
        let names: Option<Vec<Option<SymbolId>>> = statement.members.iter().map(name_or_number).collect();
        let names: Vec<SymbolId> = names.into_iter().flatten().flatten().collect();
        let statements = readings[at].statements.iter().flatten();
        let ends =
            statements.flat_map(|statement| statement.members.first().into_iter().chain(statement.members.last()));
        let printed: Vec<SymbolId> = ends.flat_map(Expr::symbols).map(|(id, _)| id).collect();
        !names.is_empty() && names.iter().all(|id| printed.contains(id))
    }

    /// The names that have another value in a special case that holds at a display, without saying so: after `r = n^2 a_0` it is n where,
    /// for the ground state, `r = a_0`.
    pub(in crate::check::unaided) fn left_open_by_a_case(&self, at: usize) -> Vec<SymbolId> {
        let readings = self.checker.readings;
        let names = |place: usize| {
            let members = readings[place].statements.iter().flatten().flat_map(|statement| &statement.members);
            members.flat_map(Expr::symbols).map(|(id, _)| id).collect::<Vec<_>>()
        };
        let subject = |place: usize| match readings[place].statements.as_slice() {
            [Ok(statement)] => statement.members.first().and_then(Expr::as_plain_symbol),
            _ => None,
        };
        let cases = (self.scope.carried..at).filter(|case| self.states_a_case(*case) && self.goes_on(*case, at));
        let general = cases.flat_map(|case| {
            let is_general = move |place: &usize| subject(*place).is_some() && subject(*place) == subject(case);
            (0..case).filter(is_general).map(move |place| (place, case))
        });
        general
            .flat_map(|(place, case)| {
                let kept = names(case);
                names(place).into_iter().filter(move |id| !kept.contains(id))
            })
            .collect()
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

/// The name that a value is, or a rate of which it is one; no name, if it is a number.
fn name_or_number(value: &Expr) -> Option<Option<SymbolId>> {
    match &value.node {
        Node::Symbol { id, .. } => Some(Some(*id)),
        Node::Sum(terms) if terms.len() == 1 => name_or_number(&terms[0].expr),
        _ => value.symbols().is_empty().then_some(None),
    }
}

fn is_name_or_number(value: &Expr) -> bool {
    value.as_plain_symbol().is_some() || value.symbols().is_empty()
}
