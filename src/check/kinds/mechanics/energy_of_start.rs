//! What holds on all motions with the energy of a start from rest.
//!
//! A motion that starts from rest at an equilibrium stays there, and whatever vanishes there holds along it. Authors mean the limit
//! of a small push: the motion that leaves the place has its energy. And where only some derivatives at the start were compared, a
//! term of a higher power is seen only here; so it is for a start of one coordinate with a velocity.

use super::expressions::partial;
use crate::Result;
use crate::check::judge::identity;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::{Meaning, Quantity};
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::formula::symbols::{Kind, Name};
use crate::formula::{Expr, Node, Relation, Sign, SymbolId, Term};
use crate::source::Span;

/// The name of the energy in the model that is made here.
const ENERGY: &str = "\\mathrm{energy}";

/// The most definitions inside each other that are put in.
const DEEPEST: usize = 8;

/// Whether a link holds on all motions with the energy of the start that the hypotheses give; `None`, if that cannot be said.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn holds(link: &Link, context: &Context<'_>) -> Result<Option<bool>> {
    Ok(match check(link, context)?.map(|found| found.verdict) {
        Some(verdict) if verdict.holds() => Some(true),
        Some(Verdict::Refuted) => Some(false),
        _ => None,
    })
}

/// The finding on a link for all motions with the energy of the start that the hypotheses give; `None`, if that energy is not known.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn check(link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
    let model = context.model;
    if model.contains_time(&link.lhs) || model.contains_time(&link.rhs) {
        return Ok(None);
    }
    let Some(at_start) = energy_at_start(context) else { return Ok(None) };
    let mut with = model.clone();
    let Some(id) = with.symbols.add(Name::plain(ENERGY), Kind::Scalar) else { return Ok(None) };
    let entry = with.symbols.entry_mut(id);
    (entry.varies, entry.derived) = (true, true);
    with.mean(id, Meaning::System(Quantity::Energy));
    let energy = Link { lhs: symbol(id), relation: Relation::Equal, rhs: at_start, free: Vec::new() };
    let is_start = |known: &&Hypothesis| start(known, model).is_none();
    let others = context.hypotheses.iter().filter(is_start).cloned();
    let implied = |known: Hypothesis| Hypothesis { implied: true, ..known };
    let hypotheses: Vec<Hypothesis> = others.chain([Hypothesis::of(energy, false)]).map(implied).collect();
    let context = Context { model: &with, hypotheses: &hypotheses, on_shell: Some(true), ..context.quick() };
    identity::check(link, &context).map(Some)
}

/// The energy of a system without forces at the start that the hypotheses give: −L at rest, and q̇ ∂L/∂q̇ − L where one coordinate moves.
fn energy_at_start(context: &Context<'_>) -> Option<Expr> {
    let model = context.model;
    let printed = model.printed_lagrangian.as_ref()?;
    if printed.dissipation.is_some() || !printed.forces.is_empty() {
        return None;
    }
    let (id, _) = model.symbols.find(&printed.lagrangian)?;
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    let mut formula = symbol(id);
    for _ in 0..DEEPEST {
        formula.substitute(&|node| inlined(node, &coordinates, model));
    }
    let starts: Vec<(SymbolId, u8, &Expr)> =
        context.hypotheses.iter().filter_map(|known| start(known, model)).collect();
    let rate_of = |id: &SymbolId| starts.iter().find(|(known, dots, _)| known == id && *dots == 1).map(|(.., v)| *v);
    let is_at_rest = |id: &SymbolId| rate_of(id).is_some_and(Expr::is_null);
    let moving: Vec<SymbolId> = formula
        .symbols()
        .into_iter()
        .filter(|(id, dots)| *dots > 0 && coordinates.contains(id))
        .map(|(id, _)| id)
        .collect();
    // What a constraint of its own holds in its place rests too.
    let is_fixed = |id: &SymbolId| {
        let mut constraints = printed.constraints.iter().map(|(_, formula)| formula);
        constraints.any(|formula| {
            let others: Vec<SymbolId> = coordinates.iter().copied().filter(|other| other != id).collect();
            model.depends_on(formula, &[*id]) && !model.depends_on(formula, &others)
        })
    };
    // Of several coordinates the velocities are not known from the energy.
    let only = match coordinates.as_slice() {
        [only] => rate_of(only).filter(|rate| !rate.is_null()).map(|rate| (*only, rate)),
        _ => None,
    };
    let is_given = |id: &SymbolId| is_at_rest(id) || is_fixed(id) || only.is_some();
    if moving.is_empty() || !moving.iter().all(is_given) || model.contains_time(&formula) {
        return None;
    }
    let term = |sign, expr| Term { sign, sign_span: None, expr };
    let mut terms = vec![term(Sign::Minus, formula.clone())];
    if let Some((q, rate)) = only {
        let momentum = partial(&formula, q, 1, context)?;
        terms.push(term(Sign::Plus, Expr::new(Node::Product(vec![rate.clone(), momentum]), Span::default())));
    }
    let mut formula = Expr::new(Node::Sum(terms), Span::default());
    formula.substitute(&|node| match node {
        Node::Symbol { id, dots, .. } if coordinates.contains(id) && *dots > 0 => Some(match only {
            Some((_, rate)) if *dots == 1 => rate.clone(),
            _ => Expr::integer(0, Span::default()),
        }),
        Node::Symbol { id, .. } => {
            starts.iter().find(|(known, dots, _)| known == id && *dots == 0).map(|(.., value)| (*value).clone())
        }
        _ => None,
    });
    // A coordinate of which nothing says where it starts may be anywhere.
    let is_open = |id: &SymbolId| coordinates.contains(id) && !is_fixed(id);
    (!formula.symbols().iter().any(|(id, _)| is_open(id))).then_some(formula)
}

/// The formula of a name that moves with coordinates.
fn inlined(node: &Node, coordinates: &[SymbolId], model: &Model) -> Option<Expr> {
    let Node::Symbol { id, indices, dots } = node else { return None };
    let Some(Meaning::Defined(formula)) = model.meaning(*id) else { return None };
    if !indices.is_empty() || model.symbols.entry(*id).squared || !model.depends_on(formula, coordinates) {
        return None;
    }
    let formula = Expr::clone(formula);
    Some(match dots {
        0 => formula,
        dots => Expr::new(Node::TimeDerivative(*dots, Box::new(formula)), Span::default()),
    })
}

/// The coordinate to which a hypothesis gives a value at the start, with its dots.
fn start<'h>(known: &'h Hypothesis, model: &Model) -> Option<(SymbolId, u8, &'h Expr)> {
    match &known.lhs.node {
        Node::Symbol { id, dots, .. }
            if *dots < 2 && known.relation == Relation::Equal && model.is_coordinate(*id) && !known.throughout =>
        {
            Some((*id, *dots, &known.rhs))
        }
        _ => None,
    }
}

fn symbol(id: SymbolId) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default())
}
