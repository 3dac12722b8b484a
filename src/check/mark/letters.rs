//! Other letters: which names of a hand-in stand for which names of the problem.
//!
//! Declared letters come first. If the hand-in then has a false line or lacks a result, and names of its own, each way to
//! take them for unused names of the problem is tried, and the best one counts, if it makes more true than none.

use std::collections::HashMap;

use crate::Result;
use crate::formula::symbols::Name;
use crate::latex::{Macros, names};
use crate::notes::Notes;

use crate::check::document::setup::{Run, define_macros};
use crate::check::sample::context::Options;
use crate::check::unaided::names::{Usage, names_of};

use super::judge::judge;
use super::judged::Judged;
use super::marked::Mark;
use super::names::{Names, Role};
use super::problem::{self, Problem};
use super::world::World;
use super::written::{Written, written};

/// The most ways that are tried.
const WAYS: usize = 60;

/// The number of states at which a way is tried.
const POINTS: usize = 8;

/// The hand-in, judged with the letters that fit best, and those letters with what they stand for.
///
/// # Errors
/// When the problem cannot be applied to the hand-in.
pub(super) fn best(run: &Run<'_>, problem: &Problem, notes: &Notes) -> Result<(Judged, Vec<(String, String)>)> {
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let lines = written(notes, &macros);
    let used = usages(notes, &lines, &macros);
    let known = &problem.names;
    let declared = declared(problem, &used);
    let tried = |table: &HashMap<Name, Name>, run: &Run<'_>, details: bool| {
        let world = World::new(run, problem, (notes, &lines), &known.with_momenta(table))?;
        judge(run, &world, details)
    };
    let shown = |table: &HashMap<Name, Name>| {
        let mut pairs: Vec<(String, String)> = table.iter().map(|(a, b)| (a.to_string(), b.to_string())).collect();
        pairs.sort();
        pairs
    };
    let quick = Run { options: Options { points: POINTS, explain: false, ..run.options }, ..*run };
    let mut best = declared.clone();
    let ways = ways(&used, known, &declared);
    if !ways.is_empty() {
        let own = tried(&declared, &quick, false)?;
        let mut score = own.score();
        let mut is_whole = is_whole(&own);
        for way in ways {
            if is_whole {
                break;
            }
            let Ok(judged) = tried(&way, &quick, false) else { continue };
            if judged.score() > score {
                is_whole = self::is_whole(&judged);
                (score, best) = (judged.score(), way);
            }
        }
    }
    Ok((tried(&best, run, true)?, shown(&best)))
}

/// Whether every line holds, and every result is reached.
fn is_whole(judged: &Judged) -> bool {
    judged.lines.iter().all(|line| matches!(line.mark, Mark::Right | Mark::Given))
        && judged.found.iter().all(|found| found.as_ref().is_some_and(|found| found.is_right))
}

fn usages(notes: &Notes, lines: &[Written], macros: &Macros) -> Vec<Usage> {
    let displays: Vec<_> = lines
        .iter()
        .map(|line| crate::notes::Display {
            span: line.body,
            body: line.body,
            parts: vec![line.body],
            text: line.text.clone(),
            number: None,
            labels: Vec::new(),
            line: notes.source.line_column(line.body.start).0,
        })
        .collect();
    names_of(&displays, macros)
}

/// The letters that the rubric declares, where the hand-in uses them and not the problem's own.
fn declared(problem: &Problem, used: &[Usage]) -> HashMap<Name, Name> {
    let parsed = |text: &str| names::parse(text).map(|(name, _)| name);
    let mut table = HashMap::new();
    for (own, other) in problem::declared_letters(&problem.rubric) {
        let (Some(own), Some(other)) = (parsed(&own.value), parsed(&other.value)) else { continue };
        let is_used = |name: &Name| used.iter().any(|usage| usage.name == *name);
        if is_used(&other) && !is_used(&own) {
            table.insert(other, own);
        }
    }
    table
}

/// The ways to take the names that only the hand-in has for names that only the problem has, the most likely first.
fn ways(used: &[Usage], known: &Names, declared: &HashMap<Name, Name>) -> Vec<HashMap<Name, Name>> {
    let is_used = |name: &Name| used.iter().any(|usage| usage.name == *name);
    let is_taken = |name: &Name| declared.values().any(|other| other == name);
    let free: Vec<&(Name, Role)> = known.names.iter().filter(|(name, _)| !is_used(name) && !is_taken(name)).collect();
    let is_own = |usage: &&Usage| {
        let name = &usage.name;
        // `d` is a name where it is the whole left side.
        let is_free = name.base == "d" && usage.introduced.is_some();
        let reserved = !is_free
            && ["t", "e", "d", "i", "\\pi", "\\mathrm{d}"].contains(&name.base.as_str())
            && name.subscript.is_empty();
        let is_momentum = name.base == "p" && !name.subscript.is_empty();
        known.symbols.find(name).is_none()
            && !reserved
            && !is_momentum
            && !declared.contains_key(name)
            && name.primes == 0
            && !name.base.starts_with(['(', '['])
    };
    let own: Vec<&Usage> = used.iter().filter(is_own).collect();
    let mut found = vec![HashMap::new()];
    for usage in own {
        let fits = |role: Role| match (usage.moves, usage.introduced.is_some()) {
            (true, false) => role == Role::Moving,
            (true, true) => role != Role::Constant,
            (false, _) => true,
        };
        // A name without a line of its own is more likely a constant than a result that the hand-in uses early.
        let is_late = |role: Role| usage.introduced.is_none() && role == Role::Determined;
        let mut names: Vec<&&(Name, Role)> = free.iter().filter(|(_, role)| fits(*role)).collect();
        names.sort_by_key(|(_, role)| is_late(*role));
        let mut next: Vec<HashMap<Name, Name>> = Vec::new();
        for way in &found {
            for (name, _) in &names {
                if !way.values().any(|other| other == name) {
                    let mut way: HashMap<Name, Name> = way.clone();
                    way.insert(usage.name.clone(), name.clone());
                    next.push(way);
                }
            }
        }
        // Each name may also be one of the student's own.
        next.extend(found);
        next.sort_by_key(|way| std::cmp::Reverse(way.len()));
        next.truncate(WAYS * 4);
        found = next;
    }
    found.retain(|way| !way.is_empty());
    found.truncate(WAYS);
    found.into_iter().map(|way| declared.clone().into_iter().chain(way).collect()).collect()
}
