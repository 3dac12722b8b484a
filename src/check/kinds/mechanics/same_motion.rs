//! Two Lagrangians with the same motion: equal up to d/dt of a function, a constant, or a constant factor.
//!
//! The Euler–Lagrange expressions of both are formed, one for each coordinate, and must be equal whatever the motion. If they are
//! not, the ratio of the masses in them may be a constant factor. The function of which the difference is the rate is named
//! where it is a polynomial: it is ∫₀¹ (Σ qᵢ aᵢ(λq, t) + t b(0, λt)) dλ for the difference Σ aᵢ q̇ᵢ + b. Boole's rule has this
//! integral exactly up to the fifth power of λ, and its rate is compared with the difference again.

use crate::Result;
use crate::code::Code;
use crate::formula::tree::{Sign, Term};
use crate::formula::{Expr, Node, SymbolId, Value, text};
use crate::source::Span;

use super::expressions::{equal, euler_lagrange, lagrangian, partial, rate};
use crate::check::judge::{difference, identity};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::scalar::Symbol;

/// The nodes of Boole's rule in quarters, and their weights in ninetieths.
const BOOLE: [(u32, u32); 5] = [(0, 7), (1, 32), (2, 12), (3, 32), (4, 7)];

/// Checks that `ours` has the same motion as `other`, another Lagrangian of the document.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn check(ours: &Expr, other: &Expr, context: &Context<'_>) -> Result<Finding> {
    let shown = text::formula(other, &context.model.symbols);
    let unsupported = || {
        let message = format!(
            "the equations of motion of this Lagrangian or of {shown} cannot be written as formulas; \
             write both with sums, products, powers and elementary functions"
        );
        context.finding(Code::NotSupported, Verdict::Undecided, message)
    };
    let coordinates = coordinates(context);
    if coordinates.is_empty() {
        let message = "a Lagrangian needs coordinates; declare them under \"coordinates\"";
        return Ok(context.finding(Code::NotSupported, Verdict::Undecided, message));
    }
    let equations = |of: &Expr| coordinates.iter().map(|q| euler_lagrange(of, *q, context)).collect::<Option<Vec<_>>>();
    let (Some(of_ours), Some(of_other)) = (equations(ours), equations(other)) else { return Ok(unsupported()) };
    let opened = |side: &Expr| written_out(side, context);
    if opened(ours) == opened(other) {
        let message =
            format!("this is the same formula as {shown}, so nothing is checked; write another Lagrangian here");
        return Ok(context.finding(Code::SameFormula, Verdict::Undecided, message));
    }
    let off_shell = Context { on_shell: Some(false), ..*context }.quick();
    let found = all_equal(&of_ours, &of_other, &off_shell)?;
    if found.verdict.holds() {
        let how = match total_derivative(ours, other, &coordinates, &off_shell)? {
            Some(what) => format!("; they differ by {what}"),
            None => "; they differ by a total time derivative".to_owned(),
        };
        return Ok(Finding { message: format!("gives the same motion as {shown}{how}"), ..found });
    }
    if found.verdict != Verdict::Refuted {
        return Ok(found);
    }
    if let Some((factor, found)) = factor((ours, &of_ours), (other, &of_other), &coordinates, &off_shell)? {
        let factor = printed(&factor, &off_shell).unwrap_or_else(|| "a constant".to_owned());
        return Ok(Finding {
            message: format!("gives the same motion as {shown}; it is {factor} times {shown}"),
            ..found
        });
    }
    let message = format!(
        "this does not give the same motion as {shown}; below, the sides are d/dt ∂L/∂q̇ − ∂L/∂q of this formula and \
         of {shown}"
    );
    let refuted = Finding { message, code: Code::SidesDiffer, ..found };
    // The equations of one may be combinations of those of the other. So ours are tested along the motions of the other one.
    let is_system =
        lagrangian(context).is_some_and(|lagrangian| lagrangian.as_plain_symbol() == other.as_plain_symbol());
    let zeros: Vec<Expr> = of_ours.iter().map(|of| Expr::integer(0, of.span)).collect();
    let along = match is_system {
        true => all_equal(&of_ours, &zeros, &Context { on_shell: Some(true), ..*context }.quick())?.verdict,
        false => Verdict::Undecided,
    };
    if along == Verdict::Refuted {
        return Ok(refuted);
    }
    let message = format!(
        "the equations of motion are not those of {shown} one by one; combined, they may give the same motion, so \
         this was not decided"
    );
    Ok(context.finding(Code::NotDecided, Verdict::Undecided, message))
}

