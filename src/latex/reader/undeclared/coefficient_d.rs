//! Whether d is a factor in a display, and no differential: `\sin(ay + dz)`.
//!
//! In the argument of a function or in an exponent, outside of derivatives and integrals, a d before a letter is no differential
//! as a rule: at most an infinitesimal angle. It is a factor for sure beside another term that is a letter before a letter.

use super::super::super::layout::{Item, Layout, contents};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::{differential, function_head, is_any_integral};

/// What a display shows about its d.
#[derive(Default)]
pub(in super::super::super) struct Evidence {
    /// Whether a d before a letter stands among other factors in the argument of a function or in an exponent.
    pub is_in_a_function: bool,
    /// Whether it is a factor there.
    pub is_factor: bool,
    /// Whether an integral stands anywhere.
    pub has_integral: bool,
}

/// What some items show.
pub(in super::super::super) fn of(items: &[Item]) -> Evidence {
    let mut found = Evidence::default();
    found.list(items, false);
    found
}

impl Evidence {
    fn list(&mut self, items: &[Item], in_function: bool) {
        let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        if in_function {
            let terms: Vec<&[&Item]> = solid.split(|item| matches!(item.layout, Layout::Other('+' | '-'))).collect();
            // `\sin d\theta` and `\cos(\theta + d\theta)` are of small angles.
            let is_factor = |item: &&&Item| !matches!(item.layout, Layout::Number(_));
            let has_d = |term: &[&Item]| (0..term.len()).any(|at| is_product(&term[at..], true));
            let among_factors = terms.iter().any(|term| has_d(term) && term.iter().filter(is_factor).count() > 2);
            let with_d = terms.iter().any(|term| is_product(term, true) && term.len() == 2);
            let without = terms.iter().any(|term| is_product(term, false) && term.len() == 2);
            self.is_factor |= with_d && without;
            self.is_in_a_function |= among_factors || with_d && without;
        }
        self.is_factor |= !in_function && is_polynomial(&solid);
        for (at, item) in solid.iter().enumerate() {
            self.has_integral |= is_any_integral(item);
            let is_argument = at > 0 && matches!(function_head(solid[at - 1]), Ok(Some(_)));
            self.inside(item, in_function || is_argument);
        }
    }

    fn inside(&mut self, item: &Item, in_function: bool) {
        match &item.layout {
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items, in_function),
            Layout::Fraction(above, below) => {
                let begins = |part: &Item| contents(part).first().is_some_and(|first| differential(first).is_some());
                if !(begins(above) && begins(below)) {
                    self.list(contents(above), in_function);
                    self.list(contents(below), in_function);
                }
            }
            Layout::Root(_, inner) => {
                // `\sqrt{d\alpha}`: nobody takes the root of one differential.
                let inner: Vec<&Item> =
                    contents(inner).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
                self.is_in_a_function |= is_product(&inner, true) && inner.len() == 2;
                self.list(&inner.into_iter().cloned().collect::<Vec<_>>(), in_function);
            }
            Layout::Scripts { nucleus, sup, .. } => {
                self.inside(nucleus, in_function);
                if let Some(sup) = sup
                    && nucleus.layout == Layout::Letter('e')
                {
                    self.list(contents(sup), true);
                }
            }
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell, in_function)),
            _ => {}
        }
    }
}

/// Whether two letters side by side begin here, of which the first is d, or is not.
fn is_product(items: &[&Item], by_d: bool) -> bool {
    let [first, second, ..] = items else { return false };
    let is_d = differential(first).is_some();
    let is_plain = |item: &Item| names::printed(item, None).is_some_and(|found| found.dots == 0);
    is_d == by_d && is_plain(first) && is_plain(second)
}

/// Whether d is a coefficient of a polynomial, `a t^3 + b t^2 + d t`: two other letters stand before powers of the letter after it.
fn is_polynomial(solid: &[&Item]) -> bool {
    let divides = |item: &&Item| matches!(item.layout, Layout::Other('+' | '-')) || relation(item).is_some();
    let terms = || solid.split(divides);
    let variable = |item: &Item| names::printed(item, None).filter(|found| found.dots == 0).map(|found| found.name);
    let Some(of_d) = terms().find(|term| is_product(term, true) && term.len() == 2) else { return false };
    let power = |item: &Item| matches!(&item.layout, Layout::Scripts { sub: None, sup: Some(_), primes: 0, .. });
    let has_same = |term: &[&Item]| {
        matches!(term, [first, second] if power(second) && !power(first)
            && differential(first).is_none() && variable(second) == variable(of_d[1]))
    };
    terms().filter(|term| has_same(term)).count() > 1
}
