//! Numbers that are put into a formula, compared with it: the values of the letters come from the sentences and displays before.
//!
//! `d = \frac{v^2}{2g} = \frac{(4.4\,\text{m/s})^2}{2 \times 9.81\,\text{m/s}^2}` has no letters on its right side. Where each letter of the
//! formula was given a value before, the formula has one too, and the two are compared. They may differ for many reasons, such as
//! the values of another example, so the display is called wrong only if one likely slip in the formula explains the numbers.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::document::inferred::prose::body_of;
use crate::check::equations::measured::{
    Comparison, agree_to_the_digits, compared, in_words, other_units, shown_quantity,
};
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::repair::culprit::is_common;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::repair::suggest::is_in_source;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId, text};
use crate::latex::read_display;
use crate::latex::slips::{self, Edit, Pool, Slip};
use crate::phrases::listed;
use crate::source::Span;

/// The most edits of one formula that are tried, the likeliest first.
const TRIED: usize = 160;

/// The factors that authors lose.
pub(in crate::check::unaided) const LOST_FACTORS: [&str; 4] = ["2", "\\frac12", "4", "3"];

/// The deepest chain of definitions that is written out.
const DEEPEST: usize = 6;

/// The most letters, those of definitions included, among which those without a value are looked for.
const MOST_LETTERS: usize = 64;

/// The value of a letter, and where it is printed.
#[derive(Clone)]
pub(super) struct Given {
    symbol: SymbolId,
    value: Expr,
    end: usize,
}

/// A formula beside the numbers that stand for it.
struct Example<'e> {
    formula: &'e Expr,
    numbers: &'e Expr,
    is_approximate: bool,
}

/// A definition that the numbers of an example contradict.
pub(super) struct Contradicted {
    /// The place of the definition.
    pub definition: usize,
    /// The edit of it with which the numbers agree.
    pub repair: Repair,
    /// The place of the example.
    pub by: usize,
}

