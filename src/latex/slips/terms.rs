//! Edits of the terms of a sum and of the factors of a product: their signs, their order, one lost or typed twice.

use crate::source::Span;

use super::super::layout::{Delimiter, Item, Layout};
use super::super::names;
use super::edit::Slip;
use super::finder::Finder;
use super::parts::{Factor, Term, formulas, is_big, is_function, is_number, is_space, is_times};

impl Finder<'_> {
    /// Collects the edits of a display. An environment of rows that is the whole display is divided into its cells.
    pub(super) fn display(&mut self, items: &[Item]) {
        let mut significant = items.iter().filter(|item| !is_space(item) && item.layout != Layout::Other(','));
        match (significant.next(), significant.next()) {
            (Some(Item { layout: Layout::Environment(_, rows), .. }), None) => {
                rows.iter().flatten().for_each(|cell| self.list(cell));
            }
            _ => self.list(items),
        }
    }

    /// Collects the edits of a list and of all its parts.
    pub(super) fn list(&mut self, items: &[Item]) {
        for terms in formulas(items) {
            for (at, term) in terms.iter().enumerate() {
                // The sign and the factors of a zero do not matter.
                if self.is_null(term) {
                    continue;
                }
                self.sign(term, at == 0);
                if terms.len() > 1 {
                    self.drop_term(&terms, at);
                }
                // An author writes 2a and not a + a, so no correction repeats a term.
                if self.pool.is_none() {
                    self.double_term(term);
                }
                self.term(term);
            }
            self.enclose(&terms);
            if self.pool.is_some() {
                self.insert_terms(&terms);
                self.roots_lost(&terms);
                self.squares_lost(&terms);
                self.exchange(&terms);
                self.norms(&terms);
                self.nothing(&terms);
            }
        }
        for (at, item) in items.iter().enumerate() {
            self.relation(item);
            // The items of a macro share its bytes.
            let alone = |other: Option<&Item>| other.is_none_or(|other| other.span != item.span);
            if alone(at.checked_sub(1).and_then(|before| items.get(before))) && alone(items.get(at + 1)) {
                self.item(item);
            }
        }
        if self.pool.is_some() {
            formulas(items).iter().flatten().for_each(|term| self.exchange_within(term));
        }
    }

    /// Whether a term is 0 or the zero vector, or a product with it.
    pub(super) fn is_null(&self, term: &Term<'_>) -> bool {
        term.items.iter().any(|item| match &item.layout {
            Layout::Number(digits) => digits.bytes().all(|digit| matches!(digit, b'0' | b'.')),
            Layout::Accent(_, inner) | Layout::Style(_, inner) => {
                matches!(self.bare(inner), "0")
            }
            _ => false,
        })
    }

    /// Collects the edits of a term's sign. The first term needs no plus.
    fn sign(&mut self, term: &Term<'_>, is_first: bool) {
        let Some(sign) = term.sign else {
            self.edit(Slip::Sign, Span::at(term.span().start), "-");
            return;
        };
        let others: &[&str] = match self.slice(sign.span) {
            "+" => &["-"],
            "-" if is_first => &[""],
            "-" => &["+"],
            "\\pm" => &["+", "-", "\\mp"],
            "\\mp" => &["+", "-", "\\pm"],
            _ => &[],
        };
        for other in others {
            self.edit(Slip::Sign, sign.span, *other);
        }
        if self.pool.is_some() && matches!(self.slice(sign.span), "+" | "-") {
            self.edit(Slip::Sign, sign.span, "\\pm");
            self.edit(Slip::Sign, sign.span, "\\mp");
        }
    }

    fn drop_term(&mut self, terms: &[Term<'_>], at: usize) {
        let term = &terms[at];
        let span = match (at, term.sign, terms.get(1).and_then(|next| next.sign)) {
            // The sign of the first term is left to the second where it is a minus.
            (0, None, Some(next)) if self.slice(next.span) == "+" => {
                Span::new(term.span().start, terms[1].span().start)
            }
            (0, Some(_), Some(next)) if self.slice(next.span) == "+" => {
                Span::new(term.whole().start, terms[1].span().start)
            }
            _ => term.whole(),
        };
        let same = |other: usize| {
            let other = terms.get(other);
            other.is_some_and(|other| self.slice(other.span()) == self.slice(term.span()))
        };
        let twice = same(at + 1) || at > 0 && same(at - 1);
        self.edit(if twice { Slip::Doubled } else { Slip::Term }, span, "");
    }

    fn double_term(&mut self, term: &Term<'_>) {
        let sign = term.sign.map_or("+", |sign| self.slice(sign.span));
        let twice = format!(" {sign} {}", self.slice(term.span()));
        self.edit(Slip::Doubled, Span::at(term.span().end), twice);
    }

    /// The kind of slip of a repeated factor. In a correction a repetition is rarely what is missing.
    fn doubling(&self, loss: Slip) -> Slip {
        if self.pool.is_some() { loss } else { Slip::Doubled }
    }

    fn relation(&mut self, item: &Item) {
        let other = match self.slice(item.span) {
            "<" => ">",
            ">" => "<",
            "\\lt" => "\\gt",
            "\\gt" => "\\lt",
            "\\le" => "\\ge",
            "\\ge" => "\\le",
            "\\leq" => "\\geq",
            "\\geq" => "\\leq",
            "\\leqslant" => "\\geqslant",
            "\\geqslant" => "\\leqslant",
            _ => return,
        };
        self.edit(Slip::Relation, item.span, other);
    }

    /// Collects the edits of the factors of a term.
    fn term(&mut self, term: &Term<'_>) {
        let factors = self.factors(term.items);
        for (at, factor) in factors.iter().enumerate() {
            if factors.len() > 1 {
                self.drop_factor(&factors, at);
            }
            let is_number = matches!(factor.items[0].layout, Layout::Number(_));
            match self.place_of_a_power(factor) {
                // A factor that is missing beside the same factor is more likely a lost power.
                Some(at) if self.pool.is_some() => self.edit(Slip::Exponent, Span::at(at), "^2"),
                _ if is_number || is_big(&factor.items[0]) => {}
                _ => {
                    let twice = format!(" {}", self.slice(factor.span()));
                    self.edit(self.doubling(Slip::Factor), Span::at(factor.span().end), twice);
                }
            }
            let has_power = matches!(factor.items[0].layout, Layout::Scripts { sup: Some(_), .. });
            let is_name = factor.items.len() == 1 && names::printed(&factor.items[0], None).is_some();
            if self.pool.is_some() && is_name && (self.is_matrix(factor) || self.is_entry(factor)) && !has_power {
                self.edit(Slip::Exponent, Span::at(factor.span().end), "^{-1}");
            }
            if self.pool.is_some() {
                self.multiple_angle(&factors, at);
            }
            let Some(before) = at.checked_sub(1).map(|before| &factors[before]) else { continue };
            let swapped = Span::new(before.span().start, factor.span().end);
            let (a, b) = (self.slice(before.span()).to_owned(), self.slice(factor.span()).to_owned());
            match factor.operator.map(|operator| (operator.span, self.slice(operator.span))) {
                Some((span, "\\times" | "\\wedge")) => self.edit(Slip::Order, span, "\\cdot"),
                Some((span, "\\cdot")) => self.edit(Slip::Order, span, "\\times"),
                _ => {}
            }
            match factor.operator {
                Some(operator) if is_times(operator) => {
                    self.edit(Slip::Order, swapped, format!("{b} {} {a}", self.slice(operator.span)));
                }
                None if self.is_matrix(before) && self.is_matrix(factor) => {
                    self.edit(Slip::Order, swapped, format!("{b} {a}"));
                }
                _ => {}
            }
        }
        self.exponents(&factors);
        self.fences(&factors);
        if self.pool.is_some() {
            self.insert_factors(&factors);
            self.split(&factors);
            self.insert_sums(&factors);
            self.divide(&factors);
            self.multiply(&factors);
            self.associate(&factors);
            self.elements(&factors);
        }
    }

    /// `2 \cos\theta` for `\cos 2\theta`, and the other way round; the 2 lost, or one too many.
    fn multiple_angle(&mut self, factors: &[Factor<'_>], at: usize) {
        let is_number = |item: &Item| matches!(item.layout, Layout::Number(_));
        let factor = &factors[at];
        match factor.items {
            [function, .., number] if is_function(function) && is_number(number) => {
                let outside = format!("{} {}", self.slice(number.span), self.slice(function.span));
                self.edit(Slip::Function, factor.span(), outside);
                if factors.get(at + 1).is_some_and(|next| next.operator.is_none()) {
                    self.edit(Slip::Number, number.span, "");
                }
            }
            [function, argument] if is_function(function) && names::printed(argument, None).is_some() => {
                self.edit(Slip::Number, Span::at(argument.span.start), " 2 ");
            }
            [number] if is_number(number) => {
                let Some(Factor { operator: None, items: [function, rest @ ..] }) = factors.get(at + 1) else { return };
                if let (true, Some(argument)) = (is_function(function), rest.last()) {
                    let function = self.slice(function.span);
                    let inside = format!("{function} {} {}", self.slice(number.span), self.slice(argument.span));
                    self.edit(Slip::Function, number.span.to(argument.span), inside);
                }
            }
            _ => {}
        }
    }

    /// A quotient where a product is printed, as in `e^{-t/(RC)}` for `e^{-tRC}`.
    pub(super) fn quotients(&mut self, items: &[Item]) {
        for term in formulas(items).into_iter().flatten() {
            let factors = self.factors(term.items);
            if factors.iter().any(|factor| factor.operator.is_some() || is_big(&factor.items[0])) {
                continue;
            }
            let (Some(first), Some(last)) = (factors.first(), factors.last()) else { continue };
            for (before, after) in factors.iter().zip(factors.iter().skip(1)) {
                let above = self.slice(first.span().to(before.span())).to_owned();
                let below = self.slice(after.span().to(last.span())).to_owned();
                self.edit(Slip::Fraction, first.span().to(last.span()), format!("\\frac{{{above}}}{{{below}}}"));
            }
        }
    }

    /// The place for a power on a factor without one: after a name or a parenthesis, or between a function and its
    /// argument.
    fn place_of_a_power(&self, factor: &Factor<'_>) -> Option<usize> {
        let first = &factor.items[0];
        let bare = match &first.layout {
            Layout::Scripts { sup, primes, .. } => sup.is_none() && *primes == 0,
            Layout::Fence(delimiter, _) => matches!(delimiter, Delimiter::Round | Delimiter::Square),
            _ => true,
        };
        let takes = match factor.items {
            [only] => {
                let is_name = names::printed(only, None).is_some() && !self.is_matrix(factor);
                is_name || matches!(only.layout, Layout::Fence(..))
            }
            [function, ..] => is_function(function),
            [] => false,
        };
        (bare && takes).then_some(first.span.end)
    }

    fn drop_factor(&mut self, factors: &[Factor<'_>], at: usize) {
        let factor = &factors[at];
        let span = match (factor.operator, factors.get(at + 1).and_then(|next| next.operator)) {
            (Some(operator), _) => Span::new(operator.span.start, factor.span().end),
            (None, Some(next)) => Span::new(factor.span().start, next.span.end),
            (None, None) => factor.span(),
        };
        let same = |other: usize| {
            let other = factors.get(other);
            other.is_some_and(|other| self.slice(other.span()) == self.slice(factor.span()))
        };
        let twice = same(at + 1) || at > 0 && same(at - 1);
        let slip = match (twice, is_number(self.slice(factor.span()))) {
            (true, _) => Slip::Doubled,
            (false, true) => Slip::Number,
            (false, false) => Slip::Factor,
        };
        self.edit(slip, span, "");
        // The function is left out and its argument stays.
        if is_function(&factor.items[0]) {
            self.edit(Slip::Function, factor.items[0].span, "");
        }
    }
}
