//! Whether a correction of a display makes it likely that its author made a slip.

use crate::formula::{Expr, Node, Relation, Statement, SymbolId, Symbols};
use crate::latex::layout::prints_derivative;
use crate::latex::{Reading, read_display};
use crate::notes::Display;
use crate::source::Span;

use super::content::{FEWEST_SYMBOLS, is_content, occurrences, operations};
use super::{Around, Basis, distinct, is_derived, is_foreign, leaves, symbols_of};
use crate::check::kinds::series::has_rest;
use crate::check::model::meaning::Meaning;
use crate::check::repair::culprit::{cancels, is_common};
use crate::check::unaided::prose::Announced;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;

/// The fewest symbols and operations of a series that is no triviality.
const FEWEST_IN_SERIES: usize = 3;

/// The largest number that authors leave out, or write twice, by a slip.
const LARGEST_LOST_FACTOR: u32 = 4;

/// Whether a correction makes it likely that a slip was made: it is certified, in this display, and no triviality.
pub(in crate::check::unaided) fn is_likely(repair: &Repair, display: &Display, around: &Around<'_>) -> bool {
    let holds = matches!(repair.verdict, Verdict::Certified | Verdict::Verified);
    if !holds || repair.idle || repair.shared.is_some() || !display.body.contains(repair.span) {
        return false;
    }
    let place = Span::new(repair.span.start - display.body.start, repair.span.end - display.body.start);
    let Some(left_out) = display.text.get(place.range()) else { return false };
    if is_no_slip_in_text(repair, &display.text[..place.start], left_out, around) {
        return false;
    }
    let mut corrected = display.text.clone();
    corrected.replace_range(place.range(), &repair.replacement);
    let mut symbols = around.model.symbols.clone();
    let reading = read_display(&corrected, &mut symbols, &around.model.macros);
    if reading.statements.iter().any(Result::is_err) {
        return false;
    }
    // A factor above and below one bar is nothing that anybody writes.
    let has_cancelling = |reading: &Reading, symbols: &Symbols| {
        let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        members.into_iter().any(|member| cancels(member, symbols))
    };
    if has_cancelling(&reading, &symbols) {
        let mut known = around.model.symbols.clone();
        let printed = read_display(&display.text, &mut known, &around.model.macros);
        if !has_cancelling(&printed, &known) {
            return false;
        }
    }
    let edited = Span::new(place.start, place.start + repair.replacement.len());
    let correction = Correction {
        repair,
        around,
        printed: &display.text,
        before: symbols_of(&display.text, around.model),
        after: symbols_of(&corrected, around.model),
        corrected,
        reading,
        edited,
        is_put_in: left_out.trim().is_empty(),
    };
    !correction.means_something_else() && correction.says_something(&symbols)
}

/// Whether the text alone shows that an edit corrects no slip of an author. `before` is the text before the edit.
fn is_no_slip_in_text(repair: &Repair, before: &str, left_out: &str, around: &Around<'_>) -> bool {
    // A factor of 0 takes a term away.
    if repair.replacement.trim().trim_end_matches("\\,").trim() == "0" {
        return true;
    }
    // Authors lose terms; they do not add terms that do not belong.
    let without_bars =
        ["\\frac", "\\tfrac", "\\dfrac"].iter().fold(left_out.to_owned(), |text, bar| text.replace(bar, ""));
    if repair.replacement.trim().is_empty() && without_bars.contains(|c: char| c.is_ascii_alphabetic()) {
        return true;
    }
    // Nor do they write a number that is not there, but for the small ones of ½, 2π and 4π.
    let number = left_out.trim().trim_end_matches("\\,").trim().parse::<u32>();
    if repair.replacement.trim().is_empty() && number.is_ok_and(|number| number > LARGEST_LOST_FACTOR) {
        return true;
    }
    // sin θ that comes in the place of θ: the display is linearised, and means small angles.
    let linear = ["\\sin", "\\tan", "\\sinh", "\\tanh"]
        .iter()
        .fold(repair.replacement.clone(), |text, name| text.replace(name, ""));
    let letters = |text: &str| text.chars().filter(|c| c.is_alphanumeric() || *c == '\\').collect::<String>();
    if linear != repair.replacement && letters(&linear) == letters(left_out) {
        return true;
    }
    // Authors write one voltage as v_C and as V_C.
    if left_out.contains('_') && left_out.eq_ignore_ascii_case(&repair.replacement) {
        return true;
    }
    // A quotient, a power or a sum of several quantities that is put in is a relation that the notes do not print, and no lost
    // factor. And a sign between two factors makes terms of them.
    let has_structure = repair.replacement.contains("\\frac") || repair.replacement.contains(['/', '(', '^']);
    let is_relation = has_structure && symbols_of(&repair.replacement, around.model).len() > 1;
    if left_out.trim().is_empty() && (is_relation || parts_factors(before, &repair.replacement)) {
        return true;
    }
    // What solves another equation becomes a solution of this one where a parenthesis unites its terms. So does what follows
    // from other premises.
    let parentheses = |text: &str| text.matches('(').count();
    if (around.solves || around.basis != Basis::Definitions) && parentheses(&repair.replacement) > parentheses(left_out)
    {
        return true;
    }
    false
}

