//! What a finding means where no claims file says what the symbols are: whether the display follows, introduces a name,
//! is taken for granted, or is wrong.

mod content;

use std::collections::HashMap;

use crate::code::Code;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::layout::typeset_items;
use crate::latex::layout::values::has_derivative;
use crate::latex::{Macros, Reading, read_display};
use crate::notes::Display;
use crate::source::Span;

use crate::check::kinds::series::has_rest;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::repair::culprit::is_common;
use crate::check::unaided::gate::content::{FEWEST_SYMBOLS, is_content, occurrences, operations};
use crate::check::unaided::prose::{Announced, Words};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;

/// The most symbols that stand on one side only of what one slip separates from an identity.
const MOST_ON_ONE_SIDE: usize = 2;

/// The fewest symbols and operations of a series that is no triviality.
const FEWEST_IN_SERIES: usize = 3;

/// The largest number that authors leave out, or write twice, by a slip.
const LARGEST_LOST_FACTOR: u32 = 4;

/// What the correction of a display rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Basis {
    /// Definitions and the motion.
    Definitions,
    /// One relation that is taken for granted.
    Premise,
    /// Several of them.
    Premises,
    /// One relation that the display solves for a symbol.
    Solution,
}

/// What stands around a display.
pub(super) struct Around<'a> {
    /// The symbols of the document.
    pub model: &'a Model,
    /// The symbols of the displays before it.
    pub before: &'a HashMap<SymbolId, usize>,
    /// The place of the display, or of the chain of which it is a step.
    pub origin: usize,
    /// What the correction rests on.
    pub basis: Basis,
    /// The words before the display.
    pub words: &'a Words,
    /// Whether the display prints a solution of an equation, which is a claim and no definition.
    pub solves: bool,
}

/// Whether a display may be one slip away from what follows.
pub(super) fn may_be_a_slip(reading: &Reading, model: &Model, basis: Basis, words: &Words) -> bool {
    reading.statements.iter().flatten().any(|statement| may_be(statement, model, basis, words))
}

fn may_be(statement: &Statement, model: &Model, basis: Basis, words: &Words) -> bool {
    let members = &statement.members;
    let is_announced = words.announced == Announced::Consequence;
    if let ([first, _], Some(id), false) =
        (members.as_slice(), members.first().and_then(Expr::as_plain_symbol), is_announced)
    {
        // Another formula for a name that has one is a law, a case or a new meaning; for a derived quantity it is a claim.
        let has_formula = model.meaning(id).is_some_and(|meaning| matches!(meaning, Meaning::Defined(_)));
        // So is what its own formula contains by the definitions of others, as where two equations are solved.
        if basis == Basis::Definitions && members[1..].iter().any(|side| names(side, model).contains(&id)) {
            return true;
        }
        // That it is nearly equal to another one is a claim.
        let is_near = statement.relations.iter().all(|(relation, _)| *relation == Relation::Approximately);
        if !is_near
            && !is_derived(first, model)
            && (has_formula || basis == Basis::Definitions && model.meaning(id).is_some())
        {
            return false;
        }
    }
    // In other words, what one relation says is a law of its own more often than a slip, unless the author says otherwise or it
    // relates as many symbols as no law does by chance.
    if basis == Basis::Premise && !is_announced && members.len() < 3 && distinct(members, model) < FEWEST_SYMBOLS {
        return false;
    }
    if basis != Basis::Definitions {
        return true;
    }
    let pairs = members.windows(2).zip(&statement.relations);
    let equates = |relation: Relation| is_equality(relation) || relation == Relation::Approximately;
    pairs.filter(|(_, relation)| equates(relation.0)).any(|(pair, _)| {
        let (left, right) = (leaves(&pair[0], model), leaves(&pair[1], model));
        let alone =
            left.iter().filter(|id| !right.contains(id)).count() + right.iter().filter(|id| !left.contains(id)).count();
        model.system.is_some() || alone <= MOST_ON_ONE_SIDE
    })
}

/// Whether a formula is the name of a quantity that the Lagrangian determines, such as a frequency of small oscillations.
fn is_derived(formula: &Expr, model: &Model) -> bool {
    formula
        .as_plain_symbol()
        .is_some_and(|id| matches!(model.meaning(id), Some(Meaning::System(_))) || is_frequency(id, model))
}

