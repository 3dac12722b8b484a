//! Sums and products over letters that are no declared indices: `\sum_{k=1}^{3} k^2`, `\sum_{k=0}^{n} k`,
//! `\sum_{k=0}^{\infty} x^k`, `\prod_{k=1}^{3} k`.
//!
//! Between two numbers they are written out. Up to a letter or to infinity, a sum is replaced by its formula, if its
//! summand is a polynomial or geometric.

use crate::formula::calculus::places::{End, at, depends_on, whole};
use crate::formula::calculus::{NoFormula, series};
use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::source::Fault;

use super::super::super::layout::{Item, Layout};
use super::super::super::names;
use super::super::items::{contents, extent, is_big_product, parts};
use super::super::state::{Read, Reader};

/// The most terms that are written out.
const MOST: i64 = 60;

impl Reader<'_> {
    /// A sum or a product of the rest of the term; `None` for one over a declared index.
    pub(in super::super) fn counted(&mut self, sign: &Item, rest: &[Item]) -> Read<Option<Expr>> {
        let Layout::Scripts { sub: Some(sub), sup: Some(sup), primes: 0, .. } = &sign.layout else { return Ok(None) };
        let below: Vec<&Item> = contents(sub).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        let [letter, Item { layout: Layout::Other('='), .. }, first, ..] = below.as_slice() else { return Ok(None) };
        let Some(printed) = names::printed(letter, None) else { return Ok(None) };
        if self.symbols.index(&printed.name.to_string()).is_some() {
            return Ok(None);
        }
        let Some(start) = contents(sub).iter().position(|item| std::ptr::eq(item, *first)) else { return Ok(None) };
        if rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            return Err(Fault::new(sign.span, "no formula follows this sum"));
        }
        let span = extent(rest).map_or(sign.span, |rest| sign.span.to(rest));
        let lower = self.sum(&contents(sub)[start..], sub.span)?;
        let upper = self.end(sup)?;
        let numbers = match &upper {
            End::At(upper) => whole(&lower).zip(whole(upper)),
            _ => None,
        };
        let is_product = is_big_product(sign);
        let Some((low, high)) = numbers else {
            if is_product {
                return Err(Fault::unsupported(sign.span, "a product has a value between two numbers only")
                    .help("write the product out, or leave the equation out with \"skip\""));
            }
            is_no_index(rest, &printed.name.base)?;
            let bound = self.bind(letter)?;
            let body = self.term(rest);
            self.release(&bound);
            let body = self.written_out(&body?, bound.id)?;
            self.without_any_function(&body)?;
            if !depends_on(&body, bound.id) && !body.symbols().is_empty() {
                return Err(Fault::index(letter.span, "the letter of this sum does not occur in what is summed")
                    .help("correct the letter under the Σ, or write the product with the number of terms"));
            }
            let found = series::sum(&body, bound.id, &lower, &upper, span);
            return found.map(|formula| Some(as_step(formula))).map_err(|reason| refused(reason, sign, &upper));
        };
        if high - low >= MOST {
            return Err(Fault::unsupported(sign.span, format!("a sum of more than {MOST} terms is not supported"))
                .help("write an equation for a letter as the upper limit"));
        }
        let mut parts = Vec::new();
        for value in low..=high {
            let number = number(value, span);
            let placed: Vec<Item> = rest.iter().map(|item| with_subscript(item, &printed.name.base, value)).collect();
            is_no_index(&placed, &printed.name.base)?;
            let bound = self.bind(letter)?;
            let body = self.term(&placed);
            self.release(&bound);
            let body = self.written_out(&body?, bound.id)?;
            parts.push(at(&body, bound.id, &number));
        }
        Ok(Some(match (is_product, parts.is_empty()) {
            (true, true) => as_step(Expr::integer(1, span)),
            (true, false) => as_step(Expr::new(Node::Product(parts), span)),
            (false, true) => as_step(Expr::integer(0, span)),
            (false, false) => {
                let term = |expr| Term { sign: Sign::Plus, sign_span: None, expr };
                Expr::new(Node::Sum(parts.into_iter().map(term).collect()), span)
            }
        }))
    }
}

