//! Which part of a formula has no real value at the sampled states, and what to do about it.
//!
//! A claim is decided only where both sides have a value. Where few states give one, the message names the innermost part
//! without a value, such as ln(x − 5000), and the symbols whose ranges matter.

use crate::formula::{Expr, Node, SymbolId, text};
use crate::scalar::RunningError;

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::state::sampled_state::SampledState;

/// The most states that are looked at.
const STATES: usize = 24;

/// The innermost part of the formulas, or of what defines a name in them, that has no value at most states.
pub(crate) fn part(formulas: &[&Expr], states: &[SampledState<'_, RunningError>]) -> Option<Expr> {
    let model = states.first()?.model();
    let (mut waiting, mut seen): (Vec<Expr>, Vec<SymbolId>) =
        (formulas.iter().map(|formula| (*formula).clone()).collect(), Vec::new());
    let mut worst: Option<(usize, Expr)> = None;
    while let Some(formula) = waiting.pop() {
        formula.walk(&mut |part| {
            if !matches!(part.node, Node::Call(..) | Node::Root(..) | Node::Power(..) | Node::Quotient(..)) {
                return;
            }
            let count = states.iter().take(STATES).filter(|state| fails_first_in(part, state)).count();
            if count > worst.as_ref().map_or(0, |(most, _)| *most) {
                worst = Some((count, part.clone()));
            }
        });
        for (id, _) in formula.symbols() {
            if let (Some(Meaning::Defined(inner)), false) = (model.meaning(id), seen.contains(&id)) {
                seen.push(id);
                waiting.push(inner.as_ref().clone());
            }
        }
    }
    worst.map(|(_, part)| part)
}

/// Whether a formula has no value at a state although everything in it has one.
fn fails_first_in(formula: &Expr, state: &SampledState<'_, RunningError>) -> bool {
    let is_finite = |part: &Expr| {
        state.now(part, &[]).is_ok_and(|value| value.entries().iter().all(|entry| entry.value.is_finite()))
    };
    !is_finite(formula) && formula.children().into_iter().all(is_finite)
}

/// The message that too few of the states that were tried gave a number, with the part that has none, if it is known.
pub(crate) fn message((points, tried): (usize, usize), part: Option<&Expr>, model: &Model) -> String {
    let found = match points {
        0 => "no sampled state gave a number".to_owned(),
        points => format!("only {points} of {tried} sampled states gave a number"),
    };
    let Some(part) = part else {
        return format!("{found}; narrow the ranges (for example, assume v < c)");
    };
    let shown = text::formula(part, &model.symbols);
    let names: Vec<String> = part.symbols().iter().map(|(id, _)| text::plain(&model.name(*id))).collect();
    let place = if points == 0 { "there" } else { "at the others" };
    let ranges = match names.as_slice() {
        [] => String::new(),
        [only] => format!("change the range of {only}, or "),
        names => format!("change the ranges of {}, or ", names.join(", ")),
    };
    format!("{found}, because {shown} has no finite real value {place}; {ranges}correct the formula")
}
