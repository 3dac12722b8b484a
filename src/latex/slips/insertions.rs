//! What undoes a loss: factors and terms that stand elsewhere in the document, put in.

use std::collections::HashMap;

use crate::formula::{SymbolId, Symbols};
use crate::source::Span;

use super::super::layout::{Item, Layout, typeset_items};
use super::super::macros::Macros;
use super::super::names;
use super::lists::{Factor, Term, formulas, is_big, is_function, is_integral, is_sum, is_times};
use super::{Finder, Slip, slips};

/// Factors and terms that may be put in, as their authors typed them.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    factors: Vec<String>,
    terms: Vec<String>,
    /// `\sin`, `\cos^2`: what may stand before a name.
    functions: Vec<String>,
    /// `\sum_{i=1}^{n}`, `\int_V`: what may stand before factors.
    pub(super) sums: Vec<String>,
    /// The symbols that stand there.
    pub(super) names: Vec<SymbolId>,
}

/// The factors, terms and functions of texts, and how often each stands there.
#[derive(Default)]
struct Counts {
    factors: HashMap<String, usize>,
    terms: HashMap<String, usize>,
    functions: HashMap<String, usize>,
    sums: HashMap<String, usize>,
    names: Vec<SymbolId>,
}

impl Pool {
    /// Nothing: what was lost is not looked for.
    pub fn empty() -> Pool {
        Pool::default()
    }

    /// The factors of some texts, the commonest first, and the terms of them; at most so many of each.
    pub fn of<'t>(texts: impl Iterator<Item = &'t str>, symbols: &Symbols, macros: &Macros, most: usize) -> Pool {
        let mut counts = Counts::default();
        for text in texts {
            let Ok(items) = typeset_items(text, macros) else { continue };
            let finder = Finder { text, symbols, pool: None, edits: Vec::new() };
            finder.gather(&items, &mut counts);
        }
        for number in ["2", "\\frac{1}{2}", "4", "3"] {
            counts.factors.entry(number.to_owned()).or_insert(1);
        }
        for function in ["\\sin", "\\cos"] {
            counts.functions.entry(function.to_owned()).or_insert(1);
        }
        let sorted = |counts: HashMap<String, usize>| {
            let mut all: Vec<(String, usize)> = counts.into_iter().collect();
            all.sort_by(|(a, n), (b, m)| m.cmp(n).then(a.len().cmp(&b.len())).then(a.cmp(b)));
            all.into_iter().map(|(text, _)| text).take(most).collect()
        };
        let (factors, terms) = (sorted(counts.factors), sorted(counts.terms));
        Pool { factors, terms, functions: sorted(counts.functions), sums: sorted(counts.sums), names: counts.names }
    }

    /// The factors, the commonest first.
    pub fn factors(&self) -> &[String] {
        &self.factors
    }

    /// The terms alone, each with every single slip in it: what was lost is like what stands there.
    pub fn of_like_terms(&self, symbols: &Symbols, macros: &Macros) -> Pool {
        let like = |term: &String| {
            let slips = slips(term, symbols, macros).into_iter().filter(|edit| edit.slip != Slip::Doubled);
            slips.map(|edit| edit.applied(term)).collect::<Vec<_>>()
        };
        let mut terms: Vec<String> = self.terms.iter().flat_map(like).take(LIKE).collect();
        terms.retain(|term| !self.terms.contains(term));
        Pool { terms, ..Pool::default() }
    }

    /// With the members of families that have the index letters of a text.
    pub fn with_members(mut self, text: &str, symbols: &Symbols, macros: &Macros) -> Pool {
        if let Ok(items) = typeset_items(text, macros) {
            let members = Finder { text, symbols, pool: None, edits: Vec::new() }.members(&items);
            self.factors
                .extend(members.into_iter().filter(|member| !self.factors.contains(member)).collect::<Vec<_>>());
        }
        self
    }

    /// The factors alone.
    pub fn factors_only(mut self) -> Pool {
        self.terms.clear();
        self
    }
}

/// So many terms that are like those that stand there are tried.
const LIKE: usize = 400;

/// Longer factors are not put in.
const LONGEST: usize = 120;

