//! Formulas that follow from a Lagrangian by derivatives: ∂L/∂q, d/dt of it, the Euler–Lagrange expression.

use crate::formula::derivative::{self, Scope};
use crate::formula::tree::{Sign, Term, Variable};
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::source::Span;

use crate::check::model::claim::Link;
use crate::check::sample::context::Context;

/// Why nothing is derived where there is no Lagrangian to differentiate.
pub(super) const NO_LAGRANGIAN: &str = "no display that can be read defines a Lagrangian; write a display L = …, and \
                                        \"means\": { \"L\": \"Lagrangian\" } in the claims file";

/// Why nothing is derived where the second derivatives of the Lagrangian are not known as formulas.
pub(super) const NOT_ELEMENTARY: &str = "the second derivatives of the Lagrangian cannot be written as formulas; write the \
                                         Lagrangian with sums, products, powers and elementary functions";

/// The Lagrangian that the notes define, as a formula that is its name.
pub(super) fn lagrangian(context: &Context<'_>) -> Option<Expr> {
    let model = context.model;
    let printed = model.printed_lagrangian.as_ref()?;
    let (id, _) = model.symbols.find(&printed.lagrangian)?;
    Some(symbol(id, 0))
}

/// The derivative of a formula by a symbol with this number of dots. It is printed nowhere, and so has no place.
pub(super) fn partial(of: &Expr, q: SymbolId, dots: u8, context: &Context<'_>) -> Option<Expr> {
    let by = Variable { id: q, indices: Vec::new(), dots };
    let scope = Scope { symbols: &context.model.symbols, fixed: &[] };
    let mut found = derivative::partial(of, &by, scope, of.span).ok()?;
    found.move_to(Span::default());
    Some(found)
}

/// d/dt of a formula.
pub(super) fn rate(of: Expr) -> Expr {
    let span = of.span;
    Expr::new(Node::TimeDerivative(1, Box::new(of)), span)
}

/// d/dt ∂L/∂q̇ − ∂L/∂q.
pub(super) fn euler_lagrange(of: &Expr, q: SymbolId, context: &Context<'_>) -> Option<Expr> {
    let (momentum, force) = (partial(of, q, 1, context)?, partial(of, q, 0, context)?);
    Some(match momentum.is_zero() {
        true => force.negated(),
        false => rate(momentum).minus(force),
    })
}

/// The equality of two formulas.
pub(super) fn equal(lhs: &Expr, rhs: &Expr) -> Link {
    Link { lhs: lhs.clone(), relation: Relation::Equal, rhs: rhs.clone(), free: Vec::new() }
}

/// The sum of formulas.
pub(super) fn sum(all: Vec<Expr>) -> Expr {
    let term = |expr| Term { sign: Sign::Plus, sign_span: None, expr };
    Expr::new(Node::Sum(all.into_iter().map(term).collect()), Span::default())
}

/// The product of formulas.
pub(super) fn product(all: Vec<Expr>) -> Expr {
    Expr::new(Node::Product(all), Span::default())
}

/// A symbol with this number of dots.
pub(super) fn symbol(id: SymbolId, dots: u8) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, Span::default())
}

/// The equalities ∂²L/∂q̇∂r = ∂²L/∂ṙ∂q of each two coordinates q and r. Where one fails, there are forces that are linear in the
/// velocities. `None` if there are no such derivatives as formulas.
pub(super) fn without_velocity_forces(
    lagrangian: &Expr,
    coordinates: &[SymbolId],
    context: &Context<'_>,
) -> Option<Vec<Link>> {
    let mixed =
        |velocity: SymbolId, place: SymbolId| partial(&partial(lagrangian, velocity, 1, context)?, place, 0, context);
    let pairs = coordinates.iter().enumerate().flat_map(|(at, q)| coordinates[at + 1..].iter().map(move |r| (*q, *r)));
    pairs.map(|(q, r)| Some(equal(&mixed(q, r)?, &mixed(r, q)?))).collect()
}
