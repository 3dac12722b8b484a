//! Series whose further terms are left out: A = B + … says that A and B agree up to terms of higher order than the last one
//! printed, in the symbol whose power grows from term to term. A = B + O(xⁿ) says so up to terms of the order n in x.
//!
//! Which symbol is small, and the order, are taken from the printed terms. The rest is that of a claim with `small`
//! ([`super::small`]).

use crate::Result;
use crate::code::Code;
use crate::formula::tree::Term;
use crate::formula::{Expr, Node, SymbolId, text};

use crate::check::kinds::small;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::free_symbols::drawn;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::verdict::finding::Finding;

/// The deepest chain of definitions.
const DEEPEST: usize = 8;

/// The highest order that is tested.
const HIGHEST: f64 = 9.0;

/// The sides of a relation, as far as terms are left out in them.
pub(crate) enum Read {
    /// No terms are left out.
    Plain,
    /// The sides without what stands for terms that are left out; others say what is small.
    Cut(Link),
    /// What is small, and to which order.
    Series(Series),
    /// Nothing says what is small.
    Unclear(String),
}

/// A relation that holds up to terms of a higher order.
pub(crate) struct Series {
    /// The relation, without what stands for the terms that are left out.
    pub link: Link,
    /// The symbol that is small.
    pub small: SymbolId,
    /// The order of the last printed term.
    pub order: u32,
}

/// Reads a link in which terms may be left out. With `is_inferred` nothing but the terms says what is small.
pub(crate) fn of(link: &Link, is_inferred: bool, model: &Model) -> Read {
    if ![&link.lhs, &link.rhs].iter().any(|side| has_rest(side)) {
        return Read::Plain;
    }
    let cut = |side: &Expr| without_rest(side).unwrap_or_else(|| Expr::integer(0, side.span));
    let cut = Link { lhs: cut(&link.lhs), rhs: cut(&link.rhs), ..link.clone() };
    if !is_inferred {
        return Read::Cut(cut);
    }
    // Where no name is drawn at random, the time may be small.
    let time = model.symbols.time.as_ref().and_then(|time| model.symbols.find(time)).map(|(id, _)| id);
    let names = drawn(&[&link.lhs, &link.rhs], model);
    let names: Vec<SymbolId> = names.iter().copied().chain(time.filter(|id| !names.contains(id))).collect();
    let is_number = |id: &SymbolId| model.symbols.entry(*id).slots.is_empty();
    let found = names.into_iter().filter(is_number).find_map(|small| {
        let orders = [&link.lhs, &link.rhs].map(|side| last_order(side, small, model));
        // Where both sides leave terms out, the lower order counts.
        let order = match orders {
            [Some(a), Some(b)] => a.min(b),
            [Some(order), None] if !has_rest(&link.rhs) => order,
            [None, Some(order)] if !has_rest(&link.lhs) => order,
            _ => return None,
        };
        let is_whole = order.fract() == 0.0 && (0.0..=HIGHEST).contains(&order);
        is_whole.then_some((small, order as u32))
    });
    match found {
        Some((small, order)) => Read::Series(Series { link: cut, small, order }),
        None => Read::Unclear(
            "the order of the terms that are left out is unknown, because no symbol has a power that grows from term \
             to term; name the small quantity under \"small\" in the claims file"
                .to_owned(),
        ),
    }
}

impl Series {
    /// Checks the relation to its order.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub fn check(&self, context: &Context<'_>) -> Result<Finding> {
        let found = small::check(&self.link, &self.small_names(), self.order, context)?;
        let name = text::plain(&context.model.name(self.small));
        // The message on an order names the letter.
        if found.code == Code::OrderDiffers {
            return Ok(found);
        }
        let message = format!("{}; {name} is taken to be small", found.message);
        Ok(Finding { message, ..found })
    }

    /// The small symbol, as a formula.
    pub fn small_names(&self) -> Vec<Expr> {
        let node = Node::Symbol { id: self.small, indices: Vec::new(), dots: 0 };
        vec![Expr::new(node, self.link.lhs.span)]
    }
}

/// Whether terms are left out in a formula.
pub(crate) fn has_rest(expr: &Expr) -> bool {
    let mut found = false;
    expr.walk(&mut |part| found |= matches!(part.node, Node::Rest(_)));
    found
}

