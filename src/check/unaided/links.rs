//! The equalities of chains, as displays of their own.
//!
//! In `Q = \int p\,dV = nRT \ln(V_1/V_2)` the first equality may be a definition or a law, and then the chain as a whole does
//! not follow. Its other equalities may still be wrong by themselves. Each is judged as a display of its own, at the end of the
//! notes, with the premises and the words that the chain has.

use crate::check::document::checker::Checker;
use crate::check::model::claim::is_equality;
use crate::check::unaided::course::taken::is_static;
use crate::check::unaided::scope::Link;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Relation, Statement};
use crate::notes::{Display, Notes, Numbered};
use crate::source::Span;

/// The most equalities that are judged by themselves.
const MOST: usize = 24;

/// Notes with equalities of chains at their end.
pub(super) struct Apart {
    /// The notes.
    pub notes: Notes,
    /// The equalities, in their order.
    pub links: Vec<Link>,
}

/// The chains that are taken for granted, taken apart; `first` is the place of the first finding. `None`, if there is none.
pub(super) fn apart(checker: &Checker<'_>, first: usize, found: &[Equation]) -> Option<Apart> {
    let mut apart = Apart { notes: checker.notes.clone(), links: Vec::new() };
    apart.notes.equations.truncate(first + found.len());
    for (place, equation) in found.iter().enumerate() {
        let at = first + place;
        // Beside a motion, a step may hold for one case of it only.
        if !is_open(equation) || checker.model.system.is_some() && !is_static(checker, at) {
            continue;
        }
        let chains = checker.readings[at].statements.iter().flatten().filter(|statement| {
            statement.members.len() > 2
                && statement.relations.iter().all(|(relation, _)| is_equality(*relation) || is_near(*relation))
        });
        for (statement, link) in
            chains.flat_map(|statement| (0..statement.relations.len()).map(move |k| (statement, k)))
        {
            // Where a chain ends with "= 0", the author asks when that is so. And its first equality may give a name a formula.
            let is_condition = statement.members[link + 1].is_null();
            let is_definition = link == 0 && statement.members[0].as_plain_symbol().is_some();
            // What is nearly equal on the way to something else is so in a limit that the whole chain has. Numbers are compared.
            let is_rough = is_near(statement.relations[link].0)
                && link + 1 < statement.relations.len()
                && statement.members[link..link + 2].iter().any(|side| !side.symbols().is_empty());
            if apart.links.len() < MOST
                && !is_rough
                && !is_condition
                && !is_definition
                && let Some(display) = alone(&checker.notes.equations[at], statement, link)
            {
                apart.notes.equations.push(display);
                apart.links.push(Link { chain: at, is_later: link > 0 });
            }
        }
    }
    (!apart.links.is_empty()).then_some(apart)
}

fn is_near(relation: Relation) -> bool {
    relation == Relation::Approximately
}

/// Whether a chain as a whole was taken for granted, or left open since nothing gives a formula that is differentiated in it.
fn is_open(chain: &Equation) -> bool {
    chain.finding.verdict == Verdict::Assumed
        || chain.finding.verdict == Verdict::Undecided && chain.finding.code == Code::NotDecided
}

/// One equality of a chain as a display.
fn alone(display: &Display, statement: &Statement, link: usize) -> Option<Display> {
    let start = match link.checked_sub(1) {
        Some(before) => statement.relations.get(before)?.1.end,
        None => statement.members.first()?.span.start,
    };
    let end = match statement.relations.get(link + 1) {
        Some((_, next)) => next.start,
        None => statement.members.last()?.span.end,
    };
    let text = display.text.get(start..end)?;
    // What separates the rows of the chain is no part of a side.
    let significant = text.trim_end_matches(|c: char| c.is_whitespace() || c == '&' || c == '\\');
    let end = start + significant.len();
    let start = end - significant.trim_start_matches(|c: char| c.is_whitespace() || c == '&').len();
    let body = Span::new(start, end).shifted(display.body.start);
    let id = format!("{} equality {} at {}", display.id()?, link + 1, statement.span.start);
    Some(Display {
        span: body,
        body,
        parts: vec![body],
        text: display.text[start..end].to_owned(),
        number: Some(Numbered { id, span: body }),
        labels: Vec::new(),
        automatic: Vec::new(),
        numbers_rows: false,
        ..display.clone()
    })
}

/// Gives each chain what the findings on its equalities say; these come after those on the displays.
pub(super) fn merged(found: &mut [Equation], first: usize, apart: &Apart, links: &[Equation]) {
    // The report knows an equality by the name of its chain.
    for (link, equality) in apart.links.iter().zip(links) {
        let Some(chain) =
            link.chain.checked_sub(first).and_then(|place| found.get(place)).map(|chain| chain.id.clone())
        else {
            continue;
        };
        found.iter_mut().for_each(|equation| equation.rename_in_words(&equality.id, &chain));
    }
    for (place, chain) in found.iter_mut().enumerate() {
        let own = apart.links.iter().zip(links).filter(|(link, _)| link.chain == first + place);
        let own: Vec<&Equation> = own.map(|(_, found)| found).collect();
        if !is_open(chain) {
            continue;
        }
        // Of two displays that contradict each other one is wrong.
        let is_wrong =
            |link: &&&Equation| link.finding.verdict == Verdict::Refuted || link.finding.code == Code::Contradiction;
        if let Some(link) = own.iter().find(is_wrong) {
            *chain = Equation {
                finding: link.finding.clone(),
                repairs: link.repairs.clone(),
                parts: Vec::new(),
                ok: false,
                ..chain.clone()
            };
            let own = chain.id.clone();
            apart.links.iter().zip(links).filter(|(link, _)| link.chain == first + place).for_each(|(_, equality)| {
                chain.rename_in_words(&equality.id, &own);
            });
        } else if chain.finding.verdict == Verdict::Assumed {
            let holds = |link: &&Equation| matches!(link.finding.verdict, Verdict::Certified | Verdict::Verified);
            let open: Vec<String> =
                own.iter().filter(|link| !holds(link)).map(|link| format!("“{}”", link.reading)).collect();
            chain.finding.message = match open.as_slice() {
                all if all.len() == own.len() => continue,
                [] => "the first equality of this chain is taken for granted; what comes after it follows".to_owned(),
                [only] => format!(
                    "no derivation of {only} from the other displays was found, so it is taken for granted; the rest follows"
                ),
                all => format!(
                    "no derivation of {} from the other displays was found, so they are taken for granted; the rest follows",
                    all.join(" and ")
                ),
            };
        }
    }
}
