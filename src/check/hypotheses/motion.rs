//! Equations of motion: laws that give the highest derivative of a symbol, `m_i \ddot{\vec r}_i = …`, in any form.
//!
//! `\vec F_i = \dot{\vec p}_i` is such a law. With the definitions of p and F inserted it is linear in the second
//! derivative of the positions, with a constant coefficient. Solved for it, the law gives the motion from any positions
//! and velocities. All higher derivatives follow one after the other.
//!
//! # How a law is obeyed
//!
//! A law gives the highest derivative of something, whatever the print calls it. Definitions are inserted until
//! that derivative is found with a coefficient that does not vary, and the law is solved for it. Lower derivatives
//! are initial values; higher ones follow one after the other, all members at once. Solving for the force instead
//! would make every equation of motion a statement about forces: "without external forces P is conserved" would be
//! met by choosing them. If no derivative can be singled out, the law is solved for a free symbol. A law is what
//! the author takes for granted, so it must not be true anyway, and not stand beside a system, which has its own
//! motion.

use crate::formula::{Expr, Index, IndexId, Node, Sign, SymbolId, Term};
use crate::source::Span;

use crate::check::hypotheses::rule::{Action, Rule, letters};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::Meaning;

/// The depth to which definitions are inserted.
const DEPTH: usize = 8;

/// A term of a law: a sign, constant factors, and the factor that varies.
struct Opened {
    sign: Sign,
    fixed: Vec<Expr>,
    core: Expr,
}

/// The rule of a law that gives the highest derivative of a free function of time.
pub(crate) fn motion(model: &Model, hypothesis: &Hypothesis) -> Option<Rule> {
    let mut terms = Vec::new();
    let whole = |expr: &Expr, sign| Opened { sign, fixed: Vec::new(), core: expr.clone() };
    open(model, whole(&hypothesis.lhs, Sign::Plus), 0, DEPTH, &mut terms);
    open(model, whole(&hypothesis.rhs, Sign::Minus), 0, DEPTH, &mut terms);
    let terms = merged(terms);
    for (at, term) in terms.iter().enumerate() {
        let Some((symbol, letters, order)) = derivative(model, &term.core) else { continue };
        let rest: Vec<&Opened> =
            terms.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, term)| term).collect();
        if rest.iter().any(|other| {
            crate::check::model::order::order(model, &other.core, symbol).is_some_and(|known| known >= order)
        }) {
            continue;
        }
        let formula = solved(term, &rest);
        return Some(Rule { symbol, letters, action: Action::EquationOfMotion { order, formula }, throughout: true });
    }
    None
}

/// Terms without repeated derivatives: coefficients of the same one are added, and opposite ones cancel.
fn merged(terms: Vec<Opened>) -> Vec<Opened> {
    let mut found: Vec<Opened> = Vec::new();
    for term in terms {
        let is_rate = matches!(&term.core.node, Node::Symbol { dots: 1.., .. });
        let Some(at) = found.iter().position(|known| is_rate && known.core == term.core) else {
            found.push(term);
            continue;
        };
        if found[at].fixed == term.fixed && found[at].sign != term.sign {
            found.remove(at);
            continue;
        }
        let span = term.core.span;
        let coefficient = |of: &Opened| {
            let mut factors = of.fixed.clone();
            let expr = match factors.len() {
                0 => Expr::integer(1, span),
                1 => factors.swap_remove(0),
                _ => Expr::new(Node::Product(factors), span),
            };
            Term { sign: of.sign, sign_span: None, expr }
        };
        let sum = Expr::new(Node::Sum(vec![coefficient(&found[at]), coefficient(&term)]), span);
        found[at] = Opened { sign: Sign::Plus, fixed: vec![sum], core: term.core };
    }
    found
}

