//! The check of a claim between two formulas: always or on shell, under hypotheses.

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, Relation, text};
use crate::scalar::RunningError;

use crate::check::certificate::negligible_terms;
use crate::check::judge::at_states::{AtStates, tested_against_mutants};
use crate::check::judge::conclusion::conclude;
use crate::check::judge::difference;
use crate::check::judge::other_branches;
use crate::check::judge::trivial::trivial;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::order::derivatives;
use crate::check::sample::context::Context;
use crate::check::sample::enclosed;
use crate::check::sample::enclosed::Decision;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::outcome::Outcome;
use crate::check::sample::setting::FEWEST;
use crate::check::search::{
    boundary, branch_points, branches, double_range, family_sizes, magnitudes, proof, worst_state,
};
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::state::sampled_state::SampledState;
use crate::check::vacuity::premises::Vacuity;
use crate::check::vacuity::{forced_value, premises, zero};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Checks a claim between two formulas. If it is refuted, the finding shows the difference of the two sides.
///
/// # Errors
/// If the mass matrix of the system is singular.
pub fn check(link: &Link, context: &Context<'_>) -> Result<Finding> {
    let finding = context.for_every_function(judged(link, context)?, &[&link.lhs, &link.rhs]);
    Ok(if context.options.explain { difference::explained(link, context, finding) } else { finding })
}

fn judged(link: &Link, context: &Context<'_>) -> Result<Finding> {
    if let Some(finding) = trivial(link, context) {
        return Ok(finding);
    }
    if zero::is_its_rate(link, context)? {
        return Ok(context.finding(
            Code::SideAlwaysZero,
            Verdict::Undecided,
            "the differentiated quantity is always 0, so nothing is checked; look for a lost symbol or dot",
        ));
    }
    match (context.on_shell, context.model.has_motion()) {
        (Some(on_shell), true) => Ok(check_in(link, context, on_shell)?.0),
        (_, false) => Ok(check_in(link, context, false)?.0),
        (None, true) => {
            let (always, next) = check_in(link, context, false)?;
            if next == Next::Settled {
                return Ok(always);
            }
            let (on_shell, _) = check_in(link, context, true)?;
            Ok(match (always.verdict, on_shell.verdict) {
                (always_verdict, verdict) if always_verdict.holds() && verdict.holds() => always,
                (Verdict::Undecided, Verdict::Refuted | Verdict::Undecided) => always,
                _ => on_shell,
            })
        }
    }
}

/// The number of states at which a claim that is not certified is tested with more digits than doubles have.
const STATES_TO_ALL_DIGITS: usize = 3;

/// The finding on an equality that passed in doubles, tested with more digits.
fn to_all_digits(link: &Link, ensemble: &Ensemble<'_>, finding: Finding) -> Finding {
    if finding.verdict != Verdict::Verified {
        return finding;
    }
    for (at, state) in ensemble.states.iter().take(STATES_TO_ALL_DIGITS).enumerate() {
        let decide = if at == 0 { enclosed::decided_finely } else { enclosed::decided };
        match decide(link, state, &ensemble.projection) {
            Decision::Differ(failure) if enclosed::is_beyond_doubles(&failure) => {
                let by = failure.residual.log10().floor();
                let message = format!(
                    "the two sides differ by about 10^{by} of their size; check the digits of the printed numbers"
                );
                return Finding {
                    max_residual: Some(failure.residual),
                    counterexample: Some(counterexample(link, state, &failure)),
                    ..finding.replaced(Code::SidesDiffer, Verdict::Refuted, message)
                };
            }
            // At this state the most digits were tried.
            Decision::Absorbed if at == 0 => {
                let message = "one term is so small beside another that the two sides agree to hundreds of \
                               digits, whether they are equal or not; choose smaller numbers or ranges";
                return finding.replaced(Code::WithinRounding, Verdict::Undecided, message.to_owned());
            }
            Decision::Agree | Decision::Absorbed => {}
            // Nothing more is known than what doubles say.
            Decision::Differ(_) | Decision::Open => break,
        }
    }
    finding
}

/// Whether a claim tested off shell must be tested on shell as well.
#[derive(Clone, Copy, PartialEq)]
enum Next {
    Settled,
    OnShell,
}

/// The finding on a claim that passes without any hypothesis: 2xy + x = ∂V/∂x beside the place where both are 0.
fn without_hypotheses(link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
    if context.hypotheses.is_empty() {
        return Ok(None);
    }
    let (found, _) = check_in(link, &Context { hypotheses: &[], ..*context }, false)?;
    Ok(found
        .verdict
        .passes()
        .then(|| Finding { message: format!("{}; it also holds without its hypotheses", found.message), ..found }))
}