/// A display with an edit that makes it hold.
struct Correction<'c> {
    repair: &'c Repair,
    around: &'c Around<'c>,
    /// The display as printed.
    printed: &'c str,
    corrected: String,
    reading: Reading,
    /// The bytes of the correction that are new.
    edited: Span,
    /// Whether nothing is taken away.
    is_put_in: bool,
    /// The symbols of the display as printed, and corrected.
    before: Vec<SymbolId>,
    after: Vec<SymbolId>,
}

impl Correction<'_> {
    fn statements(&self) -> impl Iterator<Item = &Statement> {
        self.reading.statements.iter().flatten()
    }

    /// Whether printed and corrected contain the same symbols.
    fn has_same(&self) -> bool {
        let (before, after) = (&self.before, &self.after);
        before.iter().all(|id| after.contains(id)) && after.iter().all(|id| before.contains(id))
    }

    /// Whether the symbols show that the author meant the printed statement, and not the corrected one.
    fn means_something_else(&self) -> bool {
        let Around { model, basis, words, .. } = *self.around;
        let (before, after) = (&self.before, &self.after);
        // What a chain introduces says nothing about its later steps.
        let is_seen = |id: &SymbolId| self.around.before.get(id).is_some_and(|first| *first < self.around.origin);
        // In other words, what one relation says is a law of its own more often than a slip, unless the author says otherwise, or a
        // common slip lies between many symbols.
        let is_chain = self.statements().any(|statement| statement.members.len() > 2);
        let is_close = self.has_same()
            && is_common(self.repair.slip)
            && self.statements().any(|statement| distinct(&statement.members, model) >= FEWEST_SYMBOLS);
        if basis == Basis::Premise && words.announced != Announced::Consequence && !is_chain && !is_close {
            return true;
        }
        // What gives each of several names a formula gives none to one of them twice.
        if gives_a_name_twice(&self.reading) {
            let printed = read_display(self.printed, &mut model.symbols.clone(), &model.macros);
            if !gives_a_name_twice(&printed) {
                return true;
            }
        }
        // A correction loses no more than one symbol: what has more of them was meant.
        if after.len() + 1 < before.len() {
            return true;
        }
        // What has a value of 0, or comes to have several new symbols, was meant as another statement.
        let is_zero = self.statements().any(|statement| statement.members.iter().any(Expr::is_null));
        let mut new: Vec<&SymbolId> = after.iter().filter(|id| !before.contains(id)).collect();
        new.dedup();
        if after.len() > before.len() && !new.is_empty() && (is_zero || new.len() > 1) {
            return true;
        }
        // What lacks a function of a symbol holds at a special value of it: at the start, at the top.
        let is_function =
            ["\\sin", "\\cos", "\\tan", "e^", "\\exp"].iter().any(|name| self.repair.replacement.contains(name));
        if self.is_put_in && !new.is_empty() && is_function {
            return true;
        }
        // A name that no display before has is new, and no slip for another one. Neither is a free constant that the motion
        // does not contain: the display says what it is.
        let is_new = |id: &SymbolId| !is_seen(id) || model.system.is_some() && is_foreign(*id, model);
        if before.iter().any(|id| !after.contains(id) && is_new(id)) {
            return true;
        }
        // An equation of which one side is 0 is solved for a symbol that nothing determines: it is no slip for another one.
        // With a name that has a formula in its place it says what this formula does: E r² + α r = … is none for U r² + α r = ….
        let is_named =
            new.iter().any(|id| matches!(model.meaning(**id), Some(Meaning::Defined(_) | Meaning::System(_))));
        let is_open = |id: &&SymbolId| is_named || !matches!(model.meaning(**id), Some(Meaning::Defined(_)));
        if is_zero && before.iter().filter(is_open).any(|id| count(after, *id) < count(before, *id)) && !new.is_empty()
        {
            return true;
        }
        // A term with a defined name that the display does not have makes it say what the definition says. And a name that no
        // display before has is not what the author meant.
        let is_brought_in = |id: &&SymbolId| {
            !is_seen(id) || after.len() > before.len() && matches!(model.meaning(**id), Some(Meaning::Defined(_)))
        };
        if new.iter().any(is_brought_in) {
            return true;
        }
        // Of a motion, what lacks a term is a special case as often as a slip: a circular orbit, a length of 1.
        let moves = |id: &SymbolId| model.coordinates.iter().any(|coordinate| coordinate.symbol == *id);
        if model.system.is_some() && before.iter().any(moves) && after.len() > before.len() {
            return true;
        }
        false
    }

    /// Whether the corrected statement says more than a definition or a triviality.
    fn says_something(&self, symbols: &Symbols) -> bool {
        let Around { model, basis, words, solves, .. } = *self.around;
        let (has_same, edited) = (self.has_same(), self.edited);
        // A name beside its formula is a definition, and says nothing of its own, unless the formula contains the name.
        let is_bound = |side: &Expr, other: &Expr| {
            let others = leaves(other, model);
            side.as_plain_symbol().is_none()
                || is_derived(side, model)
                || leaves(side, model).iter().all(|id| others.contains(id))
        };
        // Under premises a formula for a known name is a conclusion. A special case has fewer symbols than what it is a case of.
        let concludes = words.connected
            && matches!(basis, Basis::Premise | Basis::Premises)
            && has_same
            && self.before.len() >= FEWEST_SYMBOLS;
        let is_claim =
            |pair: &&[Expr]| solves || concludes || is_bound(&pair[0], &pair[1]) && is_bound(&pair[1], &pair[0]);
        let is_edited = |pair: &&[Expr]| pair[0].span.to(pair[1].span).contains(edited);
        let pairs = self.statements().flat_map(|statement| statement.members.windows(2));
        let mut claims = pairs.filter(is_edited).filter(is_claim).peekable();
        // A derivative that is written out says more than its value, which is what was read.
        let has_derivative = prints_derivative(self.printed, &model.macros);
        let is_differentiated = |pair: &[Expr]| {
            has_derivative && pair.iter().map(|side| occurrences(side, model)).sum::<usize>() >= FEWEST_SYMBOLS
        };
        // So does an integral.
        let is_integrated = |pair: &[Expr]| {
            let prints = |side: &Expr| {
                self.corrected.get(side.span.start..side.span.end).is_some_and(|text| text.contains("\\int"))
            };
            pair.iter().any(prints)
        };
        // And a series, of which the sides have other forms. What is nearly equal is one without its rest.
        let is_near = self
            .statements()
            .all(|statement| statement.relations.iter().all(|(relation, _)| *relation == Relation::Approximately));
        let is_expanded = |pair: &[Expr]| {
            (is_near || pair.iter().any(has_rest))
                && pair.iter().map(|side| operations(side, model)).sum::<usize>() >= FEWEST_IN_SERIES
        };
        // And a matrix of numbers that a formula of known matrices has.
        let is_computed = |pair: &[Expr]| pair.iter().any(is_matrix) && pair.iter().any(|side| !is_matrix(side));
        let is_printed =
            |pair: &[Expr]| is_differentiated(pair) || is_integrated(pair) || is_expanded(pair) || is_computed(pair);
        // What several relations are said to give says something in fewer symbols too.
        let is_concluded = |pair: &[Expr]| {
            concludes
                && basis == Basis::Premises
                && words.announced == Announced::Consequence
                && is_common(self.repair.slip)
                && pair.iter().map(|side| occurrences(side, model)).sum::<usize>() >= FEWEST_SYMBOLS - 1
        };
        let says_something =
            |pair: &[Expr]| is_content(&pair[0], &pair[1], symbols, model) || is_printed(pair) || is_concluded(pair);
        // That a formula is constant is a claim about it, and the correction has its symbols.
        let is_constant = |statement: &&Statement| {
            matches!(statement.members.as_slice(), [only] if statement.constant.is_some()
                && occurrences(only, model) >= FEWEST_SYMBOLS - 1
                && only.span.contains(edited))
        };
        if basis != Basis::Definitions && has_same && self.statements().any(|statement| is_constant(&statement)) {
            return true;
        }
        claims.peek().is_some() && claims.all(says_something)
    }
}

/// Whether two statements of a display give one name a formula.
fn gives_a_name_twice(reading: &Reading) -> bool {
    let statements = reading.statements.iter().flatten();
    let names: Vec<SymbolId> =
        statements.filter_map(|statement| statement.members.first().and_then(Expr::as_plain_symbol)).collect();
    names.iter().enumerate().any(|(at, name)| names[..at].contains(name))
}

/// Whether a sign is put in after a factor, so that what is before it and what is after it become terms.
fn parts_factors(before: &str, replacement: &str) -> bool {
    let ends_a_factor = before.trim_end().ends_with(|c: char| c.is_alphanumeric() || matches!(c, '}' | ')' | ']'));
    matches!(replacement.trim(), "+" | "-") && ends_a_factor
}

/// Whether a formula is a written-out matrix of at least two rows and columns.
pub(in crate::check::unaided) fn is_matrix(formula: &Expr) -> bool {
    matches!(&formula.node, Node::Matrix(rows) if rows.len() > 1 && rows.iter().all(|row| row.len() > 1))
}

/// How often a symbol is among some.
fn count(symbols: &[SymbolId], id: SymbolId) -> usize {
    symbols.iter().filter(|other| **other == id).count()
}
