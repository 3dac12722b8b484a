//! Sums, products, limits and ellipses without declared indices: `\sum_{n=0}^{\infty}`, `\prod_i`, `\lim_{x \to 0}`.

use crate::formula::symbols::Operator;
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::{extent, is_big_product, is_big_sum, is_limit};
use super::super::state::{Read, Reader};
use super::super::structure::printed;
use super::simple_text;

impl Reader<'_> {
    /// A sum, a product or a limit of the rest of the term.
    pub(in super::super) fn unevaluated(&mut self, sign: &Item, rest: &[Item]) -> Read<Expr> {
        let (command, below, above) = match &sign.layout {
            Layout::Scripts { nucleus, sub, sup, primes: 0 } => match &nucleus.layout {
                Layout::Command(name) => (name.clone(), sub.as_deref(), sup.as_deref()),
                _ => return Err(refused(sign.span)),
            },
            Layout::Command(name) => (name.clone(), None, None),
            _ => return Err(refused(sign.span)),
        };
        if rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            if self.is_abstract() {
                return Ok(self.label(std::slice::from_ref(sign), sign.span));
            }
            return Err(Fault::new(sign.span, format!("no formula follows this {command}"))
                .help("write what is summed or multiplied after it"));
        }
        let mut name = command;
        let mut bound = Vec::new();
        for (mark, part) in [("_", below), ("^", above)] {
            let Some(part) = part else { continue };
            let text = match simple_text(contents(part)) {
                Some(text) => text,
                None if self.is_abstract() => printed(contents(part)),
                None => return Err(refused(part.span)),
            };
            name.push_str(&format!("{mark}{{{text}}}"));
            if mark == "_" {
                let letters = contents(part).iter().filter_map(|item| names::printed(item, None));
                bound.extend(letters.map(|found| found.name.to_string()));
            }
        }
        let outer = self.bound.len();
        self.bound.extend(bound);
        let first = rest.iter().find(|item| !matches!(item.layout, Layout::Space(_)));
        let body = match first.is_some_and(|first| first.layout == Layout::Other('-')) {
            true => self.sum(rest, sign.span),
            false => self.term(rest),
        };
        self.bound.truncate(outer);
        let span = extent(rest).map_or(sign.span, |rest| sign.span.to(rest));
        Ok(self.operate(&name, Operator::Same, vec![body?], span))
    }

    /// Rejects `\sum_i x_i + y_i`, where a letter of Σ stands as an index in a term after it, and in none before.
    pub(in super::super) fn is_no_lost_index(&self, items: &[Item]) -> Read<()> {
        let is_sign = |at: usize| matches!(items[at].layout, Layout::Other('+' | '-')) && !follows_a_sum(items, at);
        let mut terms: Vec<&[Item]> = Vec::new();
        let mut start = 0;
        for at in (0..items.len()).filter(|at| is_sign(*at)) {
            terms.push(&items[start..at]);
            start = at + 1;
        }
        terms.push(&items[start..]);
        let mut bound: Vec<String> = Vec::new();
        for (at, term) in terms.iter().enumerate() {
            let own: Vec<String> = term.iter().flat_map(letters_of_a_sum).collect();
            let is_lost = |letter: &String| {
                !own.contains(letter)
                    && !self.bound.contains(letter)
                    && term.iter().any(|item| has_index(item, letter))
                    && !terms[..at].iter().any(|before| is_free_in(before, letter))
            };
            if let (Some(letter), Some(first), Some(last)) =
                (bound.iter().find(|letter| is_lost(letter)), term.first(), term.last())
            {
                let what = format!("the sum over {letter} may or may not include this term");
                return Err(Fault::ambiguous(first.span.to(last.span), what)
                    .help("put what is summed in parentheses, or use another letter after the sum"));
            }
            bound.extend(own);
        }
        Ok(())
    }

    /// `\dots` as a term or a factor of its own.
    pub(in super::super) fn ellipsis(&mut self, span: Span) -> Expr {
        self.operate("\\dots", Operator::Function, Vec::new(), span)
    }
}

/// Whether a minus stands directly behind Σ, ∏ or lim.
pub(in super::super) fn follows_a_sum(items: &[Item], at: usize) -> bool {
    let before = || items[..at].iter().rev().find(|item| !matches!(item.layout, Layout::Space(_)));
    let reaches = |item: &Item| is_big_sum(item) || is_big_product(item) || is_limit(item);
    items[at].layout == Layout::Other('-') && before().is_some_and(reaches)
}

fn refused(span: Span) -> Fault {
    Fault::unsupported(span, "these limits of a sum or product are not supported")
        .help("write \\sum_{i=1}^{n}, with names and numbers only")
}

/// The letters that a Σ or a ∏ binds.
fn letters_of_a_sum(item: &Item) -> Vec<String> {
    let Layout::Scripts { sub: Some(sub), .. } = &item.layout else { return Vec::new() };
    if !is_big_sum(item) && !is_big_product(item) {
        return Vec::new();
    }
    let end = contents(sub).iter().position(|item| relation(item).is_some()).unwrap_or(contents(sub).len());
    let letters = contents(sub)[..end].iter().filter_map(|item| names::printed(item, None));
    letters.map(|found| found.name.to_string()).collect()
}

/// Whether a letter stands as an index below a name.
fn has_index(item: &Item, letter: &str) -> bool {
    let here = names::printed(item, None).is_some_and(|found| found.name.subscript.iter().any(|token| token == letter));
    here || parts(item).into_iter().flatten().any(|item| has_index(item, letter))
}

/// Whether a letter is an index in a term outside of a sum over it.
fn is_free_in(term: &[Item], letter: &str) -> bool {
    let sum = term.iter().position(|item| letters_of_a_sum(item).iter().any(|bound| bound == letter));
    term[..sum.unwrap_or(term.len())].iter().any(|item| has_index(item, letter))
}
