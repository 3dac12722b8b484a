//! Parentheses after a name that hold a factor by what stands in or beside them.

use crate::formula::SymbolId;

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names;
use super::super::state::Reader;
use super::inside::{parenthesis, relation_or_comma};

impl Reader<'_> {
    /// Whether braces hold a sum, `D\{a + b\}`, or a coefficient stands before brackets around parentheses, `a[(b + c) + d]`.
    /// The arguments of a function stand in neither.
    pub(super) fn is_a_product_by_its_brackets(&self, id: SymbolId, fence: &Item) -> bool {
        let Layout::Fence(delimiter, inside) = &fence.layout else { return false };
        let name = &self.symbols.entry(id).name;
        let is_sum = inside.iter().skip(1).any(|item| self.is_sign(item));
        let holds = |of: &dyn Fn(&Item) -> bool| inside.iter().any(of);
        let is_enclosed = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::Round, _));
        const COEFFICIENTS: [&str; 9] = ["a", "b", "c", "k", "A", "B", "C", "\\alpha", "\\lambda"];
        is_sum
            && !holds(&relation_or_comma)
            && name.primes == 0
            && match delimiter {
                Delimiter::Curly => name.base.chars().all(char::is_alphabetic),
                // `H_0^2[\Omega_m + \Omega_r]`
                Delimiter::Square => {
                    COEFFICIENTS.contains(&name.base.as_str()) && holds(&is_enclosed) || name.subscript == ["0"]
                }
                _ => false,
            }
    }

    /// Whether a parenthesis with more than a letter stands between a wave function with a star and the same without.
    pub(super) fn is_between_states(&self, id: SymbolId, items: &[Item], cursor: usize) -> bool {
        let base = self.symbols.entry(id).name.base.as_str();
        let is_wave = ["\\psi", "\\Psi", "\\phi", "\\varphi"].contains(&base);
        let mut rest = items[cursor.min(items.len())..].iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let is_operator = rest.next().and_then(parenthesis).is_some_and(|(_, inside)| inside.len() > 1);
        let next = rest.next().and_then(|next| names::printed(next, self.branch));
        is_wave && is_operator && next.is_some_and(|next| next.name.base == base)
    }
}
