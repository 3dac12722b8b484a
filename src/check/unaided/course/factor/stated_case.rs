//! What a display says in a case that the sentence before it states: "At `\beta = 3/5` we have `\gamma = 5/4`", after `\gamma = …`.
//!
//! The case is a hypothesis beside the last relation that contains all its names. If the display follows from the two, it passes. If
//! its sides then have the same ratio in all states, and it is not 1, the display is wrong: it gives the quantity another value.

use crate::Result;
use crate::check::document::inferred::prose::body_of;
use crate::check::unaided::course::{Course, special_values};
use crate::check::unaided::gate;
use crate::check::unaided::inline;
use crate::check::unaided::premises::Said;
use crate::check::unaided::prose;
use crate::check::unaided::signs::Positive;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::formula::{Expr, Statement, SymbolId, text};
use crate::latex::read_display;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

/// The most values that a sentence gives.
const MOST: usize = 3;

/// How many displays back the relation may stand.
const NEAR: usize = 4;

/// A value that a sentence gives to a name.
struct Value {
    name: SymbolId,
    /// The symbols of the value.
    symbols: Vec<SymbolId>,
    latex: String,
    /// The same in plain text.
    says: String,
}

impl Course<'_, '_> {
    /// The finding on a display that follows from a relation in the case that the sentence before it states, or is off by a number.
    pub(in crate::check::unaided::course) fn in_stated_case(
        &mut self,
        at: usize,
        positive: Option<&Positive>,
    ) -> Result<Option<Equation>> {
        let (checker, notes) = (self.checker, self.checker.notes);
        let values = self.values_in_last_sentence(at);
        let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(None) };
        if values.is_empty() || values.len() > MOST || statement.members.len() != 2 {
            return Ok(None);
        }
        let Some(general) = self.general(at, statement, &values) else { return Ok(None) };
        let Some(id) = notes.equations[general].id().map(str::to_owned) else { return Ok(None) };
        let hypothesis = |latex: String| Spanned::new(latex, Span::default());
        // A definition is put in wherever its name stands. What is neither that nor taken for granted is wrong.
        let defines = !checker.readings[general].introduced.is_empty();
        let premise = self.known.iter().find(|premise| premise.at == general && premise.said == Said::Whole).cloned();
        if !defines && premise.is_none() {
            return Ok(None);
        }
        let relation = (!defines).then(|| id.clone());
        let throughout = relation.into_iter().chain(values.iter().map(|value| value.latex.clone())).map(hypothesis);
        let claim = Claim { throughout: throughout.collect(), ..Claim::default() };
        let case: Vec<&str> = values.iter().map(|value| value.says.as_str()).collect();
        let case = format!("({id}) where {}", case.join(" and "));
        let relations = self.checker.readings[general].statements.iter().flatten();
        let symbols = self.symbols_of(&relations.collect::<Vec<&Statement>>());
        let where_positive = positive.map(|positive| positive.with(symbols.into_iter(), checker.model));
        if let Some(mut follows) = self.passes(at, &claim)? {
            follows.finding.message = format!("follows from {case}");
            return Ok(Some(gate::as_it_counts(follows)));
        }
        if let Some(positive) = where_positive
            && let Some(mut follows) = self.follows_where(at, &positive, &claim)?
        {
            follows.finding.message = format!("{}; it follows from {case}", follows.finding.message);
            return Ok(Some(gate::as_it_counts(follows)));
        }
        let quick = self.equation(&self.quick, at, &claim)?;
        if quick.finding.verdict != Verdict::Refuted
            || self.rests_on_doubt(at)
            || prose::brings_another_thing(notes, at)
        {
            return Ok(None);
        }
        let Some(mut wrong) = self.concluded_off_by_a_factor(at, &claim)? else { return Ok(None) };
        wrong.finding.message = format!("this does not follow from {case}: {}", wrong.finding.message);
        self.blamed.extend(premise.map(|premise| (at, vec![premise])));
        Ok(Some(wrong))
    }

    /// The last relation before a display that contains all names of a case, and what the display is about.
    fn general(&self, at: usize, statement: &Statement, values: &[Value]) -> Option<usize> {
        let (notes, readings) = (self.checker.notes, self.checker.readings);
        let own: Vec<SymbolId> = statement.members.iter().flat_map(Expr::symbols).map(|(id, _)| id).collect();
        if values.iter().any(|value| own.contains(&value.name) && !value.symbols.is_empty()) {
            return None;
        }
        let displays = (0..at).rev().filter(|place| !inline::is_inline(notes, &notes.equations[*place]));
        displays.take(NEAR).take_while(|place| readings[*place].statements.iter().all(Result::is_ok)).find(|place| {
            let [Ok(general)] = readings[*place].statements.as_slice() else { return false };
            let printed: Vec<SymbolId> = general.members.iter().flat_map(Expr::symbols).map(|(id, _)| id).collect();
            let is_known =
                |id: &SymbolId| printed.contains(id) || values.iter().any(|value| value.symbols.contains(id));
            let is_about = |id: &SymbolId| printed.contains(id) && values.iter().all(|value| value.name != *id);
            values.iter().all(|value| printed.contains(&value.name))
                && own.iter().all(is_known)
                && own.iter().any(is_about)
        })
    }

    /// The values that the sentence directly before a display gives to names.
    fn values_in_last_sentence(&self, at: usize) -> Vec<Value> {
        let (notes, model) = (self.checker.notes, self.checker.model);
        let end = notes.equations[at].span.start;
        let mut found = Vec::new();
        for span in self.in_sentences_before(at).filter(|span| prose::is_in_last_sentence(notes, *span, end)) {
            let Some(printed) = body_of(notes, span).map(|body| notes.source.slice(body)) else { continue };
            let mut table = model.symbols.clone();
            let reading = read_display(printed, &mut table, &model.macros);
            for statement in reading.statements.iter().flatten() {
                let Some((name, value)) =
                    special_values::value_of(statement).filter(|(name, _)| self.seen.contains_key(name))
                else {
                    continue;
                };
                let symbols: Vec<SymbolId> = value.symbols().into_iter().map(|(id, _)| id).collect();
                let latex = printed[statement.span.range()].to_owned();
                let says = format!("{} = {}", text::plain(&model.name(name)), text::formula(value, &table));
                if !symbols.contains(&name) {
                    found.push(Value { name, symbols, latex, says });
                }
            }
        }
        found
    }
}