/// Whether a name is that of a frequency or a period of small oscillations.
pub(super) fn is_frequency(id: SymbolId, model: &Model) -> bool {
    let name = &model.symbols.entry(id).name;
    model.frequencies.iter().any(|frequency| frequency.name == *name) || model.modes.contains(name)
}

/// Whether a symbol is a constant that the Lagrangian does not contain and no formula defines.
fn is_foreign(id: SymbolId, model: &Model) -> bool {
    let moves = model.coordinates.iter().any(|coordinate| coordinate.symbol == id);
    let has_meaning = matches!(model.meaning(id), Some(Meaning::Defined(_) | Meaning::System(_)));
    let printed = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let contains = printed.is_some_and(|(lagrangian, _)| {
        let node = Node::Symbol { id: lagrangian, indices: Vec::new(), dots: 0 };
        model.depends_on(&Expr::new(node, Span::default()), &[id])
    });
    !moves && !has_meaning && !contains
}

/// The symbols of a formula that no formula defines.
pub(super) fn leaves(formula: &Expr, model: &Model) -> Vec<SymbolId> {
    let mut found = names(formula, model);
    found.retain(|id| !matches!(model.meaning(*id), Some(Meaning::Defined(_))));
    found.dedup();
    found
}

/// The symbols of a formula, and those of the formulas that define them.
pub(super) fn names(formula: &Expr, model: &Model) -> Vec<SymbolId> {
    let (mut found, mut at) = (formula.symbols().into_iter().map(|(id, _)| id).collect::<Vec<_>>(), 0);
    while let Some(next) = found.get(at).copied() {
        at += 1;
        if let Some(Meaning::Defined(inner)) = model.meaning(next) {
            for (id, _) in inner.symbols() {
                if !found.contains(&id) {
                    found.push(id);
                }
            }
        }
    }
    found
}

/// The number of different symbols that members relate, without those that formulas define.
fn distinct(members: &[Expr], model: &Model) -> usize {
    let mut all: Vec<SymbolId> = members.iter().flat_map(|member| leaves(member, model)).collect();
    all.sort_unstable_by_key(|id| id.0);
    all.dedup();
    all.len()
}

/// The symbols in a text, each as often as it stands there.
pub(super) fn symbols_of(text: &str, model: &Model) -> Vec<SymbolId> {
    let reading = read_display(text, &mut model.symbols.clone(), &model.macros);
    let mut found = Vec::new();
    for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
        member.walk(&mut |part| {
            if let Node::Symbol { id, .. } = &part.node {
                found.push(*id);
            }
        });
    }
    found
}

/// The equation as it counts in notes without a claims file, where no likely slip was found in it.
pub(super) fn as_it_counts(mut equation: Equation) -> Equation {
    equation.repairs.clear();
    equation.elsewhere.clear();
    equation.finding = finding_as_it_counts(equation.finding);
    for part in &mut equation.parts {
        part.finding = finding_as_it_counts(part.finding.clone());
        part.ok = part.finding.verdict != Verdict::Refuted;
    }
    equation.ok = true;
    equation
}

/// The equation with the finding that numbers in it are wrong, in all of it or in one of its parts, if they are.
pub(super) fn wrong_numbers(equation: &Equation) -> Option<Equation> {
    let is_wrong = |finding: &&Finding| finding.code == Code::NumbersDiffer && finding.verdict == Verdict::Refuted;
    if is_wrong(&&equation.finding) {
        return Some(equation.clone());
    }
    let finding = equation.parts.iter().map(|part| &part.finding).find(is_wrong)?.clone();
    let mut found = as_it_counts(equation.clone());
    for (part, printed) in found.parts.iter_mut().zip(&equation.parts).filter(|(_, part)| is_wrong(&&part.finding)) {
        *part = printed.clone();
    }
    Some(Equation { finding, ok: false, ..found })
}

/// The equation, if it passes. What defines names beside an equality that passes takes nothing from it:
/// `\ddot x + 2\gamma\dot x = 0, \quad \gamma = b/2m`.
pub(super) fn as_following(equation: Equation) -> Option<Equation> {
    if equation.finding.verdict.passes() {
        return Some(equation);
    }
    let defines = |finding: &Finding| finding.leaves_a_definition_open();
    let mut findings = equation.parts.iter().map(|part| &part.finding);
    let passing =
        findings.clone().find(|finding| finding.verdict.passes() && finding.verdict != Verdict::Definition)?;
    let finding = passing.clone();
    findings.all(|finding| finding.verdict.passes() || defines(finding)).then_some(Equation { finding, ..equation })
}

