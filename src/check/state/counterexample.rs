//! Counterexamples: the values of a claim's symbols at a state at which it fails.

use crate::formula::{Expr, Index, IndexId, Node};
use crate::latex::typeset;
use crate::scalar::RunningError;

use crate::check::model::claim::Link;
use crate::check::state::residual;
use crate::check::state::residual::Failure;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::finding::Counterexample;

/// The counterexample of a failure at a state.
pub fn counterexample(link: &Link, state: &SampledState<'_, RunningError>, failure: &Failure) -> Counterexample {
    Counterexample {
        state: values(&[&link.lhs, &link.rhs], state),
        lhs: failure.lhs,
        rhs: failure.rhs,
        entry: failure.entry.clone(),
    }
}

/// The largest number of values in a counterexample.
const MOST_SHOWN: usize = 40;

/// The names and values of the symbols of some formulas at a state, with their dots. All members of a family are
/// listed. Formulas without symbols give the coordinates.
pub fn values(formulas: &[&Expr], state: &SampledState<'_, RunningError>) -> Vec<(String, f64)> {
    let model = state.model();
    let mut found: Vec<(String, f64)> = Vec::new();
    for formula in formulas {
        formula.walk(&mut |expr| {
            let Node::Symbol { id, indices, dots } = &expr.node else { return };
            let mut labels: Vec<(IndexId, u8)> = Vec::new();
            for index in indices {
                match index {
                    Index::Letter(letter) if !labels.iter().any(|(known, _)| known == letter) => {
                        labels.push((*letter, 1))
                    }
                    _ => {}
                }
            }
            loop {
                let at = |index: &Index| match index {
                    Index::Letter(letter) => {
                        Index::Fixed(labels.iter().find(|(known, _)| known == letter).map_or(1, |(_, value)| *value))
                    }
                    fixed => *fixed,
                };
                let member = Node::Symbol { id: *id, indices: indices.iter().map(at).collect(), dots: *dots };
                let member = Expr::new(member, expr.span);
                let name = typeset(&member, &model.symbols);
                let Ok(value) = state.now(&member, &[]) else { return };
                let entries = value.entries();
                for (axis, entry) in ["x", "y", "z"].iter().zip(&entries) {
                    let name = if entries.len() == 1 { name.clone() } else { format!("{name} {axis}") };
                    if entries.len() <= 3 && found.len() < MOST_SHOWN && !found.iter().any(|(known, _)| *known == name)
                    {
                        found.push((name, entry.value));
                    }
                }
                if !matches!(residual::advance(&mut labels, state), Ok(true)) {
                    return;
                }
            }
        });
    }
    if found.is_empty() {
        let coordinates = model.coordinates.iter().zip(state.coordinates());
        found.extend(coordinates.map(|(variable, value)| (model.name(variable.symbol), value.value().value)));
    }
    found
}
