//! The slips of authors, as edits of what they typed; and the edits that undo such slips.
//!
//! [`slips`] gives every single slip in the text of a display: a sign, a factor, a dot, an index, a parenthesis.
//! [`corrections`] gives what mends one: the same edits, since most slips are undone by one of their own kind, and what
//! undoes the others, a factor or a term put in. They are found in what is typeset ([`super::layout`]) and in the names
//! of the document; what a formula means is not looked at, so a display that cannot be read has them too.
//!
//! An [`Edit`] is one run of bytes and what stands there instead. Nothing else of the author's text is touched. What a
//! macro of the author's expands to has no bytes of its own, and is left alone but as a whole.

mod atoms;
mod candidates;
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

/// So many terms that are like those that stand there are tried.
const LIKE: usize = 400;

/// Every single slip in the text of a display.
pub fn slips(text: &str, symbols: &Symbols, macros: &Macros) -> Vec<Edit> {
    found(text, symbols, macros, None)
}

/// The edits that undo a single slip; what may be put in is taken from `pool`.
pub fn corrections(text: &str, symbols: &Symbols, macros: &Macros, pool: &Pool) -> Vec<Edit> {
    found(text, symbols, macros, Some(pool))
}

fn found(text: &str, symbols: &Symbols, macros: &Macros, pool: Option<&Pool>) -> Vec<Edit> {
    // A display of which nothing is typeset at all has no terms, but its characters may be mended.
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
}
