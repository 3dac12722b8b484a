//! Insertions: factors and terms of the pool, inserted where one may be missing.

use crate::source::Span;

use super::super::layout::{Item, Layout};
use super::edit::Slip;
use super::finder::Finder;
use super::parts::{Factor, Term, is_big, is_function, is_integral, is_number, is_times};

impl Finder<'_> {
    /// Inserts each factor of the pool into a term: before it, after it if it is no number, and after Σ, ∫ or lim. A
    /// vector is also inserted before and after each vector, with × and ·.
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
            // The product of two vectors is chosen below.
            let text = self.text;
            let are_vectors = |text: &str| is_arrow(text) && is_arrow(factor);
            for at in before.iter().filter(|at| !are_vectors(&text[**at..])) {
                self.edit(slip, Span::at(*at), format!("{factor} \\, "));
                // A function of the position, `\rho(\vec r)`, stays together.
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

    /// The places where two vectors follow each other without an operator.
    fn between_vectors(&self, factors: &[Factor<'_>]) -> Vec<usize> {
        let is = |factor: &Factor<'_>| is_vector(self.slice(factor.span()));
        let pairs = factors.iter().zip(factors.iter().skip(1));
        let bare = pairs.filter(|(a, b)| b.operator.is_none() && is(a) && is(b));
        bare.map(|(_, second)| second.span().start).collect()
    }

    /// Inserts × or · between two vectors without an operator.
    pub(super) fn multiply(&mut self, factors: &[Factor<'_>]) {
        for at in self.between_vectors(factors) {
            for operator in ["\\times ", "\\cdot "] {
                self.edit(Slip::Order, Span::at(at), operator);
            }
        }
    }

    /// Puts a product of two vectors in parentheses where another product follows.
    pub(super) fn associate(&mut self, factors: &[Factor<'_>]) {
        if factors.iter().filter(|factor| factor.operator.is_some_and(is_times)).count() < 2 {
            return;
        }
        for (a, b) in factors.iter().zip(&factors[1..]).filter(|(_, b)| b.operator.is_some_and(is_times)) {
            let product = a.span().to(b.span());
            self.edit(Slip::Parenthesis, product, format!("({})", self.slice(product)));
        }
    }

    /// Completes a differential: its d, its power, or its variable.
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

    /// Inserts a sign between two factors, which makes two terms.
    pub(super) fn split(&mut self, factors: &[Factor<'_>]) {
        // An operator on all following factors is no term.
        let acts = |factor: &Factor<'_>| is_big(&factor.items[0]) || self.slice(factor.span()).contains("{dt");
        let apart = factors.iter().take_while(|factor| !acts(factor)).count();
        for factor in factors[..apart].iter().skip(1).filter(|factor| factor.operator.is_none()) {
            for sign in ["-", "+"] {
                self.edit(Slip::Term, Span::at(factor.span().start), format!("{sign} "));
            }
        }
    }

    /// Inserts each Σ of the pool before each factor.
    pub(super) fn insert_sums(&mut self, factors: &[Factor<'_>]) {
        let Some(pool) = self.pool else { return };
        for sum in &pool.sums {
            for factor in factors {
                self.edit(Slip::Factor, Span::at(factor.span().start), format!("{sum} "));
            }
        }
    }

    /// Adds each term of the pool to a formula, and subtracts it.
    pub(super) fn insert_terms(&mut self, terms: &[Term<'_>]) {
        let (Some(pool), Some(last)) = (self.pool, terms.last()) else { return };
        for term in &pool.terms {
            for sign in ["+", "-", "\\pm"] {
                self.edit(Slip::Term, Span::at(last.span().end), format!(" {sign} {term}"));
            }
        }
    }
}

/// Whether a text starts with the name of a vector.
fn is_arrow(text: &str) -> bool {
    ["\\vec", "\\hat", "\\dot{\\vec"].iter().any(|start| text.starts_with(start))
}

/// Whether a factor looks like a vector, or like a product of them in parentheses.
fn is_vector(text: &str) -> bool {
    is_arrow(text) || ["\\mathbf", "("].iter().any(|start| text.starts_with(start)) || text.contains("\\vec")
}