/// The coordinates of the document, in their order.
fn coordinates(context: &Context<'_>) -> Vec<SymbolId> {
    let model = context.model;
    match model.coordinates.is_empty() {
        false => model.coordinates.iter().map(|coordinate| coordinate.symbol).collect(),
        true => model.symbols.canonical.iter().map(|(q, _)| *q).collect(),
    }
}

/// The worst finding on several equalities. The right sides are steps of their own, so that equal formulas can be compared.
fn all_equal(left: &[Expr], right: &[Expr], context: &Context<'_>) -> Result<Finding> {
    let mut worst: Option<Finding> = None;
    let is_nothing = |(lhs, rhs): &(&Expr, &Expr)| lhs == rhs && left.iter().zip(right).any(|(a, b)| a != b);
    for (lhs, rhs) in left.iter().zip(right).filter(|pair| !is_nothing(pair)) {
        let step = Term { sign: Sign::Plus, sign_span: None, expr: rhs.clone() };
        let rhs = Expr::new(Node::Sum(vec![step]), rhs.span);
        let found = identity::check(&equal(lhs, &rhs), context)?;
        let rank = |finding: &Finding| match finding.verdict {
            Verdict::Certified => 0,
            Verdict::Verified => 1,
            Verdict::Refuted => 3,
            _ => 2,
        };
        let sum = worst.as_ref().and_then(|known| known.false_accept_log2).zip(found.false_accept_log2);
        worst = Some(match worst {
            Some(known) if rank(&known) >= rank(&found) => known,
            _ => found,
        });
        if let (Some(worst), Some((a, b))) = (&mut worst, sum) {
            worst.false_accept_log2 = Some((a.exp2() + b.exp2()).log2());
        }
    }
    Ok(worst.unwrap_or_else(|| {
        context.finding(Code::NotDecided, Verdict::Undecided, "a Lagrangian needs coordinates to be compared")
    }))
}

/// The constant factor between two Lagrangians, with the finding on their equations of motion.
fn factor(
    (ours, of_ours): (&Expr, &[Expr]),
    (other, of_other): (&Expr, &[Expr]),
    coordinates: &[SymbolId],
    context: &Context<'_>,
) -> Result<Option<(Expr, Finding)>> {
    let mass = |of: &Expr, q: SymbolId| {
        let inner = partial(of, q, 1, context)?;
        partial(&inner, q, 1, context).filter(|mass| !mass.is_zero())
    };
    let ratio = |q: &SymbolId| {
        let (above, below) = (mass(ours, *q)?, mass(other, *q)?);
        Some(Expr::new(Node::Quotient(Box::new(above), Box::new(below)), ours.span))
    };
    let Some(ratio) = coordinates.iter().find_map(ratio) else { return Ok(None) };
    let scaled = |equation: &Expr| Expr::new(Node::Product(vec![ratio.clone(), equation.clone()]), ours.span);
    let found = all_equal(of_ours, &of_other.iter().map(scaled).collect::<Vec<_>>(), context)?;
    // It is constant if it is the same for all motions: the states are off shell.
    let steady = equal(&rate(ratio.clone()), &Expr::integer(0, ours.span));
    let is_constant = is_free_of_motion(&ratio, context) || identity::check(&steady, &context.quick())?.verdict.holds();
    Ok((found.verdict.holds() && is_constant).then_some((ratio, found)))
}

/// Whether a formula contains constants only.
fn is_free_of_motion(formula: &Expr, context: &Context<'_>) -> bool {
    formula.symbols().iter().all(|(id, _)| match context.model.meaning(*id) {
        Some(Meaning::Constant(_)) => true,
        Some(Meaning::Defined(formula)) => is_free_of_motion(formula, context),
        _ => false,
    })
}

