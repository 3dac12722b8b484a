//! Hypotheses that every component of a vector vanishes, combined into one about the vector.
//!
//! Authors write "torque free" as `M_1 = M_2 = M_3 = 0`, as `M_a = 0` and as `\vec M = \vec 0`. Only the last gives the
//! vector explicitly ([`super::explicit`]). To solve for three components that vanish at all times, a state would need
//! more derivatives than it has.

use crate::formula::symbols::Components;
use crate::formula::{Expr, Index, Node, Relation, SymbolId};
use crate::source::Span;

use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;

/// The same hypotheses, with those about all components of a vector combined into one about the vector.
pub(crate) fn vectors(model: &Model, hypotheses: Vec<Hypothesis>) -> Vec<Hypothesis> {
    let vanishing: Vec<Option<Part>> = hypotheses.iter().map(|hypothesis| vanishing(model, hypothesis)).collect();
    let mut whole = Vec::with_capacity(hypotheses.len());
    for (at, hypothesis) in hypotheses.iter().enumerate() {
        let Some(part) = &vanishing[at] else {
            whole.push(hypothesis.clone());
            continue;
        };
        let others = || {
            let others = vanishing.iter().zip(&hypotheses).enumerate();
            others.filter_map(|(other, (found, c))| Some((other, found.as_ref()?, c.throughout)))
        };
        let siblings: Vec<_> = others()
            .filter(|(_, other, throughout)| part.is_sibling(other) && *throughout == hypothesis.throughout)
            .collect();
        let all = (1..=3).all(|axis| siblings.iter().any(|(_, other, _)| other.axis.is_none_or(|known| known == axis)));
        if !all {
            whole.push(hypothesis.clone());
        } else if siblings.first().is_some_and(|(first, ..)| *first == at) {
            let zero = Expr::integer(0, Span::default());
            whole.push(Hypothesis { lhs: part.vector.clone(), rhs: zero, free: Vec::new(), ..hypothesis.clone() });
        }
    }
    whole
}

/// A component of a vector.
struct Part {
    vector: Expr,
    /// The named axes along which the component is taken, if they are named.
    triad: Option<SymbolId>,
    /// The number of the component, from 1; `None` for all of them.
    axis: Option<u8>,
}

impl Part {
    fn is_sibling(&self, other: &Part) -> bool {
        self.vector == other.vector && self.triad == other.triad
    }
}

/// The component that a hypothesis sets to zero.
fn vanishing(model: &Model, hypothesis: &Hypothesis) -> Option<Part> {
    let is_equality = matches!(hypothesis.relation, Relation::Equal | Relation::Identical);
    let side = match (hypothesis.lhs.is_null(), hypothesis.rhs.is_null()) {
        (false, true) => &hypothesis.lhs,
        (true, false) => &hypothesis.rhs,
        _ => return None,
    };
    let part = part(model, side).filter(|_| is_equality)?;
    let free = match (&part, hypothesis.free.as_slice()) {
        (Part { axis: Some(_), .. }, []) => true,
        (Part { axis: None, vector, .. }, [_]) => {
            matches!(&vector.node, Node::Symbol { indices, .. } if indices.is_empty())
        }
        _ => false,
    };
    free.then_some(part)
}

fn part(model: &Model, expr: &Expr) -> Option<Part> {
    match &expr.node {
        Node::Dot(vector, axis) => {
            let (Node::Symbol { id, .. }, Node::Symbol { id: axes, indices, dots: 0 }) = (&vector.node, &axis.node)
            else {
                return None;
            };
            let along = model.symbols.components_of(*id) == Some(Components::Along(*axes));
            let axis = match indices.as_slice() {
                [Index::Fixed(axis)] => Some(*axis),
                [Index::Letter(_)] => None,
                _ => return None,
            };
            along.then(|| Part { vector: (**vector).clone(), triad: Some(*axes), axis })
        }
        Node::Component(vector, Index::Fixed(axis)) => {
            Some(Part { vector: (**vector).clone(), triad: None, axis: Some(*axis) })
        }
        Node::Symbol { id, indices, dots: 0 } if indices.is_empty() => match model.meaning(*id)? {
            Meaning::Defined(formula) if matches!(formula.node, Node::Component(..)) => part(model, formula),
            _ => None,
        },
        _ => None,
    }
}