/// The equation as it counts where it gives a new name a formula.
pub(super) fn introduces(equation: Equation, name: &str) -> Equation {
    let finding =
        Finding::new(Code::Introduced, Verdict::Definition, equation.finding.span, format!("introduces {name}"));
    Equation { finding, parts: Vec::new(), repairs: Vec::new(), elsewhere: Vec::new(), ok: true, ..equation }
}

/// Whether a derivative in a display was read as 0, since nothing says what the formula of the derived quantity is.
pub(super) fn lost_derivative(reading: &Reading, display: &Display, macros: &Macros) -> bool {
    let is_printed = |part: &Expr| {
        let text = display.text.get(part.span.start..part.span.end).unwrap_or_default();
        // The parts of an integral that has a value are all read from the whole of it, its zeros too.
        let is_integral = text.contains("\\int");
        text.contains(|c: char| c.is_ascii_alphabetic())
            && (!is_integral || typeset_items(text, macros).is_ok_and(|items| has_derivative(&items)))
    };
    let mut is_lost = false;
    for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
        member.walk(&mut |part| is_lost |= part.is_null() && is_printed(part));
    }
    is_lost
}

/// The equation as it counts where a derivative is one of an unknown formula.
pub(super) fn left_open(equation: Equation) -> Equation {
    let message = "no display before gives the formula that is differentiated here, so this was not decided";
    let finding = Finding::new(Code::NotDecided, Verdict::Undecided, equation.finding.span, message);
    Equation { finding, parts: Vec::new(), repairs: Vec::new(), elsewhere: Vec::new(), ok: true, ..equation }
}

fn taken_for_granted(span: Span) -> Finding {
    let message = "this does not follow from the other displays; it is taken for granted, and was not checked";
    Finding::new(Code::Assumed, Verdict::Assumed, span, message)
}

fn finding_as_it_counts(finding: Finding) -> Finding {
    let is_untested = finding.leaves_a_definition_open();
    match finding.verdict {
        Verdict::Refuted => taken_for_granted(finding.span),
        Verdict::Undecided if finding.code == Code::NoMotion => taken_for_granted(finding.span),
        // The condition is said; nobody declared ranges that contradict it.
        Verdict::Domain if finding.code == Code::OneBranch => Finding { verdict: Verdict::Verified, ..finding },
        // The ranges of the symbols were guessed, so where both sides are defined they must agree, and no more.
        Verdict::Domain => {
            let message = "the two sides agree wherever both are defined";
            Finding::new(Code::Holds, Verdict::Verified, finding.span, message)
        }
        Verdict::Undecided if is_untested => {
            let message = match finding.message.split_once([';', ',']) {
                Some((what, _)) => what.to_owned(),
                None => finding.message.clone(),
            };
            Finding::new(Code::Introduced, Verdict::Definition, finding.span, message)
        }
        Verdict::Unreadable if finding.code == Code::NeedsLimitOrSmall => {
            let message = "≈ does not say when the two sides are nearly equal, so this was not decided";
            Finding::new(finding.code, Verdict::Undecided, finding.span, message)
        }
        _ => finding,
    }
}

