//! Displays that differentiate or integrate a name whose formula is printed, though it defines nothing: `p = \frac{RT}{V-b}` where
//! the equation of state stands before it, `\phi \approx \dots`, or the solution of an equation of motion.
//!
//! Such a name is read as a number, so its derivative is a quantity of its own and the display is taken for granted. The notes
//! are read once more with the formula as a definition, and these displays are judged by the definitions alone. All others keep their
//! findings: where the name stands without a derivative, its relations say all.
//!
//! Offers `sought`, the formulas and the displays that need them, and `Formulas::merged`. Knows `guess`, `calculus` and `gate`.

mod changes;

use crate::check::document::checker::Checker;
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::gate;
use crate::check::unaided::guess::declarations::Formula;
use crate::check::unaided::inline;
use crate::check::unaided::printed_formulas::changes::Change;
use crate::check::unaided::scope::Scope;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::formula::{Expr, Kind, Node, Relation, Statement, SymbolId, text};
use crate::latex::names;
use crate::notes::Notes;

/// The formulas of names, and the displays that need them.
pub(super) struct Formulas {
    /// The formulas, one for each name.
    pub given: Vec<Formula>,
    /// The places of the displays among the findings, each with the places of its formulas among those given.
    targets: Vec<(usize, Vec<usize>)>,
    /// The places of the displays that print the formulas.
    printed_at: Vec<usize>,
    /// The places of displays that print a rate or a derivative of a formula which stands beside them.
    pub evaluated: Vec<usize>,
}

/// A display that gives a name a formula without defining it.
struct Candidate {
    /// The place of the display.
    at: usize,
    symbol: SymbolId,
    /// The names in the formula, and in the formulas of these.
    names: Vec<SymbolId>,
    latex: String,
}

/// The formulas that displays need which do not follow otherwise. Beside a Lagrangian there are none: its coordinates move.
pub(super) fn sought(checker: &Checker<'_>, scope: &Scope, found: &[Equation]) -> Formulas {
    let mut formulas =
        Formulas { given: Vec::new(), targets: Vec::new(), printed_at: Vec::new(), evaluated: Vec::new() };
    if checker.model.system.is_some() {
        return formulas;
    }
    let candidates = candidates(checker, scope.carried, found);
    if candidates.is_empty() {
        return formulas;
    }
    for place in (0..found.len()).filter(|place| is_open(&found[*place])) {
        let at = scope.carried + place;
        let changes = changes::changes(checker, at);
        let is_needed = |candidate: &&Candidate| {
            let is_before = candidate.at <= at && scope.section_of(candidate.at) == scope.section_of(at);
            is_before && changes.iter().any(|change| is_answered(change, candidate, checker.model))
        };
        let needed: Vec<usize> =
            candidates.iter().filter(is_needed).map(|candidate| formulas.place_of(candidate, checker)).collect();
        let is_beside = |candidate: &Candidate| candidate.at == at || Some(candidate.at) == before(checker, at);
        if candidates.iter().filter(is_needed).any(is_beside) && gives_a_derived_name(checker, at) {
            formulas.evaluated.push(at);
        }
        if !needed.is_empty() {
            formulas.targets.push((place, needed));
        }
    }
    formulas
}

impl Formulas {
    fn place_of(&mut self, candidate: &Candidate, checker: &Checker<'_>) -> usize {
        let name = checker.model.symbols.entry(candidate.symbol).name.clone();
        let known = self.given.iter().position(|formula| formula.name == name);
        known.unwrap_or_else(|| {
            self.given.push(Formula { name, latex: candidate.latex.clone() });
            self.printed_at.push(candidate.at);
            self.given.len() - 1
        })
    }

    /// Whether a display needs one of the formulas, or prints one, which is a definition then.
    pub fn concern(&self, at: usize, scope: &Scope) -> bool {
        self.printed_at.contains(&at) || self.targets.iter().any(|(place, _)| scope.carried + place == at)
    }

    /// Puts the findings on the displays that need the formulas in the place of those before, where they say more.
    pub fn merged(&self, found: &mut [Equation], again: &[Equation], notes: &Notes) {
        for (place, needed) in &self.targets {
            let Some(mut new) = again.get(*place).filter(|new| new.id == found[*place].id).cloned() else { continue };
            let follows = matches!(new.finding.verdict, Verdict::Certified | Verdict::Verified);
            if !follows && new.finding.verdict != Verdict::Refuted {
                continue;
            }
            let shown = |at: &usize| {
                let name = text::plain(&self.given[*at].name.to_string());
                let id = notes.equations[self.printed_at[*at]].id().unwrap_or_default();
                format!("the formula of {name} in ({id})")
            };
            let uses = needed.iter().map(shown).collect::<Vec<_>>().join(" and ");
            let message = &mut new.finding.message;
            *message = if message.is_empty() { format!("uses {uses}") } else { format!("{message}; uses {uses}") };
            found[*place] = new;
        }
    }
}

/// Whether a finding says less than the formula of a name could.
fn is_open(equation: &Equation) -> bool {
    matches!(
        equation.finding.verdict,
        Verdict::Assumed | Verdict::Undecided | Verdict::Definition | Verdict::Unreadable
    )
}

