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
use crate::formula::{Expr, Node, SymbolId, text};
use crate::latex::read_display;

/// Words for a sum.
const SUM: [&str; 5] = ["sum is", "summe ist", "somme est", "somma è", "suma es"];

/// What the words say of a name.
pub(super) struct Restated {
    pub said: Special,
    /// Whether nothing stands between the words and the display but that the one gives the other.
    pub is_direct: bool,
}

impl Course<'_, '_> {
    /// The finding on a display that gives a formula to a name, if the words before it say what the name is.
    pub(super) fn restated(&mut self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(None) };
        let Some((name, formula)) = named(statement).filter(|(_, formula)| !formula.symbols().is_empty()) else {
            return Ok(None);
        };
        if inline::is_inline(checker.notes, display) || found.finding.verdict.passes() && !is_definition(found) {
            return Ok(None);
        }
        let restated = self.sum(at, name).or_else(|| self.formula_in_sentence(at, statement));
        let Some(Restated { said: Special { value, says }, is_direct }) = restated else { return Ok(None) };
        let agrees = |formula: &Expr| -> Result<bool> {
            Ok(self.constant_ratio(&value, formula)?.is_some_and(|ratio| (ratio - 1.0).abs() < ROUNDING))
        };
        if agrees(formula)? {
            return Ok(Some(gate::settled(found, (Verdict::Verified, Code::Holds), format!("this is {says}"))));
        }
        if !is_direct {
            return Ok(None);
        }
        let words = prose::before(checker.notes, at);
        let is_general = !words.other_case && !words.announced.is_supposed();
        if !is_general {
            return Ok(None);
        }
        // With another letter it is the same law of another thing: the speed at another height.
        let is_meant = |edited: &Expr| Ok(has_same_names(formula, edited) && agrees(edited)?);
        if let Some(wrong) = self.one_edit_from(at, found, formula, (&says, &is_meant))? {
            // The slip may be in what the formula of the words uses.
            return Ok(Some(match self.definition_that_explains(&value, formula)? {
                Some(other) => {
                    let message = format!("this is not {says}, unless ({other}) is wrong");
                    gate::settled(found, (Verdict::Undecided, Code::NotDecided), message)
                }
                None => wrong,
            }));
        }
        // What rests on this name rests on a formula that may be wrong.
        self.doubtful.push(name);
        Ok(None)
    }

    /// The name of a display with a definition, where a likely slip in it explains why a formula that uses it is not equal to another
    /// one.
    fn definition_that_explains(&self, uses: &Expr, other: &Expr) -> Result<Option<String>> {
        let checker = self.checker;
        let used = gate::names(uses, checker.model);
        for (place, display) in checker.notes.equations.iter().enumerate() {
            let is_used = |id: &SymbolId| checker.readings[place].introduced.iter().any(|new| new.symbol == *id);
            if inline::is_inline(checker.notes, display) || !used.iter().any(is_used) {
                continue;
            }
            for edit in self.edits_with_factors(place, None) {
                let text = edit.applied(&display.text);
                let reading = read_display(&text, &mut checker.model.symbols.clone(), &checker.model.macros);
                for (name, formula) in reading.statements.iter().flatten().filter_map(named) {
                    let mut edited = uses.clone();
                    edited.substitute(&|node| match node {
                        Node::Symbol { id, dots: 0, .. } if *id == name => Some(formula.clone()),
                        _ => None,
                    });
                    let ratio = self.constant_ratio(&edited, other)?;
                    if edited != *uses && ratio.is_some_and(|ratio| (ratio - 1.0).abs() < ROUNDING) {
                        return Ok(display.id().map(str::to_owned));
                    }
                }
            }
        }
        Ok(None)
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
    fn sum(&self, at: usize, name: SymbolId) -> Option<Restated> {
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
        let value = self.read_formula(&sum).filter(|_| terms.len() > 1)?;
        let says = format!("{}, the sum that the text before it names", text::plain(&sum));
        Some(Restated { said: Special { value, says }, is_direct: true })
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

/// Whether two formulas contain the same names.
fn has_same_names(a: &Expr, b: &Expr) -> bool {
    let (a, b) = (a.symbols(), b.symbols());
    a.iter().all(|name| b.contains(name)) && b.iter().all(|name| a.contains(name))
}

/// Whether the finding is that a display gives a name a formula.
fn is_definition(found: &Equation) -> bool {
    found.finding.verdict == Verdict::Definition
}
