//! Whether two equalities are the same but for their letters, exactly or but for slips.
//!
//! A slip changes a sign, a number, a power, a dot, or one of sine, cosine and tangent. So much may differ that only a hand-in in which
//! nothing else says what its letters are is compared in this way.

use crate::formula::{Expr, Function, Node, Sign, SymbolId};
use crate::source::Span;

/// What may differ beside the letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Likeness {
    /// Nothing.
    Same,
    /// What a slip changes.
    ButForSlips,
}

/// Letters of the hand-in with those of the problem to which they correspond.
pub(super) type Pairs = Vec<(SymbolId, SymbolId)>;

/// An equality: its sides.
type Sides = (Expr, Expr);

/// Whether two equalities of several terms are the same but for their letters and for the sides on which the terms stand.
pub(super) fn is_rearranged(likeness: Likeness, line: &Sides, display: &Sides, pairs: &mut Pairs) -> bool {
    let (own, other) = (terms(line), terms(display));
    let flipped = |(sign, term): &(Sign, _)| (sign.flipped(), *term);
    (own.len() >= FEWEST_TERMS || own.len() == 2 && letters(line) >= FEWEST_LETTERS)
        && [own.clone(), own.iter().map(flipped).collect()].iter().any(|own| {
            in_some_order(own, &other, pairs, &|a: (Sign, &Expr), b: (Sign, &Expr), pairs: &mut _| {
                (a.0 == b.0 || likeness == Likeness::ButForSlips) && is_alike(likeness, a.1, b.1, pairs)
            })
        })
}

/// Whether an equality has so many terms and letters that another one is like it by chance only rarely: three terms, of which one is no
/// letter alone, as in `E = T + V`; a rate and at least three letters, as an equation of motion has; or five letters.
pub(super) fn is_rich(line: &Sides) -> bool {
    let all = terms(line);
    let has_rate = [&line.0, &line.1].iter().any(|side| side.symbols().iter().any(|(_, dots)| *dots > 0));
    all.len() >= FEWEST_TERMS && all.iter().any(|(_, term)| term.as_plain_symbol().is_none())
        || has_rate && letters(line) >= FEWEST_BESIDE_A_RATE
        || letters(line) >= FEWEST_LETTERS
}

/// The fewest letters of an equality with a rate that is recognised with a slip.
const FEWEST_BESIDE_A_RATE: usize = 3;

/// The fewest terms of an equality that is recognised with its terms on other sides: fewer are like many others.
const FEWEST_TERMS: usize = 3;

/// The fewest letters of an equality of two terms that is recognised in this way: `(M + m) \ddot X + m \ddot s \cos\alpha = 0`.
const FEWEST_LETTERS: usize = 5;

/// The number of letters in an equality.
fn letters((left, right): &Sides) -> usize {
    let mut all: Vec<SymbolId> = [left.symbols(), right.symbols()].concat().into_iter().map(|(id, _)| id).collect();
    all.sort_unstable();
    all.dedup();
    all.len()
}

/// The terms of an equality with their signs, as if all stood on the left side.
fn terms<'e>((left, right): &'e (Expr, Expr)) -> Vec<(Sign, &'e Expr)> {
    let of = |side: &'e Expr| match &side.node {
        Node::Sum(terms) => terms.iter().map(|term| (term.sign, &term.expr)).collect(),
        _ => vec![(Sign::Plus, side)],
    };
    let moved = of(right).into_iter().map(|(sign, term): (Sign, &Expr)| (sign.flipped(), term));
    of(left).into_iter().chain(moved).filter(|(_, term)| !term.is_null()).collect()
}

