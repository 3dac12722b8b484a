//! The finding that follows from what all states say.

use crate::code::Code;
use crate::formula::Relation;

use crate::check::judge::at_states::AtStates;
use crate::check::judge::mutants::{Mutant, mutants_of};
use crate::check::model::Model;
use crate::check::model::claim::Law;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::outcome::Outcome;
use crate::check::sample::setting::FEWEST;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual::Point;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

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
    let free = context.hypotheses.is_empty() && context.local.is_empty();
    let whence = match (ensemble.mode.on_shell, free) {
        (false, true) => "always",
        (false, false) => "under its hypotheses",
        (true, true) => "on shell",
        (true, false) => "on shell, under its hypotheses",
    };
    let whence = &match (ensemble.mode.on_shell, context.model.laws.as_slice()) {
        (false, _) | (_, []) => whence.to_owned(),
        (true, laws) => {
            let names: Vec<String> = laws.iter().map(Law::title).collect();
            format!("{}, given {}", whence.replace("on shell", "by law"), names.join(", "))
        }
    };
    if let Some((failure, at)) = &outcome.failure {
        let message = match (&failure.entry, link.relation) {
            (Some(entry), _) => format!("fails {whence}, at {entry}"),
            (None, Relation::Equal | Relation::Identical) => format!("the two sides differ, {whence}"),
            (None, relation) => format!("“{}” fails, {whence}", relation.glyph()),
        };
        let mut finding = evidence(Code::SidesDiffer, Verdict::Refuted, message);
        finding.max_residual = Some(failure.residual);
        finding.counterexample = Some(counterexample(link, &ensemble.states[*at], failure));
        if let Some(mutant) = context.options.explain.then(|| meant(states, context.model)).flatten() {
            finding.message.push_str(&format!("; it would hold with {}", mutant.change));
        }
        return finding;
    }
    if let (Some((failure, at)), true) = (&outcome.one_sided, outcome.points > 0) {
        let which = if failure.lhs.is_finite() { "right" } else { "left" };
        let message = format!("agrees wherever both sides are defined, but the {which} side is not defined everywhere");
        let mut finding = evidence(Code::DomainDiffers, Verdict::Domain, message);
        finding.counterexample = Some(counterexample(link, &ensemble.states[*at], failure));
        return finding;
    }
    if outcome.doubtful > 0 {
        let message = format!(
            "at {} of {} states the sides differ by more than rounding, and too little to call it a difference",
            outcome.doubtful, ensemble.tried
        );
        return evidence(Code::NotDecided, Verdict::Undecided, message);
    }
    if outcome.points < FEWEST.min(context.options.points) {
        let message = format!("only {} of {} states can tell: too few", outcome.points, ensemble.tried);
        return evidence(Code::NotDecided, Verdict::Undecided, message);
    }
    evidence(Code::Holds, Verdict::Verified, format!("holds {whence}"))
}

/// The first mutant that holds at all states: what may have been meant.
fn meant(states: &AtStates<'_, '_>, model: &Model) -> Option<Mutant> {
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
