//! Forced values: symbols to which the hypotheses together leave one value.
//!
//! Two laws such as x + y = 0 and x − y = 0 have one solution, at which many false formulas hold too. So if a symbol
//! that may vary has one value at all states, and no hypothesis states that value by itself, a claim about it is not
//! tested. A hypothesis states a value by itself if it contains no other symbol: θ = π/2, \cos θ = 0.

use crate::formula::{Expr, Index, Node, Relation, SymbolId, text};

use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Law, Link, is_equality};
use crate::check::model::free_symbols::drawn;
use crate::check::model::order::order;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual;

/// The relative difference below which two values are the same: far above the error of solving hypotheses.
const ONE_VALUE: f64 = 1e-9;

/// A symbol of a claim that the hypotheses together force to one value; `None` if the claim states that value.
pub(crate) fn of_claim(link: &Link, context: &Context<'_>, ensemble: &Ensemble<'_>) -> Option<SymbolId> {
    let symbol = of_formulas(&[&link.lhs, &link.rhs], context, ensemble)?;
    let laws = ensemble.mode.on_shell && !context.model.laws.is_empty();
    let is_value = |a: &Expr, b: &Expr| a.as_plain_symbol() == Some(symbol) && drawn(&[b], context.model).is_empty();
    let says_it = is_equality(link.relation) && (is_value(&link.lhs, &link.rhs) || is_value(&link.rhs, &link.lhs));
    (laws || !says_it).then_some(symbol)
}

/// A symbol on which some formulas depend and that the hypotheses together force to one value.
pub(crate) fn of_formulas(formulas: &[&Expr], context: &Context<'_>, ensemble: &Ensemble<'_>) -> Option<SymbolId> {
    let model = context.model;
    let laws = model.laws.iter().flat_map(|law| &law.hypotheses).filter(|_| ensemble.mode.on_shell);
    let hypotheses: Vec<&Hypothesis> = context.hypotheses.iter().chain(laws).collect();
    let binds = |hypothesis: &&Hypothesis| !matches!(hypothesis.relation, Relation::NotEqual);
    if ensemble.states.len() < FEWEST.min(context.options.points) || !hypotheses.iter().any(binds) {
        return None;
    }
    let stated_alone = stated_alone(&hypotheses, model);
    let is_free =
        |symbol: &SymbolId| !stated_alone.contains(symbol) && !context.local.iter().any(|rule| rule.symbol == *symbol);
    drawn(formulas, model).into_iter().filter(is_free).find(|symbol| {
        let Some((first, others)) = ensemble.states.split_first() else { return false };
        let Some(first) = values(*symbol, first).filter(|first| !first.is_empty()) else { return false };
        let one = |(a, b): (&f64, &f64)| (a - b).abs() <= ONE_VALUE * (1.0 + a.abs());
        let same = |other| values(*symbol, other).is_some_and(|other| first.iter().zip(&other).all(one));
        others.iter().all(same) && !is_narrow(*symbol, model)
    })
}

/// The message about a claim with such a symbol.
pub(crate) fn message(symbol: SymbolId, context: &Context<'_>) -> String {
    let name = text::plain(&context.model.name(symbol));
    let laws = &context.model.laws;
    if laws.len() > 1 && context.hypotheses.is_empty() {
        return format!(
            "{} together allow only one value of {name}, and a test at one value shows too little; the laws may \
             contradict each other: correct one of them",
            Law::phrases(laws)
        );
    }
    format!(
        "the hypotheses together allow only one value of {name}, and a test at one value shows too little; remove a \
         hypothesis, or write the value of {name} as a hypothesis"
    )
}

/// The symbols whose value one hypothesis gives by itself: it contains no other symbol, or equates it to one of these.
fn stated_alone(hypotheses: &[&Hypothesis], model: &Model) -> Vec<SymbolId> {
    let equalities: Vec<&&Hypothesis> = hypotheses.iter().filter(|c| is_equality(c.relation)).collect();
    let mut found: Vec<SymbolId> = Vec::new();
    for hypothesis in &equalities {
        let sides = [&hypothesis.lhs, &hypothesis.rhs];
        if let [only] = drawn(&sides, model).as_slice()
            && sides.iter().filter_map(|side| order(model, side, *only)).max() == Some(0)
        {
            found.push(*only);
        }
    }
    // A chain, a = b = 0.
    for _ in 0..equalities.len() {
        for hypothesis in &equalities {
            let pair = (hypothesis.lhs.as_plain_symbol(), hypothesis.rhs.as_plain_symbol());
            if let (Some(a), Some(b)) = pair
                && found.contains(&a) != found.contains(&b)
            {
                found.extend([a, b]);
            }
        }
    }
    found
}

/// All numbers of a symbol at a state, for all members of a family.
fn values(
    symbol: SymbolId,
    state: &crate::check::state::sampled_state::SampledState<'_, crate::scalar::RunningError>,
) -> Option<Vec<f64>> {
    let letters: Vec<_> = state.model().symbols.entry(symbol).slots.iter().map(|(_, letter)| *letter).collect();
    let indices = letters.iter().map(|letter| Index::Letter(*letter)).collect();
    let itself = Expr::new(Node::Symbol { id: symbol, indices, dots: 0 }, crate::source::Span::default());
    let mut at: Vec<_> = letters.iter().map(|letter| (*letter, 1)).collect();
    let mut numbers = Vec::new();
    loop {
        let value = state.now(&itself, &at).ok()?;
        numbers.extend(value.entries().iter().map(|entry| entry.value));
        if !residual::advance(&mut at, state).ok()? {
            return Some(numbers);
        }
    }
}

/// Whether the declared range of a symbol has nearly one value only.
fn is_narrow(symbol: SymbolId, model: &Model) -> bool {
    use crate::notes::claims::Range;
    match model.range(symbol) {
        Range::Interval { low, high, .. } => high - low <= 1e3 * ONE_VALUE * (1.0 + low.abs()),
        Range::Integer { .. } => true,
        _ => false,
    }
}
