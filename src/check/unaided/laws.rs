//! The equations of motion that notes solve: `m \ddot x = -k x`, and later `x(t) = A \cos \omega t`.
//!
//! Such an equation is a law, whether it follows or is taken for granted: the solution is tested with it, and so is what else
//! comes after it and does not follow otherwise. Without a printed solution nothing says that an equation is one of motion and
//! no condition. What comes before the equation does not follow from it: it may be what the equation follows from.

use serde_json::json;
use std::sync::Arc;

use crate::Result;
use crate::formula::{Expr, Relation, Statement, SymbolId, text};
use crate::notes::Claims;
use crate::source::{Fault, Source};

use crate::check::document::checker::Checker;
use crate::check::hypotheses::motion::motion;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, is_equality};
use crate::check::model::free_symbols;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::scope::Scope;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;

/// The laws of notes.
pub(super) struct Laws {
    /// The names, each with the address of the statement that prints the law.
    addresses: Vec<(String, String)>,
    /// The places of their displays, each with that of the solution.
    places: Vec<(usize, usize)>,
}

impl Laws {
    /// Whether a display comes after a law, and is none. A section without the law and its solution may be about another motion.
    pub fn may_give(&self, at: usize, scope: &Scope) -> bool {
        let is_about_it = |(law, solution): &(usize, usize)| {
            let section = scope.section_of(at);
            *law < at && [scope.section_of(*law), scope.section_of(*solution)].contains(&section)
        };
        self.places.iter().any(is_about_it) && !self.places.iter().any(|(law, _)| *law == at)
    }

    /// The claims with these laws; `None`, if there are none.
    ///
    /// # Errors
    /// For claims that are no JSON object.
    pub fn added_to(&self, claims: &Claims) -> Result<Option<Claims>> {
        let mut keys: serde_json::Map<_, _> = serde_json::from_str(&claims.source.text).unwrap_or_default();
        let laws: serde_json::Map<_, _> =
            self.addresses.iter().map(|(name, address)| (name.clone(), json!(address))).collect();
        if laws.is_empty() || keys.contains_key("laws") || keys.contains_key("system") {
            return Ok(None);
        }
        keys.insert("laws".to_owned(), serde_json::Value::Object(laws));
        let source = Source::new(claims.source.path.clone(), serde_json::Value::Object(keys).to_string());
        let beside = claims.source.path.trim_end_matches(" (inferred)").to_owned();
        Claims::parse(Arc::new(source), std::path::Path::new(&beside)).map(Some)
    }
}

/// The laws of notes with these findings: for each symbol with a printed solution the first equation that gives its highest
/// derivative, if it is before the solution, is not wrong, and nothing else moves in it.
pub(super) fn laws(checker: &Checker<'_>, carried: usize, equations: &[Equation]) -> Laws {
    let mut found: Vec<(SymbolId, (usize, usize), String)> = Vec::new();
    // What comes after the findings is in another scope.
    let end = carried + equations.len();
    for (at, reading) in checker.readings.iter().enumerate().take(end) {
        let Some(id) = checker.notes.equations[at].id() else { continue };
        let is_right = |equation: &Equation| equation.id == id && equation.finding.verdict != Verdict::Refuted;
        if checker.model.system.is_some() || !equations.iter().any(is_right) {
            continue;
        }
        for (place, statement) in reading.statements.iter().enumerate() {
            let Ok(statement) = statement else { continue };
            let Some(moving) = moved_by(checker, statement) else { continue };
            let is_new = !found.iter().any(|(known, ..)| *known == moving);
            if let Some(solution) =
                is_new.then(|| solved_after(checker, moving, (at, place))).flatten().filter(|solution| *solution < end)
            {
                let address = match reading.statements.len() {
                    1 => id.to_owned(),
                    _ => format!("{id} part {}", place + 1),
                };
                found.push((moving, (at, solution), address));
            }
        }
    }
    let name = |moving: SymbolId| format!("the equation of motion of {}", text::plain(&checker.model.name(moving)));
    let places = found.iter().map(|(_, places, _)| *places).collect();
    Laws { addresses: found.into_iter().map(|(moving, _, address)| (name(moving), address)).collect(), places }
}

/// The symbol whose highest derivative a statement gives, if it is the only one that moves in it.
fn moved_by(checker: &Checker<'_>, statement: &Statement) -> Option<SymbolId> {
    let ([lhs, rhs], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
        return None;
    };
    if !is_equality(*relation) || !statement.conditions.is_empty() {
        return None;
    }
    let link = checker.link(lhs, Relation::Equal, rhs).ok()?;
    let mut moving = free_symbols::drawn(&[&link.lhs, &link.rhs], checker.model);
    moving.retain(|id| matches!(checker.model.meaning(*id), Some(Meaning::Varying(_))));
    let [only] = moving.as_slice() else { return None };
    motion(checker.model, &Hypothesis::of(link, true)).filter(|rule| rule.symbol == *only).map(|_| *only)
}

/// The display of the first statement after this place that gives a symbol as a function of the time and constants.
fn solved_after(checker: &Checker<'_>, moving: SymbolId, place: (usize, usize)) -> Option<usize> {
    let model = checker.model;
    let all = checker.readings.iter().enumerate();
    let mut statements = all.flat_map(|(at, reading)| {
        reading.statements.iter().enumerate().map(move |(statement, read)| ((at, statement), read))
    });
    let is_solution = |((at, place_of_it), read): &((usize, usize), &Result<Statement, Fault>)| {
        let at = (*at, *place_of_it);
        let Ok(statement) = read else { return false };
        let is_of_time = |formula: &Expr| model.contains_time(formula) && !moves(formula, model);
        at > place
            && statement.members.first().and_then(Expr::as_plain_symbol) == Some(moving)
            && statement.members.get(1).is_some_and(is_of_time)
    };
    statements.find(is_solution).map(|((at, _), _)| at)
}

fn moves(formula: &Expr, model: &Model) -> bool {
    let drawn = free_symbols::drawn(&[formula], model);
    drawn.into_iter().any(|id| !matches!(model.meaning(id), Some(Meaning::Constant(_))))
}
