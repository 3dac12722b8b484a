//! Solutions of laws, by substitution: `x = A \cos \omega t` in the place of x makes `m \ddot x = -k x` an identity in the time
//! and the constants.
//!
//! So no state has to be projected onto the solution, and the prime field can decide the law as it is. A law counts if
//! everything in it that moves has a printed solution. A law in which something else moves, as a constraint force does, does
//! not say by itself whether a formula solves it; then the way of systems is left ([`super::solution`]).

use crate::Result;
use crate::code::Code;
use crate::formula::text;

use crate::check::judge::identity;
use crate::check::kinds::printed_solution::Solution;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::{Model, free_symbols};
use crate::check::sample::context::{Context, Options};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The finding on the laws with printed solutions in the place of the coordinates; `None` beside a system, for a rate, and where
/// no law contains the coordinate and nothing else that moves but these.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn by_substitution(
    solution: &Solution,
    others: &[Solution],
    context: &Context<'_>,
) -> Result<Option<Finding>> {
    let model = context.model;
    let mut along = model.clone();
    along.laws.clear();
    let solutions = || std::iter::once(solution).chain(others.iter().filter(|other| other.dots == 0));
    for known in solutions() {
        along.redefine(known.coordinate, known.formula.clone());
    }
    // A formula that contains what it defines has no value.
    let is_circular = |known: &Solution| along.depends_on(&known.formula, &[known.coordinate]);
    if model.system.is_some() || solution.dots > 0 || solutions().any(is_circular) {
        return Ok(None);
    }
    let options = Options { explain: false, ..context.options };
    let context = Context { model: &along, on_shell: None, options, ..*context };
    let mut worst: Option<Finding> = None;
    for law in laws_of(solution, others, model) {
        let link = Link { lhs: law.lhs.clone(), relation: law.relation, rhs: law.rhs.clone(), free: law.free.clone() };
        let mut found = identity::check(&link, &context)?;
        let printed = || {
            let side = |side| text::formula(side, &model.symbols);
            format!("{} = {}", side(&link.lhs), side(&link.rhs))
        };
        match found.verdict {
            Verdict::Refuted => found.message = format!("{} fails for this formula", printed()),
            // Where the formula has no value, it prints no solution.
            Verdict::Domain => {
                let points = found.points;
                found = context.verified(String::new(), "a formula that has no value at some states");
                (found.points, found.tried) = (points, points);
            }
            // What moves without acceleration makes both sides 0.
            Verdict::Undecided if found.code == Code::SideAlwaysZero => {
                let points = found.points;
                found = context.verified(String::new(), "a law whose sides are both 0");
                (found.points, found.tried) = (points, points);
            }
            _ => {}
        }
        if worst.as_ref().is_none_or(|known| known.verdict.severity() < found.verdict.severity()) {
            worst = Some(found);
        }
    }
    Ok(worst)
}

/// The equations of laws in which a coordinate moves, and nothing else than it and these.
fn laws_of<'m>(
    solution: &Solution,
    others: &[Solution],
    model: &'m Model,
) -> impl Iterator<Item = &'m Hypothesis> + use<'m> {
    let known: Vec<_> =
        std::iter::once(solution).chain(others).filter(|known| known.dots == 0).map(|known| known.coordinate).collect();
    let coordinate = solution.coordinate;
    model.laws.iter().flat_map(|law| &law.hypotheses).filter(move |law| {
        let mut drawn = free_symbols::drawn(&[&law.lhs, &law.rhs], model);
        drawn.retain(|id| !matches!(model.meaning(*id), Some(Meaning::Constant(_))));
        is_equality(law.relation) && drawn.contains(&coordinate) && drawn.iter().all(|id| known.contains(id))
    })
}
