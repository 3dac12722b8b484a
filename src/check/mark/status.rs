//! What a line is in the problem: it holds, is false, gives something, or was not decided or not read.

use crate::code::Code;
use crate::formula::{Relation, Statement};
use crate::latex::Reading;
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
pub(super) use crate::check::document::reading::approximate;
use crate::check::model::claim::is_equality;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// What a line is in the problem.
pub(super) enum Status {
    /// It holds.
    Holds(Verdict),
    /// It is false.
    False(Box<Finding>),
    /// It introduces a name, or prints a law.
    Given(Verdict, &'static str),
    /// It was not decided.
    Open(Verdict, String),
    /// It cannot be read.
    Unread(String),
}

/// The fewest states that decide where others give no number.
const ENOUGH: usize = 5;

/// What a reading of a display is.
pub(super) fn status(checker: &Checker<'_>, display: usize, reading: &Reading, claim: &Claim) -> Status {
    if let Some(known) = stated(reading) {
        return known;
    }
    let place = &checker.notes.equations[display];
    let parts = match checker.parts((display, place.body.start), reading, claim, &shown(place)) {
        Ok(parts) => parts,
        Err(error) => return Status::Open(Verdict::Undecided, error.message().to_owned()),
    };
    let mut best = Status::Holds(Verdict::Certified);
    for part in parts {
        let finding = part.finding;
        let here = of_finding(finding);
        let rank = |status: &Status| match status {
            Status::Holds(verdict) => verdict.severity(),
            Status::Given(..) => 20,
            Status::Open(..) => 30,
            Status::Unread(_) => 40,
            Status::False(_) => 50,
        };
        if rank(&here) > rank(&best) {
            best = here;
        }
    }
    best
}

/// What a reading is that claims nothing: a fault, a definition or a formula alone.
pub(super) fn stated(reading: &Reading) -> Option<Status> {
    if let Some(Err(fault)) = reading.statements.iter().find(|statement| statement.is_err()) {
        return Some(Status::Unread(fault.message.clone()));
    }
    let is_definition = |statement: usize| {
        let read = reading.statements[statement].as_ref();
        let defines = reading.introduced.iter().any(|new| new.statement == statement);
        defines && read.is_ok_and(|read| read.members.len() == 2 && read.constant.is_none())
    };
    if !reading.statements.is_empty() && (0..reading.statements.len()).all(is_definition) {
        return Some(Status::Given(Verdict::Definition, "defines a name"));
    }
    let no_relation = |statement: &Statement| statement.relations.is_empty() && statement.constant.is_none();
    let is_bare = reading.statements.iter().flatten().all(no_relation);
    is_bare.then_some(Status::Given(Verdict::Unclaimed, "is a formula without a relation, and states nothing"))
}

fn of_finding(finding: Finding) -> Status {
    use Code::{
        AlwaysConstant, Definition, DefinitionNotTested, DefinitionUnused, DefinitionUpToSign, DefinitionUsersFail,
        FollowsFromHypotheses, ForcedValue, MutantPasses, RestatesHypothesis, SameFormula, SideAlwaysZero,
        TrueByDefinition, UnitMismatch,
    };
    let is_named = |code: Code| {
        matches!(code, Definition | DefinitionNotTested | DefinitionUnused | DefinitionUpToSign | DefinitionUsersFail)
    };
    match (finding.verdict, finding.code) {
        (_, code) if is_named(code) => Status::Given(Verdict::Definition, "defines a name"),
        (Verdict::Law, _) => Status::Given(Verdict::Law, "is a law that the problem gives"),
        (Verdict::Unreadable, UnitMismatch) | (Verdict::Refuted, _) => Status::False(Box::new(finding)),
        // The problem says of no line of a hand-in what is small there.
        (Verdict::Unreadable, Code::NeedsLimitOrSmall) => Status::Open(
            Verdict::Undecided,
            "≈ stands here without printed decimals to compare; mark this line by hand".to_owned(),
        ),
        (Verdict::Unreadable, _) => Status::Unread(finding.message),
        (
            Verdict::Undecided,
            SameFormula
            | RestatesHypothesis
            | FollowsFromHypotheses
            | TrueByDefinition
            | MutantPasses
            | SideAlwaysZero
            | AlwaysConstant
            | ForcedValue,
        )
        | (Verdict::Domain, _) => Status::Holds(Verdict::Verified),
        // Where both sides have values they agree: a root exists only for some values of what it is taken of.
        (Verdict::Undecided, Code::TooFewStates) if finding.points >= ENOUGH => Status::Holds(Verdict::Verified),
        (verdict, _) if verdict.passes() => Status::Holds(verdict),
        (verdict, _) => Status::Open(verdict, finding.message),
    }
}

/// What a row of a chain says of the first member of the chain.
pub(super) fn composed(start: &Reading, row: &Reading) -> Option<Reading> {
    if start.statements.len() != row.statements.len() {
        return None;
    }
    let mut statements = Vec::new();
    for pair in start.statements.iter().zip(&row.statements) {
        let (Ok(start), Ok(row)) = pair else { return None };
        let (first, last) = (start.members.first()?.clone(), row.members.last()?.clone());
        let all = start.relations.iter().chain(&row.relations);
        let relation = match all.clone().all(|(relation, _)| is_equality(*relation)) {
            true => Relation::Equal,
            false => all.map(|(relation, _)| *relation).find(|relation| !is_equality(*relation))?,
        };
        let place = row.relations.first()?.1;
        let (members, relations) = (vec![first, last], vec![(relation, place)]);
        statements.push(Ok(Statement { members, relations, ..row.clone() }));
    }
    Some(Reading { statements, introduced: Vec::new() })
}
