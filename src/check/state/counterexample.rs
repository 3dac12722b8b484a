//! Counterexamples as they are printed: the values of a claim's symbols at a state at which it fails. The state itself is
//! chosen where all states are tested, in `crate::check::sample::outcome`: the one with the largest residual.

use crate::formula::{Expr, Index, IndexId, Node, Relation, SymbolId, Value};
use crate::latex::typeset;
use crate::scalar::RunningError;

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::state::residual;
use crate::check::state::residual::Failure;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::finding::{Compared, Counterexample};

/// The relative distance below which the two sides of an inequality differ by their rounding only.
const ROUNDED: f64 = 1e-14;

/// Whether the two sides of a strict inequality, or of ≠, are equal where it fails, but for their rounding.
pub(crate) fn are_equal(link: &Link, failure: &Failure) -> bool {
    matches!(link.relation, Relation::Less | Relation::Greater | Relation::NotEqual)
        && (failure.lhs - failure.rhs).abs() <= ROUNDED * failure.lhs.abs().max(failure.rhs.abs())
}

/// The counterexample of a failure at a state.
pub fn counterexample(link: &Link, state: &SampledState<'_, RunningError>, failure: &Failure) -> Counterexample {
    Counterexample {
        state: values(&[&link.lhs, &link.rhs], state),
        lhs: failure.lhs,
        // A difference that is rounding alone says of a > b that it holds.
        rhs: if are_equal(link, failure) { failure.lhs } else { failure.rhs },
        entry: failure.entry.clone(),
        compared: Compared::Sides,
    }
}

/// The largest number of values in a counterexample.
const MOST_SHOWN: usize = 40;

/// The names and values of what a quantity and its motion depend on: its symbols, those of the definitions in it, and
/// the coordinates, velocities and parameters of the system, or the symbols of the laws.
pub(crate) fn values_of_motion(quantity: &Expr, state: &SampledState<'_, RunningError>) -> Vec<(String, f64)> {
    let model = state.model();
    let mut formulas = vec![quantity.clone()];
    let mut known: Vec<SymbolId> = Vec::new();
    let mut next = 0;
    while let Some(formula) = formulas.get(next).cloned() {
        next += 1;
        for (id, _) in formula.symbols() {
            if let (Some(Meaning::Defined(formula)), false) = (model.meaning(id), known.contains(&id)) {
                known.push(id);
                formulas.push(formula.as_ref().clone());
            }
        }
    }
    let symbol = |id, dots| Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, quantity.span);
    if model.system.is_some() {
        formulas.extend(model.coordinates.iter().flat_map(|of| [symbol(of.symbol, 0), symbol(of.symbol, 1)]));
        formulas.extend(model.parameters.iter().map(|at| symbol(model.constants[*at].symbol, 0)));
    }
    let laws = model.laws.iter().flat_map(|law| &law.hypotheses);
    formulas.extend(laws.flat_map(|hypothesis| [hypothesis.lhs.clone(), hypothesis.rhs.clone()]));
    values(&formulas.iter().collect::<Vec<_>>(), state)
}

/// The symbols in a formula, each with the numbers of overdots that its value depends on: a symbol under d/dt is needed
/// with more dots.
fn with_dots(expr: &Expr, order: u8, found: &mut Vec<Expr>) {
    match &expr.node {
        Node::TimeDerivative(more, inner) => match &inner.node {
            Node::Symbol { id, indices, dots } => {
                let node = Node::Symbol { id: *id, indices: indices.clone(), dots: dots + more };
                with_dots(&Expr::new(node, inner.span), order, found);
            }
            _ => with_dots(inner, order + more, found),
        },
        Node::Symbol { id, indices, dots } => found.extend((*dots..=dots + order).map(|dots| {
            let node = Node::Symbol { id: *id, indices: indices.clone(), dots };
            Expr::new(node, expr.span)
        })),
        _ => expr.children().into_iter().for_each(|child| with_dots(child, order, found)),
    }
}

/// Whether the rate of a symbol is worth a line: not that of the time, or of a formula of constants.
fn moves(id: SymbolId, model: &Model) -> bool {
    match model.meaning(id) {
        Some(Meaning::Time | Meaning::Constant(_)) => false,
        Some(Meaning::Defined(formula)) => {
            let names_time = |id| matches!(model.meaning(id), Some(Meaning::Time));
            formula.symbols().iter().any(|(inner, _)| names_time(*inner) || moves(*inner, model))
        }
        _ => true,
    }
}

/// The names and values of the symbols of some formulas at a state, with their dots. All members of a family are
/// listed. Formulas without symbols give the coordinates.
pub fn values(formulas: &[&Expr], state: &SampledState<'_, RunningError>) -> Vec<(String, f64)> {
    let model = state.model();
    let mut found: Vec<(String, f64)> = Vec::new();
    for formula in formulas {
        let mut symbols = Vec::new();
        with_dots(formula, 0, &mut symbols);
        symbols.iter().for_each(|expr| {
            let Node::Symbol { id, indices, dots } = &expr.node else { return };
            // What does not vary has no rate to show; of a function its value is shown, and no coefficient.
            let entry = model.symbols.entry(*id);
            if entry.hidden || *dots > 0 && !(entry.varies && moves(*id, model)) {
                return;
            }
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
                for (at, entry) in entries.iter().enumerate() {
                    let name = match &value {
                        Value::Scalar(_) => name.clone(),
                        Value::Matrix(matrix) => {
                            let columns = matrix.ncols();
                            format!("{name}_{{{}{}}}", at / columns + 1, at % columns + 1)
                        }
                        Value::Complex(_) => format!("{}({name})", ["Re", "Im"][at.min(1)]),
                        _ => format!("{name} {}", ["x", "y", "z"][at.min(2)]),
                    };
                    if found.len() < MOST_SHOWN && !found.iter().any(|(known, _)| *known == name) {
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