/// What the difference of two Lagrangians is, in words, where it is a constant or the rate of a polynomial.
fn total_derivative(
    ours: &Expr,
    other: &Expr,
    coordinates: &[SymbolId],
    context: &Context<'_>,
) -> Result<Option<String>> {
    let whole = ours.clone().minus(other.clone());
    let mut factors = Vec::new();
    for q in coordinates {
        let Some(factor) = partial(&whole, *q, 1, context) else { return Ok(None) };
        factors.push((*q, factor));
    }
    let node = |node: Node| Expr::new(node, ours.span);
    let number = |value: u32| Expr::integer(value, ours.span);
    let time = context.model.symbols.time.as_ref().and_then(|name| context.model.symbols.find(name)).map(|(id, _)| id);
    let mut still = written_out(&whole, context);
    still.substitute(&|part| match part {
        Node::Symbol { id, .. } if coordinates.contains(id) => Some(number(0)),
        _ => None,
    });
    let depends_on_time = still.symbols().iter().any(|(id, _)| Some(*id) == time);
    if !depends_on_time && identity::check(&equal(&whole, &still), &context.quick())?.verdict.holds() {
        return Ok(printed(&still, context).map(|constant| format!("the constant {constant}")));
    }
    let plain = |id: SymbolId| node(Node::Symbol { id, indices: Vec::new(), dots: 0 });
    let mut terms = Vec::new();
    for (quarters, weight) in BOOLE {
        let scaled = |id: SymbolId| match quarters {
            0 => number(0),
            4 => plain(id),
            _ => node(Node::Quotient(
                Box::new(node(Node::Product(vec![number(quarters), plain(id)]))),
                Box::new(number(4)),
            )),
        };
        let weighted = |factors: Vec<Expr>| {
            let above = node(Node::Product(std::iter::once(number(weight)).chain(factors).collect()));
            let expr = node(Node::Quotient(Box::new(above), Box::new(number(90))));
            Term { sign: Sign::Plus, sign_span: None, expr }
        };
        for (q, factor) in factors.iter().filter(|(_, factor)| !factor.is_zero()) {
            let mut at = factor.clone();
            at.substitute(&|part| match part {
                Node::Symbol { id, dots: 0, .. } if coordinates.contains(id) => Some(scaled(*id)),
                _ => None,
            });
            terms.push(weighted(vec![plain(*q), at]));
        }
        let Some(time) = time else { continue };
        let mut at = written_out(&whole, context);
        at.substitute(&|part| match part {
            Node::Symbol { id, .. } if coordinates.contains(id) => Some(number(0)),
            Node::Symbol { id, dots: 0, .. } if *id == time => Some(scaled(time)),
            _ => None,
        });
        terms.push(weighted(vec![plain(time), at]));
    }
    let function = node(Node::Sum(terms));
    let link = equal(&rate(function.clone()), &whole);
    if !identity::check(&link, &context.quick())?.verdict.holds() {
        return Ok(None);
    }
    Ok(printed(&function, context).map(|function| format!("d/dt of {function}")))
}

/// A formula with all definitions inserted, as far as they have no rate.
fn written_out(formula: &Expr, context: &Context<'_>) -> Expr {
    const DEEPEST: usize = 8;
    let mut formula = formula.clone();
    for _ in 0..DEEPEST {
        formula.substitute(&|part| match part {
            Node::Symbol { id, indices, dots: 0 } if indices.is_empty() => match context.model.meaning(*id) {
                Some(Meaning::Defined(inner)) => {
                    let mut inner = inner.as_ref().clone();
                    inner.move_to(Span::default());
                    Some(inner)
                }
                _ => None,
            },
            _ => None,
        });
    }
    formula
}

/// A formula in normal form, as text.
fn printed(formula: &Expr, context: &Context<'_>) -> Option<String> {
    let link = equal(formula, &Expr::integer(0, formula.span));
    let ensemble = context.ensemble(context.mode(false, &[formula]), false, 1).ok()?;
    let numbers = |state: &SampledState<'_, Symbol>| match state.now(formula, &[]) {
        Ok(Value::Scalar(value)) => Some((value, Symbol::from(0.0))),
        _ => None,
    };
    let found = difference::normal(context.model, &ensemble, &link, &numbers)?;
    Some(text::formula(&found, &context.model.symbols))
}
