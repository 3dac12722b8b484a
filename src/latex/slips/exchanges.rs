//! Edits for corrections only: two parts exchanged, a product for a quotient, lost bars of a norm, lost roots, lost squares of
//! all terms of a sum, and 0 for a whole side.

use crate::formula::Kind;
use crate::source::Span;

use super::super::layout::{Item, Layout};
use super::super::names;
use super::edit::Slip;
use super::finder::{Finder, ends_in_command};
use super::parts::{Factor, Term, formulas, insides, is_big, is_sum, is_times};

/// The most pairs of names that are exchanged in one formula.
const EXCHANGES: usize = 24;

/// The most entries after a matrix entry that it is exchanged with.
const MOST_CELLS: usize = 8;

/// The numerators and denominators that authors confuse with one another, as ½ with ⅔.
const COEFFICIENTS: [(&str, &str); 12] = [
    ("1", "2"),
    ("1", "3"),
    ("2", "3"),
    ("3", "2"),
    ("1", "4"),
    ("3", "4"),
    ("4", "3"),
    ("2", "5"),
    ("3", "5"),
    ("1", "6"),
    ("1", "8"),
    ("1", "12"),
];

/// The names in an item, and whether they stand in a fraction or in parentheses.
fn gather<'i>(item: &'i Item, within: bool, names: &mut Vec<(&'i Item, bool)>) {
    if names::printed(item, None).is_some() {
        names.push((item, within));
    } else if matches!(item.layout, Layout::Fraction(..) | Layout::Fence(..) | Layout::Group(_)) {
        insides(item).into_iter().flatten().for_each(|inner| gather(inner, true, names));
    }
}

