//! Missing vectors of a sum: the vectors of the document, their rates, their vector products, and multiples of vectors that
//! the sum does not contain.

use crate::formula::symbols::Entry;
use crate::formula::{Kind, Node};
use crate::latex::slips::{InsertionPoint, Pool};
use crate::latex::{names, read_formula};

use crate::check::repair::missing_terms::{MissingPart, Proposal, is_small};
use crate::check::trial::failed_display::MISSING;

/// The number of states at which a vector is tried.
const STATES: usize = 4;

/// The largest number of vectors in products.
const MOST: usize = 8;

impl MissingPart<'_, '_> {
    /// The vectors that, added or subtracted in a hole, make the equation hold at a few states.
    pub(crate) fn vectors(&self, hole: InsertionPoint) -> Vec<Proposal> {
        let mut found = Vec::new();
        for latex in self.all_vectors() {
            for sign in ['+', '-'] {
                let edit = hole.filled(sign, &latex);
                let reading = self.reading(&edit);
                let holds = |state| {
                    let rows = self.residuals(&reading, state);
                    rows.is_some_and(|rows| rows.iter().all(|row| is_small(row.value, row)))
                };
                if self.ensemble.states.iter().take(STATES).all(holds) {
                    let cost = 1 + usize::from(latex.contains("\\times"));
                    found.push(self.proposal(hole, sign, &latex, cost));
                }
            }
        }
        found
    }

    /// Multiples of the vectors that are in the document and not in the sum with the hole.
    pub(crate) fn multiples(&self, hole: InsertionPoint) -> Vec<Proposal> {
        let printed = &self.wrong.text[hole.whole.range()];
        let directions = self.directions.get_or_init(|| self.all_directions());
        let others = directions.iter().filter(|direction| !printed.contains(direction.as_str()));
        others.filter_map(|direction| self.along(hole, direction)).collect()
    }

    /// The missing term, if it is a multiple of this vector.
    fn along(&self, hole: InsertionPoint, direction: &str) -> Option<Proposal> {
        let filling = |number: &str| self.reading(&hole.filled('+', &format!("{number} \\, {direction}")));
        let [one, two] = ["1", "2"].map(filling);
        if one.statements.iter().any(std::result::Result::is_err) {
            return None;
        }
        let needed = self.needed(hole, &one, &two)?;
        let (link, first) = self.link(self.wrong.reading, needed.row)?;
        // All components have the same factor, and some have a shorter normal form.
        let others = (0..3).filter(|row| *row != first);
        let mut rows = std::iter::once(first).chain(others);
        let found = rows.find_map(|row| self.formula(hole, &needed, (&link, row), &one))?;
        let (sign, factor) = found.sum.map_or((found.sign, found.latex), |sum| ('+', format!("({sum})")));
        Some(self.proposal(hole, sign, &format!("{factor} \\, {direction}"), found.cost + 1))
    }

    /// The vectors in the document, those of the wrong equation first.
    fn all_directions(&self) -> Vec<String> {
        let (checker, model) = (self.checker, self.checker.model);
        let others = checker.notes.equations.iter().map(|display| display.text.as_str());
        let texts = [self.wrong.text].into_iter().chain(others);
        let pools = texts.map(|text| Pool::of(std::iter::once(text), &model.symbols, &model.macros, MISSING));
        let mut directions: Vec<String> = Vec::new();
        for factor in pools.flat_map(|pool| pool.factors().to_vec()) {
            let read = read_formula(&factor, &mut model.symbols.clone(), &model.macros);
            let is_vector = read.is_ok_and(|expr| match &expr.node {
                Node::Symbol { id, dots: 0, .. } => {
                    id.0 < model.symbols.len() && model.symbols.entry(*id).kind == Kind::Vector
                }
                _ => false,
            });
            if is_vector && !directions.contains(&factor) {
                directions.push(factor);
            }
        }
        directions.truncate(MOST);
        directions
    }

    /// The declared vectors, their rates, and their vector products.
    fn all_vectors(&self) -> Vec<String> {
        let symbols = &self.checker.model.symbols;
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
