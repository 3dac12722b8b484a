//! Noether's charge of a symmetry that the claims file gives.
//!
//! For a change δq of the coordinates with δL = dF/dt the charge is Q = Σ ∂L/∂q̇ δq − F. Then dQ/dt = Σ (d/dt ∂L/∂q̇ − ∂L/∂q) δq
//! whatever the motion, and only then. So this one identity decides both that the change is a symmetry and that Q is its charge,
//! up to a constant, and F need not be found. On shell its right side is 0, so Q is constant.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, SymbolId, text};

use super::expressions::{equal, euler_lagrange, lagrangian, product, rate, sum};
use crate::check::judge::identity;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Checks that `charge` is Noether's charge of a change of the coordinates.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn check(charge: &Expr, change: &[(SymbolId, Expr)], context: &Context<'_>) -> Result<Finding> {
    let undecided = |message: String| Ok(context.finding(Code::NotSupported, Verdict::Undecided, message));
    let Some(lagrangian) = lagrangian(context) else {
        return undecided(
            "a symmetry needs a Lagrangian that the notes define; write \"means\": { \"L\": \"Lagrangian\" }"
                .to_owned(),
        );
    };
    let mut terms = Vec::new();
    for (q, change) in change {
        if !context.model.coordinates.iter().any(|coordinate| coordinate.symbol == *q) {
            let name = text::plain(&context.model.name(*q));
            return undecided(format!("{name} is not a coordinate, so it has no change under a symmetry"));
        }
        let Some(expression) = euler_lagrange(&lagrangian, *q, context) else {
            let name = text::plain(&context.model.name(*q));
            return undecided(format!(
                "the Euler–Lagrange equation for {name} cannot be written as a formula; \
                 write the Lagrangian with sums, products, powers and elementary functions"
            ));
        };
        terms.push(product(vec![expression, change.clone()]));
    }
    let mut link = equal(&rate(charge.clone()), &sum(terms));
    link.lhs.span = charge.span;
    let found = identity::check(&link, &Context { on_shell: Some(false), ..*context })?;
    let message = match found.verdict {
        verdict if verdict.holds() => {
            "this is the charge of this symmetry by Noether's theorem, and so constant on shell"
        }
        Verdict::Refuted => {
            "this is not the Noether charge of this symmetry: its time derivative (left side below) is not \
             Σ (d/dt ∂L/∂q̇ − ∂L/∂q) δq (right side below); either L does not have this symmetry, or the charge is wrong"
        }
        _ => return Ok(found),
    };
    Ok(Finding { message: message.to_owned(), ..found })
}
