//! States with families of other sizes than those that are drawn first, for claims about n things.
//!
//! What a field decides is decided for as many sizes as are needed for all
//! ([`crate::check::certificate::family_growth`]).
//!
//! A claim that has no such bound, with the root of a sum or 2ⁿ in it, gets no certificate. It and all inequalities
//! are tried with 2, 5 and 7 members in doubles.

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

/// The numbers of members that are tried beside three and four, and how many states of each.
const OTHERS: [u32; 3] = [2, MANY, 7];

const MANY: u32 = 5;

const STATES: usize = 3;

/// Whether a formula speaks of families whose members are counted, or of their number.
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

/// The finding on a claim that agreed in numbers, with what a field says of it; where that finds it false for another number
/// of members, with a state of so many.
///
/// # Errors
/// When the system's mass matrix is singular at all of their states.
pub(crate) fn certified(
    link: &Link,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    finding: Finding,
) -> Result<Finding> {
    let certificate = certify(link, context, ensemble);
    if let Certificate::DiffersFor(size) = certificate {
        // Of one thing or two a reader may think that they are too few.
        for size in [MANY, size] {
            if let Some(refuted) = fails_at(link, context, ensemble.mode, (size, &finding))? {
                return Ok(refuted);
            }
        }
    }
    Ok(certificate.stamp(finding))
}

/// The finding on a claim that has passed by numbers alone, with what families of other sizes say of it.
///
/// # Errors
/// When the system's mass matrix is singular at all of their states.
pub(crate) fn at_other_sizes(link: &Link, context: &Context<'_>, mode: Mode, finding: Finding) -> Result<Finding> {
    let sides = [&link.lhs, &link.rhs];
    if finding.verdict != Verdict::Verified || !counts_members(&sides, context) {
        return Ok(finding);
    }
    let hypotheses = context.hypotheses.iter().flat_map(|hypothesis| [&hypothesis.lhs, &hypothesis.rhs]);
    let all: Vec<&Expr> = sides.into_iter().chain(hypotheses).collect();
    let named = GrowthAnalysis::new(context.model, context.local).distinguished_members(&all, &[]);
    for size in OTHERS.into_iter().filter(|size| *size >= named) {
        if let Some(refuted) = fails_at(link, context, mode, (size, &finding))? {
            return Ok(refuted);
        }
    }
    Ok(finding)
}

/// The counterexample to a claim at a number of members, if one of a few states is one.
///
/// # Errors
/// When the system's mass matrix is singular at all of them.
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

/// That a claim is false at a number of members.
fn message(model: &Model, size: u32) -> String {
    let names: Vec<String> = counts(model).iter().map(|id| text::plain(&model.name(*id))).collect();
    format!(
        "this holds for 3 and 4 members, but is false for {} = {size}; check the limits of the sums",
        names.join(" = ")
    )
}
