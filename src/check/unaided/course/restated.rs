//! A name that is the sum of the quantities directly before its display, as the words say: "The sum is" before W = …, after
//! W_i = … and W_o = ….
//!
//! Such a display gives the name a formula, which would be a definition otherwise. If it agrees with the sum, the display follows. It is
//! called wrong only if one likely slip in it lies between the two.

use crate::Result;
use crate::check::unaided::course::Course;
use crate::check::unaided::course::special_values::{ROUNDING, Special, named};
use crate::check::unaided::{gate, inline, prose};
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, SymbolId, text};
use crate::latex::read_display;

/// Words for a sum.
const SUM: [&str; 5] = ["sum is", "summe ist", "somme est", "somma è", "suma es"];

impl Course<'_, '_> {
    /// The finding on a display that gives a formula to a name, if the words before it say what the name is.
    pub(super) fn restated(&self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(None) };
        let Some((name, formula)) = named(statement).filter(|(_, formula)| !formula.symbols().is_empty()) else {
            return Ok(None);
        };
        if inline::is_inline(checker.notes, display) || found.finding.verdict.passes() && !is_definition(found) {
            return Ok(None);
        }
        let Some(said) = self.sum(at, name) else { return Ok(None) };
        let agrees = |formula: &Expr| -> Result<bool> {
            Ok(self.constant_ratio(&said.value, formula)?.is_some_and(|ratio| (ratio - 1.0).abs() < ROUNDING))
        };
        if agrees(formula)? {
            let verdict = (Verdict::Verified, Code::Holds);
            return Ok(Some(gate::settled(found, verdict, format!("this is {}", said.says))));
        }
        let words = prose::before(checker.notes, at);
        let is_general = !words.other_case && !words.announced.is_supposed();
        if !is_general {
            return Ok(None);
        }
        self.one_edit_from(at, found, formula, (&said.says, &agrees))
    }

    /// The displays directly before a display, the last first: the rows of one block, with no words between them.
    fn block_before(&self, at: usize) -> Vec<usize> {
        let notes = self.checker.notes;
        let mut found: Vec<usize> = Vec::new();
        for place in (0..at).rev().filter(|place| !inline::is_inline(notes, &notes.equations[*place])) {
            if let Some(last) = found.last() {
                let between = notes.equations[place].span.end..notes.equations[*last].span.start;
                let between = notes.source.text.get(between).unwrap_or_default();
                if between.contains(|c: char| c.is_alphabetic()) {
                    break;
                }
            }
            found.push(place);
        }
        found
    }

    /// The sum of the quantities directly before a display, if the sentence says that it is their sum: W of W_i and W_o.
    fn sum(&self, at: usize, name: SymbolId) -> Option<Special> {
        let (checker, model) = (self.checker, self.checker.model);
        let sentence = prose::sentence(checker.notes, at).to_lowercase();
        let own = &model.symbols.entry(name).name;
        if !SUM.iter().any(|word| sentence.contains(word)) || !own.subscript.is_empty() {
            return None;
        }
        let mut terms = Vec::new();
        for place in self.block_before(at).into_iter().rev() {
            for statement in checker.readings[place].statements.iter().flatten() {
                let id = statement.members.first().and_then(Expr::as_plain_symbol)?;
                let term = &model.symbols.entry(id).name;
                if term.base != own.base || term.subscript.is_empty() {
                    return None;
                }
                terms.push(model.name(id));
            }
        }
        let sum = terms.join(" + ");
        let formula = self.read_formula(&sum).filter(|_| terms.len() > 1)?;
        Some(Special { value: formula, says: format!("{}, the sum of which the words speak", text::plain(&sum)) })
    }

    /// A formula by its LaTeX, if it moves or has letters.
    fn read_formula(&self, latex: &str) -> Option<Expr> {
        let model = self.checker.model;
        let latex = format!("0 = {latex}");
        let reading = read_display(&latex, &mut model.symbols.clone(), &model.macros);
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        statement.members.get(1).filter(|formula| !formula.is_null() && !formula.symbols().is_empty()).cloned()
    }
}

/// Whether the finding is that a display gives a name a formula.
fn is_definition(found: &Equation) -> bool {
    found.finding.verdict == Verdict::Definition
}
