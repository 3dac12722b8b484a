//! Formulas that are always 0, whatever moves: `\vec r \times \vec r`, where a dot was lost.
//!
//! An equation that sets the time derivative of such a formula to 0 is true and says nothing.

use crate::Result;
use crate::formula::{Expr, Node, Relation};

use crate::check::model::claim::{Link, is_equality};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;

/// Whether a formula that is not printed as 0 is 0 at all states, on shell or not.
///
/// # Errors
/// If the mass matrix of the system is singular.
pub(crate) fn is_always_zero(expr: &Expr, context: &Context<'_>) -> Result<bool> {
    if expr.is_null() {
        return Ok(false);
    }
    let context = &Context { hypotheses: &[], local: &[], ..*context };
    let free = crate::formula::shape::bind(expr.clone(), &context.model.symbols).map(|(_, found)| found.free);
    let zero = Expr::integer(0, expr.span);
    let link = Link { lhs: expr.clone(), relation: Relation::Equal, rhs: zero, free: free.unwrap_or_default() };
    let states = context.ensemble(context.mode(false, &[expr]), false, context.options.points)?;
    Ok(run(&link, &states.states).is_ok_and(|found| found.failure.is_none() && found.points > 0))
}

/// Whether a link sets the time derivative of an always-zero formula to 0.
///
/// # Errors
/// As [`is_always_zero`].
pub(crate) fn is_its_rate(link: &Link, context: &Context<'_>) -> Result<bool> {
    let rate = match (link.lhs.is_null(), link.rhs.is_null()) {
        (true, false) => &link.rhs,
        (false, true) => &link.lhs,
        _ => return Ok(false),
    };
    let differentiated = match &rate.node {
        Node::TimeDerivative(_, inner) => inner.as_ref().clone(),
        Node::Symbol { id, indices, dots: 1.. } => {
            Expr::new(Node::Symbol { id: *id, indices: indices.clone(), dots: 0 }, rate.span)
        }
        _ => return Ok(false),
    };
    Ok(is_equality(link.relation) && is_always_zero(&differentiated, context)?)
}