/// Rejects a quantity with the letter of a sum below it, `c_j`: it has another value in each term.
fn is_no_index(items: &[Item], letter: &str) -> Read<()> {
    for item in items {
        if let Layout::Scripts { sub: Some(sub), .. } = &item.layout
            && let Some(place) = contents(sub).iter().find(|part| is_letter(part, letter))
        {
            return Err(Fault::index(
                place.span,
                format!("this quantity has another value for each {letter}, and no formula"),
            )
            .help(format!("give a formula for it in a display, or declare {letter} under \"indices\"")));
        }
        for part in parts(item) {
            is_no_index(part, letter)?;
        }
        if let Layout::Scripts { sup: Some(sup), .. } = &item.layout {
            is_no_index(contents(sup), letter)?;
        }
    }
    Ok(())
}

/// Whether an item is a letter, or has it in it: `j`, `{j}`.
fn is_letter(item: &Item, letter: &str) -> bool {
    names::printed(item, None).is_some_and(|found| found.name.base == letter && found.name.subscript.is_empty())
}

/// A formula as a sum of one term: it so differs from its own text, because to compute it is a step.
pub(super) fn as_step(expr: Expr) -> Expr {
    let span = expr.span;
    Expr::new(Node::Sum(vec![Term { sign: Sign::Plus, sign_span: None, expr }]), span)
}

fn number(value: i64, span: crate::source::Span) -> Expr {
    let size = Expr::new(Node::Number(value.unsigned_abs().to_string()), span);
    if value < 0 { size.negated() } else { size }
}

/// An item with the letter of a sum replaced by a number where it is a subscript by itself: x₂ for x_k.
fn with_subscript(item: &Item, letter: &str, value: i64) -> Item {
    let inner = |items: &[Item]| items.iter().map(|item| with_subscript(item, letter, value)).collect::<Vec<_>>();
    let boxed = |item: &Item| Box::new(with_subscript(item, letter, value));
    let layout = match &item.layout {
        Layout::Scripts { nucleus, sub: Some(sub), sup, primes } => {
            let is_letter = matches!(contents(sub), [only] if names::printed(only, None)
                .is_some_and(|found| found.name.base == letter && found.name.subscript.is_empty()));
            let sub = match is_letter && value >= 0 {
                true => Box::new(Item { layout: Layout::Number(value.to_string()), span: sub.span }),
                false => sub.clone(),
            };
            Layout::Scripts { nucleus: boxed(nucleus), sub: Some(sub), sup: sup.as_deref().map(boxed), primes: *primes }
        }
        Layout::Scripts { nucleus, sub, sup, primes } => Layout::Scripts {
            nucleus: boxed(nucleus),
            sub: sub.clone(),
            sup: sup.as_deref().map(boxed),
            primes: *primes,
        },
        Layout::Group(items) => Layout::Group(inner(items)),
        Layout::Fence(delimiter, items) => Layout::Fence(*delimiter, inner(items)),
        Layout::Fraction(a, b) => Layout::Fraction(boxed(a), boxed(b)),
        Layout::Root(degree, radicand) => Layout::Root(degree.clone(), boxed(radicand)),
        Layout::Accent(command, under) => Layout::Accent(command.clone(), boxed(under)),
        Layout::Style(command, under) => Layout::Style(command.clone(), boxed(under)),
        other => other.clone(),
    };
    Item { layout, span: item.span }
}

fn refused(reason: NoFormula, sign: &Item, upper: &End) -> Fault {
    let what = match (reason, upper) {
        (NoFormula::Diverges, _) => "this series has no finite value, or none that can be shown",
        (_, End::At(_)) => "a sum up to a letter has a value for polynomials and geometric sums only",
        _ => "an infinite series has a value for geometric series only",
    };
    Fault::unsupported(sign.span, what).help("leave the equation out with \"skip\" in the claims file")
}
