//! What a finding means where no claims file says what the symbols are: whether the display follows, introduces a name,
//! is taken for granted, or is wrong.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Sign, Statement, SymbolId, Symbols, text};
use crate::latex::read_display;
use crate::notes::{Claims, Display, Notes};

use crate::check::document::setup::{Run, with_checker};
use crate::check::model::Model;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;

/// The most symbols that stand on one side only of what one slip separates from an identity.
const MOST_ON_ONE_SIDE: usize = 2;

/// The fewest symbols, each as often as it stands there, of a correction that is no triviality.
const FEWEST_SYMBOLS: usize = 4;

/// The displays that may be one slip away from what follows.
///
/// # Errors
/// For claims that do not fit the notes.
pub(super) fn candidates(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Vec<String>> {
    with_checker(run, claims, notes, |checker| {
        let may_be = |statement: &Statement| may_be_a_slip(statement, checker.model);
        let found = notes
            .equations
            .iter()
            .zip(checker.readings)
            .filter(|(_, reading)| reading.statements.iter().flatten().any(may_be));
        Ok(found.filter_map(|(display, _)| display.id().map(str::to_owned)).collect())
    })
}

fn may_be_a_slip(statement: &Statement, model: &Model) -> bool {
    let members = &statement.members;
    if let ([first, _], Some(id)) = (members.as_slice(), members.first().and_then(Expr::as_plain_symbol)) {
        // Another formula for a name that has one is a law, a case or a new meaning; for a derived quantity it is a claim.
        if !is_derived(first, model) && model.meaning(id).is_some() {
            return false;
        }
    }
    let pairs = members.windows(2).zip(&statement.relations);
    pairs.filter(|(_, relation)| is_equality(relation.0)).any(|(pair, _)| {
        let (left, right) = (leaves(&pair[0], model), leaves(&pair[1], model));
        let alone =
            left.iter().filter(|id| !right.contains(id)).count() + right.iter().filter(|id| !left.contains(id)).count();
        model.system.is_some() || alone <= MOST_ON_ONE_SIDE
    })
}

/// Whether a formula is the name of a quantity that the Lagrangian determines.
fn is_derived(formula: &Expr, model: &Model) -> bool {
    formula.as_plain_symbol().is_some_and(|id| matches!(model.meaning(id), Some(Meaning::System(_))))
}

/// The symbols of a formula that no formula defines.
fn leaves(formula: &Expr, model: &Model) -> Vec<SymbolId> {
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
    found.retain(|id| !matches!(model.meaning(*id), Some(Meaning::Defined(_))));
    found.dedup();
    found
}

/// The symbols in a text, each as often as it stands there.
fn symbols_of(text: &str, model: &Model) -> Vec<SymbolId> {
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

/// The equation as it counts in notes without a claims file. `elsewhere` are the symbols of the other displays.
pub(super) fn weigh(mut equation: Equation, display: &Display, (model, elsewhere): (&Model, &[SymbolId])) -> Equation {
    let is_wrong = equation.finding.verdict == Verdict::Refuted
        && equation.repairs.iter().any(|repair| is_likely(repair, display, (model, elsewhere)));
    if is_wrong {
        equation.repairs.retain(|repair| is_likely(repair, display, (model, elsewhere)));
    } else {
        equation.repairs.clear();
    }
    equation.finding = as_it_counts(equation.finding, is_wrong);
    for part in &mut equation.parts {
        part.finding = as_it_counts(part.finding.clone(), is_wrong);
        part.ok = part.finding.verdict != Verdict::Refuted;
    }
    equation.ok = equation.finding.verdict != Verdict::Refuted;
    equation.elsewhere.clear();
    equation
}

fn as_it_counts(finding: Finding, is_wrong: bool) -> Finding {
    let is_untested =
        matches!(finding.code, Code::DefinitionUnused | Code::DefinitionNotTested | Code::DefinitionUpToSign);
    match finding.verdict {
        Verdict::Refuted if !is_wrong => Finding::new(
            Code::Assumed,
            Verdict::Assumed,
            finding.span,
            "this does not follow from the other displays, and no likely slip explains that; it is taken for granted",
        ),
        Verdict::Domain => Finding { verdict: Verdict::Undecided, ..finding },
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
fn is_likely(repair: &Repair, display: &Display, (model, elsewhere): (&Model, &[SymbolId])) -> bool {
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
    // Authors lose terms; they do not add terms that do not belong.
    if repair.replacement.trim().is_empty() && left_out.contains(|c: char| c.is_ascii_alphabetic()) {
        return false;
    }
    corrected.replace_range(start..end, &repair.replacement);
    let mut symbols = model.symbols.clone();
    let reading = read_display(&corrected, &mut symbols, &model.macros);
    let statements: Vec<&Statement> = reading.statements.iter().flatten().collect();
    if statements.len() < reading.statements.len() {
        return false;
    }
    let (before, after) = (symbols_of(&display.text, model), symbols_of(&corrected, model));
    // A correction loses no more than one symbol: what has more of them was meant.
    if after.len() + 1 < before.len() {
        return false;
    }
    // A name that stands nowhere else is new, and no slip for another one.
    if before.iter().any(|id| !after.contains(id) && !elsewhere.contains(id)) {
        return false;
    }
    // Of a motion, what lacks a term is a special case as often as a slip: a circular orbit, a length of 1.
    let moves = |id: &SymbolId| model.coordinates.iter().any(|coordinate| coordinate.symbol == *id);
    if model.system.is_some() && before.iter().any(moves) && after.len() > before.len() {
        return false;
    }
    // A name beside its formula is a definition, and says nothing of its own.
    let is_claim = |pair: &&[Expr]| pair.iter().all(|side| side.as_plain_symbol().is_none() || is_derived(side, model));
    let pairs = statements.iter().flat_map(|statement| statement.members.windows(2));
    let mut claims = pairs.filter(is_claim).peekable();
    claims.peek().is_some() && claims.all(|pair| is_content(&pair[0], &pair[1], &symbols))
}

/// Whether an equality says more than that something is equal to itself: what is left of it without the terms that both
/// sides have is no triviality.
fn is_content(left: &Expr, right: &Expr, symbols: &Symbols) -> bool {
    let (mut left, mut right) = (terms(left, symbols), terms(right, symbols));
    left.retain(|(term, _)| match right.iter().position(|(other, _)| other == term) {
        Some(at) => {
            right.remove(at);
            false
        }
        None => true,
    });
    let count: usize = left.iter().chain(&right).map(|(_, count)| count).sum();
    count >= FEWEST_SYMBOLS
}

/// The terms of a formula, with their signs, and the number of symbols in each.
fn terms(formula: &Expr, symbols: &Symbols) -> Vec<(String, usize)> {
    let one = |sign: Sign, term: &Expr| {
        let sign = if sign == Sign::Plus { '+' } else { '-' };
        (format!("{sign}{}", canonical(term, symbols)), occurrences(term))
    };
    match &formula.node {
        Node::Sum(terms) => terms.iter().map(|term| one(term.sign, &term.expr)).collect(),
        _ => vec![one(Sign::Plus, formula)],
    }
}

/// The number of symbols in a formula, each as often as it stands there.
fn occurrences(formula: &Expr) -> usize {
    let mut count = 0;
    formula.walk(&mut |part| count += usize::from(matches!(part.node, Node::Symbol { .. })));
    count
}

/// A formula in which the order of terms and factors does not count.
fn canonical(expr: &Expr, symbols: &Symbols) -> String {
    match &expr.node {
        Node::Sum(terms) => {
            let sign = |sign: Sign| if sign == Sign::Plus { '+' } else { '-' };
            let mut terms: Vec<String> =
                terms.iter().map(|term| format!("{}{}", sign(term.sign), canonical(&term.expr, symbols))).collect();
            terms.sort();
            format!("({})", terms.concat())
        }
        Node::Product(factors) => {
            let mut factors: Vec<String> = factors.iter().map(|factor| canonical(factor, symbols)).collect();
            factors.sort();
            factors.join("·")
        }
        // d/dt of x is ẋ.
        Node::TimeDerivative(order, inner) => match &inner.node {
            Node::Symbol { id, indices, dots } => {
                let node = Node::Symbol { id: *id, indices: indices.clone(), dots: dots + order };
                text::formula(&Expr::new(node, expr.span), symbols)
            }
            _ => text::formula(expr, symbols),
        },
        Node::Dot(a, b) | Node::Cross(a, b) => {
            let mut both = [canonical(a, symbols), canonical(b, symbols)];
            both.sort();
            format!("[{}]", both.join(" "))
        }
        Node::Quotient(a, b) => format!("({})/({})", canonical(a, symbols), canonical(b, symbols)),
        Node::Power(a, b) => format!("({})^({})", canonical(a, symbols), canonical(b, symbols)),
        _ => text::formula(expr, symbols),
    }
}
