//! Terms that are too small beside the others to be tested at sampled states.

use crate::formula::{Expr, Node, Value, text};
use crate::scalar::RunningError;

use crate::check::model::claim::Link;
use crate::check::state::residual;
use crate::check::state::residual::DIFFERENCE;
use crate::check::state::sampled_state::SampledState;

/// A term of a claim that is not zero and at all states so small beside the others that its omission is within rounding
/// error.
pub fn of_claim(link: &Link, states: &[SampledState<'_, RunningError>]) -> Option<String> {
    fn terms(side: &Expr) -> Vec<&Expr> {
        match &side.node {
            Node::Sum(terms) => terms.iter().map(|term| &term.expr).collect(),
            _ => vec![side],
        }
    }
    if !link.free.is_empty() {
        return None;
    }
    let all: Vec<&Expr> = terms(&link.lhs).into_iter().chain(terms(&link.rhs)).collect();
    hidden(&all, states)
}

/// The message about a claim with such a term.
pub(crate) fn message(term: &str) -> String {
    format!(
        "“{term}” is far smaller than the other terms at all sampled states, so it was not tested; choose ranges in \
         which it is of similar size"
    )
}

/// Such a term of a sum inside of a claim: under a root, in a sine, in an exponent.
pub fn inside(link: &Link, states: &[SampledState<'_, RunningError>]) -> Option<String> {
    let mut sums: Vec<Vec<&Expr>> = Vec::new();
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |expr| match &expr.node {
            Node::Sum(terms) if terms.len() > 1 => sums.push(terms.iter().map(|term| &term.expr).collect()),
            _ => {}
        });
    }
    sums.iter().find_map(|terms| hidden(terms, states))
}

/// The first term of a sum that is negligible beside the others at all states.
fn hidden(all: &[&Expr], states: &[SampledState<'_, RunningError>]) -> Option<String> {
    // A literal zero is not tested.
    let (mut seen, mut there): (Vec<bool>, Vec<bool>) = all.iter().map(|term| (term.is_null(), false)).unzip();
    for state in states {
        if seen.iter().all(|seen| *seen) {
            return None;
        }
        let values: Option<Vec<RunningError>> = all
            .iter()
            .map(|term| match state.now(term, &[]) {
                Ok(Value::Scalar(value)) => Some(value),
                _ => None,
            })
            .collect();
        let Some(values) = values else { continue };
        let scale: f64 = values.iter().map(|value| value.magnitude).sum();
        for (at, value) in values.iter().enumerate().filter(|(_, value)| value.value.is_finite()) {
            let is_there = !residual::vanishes(*value);
            there[at] |= is_there;
            seen[at] |= is_there && value.value.abs() > DIFFERENCE * scale;
        }
    }
    let hidden = (0..all.len()).find(|at| there[*at] && !seen[*at])?;
    Some(text::formula(all[hidden], &states.first()?.model().symbols))
}
