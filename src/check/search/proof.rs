//! The proof of an inequality by dividing the declared ranges, or a narrow place where it fails.
//!
//! The difference of the sides is bounded by interval arithmetic over all ranges, then over halves of them, until it is
//! nowhere of the wrong sign, or the budget is used. Where that does not settle it, the difference is followed downhill
//! from sampled states ([`super::dips`]): a dip that is narrow is met by no random state.

use crate::code::Code;
use crate::formula::{Relation, Value};
use crate::scalar::Interval;

use crate::check::model::claim::Link;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::contains;
use crate::check::search::dips;
use crate::check::search::interval_bounds::{Least, Ranges};
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual::Failure;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The largest number of parts into which the ranges are divided.
const PARTS: usize = 3000;

/// The number of states from which the difference is followed downhill.
const DESCENTS: usize = 8;

/// The finding on an inequality that passed: proved, refuted at a narrow place, or as it was, with what was searched.
pub(crate) fn by_subdivision(link: &Link, context: &Context<'_>, ensemble: &Ensemble<'_>, finding: Finding) -> Finding {
    if finding.verdict != Verdict::Verified {
        return finding;
    }
    let open = |finding: Finding| {
        let message = format!("{}; a search found no counterexample, but this is not a proof", finding.message);
        Finding { message, ..finding }
    };
    let is_strict = matches!(link.relation, Relation::Less | Relation::Greater);
    let rises = match link.relation {
        Relation::Less | Relation::LessEqual => true,
        Relation::Greater | Relation::GreaterEqual => false,
        _ => return open(finding),
    };
    let found = {
        let Some(ranges) =
            Ranges::of(&[&link.lhs, &link.rhs], context.model, &ensemble.projection).filter(|_| link.free.is_empty())
        else {
            return open(finding);
        };
        let side = |side, values: &[Interval]| ranges.bounds(side, values).unwrap_or(Interval::ALL);
        let margin = |values: &[Interval]| {
            let (a, b) = (side(&link.lhs, values), side(&link.rhs, values));
            if rises { b.minus(a) } else { a.minus(b) }
        };
        let mut places = Vec::new();
        match ranges.least(&margin, is_strict, PARTS, &mut |_: &[f64]| true) {
            Least::Proved => {
                let message =
                    format!("{}; proved for all values in the ranges by interval arithmetic", finding.message);
                return Finding { message, ..finding };
            }
            Least::Below(values) => places.extend(ensemble.bases.first().map(|base| ranges.moved(base, &values))),
            Least::Open => {}
        }
        let at = |values: &[f64]| margin(&values.iter().map(|x| Interval::point(*x)).collect::<Vec<_>>());
        for base in ensemble.bases.iter().take(DESCENTS) {
            let start = ranges.unknowns.iter().map(|unknown| base[unknown.slot]).collect();
            places.extend(dips::below_zero(&at, &ranges, start).map(|values| ranges.moved(base, &values)));
        }
        places
    };
    let mut projection = Projection::new(context.model, &context.setting(ensemble.mode));
    let refuted = found.into_iter().find_map(|base| {
        let in_range = projection.slots.iter().zip(&base).all(|(slot, x)| contains(&slot.range, *x));
        // A place that obeys all hypotheses as it is: only there the bounds are those of the claim.
        let (_, state) = projection.project(base.clone()).ok()?.filter(|(moved, _)| in_range && *moved == base)?;
        let (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) = (state.now(&link.lhs, &[]), state.now(&link.rhs, &[]))
        else {
            return None;
        };
        let residual = (a.value - b.value).abs() / (a.value.abs() + b.value.abs()).max(f64::MIN_POSITIVE);
        let failure = Failure { lhs: a.value, rhs: b.value, residual, entry: None };
        Some((counterexample(link, &state, &failure), residual))
    });
    match refuted {
        Some((counterexample, residual)) => Finding {
            points: finding.points,
            tried: finding.tried,
            max_residual: Some(residual),
            counterexample: Some(counterexample),
            ..context.finding(
                Code::InequalityFails,
                Verdict::Refuted,
                format!("“{}” is false in a narrow range of values, which a search found", link.relation.glyph()),
            )
        },
        None => open(finding),
    }
}
