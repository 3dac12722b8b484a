//! Integrals as limits of sums: a body cut into ever finer cells, against a cubature of the same body.
//!
//! The cells are particles with the mass of the density at their middle, and stand in for the family that the equation
//! for particles sums over. The difference of the sides must fall as the square of the cells' size, which is what
//! midpoints give, and not only become small.

use crate::Result;
use crate::formula::evaluate::{Unavailable, evaluate};
use crate::formula::{Expr, Node};
use crate::scalar::Measured;

use super::identity::{Context, FEWEST, counterexample};
use super::judge::{Failure, Link, pair};
use super::model::{Meaning, Model};
use super::scene::Scene;
use super::twins::twins;
use super::verdict::{Finding, Verdict};

/// Into how many cells each edge is cut.
const CUTS: [usize; 3] = [2, 3, 4];

/// The power of the cells' size with which the difference must fall at least; midpoints give the second.
const POWER: f64 = 1.5;

/// Checks that a formula with integrals is the limit of one for particles.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn check(link: &Link, context: &Context<'_>) -> Result<Finding> {
    let Some(at) = region(&link.lhs, context.model).or_else(|| region(&link.rhs, context.model)) else {
        return Ok(context.finding(Verdict::Unreadable, "there is no integral over a continuum in it"));
    };
    let mode = context.mode(false, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, FEWEST)?;
    if ensemble.scenes.is_empty() {
        return Ok(context.no_room(&ensemble));
    }
    for (tried, scene) in ensemble.scenes.iter().enumerate() {
        match approach(link, at, scene) {
            Ok((power, failure)) if power.is_nan() || power <= POWER => {
                return Ok(Finding {
                    points: tried + 1,
                    tried: tried + 1,
                    max_residual: failure.as_ref().map(|failure| failure.residual),
                    counterexample: failure.map(|failure| counterexample(link, scene, &failure)),
                    ..context.finding(Verdict::Refuted, "the sum over ever finer cells does not become the integral")
                });
            }
            Ok(_) => {}
            Err(reason) => return Ok(context.unavailable(&reason)),
        }
    }
    let wide = context.ensemble(mode, true, FEWEST)?;
    for twin in twins(link, context.model) {
        let falls = |least: f64| {
            let link = &twin.link;
            move |scene: &Scene<'_, Measured>| approach(link, at, scene).is_ok_and(|(power, _)| power > least)
        };
        // One that holds for all other bodies as well says the same.
        if ensemble.scenes.iter().all(falls(POWER)) && !wide.scenes.iter().all(falls(1.0)) {
            let message = format!("these bodies cannot tell it from the same claim with {}", twin.change);
            return Ok(context.finding(Verdict::Undecided, message));
        }
    }
    let points = ensemble.scenes.len();
    let message = "the sum over cells becomes the integral, with an error that falls as the square of their size";
    Ok(Finding { points, tried: ensemble.tried, ..context.finding(Verdict::Verified, message) })
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

/// The power of the cells' size with which the sides approach each other, infinite where they agree to rounding.
fn approach(link: &Link, at: usize, scene: &Scene<'_, Measured>) -> Result<(f64, Option<Failure>), Unavailable> {
    let mut errors = Vec::new();
    let mut last = None;
    let mut noise = 0.0_f64;
    for k in CUTS {
        scene.populate(scene.cut(at, k)?);
        let sides = evaluate(&link.lhs, scene, &[]).and_then(|lhs| Ok((lhs, evaluate(&link.rhs, scene, &[])?)));
        scene.depopulate();
        let (lhs, rhs) = sides?;
        let (lhs, rhs) = pair(lhs, rhs);
        let mut error = 0.0_f64;
        for (a, b) in lhs.into_iter().zip(rhs) {
            let difference = (a.value - b.value).abs();
            if difference.is_nan() {
                let failure = Failure { lhs: a.value, rhs: b.value, residual: f64::INFINITY, entry: None };
                return Ok((0.0, Some(failure)));
            }
            if difference >= error {
                let residual = difference / (a.magnitude + b.magnitude);
                last = Some(Failure { lhs: a.value, rhs: b.value, residual, entry: None });
            }
            error += difference * difference;
            noise = noise.max(1e-13 * (a.magnitude + b.magnitude));
        }
        errors.push(error.sqrt());
    }
    if errors.iter().all(|error| *error <= noise) {
        return Ok((f64::INFINITY, last));
    }
    let power = |i: usize| (errors[i] / errors[i + 1]).ln() / (CUTS[i + 1] as f64 / CUTS[i] as f64).ln();
    Ok((power(0).min(power(1)), last))
}