/// Leaves those of the states at which all defined names of a claim have a value; returns whether there are enough of them, and
/// others. A claim says nothing where a quantity that it names does not exist.
fn where_names_exist(link: &Link, ensemble: &mut Ensemble<'_>) -> bool {
    let all: Vec<bool> = ensemble.states.iter().map(|state| residual::has_its_names(link, state)).collect();
    let count = all.iter().filter(|exist| **exist).count();
    if count < FEWEST || count == all.len() {
        return false;
    }
    let mut exist = all.into_iter();
    ensemble.states.retain(|_| exist.next() == Some(true));
    true
}

/// The finding on a claim that passes where a name with a formula is positive, which says so.
fn where_positive(link: &Link, name: &Expr, context: &Context<'_>, on_shell: bool) -> Result<Option<Finding>> {
    let zero = Expr::integer(0, name.span);
    let positive = Link { lhs: name.clone(), relation: Relation::Greater, rhs: zero, free: Vec::new() };
    let mut hypotheses = context.hypotheses.to_vec();
    hypotheses.push(Hypothesis::of(positive, false));
    let (found, _) = check_in(link, &Context { hypotheses: &hypotheses, ..*context }, on_shell)?;
    let name = text::formula(name, &context.model.symbols);
    let message = format!("holds where {name} > 0; where {name} < 0, the other sign of a root is meant");
    Ok(found.verdict.holds().then_some(Finding { message, ..found }))
}

/// How many times as many states are drawn where the names of a claim seldom have a value.
const MORE: usize = 8;

/// Checks a claim at states on shell or off shell.
fn check_in(link: &Link, context: &Context<'_>, on_shell: bool) -> Result<(Finding, Next)> {
    let mode = context.mode(on_shell, &[&link.lhs, &link.rhs]);
    let mut ensemble = context.ensemble(mode, false, context.options.points)?;
    if ensemble.states.is_empty() {
        return Ok((context.no_state(&ensemble), Next::Settled));
    }
    let forced = forced_value::of_claim(link, context, &ensemble);
    if !is_equality(link.relation) {
        add_special_states(link, context, on_shell, &mut ensemble)?;
    }
    double_range::within_doubles(link, context, &mut ensemble)?;
    let fails = |state: &SampledState<'_, RunningError>| matches!(residual::test(link, state), Ok(Point::Fails(_)));
    // Where a claim fails at typical states, a special case of its hypotheses, with a common factor 0, says no more.
    if !ensemble.states.iter().any(fails) {
        ensemble.states.extend(branches::states(context, &ensemble).into_iter().filter(fails));
    }
    let tested = tested_where_defined(link, context, &mut ensemble)?;
    let states = AtStates::new(link, &ensemble.states);
    let outcome = match tested {
        Ok(outcome) => outcome,
        Err(reason) => {
            let found = context.unavailable_at(&[&link.lhs, &link.rhs], ensemble.states.first(), &reason);
            return Ok((found, Next::Settled));
        }
    };
    let mut finding = conclude(&states, context, &ensemble, &outcome);
    if finding.verdict == Verdict::Refuted && is_equality(link.relation) {
        let (found, name) = other_branches::on_another_branch(link, context, &ensemble, finding);
        if let Some(name) = name.filter(|_| !context.options.deduction)
            && let Some(found) = where_positive(link, &name, context, on_shell)?
        {
            return Ok((found, Next::Settled));
        }
        finding = found;
    }
    // An inequality that holds off shell is tested on shell as well, since it may fail on the motions only.
    let open = outcome.failure.is_some() || outcome.doubtful > 0 || !is_equality(link.relation);
    let next = if open { Next::OnShell } else { Next::Settled };
    if let (Verdict::Verified, Some(symbol)) = (finding.verdict, forced) {
        let message = forced_value::message(symbol, context);
        return Ok((finding.replaced(Code::ForcedValue, Verdict::Undecided, message), next));
    }
    // A mutant of an inequality may be true as well, so only an equality is compared with its mutants.
    if finding.verdict != Verdict::Verified {
        return Ok((finding, next));
    }
    if !is_equality(link.relation) {
        return Ok((inequality_that_holds(link, context, &ensemble, finding)?, next));
    }
    drop(states);
    equality_that_holds(link, context, ensemble, finding)
}

/// Adds states at which an inequality is likely to fail: special ones, and those at its boundary.
fn add_special_states<'m>(
    link: &Link,
    context: &Context<'m>,
    on_shell: bool,
    ensemble: &mut Ensemble<'m>,
) -> Result<()> {
    let special = context.special(ensemble.mode)?;
    ensemble.tried += special.tried;
    // Off shell the boundary of a formula of drawn numbers has been tested already.
    let plain = |expr: &Expr| context.model.is_plain(expr) && derivatives(expr, context.model) == 0;
    if !on_shell || !plain(&link.lhs) || !plain(&link.rhs) {
        let own: Vec<_> = boundary::of_link(link).into_iter().collect();
        let of_claim = own.len();
        let all: Vec<_> =
            own.into_iter().chain(context.hypotheses.iter().filter_map(boundary::of_hypothesis)).collect();
        let edges = boundary::states((&all, of_claim), context, ensemble, &special)?;
        ensemble.tried += edges.len();
        ensemble.states.extend(edges);
    }
    ensemble.states.extend(special.states);
    double_range::without_rounded_equalities(link, context, ensemble);
    Ok(())
}