/// Whether a correction makes it likely that a slip was made: it is certified, in this display, and no triviality.
pub(super) fn is_likely(repair: &Repair, display: &Display, around: &Around<'_>) -> bool {
    let Around { model, before, origin, basis, words, solves } = *around;
    // What a chain introduces says nothing about its later steps.
    let is_seen = |id: &SymbolId| before.get(id).is_some_and(|first| *first < origin);
    let holds = matches!(repair.verdict, Verdict::Certified | Verdict::Verified);
    if !holds || repair.idle || repair.shared.is_some() || !display.body.contains(repair.span) {
        return false;
    }
    let mut corrected = display.text.clone();
    let start = repair.span.start - display.body.start;
    let end = repair.span.end - display.body.start;
    if corrected.get(start..end).is_none() {
        return false;
    }
    let left_out = &corrected[start..end];
    // A factor of 0 takes a term away.
    if repair.replacement.trim().trim_end_matches("\\,").trim() == "0" {
        return false;
    }
    // Authors lose terms; they do not add terms that do not belong.
    if repair.replacement.trim().is_empty() && left_out.contains(|c: char| c.is_ascii_alphabetic()) {
        return false;
    }
    // Nor do they write a number that is not there, but for the small ones of ½, 2π and 4π.
    let number = left_out.trim().trim_end_matches("\\,").trim().parse::<u32>();
    if repair.replacement.trim().is_empty() && number.is_ok_and(|number| number > LARGEST_LOST_FACTOR) {
        return false;
    }
    // sin θ that comes in the place of θ: the display is linearised, and means small angles.
    let linear = ["\\sin", "\\tan", "\\sinh", "\\tanh"]
        .iter()
        .fold(repair.replacement.clone(), |text, name| text.replace(name, ""));
    let letters = |text: &str| text.chars().filter(|c| c.is_alphanumeric() || *c == '\\').collect::<String>();
    if linear != repair.replacement && letters(&linear) == letters(left_out) {
        return false;
    }
    // Authors write one voltage as v_C and as V_C.
    if left_out.contains('_') && left_out.eq_ignore_ascii_case(&repair.replacement) {
        return false;
    }
    // A quotient, a power or a sum of several quantities that is put in is a relation that the notes do not print, and no lost
    // factor. And a sign between two factors makes terms of them.
    let has_structure = repair.replacement.contains("\\frac") || repair.replacement.contains(['/', '(', '^']);
    let is_relation = has_structure && symbols_of(&repair.replacement, model).len() > 1;
    if left_out.trim().is_empty() && (is_relation || parts_factors(&corrected[..start], &repair.replacement)) {
        return false;
    }
    // What solves another equation becomes a solution of this one where a parenthesis unites its terms. So does what follows
    // from other premises.
    let parentheses = |text: &str| text.matches('(').count();
    if (solves || basis != Basis::Definitions) && parentheses(&repair.replacement) > parentheses(left_out) {
        return false;
    }
    let is_put_in = left_out.trim().is_empty();
    corrected.replace_range(start..end, &repair.replacement);
    let mut symbols = model.symbols.clone();
    let reading = read_display(&corrected, &mut symbols, &model.macros);
    let statements: Vec<&Statement> = reading.statements.iter().flatten().collect();
    if statements.len() < reading.statements.len() {
        return false;
    }
    let (before, after) = (symbols_of(&display.text, model), symbols_of(&corrected, model));
    // In other words, what one relation says is a law of its own more often than a slip, unless the author says otherwise, or a
    // common slip lies between many symbols.
    let is_chain = statements.iter().any(|statement| statement.members.len() > 2);
    let has_same = before.iter().all(|id| after.contains(id)) && after.iter().all(|id| before.contains(id));
    let is_close = has_same
        && is_common(repair.slip)
        && statements.iter().any(|statement| distinct(&statement.members, model) >= FEWEST_SYMBOLS);
    if basis == Basis::Premise && words.announced != Announced::Consequence && !is_chain && !is_close {
        return false;
    }
    // A correction loses no more than one symbol: what has more of them was meant.
    if after.len() + 1 < before.len() {
        return false;
    }
    // What has a value of 0, or comes to have several new symbols, was meant as another statement.
    let is_zero = statements.iter().any(|statement| statement.members.iter().any(Expr::is_null));
    let mut new: Vec<&SymbolId> = after.iter().filter(|id| !before.contains(id)).collect();
    new.dedup();
    if after.len() > before.len() && !new.is_empty() && (is_zero || new.len() > 1) {
        return false;
    }
    // What lacks a function of a symbol holds at a special value of it: at the start, at the top.
    let is_function = ["\\sin", "\\cos", "\\tan", "e^", "\\exp"].iter().any(|name| repair.replacement.contains(name));
    if is_put_in && !new.is_empty() && is_function {
        return false;
    }
    // A name that no display before has is new, and no slip for another one. Neither is a free constant that the motion
    // does not contain: the display says what it is.
    let is_new = |id: &SymbolId| !is_seen(id) || model.system.is_some() && is_foreign(*id, model);
    if before.iter().any(|id| !after.contains(id) && is_new(id)) {
        return false;
    }
    // An equation of which one side is 0 is solved for a symbol that nothing determines: it is no slip for another one.
    // With a name that has a formula in its place it says what this formula does: E r² + α r = … is none for U r² + α r = ….
    let is_named = new.iter().any(|id| matches!(model.meaning(**id), Some(Meaning::Defined(_) | Meaning::System(_))));
    let is_open = |id: &&SymbolId| is_named || !matches!(model.meaning(**id), Some(Meaning::Defined(_)));
    if is_zero && before.iter().filter(is_open).any(|id| count(&after, *id) < count(&before, *id)) && !new.is_empty() {
        return false;
    }
    // A term with a defined name that the display does not have makes it say what the definition says. And a name that no
    // display before has is not what the author meant.
    let is_brought_in = |id: &&SymbolId| {
        !is_seen(id) || after.len() > before.len() && matches!(model.meaning(**id), Some(Meaning::Defined(_)))
    };
    if new.iter().any(is_brought_in) {
        return false;
    }
    // Of a motion, what lacks a term is a special case as often as a slip: a circular orbit, a length of 1.
    let moves = |id: &SymbolId| model.coordinates.iter().any(|coordinate| coordinate.symbol == *id);
    if model.system.is_some() && before.iter().any(moves) && after.len() > before.len() {
        return false;
    }
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
        && before.len() >= FEWEST_SYMBOLS;
    let is_claim = |pair: &&[Expr]| solves || concludes || is_bound(&pair[0], &pair[1]) && is_bound(&pair[1], &pair[0]);
    let edited = Span::new(start, start + repair.replacement.len());
    let is_edited = |pair: &&[Expr]| pair[0].span.to(pair[1].span).contains(edited);
    let pairs = statements.iter().flat_map(|statement| statement.members.windows(2));
    let mut claims = pairs.filter(is_edited).filter(is_claim).peekable();
    // A derivative that is written out says more than its value, which is what was read.
    let is_differentiated = |pair: &[Expr]| {
        display.text.contains("\\partial")
            && pair.iter().map(|side| occurrences(side, model)).sum::<usize>() >= FEWEST_SYMBOLS
    };
    // So does an integral.
    let is_integrated = |pair: &[Expr]| {
        let prints =
            |side: &Expr| corrected.get(side.span.start..side.span.end).is_some_and(|text| text.contains("\\int"));
        pair.iter().any(prints)
    };
    // And a series, of which the sides have other forms.
    let is_expanded = |pair: &[Expr]| {
        pair.iter().any(has_rest) && pair.iter().map(|side| operations(side, model)).sum::<usize>() >= FEWEST_IN_SERIES
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
            && is_common(repair.slip)
            && pair.iter().map(|side| occurrences(side, model)).sum::<usize>() >= FEWEST_SYMBOLS - 1
    };
    let says_something =
        |pair: &[Expr]| is_content(&pair[0], &pair[1], &symbols, model) || is_printed(pair) || is_concluded(pair);
    // That a formula is constant is a claim about it, and the correction has its symbols.
    let is_constant = |statement: &&Statement| {
        matches!(statement.members.as_slice(), [only] if statement.constant.is_some()
            && occurrences(only, model) >= FEWEST_SYMBOLS - 1
            && only.span.contains(edited))
    };
    if basis != Basis::Definitions && has_same && statements.iter().any(is_constant) {
        return true;
    }
    claims.peek().is_some() && claims.all(says_something)
}

/// Whether a sign is put in after a factor, so that what is before it and what is after it become terms.
fn parts_factors(before: &str, replacement: &str) -> bool {
    let ends_a_factor = before.trim_end().ends_with(|c: char| c.is_alphanumeric() || matches!(c, '}' | ')' | ']'));
    matches!(replacement.trim(), "+" | "-") && ends_a_factor
}

/// Whether a formula is a written-out matrix of at least two rows and columns.
pub(super) fn is_matrix(formula: &Expr) -> bool {
    matches!(&formula.node, Node::Matrix(rows) if rows.len() > 1 && rows.iter().all(|row| row.len() > 1))
}

/// How often a symbol is among some.
fn count(symbols: &[SymbolId], id: SymbolId) -> usize {
    symbols.iter().filter(|other| **other == id).count()
}
