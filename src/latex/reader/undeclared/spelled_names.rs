//! Names of several letters that look like a product: `CDF(x)`, `Var(X)`, `SU(3)`, and the sides of a triangle, `AB^2 + AC^2`.
//!
//! Before a parenthesis the last letter would be a function, and the others its factors. Nobody means that of a known name, or of
//! capitals that stand nowhere else in the display.

use std::collections::{BTreeMap, BTreeSet};

use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents, parts};
use super::super::super::names;
use super::super::words::run_of_letters;

/// Names that nobody takes for a product before a parenthesis.
const NAMES: [&str; 15] =
    ["Var", "Cov", "Std", "var", "cov", "std", "pdf", "cdf", "pmf", "cis", "SU", "SO", "SL", "GL", "SE"];

/// The fault of such a name in a display.
pub(in super::super::super) fn unclear_name(items: &[Item]) -> Option<Fault> {
    let mut found = Found::default();
    found.list(items);
    let apart = "for a product, put a space \\, between the letters";
    let is_new = |word: &str| !word.chars().any(|letter| found.others.contains(&letter));
    let called = found.called.iter().find(|(word, _, is_call)| is_known(word) || *is_call && is_new(word));
    if let Some((word, span, _)) = called {
        return Some(
            Fault::ambiguous(*span, format!("{word} may be a name or a product"))
                .help(format!("write \\operatorname{{{word}}} for the name, or a letter with a subscript; {apart}")),
        );
    }
    let (word, span) = found.side_of_a_triangle().or(found.ratio)?;
    Some(
        Fault::ambiguous(span, format!("{word} may be the length between two points or a product"))
            .help(format!("write |\\overrightarrow{{{word}}}| for the length; {apart}")),
    )
}

fn is_sign_of_a_set(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if ["\\in", "\\notin", "\\subset", "\\subseteq"].contains(&name.as_str()))
}

fn is_known(word: &str) -> bool {
    NAMES.contains(&word)
}

#[derive(Default)]
struct Found {
    /// Words directly before a parenthesis that are known or consist of capitals, and whether it holds a name, a number or a list.
    called: Vec<(String, Span, bool)>,
    /// Two capitals side by side, without a parenthesis after them.
    pairs: BTreeMap<String, Span>,
    /// The letters outside of all these.
    others: BTreeSet<char>,
    /// The lower side of a quotient of two sides with a common point.
    ratio: Option<(String, Span)>,
}

impl Found {
    fn list(&mut self, items: &[Item]) {
        let mut at = 0;
        // `x \in SO(3)`: behind the sign stands the name of a set.
        let is_map = items.iter().any(|item| item.layout == Layout::Other(':'));
        let is_arrow = |item: &Item| is_map && matches!(&item.layout, Layout::Command(name) if name == "\\rightarrow");
        let set = items.iter().position(|item| is_sign_of_a_set(item) || is_arrow(item)).unwrap_or(items.len());
        while at < items.len() {
            let length = match run_of_letters(items, at).filter(|_| at < set) {
                Some((word, span, length)) => {
                    self.word(word, span, items.get(at + length));
                    length
                }
                None => 1,
            };
            items[at..at + length].iter().for_each(|item| self.inside(item));
            at += length;
        }
    }

    fn inside(&mut self, item: &Item) {
        match &item.layout {
            Layout::Scripts { nucleus, sup, .. } => {
                if !matches!(nucleus.layout, Layout::Letter(_)) {
                    self.inside(nucleus);
                }
                if let Some(sup) = sup {
                    self.list(contents(sup));
                }
            }
            Layout::Fraction(above, below) => {
                // `\frac{CP}{CH}`: nobody leaves a common factor above and below.
                if let (Some((first, _)), Some((second, span))) = (side(above), side(below))
                    && first != second
                    && first.chars().any(|point| second.contains(point))
                {
                    self.ratio.get_or_insert((second, span));
                }
                [above, below].into_iter().for_each(|part| self.list(contents(part)));
            }
            _ => parts(item).into_iter().for_each(|part| self.list(part)),
        }
    }

    fn word(&mut self, word: String, span: Span, next: Option<&Item>) {
        let are_capitals = word.len() > 1 && word.chars().all(|c| c.is_ascii_uppercase());
        match next.and_then(called) {
            Some(is_call) if is_known(&word) || are_capitals && is_call => {
                self.called.push((word, span, is_call));
            }
            None if are_capitals && word.len() == 2 => {
                self.pairs.entry(word).or_insert(span);
            }
            _ => self.others.extend(word.chars()),
        }
    }

    /// One of three pairs of three letters that stand nowhere else.
    fn side_of_a_triangle(&self) -> Option<(String, Span)> {
        let letters: BTreeSet<char> = self.pairs.keys().flat_map(|pair| pair.chars()).collect();
        let sides: BTreeSet<BTreeSet<char>> = self.pairs.keys().map(|pair| pair.chars().collect()).collect();
        let is_triangle = letters.len() == 3 && sides.len() == 3 && sides.iter().all(|side| side.len() == 2);
        let first = self.pairs.iter().next().filter(|_| is_triangle && letters.is_disjoint(&self.others))?;
        Some((first.0.clone(), *first.1))
    }
}

/// Two capitals that are all of a part of a quotient.
fn side(part: &Item) -> Option<(String, Span)> {
    let items = contents(part);
    let (word, span, length) = run_of_letters(items, 0)?;
    let are_letters = items.iter().all(|item| matches!(item.layout, Layout::Letter('A'..='Z')));
    (length == 2 && items.len() == 2 && are_letters).then_some((word, span))
}

/// Whether a lone name, a number or a list stands in a parenthesis; `None` for anything else than a parenthesis.
fn called(item: &Item) -> Option<bool> {
    let fence = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    let Layout::Fence(delimiter @ (Delimiter::Round | Delimiter::Square), inside) = &fence.layout else { return None };
    let is_alone = match inside.as_slice() {
        [only] => matches!(only.layout, Layout::Number(_)) || names::printed(only, None).is_some(),
        _ => false,
    };
    let is_list = inside.iter().any(|item| matches!(item.layout, Layout::Other(',' | ';' | '|')));
    Some(*delimiter == Delimiter::Round && (is_alone || is_list))
}