impl Course<'_, '_> {
    /// The finding on a display that puts numbers into a formula, if the values of all letters are known, and the numbers agree with
    /// them or one slip explains why they do not.
    pub(super) fn example(&mut self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        let checker = self.checker;
        let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(None) };
        let Some(example) = example_of(statement).or_else(|| self.example_of_definition(statement)) else {
            return Ok(None);
        };
        let given = self.values_before(at);
        let Some((with_values, used)) = self.put_in(example.formula, &given) else {
            return Ok(self.without_values(&example, &given, found));
        };
        let context = self.context(&[]);
        let compare = |formula: &Expr| compared(formula, example.numbers, example.is_approximate, &context);
        let shown: Vec<String> = used.iter().map(|given| self.shown(given)).collect();
        let finding = |verdict: Verdict, code: Code, message: String| gate::settled(found, (verdict, code), message);
        let outcome = compare(&with_values);
        if outcome == Comparison::Agree {
            let near = match agree_to_the_digits(&with_values, example.numbers, &context) {
                true => "to the printed digits",
                false => "to one part in a hundred",
            };
            let message = format!("the numbers agree with the formula {near}, for {}", shown.join(", "));
            return Ok(Some(finding(Verdict::Verified, Code::Holds, message)));
        }
        // The formula stands here, or in the display that defines the name.
        let (place, part) = match statement.members.iter().any(|member| std::ptr::eq(member, example.formula)) {
            true => (at, Some(example.formula.span)),
            false => match self.definition_before(at, statement) {
                Some(place) => (place, None),
                None => return Ok(None),
            },
        };
        let values = in_words(&with_values, example.numbers, &context).filter(|_| place == at);
        let units = other_units(&with_values, example.numbers, &context).filter(|_| place == at);
        let other = || {
            if let Some([computed, printed]) = &units {
                let message = format!(
                    "the units do not fit: for {}, the formula is in {computed}, and the printed value in {printed}; correct one \
                     of them; this is not called wrong, since these values may belong to another example",
                    shown.join(", ")
                );
                return Some(finding(Verdict::Assumed, Code::Assumed, message));
            }
            let (computed, printed) = values.as_ref()?;
            let message = format!(
                "the formula gives {computed} for {}, and {printed} is printed; this is not called wrong, since these values \
                 may belong to another example",
                shown.join(", ")
            );
            Some(finding(Verdict::Assumed, Code::Assumed, message))
        };
        if outcome == Comparison::Open {
            return Ok(other().filter(|_| found.finding.verdict == Verdict::Assumed));
        }
        let display = &checker.notes.equations[place];
        let explains = |edit: &Edit| {
            let text = edit.applied(&display.text);
            let reading = read_display(&text, &mut checker.model.symbols.clone(), &checker.model.macros);
            let mut statements = reading.statements.iter().flatten();
            let edited = match part {
                Some(_) => statements.next().and_then(example_of).map(|edited| edited.formula),
                None => {
                    let name = statement.members[0].as_plain_symbol();
                    statements
                        .find(|other| other.members.first().and_then(Expr::as_plain_symbol) == name)
                        .and_then(|other| other.members.get(1))
                }
            };
            let again = edited.and_then(|edited| self.put_in(edited, &given));
            again.is_some_and(|(edited, _)| compare(&edited) == Comparison::Agree)
        };
        let Some(edit) = self.edits_of(place, part).into_iter().filter(may_be_lost).find(explains) else {
            return Ok(other());
        };
        let repair = Repair::of(edit, display.body.start, Verdict::Verified);
        if place != at {
            self.contradicted.push(Contradicted { definition: place, repair, by: at });
            return Ok(None);
        }
        let message = match &values {
            Some((computed, printed)) => {
                format!("the formula gives {computed} for {}, and {printed} is printed", shown.join(", "))
            }
            None => format!("the formula does not give these numbers for {}", shown.join(", ")),
        };
        Ok(Some(Equation { repairs: vec![repair], ..finding(Verdict::Refuted, Code::NumbersDiffer, message) }))
    }

    /// The finding on numbers with units beside a formula of which a letter has no value, which says what letter this is.
    fn without_values(&self, example: &Example<'_>, given: &[Given], found: &Equation) -> Option<Equation> {
        let (model, left_open) = (self.checker.model, (Verdict::Assumed, Code::Assumed));
        let mut letters: Vec<(SymbolId, u8)> = example.formula.symbols();
        let mut lacking: Vec<String> = Vec::new();
        let mut at = 0;
        while let Some((id, dots)) = letters.get(at).copied().filter(|_| letters.len() < MOST_LETTERS) {
            at += 1;
            let is_given = dots == 0 && given.iter().any(|given| given.symbol == id);
            match model.meaning(id) {
                _ if is_given => {}
                Some(Meaning::Defined(inner)) if dots == 0 => {
                    let new = inner.symbols().into_iter().filter(|symbol| !letters.contains(symbol));
                    letters.extend(new.collect::<Vec<_>>());
                }
                _ => lacking.push(text::with_dots(&model.name(id), dots)),
            }
        }
        if lacking.is_empty() || (found.finding.verdict, found.finding.code) != left_open {
            return None;
        }
        let formula = text::formula(example.formula, &model.symbols);
        let letters = listed(&lacking, "and");
        let message =
            format!("the numbers for {formula} were not checked: the notes before it give no value for {letters}");
        Some(gate::settled(found, left_open, message))
    }

    /// The formula of a name that another display defines, beside the numbers that a statement gives it.
    fn example_of_definition<'s>(&'s self, statement: &'s Statement) -> Option<Example<'s>> {
        let [name, numbers, ..] = statement.members.as_slice() else { return None };
        let (relation, _) = statement.relations.first()?;
        let is_approximate = *relation == Relation::Approximately;
        let is_example = statement.branch.is_none() && numbers.symbols().is_empty() && !numbers.is_null();
        match self.checker.model.meaning(name.as_plain_symbol()?) {
            Some(Meaning::Defined(formula)) if is_example && (is_approximate || is_equality(*relation)) => {
                (!formula.symbols().is_empty()).then_some(Example { formula, numbers, is_approximate })
            }
            _ => None,
        }
    }

    /// The place of the display that defines the name on the left side of a statement of a later one.
    fn definition_before(&self, at: usize, statement: &Statement) -> Option<usize> {
        let name = statement.members.first()?.as_plain_symbol()?;
        let defines = |place: &usize| self.checker.readings[*place].introduced.iter().any(|new| new.symbol == name);
        (self.scope.carried..at).rev().find(defines)
    }

    /// The likely slips in a display, or a part of it, the likeliest first.
    pub(super) fn edits_of(&self, at: usize, part: Option<Span>) -> Vec<Edit> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let mut edits =
            slips::corrections(&display.text, &checker.model.symbols, &checker.model.macros, &Pool::empty());
        edits.retain(|edit| {
            part.is_none_or(|part| part.contains(edit.span))
                && is_common(edit.slip)
                && !edit.replacement.trim().is_empty()
                && !adds_parentheses(&display.text, edit)
                && is_in_source(checker, &display.text, edit, display.body.start)
        });
        edits.sort_by_key(|edit| rank(&display.text, edit, false));
        edits.truncate(TRIED);
        edits
    }

    /// The likely slips in a display, or a part of it, and the small numbers that it may have lost.
    pub(super) fn edits_with_factors(&self, at: usize, part: Option<Span>) -> Vec<Edit> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let points = slips::insertion_points(&display.text, &checker.model.symbols, &checker.model.macros);
        let starts = points.into_iter().filter(|point| point.slip == Slip::Factor).map(|point| point.whole.start);
        let inside = starts.filter(|start| part.is_none_or(|part| part.contains(Span::at(*start))));
        let factor = |start: usize| {
            LOST_FACTORS.map(|factor| Edit {
                span: Span::at(start),
                replacement: format!("{factor} "),
                slip: Slip::Factor,
            })
        };
        let lost = inside.flat_map(factor);
        let lost = lost.filter(|edit| is_in_source(checker, &display.text, edit, display.body.start));
        self.edits_of(at, part).into_iter().chain(lost).collect()
    }

    /// The values that the displays and the sentences before a display give to letters, the last first.
    fn values_before(&self, at: usize) -> Vec<Given> {
        let checker = self.checker;
        let here = checker.notes.equations[at].span.start;
        let mut found = Vec::new();
        let displays = checker.notes.equations.iter().zip(checker.readings).take(at);
        for (display, reading) in displays.filter(|(display, _)| display.span.end <= here) {
            let statements = reading.statements.iter().flatten();
            found.extend(statements.filter_map(|statement| value_of(statement, display.span.end)));
        }
        // All sentences are read once: a book has thousands of formulas in them.
        let in_sentences = self.in_sentences.get_or_init(|| values_in_sentences(checker));
        found.extend(in_sentences.iter().filter(|given| given.end <= here).cloned());
        found.sort_by_key(|given| std::cmp::Reverse(given.end));
        found
    }

    /// A formula with the values of its letters put in, and these; `None` if one of them has no value.
    fn put_in<'g>(&self, formula: &Expr, given: &'g [Given]) -> Option<(Expr, Vec<&'g Given>)> {
        let (mut formula, mut used) = (formula.clone(), Vec::<&Given>::new());
        for _ in 0..DEEPEST {
            let symbols = formula.symbols();
            if symbols.is_empty() {
                return (!used.is_empty()).then_some((formula, used));
            }
            let mut values: Vec<(SymbolId, Expr)> = Vec::new();
            for (id, dots) in symbols {
                let known = given.iter().find(|given| given.symbol == id);
                let value = match (known, self.checker.model.meaning(id)) {
                    _ if dots > 0 => return None,
                    (Some(known), _) => {
                        if !used.iter().any(|other| other.symbol == id) {
                            used.push(known);
                        }
                        known.value.clone()
                    }
                    (None, Some(Meaning::Defined(inner))) => inner.as_ref().clone(),
                    _ => return None,
                };
                values.push((id, value));
            }
            formula.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, .. } => {
                    values.iter().find(|(known, _)| known == id).map(|(_, value)| value.clone())
                }
                _ => None,
            });
        }
        None
    }

    fn shown(&self, given: &Given) -> String {
        let symbols = &self.checker.model.symbols;
        format!("{} = {}", text::plain(&self.checker.model.name(given.symbol)), shown_quantity(&given.value, symbols))
    }
}

