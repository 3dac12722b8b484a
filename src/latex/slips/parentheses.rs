//! Edits of parentheses that are lost or close too early or too late, and of powers on the wrong factor.

use crate::source::Span;

use super::super::layout::{Delimiter, Item, Layout};
use super::edit::Slip;
use super::finder::Finder;
use super::parts::{Factor, Term, formulas, is_function};

/// The most terms or factors that a parenthesis gains or loses.
const FARTHEST: usize = 4;

/// The most ways in which new parentheses are tried.
const MOST: usize = 400;

/// The parts of a parenthesis: its opening, its contents, its closing with its scripts.
struct Fence<'i> {
    whole: Span,
    inner: Span,
    items: &'i [Item],
}

fn fence(item: &Item) -> Option<Fence<'_>> {
    let (fenced, whole) = match &item.layout {
        Layout::Fence(..) => (item, item.span),
        Layout::Scripts { nucleus, sub: None, primes: 0, .. } => (&**nucleus, item.span),
        _ => return None,
    };
    let Layout::Fence(Delimiter::Round | Delimiter::Square, items) = &fenced.layout else { return None };
    let inner = items.iter().map(|item| item.span).reduce(Span::to)?;
    (inner != fenced.span).then_some(Fence { whole, inner, items })
}

impl Finder<'_> {
    /// Slips at the parentheses of a term.
    pub(super) fn fences(&mut self, factors: &[Factor<'_>]) {
        for (rotation, angle) in factors.iter().zip(factors.iter().skip(1)) {
            if self.pool.is_some()
                && self.is_matrix(rotation)
                && fence(&angle.items[0]).is_none()
                && angle.operator.is_none()
            {
                let enclosed = format!("({})", self.slice(angle.span()));
                self.edit(Slip::Parenthesis, angle.span(), enclosed);
            }
        }
        for (at, factor) in factors.iter().enumerate() {
            let Some(last) = factor.items.last() else { continue };
            let Some(fence) = fence(last) else { continue };
            let open = self.slice(Span::new(fence.whole.start, fence.inner.start)).to_owned();
            let close = self.slice(Span::new(fence.inner.end, fence.whole.end)).to_owned();
            let inner = self.slice(fence.inner).to_owned();
            if matches!(last.layout, Layout::Fence(..)) {
                self.edit(Slip::Parenthesis, fence.whole, inner.clone());
                if self.pool.is_some() {
                    self.edit(Slip::Exponent, fence.whole, format!("\\sqrt{{{inner}}}"));
                    self.edit(Slip::Exponent, Span::at(fence.whole.end), "^2");
                    self.power_gathered(fence.whole, &open, fence.items, &close);
                }
            }
            if self.pool.is_some()
                && let Some(Item { layout: Layout::Scripts { nucleus, sub, sup: Some(sup), .. }, .. }) =
                    fence.items.last()
            {
                let base = sub.as_ref().map_or(nucleus.span, |sub| nucleus.span.to(sub.span));
                let (kept, power) = (self.slice(Span::new(fence.inner.start, base.end)), self.slice(sup.span));
                let moved = format!("{open}{kept}{close}^{power}");
                self.edit(Slip::Exponent, fence.whole, moved);
            }
            for cut in self.places(fence.items).into_iter().filter(|cut| *cut < fence.inner.end) {
                let (kept, out) = inner.split_at(cut - fence.inner.start);
                let moved = format!("{open}{}{close} {}", kept.trim_end(), out.trim_start());
                self.edit(Slip::Parenthesis, fence.whole, moved);
            }
            for taken in factors[at + 1..].iter().take(FARTHEST) {
                let more = self.slice(Span::new(fence.whole.end, taken.span().end)).to_owned();
                let span = Span::new(fence.whole.start, taken.span().end);
                self.edit(Slip::Parenthesis, span, format!("{open}{inner}{more}{close}"));
            }
        }
    }

    /// Where a parenthesis may close earlier: after one of its last factors, or after any of its terms.
    fn places(&self, items: &[Item]) -> Vec<usize> {
        let (mut places, mut ends) = (Vec::new(), Vec::new());
        for terms in formulas(items) {
            for term in &terms {
                places.extend(self.factors(term.items).iter().map(|factor| factor.span().end));
                ends.extend(places.last());
            }
        }
        let last = places.split_off(places.len().saturating_sub(FARTHEST + 1));
        ends.retain(|end| !last.contains(end));
        ends.into_iter().chain(last).collect()
    }

    /// Extends a parenthesis that may close too early over the terms after it. For corrections it also adds lost
    /// parentheses.
    pub(super) fn enclose(&mut self, terms: &[Term<'_>]) {
        for (at, term) in terms.iter().enumerate() {
            for factor in self.factors(term.items) {
                if let Some(fence) = factor.items.last().and_then(fence) {
                    self.take_in(&fence, &terms[at + 1..]);
                }
            }
        }
        if self.pool.is_none() || terms.len() < 2 {
            return;
        }
        // A function and its argument stay together.
        let place = |factor: &Factor<'_>| match factor.items {
            [function, argument] if is_function(function) => argument.span,
            _ => factor.span(),
        };
        let all: Vec<Vec<Span>> =
            terms.iter().map(|term| self.factors(term.items).iter().map(place).collect()).collect();
        // A power on the last factor alone, put on the sum, which may begin at any factor of its first term.
        for (at, term) in terms.iter().enumerate() {
            for last in terms[at + 1..].iter().filter_map(|later| later.items.last()) {
                if let Layout::Scripts { nucleus, sup: Some(sup), sub, .. } = &last.layout {
                    let base = sub.as_ref().map_or(nucleus.span, |sub| nucleus.span.to(sub.span));
                    for start in self.factors(term.items).iter().map(|factor| factor.span().start) {
                        let sum = self.slice(Span::new(start, base.end));
                        let gathered = format!("({sum})^{}", self.slice(sup.span));
                        self.edit(Slip::Exponent, Span::new(start, last.span.end), gathered);
                    }
                }
            }
        }
        let mut tried = 0;
        for (at, factors) in all.iter().enumerate() {
            for open in factors {
                for close in all[at + 1..].iter().flatten() {
                    tried += 1;
                    if tried > MOST {
                        return;
                    }
                    let span = Span::new(open.start, close.end);
                    let enclosed = format!("({})", self.slice(span));
                    self.edit(Slip::Parenthesis, span, enclosed);
                }
            }
        }
    }

    /// Moves the end of a parenthesis behind any factor of the terms after it.
    fn take_in(&mut self, fence: &Fence<'_>, behind: &[Term<'_>]) {
        let open = self.slice(Span::new(fence.whole.start, fence.inner.start)).to_owned();
        let close = self.slice(Span::new(fence.inner.end, fence.whole.end)).to_owned();
        let inner = self.slice(fence.inner).to_owned();
        for next in behind.iter().take(FARTHEST) {
            for factor in self.factors(next.items) {
                let more = self.slice(Span::new(fence.whole.end, factor.span().end)).to_owned();
                let span = Span::new(fence.whole.start, factor.span().end);
                self.edit(Slip::Parenthesis, span, format!("{open}{inner}{more}{close}"));
            }
        }
    }

    /// Moves a power from a parenthesis to its last factor, and back.
    pub(super) fn exponents(&mut self, factors: &[Factor<'_>]) {
        for (at, factor) in factors.iter().enumerate() {
            for item in factor.items {
                let Layout::Scripts { nucleus, sup: Some(sup), sub, primes: 0 } = &item.layout else { continue };
                let power = self.slice(sup.span).to_owned();
                if sub.is_none()
                    && let Layout::Fence(Delimiter::Round, items) = &nucleus.layout
                    && let (Some(first), Some(last)) = (items.first(), items.last())
                    && self.inside(nucleus, first).is_some()
                    && !matches!(last.layout, Layout::Scripts { sup: Some(_), .. })
                {
                    let inner = self.slice(first.span.to(last.span)).to_owned();
                    self.edit(Slip::Exponent, item.span, format!("{inner}^{power}"));
                    if self.pool.is_some() {
                        self.power_spread(item.span, items, &power);
                    }
                }
                if is_function(item)
                    && let [_, argument] = factor.items
                    && !matches!(argument.layout, Layout::Scripts { sup: Some(_), .. })
                {
                    let (function, argument) = (self.slice(nucleus.span), self.slice(argument.span));
                    let moved = format!("{function} {argument}^{power}");
                    self.edit(Slip::Exponent, factor.span(), moved);
                }
                self.gather_power(&factors[..=at], item, &power);
            }
        }
    }

    /// Moves the power of an item to a product that ends with it, or to the function whose argument it is.
    fn gather_power(&mut self, factors: &[Factor<'_>], item: &Item, power: &str) {
        let Layout::Scripts { nucleus, sub, .. } = &item.layout else { return };
        let base = sub.as_ref().map_or(nucleus.span, |sub| nucleus.span.to(sub.span));
        let Some((last, before)) = factors.split_last() else { return };
        let is_argument = last.items.len() == 2 && last.items[1].span == item.span;
        if is_argument && is_function(&last.items[0]) {
            let (function, argument) = (self.slice(last.items[0].span), self.slice(base));
            let moved = format!("{function}^{power} {argument}");
            self.edit(Slip::Exponent, last.span(), moved);
        }
        let starts = before.iter().rev().take(FARTHEST).chain(is_argument.then_some(last));
        for start in starts.map(|factor| factor.span().start).collect::<Vec<_>>() {
            let enclosed = format!("({})^{power}", self.slice(Span::new(start, base.end)));
            self.edit(Slip::Exponent, Span::new(start, item.span.end), enclosed);
        }
    }
}