/// The formula −rest / coefficient.
fn solved(term: &Opened, rest: &[&Opened]) -> Expr {
    let span = Span::default();
    let product = |factors: Vec<Expr>| match factors.len() {
        1 => factors.into_iter().next().unwrap_or_else(|| Expr::integer(1, span)),
        _ => Expr::new(Node::Product(factors), span),
    };
    let terms: Vec<Term> = rest
        .iter()
        .map(|other| {
            let sign = if term.sign == Sign::Plus { other.sign.flipped() } else { other.sign };
            let expr = product(other.fixed.iter().cloned().chain([other.core.clone()]).collect());
            Term { sign, sign_span: None, expr }
        })
        .collect();
    let sum = match terms.is_empty() {
        true => Expr::integer(0, span),
        false => Expr::new(Node::Sum(terms), span),
    };
    match term.fixed.is_empty() {
        true => sum,
        false => Expr::new(Node::Quotient(Box::new(sum), Box::new(product(term.fixed.clone()))), span),
    }
}

/// A free function of time under at least one dot, with a different letter for each index, and the number of dots.
fn derivative(model: &Model, core: &Expr) -> Option<(SymbolId, Vec<IndexId>, u8)> {
    let Node::Symbol { id, indices, dots: order @ 1.. } = &core.node else { return None };
    if !matches!(model.meaning(*id)?, Meaning::Varying(_)) {
        return None;
    }
    Some((*id, letters(indices)?, *order))
}

/// Expands sums, products with constants, derivatives and definitions; the term is under `dots` time derivatives.
fn open(model: &Model, term: Opened, dots: u8, depth: usize, into: &mut Vec<Opened>) {
    let Opened { sign, fixed, core } = term;
    let keep = |core: Expr, fixed: Vec<Expr>, into: &mut Vec<Opened>| {
        let span = core.span;
        let core = if dots == 0 { core } else { Expr::new(Node::TimeDerivative(dots, Box::new(core)), span) };
        into.push(Opened { sign, fixed, core });
    };
    match &core.node {
        _ if core.is_null() => {}
        Node::Sum(terms) => {
            for inner in terms {
                let sign = if inner.sign == Sign::Minus { sign.flipped() } else { sign };
                let inner = Opened { sign, fixed: fixed.clone(), core: inner.expr.clone() };
                open(model, inner, dots, depth, into);
            }
        }
        Node::Product(factors) => {
            let (constant, varying): (Vec<&Expr>, Vec<&Expr>) =
                factors.iter().partition(|factor| is_constant(model, factor));
            match varying.as_slice() {
                [only] => {
                    let fixed = fixed.into_iter().chain(constant.into_iter().cloned()).collect();
                    open(model, Opened { sign, fixed, core: (*only).clone() }, dots, depth, into);
                }
                _ => keep(core.clone(), fixed, into),
            }
        }
        Node::TimeDerivative(n, inner) => {
            open(model, Opened { sign, fixed, core: inner.as_ref().clone() }, dots + n, depth, into);
        }
        Node::Symbol { id, indices, dots: own } => {
            let letters = model.symbols.entry(*id).slots.iter().map(|(_, letter)| Index::Letter(*letter));
            match model.meaning(*id) {
                Some(Meaning::Defined(formula)) if depth > 0 && letters.eq(indices.iter().copied()) => {
                    let inner = Opened { sign, fixed, core: formula.as_ref().clone() };
                    open(model, inner, dots + own, depth - 1, into);
                }
                Some(Meaning::Varying(_)) => {
                    let node = Node::Symbol { id: *id, indices: indices.clone(), dots: own + dots };
                    into.push(Opened { sign, fixed, core: Expr::new(node, core.span) });
                }
                _ => keep(core.clone(), fixed, into),
            }
        }
        _ => keep(core.clone(), fixed, into),
    }
}

/// Whether a formula is a constant scalar.
fn is_constant(model: &Model, expr: &Expr) -> bool {
    expr.symbols().iter().all(|(id, _)| match model.meaning(*id) {
        Some(Meaning::Constant(_)) => model.symbols.entry(*id).kind == crate::formula::Kind::Scalar,
        Some(Meaning::Defined(formula)) => is_constant(model, formula),
        _ => false,
    })
}