impl Finder<'_> {
    /// Two names of a formula exchanged.
    pub(super) fn exchange(&mut self, terms: &[Term<'_>]) {
        let mut names: Vec<&Item> = Vec::new();
        for term in terms {
            let factors = self.factors(term.items);
            let single = factors.iter().filter(|factor| factor.items.len() == 1).map(|factor| &factor.items[0]);
            names.extend(single.filter(|item| names::printed(item, None).is_some()));
        }
        let pairs = names.iter().enumerate().flat_map(|(at, a)| names[at + 1..].iter().map(move |b| (*a, *b)));
        // What comes from a macro stands where its call does, and may hold what stands in its argument.
        let differ = |(a, b): &(&Item, &Item)| {
            a.span.end <= b.span.start && self.slice(a.span) != self.slice(b.span) && self.kind(a) == self.kind(b)
        };
        let pairs: Vec<_> = pairs.filter(differ).take(EXCHANGES).collect();
        for (a, b) in pairs {
            self.edit(Slip::Name, a.span.to(b.span), self.exchanged(a.span, b.span));
        }
    }

    /// Two names of a term exchanged, of which one at least stands in a fraction or in parentheses.
    pub(super) fn exchange_within(&mut self, term: &Term<'_>) {
        let mut names: Vec<(&Item, bool)> = Vec::new();
        for item in term.items {
            gather(item, false, &mut names);
        }
        let pairs = names.iter().enumerate().flat_map(|(at, a)| names[at + 1..].iter().map(move |b| (*a, *b)));
        let differ = |((a, a_within), (b, b_within)): &((&Item, bool), (&Item, bool))| {
            (*a_within || *b_within)
                && a.span.end <= b.span.start
                && self.slice(a.span) != self.slice(b.span)
                && self.kind(a).is_some()
                && self.kind(a) == self.kind(b)
        };
        let undotted = pairs.clone().take(EXCHANGES).filter_map(|((a, _), (b, _))| self.without_dot(a, b));
        let pairs = pairs.filter(differ).take(EXCHANGES).map(|((a, _), (b, _))| (a.span, b.span));
        let pairs: Vec<(Span, Span)> = pairs.chain(undotted).collect();
        for (a, b) in pairs {
            self.edit(Slip::Name, a.to(b), self.exchanged(a, b));
        }
    }

    /// Two names of which one has a dot, which stays in its place: `x \dot y` for `y \dot x`.
    fn without_dot(&self, a: &Item, b: &Item) -> Option<(Span, Span)> {
        let dotted = |item: &Item| match &item.layout {
            Layout::Accent(command, inner) if command.starts_with("\\d") => match &inner.layout {
                Layout::Group(items) => items.first().map(|only| only.span),
                _ => Some(inner.span),
            },
            _ => None,
        };
        let (first, second) = match (dotted(a), dotted(b)) {
            (None, Some(inner)) => (a.span, inner),
            (Some(inner), None) => (inner, b.span),
            _ => return None,
        };
        let is_like = self.kind(a).is_some() && self.kind(a) == self.kind(b);
        (is_like && first.end < second.start).then_some((first, second))
    }

    /// Two rows of a matrix exchanged, and two of its entries.
    pub(super) fn exchange_cells(&mut self, rows: &[Vec<Vec<Item>>]) {
        if self.pool.is_none() {
            return;
        }
        let span = |cell: &[Item]| cell.iter().map(|item| item.span).reduce(Span::to);
        let of_row = |row: &Vec<Vec<Item>>| row.iter().filter_map(|cell| span(cell)).reduce(Span::to);
        let cells: Vec<Span> = rows.iter().flatten().filter_map(|cell| span(cell)).collect();
        for spans in [rows.iter().filter_map(of_row).collect(), cells] {
            for (at, first) in spans.iter().enumerate() {
                for second in spans[at + 1..].iter().take(MOST_CELLS) {
                    if !self.differ(first, second) {
                        continue;
                    }
                    self.edit(Slip::Name, first.to(*second), self.exchanged(*first, *second));
                }
            }
        }
    }

    /// The text with two parts exchanged: the second part, the text between them, and the first part.
    fn exchanged(&self, first: Span, second: Span) -> String {
        let rest = format!("{}{}", self.slice(Span::new(first.end, second.start)), self.slice(first));
        let second = self.slice(second);
        let runs_on = ends_in_command(second) && rest.starts_with(|c: char| c.is_ascii_alphabetic());
        format!("{second}{}{rest}", if runs_on { " " } else { "" })
    }

    /// Whether two parts are in order and differ in more than a sign, which has its own edit.
    fn differ(&self, first: &Span, second: &Span) -> bool {
        let unsigned = |span: &Span| self.slice(*span).trim_start_matches('-').trim_start().to_owned();
        first.end < second.start && unsigned(first) != unsigned(second)
    }

    /// A product in place of a fraction.
    pub(super) fn unfraction(&mut self, span: Span, above: &Item, below: &Item) {
        let factor = |item: &Item| {
            let bare = self.bare(item);
            let items = match &item.layout {
                Layout::Group(items) => items.as_slice(),
                _ => std::slice::from_ref(item),
            };
            match formulas(items).iter().all(|terms| terms.len() == 1) {
                true => bare.to_owned(),
                false => format!("({bare})"),
            }
        };
        let product = match self.bare(above) {
            "1" => factor(below),
            _ => format!("{} \\, {}", factor(above), factor(below)),
        };
        self.edit(Slip::Fraction, span, product);
    }

    /// The numbers before numerator and denominator exchanged, `\frac{2a}{3b}` for `\frac{3a}{2b}`; and two other numbers in
    /// their places, `\frac{2a}{3}` for `\frac{a}{2}`.
    pub(super) fn coefficients(&mut self, above: &Item, below: &Item) {
        let (Some(over), Some(under)) = (self.coefficient(above), self.coefficient(below)) else { return };
        let (n, m) = (self.slice(over.0).to_owned(), self.slice(under.0).to_owned());
        let mut others: Vec<(&str, &str, Slip)> = Vec::new();
        // Numerator and denominator that are numbers are exchanged as a whole.
        if !(n.is_empty() || m.is_empty() || n == m || over.1 && under.1) {
            others.push((&m, &n, Slip::Fraction));
        }
        let is_one = |number: &str| if number.is_empty() { "1".to_owned() } else { number.to_owned() };
        if !n.is_empty() || !m.is_empty() {
            let both = COEFFICIENTS.into_iter().filter(|(p, q)| is_one(&n) != *p && is_one(&m) != *q);
            others.extend(both.map(|(p, q)| (p, q, Slip::Number)));
        }
        let whole = above.span.to(below.span);
        for (p, q, slip) in others {
            let (p, q) = (self.with_coefficient(above, over, p), self.with_coefficient(below, under, q));
            let between = self.slice(Span::new(above.span.end, below.span.start));
            self.edit(slip, whole, format!("{p}{between}{q}"));
        }
    }

    /// Where the number before a numerator or a denominator stands, or would stand, and whether it is all of it. A sum has none.
    fn coefficient(&self, argument: &Item) -> Option<(Span, bool)> {
        let items = match &argument.layout {
            Layout::Group(items) => items.as_slice(),
            _ => std::slice::from_ref(argument),
        };
        let lists = formulas(items);
        let [terms] = &lists[..] else { return None };
        let [Term { sign: None, items }] = &terms[..] else { return None };
        let factors = self.factors(items);
        let first = factors.first()?;
        Some(match first.items {
            [Item { layout: Layout::Number(_), span }] => (*span, factors.len() == 1),
            _ => (Span::at(first.span().start), false),
        })
    }

    /// A numerator or a denominator with another number before it.
    fn with_coefficient(&self, argument: &Item, (place, is_all): (Span, bool), number: &str) -> String {
        let number = match number {
            "1" if !is_all => String::new(),
            _ if place.start == place.end => format!("{number} "),
            _ => number.to_owned(),
        };
        let before = self.slice(Span::new(argument.span.start, place.start));
        let text = format!("{before}{number}{}", self.slice(Span::new(place.end, argument.span.end)));
        if text.starts_with('{') { text } else { format!("{{{text}}}") }
    }

    /// The squares of all terms of a sum, where each is a name.
    pub(super) fn squares_lost(&mut self, terms: &[Term<'_>]) {
        let is_name = |term: &Term<'_>| {
            let power = |item: &Item| matches!(item.layout, Layout::Scripts { sup: Some(_), .. });
            matches!(term.items, [only] if names::printed(only, None).is_some() && !power(only))
        };
        if terms.len() < 2 || !terms.iter().all(is_name) || terms[0].sign.is_some() {
            return;
        }
        let squared = |term: &Term<'_>| {
            let sign = term.sign.map_or(String::new(), |sign| format!(" {} ", self.slice(sign.span)));
            format!("{sign}{}^2", self.slice(term.span()))
        };
        let whole = terms[0].span().to(terms[terms.len() - 1].span());
        let all: String = terms.iter().map(squared).collect();
        self.edit(Slip::Exponent, whole, all);
    }

    /// A quotient in place of a factor.
    pub(super) fn divide(&mut self, factors: &[Factor<'_>]) {
        for factor in factors {
            if let [only] = factor.items
                && (names::printed(only, None).is_some() || matches!(only.layout, Layout::Number(_)))
                && only.layout != Layout::Number("1".to_owned())
            {
                self.edit(Slip::Fraction, only.span, format!("\\frac{{1}}{{{}}}", self.slice(only.span)));
            }
        }
    }

    /// The norm of a vector that is the last factor of a term, or of a product of two.
    pub(super) fn norms(&mut self, terms: &[Term<'_>]) {
        terms.iter().for_each(|term| self.norm(term));
    }

    fn norm(&mut self, term: &Term<'_>) {
        let factors = self.factors(term.items);
        let [.., last] = factors.as_slice() else { return };
        let crossed = || factors.iter().rev().nth(1).filter(|_| last.operator.is_some_and(is_times));
        let whole = crossed().map_or(last.span(), |before| before.span().to(last.span()));
        if self.kind(&last.items[0]) == Some(Kind::Vector) {
            self.edit(Slip::Accent, whole, format!("|{}|", self.slice(whole)));
        }
    }

    /// The root of what stands above or below in a fraction, and is no number and no power.
    pub(super) fn root_lost(&mut self, argument: &Item) {
        let has_none = |items: &[Item]| match items {
            [] => true,
            [only] => {
                matches!(only.layout, Layout::Number(_) | Layout::Root(..) | Layout::Scripts { sup: Some(_), .. })
            }
            _ => false,
        };
        if let Layout::Group(items) = &argument.layout
            && self.pool.is_some()
            && !has_none(items)
        {
            self.edit(Slip::Exponent, argument.span, format!("{{\\sqrt{}}}", self.slice(argument.span)));
        }
    }

    /// The root of a whole sum, of a whole product, and of a fraction in it.
    pub(super) fn roots_lost(&mut self, terms: &[Term<'_>]) {
        let (Some(first), Some(last)) = (terms.first(), terms.last()) else { return };
        let mut lost: Vec<Span> = Vec::new();
        if terms.len() > 1 {
            let start = first.sign.map_or(first.span().start, |sign| sign.span.start);
            lost.push(Span::new(start, last.span().end));
        }
        for term in terms {
            let factors = self.factors(term.items);
            let is_fraction =
                |factor: &&Factor<'_>| matches!(factor.items, [Item { layout: Layout::Fraction(..), .. }]);
            let is_big = |factor: &Factor<'_>| is_big(&factor.items[0]);
            if factors.len() > 1 && !factors.iter().any(is_big) {
                lost.push(term.span());
            }
            lost.extend(factors.iter().filter(is_fraction).map(Factor::span));
        }
        for span in lost {
            let inner = self.slice(span);
            if !inner.starts_with("\\sqrt") && !inner.contains("{dt") {
                self.edit(Slip::Exponent, span, format!("\\sqrt{{{inner}}}"));
            }
        }
    }

    /// The power of a parenthesis moved to each of its terms.
    pub(super) fn power_spread(&mut self, whole: Span, inside: &[Item], power: &str) {
        let [terms] = &formulas(inside)[..] else { return };
        if terms.len() < 2 || terms[0].sign.is_some() {
            return;
        }
        let spread: String = terms
            .iter()
            .map(|term| {
                let sign = term.sign.map_or(String::new(), |sign| format!(" {} ", self.slice(sign.span)));
                format!("{sign}{}^{power}", self.slice(term.span()))
            })
            .collect();
        self.edit(Slip::Exponent, whole, format!("({spread})"));
    }

    /// The power of all terms of a parenthesis moved to the parenthesis.
    pub(super) fn power_gathered(&mut self, whole: Span, open: &str, inside: &[Item], close: &str) {
        let [terms] = &formulas(inside)[..] else { return };
        let mut gathered = String::new();
        let mut power: Option<String> = None;
        for (at, term) in terms.iter().enumerate() {
            let Some(Item { layout: Layout::Scripts { nucleus, sub, sup: Some(sup), .. }, .. }) = term.items.last()
            else {
                return;
            };
            let this = self.slice(sup.span).to_owned();
            if power.as_ref().is_some_and(|power| *power != this) || at == 0 && term.sign.is_some() {
                return;
            }
            let base = sub.as_ref().map_or(nucleus.span, |sub| nucleus.span.to(sub.span));
            let sign = term.sign.map_or(String::new(), |sign| format!(" {} ", self.slice(sign.span)));
            gathered = format!("{gathered}{sign}{}", self.slice(Span::new(term.span().start, base.end)));
            power = Some(this);
        }
        if let (Some(power), true) = (power, terms.len() > 1) {
            self.edit(Slip::Exponent, whole, format!("{open}{gathered}{close}^{power}"));
        }
    }

    /// 0 in place of a name, a product or a number that is a whole side.
    pub(super) fn nothing(&mut self, terms: &[Term<'_>]) {
        if let [term] = terms
            && term.items.len() > 1
            && self.text[..term.whole().start].trim_end().ends_with(['=', '&'])
            && !self.is_null(term)
        {
            self.edit(Slip::Term, term.whole(), "0");
        }
        if let [Term { sign: None, items: [only] }] = terms {
            if names::printed(only, None).is_some() {
                self.edit(Slip::Term, only.span, "0");
            } else if matches!(only.layout, Layout::Number(_))
                && !self.text[..only.span.start].trim_end().ends_with(['{', '('])
            {
                self.edit(Slip::Number, only.span, "0");
            }
        }
    }

    /// Another Σ of the display in place of this one; and edits of the limit under lim.
    pub(super) fn limits(&mut self, item: &Item, sub: &Item) {
        let Some(pool) = self.pool else { return };
        if is_sum(item) {
            pool.sums
                .iter()
                .filter(|sum| sum.starts_with("\\sum"))
                .for_each(|sum| self.edit(Slip::Index, item.span, sum.clone()));
        } else {
            self.argument(item, sub);
        }
    }
}
