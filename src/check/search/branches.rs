//! The other branches of the solutions of hypotheses.
//!
//! xy = 0 is solved for one number, y, so y = 0 at all drawn states. But x = 0 obeys it as well, and a claim must hold
//! there too. These states have one factor of such a hypothesis, or one of its symbols, equal to 0.

use crate::formula::{Expr, Kind, Node, Relation};
use crate::notes::claims::Range;
use crate::scalar::RunningError;

use crate::check::model::claim::{Hypothesis, is_equality};
use crate::check::model::free_symbols::drawn;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::sampler::contains;
use crate::check::sample::setting::Setting;
use crate::check::state::sampled_state::SampledState;

/// The number of states on each branch.
const OF_EACH: usize = 3;

/// States on other branches of the hypotheses of a claim. A branch without a finite mass matrix, as where the velocity of
/// light is 0, has no motions.
pub(crate) fn states<'m>(context: &Context<'m>, ensemble: &Ensemble<'m>) -> Vec<SampledState<'m, RunningError>> {
    let mut found = Vec::new();
    for (at, hypothesis) in context.hypotheses.iter().enumerate() {
        if !is_equality(hypothesis.relation) || !hypothesis.free.is_empty() {
            continue;
        }
        for factor in factors(hypothesis, context) {
            let mut hypotheses = context.hypotheses.to_vec();
            hypotheses[at] = zero(factor, hypothesis.throughout);
            found.extend(drawn_under(&hypotheses, context, ensemble));
        }
        for symbol in symbols(hypothesis, context) {
            let first = [zero(symbol, false)].into_iter();
            let hypotheses: Vec<Hypothesis> = first.chain(context.hypotheses.iter().cloned()).collect();
            found.extend(drawn_under(&hypotheses, context, ensemble));
        }
    }
    if context.options.deduction {
        found.retain(|state| context.hypotheses.iter().all(|hypothesis| says_something(hypothesis, state)));
    }
    found
}

fn zero(expr: Expr, throughout: bool) -> Hypothesis {
    let rhs = Expr::integer(0, expr.span);
    Hypothesis { lhs: expr, relation: Relation::Equal, rhs, free: Vec::new(), throughout, stated: None, implied: false }
}

/// The factors of a product that a hypothesis sets to 0, if more than one of them varies.
fn factors(hypothesis: &Hypothesis, context: &Context<'_>) -> Vec<Expr> {
    let product = match (&hypothesis.lhs.node, &hypothesis.rhs.node) {
        (Node::Product(factors), _) if hypothesis.rhs.is_null() => factors,
        (_, Node::Product(factors)) if hypothesis.lhs.is_null() => factors,
        _ => return Vec::new(),
    };
    let varying = product.iter().filter(|factor| !drawn(&[factor], context.model).is_empty());
    let varying: Vec<Expr> = varying.cloned().collect();
    if varying.len() > 1 { varying } else { Vec::new() }
}

/// The scalar symbols of a hypothesis with several symbols that may be 0.
fn symbols(hypothesis: &Hypothesis, context: &Context<'_>) -> Vec<Expr> {
    let model = context.model;
    let all = drawn(&[&hypothesis.lhs, &hypothesis.rhs], model);
    if all.len() < 2 {
        return Vec::new();
    }
    let may_vanish =
        |range: &Range| matches!(range, Range::Any | Range::Angle | Range::Interval { .. }) && contains(range, 0.0);
    let numbers = all.into_iter().filter(|symbol| {
        let entry = model.symbols.entry(*symbol);
        entry.kind == Kind::Scalar && entry.slots.is_empty() && may_vanish(&model.range(*symbol))
    });
    let name = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, hypothesis.lhs.span);
    numbers.map(name).collect()
}

/// Whether a premise says something at a state. Where both of its sides are 0, and neither is written so, they have a
/// common factor that vanishes, and nobody who divides by it means that state.
fn says_something(hypothesis: &Hypothesis, state: &SampledState<'_, RunningError>) -> bool {
    let sides = [&hypothesis.lhs, &hypothesis.rhs];
    let is_zero =
        |side: &&Expr| state.now(side, &[]).is_ok_and(|value| value.entries().iter().all(|entry| entry.value == 0.0));
    sides.iter().any(|side| side.is_null()) || !sides.iter().all(is_zero)
}

fn drawn_under<'m>(
    hypotheses: &[Hypothesis],
    context: &Context<'m>,
    ensemble: &Ensemble<'m>,
) -> Vec<SampledState<'m, RunningError>> {
    let setting = Setting { hypotheses, ..context.setting(ensemble.mode) };
    // The same branches are sought for each correction that is tried, so these states are cached.
    let stream = format!("{}/another way", context.topic);
    let found = Ensemble::named(context.model, &setting, OF_EACH, context.options.seed, &stream);
    found.map_or(Vec::new(), |ensemble| ensemble.states)
}
