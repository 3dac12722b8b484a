//! Quantities of a printed Lagrangian that notes define again by a formula: T, U, E, and the momenta.
//!
//! Notes print T = … and V = … beside an L that is written out, or ℓ = mr²θ̇ and then only ℓ̇ = 0. No other equation tests
//! such a definition. But what follows from L does: T = ½ Σ p q̇ if L is quadratic in the velocities, V = T − L,
//! E = Σ p q̇ − L, and p = ∂L/∂q̇. A name whose formula is one of these is tested by the equality.

use crate::Result;
use crate::formula::{Expr, Node, Relation, Sign, SymbolId, text};
use crate::source::Span;

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::{Meaning, Quantity};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;

/// The number of sampled states at which a name must equal the quantity.
const STATES: usize = 6;

/// The equality of a defined name with a quantity of the printed Lagrangian, and the words for it; `None` if it is none.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn of(symbol: SymbolId, context: &Context<'_>) -> Result<Option<(String, Link)>> {
    let model = context.model;
    let quantities = quantities(model);
    let Some((_, first)) = quantities.first() else { return Ok(None) };
    let name = node(Node::Symbol { id: symbol, indices: Vec::new(), dots: 0 });
    let has_multipliers = model.system.as_ref().is_some_and(|system| !system.multipliers().is_empty());
    for on_shell in [false, true].into_iter().filter(|on_shell| !on_shell || has_multipliers) {
        let ensemble = context.ensemble(context.mode(on_shell, &[&name, first]), false, STATES)?;
        for (words, quantity) in &quantities {
            let link = Link { lhs: name.clone(), relation: Relation::Equal, rhs: quantity.clone(), free: Vec::new() };
            let holds = run(&link, &ensemble.states)
                .is_ok_and(|o| o.failure.is_none() && o.doubtful == 0 && o.points == ensemble.states.len());
            if holds && !ensemble.states.is_empty() {
                return Ok(Some((format!("{} = {words}", text::plain(&model.name(symbol))), link)));
            }
        }
    }
    Ok(None)
}

/// The kinetic and the potential energy in the printed Lagrangian, if it is quadratic in the velocities; `None` without one.
pub(crate) fn energies(model: &Model) -> Option<[Expr; 2]> {
    let mut found = quantities(model);
    let (potential, kinetic) = (found.pop()?.1, found.pop()?.1);
    Some([kinetic, potential])
}

/// The quantities that follow from the printed Lagrangian, with the words for them; none without one.
fn quantities(model: &Model) -> Vec<(String, Expr)> {
    let printed = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let Some((lagrangian, _)) = printed else { return Vec::new() };
    let of_meaning = |place: usize| {
        let is_it =
            |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::System(Quantity::Momentum(at))) if *at == place);
        model.symbols.iter().map(|(id, _)| id).find(is_it)
    };
    let symbol = |id: SymbolId, dots: u8| node(Node::Symbol { id, indices: Vec::new(), dots });
    let (mut found, mut products) = (Vec::new(), Vec::new());
    for (place, coordinate) in model.coordinates.iter().enumerate() {
        let Some(momentum) = of_meaning(place) else { return Vec::new() };
        let words = format!("the momentum of {}", text::plain(&model.name(coordinate.symbol)));
        found.push((words, symbol(momentum, 0)));
        products.push(node(Node::Product(vec![symbol(momentum, 0), symbol(coordinate.symbol, 1)])));
    }
    let sum = |terms: Vec<(Sign, Expr)>| {
        let term = |(sign, expr)| crate::formula::tree::Term { sign, sign_span: None, expr };
        node(Node::Sum(terms.into_iter().map(term).collect()))
    };
    let twice = sum(products.into_iter().map(|product| (Sign::Plus, product)).collect());
    let half = node(Node::Quotient(Box::new(twice.clone()), Box::new(Expr::integer(2, Span::default()))));
    let minus_l = |formula: &Expr| sum(vec![(Sign::Plus, formula.clone()), (Sign::Minus, symbol(lagrangian, 0))]);
    let l = text::plain(&model.name(lagrangian));
    found.push((format!("the energy that follows from {l}"), minus_l(&twice)));
    found.push((format!("the kinetic energy in {l}"), half.clone()));
    found.push((format!("the potential energy in {l}"), minus_l(&half)));
    found
}

fn node(node: Node) -> Expr {
    Expr::new(node, Span::default())
}