/// Whether an edit is no exchange of a number for one that no author loses: some number explains any result.
fn may_be_lost(edit: &Edit) -> bool {
    const SMALL: [&str; 6] = ["1", "2", "3", "4", "6", "8"];
    let has_digits = edit.replacement.chars().any(|c| c.is_ascii_digit());
    edit.slip != Slip::Number || !has_digits || SMALL.contains(&edit.replacement.trim())
}

/// The values that the formulas in sentences give to letters.
fn values_in_sentences(checker: &Checker<'_>) -> Vec<Given> {
    let mut found = Vec::new();
    for span in &checker.notes.inline {
        let Some(text) = body_of(checker.notes, *span).map(|body| checker.notes.source.slice(body)) else { continue };
        if !text.contains('=') && !text.contains("\\approx") {
            continue;
        }
        let reading = read_display(text, &mut checker.model.symbols.clone(), &checker.model.macros);
        let statements = reading.statements.iter().flatten();
        found.extend(statements.filter_map(|statement| value_of(statement, span.end)));
    }
    found
}

/// The value that a statement gives to the letter on its left side: `v = \sqrt{2aL} = 4.39\,\text{m/s}`.
fn value_of(statement: &Statement, end: usize) -> Option<Given> {
    let symbol = statement.members.first()?.as_plain_symbol()?;
    let value = statement.members.last().filter(|last| last.symbols().is_empty() && !last.is_null())?;
    let equates = |(relation, _): &(Relation, Span)| is_equality(*relation) || *relation == Relation::Approximately;
    let is_one =
        statement.branch.is_none() && statement.conditions.is_empty() && statement.relations.iter().all(equates);
    is_one.then(|| Given { symbol, value: value.clone(), end })
}

/// The first formula of a statement with numbers beside it.
fn example_of(statement: &Statement) -> Option<Example<'_>> {
    if statement.branch.is_some() {
        return None;
    }
    let pairs = statement.members.windows(2).zip(&statement.relations);
    pairs
        .filter(|(pair, _)| {
            let has_letters = pair[0].as_plain_symbol().is_none() && !pair[0].symbols().is_empty();
            has_letters && pair[1].symbols().is_empty() && !pair[1].is_null()
        })
        .find_map(|(pair, (relation, _))| {
            let is_approximate = *relation == Relation::Approximately;
            let formula = &pair[0];
            (is_approximate || is_equality(*relation)).then_some(Example { formula, numbers: &pair[1], is_approximate })
        })
}
