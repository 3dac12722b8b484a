//! Integrals as limits of sums: a body cut into smaller and smaller cells, compared with quadrature over the same body.
//!
//! Each cell is a particle with the mass of its volume at its midpoint, and the particles are the family that the equation
//! for particles sums over. The error of the midpoint rule is a series in the square of the cell size. So the difference of
//! the sides is extrapolated from a few cuts to vanishing cells (Richardson), and must vanish there.

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, Node, text};
use crate::scalar::RunningError;

use crate::check::judge::mutants::mutants_of;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::setting::FEWEST;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual::{Failure, pair};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The numbers of cells along each edge.
const CUTS: [usize; 3] = [2, 3, 4];

/// The largest extrapolated difference that counts as zero, relative to the largest difference of the cuts.
const LEFT: f64 = 0.02;

/// Checks that a formula with integrals is the limit of one for particles.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(link: &Link, context: &Context<'_>) -> Result<Finding> {
    let Some(at) = region(&link.lhs, context.model).or_else(|| region(&link.rhs, context.model)) else {
        return Ok(context.finding(
            Code::ClaimDoesNotFit,
            Verdict::Unreadable,
            "there is no integral over a continuum here; remove \"continuum limit of\"",
        ));
    };
    if let Some(name) = link.lhs.as_plain_symbol()
        && link.rhs.symbols().iter().any(|(symbol, _)| *symbol == name)
    {
        let message = format!("{} is on both sides, so the integral does not determine it", context.model.name(name));
        return Ok(context.finding(Code::Circular, Verdict::Undecided, text::plain(&message)));
    }
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, FEWEST)?;
    if ensemble.states.is_empty() {
        return Ok(context.no_state(&ensemble));
    }
    for (tried, state) in ensemble.states.iter().enumerate() {
        match approach(link, at, state) {
            Ok((left, failure)) if left.is_nan() || left >= LEFT => {
                return Ok(Finding {
                    points: tried + 1,
                    tried: tried + 1,
                    max_residual: failure.as_ref().map(|failure| failure.residual),
                    counterexample: failure.map(|failure| counterexample(link, state, &failure)),
                    ..context.finding(
                        Code::IntegralDiffers,
                        Verdict::Refuted,
                        "the sum over smaller and smaller cells does not become the integral",
                    )
                });
            }
            Ok(_) => {}
            Err(reason) => return Ok(context.unavailable(&reason)),
        }
    }
    let wide = context.ensemble(mode, true, FEWEST)?;
    for mutant in mutants_of(link, context.model) {
        let within = |most: f64| {
            let link = &mutant.link;
            move |state: &SampledState<'_, RunningError>| approach(link, at, state).is_ok_and(|(left, _)| left < most)
        };
        // A mutant that holds for bodies from wider ranges too is equivalent.
        if ensemble.states.iter().all(within(LEFT)) && !wide.states.iter().all(within(5.0 * LEFT)) {
            let message = format!(
                "the sampled bodies do not distinguish this from the same claim with {}; widen the ranges",
                mutant.change
            );
            return Ok(context.finding(Code::MutantPasses, Verdict::Undecided, message));
        }
    }
    let points = ensemble.states.len();
    let message = "the sum over cells becomes the integral as the cells get smaller";
    Ok(Finding { points, tried: ensemble.tried, ..context.verified(message, "the limit of a sum") })
}

/// The continuum that a formula integrates over.
fn region(expr: &Expr, model: &Model) -> Option<usize> {
    let mut found = None;
    expr.walk(&mut |inner| {
        if let Node::Integral(region, _) = &inner.node
            && let Some(Meaning::Region(at)) = model.meaning(*region)
        {
            found = found.or(Some(*at));
        }
    });
    found
}

/// The difference of the sides extrapolated to vanishing cells, relative to the largest of the cuts, and that largest one.
fn approach(
    link: &Link,
    at: usize,
    state: &SampledState<'_, RunningError>,
) -> Result<(f64, Option<Failure>), Unavailable> {
    let mut largest = 0.0_f64;
    let mut failure = None;
    let mut noise = 0.0_f64;
    let mut limits: Vec<f64> = Vec::new();
    for (n, k) in CUTS.into_iter().enumerate() {
        state.substitute(Some(state.cut(at, k)?));
        let sides = state.now(&link.lhs, &[]).and_then(|lhs| Ok((lhs, state.now(&link.rhs, &[])?)));
        state.substitute(None);
        let (lhs, rhs) = sides?;
        let (lhs, rhs) = pair(lhs, rhs);
        limits.resize(lhs.len(), 0.0);
        for ((a, b), limit) in lhs.into_iter().zip(rhs).zip(&mut limits) {
            let difference = a.value - b.value;
            if difference.is_nan() {
                let failure = Failure { lhs: a.value, rhs: b.value, residual: f64::INFINITY, entry: None };
                return Ok((f64::INFINITY, Some(failure)));
            }
            if difference.abs() >= largest || n + 1 == CUTS.len() && failure.is_none() {
                let residual = difference.abs() / (a.magnitude + b.magnitude);
                failure = Some(Failure { lhs: a.value, rhs: b.value, residual, entry: None });
            }
            largest = largest.max(difference.abs());
            noise = noise.max(1e-13 * (a.magnitude + b.magnitude));
            *limit += weight(n) * difference;
        }
    }
    if largest <= noise {
        return Ok((0.0, failure));
    }
    Ok((limits.iter().fold(0.0_f64, |most, limit| most.max(limit.abs())) / largest, failure))
}

/// The weight of the n-th cut in the extrapolation: the Lagrange polynomial in the square of the cell size, at 0.
fn weight(n: usize) -> f64 {
    let square = |k: usize| 1.0 / (k * k) as f64;
    let others = CUTS.iter().enumerate().filter(|(at, _)| *at != n);
    others.map(|(_, k)| square(*k) / (square(*k) - square(CUTS[n]))).product()
}
