//! Claims that hold exactly when something else does: both where it holds and where it does not.

use crate::Result;
use crate::formula::text;

use super::ensemble::Condition;
use super::identity::{Context, FEWEST, counterexample};
use super::judge::{self, Link, Point};
use super::scene::Scene;
use super::verdict::{Finding, Verdict};
use crate::scalar::Measured;

/// Checks that `link` holds where one of the alternatives does, all conditions of it, and nowhere else.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn check(link: &Link, alternatives: &[Vec<Condition>], context: &Context<'_>) -> Result<Finding> {
    let conditions: Vec<&Condition> = alternatives.iter().flatten().collect();
    let formulas = [&link.lhs, &link.rhs].into_iter().chain(conditions.iter().flat_map(|c| [&c.lhs, &c.rhs]));
    let formulas: Vec<_> = formulas.collect();
    let mode = context.mode(context.on_shell.unwrap_or(context.model.has_motion()), &formulas);
    let mut scenes = context.ensemble(mode, false, 2 * context.options.points)?.scenes;
    scenes.extend(context.special(mode)?.scenes);
    let holds = |link: &Link, scene: &Scene<'_, Measured>| match judge::test(link, scene) {
        Ok(Point::Holds(_)) => Some(true),
        Ok(Point::Fails(_)) => Some(false),
        _ => None,
    };
    let (mut both, mut neither, mut other) = (0, 0, 0);
    for scene in &scenes {
        let met = |condition: &Condition| {
            let Condition { lhs, relation, rhs, free, .. } = condition.clone();
            holds(&Link { lhs, relation, rhs, free }, scene)
        };
        let alternative = |all: &Vec<Condition>| all.iter().map(met).try_fold(true, |so_far, met| Some(so_far && met?));
        let any = alternatives.iter().map(alternative).try_fold(false, |so_far, met| Some(so_far || met?));
        match (holds(link, scene), any) {
            (Some(true), Some(true)) => both += 1,
            (Some(false), Some(false)) => neither += 1,
            (Some(claim), Some(_)) => {
                let relation = text_of(link, context);
                let message = match claim {
                    true => format!("“{relation}” holds here, and none of the conditions does"),
                    false => format!("“{relation}” fails here, though the conditions hold"),
                };
                let failure = match judge::test(link, scene) {
                    Ok(Point::Fails(failure)) => failure,
                    _ => judge::Failure { lhs: f64::NAN, rhs: f64::NAN, residual: 1.0, entry: None },
                };
                return Ok(Finding {
                    points: both + neither + 1,
                    tried: scenes.len(),
                    counterexample: Some(counterexample(link, scene, &failure)),
                    ..context.finding(Verdict::Refuted, message)
                });
            }
            _ => other += 1,
        }
    }
    if both < FEWEST / 2 || neither < FEWEST / 2 || both + neither < other {
        let message = format!("{both} states where it holds and {neither} where it does not are too few");
        return Ok(context.finding(Verdict::Undecided, message));
    }
    let message = format!("holds at {both} states, and at none of the {neither} others, as the conditions say");
    Ok(Finding { points: both + neither, tried: scenes.len(), ..context.finding(Verdict::Verified, message) })
}

fn text_of(link: &Link, context: &Context<'_>) -> String {
    let symbols = &context.model.symbols;
    format!("{} {} {}", text::formula(&link.lhs, symbols), link.relation.glyph(), text::formula(&link.rhs, symbols))
}
