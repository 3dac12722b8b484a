//! The hypotheses that no state obeys, in words, with the places at which they are stated.

use crate::formula::{Relation, text};
use crate::phrases::listed;

use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::contains;

/// The largest number of hypotheses that are named as failing, and as possibly contradicted.
const NAMED: usize = 3;

/// Why no state was found that obeys the hypotheses of a projection, and what to do about it: clauses of a message that
/// begin with what is not obeyed. That no state was found is no proof that there is none.
pub(crate) fn explanation(projection: &Projection<'_>) -> String {
    let mut unmet: Vec<(usize, usize)> = projection.record.unmet.iter().map(|(at, count)| (*at, *count)).collect();
    unmet.sort_by_key(|(at, count)| (std::cmp::Reverse(*count), *at));
    unmet.truncate(NAMED);
    unmet.sort_unstable();
    let hypotheses = &projection.hypotheses;
    if let [(at, _)] = unmet.as_slice()
        && let Some(said) = impossible_motion(&hypotheses[*at], projection)
    {
        return said;
    }
    if let Some(said) = hypotheses.iter().find_map(|hypothesis| outside_its_range(hypothesis, projection)) {
        return said;
    }
    let is_of_a_law = |hypothesis| projection.model.laws.iter().any(|law| law.hypotheses.contains(hypothesis));
    if let [(at, _)] = unmet.as_slice()
        && hypotheses[*at].throughout
        && projection.model.has_motion()
        && !is_of_a_law(&hypotheses[*at])
    {
        let what = shown(&hypotheses[*at], projection);
        return format!(
            "{what}: perhaps no motion of the system obeys it; if it holds at one instant, put it under \"assume\" in place of \
             \"throughout\", or check the declared ranges"
        );
    }
    let is_unmet = |at: &usize| unmet.iter().any(|(known, _)| known == at);
    let named = |at: usize| shown(&hypotheses[at], projection);
    let failing: Vec<String> = unmet.iter().map(|(at, _)| named(*at)).collect();
    let others: Vec<usize> = (0..hypotheses.len()).filter(|at| !is_unmet(at)).collect();
    let others = match others.len() {
        0 => String::new(),
        1..=NAMED => format!(" or {}", listed(&others.iter().map(|at| named(*at)).collect::<Vec<_>>(), "or")),
        count => format!(" or one of {count} other hypotheses"),
    };
    let (what, they, contradict, them) = match failing.len() {
        0 => ("the hypotheses".to_owned(), "they", "contradict each other or", "them"),
        1 => (failing.concat(), "it", "contradicts", "it"),
        _ => (format!("{} together", listed(&failing, "and")), "they", "contradict each other or", "them"),
    };
    // Without a name for what fails, nothing is known to be contradicted.
    let others = if failing.is_empty() { String::new() } else { others };
    match projection.record.is_stuck() {
        true => format!(
            "{what}: {they} {contradict} the declared ranges{others}, or the solver failed; check {them}, or write {them} \
             in the form x = …"
        ),
        false => format!(
            "{what}: {they} {contradict} the declared ranges{others}, or the ranges are too wide; check {them}, or narrow \
             the ranges"
        ),
    }
}

/// What is said of an equation of motion without anything that moves: no motion obeys −m = 0, which follows from L = m x.
fn impossible_motion(hypothesis: &Hypothesis, projection: &Projection<'_>) -> Option<String> {
    let model = projection.model;
    let is_constant = |id| matches!(model.meaning(id), Some(Meaning::Constant(_)));
    let all = [&hypothesis.lhs, &hypothesis.rhs].map(|side| side.symbols()).concat();
    let is_of_the_lagrangian = model.laws.iter().any(|law| law.derived && law.hypotheses.contains(hypothesis));
    (is_of_the_lagrangian && all.iter().all(|(id, _)| is_constant(*id))).then(|| {
        let equation = shown(hypothesis, projection);
        format!(
            "the equations of motion: they contain {equation}, which is false for every motion; correct the Lagrangian"
        )
    })
}

/// What is said of a hypothesis that gives a name a number outside of its declared range: m = 0, where m is declared positive.
fn outside_its_range(hypothesis: &Hypothesis, projection: &Projection<'_>) -> Option<String> {
    let model = projection.model;
    let name = hypothesis.lhs.as_plain_symbol()?;
    let number = if hypothesis.rhs.is_zero() { 0.0 } else { hypothesis.rhs.as_digits()?.parse().ok()? };
    let is_outside = hypothesis.relation == Relation::Equal && !contains(&model.range(name), number);
    is_outside.then(|| {
        let (what, name) = (shown(hypothesis, projection), text::plain(&model.name(name)));
        format!("{what}: it contradicts the declared range of {name}; remove the hypothesis, or declare a range with this number")
    })
}

/// A hypothesis in words, with its place.
fn shown(hypothesis: &Hypothesis, projection: &Projection<'_>) -> String {
    let symbols = &projection.model.symbols;
    let (lhs, rhs) = (text::formula(&hypothesis.lhs, symbols), text::formula(&hypothesis.rhs, symbols));
    let stated = hypothesis.stated.as_ref().map_or_else(String::new, |place| format!(" ({place})"));
    let always = if hypothesis.throughout { " at all times" } else { "" };
    format!("“{lhs} {} {rhs}”{always}{stated}", hypothesis.relation.glyph())
}
