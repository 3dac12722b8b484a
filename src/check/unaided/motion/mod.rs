//! What other displays say of a motion: a period beside its frequency, the energies T and U beside the printed Lagrangian, and a force
//! that it does not contain.
//!
//! Without a claims file the motion is that of the printed L. Where T − U is not L, or an equation of motion has a force beside L, the
//! motion may be another one, and what does not follow from L may be right.
//!
//! Offers `weighed`, which changes the findings accordingly. Knows `gate` and `contradictions`, and `kinds` and below.

mod energies;
mod forces;
mod given;
mod periods;

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::unaided::scope::Scope;
use crate::check::verdict::report::Equation;
use crate::formula::{Expr, Relation};
use crate::source::Span;

/// The number of sampled states at which sides are compared.
const STATES: usize = 6;

/// Weighs the findings on displays about a motion.
///
/// # Errors
/// As for a check of an equation.
pub(super) fn weighed(checker: &Checker<'_>, scope: &Scope, found: &mut [Equation]) -> Result<()> {
    periods::weighed(checker, scope, found)?;
    if checker.model.printed_lagrangian.is_none() || checker.model.system.is_none() {
        return Ok(());
    }
    energies::weighed(checker, scope, found)?;
    forces::weighed(checker, scope, found)
}

/// Whether two formulas are equal in all states of the motion, on shell or for any motion.
fn are_equal(checker: &Checker<'_>, a: &Expr, b: &Expr, on_shell: bool) -> Result<bool> {
    let Ok(link) = checker.link(a, Relation::Equal, b) else { return Ok(false) };
    let context = Context {
        model: checker.model,
        options: checker.options,
        hypotheses: &[],
        on_shell: Some(on_shell),
        topic: "beside the Lagrangian",
        span: Span::default(),
        spread: Spread::Declared,
        local: &[],
    };
    let ensemble = context.ensemble(context.mode(on_shell, &[&link.lhs, &link.rhs]), false, STATES)?;
    let holds = run(&link, &ensemble.states);
    Ok(!ensemble.states.is_empty() && holds.is_ok_and(|outcome| outcome.failure.is_none() && outcome.points > 0))
}
