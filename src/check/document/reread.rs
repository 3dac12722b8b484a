//! Another text of a display, read with the names of the document, and compared with the original.

use crate::formula::{Expr, Relation, Statement, text};
use crate::latex::{DefinedSymbol, Macros, Reading};
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;

/// The reading of a text in place of the `at`-th equation, with the definitions that both have.
pub(crate) fn read_in_place(checker: &Checker<'_>, macros: &Macros, at: usize, text: &str, claim: &Claim) -> Reading {
    let mut reading = checker.as_printed(text, claim, macros);
    for introduced in &checker.readings[at].introduced {
        let Some(Ok(original)) = checker.readings[at].statements.get(introduced.statement) else { continue };
        let shared =
            |read: &Statement| defined(read, introduced).is_some_and(|d| Some(d) == defined(original, introduced));
        let here = reading.statements.iter().position(|read| read.as_ref().is_ok_and(shared));
        if let Some(statement) = here {
            reading.introduced.push(DefinedSymbol { statement, ..introduced.clone() });
        }
    }
    reading
}

/// The message for a print that says less than the reference: it has fewer relations of a kind, or lacks "is constant".
/// `None` where it says as much, or where it cannot be read, which is reported by itself.
pub(crate) fn missing_from_print(checker: &Checker<'_>, reading: &Reading, reference: &Reading) -> Option<String> {
    let kind = |relation: Relation| match relation {
        Relation::Identical => Relation::Equal,
        Relation::Greater => Relation::Less,
        Relation::GreaterEqual => Relation::LessEqual,
        other => other,
    };
    let kinds = |reading: &Reading| -> Vec<Relation> {
        let statements = reading.statements.iter().flatten();
        statements.flat_map(|s| s.relations.iter().map(|(relation, _)| kind(*relation))).collect()
    };
    if reading.statements.iter().any(std::result::Result::is_err) {
        return None;
    }
    let (here, there) = (kinds(reading), kinds(reference));
    let count = |kinds: &[Relation], wanted: Relation| kinds.iter().filter(|found| **found == wanted).count();
    let source = &checker.notes.source.path;
    if let Some(fewer) = there.iter().find(|wanted| count(&here, **wanted) < count(&there, **wanted)) {
        let (has, had) = (count(&here, *fewer), count(&there, *fewer));
        let members = |reading: &'_ Reading| -> Vec<Expr> {
            reading.statements.iter().flatten().flat_map(|statement| statement.members.clone()).collect()
        };
        let kept = members(reading);
        let missing = members(reference).into_iter().find(|member| !kept.contains(member));
        let missing = missing.map_or_else(String::new, |member| {
            format!("; {} is missing here", text::formula(&member, &checker.model.symbols))
        });
        return Some(format!("this equation has {had} “{}” in {source}, and {has} here{missing}", fewer.glyph()));
    }
    let constants = |reading: &Reading| reading.statements.iter().flatten().filter(|s| s.constant.is_some()).count();
    (constants(reading) < constants(reference))
        .then(|| format!("{source} says that a quantity is constant, and these notes do not"))
}

/// Whether two readings have the same statements, apart from their places in the text.
pub(crate) fn reads_alike(a: &Reading, b: &Reading) -> bool {
    let alike = |(a, b): (&_, &_)| matches!((a, b), (Ok(a), Ok(b)) if says_the_same(a, b));
    a.statements.len() == b.statements.len() && a.statements.iter().zip(&b.statements).all(alike)
}

/// The member that introduces a name, and the member that defines it.
pub(crate) fn defined<'a>(statement: &'a Statement, introduced: &DefinedSymbol) -> Option<(&'a Expr, &'a Expr)> {
    let beside = introduced.member.checked_sub(1).unwrap_or(1);
    Some((statement.members.get(introduced.member)?, statement.members.get(beside)?))
}

/// Whether two statements are the same, apart from their places in the text.
pub(crate) fn says_the_same(a: &Statement, b: &Statement) -> bool {
    let relations = |s: &Statement| s.relations.iter().map(|(relation, _)| *relation).collect::<Vec<_>>();
    a.members == b.members && relations(a) == relations(b) && a.constant.is_some() == b.constant.is_some()
}

/// Whether a display may have a derivative by a symbol or a Poisson bracket: its reading then contains the derivatives of
/// definitions in place of their names.
pub(crate) fn forms_derivatives(text: &str) -> bool {
    ["\\partial", "\\frac{d", "\\{", "]_"].iter().any(|mark| text.contains(mark))
}
