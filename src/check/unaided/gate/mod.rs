//! What a finding means where no claims file says what the symbols are: whether the display follows, introduces a name,
//! is taken for granted, or is wrong.
//!
//! Offers `as_it_counts`, the finding on a display as it counts without a claims file, and what decides whether an edit is a likely
//! slip. Knows `repair`, `kinds` and below.

mod content;
mod likely;

use std::collections::HashMap;

use crate::code::Code;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::layout::prints_derivative;
use crate::latex::{Macros, Reading, read_display};
use crate::notes::Display;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::gate::content::FEWEST_SYMBOLS;
use crate::check::unaided::prose::{Announced, Words};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Equation;

pub(super) use likely::{is_likely, is_matrix};

/// The most symbols that stand on one side only of what one slip separates from an identity.
const MOST_ON_ONE_SIDE: usize = 2;

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
        model.system.is_some() || is_announced || alone <= MOST_ON_ONE_SIDE
    })
}

/// Whether a formula is the name of a quantity that the Lagrangian determines, such as a frequency of small oscillations, or a derivative
/// of what has a formula, `\partial L/\partial x`.
fn is_derived(formula: &Expr, model: &Model) -> bool {
    formula.as_plain_symbol().is_some_and(|id| {
        is_derivative(id, model) || matches!(model.meaning(id), Some(Meaning::System(_))) || is_frequency(id, model)
    })
}

/// Whether a name is a derivative of what the notes have a formula for, where a Lagrangian is known: `\partial L/\partial x`.
pub(super) fn is_derivative(id: SymbolId, model: &Model) -> bool {
    let is_known = id.0 < model.symbols.len();
    model.system.is_some() && is_known && model.symbols.entry(id).name.base.starts_with("\\frac{\\partial")
}

/// Whether a name is that of a frequency or a period of small oscillations.
pub(super) fn is_frequency(id: SymbolId, model: &Model) -> bool {
    let name = &model.symbols.entry(id).name;
    model.frequencies.iter().any(|frequency| frequency.name == *name) || model.modes.contains(name)
}

/// Whether a symbol is a constant that the Lagrangian does not contain and no formula defines.
pub(super) fn is_foreign(id: SymbolId, model: &Model) -> bool {
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

/// A display, and those before it that give a formula to a name which it uses, through other names too.
pub(super) fn with_definitions(checker: &Checker<'_>, at: usize) -> Vec<usize> {
    let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
    let used: Vec<SymbolId> = members.flat_map(|member| names(member, checker.model)).collect();
    let gives_one = |place: &usize| checker.readings[*place].introduced.iter().any(|new| used.contains(&new.symbol));
    (0..at).filter(gives_one).chain([at]).collect()
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
    let finding = Finding::new(Code::Introduced, Verdict::Definition, equation.finding.span, format!("defines {name}"));
    Equation { finding, parts: Vec::new(), repairs: Vec::new(), elsewhere: Vec::new(), ok: true, ..equation }
}

/// The signs of what a display computes, each with its word.
const COMPUTED: [(&str, &str); 5] =
    [("\\int", "integral"), ("\\oint", "integral"), ("\\sum", "sum"), ("\\prod", "product"), ("\\lim", "limit")];

/// The equation as it counts where what it defines is no name but an integral, a sum or a limit that stands for one: such a side has a
/// value, so the equation defines nothing. `None` for any other.
pub(super) fn not_computed(equation: &Equation, reading: &Reading, model: &Model) -> Option<Equation> {
    if equation.finding.verdict != Verdict::Definition {
        return None;
    }
    let [Ok(statement)] = reading.statements.as_slice() else { return None };
    let id = statement.members.first()?.as_plain_symbol()?;
    let name = &model.symbols.entry(id).name.base;
    let (_, word) = COMPUTED.iter().find(|(sign, _)| name.starts_with(sign))?;
    let message = format!("onshell cannot compute this {word}, so the equation is taken for granted");
    Some(settled(equation, (Verdict::Assumed, Code::Assumed), message))
}

/// Whether a derivative in a display was read as 0, since nothing says what the formula of the derived quantity is.
pub(super) fn lost_derivative(reading: &Reading, display: &Display, macros: &Macros) -> bool {
    let is_printed = |part: &Expr| {
        let text = display.text.get(part.span.start..part.span.end).unwrap_or_default();
        // The parts of an integral that has a value are all read from the whole of it, its zeros too.
        let is_integral = text.contains("\\int");
        text.contains(|c: char| c.is_ascii_alphabetic()) && (!is_integral || prints_derivative(text, macros))
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
    let message = "onshell found no derivation of this from the other displays, so it is taken for granted";
    Finding::new(Code::Assumed, Verdict::Assumed, span, message)
}

fn finding_as_it_counts(finding: Finding) -> Finding {
    let is_untested = finding.leaves_a_definition_open();
    match finding.verdict {
        Verdict::Refuted => taken_for_granted(finding.span),
        Verdict::Undecided if finding.code == Code::NoMotion => taken_for_granted(finding.span),
        // The condition is said; nobody declared ranges that contradict it.
        // A state outside of the condition is no counterexample to what holds under it.
        Verdict::Domain if finding.code == Code::OneBranch => {
            Finding { verdict: Verdict::Verified, counterexample: None, ..finding }
        }
        // The ranges of the symbols were guessed, so where both sides are defined they must agree, and no more.
        Verdict::Domain => {
            let message = "the two sides agree wherever both are defined";
            Finding::new(Code::Holds, Verdict::Verified, finding.span, message)
        }
        Verdict::Undecided if is_untested => {
            let message = finding.defines.map_or(finding.message, |name| format!("defines {name}"));
            Finding::new(Code::Introduced, Verdict::Definition, finding.span, message)
        }
        Verdict::Unreadable if finding.code == Code::NeedsLimitOrSmall => {
            let message = "≈ does not say when the two sides are nearly equal, so this was not decided";
            Finding::new(finding.code, Verdict::Undecided, finding.span, message)
        }
        _ => finding,
    }
}

/// An equation with a finding of its own in the place of those of its parts.
pub(super) fn settled(found: &Equation, (verdict, code): (Verdict, Code), message: String) -> Equation {
    Equation {
        finding: Finding::new(code, verdict, found.finding.span, message),
        parts: Vec::new(),
        repairs: Vec::new(),
        ok: verdict != Verdict::Refuted,
        ..found.clone()
    }
}