/// The display before one, without the formulas in sentences.
fn before(checker: &Checker<'_>, at: usize) -> Option<usize> {
    let notes = checker.notes;
    (0..at).rev().find(|place| !inline::is_inline(notes, &notes.equations[*place]))
}

/// Whether a display gives a formula to a name that another display defines as a derivative or an integral: `I = dQ/dt`.
fn gives_a_derived_name(checker: &Checker<'_>, at: usize) -> bool {
    let firsts = checker.readings[at].statements.iter().flatten().filter_map(|statement| statement.members.first());
    let is_derived = |id: SymbolId| {
        let gives_it = |place: &usize| checker.readings[*place].introduced.iter().any(|new| new.symbol == id);
        matches!(checker.model.meaning(id), Some(Meaning::Defined(_)))
            && (0..at).filter(gives_it).any(|place| !changes::own(checker, place).is_empty())
    };
    firsts.filter_map(Expr::as_plain_symbol).any(is_derived)
}

/// Whether the formula says how a name depends on the variable of a change.
fn is_answered(change: &Change, candidate: &Candidate, model: &Model) -> bool {
    let is_time = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Time | Meaning::Varying(_)));
    change.of == candidate.symbol
        && match change.by {
            Some(variable) => candidate.names.contains(&variable),
            None => candidate.names.iter().any(is_time),
        }
}

/// What a statement with a name on its left side says of it.
struct Said {
    symbol: SymbolId,
    /// The formula that it gives the name; `None`, if it says something else, or is wrong.
    formula: Option<Candidate>,
    /// Whether it follows from others.
    follows: bool,
}

/// The formulas of names of which no other display says something else: what comes after the formula follows.
fn candidates(checker: &Checker<'_>, carried: usize, found: &[Equation]) -> Vec<Candidate> {
    let mut all: Vec<Said> = Vec::new();
    for at in 0..(carried + found.len()).min(checker.readings.len()) {
        let verdict = at.checked_sub(carried).map(|place| found[place].finding.verdict);
        for statement in
            checker.readings[at].statements.iter().flatten().filter(|statement| statement.members.len() > 1)
        {
            let Some(symbol) = statement.members[0].as_plain_symbol() else { continue };
            if matches!(checker.model.meaning(symbol), Some(Meaning::Constant(_) | Meaning::Varying(_))) {
                let is_right = verdict != Some(Verdict::Refuted);
                let formula = is_right.then(|| candidate(checker, at, symbol, statement)).flatten();
                all.push(Said { symbol, formula, follows: verdict.is_some_and(Verdict::holds) });
            }
        }
    }
    let is_alone = |at: &usize| {
        let is_same = |other: &&Said| other.symbol == all[*at].symbol;
        !all[..*at].iter().any(|other| is_same(&other))
            && all[at + 1..].iter().filter(is_same).all(|other| other.follows)
    };
    let alone: Vec<usize> = (0..all.len()).filter(is_alone).collect();
    let kept = all.into_iter().enumerate().filter(|(at, _)| alone.contains(at));
    kept.filter_map(|(_, said)| said.formula).collect()
}

/// The formula that a statement gives a name, if it is one of numbers without derivatives and integrals.
fn candidate(checker: &Checker<'_>, at: usize, symbol: SymbolId, statement: &Statement) -> Option<Candidate> {
    let model = checker.model;
    let equates = |relation: Relation| is_equality(relation) || relation == Relation::Approximately;
    let last = statement.members.last()?;
    let latex = checker.notes.equations[at].text.get(last.span.range())?;
    let names = names_without(last, symbol, model);
    let is_number = |id: &SymbolId| {
        let entry = model.symbols.entry(*id);
        entry.kind == Kind::Scalar
            && matches!(
                model.meaning(*id),
                Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Time | Meaning::Defined(_))
            )
    };
    let is_plain = last.symbols().iter().all(|(_, dots)| *dots == 0) && !changes::has_calculus(latex, model);
    let holds_always = statement.conditions.is_empty() && statement.constant.is_none();
    let is_formula = is_plain
        && holds_always
        && statement.relations.iter().all(|(relation, _)| equates(*relation))
        && model.symbols.entry(symbol).kind == Kind::Scalar
        && is_one_name(symbol, model)
        && !names.contains(&symbol)
        && names.iter().all(is_number);
    (is_formula && !names.is_empty()).then(|| Candidate { at, symbol, names, latex: latex.to_owned() })
}

/// Whether a symbol is a name, and no formula that stands for one.
fn is_one_name(symbol: SymbolId, model: &Model) -> bool {
    let name = &model.symbols.entry(symbol).name;
    names::parse(&name.to_string()).is_some_and(|(parsed, _)| parsed == *name)
}

/// The names in a formula, and in those of their formulas that do not contain a symbol: a law such as `U = RI + L\dot I` gives U a
/// formula with I, and does not define it where I has one with U.
fn names_without(formula: &Expr, symbol: SymbolId, model: &Model) -> Vec<SymbolId> {
    let mut found: Vec<SymbolId> = Vec::new();
    for (id, _) in formula.symbols() {
        let inner = gate::names(&Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, formula.span), model);
        let is_of_it = inner.contains(&symbol) && id != symbol;
        found.extend(if is_of_it { vec![id] } else { inner });
    }
    found
}
