//! A printed solution of the motion: what it says, its constants of integration, and what follows for one instant.

use crate::formula::derivative::{self, Scope};
use crate::formula::tree::Variable;
use crate::formula::{Expr, Node, Relation, SymbolId};

use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::{Model, free_symbols, order};

/// A coordinate, or a rate of it, as a function of the time and constants.
#[derive(Clone, Debug)]
pub(crate) struct Solution {
    /// The coordinate.
    pub coordinate: SymbolId,
    /// The number of its dots.
    pub dots: u8,
    /// The function.
    pub formula: Expr,
    /// The order of the equation of motion: 2 for a system, and for laws that of the highest derivative in them.
    pub order: u8,
}

impl Solution {
    /// The solution that a link prints: a coordinate on the left, and on the right the time and constants only.
    pub(crate) fn of_link(link: &Link, model: &Model) -> Option<Solution> {
        Solution::of_link_or_constant(link, model).filter(|found| model.contains_time(&found.formula))
    }

    /// The same, where the coordinate may be constant: beside the solution for another one, θ = 0 is a solution too.
    pub(crate) fn of_link_or_constant(link: &Link, model: &Model) -> Option<Solution> {
        let Node::Symbol { id, indices, dots } = &renamed(&link.lhs, model).node else { return None };
        let order = order_of_motion(*id, model)?;
        let fits = is_equality(link.relation) && indices.is_empty();
        if !fits || !is_of_time_and_constants(&link.rhs, model) {
            return None;
        }
        Some(Solution { coordinate: *id, dots: *dots, formula: link.rhs.clone(), order })
    }

    /// The k-th time derivative of its coordinate, and the derivative of the formula that must equal it.
    pub(super) fn sides(&self, order: u8) -> (Expr, Expr) {
        let span = self.formula.span;
        let node = Node::Symbol { id: self.coordinate, indices: Vec::new(), dots: order };
        let formula = match order - self.dots {
            0 => self.formula.clone(),
            more => Expr::new(Node::TimeDerivative(more, Box::new(self.formula.clone())), span),
        };
        (Expr::new(node, span), formula)
    }

    pub(super) fn link(&self, order: u8) -> Link {
        let (lhs, rhs) = self.sides(order);
        Link { lhs, relation: Relation::Equal, rhs, free: Vec::new() }
    }

    /// The highest derivative in the equation of motion of its formula by the time, written out.
    pub(crate) fn highest_rate(&self, model: &Model) -> Option<Expr> {
        let (time, _) = model.symbols.find(model.symbols.time.as_ref()?)?;
        let by = Variable { id: time, indices: Vec::new(), dots: 0 };
        let scope = Scope { symbols: &model.symbols, fixed: &[] };
        let span = self.formula.span;
        let mut found = self.formula.clone();
        for _ in self.dots..self.order {
            found = derivative::partial(&found, &by, scope, span).ok()?;
        }
        found.move_to(span);
        Some(found)
    }

    /// Whether a link contains one of its constants of integration.
    pub(crate) fn shares_a_constant_of_integration(&self, link: &Link, model: &Model) -> bool {
        let drawn = free_symbols::drawn(&[&link.lhs, &link.rhs], model);
        constants_of_integration(self, model).iter().any(|constant| drawn.contains(constant))
    }

    /// The hypotheses that a state lies on the solution: its coordinate and velocity, as far as the formula gives them.
    pub(crate) fn hypotheses(&self) -> impl Iterator<Item = Hypothesis> + '_ {
        (self.dots..self.order).map(|order| Hypothesis::of(self.link(order), false))
    }

    /// The claim: the highest derivative on shell is that of the formula.
    pub(crate) fn claim(&self) -> Link {
        self.link(self.order.max(self.dots))
    }
}

/// The order of the equation of motion for a symbol, if a system or laws determine its motion. A first-order law in which
/// something else moves as well, as q̇ = p/m, makes it of the second order at least.
fn order_of_motion(id: SymbolId, model: &Model) -> Option<u8> {
    match model.meaning(id) {
        Some(Meaning::Coordinate(_)) if model.system.is_some() => Some(2),
        Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => {
            let orders = model.laws.iter().flat_map(|law| &law.hypotheses).filter_map(|law| {
                let sides = [&law.lhs, &law.rhs];
                let order = sides.iter().filter_map(|side| order::order(model, side, id)).max()?;
                let moves = |other: &SymbolId| !matches!(model.meaning(*other), Some(Meaning::Constant(_)));
                let is_alone = free_symbols::drawn(&sides, model).iter().all(|other| *other == id || !moves(other));
                Some(if is_alone || order == 0 { order } else { order.max(2) })
            });
            orders.max().filter(|order| *order > 0)
        }
        _ => None,
    }
}

/// Whether a formula has no value that moves but the time.
fn is_of_time_and_constants(formula: &Expr, model: &Model) -> bool {
    formula.symbols().iter().all(|(id, _)| match model.meaning(*id) {
        Some(Meaning::Constant(_) | Meaning::Time) => true,
        Some(Meaning::Defined(formula)) => is_of_time_and_constants(formula, model),
        _ => false,
    })
}

/// The constants of a solution that the motion does not depend on: those of integration.
pub(crate) fn constants_of_integration(solution: &Solution, model: &Model) -> Vec<SymbolId> {
    let lagrangian = model.printed_lagrangian.as_ref().map(|printed| &printed.lagrangian);
    let hamiltonian = model.printed_hamiltonian.as_ref().map(|printed| &printed.hamiltonian);
    let lagrangian = lagrangian.or(hamiltonian).and_then(|name| model.symbols.find(name));
    let of_motion = match lagrangian {
        Some((id, _)) => {
            let node = Node::Symbol { id, indices: Vec::new(), dots: 0 };
            let lagrangian = Expr::new(node, solution.formula.span);
            // The motion depends on the forces beside the Lagrangian too, and on the constraints.
            let beside = model.printed_lagrangian.iter().flat_map(|printed| {
                let formulas = printed.forces.iter().chain(&printed.constraints).map(|(_, formula)| formula);
                formulas.chain(&printed.dissipation)
            });
            free_symbols::drawn(&std::iter::once(&lagrangian).chain(beside).collect::<Vec<_>>(), model)
        }
        None if model.system.is_none() => {
            let laws = model.laws.iter().flat_map(|law| &law.hypotheses);
            free_symbols::drawn(&laws.flat_map(|law| [&law.lhs, &law.rhs]).collect::<Vec<_>>(), model)
        }
        None => model.parameters.iter().map(|at| model.constants[*at].symbol).collect(),
    };
    let all = free_symbols::drawn(&[&solution.formula], model);
    all.into_iter().filter(|id| !of_motion.contains(id)).collect()
}

/// The coordinate or the rate that a name stands for, as I does in `I = \dot q`; else the formula itself.
fn renamed<'e>(formula: &'e Expr, model: &'e Model) -> &'e Expr {
    let meaning = formula.as_plain_symbol().and_then(|id| model.meaning(id));
    match meaning {
        Some(Meaning::Defined(other)) if matches!(other.node, Node::Symbol { .. }) => other,
        _ => formula,
    }
}
