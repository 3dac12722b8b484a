//! The finding on a claim from its outcome at all states.

use crate::code::Code;
use crate::formula::{Expr, Node, Relation, text};

use crate::check::judge::at_states::AtStates;
use crate::check::judge::mutants::{Mutant, mutants_of};
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Law, Link};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::outcome::Outcome;
use crate::check::sample::setting::FEWEST;
use crate::check::sample::without_value;
use crate::check::state::counterexample::{are_equal, counterexample};
use crate::check::state::residual::{Failure, Point};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The most characters of an inequality that is quoted.
const LONGEST: usize = 60;

/// The finding on a claim: a failure first, then sides that are not both defined, then too little evidence.
pub(crate) fn conclude(
    states: &AtStates<'_, '_>,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    outcome: &Outcome,
) -> Finding {
    let link = states.link;
    let evidence = |code, verdict, message: String| Finding {
        points: outcome.points,
        tried: ensemble.tried,
        max_residual: (outcome.points > 0).then_some(outcome.residual),
        ..context.finding(code, verdict, message)
    };
    if let Some((failure, at)) = &outcome.failure {
        let (code, message) = refutation(link, failure, context, ensemble.mode.on_shell);
        let mut finding = evidence(code, Verdict::Refuted, message);
        finding.max_residual = Some(failure.residual);
        finding.counterexample = Some(counterexample(link, &ensemble.states[*at], failure));
        if let Some(mutant) = context.options.explain.then(|| surviving_mutant(states, context.model)).flatten() {
            finding.would_hold_with(&mutant.change);
        }
        return finding;
    }
    let may_be_one_sided = context.options.deduction && outcome.points >= FEWEST;
    if let (Some((failure, at)), true) = (&outcome.one_sided, outcome.points > 0 && !may_be_one_sided) {
        let mut finding = evidence(Code::DomainDiffers, Verdict::Domain, failure.domain_message());
        finding.counterexample = Some(counterexample(link, &ensemble.states[*at], failure));
        return finding;
    }
    if outcome.doubtful > 0 {
        let message = format!(
            "at {} of {} sampled states the two sides differ by more than rounding error, but too little to call it a \
             difference; choose ranges in which the terms are of similar size",
            outcome.doubtful, ensemble.tried
        );
        return evidence(Code::WithinRounding, Verdict::Undecided, message);
    }
    if outcome.points < FEWEST.min(context.options.points) {
        let counts = (outcome.points, ensemble.tried);
        let message = match [&link.lhs, &link.rhs].iter().any(|side| has_quadrature(side, context.model)) {
            true => format!(
                "only {} of {} sampled states gave a number; at the others an integral could not be computed, perhaps \
                 because it diverges",
                counts.0, counts.1
            ),
            false => {
                let part = without_value::part(&[&link.lhs, &link.rhs], &ensemble.states);
                without_value::message(counts, part.as_ref(), context.model)
            }
        };
        return evidence(Code::TooFewStates, Verdict::Undecided, message);
    }
    evidence(Code::Holds, Verdict::Verified, confirmation(context, ensemble.mode.on_shell))
}

/// Whether a formula, or one that defines a name in it, has an integral without a known antiderivative.
fn has_quadrature(formula: &Expr, model: &Model) -> bool {
    let (mut waiting, mut seen) = (vec![formula], Vec::new());
    let mut found = false;
    while let Some(next) = waiting.pop() {
        next.walk(&mut |part| found |= matches!(part.node, Node::Definite(_)));
        for (id, _) in next.symbols() {
            if let Some(Meaning::Defined(inner)) = model.meaning(id)
                && !seen.contains(&id)
            {
                seen.push(id);
                waiting.push(inner);
            }
        }
    }
    found
}

