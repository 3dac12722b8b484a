//! Tautologies: equations of which one side is the other with its terms and factors in another order.
//!
//! a + b = a could be corrected by adding −b, which gives a = a. No author prints that, so it is not a repair. Authors
//! do print identities with a step in them: a sum expanded, a square or a sine rewritten, like terms collected. A
//! mistake in such an identity is corrected like any other.

use std::mem::discriminant;

use crate::formula::tree::{Function, Sign};
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;

use crate::check::model::Model;
use crate::check::model::claim::{Link, is_equality};
use crate::check::vacuity::monomials;
use crate::check::vacuity::monomials::{Monomial, add};

/// Whether an edit makes a display trivial: an equation in it now equates a side with itself, a side of an
/// approximation has become 0, or its one symbol has been replaced by one of another kind. A derivative or an integral that
/// `is_written_out` is read as its value, and that it has this value is no triviality.
pub(crate) fn is_lost(
    before: &Reading,
    after: &Reading,
    model: &Model,
    is_written_out: &dyn Fn(&Expr) -> bool,
) -> bool {
    before.statements.iter().zip(&after.statements).any(|pair| match pair {
        (Ok(before), Ok(after)) if before.members.len() == after.members.len() => {
            let links = before.members.windows(2).zip(after.members.windows(2)).zip(&after.relations);
            let mut changed = links.filter(|((before, after), _)| before != after);
            subject_is_gone(before, after, model)
                || changed.any(|((before, after), (relation, _))| match relation {
                    Relation::Approximately => {
                        let becomes_zero = |(before, after): (&Expr, &Expr)| {
                            after.is_null() && !before.is_null() && !before.symbols().is_empty()
                        };
                        before.iter().zip(after.iter()).any(becomes_zero)
                            || becomes_trivial(before, after, is_written_out)
                    }
                    relation => is_equality(*relation) && becomes_trivial(before, after, is_written_out),
                })
        }
        _ => false,
    })
}

/// Whether one formula is the other with terms and factors in another order, also inside of functions.
pub(crate) fn is_reordered(a: &Expr, b: &Expr) -> bool {
    if a == b || same(&collected(a), &collected(b)) {
        return true;
    }
    let blank = |expr: &Expr| {
        let mut outer = expr.clone();
        outer.children_mut().into_iter().for_each(|child| *child = Expr::integer(0, child.span));
        outer
    };
    let (inner_a, inner_b) = (a.children(), b.children());
    let alike = || inner_a.iter().zip(&inner_b).all(|(a, b)| is_reordered(a, b));
    !inner_a.is_empty() && inner_a.len() == inner_b.len() && blank(a) == blank(b) && alike()
}

/// Whether an equation, as it is written, is linear in a symbol, so that it has one solution.
pub(crate) fn is_linear_in(link: &Link, symbol: SymbolId) -> bool {
    fn degree(expr: &Expr, symbol: SymbolId) -> usize {
        match &expr.node {
            Node::Symbol { id, .. } => usize::from(*id == symbol),
            Node::Sum(terms) => terms.iter().map(|term| degree(&term.expr, symbol)).max().unwrap_or(0),
            Node::Product(factors) => factors.iter().map(|factor| degree(factor, symbol)).sum(),
            Node::Quotient(a, b) if degree(b, symbol) == 0 => degree(a, symbol),
            Node::TimeDerivative(_, inner) => degree(inner, symbol),
            // The symbol inside of any other node counts as quadratic.
            _ => 2 * expr.children().into_iter().map(|child| degree(child, symbol)).max().unwrap_or(0),
        }
    }
    degree(&link.lhs, symbol).max(degree(&link.rhs, symbol)) == 1
}

/// Whether an edit turns an equation into a reordering, and it was not an identity with a step in it.
fn becomes_trivial(before: &[Expr], after: &[Expr], is_written_out: &dyn Fn(&Expr) -> bool) -> bool {
    let ([a, b], [left, right]) = (before, after) else { return false };
    let (left, right) = (&at_zero(left), &at_zero(right));
    let says_nothing = is_reordered(left, right) || monomials::cancels(left, right);
    if !says_nothing || ![a, b].into_iter().all(is_collected) || is_written_out(left) != is_written_out(right) {
        return false;
    }
    // The equation was a sum in another order, with a mistake in a sign, a number or a power.
    let (first, second) = (collected(a), collected(b));
    let sums = first.len() > 1 && second.len() > 1;
    let atoms = |terms: &[Monomial]| terms.iter().flat_map(|term| term.factors.clone()).collect::<Vec<_>>();
    let (of_first, of_second) = (atoms(&first), atoms(&second));
    let within = |some: &[(Expr, f64)], all: &[(Expr, f64)]| {
        some.iter().all(|(base, _)| all.iter().any(|(known, _)| known == base))
    };
    !(sums && within(&of_first, &of_second) && within(&of_second, &of_first))
}

/// A formula with the values of functions at 0 inserted.
fn at_zero(expr: &Expr) -> Expr {
    let mut written = expr.clone();
    for child in written.children_mut() {
        *child = at_zero(child);
    }
    let value = match &written.node {
        Node::Call(Function::Cos | Function::Cosh | Function::Exp | Function::Sec, of) if of.is_zero() => 1,
        Node::Call(Function::Sin | Function::Tan | Function::Sinh | Function::Tanh, of) if of.is_zero() => 0,
        Node::Call(Function::Arcsin | Function::Arctan, of) if of.is_zero() => 0,
        _ => return written,
    };
    Expr::integer(value, expr.span)
}