/// A formula without what stands for terms that are left out; `None` if nothing remains.
fn without_rest(expr: &Expr) -> Option<Expr> {
    match &expr.node {
        Node::Rest(_) => None,
        Node::Sum(terms) => {
            let keep = |term: &Term| Some(Term { expr: without_rest(&term.expr)?, ..term.clone() });
            let mut kept: Vec<Term> = terms.iter().filter_map(keep).collect();
            match kept.as_slice() {
                [] => None,
                [only] if only.sign == crate::formula::Sign::Plus => Some(kept.swap_remove(0).expr),
                _ => Some(Expr::new(Node::Sum(kept), expr.span)),
            }
        }
        _ => {
            let mut whole = expr.clone();
            for child in whole.children_mut() {
                *child = without_rest(child)?;
            }
            Some(whole)
        }
    }
}

/// The order in a symbol of the last term of a sum whose powers of it grow from term to term.
pub(crate) fn order_of_sum(expr: &Expr, small: SymbolId, model: &Model) -> Option<u32> {
    let order = last_order(&with_rest(expr)?, small, model)?;
    (order.fract() == 0.0 && (0.0..=HIGHEST).contains(&order)).then_some(order as u32)
}

/// A formula, where terms are left out at the end of the one sum in it that is no argument.
fn with_rest(expr: &Expr) -> Option<Expr> {
    let mut whole = expr.clone();
    match &mut whole.node {
        Node::Sum(terms) if terms.len() > 1 => {
            let rest = Expr::new(Node::Rest(Vec::new()), expr.span);
            terms.push(Term { sign: crate::formula::Sign::Plus, sign_span: None, expr: rest });
        }
        Node::Product(factors) => {
            let sum = factors.iter_mut().find(|factor| matches!(factor.node, Node::Sum(_)))?;
            *sum = with_rest(sum)?;
        }
        Node::Quotient(above, _) => **above = with_rest(above)?,
        _ => return None,
    }
    Some(whole)
}

/// The order in a symbol of the last term before those that are left out in a formula. Factors around the sum raise it.
fn last_order(expr: &Expr, small: SymbolId, model: &Model) -> Option<f64> {
    let power = |of: &Expr| power(of, small, model, 0);
    match &expr.node {
        Node::Sum(terms) => match terms.split_last() {
            Some((Term { expr: Expr { node: Node::Rest(order), .. }, .. }, printed)) => {
                let own: Option<Vec<f64>> = printed.iter().map(|term| power(&term.expr)).collect();
                match order.iter().find(|(id, _)| *id == small) {
                    Some((_, power)) => Some(f64::from(*power) - 1.0).filter(|order| *order >= 0.0),
                    // What an order names is small, and nothing else is.
                    None if !order.is_empty() => None,
                    None => {
                        let own = own?;
                        let grows = own.len() > 1 && own.windows(2).all(|pair| pair[1] > pair[0] + 1e-9);
                        own.last().copied().filter(|_| grows)
                    }
                }
            }
            // Beside other terms.
            _ => {
                let mut inside = terms.iter().filter(|term| has_rest(&term.expr));
                let only = inside.next().filter(|_| inside.next().is_none())?;
                last_order(&only.expr, small, model)
            }
        },
        Node::Product(factors) => {
            let mut total = 0.0;
            let mut inside = 0;
            for factor in factors {
                total += match has_rest(factor) {
                    true => {
                        inside += 1;
                        last_order(factor, small, model)?
                    }
                    false => power(factor)?,
                };
            }
            (inside == 1).then_some(total)
        }
        Node::Quotient(above, below) if !has_rest(below) => Some(last_order(above, small, model)? - power(below)?),
        _ => None,
    }
}

/// The power of a symbol in a product of powers; `None` for any other formula of it.
fn power(expr: &Expr, of: SymbolId, model: &Model, depth: usize) -> Option<f64> {
    let again = |inner: &Expr| power(inner, of, model, depth);
    if !model.depends_on(expr, &[of]) {
        return Some(0.0);
    }
    match &expr.node {
        Node::Symbol { id, indices, dots: 0 } if indices.is_empty() => match model.meaning(*id) {
            _ if *id == of => Some(1.0),
            Some(Meaning::Defined(formula)) if depth < DEEPEST => power(formula, of, model, depth + 1),
            _ => None,
        },
        Node::Sum(terms) => {
            let powers: Option<Vec<f64>> = terms.iter().map(|term| again(&term.expr)).collect();
            let powers = powers?;
            let first = *powers.first()?;
            powers.iter().all(|power| (power - first).abs() < 1e-9).then_some(first)
        }
        Node::Product(factors) => factors.iter().map(again).sum(),
        Node::Quotient(above, below) => Some(again(above)? - again(below)?),
        Node::Power(base, exponent) => {
            let exponent = crate::formula::evaluate::constant_exponent(exponent)?;
            Some(again(base)? * exponent.value())
        }
        Node::Root(degree, inner) => Some(again(inner)? / f64::from(*degree)),
        _ => None,
    }
}
