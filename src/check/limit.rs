//! Claims that hold in a limit: `A ≈ B` as x → a.
//!
//! The ratio of the sides must tend to 1, or the difference to 0 where the right side is finite and its limit is zero,
//! and at a rate: the error is followed over several steps towards the limit and must fall as a power, which is
//! reported. Steps at which rounding would drown the error are not used.

use std::sync::Arc;

use crate::Result;
use crate::formula::SymbolId;
use crate::formula::Value;
use crate::formula::evaluate::Unavailable;
use crate::scalar::{Measured, Series};

use super::base::slots;
use super::identity::{Context, FEWEST, counterexample};
use super::judge::{Failure, Link};
use super::rules::Rule;
use super::scene::{Mode, Scene};
use super::twins::{Slip, twins};
use super::verdict::{Finding, Verdict};

/// Where a limit goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Towards {
    /// `\infty`, `+\infty`
    Infinity,
    /// `-\infty`
    MinusInfinity,
    /// A number.
    Number(f64),
}

impl Towards {
    /// The k-th step towards the limit.
    pub fn step(self, k: i32) -> f64 {
        let far = 16.0 * 2f64.powi(k);
        match self {
            Towards::Infinity => far,
            Towards::MinusInfinity => -far,
            Towards::Number(a) => a + 1.0 / far,
        }
    }
}

/// How the two sides of a claim approach each other at one state.
enum Approach {
    /// The error falls as this power of the distance from the limit.
    Power(f64),
    /// It does not fall.
    Fails(Failure),
    /// Too few steps can tell.
    Useless,
}

/// Checks a claim in the limit of one symbol: always, else on shell.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn check(link: &Link, variable: SymbolId, towards: Towards, context: &Context<'_>) -> Result<Finding> {
    let always = match context.on_shell {
        Some(on_shell) => return check_in(link, variable, towards, context, on_shell),
        None => check_in(link, variable, towards, context, false)?,
    };
    if always.verdict == Verdict::Verified || !context.model.has_motion() {
        return Ok(always);
    }
    let on_shell = check_in(link, variable, towards, context, true)?;
    Ok(if on_shell.verdict == Verdict::Verified { on_shell } else { always })
}

fn check_in(
    link: &Link,
    variable: SymbolId,
    towards: Towards,
    context: &Context<'_>,
    on_shell: bool,
) -> Result<Finding> {
    let mode = context.mode(on_shell, &[&link.lhs, &link.rhs]);
    let ensemble = context.ensemble(mode, false, context.options.points)?;
    if ensemble.scenes.is_empty() {
        return Ok(context.no_room(&ensemble));
    }
    let mut powers: Vec<f64> = Vec::new();
    let mut used: Vec<Steps<'_>> = Vec::new();
    for base in &ensemble.bases {
        let steps = Steps { context, mode, base, rules: &ensemble.rules, variable, towards };
        match steps.approach(link) {
            Ok(Approach::Power(power)) => {
                powers.push(power);
                used.push(steps);
            }
            Ok(Approach::Fails(failure)) => {
                return Ok(Finding {
                    points: powers.len() + 1,
                    tried: ensemble.tried,
                    max_residual: Some(failure.residual),
                    counterexample: steps.scene(LAST).map(|scene| counterexample(link, &scene, &failure)),
                    ..context.finding(Verdict::Refuted, "the two sides do not approach each other in this limit")
                });
            }
            Ok(Approach::Useless) => {}
            Err(reason) => return Ok(context.unavailable(&reason)),
        }
    }
    if powers.len() < FEWEST.min(context.options.points) {
        let message = format!("only {} of {} states reach the limit", powers.len(), ensemble.tried);
        return Ok(context.finding(Verdict::Undecided, message));
    }
    // Each printed term must earn its place: without it, or with a slip in it, the right side must be farther off.
    // On the left, terms that the limit drops may be anything; there only symbols must be told apart.
    for twin in twins(link, context.model) {
        if twin.link.rhs == link.rhs && twin.slip != Slip::Symbol {
            continue;
        }
        let as_near = used.iter().zip(&powers).all(
            |(steps, power)| matches!(steps.approach(&twin.link), Ok(Approach::Power(other)) if other > power - 0.5),
        );
        if as_near {
            let message = format!("these states cannot tell it from the same claim with {}", twin.change);
            return Ok(context.finding(Verdict::Undecided, message));
        }
    }
    let slowest = powers.iter().copied().fold(f64::INFINITY, f64::min);
    let name = crate::formula::text::plain(&context.model.name(variable));
    let distance = match towards {
        Towards::Number(_) => "of the distance from the limit".to_owned(),
        _ => format!("of 1/{name}"),
    };
    Ok(Finding {
        points: powers.len(),
        tried: ensemble.tried,
        ..context.verified(
            format!("holds in the limit; the relative error falls as the power {slowest:.1} {distance}"),
            "a limit",
        )
    })
}

/// The last step that is taken.
const LAST: i32 = 10;

/// The states on the way to a limit: one base, with the variable moved.
struct Steps<'a> {
    context: &'a Context<'a>,
    mode: Mode,
    base: &'a [f64],
    rules: &'a Arc<[Rule]>,
    variable: SymbolId,
    towards: Towards,
}

impl<'a> Steps<'a> {
    /// The state at the k-th step: a number of the base is moved there, anything else is given that value.
    fn scene(&self, k: i32) -> Option<Scene<'a, Measured>> {
        let x = self.towards.step(k);
        let model = self.context.model;
        let slot =
            slots(model, self.mode).iter().position(|slot| slot.symbol == Some(self.variable) && slot.order == 0);
        let mut base: Vec<Measured> = self.base.iter().map(|x| Measured::new(*x)).collect();
        if let Some(slot) = slot {
            base[slot] = Measured::new(x);
        }
        let mut scene = Scene::new(model, self.mode, &base, self.rules).ok()?;
        if slot.is_none() {
            scene.set_only(&[(self.variable, Series::constant(Measured::new(x)))]);
        }
        Some(scene)
    }

    fn approach(&self, link: &Link) -> Result<Approach, Unavailable> {
        let mut errors: Vec<f64> = Vec::new();
        let mut last = None;
        for k in 0..=LAST {
            let Some(scene) = self.scene(k) else { continue };
            let (Value::Scalar(a), Value::Scalar(b)) = (scene.now(&link.lhs, &[])?, scene.now(&link.rhs, &[])?) else {
                return Err(Unavailable::Operation("a limit of something that is no number"));
            };
            if !a.value.is_finite() || !b.value.is_finite() {
                continue;
            }
            let scale = if b.value == 0.0 { 1.0 } else { b.value.abs() };
            let error = (a.value - b.value).abs() / scale;
            let noise = 1e-13 * (a.magnitude + b.magnitude) / scale;
            last = Some(Failure { lhs: a.value, rhs: b.value, residual: error, entry: None });
            if error <= noise {
                break;
            }
            errors.push(error);
        }
        let Some(last) = last else { return Ok(Approach::Useless) };
        if errors.len() < 3 {
            // The sides are one to rounding: then they agree in the limit too.
            return Ok(if last.residual < 1e-9 { Approach::Power(f64::INFINITY) } else { Approach::Useless });
        }
        let tail = &errors[errors.len().saturating_sub(4)..];
        let power = (tail[0] / tail[tail.len() - 1]).log2() / (tail.len() - 1) as f64;
        let small = errors.last().is_some_and(|error| *error < 0.05);
        Ok(if power > 0.3 && small { Approach::Power(power) } else { Approach::Fails(last) })
    }
}
