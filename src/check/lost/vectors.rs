//! Vectors that were left out of a sum: those of the document, their rates, and the products of two of them.

use crate::formula::Kind;
use crate::formula::symbols::Entry;
use crate::latex::names;
use crate::latex::slips::Hole;

use super::{Lost, Proposal, is_small};

/// A vector that is wrong is found out at one of so many states.
const STATES: usize = 4;

/// So many vectors are multiplied by each other at most.
const MOST: usize = 8;

impl Lost<'_, '_> {
    /// The vectors with which the equation holds at a few states, added or taken away in a hole.
    pub(super) fn vectors(&self, hole: Hole) -> Vec<Proposal> {
        let mut found = Vec::new();
        for latex in self.all_vectors() {
            for sign in ['+', '-'] {
                let edit = hole.filled(sign, &latex);
                let reading = self.reading(&edit);
                let holds = |scene| {
                    let rows = self.residuals(&reading, scene);
                    rows.is_some_and(|rows| rows.iter().all(|row| is_small(row.value, row)))
                };
                if self.ensemble.scenes.iter().take(STATES).all(holds) {
                    let cost = 1 + usize::from(latex.contains("\\times"));
                    found.push(self.proposal(hole, sign, &latex, cost));
                }
            }
        }
        found
    }

    /// The vectors with a name of their own, their rates, and their products.
    fn all_vectors(&self) -> Vec<String> {
        let symbols = &self.desk.model.symbols;
        let is_vector = |entry: &Entry| entry.kind == Kind::Vector && entry.slots.is_empty();
        let vectors = symbols.iter().map(|(_, entry)| entry).filter(|entry| is_vector(entry));
        let named = |entry: &Entry| (0..=2).filter_map(|dots| names::with_dots(&entry.name, dots)).collect::<Vec<_>>();
        let single: Vec<String> = vectors.flat_map(named).map(|name| name.to_string()).collect();
        let (printed, others): (Vec<&String>, Vec<&String>) =
            single.iter().partition(|vector| self.wrong.text.contains(vector.as_str()));
        let factors: Vec<&String> = printed.iter().chain(&others).copied().take(MOST).collect();
        let products = factors.iter().flat_map(|a| factors.iter().map(move |b| format!("{a} \\times {b}")));
        single.iter().cloned().chain(products).collect()
    }
}
