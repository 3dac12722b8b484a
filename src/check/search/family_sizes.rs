//! Families of other sizes than those at which states are drawn first, for claims about n members.
//!
//! Sampled states have 3 or 4 members. A prime field decides a claim at as many numbers of members as are needed to
//! decide all ([`crate::check::certificate::family_growth`]). A claim that rests on floating-point numbers, such as an
//! inequality, is tested with fewer members and with more.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, SymbolId, text};

use crate::check::certificate::claim::Certificate;
use crate::check::certificate::decide::certify;
use crate::check::certificate::family_growth::GrowthAnalysis;
use crate::check::hypotheses::rule::Action;
use crate::check::model::Model;
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::sampling::Mode;
use crate::check::model::sizes::{counts, resized};
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The numbers of members that are tried beside 3 and 4: all up to the last one here, and then some that nobody can guess.
const OTHERS: [u32; 6] = [2, MANY, 7, 6, 8, 9];

/// The numbers of members among which further ones are drawn, and how many are drawn.
const LARGE: std::ops::RangeInclusive<u32> = 10..=30;
const DRAWN: usize = 2;

/// A number of members that no reader takes to be a special case.
const MANY: u32 = 5;

/// The number of states for each number of members.
const STATES: usize = 3;

/// Whether a formula depends on families of any size, or on their number of members.
pub(crate) fn counts_members(formulas: &[&Expr], context: &Context<'_>) -> bool {
    let model = context.model;
    let counts = counts(model);
    if counts.is_empty() {
        return false;
    }
    let ids = (0..model.meanings.len()).map(SymbolId);
    let is_counted = |id: &SymbolId| {
        let slots = &model.symbols.entry(*id).slots;
        counts.contains(id) || slots.iter().any(|(_, letter)| model.symbols.indices[letter.0].count.is_some())
    };
    let counted: Vec<SymbolId> = ids.filter(is_counted).collect();
    let of_rules = context.local.iter().flat_map(|rule| match &rule.action {
        Action::Union(parts) => parts.iter().collect(),
        action => action.formulas(),
    });
    formulas.iter().copied().chain(of_rules).any(|formula| model.depends_on(formula, &counted))
}

/// The finding on a claim that passed by numbers, with the decision of a prime field. If the field shows that it is
/// false for another number of members, a counterexample of that size is sought.
///
/// # Errors
/// If the mass matrix of the system is singular at all of their states.
pub(crate) fn certified(
    link: &Link,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    finding: Finding,
) -> Result<Finding> {
    let certificate = certify(link, context, ensemble);
    if let Certificate::DiffersFor(size) = certificate {
        // A reader may take one or two members for a special case.
        for size in [MANY, size] {
            if let Some(refuted) = fails_at(link, context, ensemble.mode, (size, &finding))? {
                return Ok(refuted);
            }
        }
    }
    Ok(certificate.stamp(finding))
}

/// The finding on a claim that passed by numbers only, tested again with families of other sizes.
///
/// # Errors
/// If the mass matrix of the system is singular at all of their states.
pub(crate) fn at_other_sizes(link: &Link, context: &Context<'_>, mode: Mode, finding: Finding) -> Result<Finding> {
    let sides = [&link.lhs, &link.rhs];
    if finding.verdict != Verdict::Verified || !counts_members(&sides, context) {
        return Ok(finding);
    }
    let hypotheses = context.hypotheses.iter().flat_map(|hypothesis| [&hypothesis.lhs, &hypothesis.rhs]);
    let all: Vec<&Expr> = sides.into_iter().chain(hypotheses).collect();
    let named = GrowthAnalysis::new(context.model, context.local).distinguished_members(&all, &[]);
    let mut draw = context.draw(mode, "numbers of members");
    let large: Vec<u32> =
        (0..DRAWN).map(|_| LARGE.start() + (draw.unit() * f64::from(LARGE.end() - LARGE.start())) as u32).collect();
    let tried = || OTHERS.into_iter().chain(large.iter().copied()).filter(|size| *size >= named);
    for size in tried() {
        if let Some(refuted) = fails_at(link, context, mode, (size, &finding))? {
            return Ok(refuted);
        }
    }
    let mut sizes: Vec<u32> = tried().chain([3, 4]).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let (small, large): (Vec<u32>, Vec<u32>) = sizes.into_iter().partition(|size| *size < 10);
    let small = small.first().zip(small.last()).map(|(first, last)| format!("{first} to {last}"));
    let words: Vec<String> = small.into_iter().chain(large.iter().map(u32::to_string)).collect();
    let message = format!("{}; tried with {} members only", finding.message, words.join(", "));
    Ok(Finding { message, ..finding })
}

/// The counterexample to a claim at a number of members, among a few states.
///
/// # Errors
/// If the mass matrix of the system is singular at all of them.
fn fails_at(
    link: &Link,
    context: &Context<'_>,
    mode: Mode,
    (size, finding): (u32, &Finding),
) -> Result<Option<Finding>> {
    let model = resized(context.model, size, size);
    let context = Context { model: &model, ..*context };
    let mut draw = context.draw(mode, "other sizes");
    let mut states = Ensemble::draw(&model, &context.setting(mode), STATES, &mut draw)?;
    if !is_equality(link.relation) {
        let special = context.special(mode)?;
        states.tried += special.tried;
        states.states.extend(special.states);
    }
    let found = states.states.iter().find_map(|state| match residual::test(link, state) {
        Ok(Point::Fails(failure)) => Some((state, failure)),
        _ => None,
    });
    Ok(found.map(|(state, failure)| Finding {
        points: finding.points,
        tried: finding.tried + states.tried,
        max_residual: Some(failure.residual),
        counterexample: Some(counterexample(link, state, &failure)),
        ..context.finding(Code::FailsForFamilySize, Verdict::Refuted, message(&model, size))
    }))
}

/// The message that a claim is false at a number of members.
fn message(model: &Model, size: u32) -> String {
    let names: Vec<String> = counts(model).iter().map(|id| text::plain(&model.name(*id))).collect();
    format!(
        "this holds for 3 and 4 members, but is false for {} = {size}; check the limits of the sums",
        names.join(" = ")
    )
}
