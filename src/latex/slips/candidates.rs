//! The candidates for insertion that a document offers: the factors, terms and functions in its texts.

use std::collections::HashMap;

use crate::formula::{SymbolId, Symbols};
use crate::source::Span;

use super::super::layout::{Item, typeset_items};
use super::super::macros::Macros;
use super::super::names;
use super::finder::Finder;
use super::parts::{formulas, insides, is_big, is_function, is_integral, is_sum};
use super::pool::Pool;

/// The most bytes of a factor that is inserted.
const LONGEST: usize = 120;

/// The factors, terms and functions of texts, with the number of their occurrences.
#[derive(Default)]
struct Counts {
    factors: HashMap<String, usize>,
    terms: HashMap<String, usize>,
    functions: HashMap<String, usize>,
    sums: HashMap<String, usize>,
    names: Vec<SymbolId>,
}

impl Pool {
    /// The factors, terms, functions and operators of these texts, the most frequent first; at most `most` of each.
    pub fn of<'t>(texts: impl Iterator<Item = &'t str>, symbols: &Symbols, macros: &Macros, most: usize) -> Pool {
        let mut counts = Counts::default();
        for text in texts {
            let Ok(items) = typeset_items(text, macros) else { continue };
            let finder = Finder::new(text, symbols, None);
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

    /// The pool with the members of families that have the index letters of a text.
    pub fn with_members(mut self, text: &str, symbols: &Symbols, macros: &Macros) -> Pool {
        if let Ok(items) = typeset_items(text, macros) {
            let members = Finder::new(text, symbols, None).members(&items);
            self.factors
                .extend(members.into_iter().filter(|member| !self.factors.contains(member)).collect::<Vec<_>>());
        }
        self
    }
}

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
