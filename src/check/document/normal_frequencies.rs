//! The frequency of small oscillations of one coordinate: a name for ω = √(K/M), where K and M are the second derivatives of −L
//! and of L by the coordinate and by the velocity, with the coordinate at 0 and at rest.
//!
//! It is a formula, and no condition: so its derivatives follow, and what does not contain it holds where 0 is unstable too. With
//! several coordinates det(K − ω²M) = 0 has several roots: see `crate::check::kinds::mechanics::modes`.

use crate::formula::derivative::{self, Scope};
use crate::formula::tree::Variable;
use crate::formula::{Expr, Kind, Node, Relation, SymbolId, text};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::Meaning;

/// Gives the normal frequencies of the document their formula, once the Lagrangian is defined.
///
/// # Errors
/// Where the Lagrangian has no coordinate, or no such derivatives as formulas.
pub(crate) fn define(model: &mut Model) -> Result<()> {
    let Some(first) = model.normal_frequencies.first() else { return Ok(()) };
    let name = text::plain(&first.to_string());
    let printed = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let Some((lagrangian, _)) = printed.filter(|(id, _)| matches!(model.meaning(*id), Some(Meaning::Defined(_))))
    else {
        return Ok(());
    };
    let unsupported =
        |what: &str| Error::new(format!("{name} cannot be derived as a normal frequency, because {what}"));
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    let [only] = coordinates.as_slice() else {
        return Err(unsupported("the Lagrangian has no coordinate").help("declare one under \"coordinates\""));
    };
    let second = |a: u8, b: u8| {
        let found = at_rest(model, lagrangian, [(*only, a), (*only, b)], &coordinates);
        found.ok_or_else(|| {
            unsupported("the second derivatives of the Lagrangian cannot be written as formulas")
                .help("write the Lagrangian with sums, products, powers and elementary functions")
        })
    };
    let (stiffness, mass) = (second(0, 0)?, second(1, 1)?);
    if [&stiffness, &mass].into_iter().any(|part| model.contains_time(part)) {
        return Err(
            unsupported("the Lagrangian depends on the time").help("remove the claims that need a normal frequency")
        );
    }
    let square = node(Node::Quotient(Box::new(stiffness.negated()), Box::new(mass)));
    let formula = node(Node::Root(2, Box::new(square)));
    for omega in model.normal_frequencies.clone() {
        let id = match model.symbols.find(&omega) {
            Some((id, _)) => id,
            None => model.symbols.add(omega, Kind::Scalar).ok_or_else(|| {
                unsupported("this name has another meaning too").help("give the frequency a name of its own")
            })?,
        };
        model.redefine(id, formula.clone());
    }
    Ok(())
}

/// The condition that the normal frequencies in these formulas exist: that the square of each is positive.
pub(crate) fn exist<'f>(formulas: impl Iterator<Item = &'f Expr>, model: &Model) -> Option<Hypothesis> {
    let omega = model.normal_frequencies.first()?;
    let (id, _) = model.symbols.find(omega)?;
    let Some(Meaning::Defined(formula)) = model.meaning(id) else { return None };
    let Node::Root(2, square) = &formula.node else { return None };
    let names = model.normal_frequencies.iter().filter_map(|omega| model.symbols.find(omega));
    let names: Vec<SymbolId> = names.map(|(id, _)| id).collect();
    let mut seen: Vec<SymbolId> = formulas.flat_map(Expr::symbols).map(|(id, _)| id).collect();
    let mut at = 0;
    while let Some(next) = seen.get(at).copied() {
        at += 1;
        if names.contains(&next) {
            let link = Link { lhs: (**square).clone(), relation: Relation::Greater, rhs: number(0), free: Vec::new() };
            return Some(Hypothesis { implied: true, ..Hypothesis::of(link, false) });
        }
        if let Some(Meaning::Defined(formula)) = model.meaning(next) {
            let more: Vec<SymbolId> = formula.symbols().into_iter().map(|(id, _)| id).collect();
            seen.extend(more.into_iter().filter(|id| !seen.contains(id)).collect::<Vec<_>>());
        }
    }
    None
}

/// A second derivative of the Lagrangian where all coordinates and velocities are 0.
fn at_rest(model: &Model, of: SymbolId, by: [(SymbolId, u8); 2], coordinates: &[SymbolId]) -> Option<Expr> {
    let scope = Scope { symbols: &model.symbols, fixed: &[] };
    let mut formula = symbol(of, 0);
    for (id, dots) in by {
        let by = Variable { id, indices: Vec::new(), dots };
        formula = derivative::partial(&formula, &by, scope, Span::default()).ok()?;
    }
    formula.substitute(&|part| match part {
        Node::Symbol { id, .. } if coordinates.contains(id) => Some(number(0)),
        _ => None,
    });
    Some(formula)
}

fn node(node: Node) -> Expr {
    Expr::new(node, Span::default())
}

fn number(value: u32) -> Expr {
    Expr::integer(value, Span::default())
}

fn symbol(id: SymbolId, dots: u8) -> Expr {
    node(Node::Symbol { id, indices: Vec::new(), dots })
}