/// Whether two formulas are the same but for their letters and the order of terms and factors. Letters correspond one to
/// one, as in `pairs`, to which new ones are added.
pub(super) fn is_alike(likeness: Likeness, left: &Expr, right: &Expr, pairs: &mut Pairs) -> bool {
    let may_slip = likeness == Likeness::ButForSlips;
    let [left, right] = if may_slip { [left, right].map(without_sign) } else { [left, right] };
    let start = pairs.len();
    let is_it = match (&left.node, &right.node) {
        (Node::Symbol { id: a, indices: none, dots }, Node::Symbol { id: b, indices: empty, dots: other }) => {
            let known = pairs.iter().find(|(own, meaning)| own == a || meaning == b).copied();
            if known.is_none() {
                pairs.push((*a, *b));
            }
            none.is_empty()
                && empty.is_empty()
                && (dots == other || may_slip && dots.abs_diff(*other) == 1)
                && known.is_none_or(|pair| pair == (*a, *b))
        }
        (Node::Power(base, power), _) if may_slip && is_number(power) => {
            is_alike(likeness, base, base_of(right), pairs)
        }
        (_, Node::Power(base, power)) if may_slip && is_number(power) => is_alike(likeness, left, base, pairs),
        (Node::Call(own, a), Node::Call(other, b))
            if may_slip && [own, other].iter().all(|f| is_of_a_triangle(**f)) =>
        {
            is_alike(likeness, a, b, pairs)
        }
        _ if is_product(left) && is_product(right) || may_slip && (is_product(left) || is_product(right)) => {
            let ([mut a, mut below], [mut b, mut under]) = (<[Vec<&Expr>; 2]>::default(), Default::default());
            factors(left, [&mut a, &mut below]);
            factors(right, [&mut b, &mut under]);
            for list in [&mut a, &mut below, &mut b, &mut under] {
                list.retain(|factor| !may_slip || !is_number(factor));
            }
            let same = |a: &[&Expr], b: &[&Expr], pairs: &mut Vec<_>| {
                in_some_order(a, b, pairs, &|a: &Expr, b: &Expr, pairs: &mut Vec<_>| is_alike(likeness, a, b, pairs))
            };
            same(&a, &b, pairs) && same(&below, &under, pairs)
        }
        (Node::Sum(a), Node::Sum(b)) => {
            let (a, b): (Vec<_>, Vec<_>) = (a.iter().collect(), b.iter().collect());
            in_some_order(&a, &b, pairs, &|a, b, pairs| {
                (a.sign == b.sign || may_slip) && is_alike(likeness, &a.expr, &b.expr, pairs)
            })
        }
        _ => {
            let (parts, others) = (left.children(), right.children());
            parts.len() == others.len()
                && head(left) == head(right)
                && parts.iter().zip(&others).all(|(a, b)| is_alike(likeness, a, b, pairs))
        }
    };
    if !is_it {
        pairs.truncate(start);
    }
    is_it
}

/// The factors of a formula: those above the fraction line, and those below.
fn factors<'e>(formula: &'e Expr, [above, below]: [&mut Vec<&'e Expr>; 2]) {
    match &formula.node {
        Node::Product(all) => all.iter().for_each(|factor| factors(factor, [above, below])),
        Node::Quotient(a, b) => {
            factors(a, [above, below]);
            factors(b, [below, above]);
        }
        _ => above.push(formula),
    }
}

/// Whether the members of two lists correspond in some order.
fn in_some_order<T: Copy>(a: &[T], b: &[T], pairs: &mut Pairs, is_same: &impl Fn(T, T, &mut Pairs) -> bool) -> bool {
    let Some((first, rest)) = a.split_first() else { return b.is_empty() };
    if a.len() != b.len() || a.len() > LONGEST {
        return false;
    }
    let start = pairs.len();
    (0..b.len()).any(|at| {
        let others: Vec<T> = b.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, item)| *item).collect();
        let found = is_same(*first, b[at], pairs) && in_some_order(rest, &others, pairs, is_same);
        if !found {
            pairs.truncate(start);
        }
        found
    })
}

/// The most terms or factors whose orders are tried.
const LONGEST: usize = 6;

/// A formula with nothing inside it.
pub(in crate::check::mark) fn head(formula: &Expr) -> Node {
    let mut head = formula.clone();
    head.children_mut().into_iter().for_each(|child| *child = Expr::integer(0, Span::default()));
    head.node
}

/// A formula without a sign before all of it.
fn without_sign(formula: &Expr) -> &Expr {
    match &formula.node {
        Node::Sum(terms) if terms.len() == 1 => &terms[0].expr,
        _ => formula,
    }
}

fn is_product(formula: &Expr) -> bool {
    matches!(formula.node, Node::Product(_) | Node::Quotient(..))
}

fn is_number(formula: &Expr) -> bool {
    matches!(formula.node, Node::Number(_))
}

/// What a power with a number is taken of; the formula itself, if it is no such power.
fn base_of(formula: &Expr) -> &Expr {
    match &formula.node {
        Node::Power(base, power) if is_number(power) => base,
        _ => formula,
    }
}

fn is_of_a_triangle(function: Function) -> bool {
    matches!(function, Function::Sin | Function::Cos | Function::Tan)
}
