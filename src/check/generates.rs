//! Hamilton's equations: whether a printed function of coordinates and momenta generates the motion.
//!
//! The formula is differentiated by its coordinates and momenta, each taken as independent (by AD over the formula);
//! then q̇ = ∂H/∂p and ṗ = −∂H/∂q must be what the Lagrangian gives on shell, in numbers and over a field.

use num_dual::Dual;

use crate::Result;
use crate::formula::evaluate::{Unavailable, evaluate, evaluate_to};
use crate::formula::{Expr, SymbolId, Value, text};
use crate::scalar::field::Modulus;
use crate::scalar::{Measured, Modular, Series};

use super::certify::{self, Claim, Differences};
use super::identity::{Context, FEWEST, values};
use super::judge;
use super::model::{Meaning, Quantity};
use super::scene::Scene;
use super::verdict::{Counterexample, Finding, Verdict};

/// Checks that `hamiltonian`, a formula of coordinates and momenta, generates the motion of the world.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn check(hamiltonian: &Expr, context: &Context<'_>) -> Result<Finding> {
    let model = context.model;
    let momentum = |i: usize| {
        let is =
            |(_, m): &(usize, &Option<Meaning>)| matches!(m, Some(Meaning::World(Quantity::Momentum(k))) if *k == i);
        model.meanings.iter().enumerate().find(is).map(|(at, _)| SymbolId(at))
    };
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|v| v.symbol).collect();
    let momenta: Option<Vec<SymbolId>> = (0..coordinates.len()).map(momentum).collect();
    let (Some(momenta), Some(_)) = (momenta, &model.world) else {
        return Ok(context.finding(Verdict::Undecided, "there is no world whose motion it could generate"));
    };
    let mode = context.mode(true, &[hamiltonian]);
    let ensemble = context.ensemble(mode, false, context.options.points)?;
    if ensemble.scenes.is_empty() {
        return Ok(context.no_room(&ensemble));
    }
    let (mut points, mut worst) = (0, 0.0_f64);
    for (scene, base) in ensemble.scenes.iter().zip(&ensemble.bases) {
        let base: Vec<Dual<Measured>> = base.iter().map(|x| Dual::from_re(Measured::new(*x))).collect();
        let mut free = Scene::new(model, mode, &base, &ensemble.rules)?;
        let Some(known) = scene.quantities() else { continue };
        let point: Vec<(SymbolId, Measured)> = coordinates
            .iter()
            .zip(scene.coordinates().iter().map(Series::value))
            .chain(momenta.iter().zip(known.momenta.iter().map(Series::value)))
            .map(|(id, value)| (*id, value))
            .collect();
        for (place, (id, _)) in point.iter().enumerate() {
            let seeded: Vec<(SymbolId, Series<Dual<Measured>>)> = point
                .iter()
                .map(|(other, value)| {
                    let slope = Measured::new(if other == id { 1.0 } else { 0.0 });
                    (*other, Series::from_derivatives(&[Dual::new(*value, slope)]))
                })
                .collect();
            free.set_only(&seeded);
            let slope = match evaluate(hamiltonian, &free, &[]) {
                Ok(Value::Scalar(value)) => value.value().eps,
                Ok(_) => return Ok(context.finding(Verdict::Unreadable, "a Hamiltonian is a number")),
                Err(Unavailable::Derivative(_)) => {
                    let message = "it is not written in coordinates and momenta: it contains velocities";
                    return Ok(context.finding(Verdict::Unreadable, message));
                }
                Err(reason) => return Ok(context.unavailable(&reason)),
            };
            let n = coordinates.len();
            let (printed, derived, equation) = if place < n {
                let name = text::plain(&model.name(momenta[place]));
                (-slope, known.momenta[place].derivative().value(), format!("the rate of {name}"))
            } else {
                let i = place - n;
                let name = text::plain(&model.name(coordinates[i]));
                (slope, scene.coordinates()[i].derivative().value(), format!("the rate of {name}"))
            };
            let difference = printed - derived;
            if !printed.value.is_finite() || !derived.value.is_finite() {
                continue;
            }
            let residual = difference.value.abs() / difference.magnitude.max(f64::MIN_POSITIVE);
            if !judge::vanishes(difference) {
                let counterexample = Counterexample {
                    state: values(&[hamiltonian], scene),
                    lhs: printed.value,
                    rhs: derived.value,
                    entry: Some(equation.clone()),
                };
                return Ok(Finding {
                    points: points + 1,
                    tried: ensemble.tried,
                    max_residual: Some(residual),
                    counterexample: Some(counterexample),
                    ..context.finding(Verdict::Refuted, format!("Hamilton's equations from it do not give {equation}"))
                });
            }
            worst = worst.max(residual);
        }
        points += 1;
    }
    if points < FEWEST.min(context.options.points) {
        return Ok(context.finding(Verdict::Undecided, format!("only {points} states can tell: too few")));
    }
    let finding = Finding {
        points,
        tried: ensemble.tried,
        max_residual: Some(worst),
        ..context.finding(Verdict::Verified, "Hamilton's equations from it give the motion")
    };
    let claim = Generates { hamiltonian, coordinates: &coordinates, momenta: &momenta };
    Ok(certify::decide(&[hamiltonian], context, &ensemble, &claim).stamp(finding))
}

/// That a formula generates the motion, for a field to decide.
struct Generates<'a> {
    hamiltonian: &'a Expr,
    coordinates: &'a [SymbolId],
    momenta: &'a [SymbolId],
}

impl Claim for Generates<'_> {
    /// ∂H/∂p − q̇ and ∂H/∂q + ṗ. A series in time is a dual number as well: what the formula's rate changes by, when one
    /// symbol's rate becomes 1, is its derivative by the symbol.
    fn differences<F: Modulus>(&self, scene: &mut Scene<'_, Modular<F>>) -> Differences<F> {
        let none = "a formula without a motion";
        let momenta = scene.quantities().ok_or(none)?.momenta.clone();
        let coordinates = scene.coordinates().to_vec();
        let symbols: Vec<SymbolId> = self.coordinates.iter().chain(self.momenta).copied().collect();
        let values: Vec<Series<Modular<F>>> = coordinates.iter().chain(&momenta).copied().collect();
        let mut rate = |varied: Option<usize>| {
            let slope = |at: usize| Modular::from(if varied == Some(at) { 1.0 } else { 0.0 });
            let series = |at: usize| Series::from_derivatives(&[values[at].value(), slope(at)]);
            let point: Vec<_> = symbols.iter().enumerate().map(|(at, id)| (*id, series(at))).collect();
            scene.set_only(&point);
            let found = evaluate_to(2, self.hamiltonian, scene, &[]);
            scene.set_only(&[]);
            match found {
                Ok(Value::Scalar(value)) => value.nth_derivative_value(1).ok_or(none.to_owned()),
                _ => Err(none.to_owned()),
            }
        };
        let still = rate(None)?;
        let n = coordinates.len();
        let moved = |at: usize| values[at].derivative().value();
        let mut all = Vec::new();
        for at in 0..n {
            all.push(rate(Some(n + at))? - still - moved(at));
            all.push(rate(Some(at))? - still + moved(n + at));
        }
        Ok(all)
    }
}
