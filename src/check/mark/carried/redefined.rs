//! Follow-through of a false definition: a line that holds where a name of the problem means what a false line says that it is.

use crate::formula::{Expr, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::mark::status::{Status, status};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Options;

use super::Before;

/// Whether a line holds with the definition of a false line, by itself, as a secular equation, or with the definitions of the other
/// false lines.
pub(super) fn follows(checker: &Checker<'_>, from: usize, (at, own): (usize, &Reading), before: &Before<'_>) -> bool {
    let none = Claim::default();
    let holds = |edited: &Checker<'_>, reading: &Reading, claim: &Claim| {
        matches!(status(edited, at, reading, claim), Status::Holds(..))
    };
    let others: Vec<(SymbolId, Expr)> =
        before.wrong.iter().filter(|other| **other != from).filter_map(|other| definition(checker, *other)).collect();
    let in_models = |edited: &Checker<'_>| {
        let secular = before.contexts.iter().filter(|claim| claim.secular_for.is_some());
        // A value or a slope of the name is another one then.
        let again = Some(&edited.readings[at]).filter(|again| !says_the_same(again, own));
        let readings: Vec<&Reading> = std::iter::once(own).chain(again).collect();
        if std::iter::once(&none).chain(secular).any(|claim| readings.iter().any(|own| holds(edited, own, claim))) {
            return true;
        }
        let mut model = edited.model.clone();
        for (name, formula) in others.iter().filter(|(_, formula)| !formula.symbols().is_empty()) {
            model.redefine(*name, formula.clone());
        }
        let is_circular = others.iter().any(|(name, _)| model.is_defined_by_itself(*name));
        let all = Checker { model: &model, units: None, ..*edited };
        !others.is_empty() && !is_circular && readings.iter().any(|own| holds(&all, own, &none))
    };
    if let Some((place, text)) = definition_in_place(checker, from) {
        let options = Options { explain: false, ..checker.options };
        if checker.with_edited_text(options, place, &text, in_models).unwrap_or(false) {
            return true;
        }
    }
    // The display that defines the name may say more.
    let Some((name, formula)) = definition(checker, from) else { return false };
    let mut model = checker.model.clone();
    model.redefine(name, formula);
    holds(&Checker { model: &model, units: None, ..*checker }, own, &none)
}

/// Whether two readings have the same formulas.
fn says_the_same(a: &Reading, b: &Reading) -> bool {
    let members = |reading: &Reading| -> Vec<Expr> {
        reading.statements.iter().flatten().flat_map(|statement| statement.members.clone()).collect()
    };
    members(a) == members(b)
}

/// The name of the problem that a false line gives another formula, and that formula.
fn definition(checker: &Checker<'_>, from: usize) -> Option<(SymbolId, Expr)> {
    let Some(Ok(Statement { members, .. })) = checker.readings[from].statements.first() else { return None };
    let [first, formula, ..] = members.as_slice() else { return None };
    let name = first.as_plain_symbol()?;
    let is_defined = matches!(checker.model.meaning(name), Some(Meaning::Defined(_)));
    (is_defined && !checker.model.depends_on(formula, &[name])).then(|| (name, formula.clone()))
}

/// The display that defines the name that a false line gives another formula, and its text with that formula.
fn definition_in_place(checker: &Checker<'_>, from: usize) -> Option<(usize, String)> {
    let Some(Ok(Statement { members, .. })) = checker.readings[from].statements.first() else { return None };
    let (first, last) = (members.first()?, members.last()?);
    let name = first.as_plain_symbol()?;
    if !matches!(checker.model.meaning(name), Some(Meaning::Defined(_) | Meaning::System(_))) {
        return None;
    }
    let defines = |reading: &Reading| {
        let new = reading.introduced.iter().find(|new| new.symbol == name && new.member == 0)?;
        reading.statements.get(new.statement)?.as_ref().ok().cloned()
    };
    let (place, known) =
        checker.readings.iter().enumerate().find_map(|(place, reading)| Some((place, defines(reading)?)))?;
    let value = checker.notes.equations[from].text.get(last.span.range())?;
    let old = known.members.get(1)?.span.to(known.members.last()?.span);
    let mut text = checker.notes.equations[place].text.clone();
    text.get(old.range())?;
    text.replace_range(old.range(), value);
    (place != from).then_some((place, text))
}
