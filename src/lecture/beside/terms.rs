//! The terms of a formula, with their signs.

use crate::formula::{Expr, Node, Sign, Term};
use crate::source::Span;

/// The terms of a sum; a formula that is no sum is one term.
pub(super) fn terms(formula: &Expr) -> Vec<Expr> {
    let Node::Sum(terms) = &formula.node else { return vec![formula.clone()] };
    let signed = |term: &Term| {
        let inner = self::terms(&term.expr).into_iter();
        inner.map(|expr| if term.sign == Sign::Minus { negated(expr) } else { expr }).collect::<Vec<_>>()
    };
    terms.iter().flat_map(signed).collect()
}

/// A term multiplied out over one sum in it; `None` if it contains none as a factor.
pub(super) fn multiplied_out(term: &Expr) -> Option<Vec<Expr>> {
    match &term.node {
        Node::Sum(terms) if terms.len() == 1 => {
            let parts = multiplied_out(&terms[0].expr)?;
            let is_minus = terms[0].sign == Sign::Minus;
            Some(parts.into_iter().map(|part| if is_minus { negated(part) } else { part }).collect())
        }
        Node::Product(factors) => {
            let at = factors.iter().position(|factor| matches!(&factor.node, Node::Sum(terms) if terms.len() > 1))?;
            let with = |part: Expr| {
                let (part, is_minus) = unsigned(part);
                let mut own = factors.clone();
                own[at] = part;
                let product = Expr::new(Node::Product(own), Span::default());
                if is_minus { negated(product) } else { product }
            };
            Some(terms(&factors[at]).into_iter().map(with).collect())
        }
        Node::Quotient(above, below) => {
            let parts = match &above.node {
                Node::Sum(of) if of.len() > 1 => terms(above),
                _ => multiplied_out(above)?,
            };
            let over = |part: Expr| {
                let (part, is_minus) = unsigned(part);
                let quotient = Expr::new(Node::Quotient(Box::new(part), below.clone()), Span::default());
                if is_minus { negated(quotient) } else { quotient }
            };
            Some(parts.into_iter().map(over).collect())
        }
        _ => None,
    }
}

fn unsigned(term: Expr) -> (Expr, bool) {
    match &term.node {
        Node::Sum(terms) if terms.len() == 1 && terms[0].sign == Sign::Minus => (terms[0].expr.clone(), true),
        _ => (term, false),
    }
}

fn negated(term: Expr) -> Expr {
    match unsigned(term) {
        (term, true) => term,
        (term, false) => {
            Expr::new(Node::Sum(vec![Term { sign: Sign::Minus, sign_span: None, expr: term }]), Span::default())
        }
    }
}