impl Finder<'_> {
    fn gather(&self, items: &[Item], counts: &mut Counts) {
        let count = |counts: &mut HashMap<String, usize>, span: Span| {
            if span.end - span.start <= LONGEST {
                *counts.entry(self.slice(span).to_owned()).or_default() += 1;
            }
        };
        for formula in formulas(items) {
            for term in &formula {
                if formula.len() > 1 {
                    count(&mut counts.terms, term.span());
                }
                let all = self.factors(term.items);
                // A name with the parenthesis after it: what depends on a place, `\rho(\vec r)`, is one thing.
                for pair in all.windows(2) {
                    let [name, place] = pair else { continue };
                    let adjacent = name.span().end == place.span().start;
                    if adjacent && names::printed(&name.items[0], None).is_some() && name.items.len() == 1 {
                        count(&mut counts.factors, name.span().to(place.span()));
                    }
                }
                for factor in &all {
                    let first = &factor.items[0];
                    let is_name = factor.items.len() == 1 && names::printed(first, None).is_some();
                    if !is_big(first) && (all.len() > 1 || is_name) {
                        count(&mut counts.factors, factor.span());
                        for other in other_axes(self.slice(factor.span())) {
                            counts.factors.entry(other).or_default();
                        }
                    }
                    if is_function(first) {
                        count(&mut counts.functions, first.span);
                    }
                    if is_sum(first) || is_integral(first) {
                        count(&mut counts.sums, first.span);
                    }
                }
            }
        }
        for item in items {
            let name = names::printed(item, None).and_then(|printed| self.symbols.find(&printed.name));
            counts.names.extend(name.map(|(id, _)| id).filter(|id| !counts.names.contains(id)));
            for inner in insides(item) {
                self.gather(inner, counts);
            }
        }
    }

    /// Each factor of the pool put into a term: before it, after it if it is no number, and after what acts on all that follows; a
    /// vector before and after a vector, too.
    pub(super) fn insert_factors(&mut self, factors: &[Factor<'_>]) {
        let Some(pool) = self.pool else { return };
        let (Some(first), Some(last)) = (factors.first(), factors.last()) else { return };
        let after_big = factors.iter().zip(&factors[1..]).filter(|(big, _)| is_big(&big.items[0]));
        let mut before: Vec<usize> = vec![first.span().start];
        before.extend(after_big.map(|(_, next)| next.span().start));
        let end = last.span().end;
        for function in &pool.functions {
            for factor in factors.iter().filter(|factor| !is_function(&factor.items[0])) {
                self.edit(Slip::Function, Span::at(factor.span().start), format!("{function} "));
            }
        }
        for factor in &pool.factors {
            let slip = if is_number(factor) { Slip::Number } else { Slip::Factor };
            // Of two vectors it is said below which product is meant.
            let text = self.text;
            let are_vectors = |text: &str| is_arrow(text) && is_arrow(factor);
            for at in before.iter().filter(|at| !are_vectors(&text[**at..])) {
                self.edit(slip, Span::at(*at), format!("{factor} \\, "));
                // `\rho(\vec r)`, what depends on a place, is one thing.
                if self.text[*at..].starts_with('(') {
                    self.edit(slip, Span::at(*at), factor);
                }
            }
            // A number stands before what it multiplies.
            if !is_number(factor) && !are_vectors(self.slice(last.span())) {
                self.edit(Slip::Factor, Span::at(end), format!(" \\, {factor}"));
            }
            if !is_vector(factor) {
                for at in self.between_vectors(factors) {
                    self.edit(Slip::Factor, Span::at(at), format!("\\times {factor} "));
                }
                continue;
            }
            let printed = factors.iter().map(Factor::span);
            let vectors: Vec<Span> = printed.filter(|span| is_vector(self.slice(*span))).collect();
            for at in vectors {
                for operator in ["\\times", "\\cdot"] {
                    self.edit(Slip::Factor, Span::at(at.start), format!("{factor} {operator} "));
                    self.edit(Slip::Factor, Span::at(at.end), format!(" {operator} {factor}"));
                }
            }
        }
    }

    /// Where a vector stands after another with nothing between them.
    fn between_vectors(&self, factors: &[Factor<'_>]) -> Vec<usize> {
        let is = |factor: &Factor<'_>| is_vector(self.slice(factor.span()));
        let pairs = factors.iter().zip(factors.iter().skip(1));
        let bare = pairs.filter(|(a, b)| b.operator.is_none() && is(a) && is(b));
        bare.map(|(_, second)| second.span().start).collect()
    }

    /// The product of two vectors, where it is not said which.
    pub(super) fn multiply(&mut self, factors: &[Factor<'_>]) {
        for at in self.between_vectors(factors) {
            for operator in ["\\times ", "\\cdot "] {
                self.edit(Slip::Order, Span::at(at), operator);
            }
        }
    }

    /// Parentheses around a product of two vectors that is a factor of another.
    pub(super) fn associate(&mut self, factors: &[Factor<'_>]) {
        if factors.iter().filter(|factor| factor.operator.is_some_and(is_times)).count() < 2 {
            return;
        }
        for (a, b) in factors.iter().zip(&factors[1..]).filter(|(_, b)| b.operator.is_some_and(is_times)) {
            let product = a.span().to(b.span());
            self.edit(Slip::Parenthesis, product, format!("({})", self.slice(product)));
        }
    }

    /// What an integral is taken over: the d or its power lost, or what stands after it.
    pub(super) fn elements(&mut self, factors: &[Factor<'_>]) {
        let Some(pool) = self.pool.filter(|_| factors.iter().any(|factor| is_integral(&factor.items[0]))) else {
            return;
        };
        let is_d = |factor: &&Factor<'_>| self.slice(factor.span()).trim_end_matches("{}").starts_with('d');
        let Some(last) = factors.last().map(Factor::span) else { return };
        match factors.iter().find(is_d).map(|factor| (factor.span(), factor.items)) {
            Some((d, [Item { layout: Layout::Letter(_), .. }])) => {
                ["d^2", "d^3"].iter().for_each(|element| self.edit(Slip::Exponent, d, *element));
            }
            Some((d, _)) if d == last => {
                let letters = pool.factors.iter().filter(|factor| factor.len() == 1);
                letters.for_each(|letter| self.edit(Slip::Factor, Span::at(d.end), letter.as_str()));
            }
            Some(_) => {}
            None => ["d", "d^2", "d^3"].iter().for_each(|d| self.edit(Slip::Factor, Span::at(last.start), *d)),
        }
    }

    /// A sign between two factors of a term, which was two.
    pub(super) fn split(&mut self, factors: &[Factor<'_>]) {
        // What acts on all that follows is no term by itself.
        let acts = |factor: &Factor<'_>| is_big(&factor.items[0]) || self.slice(factor.span()).contains("{dt");
        let apart = factors.iter().take_while(|factor| !acts(factor)).count();
        for factor in factors[..apart].iter().skip(1).filter(|factor| factor.operator.is_none()) {
            for sign in ["-", "+"] {
                self.edit(Slip::Term, Span::at(factor.span().start), format!("{sign} "));
            }
        }
    }

    /// Each Σ of the pool put before a factor.
    pub(super) fn insert_sums(&mut self, factors: &[Factor<'_>]) {
        let Some(pool) = self.pool else { return };
        for sum in &pool.sums {
            for factor in factors {
                self.edit(Slip::Factor, Span::at(factor.span().start), format!("{sum} "));
            }
        }
    }

    /// Each term of the pool added to a formula, and taken from it.
    pub(super) fn insert_terms(&mut self, terms: &[Term<'_>]) {
        let (Some(pool), Some(last)) = (self.pool, terms.last()) else { return };
        for term in &pool.terms {
            for sign in ["+", "-", "\\pm"] {
                self.edit(Slip::Term, Span::at(last.span().end), format!(" {sign} {term}"));
            }
        }
    }
}

/// Whether a factor is a number or a fraction of numbers.
pub(super) fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix("\\frac").unwrap_or(text);
    digits.chars().all(|c| c.is_ascii_digit() || matches!(c, '{' | '}' | ' '))
}

/// A factor with one digit of three in its subscript, for the other two: λ₂ and λ₃ for λ₁.
fn other_axes(text: &str) -> Vec<String> {
    let is_axis = |c: &char| matches!(c, '1' | '2' | '3');
    let mut digits = text.char_indices().filter(|(_, c)| c.is_ascii_digit());
    let (Some((at, axis)), None) = (digits.next(), digits.next()) else { return Vec::new() };
    if !is_axis(&axis) || !text[..at].trim_end_matches('{').ends_with('_') {
        return Vec::new();
    }
    let others = ['1', '2', '3'].into_iter().filter(|other| *other != axis);
    others.map(|other| format!("{}{other}{}", &text[..at], &text[at + 1..])).collect()
}

/// Whether a text starts with the name of a vector.
fn is_arrow(text: &str) -> bool {
    ["\\vec", "\\hat", "\\dot{\\vec"].iter().any(|start| text.starts_with(start))
}

/// Whether a factor looks like a vector, or like a product of them in parentheses.
fn is_vector(text: &str) -> bool {
    is_arrow(text) || ["\\mathbf", "("].iter().any(|start| text.starts_with(start)) || text.contains("\\vec")
}

/// The lists that an item holds.
pub(super) fn insides(item: &Item) -> Vec<&[Item]> {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => vec![items],
        Layout::Fraction(a, b) => [a, b].into_iter().flat_map(|inner| insides(inner)).collect(),
        Layout::Root(_, inner) | Layout::Scripts { nucleus: inner, .. } => insides(inner),
        Layout::Environment(_, rows) => rows.iter().flatten().map(Vec::as_slice).collect(),
        _ => Vec::new(),
    }
}