/// The code and the message of a claim that fails, with the entry at which it fails if it has several.
fn refutation(link: &Link, failure: &Failure, context: &Context<'_>, on_shell: bool) -> (Code, String) {
    let entry = failure.entry.as_deref();
    let laws = Law::phrases(&context.model.laws);
    // What follows from the meaning of a name, or is a premise, is no hypothesis of the claim.
    let is_stated = |known: &Hypothesis| known.stated.is_some() && !known.implied;
    let has_hypotheses =
        !context.options.deduction && (context.hypotheses.iter().any(is_stated) || !context.local.is_empty());
    let circumstances = match (on_shell, laws.is_empty(), has_hypotheses) {
        (false, _, false) => String::new(),
        (false, _, true) => " under its hypotheses".to_owned(),
        (true, true, false) => " on shell".to_owned(),
        (true, true, true) => " on shell, under its hypotheses".to_owned(),
        (true, false, false) => format!(" at a state that obeys {laws}"),
        (true, false, true) => format!(" at a state that obeys {laws} and its hypotheses"),
    };
    if !matches!(link.relation, Relation::Equal | Relation::Identical) {
        let at = entry.map_or_else(String::new, |entry| format!(", at {entry}"));
        let symbols = &context.model.symbols;
        let (left, right) = (text::formula(&link.lhs, symbols), text::formula(&link.rhs, symbols));
        let shown = match left.chars().count() + right.chars().count() > LONGEST {
            true => format!("this “{}”", link.relation.glyph()),
            false => format!("{left} {} {right}", link.relation.glyph()),
        };
        let way_out = match link.relation {
            _ if failure.lhs != failure.rhs && !are_equal(link, failure) => "",
            Relation::Less => "; the two sides are equal there: write ≤, or exclude this state with \"assume\"",
            Relation::Greater => "; the two sides are equal there: write ≥, or exclude this state with \"assume\"",
            Relation::NotEqual => "; the two sides are equal there: exclude this state with \"assume\"",
            _ => "",
        };
        return (Code::InequalityFails, format!("{shown} is false{circumstances}{at}{way_out}"));
    }
    let message = match (on_shell && !laws.is_empty(), entry) {
        (true, entry) => {
            let hypotheses = if has_hypotheses { " under its hypotheses" } else { "" };
            let at = entry.map_or_else(String::new, |entry| format!(": the two sides differ at {entry}"));
            format!("this does not follow from {laws}{hypotheses}{at}")
        }
        (false, Some(part)) if circumstances.is_empty() && part.ends_with(" part") => {
            format!("the two sides differ in the {part}")
        }
        (false, Some(entry)) if circumstances.is_empty() => format!("the two sides differ at {entry}"),
        (false, Some(entry)) => format!("the two sides differ{circumstances}, at {entry}"),
        (false, None) => format!("the two sides differ{circumstances}"),
    };
    (Code::SidesDiffer, message)
}

/// The message of a claim that holds.
fn confirmation(context: &Context<'_>, on_shell: bool) -> String {
    let place = match (on_shell, context.model.laws.as_slice()) {
        (false, _) if context.has_hypotheses() => return "holds under its hypotheses".to_owned(),
        (false, _) => return "holds always".to_owned(),
        (true, []) => "on shell".to_owned(),
        (true, laws) => format!("by {}", Law::phrases(laws)),
    };
    let hypotheses = if context.has_hypotheses() { ", under its hypotheses" } else { "" };
    format!("holds {place}{hypotheses}")
}

/// The first mutant of a refuted claim that holds at all states: what may have been meant.
fn surviving_mutant(states: &AtStates<'_, '_>, model: &Model) -> Option<Mutant> {
    let count = states.states.len();
    mutants_of(states.link, model).into_iter().find(|mutant| {
        let mut points = 0;
        let clean = (0..count).all(|at| match states.test(&mutant.link, at) {
            Ok(Point::Holds(_)) => {
                points += 1;
                true
            }
            Ok(Point::Useless) => true,
            _ => false,
        });
        clean && points >= FEWEST.min(count)
    })
}
