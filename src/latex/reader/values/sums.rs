//! Sums and products over letters that are no declared indices: `\sum_{k=1}^{3} k^2`, `\sum_{k=0}^{n} k`,
//! `\sum_{k=0}^{\infty} x^k`, `\prod_{k=1}^{3} k`.
//!
//! Between two numbers they are written out. Up to a letter or to infinity, a sum is replaced by its formula, if its
//! summand is a polynomial or geometric.

use crate::formula::SymbolId;
use crate::formula::calculus::places::{End, at, depends_on, whole};
use crate::formula::calculus::{NoFormula, series};
use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names;
use super::super::items::{extent, is_big_product, whole_number};
use super::super::state::{Read, Reader};

/// The most terms that are written out.
const MOST: i64 = 60;

impl Reader<'_> {
    /// A sum or a product of the rest of the term; `None` for one over a declared index.
    pub(in super::super) fn counted(&mut self, sign: &Item, rest: &[Item]) -> Read<Option<Expr>> {
        let Layout::Scripts { sub: Some(sub), sup: Some(sup), primes: 0, .. } = &sign.layout else {
            return self.over_all_members(sign, rest);
        };
        let below: Vec<&Item> = contents(sub).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        let [letter, Item { layout: Layout::Other('='), .. }, first, ..] = below.as_slice() else { return Ok(None) };
        let Some(printed) = names::printed(letter, None) else { return Ok(None) };
        if self.symbols.index(&printed.name.to_string()).is_some() {
            return Ok(None);
        }
        let Some(start) = contents(sub).iter().position(|item| std::ptr::eq(item, *first)) else { return Ok(None) };
        if rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            return Err(Fault::new(sign.span, "no formula follows this sum").help("write what is summed after the Σ"));
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
                return Err(Fault::unsupported(sign.span, "∏ is supported only between two numbers")
                    .help("write the product out, or leave the equation out with \"skip\""));
            }
            is_no_index(rest, &printed.name.base)?;
            let bound = self.bind(letter)?;
            let body = self.term(rest);
            self.release(&bound);
            let body = self.written_out(&body?, bound.id)?;
            self.without_any_function(&body)?;
            if !depends_on(&body, bound.id) && !body.symbols().is_empty() {
                return Err(Fault::index(
                    letter.span,
                    "the letter under this Σ does not occur in the terms of the sum",
                )
                .help("correct the letter under the Σ, or write the product with the number of terms"));
            }
            let found = series::sum(&body, bound.id, &lower, &upper, span);
            return found.map(|formula| Some(as_step(formula))).map_err(|reason| refused(reason, sign, &upper));
        };
        if high - low >= MOST {
            return Err(Fault::unsupported(sign.span, format!("a sum of more than {MOST} terms is not supported"))
                .help("write an equation for a letter as the upper limit"));
        }
        self.between(letter, (low, high), rest, (is_product, span)).map(Some)
    }

    /// `\sum_i \dot x_i^2`: a sum over all names that a subscript may give, if the letter is nothing else.
    fn over_all_members(&mut self, sign: &Item, rest: &[Item]) -> Read<Option<Expr>> {
        let Layout::Scripts { sub: Some(sub), sup: None, primes: 0, .. } = &sign.layout else { return Ok(None) };
        let [letter] = contents(sub) else { return Ok(None) };
        let Some(name) = names::printed(letter, None).map(|printed| printed.name.to_string()) else { return Ok(None) };
        let is_known = self.symbols.open || self.symbols.index(&name).is_some();
        let is_name = names::parse(&name).is_some_and(|(name, _)| self.symbols.find(&name).is_some());
        if is_known || is_name {
            return Ok(None);
        }
        let mut counts = Vec::new();
        rest.iter().for_each(|item| self.count_members(item, &name, &mut counts));
        let span = extent(rest).map_or(sign.span, |rest| sign.span.to(rest));
        match counts.as_slice() {
            [first, others @ ..] if *first > 1 && others.iter().all(|other| other == first) => {
                self.between(letter, (1, *first), rest, (is_big_product(sign), span)).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Adds how many names there are of each that has the letter as its subscript: 3 for x_i beside x_1, x_2, x_3.
    fn count_members(&self, item: &Item, letter: &str, counts: &mut Vec<i64>) {
        if let Some(printed) = names::printed(item, None)
            && printed.name.subscript == [letter]
        {
            let is_member = |value: &i64| {
                let mut member = printed.name.clone();
                member.subscript = vec![value.to_string()];
                self.symbols.find(&member).is_some_and(|(_, indices)| indices.is_empty())
            };
            counts.push((1..=9).take_while(is_member).count().try_into().unwrap_or(0));
            return;
        }
        for inner in parts(item) {
            inner.iter().for_each(|item| self.count_members(item, letter, counts));
        }
    }

    /// A sum or a product between two numbers, written out.
    fn between(
        &mut self,
        letter: &Item,
        (low, high): (i64, i64),
        rest: &[Item],
        (is_product, span): (bool, Span),
    ) -> Read<Expr> {
        let base = names::printed(letter, None).map(|printed| printed.name.base).unwrap_or_default();
        let mut parts = Vec::new();
        for value in low..=high {
            let number = number(value, span);
            let placed: Vec<Item> = rest.iter().map(|item| with_subscript(item, &base, value)).collect();
            is_no_index(&placed, &base)?;
            let bound = self.bind(letter)?;
            let body = self.term(&placed);
            self.release(&bound);
            let body = body?;
            // On a letter of the sum's own, which stands in subscripts only, nothing depends, and no rate does.
            let mentions_it = |(id, _): &(SymbolId, u8)| {
                let entry = self.symbols.entry(*id);
                entry.unread && entry.name.mentions(&base)
            };
            let is_apart =
                bound.released.is_some() && !depends_on(&body, bound.id) && !body.symbols().iter().any(mentions_it);
            let body = if is_apart { body } else { self.written_out(&body, bound.id)? };
            parts.push(at(&body, bound.id, &number));
        }
        Ok(match (is_product, parts.is_empty()) {
            (true, true) => as_step(Expr::integer(1, span)),
            (true, false) => as_step(Expr::new(Node::Product(parts), span)),
            (false, true) => as_step(Expr::integer(0, span)),
            (false, false) => {
                let term = |expr| Term { sign: Sign::Plus, sign_span: None, expr };
                Expr::new(Node::Sum(parts.into_iter().map(term).collect()), span)
            }
        })
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
                format!("this quantity depends on the index {letter}, and no formula says how"),
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

fn number(value: i64, span: Span) -> Expr {
    let size = Expr::new(Node::Number(value.unsigned_abs().to_string()), span);
    if value < 0 { size.negated() } else { size }
}

/// An item with the letter of a sum replaced by a number where it is a subscript by itself: x₂ for x_k.
fn with_subscript(item: &Item, letter: &str, value: i64) -> Item {
    let inner = |items: &[Item]| items.iter().map(|item| with_subscript(item, letter, value)).collect::<Vec<_>>();
    let boxed = |item: &Item| Box::new(with_subscript(item, letter, value));
    let layout = match &item.layout {
        Layout::Scripts { nucleus, sub: Some(sub), sup, primes } => {
            let sub = match subscript_at(contents(sub), letter, value) {
                Some(value) => Box::new(Item { layout: Layout::Number(value.to_string()), span: sub.span }),
                None => sub.clone(),
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

/// The number that the letter of a sum, or a sum or difference of it and a number, is: 3 for i + 1 where i is 2.
fn subscript_at(subscript: &[Item], letter: &str, value: i64) -> Option<i64> {
    let is_letter = |item: &Item| {
        names::printed(item, None).is_some_and(|found| found.name.base == letter && found.name.subscript.is_empty())
    };
    let found = match subscript {
        [only] if is_letter(only) => value,
        [first, sign, second] if is_letter(first) => {
            let second = i64::from(whole_number(second)?);
            match sign.layout {
                Layout::Other('+') => value + second,
                Layout::Other('-') => value - second,
                _ => return None,
            }
        }
        _ => return None,
    };
    (found >= 0).then_some(found)
}

fn refused(reason: NoFormula, sign: &Item, upper: &End) -> Fault {
    let what = match (reason, upper) {
        (NoFormula::Diverges, _) => "this series diverges, or cannot be shown to have a finite value",
        (_, End::At(_)) => "a sum up to a letter is supported only for polynomials and geometric sums",
        _ => "an infinite series is supported only if it is geometric",
    };
    Fault::unsupported(sign.span, what).help("leave the equation out with \"skip\" in the claims file")
}