/// Whether an edit cancels a term in its own sum, or makes a whole side a term of the other side. Then the other term
/// is the wrong one. If a sum had the term twice, its sign may have been wrong.
pub(crate) fn is_taken_back(before: &Reading, after: &Reading) -> bool {
    let statements = before.statements.iter().flatten().zip(after.statements.iter().flatten());
    before.statements.len() == after.statements.len() && statements.into_iter().any(|(b, a)| takes_back(b, a))
}

fn takes_back(before: &Statement, after: &Statement) -> bool {
    let twice: Vec<Monomial> = alike(before).filter(|(_, count, _)| *count > 1).map(|(kind, ..)| kind).collect();
    let is_new = |kind: &Monomial| !twice.iter().any(|known| known.is_like(kind));
    let in_sum = alike(after).any(|(kind, count, left)| count > 1 && left == 0.0 && is_new(&kind));
    in_sum || !has_side_on_the_other(before) && has_side_on_the_other(after)
}

/// The like terms of all sums of a statement, with their number and the sum of their coefficients.
fn alike(statement: &Statement) -> impl Iterator<Item = (Monomial, usize, f64)> {
    let mut found: Vec<(Monomial, usize, f64)> = Vec::new();
    let mut within = |part: &Expr| {
        let Node::Sum(terms) = &part.node else { return };
        let start = found.len();
        for term in terms.iter().filter(|term| !term.expr.is_zero()) {
            let kind = Monomial::of(&term.expr);
            let coefficient = if term.sign == Sign::Minus { -kind.coefficient } else { kind.coefficient };
            match found[start..].iter_mut().find(|(known, ..)| known.is_like(&kind)) {
                Some((_, count, sum)) => (*count, *sum) = (*count + 1, *sum + coefficient),
                None => found.push((kind, 1, coefficient)),
            }
        }
    };
    statement.members.iter().for_each(|member| member.walk(&mut within));
    found.into_iter()
}

/// Whether a side is a single term that is also a term of the other side.
fn has_side_on_the_other(statement: &Statement) -> bool {
    let is_among = |one: &[Monomial], all: &[Monomial]| {
        one.len() == 1 && all.len() > 1 && all.iter().any(|term| same(one, std::slice::from_ref(term)))
    };
    statement.members.windows(2).zip(&statement.relations).any(|(sides, (relation, _))| {
        let (a, b) = (collected(&sides[0]), collected(&sides[1]));
        is_equality(*relation) && (is_among(&a, &b) || is_among(&b, &a))
    })
}

/// Whether the only symbol of a statement has been replaced by one of another kind.
fn subject_is_gone(before: &Statement, after: &Statement, model: &Model) -> bool {
    let symbols = |statement: &Statement| {
        let mut all: Vec<SymbolId> = Vec::new();
        for (id, _) in statement.members.iter().flat_map(Expr::symbols) {
            if !all.contains(&id) {
                all.push(id);
            }
        }
        all
    };
    match (symbols(before).as_slice(), symbols(after).as_slice()) {
        ([was], [is]) if was != is => model.meaning(*was).map(discriminant) != model.meaning(*is).map(discriminant),
        _ => false,
    }
}

/// The terms of a formula, with like terms combined. Sums inside of products are not expanded.
fn collected(expr: &Expr) -> Vec<Monomial> {
    fn gather(expr: &Expr, sign: f64, terms: &mut Vec<Monomial>) {
        match &expr.node {
            Node::Sum(all) => {
                for term in all {
                    gather(&term.expr, if term.sign == Sign::Minus { -sign } else { sign }, terms);
                }
            }
            _ => {
                let term = Monomial::of(expr);
                if term.coefficient != 0.0 {
                    add(terms, Monomial { coefficient: sign * term.coefficient, ..term });
                }
            }
        }
    }
    let mut terms = Vec::new();
    gather(expr, 1.0, &mut terms);
    terms
}

/// Whether two sums have the same terms.
fn same(a: &[Monomial], b: &[Monomial]) -> bool {
    let is_one = |x: &Monomial, y: &Monomial| {
        x.is_like(y) && (x.coefficient - y.coefficient).abs() <= 1e-12 * x.coefficient.abs()
    };
    a.len() == b.len() && a.iter().all(|x| b.iter().any(|y| is_one(x, y)))
}

/// Whether a formula is written with collected terms: no two are alike, and none has a factor twice.
fn is_collected(expr: &Expr) -> bool {
    fn factors(expr: &Expr, numbers: &mut usize) -> Option<usize> {
        match &expr.node {
            Node::Number(_) => {
                *numbers += 1;
                Some(0)
            }
            Node::Product(all) => all.iter().map(|factor| factors(factor, numbers)).sum(),
            Node::Quotient(a, b) => {
                let (mut above, mut below) = (0, 0);
                let all = factors(a, &mut above)? + factors(b, &mut below)?;
                *numbers += above.max(below);
                Some(all)
            }
            Node::Root(_, base) if matches!(base.node, Node::Number(_)) => {
                *numbers += 1;
                Some(0)
            }
            Node::Power(base, _) | Node::Root(_, base)
                if matches!(base.node, Node::Product(_) | Node::Quotient(..) | Node::Power(..) | Node::Root(..)) =>
            {
                None
            }
            Node::Sum(_) => None,
            _ => Some(1),
        }
    }
    let terms: Vec<&Expr> = match &expr.node {
        Node::Sum(terms) => terms.iter().map(|term| &term.expr).filter(|term| !term.is_zero()).collect(),
        _ if expr.is_zero() => Vec::new(),
        _ => vec![expr],
    };
    let is_plain = |term: &&Expr| {
        let mut numbers = 0;
        factors(term, &mut numbers) == Some(Monomial::of(term).factors.len()) && numbers < 2
    };
    terms.len() == collected(expr).len() && terms.iter().all(is_plain)
}