/// The outcome of a claim at the states. Where only one side has a value at some of them, those remain at which all of its names
/// have one.
fn tested_where_defined<'m>(
    link: &Link,
    context: &Context<'m>,
    ensemble: &mut Ensemble<'m>,
) -> Result<std::result::Result<Outcome, Unavailable>> {
    let tested = AtStates::new(link, &ensemble.states).run(&ensemble.projection);
    if !tested.as_ref().is_ok_and(|outcome| outcome.one_sided.is_some()) {
        return Ok(tested);
    }
    if ensemble.states.iter().filter(|state| residual::has_its_names(link, state)).count() < FEWEST {
        // Where names seldom have a value, such as roots of a condition that the prose states, more states are drawn.
        let more = context.ensemble(ensemble.mode, false, MORE * context.options.points)?;
        ensemble.tried += more.tried;
        ensemble.states.extend(more.states.into_iter().filter(|state| residual::has_its_names(link, state)));
    }
    Ok(match where_names_exist(link, ensemble) {
        true => AtStates::new(link, &ensemble.states).run(&ensemble.projection),
        false => tested,
    })
}

/// The finding on an inequality that holds at the states, after a search for one at which it fails.
fn inequality_that_holds(
    link: &Link,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    finding: Finding,
) -> Result<Finding> {
    let reason = "an inequality, because only an equality can have a certificate".to_owned();
    let finding = Finding { not_certified_because: Some(reason), ..finding };
    let finding = family_sizes::at_other_sizes(link, context, ensemble.mode, finding)?;
    let finding = worst_state::at_worst_state(link, context, ensemble, finding);
    Ok(proof::by_subdivision(link, context, ensemble, finding))
}

/// The finding on an equality that holds at the states: whether it says something, whether its mutants fail, and whether it holds
/// exactly, at other magnitudes, and on the other side of its branch points.
fn equality_that_holds(
    link: &Link,
    context: &Context<'_>,
    mut ensemble: Ensemble<'_>,
    finding: Finding,
) -> Result<(Finding, Next)> {
    let on_shell = ensemble.mode.on_shell;
    let withheld =
        |code, message: String| Ok((finding.clone().replaced(code, Verdict::Undecided, message), Next::Settled));
    if let Some(term) = negligible_terms::of_claim(link, &ensemble.states) {
        return withheld(Code::TermTooSmall, negligible_terms::message(&term));
    }
    let special = on_shell || !context.hypotheses.is_empty();
    if special && premises::vanishes_throughout(link, &ensemble.states) {
        if context.options.deduction {
            return Ok((finding, Next::Settled));
        }
        if let Some(without) = without_hypotheses(link, context)? {
            return Ok((without, Next::Settled));
        }
        let place = if on_shell { "on shell" } else { "under its hypotheses" };
        let message = format!(
            "both sides are 0 {place}, so a wrong factor would not be noticed; to claim that each side is 0, add \"also equals\": \"0\""
        );
        return withheld(Code::SideAlwaysZero, message);
    }
    let vacuity = if context.options.deduction { Vacuity::None } else { premises::vacuity(link, context, on_shell)? };
    if let Vacuity::Vacuous(code, reason) = vacuity {
        return withheld(code, reason.to_owned());
    }
    let states = AtStates::new(link, &ensemble.states);
    let mut finding = tested_against_mutants(&states, context, ensemble.mode, finding)?;
    if finding.verdict == Verdict::Verified {
        if on_shell && let Some(combination) = premises::combination(link, context)? {
            finding.message.push_str(&format!(": it is {combination}"));
        }
        if let Vacuity::FollowsFromHypotheses = vacuity {
            finding.message.push_str("; it follows from its hypotheses, whatever the motion");
        }
        let unneeded =
            if context.options.deduction { Vec::new() } else { premises::unneeded(link, context, on_shell)? };
        if !unneeded.is_empty() {
            finding.message.push_str(&format!("; it also holds without {}", unneeded.join(", ")));
        }
        drop(states);
        finding = family_sizes::certified(link, context, &ensemble, finding)?;
        finding = family_sizes::at_other_sizes(link, context, ensemble.mode, finding)?;
        finding = magnitudes::at_all_magnitudes(link, context, ensemble.mode, finding)?;
        finding = branch_points::on_both_sides(link, context, &mut ensemble, finding);
        finding = to_all_digits(link, &ensemble, finding);
    }
    let next = if finding.verdict == Verdict::Refuted { Next::OnShell } else { Next::Settled };
    Ok((finding, next))
}
