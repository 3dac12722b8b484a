//! The other ways in which hypotheses can be met.
//!
//! xy = 0 is solved for one number, y, and so y = 0 at all states that are drawn; x = 0 obeys it as well. A claim must
//! hold there too. The states here are those at which one factor of such a hypothesis is 0, or one of its symbols.

use crate::Result;
use crate::formula::{Expr, Kind, Node, Relation};
use crate::notes::claims::Range;
use crate::scalar::Measured;

use super::draw::{Draw, contains};
use super::ensemble::{Condition, Ensemble, Setting};
use super::forced::drawn;
use super::identity::{Context, is_equality};
use super::scene::Scene;

/// So many states are drawn of each way.
const OF_EACH: usize = 3;

/// States at which the hypotheses of a claim are met in another way than where they were solved.
///
/// # Errors
/// When the mass matrix is singular at all states of one way.
pub(super) fn states<'m>(context: &Context<'m>, ensemble: &Ensemble<'m>) -> Result<Vec<Scene<'m, Measured>>> {
    let mut found = Vec::new();
    for (at, condition) in context.conditions.iter().enumerate() {
        if !is_equality(condition.relation) || !condition.free.is_empty() {
            continue;
        }
        for factor in factors(condition, context) {
            let mut conditions = context.conditions.to_vec();
            conditions[at] = zero(factor, condition.throughout);
            found.extend(drawn_under(&conditions, context, ensemble)?);
        }
        for symbol in symbols(condition, context) {
            let first = [zero(symbol, false)].into_iter();
            let conditions: Vec<Condition> = first.chain(context.conditions.iter().cloned()).collect();
            found.extend(drawn_under(&conditions, context, ensemble)?);
        }
    }
    Ok(found)
}

fn zero(expr: Expr, throughout: bool) -> Condition {
    let rhs = Expr::integer(0, expr.span);
    Condition { lhs: expr, relation: Relation::Equal, rhs, free: Vec::new(), throughout }
}

/// The factors of a product that is said to be 0, if more than one of them varies.
fn factors(condition: &Condition, context: &Context<'_>) -> Vec<Expr> {
    let product = match (&condition.lhs.node, &condition.rhs.node) {
        (Node::Product(factors), _) if condition.rhs.is_null() => factors,
        (_, Node::Product(factors)) if condition.lhs.is_null() => factors,
        _ => return Vec::new(),
    };
    let varying = product.iter().filter(|factor| !drawn(&[factor], context.model).is_empty());
    let varying: Vec<Expr> = varying.cloned().collect();
    if varying.len() > 1 { varying } else { Vec::new() }
}

/// The numbers that a hypothesis speaks of, of which it has several, and that may be 0.
fn symbols(condition: &Condition, context: &Context<'_>) -> Vec<Expr> {
    let model = context.model;
    let all = drawn(&[&condition.lhs, &condition.rhs], model);
    if all.len() < 2 {
        return Vec::new();
    }
    let may_vanish =
        |range: &Range| matches!(range, Range::Any | Range::Angle | Range::Interval { .. }) && contains(range, 0.0);
    let numbers = all.into_iter().filter(|symbol| {
        let entry = model.symbols.entry(*symbol);
        entry.kind == Kind::Scalar && entry.slots.is_empty() && may_vanish(&model.range(*symbol))
    });
    let name = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, condition.lhs.span);
    numbers.map(name).collect()
}

fn drawn_under<'m>(
    conditions: &[Condition],
    context: &Context<'m>,
    ensemble: &Ensemble<'m>,
) -> Result<Vec<Scene<'m, Measured>>> {
    let setting = Setting { conditions, local: context.local, mode: ensemble.mode, reach: context.reach };
    let mut draw = Draw::new(context.options.seed, &format!("{}/another way", context.topic));
    Ok(Ensemble::draw(context.model, &setting, OF_EACH, &mut draw)?.scenes)
}
