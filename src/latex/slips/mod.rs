//! Slips, the small mistakes of authors, as edits of a display; and the edits that may correct them.
//!
//! [`slips`] gives every single slip in the text of a display, for mutation testing: another sign, factor, dot,
//! index or parenthesis. [`corrections`] gives the candidate corrections: the same edits, and insertions of a
//! factor or a term. Both use the layout ([`super::layout`]) and the names of the document, but not the meaning of
//! a formula. A display that cannot be read has them too.
//!
//! An [`Edit`] replaces one range of bytes. The rest of the author's text stays as it is. The expansion of a macro
//! has no bytes of its own; only the whole call is edited.
//!
//! Offers [`slips`], [`corrections`] and [`of_like_terms`]. Knows the layout, the reader and symbols; nothing of verdicts.
//!
//! # Why slips are edits of the text
//!
//! A slip is made by typing and corrected by typing. So slips are found in what is typeset, with their bytes,
//! without knowing what a formula means. The same edits serve mutation testing, which makes them, and repair, which
//! undoes them, also in a display that cannot be read. Every kind of slip is undone by one of its own kind, or by
//! inserting what was lost. The lost text is sought in the display first, then in the other displays, in the
//! sentences, and then computed. Members of families with unpaired letters come first: a letter is free on both sides or
//! summed over, so an unpaired letter was also a letter of the lost factor.

mod atoms;
mod candidates;
mod derivatives;
mod edit;
mod exchanges;
mod finder;
mod index_families;
mod insertion_points;
mod insertions;
mod parentheses;
mod parts;
mod pool;
mod terms;
#[cfg(test)]
mod tests;
mod unmatched_parentheses;

use std::collections::HashSet;

use crate::formula::Symbols;

use super::layout::typeset_items;
use super::macros::Macros;
use finder::Finder;
use unmatched_parentheses::balanced;

pub use edit::{Edit, Slip};
pub use insertion_points::{InsertionPoint, insertion_points};
pub use pool::Pool;

/// The most terms with a slip that are tried.
const LIKE: usize = 400;

/// Every single slip in the text of a display.
pub fn slips(text: &str, symbols: &Symbols, macros: &Macros) -> Vec<Edit> {
    found(text, symbols, macros, None)
}

/// The edits that may correct a single slip. Factors and terms to insert are taken from `pool`.
pub fn corrections(text: &str, symbols: &Symbols, macros: &Macros, pool: &Pool) -> Vec<Edit> {
    found(text, symbols, macros, Some(pool))
}

fn found(text: &str, symbols: &Symbols, macros: &Macros, pool: Option<&Pool>) -> Vec<Edit> {
    // A display that cannot be typeset has no terms, but its characters may be corrected.
    let Ok(items) = typeset_items(text, macros) else { return Vec::new() };
    let mut finder = Finder::new(text, symbols, pool);
    if pool.is_some() {
        finder.edits = balanced(text);
    }
    finder.display(&items);
    let mut seen = HashSet::new();
    let fresh = |edit: &Edit| text[edit.span.range()] != edit.replacement && seen.insert(edit.applied(text));
    finder.edits.into_iter().filter(fresh).collect()
}

impl Pool {
    /// The terms of the pool, each with every single slip in it. A lost term is often like a term that is there.
    pub fn of_like_terms(&self, symbols: &Symbols, macros: &Macros) -> Pool {
        let like = |term: &String| {
            let slips = slips(term, symbols, macros).into_iter().filter(|edit| edit.slip != Slip::Doubled);
            slips.map(|edit| edit.applied(term)).collect::<Vec<_>>()
        };
        let mut terms: Vec<String> = self.terms.iter().flat_map(like).take(LIKE).collect();
        terms.retain(|term| !self.terms.contains(term));
        Pool { terms, ..Pool::default() }
    }
}
