//! Edits of one item: a name, its index, its dots and accents; a number; a function; a fraction; a power.

use crate::formula::symbols::{Entry, Name};
use crate::formula::{Index, IndexId, Kind, SymbolId};
use crate::source::Span;

use super::super::layout::{Item, Layout};
use super::super::names::{self, Printed, unaccented};
use super::edit::Slip;
use super::finder::Finder;
use super::parts::is_big;

/// The groups of functions that authors confuse.
const FUNCTIONS: [&[&str]; 4] =
    [&["\\sin", "\\cos", "\\tan"], &["\\cot", "\\tan"], &["\\sinh", "\\cosh", "\\tanh"], &["\\coth", "\\tanh"]];

impl Finder<'_> {
    /// Slips in an item and in its parts.
    pub(super) fn item(&mut self, item: &Item) {
        if let Some(printed) = names::printed(item, None) {
            self.name(item, &printed);
        }
        match &item.layout {
            Layout::Number(digits) => {
                // Nobody writes the sine of 1α.
                let before = self.text[..item.span.start].trim_end();
                let is_multiple = FUNCTIONS.iter().copied().flatten().any(|function| before.ends_with(function));
                self.number(item.span, digits, Some("1").filter(|_| is_multiple && self.pool.is_some()));
                self.number_of_root(item.span, digits);
            }
            Layout::Command(command) => self.function(item.span, command),
            Layout::Group(items) | Layout::Fence(_, items) if items.iter().all(|inner| inner.span != item.span) => {
                self.list(items);
            }
            // `\frac{d}{dt}` is no fraction.
            Layout::Fraction(a, b) if starts_with_d(a) && starts_with_d(b) => {}
            Layout::Fraction(a, b) => {
                if self.inside(item, a).is_some() && self.inside(item, b).is_some() {
                    self.marks(a, b);
                    let braced = |span| {
                        let text = self.slice(span);
                        if text.starts_with('{') { text.to_owned() } else { format!("{{{text}}}") }
                    };
                    let swapped = format!("\\frac{}{}", braced(b.span), braced(a.span));
                    self.edit(Slip::Fraction, item.span, swapped);
                    if self.pool.is_some() && number_of(b).is_none() {
                        self.unfraction(item.span, a, b);
                    }
                    self.root_lost(a);
                    self.root_lost(b);
                    if self.pool.is_some() {
                        self.coefficients(a, b);
                    }
                }
                match (number_of(a), number_of(b)) {
                    // A fraction of two numbers is not corrected into 1.
                    (Some((n, over)), Some((m, under))) if self.pool.is_some() => {
                        self.number(over, n, Some(m));
                        self.number(under, m, Some(n));
                    }
                    // Authors do not divide by 1.
                    (_, Some((m, under))) if self.pool.is_some() => {
                        self.argument(item, a);
                        self.number(under, m, Some("1"));
                        self.number_of_root(under, m);
                    }
                    _ => {
                        self.argument(item, a);
                        self.argument(item, b);
                    }
                }
            }
            Layout::Root(_, inner) => {
                self.argument(item, inner);
                if self.pool.is_some() {
                    self.edit(Slip::Fraction, item.span, format!("\\frac{{1}}{{{}}}", self.slice(item.span)));
                }
                if self.inside(item, inner).is_some() {
                    let bare = self.bare(inner);
                    self.edit(Slip::Exponent, item.span, format!("({bare})"));
                }
            }
            Layout::Environment(_, rows) => {
                rows.iter().flatten().for_each(|cell| self.list(cell));
                self.exchange_cells(rows);
            }
            Layout::Scripts { nucleus, sub, sup, .. } => {
                if let Some(sub) = sub.as_deref().filter(|_| is_big(item)) {
                    self.limits(item, sub);
                }
                if names::printed(item, None).is_none() {
                    self.argument(item, nucleus);
                }
                if let Some(sup) = sup.as_deref().filter(|sup| self.inside(item, sup).is_some()) {
                    self.power(sup);
                }
            }
            _ => {}
        }
    }

    /// The text of an argument without its braces.
    pub(super) fn bare(&self, item: &Item) -> &str {
        let text = self.slice(item.span);
        match item.layout {
            Layout::Group(_) => text.strip_prefix('{').and_then(|text| text.strip_suffix('}')).unwrap_or(text),
            _ => text,
        }
    }

    fn number(&mut self, span: Span, digits: &str, but: Option<&str>) {
        let Ok(n) = digits.parse::<u32>() else { return };
        let mut others = vec![n.saturating_mul(2), n.saturating_add(1)];
        others.extend((n % 2 == 0).then_some(n / 2));
        // The derivative and the integral of a cube bring a 3.
        if self.pool.is_some() {
            others.push(n.saturating_mul(3));
            others.extend((n % 3 == 0).then_some(n / 3));
        }
        // A product with 0 in it says nothing; where a number is a whole side, see `nothing`.
        others.extend(n.checked_sub(1).filter(|less| *less > 0 || self.pool.is_none()));
        if self.pool.is_some() && digits.len() == 1 {
            others.extend(1..=9);
        }
        // One digit of a number of two digits may be wrong.
        if self.pool.is_some() && digits.len() == 2 {
            others.extend((1..=9).map(|tens| 10 * tens + n % 10).chain((0..=9).map(|ones| n - n % 10 + ones)));
        }
        others.retain(|other| but != Some(other.to_string().as_str()));
        for other in others {
            self.edit(Slip::Number, span, other.to_string());
        }
    }

    /// `\sqrt{2}` for `2`, unless the number is an argument without braces.
    fn number_of_root(&mut self, span: Span, digits: &str) {
        let before = self.text[..span.start].trim_end();
        let is_bare = |text: &str| ["frac", "^", "_"].iter().any(|command| text.ends_with(command));
        let is_argument = is_bare(before) || before.strip_suffix(char::is_alphanumeric).is_some_and(is_bare);
        if self.pool.is_some() && matches!(digits.parse(), Ok(2..=9_u32)) && !is_argument {
            self.edit(Slip::Exponent, span, format!("\\sqrt{{{digits}}}"));
        }
    }

    fn function(&mut self, span: Span, command: &str) {
        if self.slice(span) != command {
            return;
        }
        if command == "\\infty" && self.pool.is_some() {
            self.edit(Slip::Number, span, "0");
        }
        for family in FUNCTIONS.iter().filter(|family| family.contains(&command)) {
            for other in family.iter().filter(|other| **other != command) {
                self.edit(Slip::Function, span, *other);
            }
        }
    }

    /// Another power, and none.
    fn power(&mut self, sup: &Item) {
        let caret = self.text[..sup.span.start].rfind('^').unwrap_or(sup.span.start);
        self.edit(Slip::Exponent, Span::new(caret, sup.span.end), "");
        let inner = match &sup.layout {
            Layout::Group(items) => items.as_slice(),
            _ => std::slice::from_ref(sup),
        };
        if let [Item { layout: Layout::Number(digits), .. }] = inner
            && let Ok(n) = digits.parse::<u32>()
        {
            if self.pool.is_some() {
                self.edit(Slip::Sign, sup.span, format!("{{-{n}}}"));
            }
            let mut others = vec![n.saturating_add(1), n.saturating_sub(1)];
            if self.pool.is_some() && digits.len() == 1 {
                others.extend([2 * n, n / 2].into_iter().filter(|other| other % 2 == 0 && *other < 10));
            }
            for other in others.into_iter().filter(|other| *other > 1) {
                self.edit(Slip::Exponent, sup.span, other.to_string());
            }
        } else if !is_mark(inner) {
            match &sup.layout {
                Layout::Group(items) => {
                    self.list(items);
                    if self.pool.is_some() {
                        self.quotients(items);
                    }
                }
                // A factor beside it needs braces.
                _ => {
                    let bare = self.slice(sup.span).to_owned();
                    self.edit(Slip::Sign, sup.span, format!("{{-{bare}}}"));
                    if self.pool.is_none() {
                        self.edit(Slip::Doubled, sup.span, format!("{{{bare} + {bare}}}"));
                    }
                    self.item(sup);
                }
            }
        }
    }

    /// Slips in a name: another like it, other dots, no accent, another index.
    fn name(&mut self, item: &Item, printed: &Printed<'_>) {
        let own = own_span(item);
        let found = self.symbols.find(&printed.name);
        if let Some((id, indices)) = &found {
            let entry = self.symbols.entry(*id);
            for (other, slip) in self.siblings(entry, item, printed) {
                if let Some(spelled) = spelled(self.symbols.entry(other), indices, printed.dots, self.symbols) {
                    self.edit(slip, own, spelled);
                }
            }
        }
        let varies = found.as_ref().is_none_or(|(id, _)| self.symbols.entry(*id).varies);
        if varies && printed.dots == 0 {
            let nucleus = nucleus(item);
            let text = self.slice(nucleus.span).to_owned();
            self.edit(Slip::Dot, nucleus.span, format!("\\dot{{{text}}}"));
        }
        if found.is_none() && self.pool.is_some() {
            for known in self.near(&printed.name) {
                if let Some(name) = names::with_dots(&known, printed.dots) {
                    self.edit(Slip::Symbol, own, name.to_string());
                }
            }
        }
        self.accent_lost(item, printed);
        self.rate_squared(item, printed);
        if printed.dots > 0 {
            self.dots(nucleus(item));
        }
        self.accents(nucleus(item));
        if let Layout::Scripts { sub: Some(sub), .. } = &item.layout
            && self.inside(item, sub).is_some()
        {
            // A component of a vector, `\omega_1` beside `\vec\omega`, is known without being declared.
            let is_known = found.is_some() || self.symbols.derived.contains_key(&printed.name.to_string());
            let family = |(_, entry): (SymbolId, &Entry)| {
                let count = printed.name.subscript.len();
                let is_component = entry.kind == Kind::Vector
                    && unaccented(&entry.name).base == printed.name.base
                    && entry.slots.len() + 1 == count;
                is_component || entry.name.base == printed.name.base && entry.slots.len() == count
            };
            let tensor = matches!(printed.name.base.as_str(), "\\delta" | "\\epsilon" | "\\varepsilon");
            let is_like = self.pool.is_some() && (tensor || self.symbols.iter().any(family));
            self.indices(sub, is_known || is_like);
        }
    }

    /// `\dot x^2` for `\ddot x`. The reverse is not tried, since too many wrong equations would pass with it.
    fn rate_squared(&mut self, item: &Item, printed: &Printed<'_>) {
        if self.pool.is_none() || printed.dots != 2 || printed.sup.is_some() {
            return;
        }
        let letter = Name { subscript: Vec::new(), ..printed.name.clone() };
        if let Some(rate) = names::with_dots(&letter, 1) {
            let subscript = self.slice(Span::new(nucleus(item).span.end, item.span.end));
            let square = format!("{rate}{subscript}^2");
            self.edit(Slip::Dot, item.span, square);
        }
    }

    /// The accents that a bare letter has elsewhere, and a hat where it is a vector.
    fn accent_lost(&mut self, item: &Item, printed: &Printed<'_>) {
        let bare = &printed.name.base;
        if self.pool.is_none() || unaccented(&printed.name).base != *bare {
            return;
        }
        let mut accented: Vec<String> = Vec::new();
        for (_, entry) in self.symbols.iter().filter(|(_, entry)| unaccented(&entry.name).base == *bare) {
            let hat = (entry.kind == Kind::Vector).then(|| format!("\\hat{{{bare}}}"));
            let own = Some(entry.name.base.clone()).filter(|base| base != bare);
            accented.extend(own.into_iter().chain(hat));
        }
        let nucleus = nucleus(item).span;
        accented.into_iter().for_each(|accented| self.edit(Slip::Accent, nucleus, accented));
    }

    /// The symbols that may be meant in place of this one.
    fn siblings(&self, entry: &Entry, item: &Item, printed: &Printed<'_>) -> Vec<(SymbolId, Slip)> {
        let letter = |name: &Name| unaccented(name).base;
        let own = letter(&entry.name);
        let alike = |other: &Entry| {
            let same = other.kind == entry.kind && other.slots.len() == entry.slots.len();
            let base = letter(&other.name);
            let is_unit = |entry: &Entry| self.pool.is_some() && entry.name.base.starts_with("\\hat");
            let are_angles = entry.angle && entry.varies && other.angle && other.varies;
            same && (base.eq_ignore_ascii_case(&own) || are_angles || is_unit(entry) && is_unit(other))
        };
        // In a correction, a lost accent may have changed the kind of the symbol.
        let corrected = |other: &Entry| {
            let same = letter(&other.name) == own && other.slots.len() == entry.slots.len();
            self.pool.is_some() && same && other.name.subscript == entry.name.subscript
        };
        // Or it stands for another symbol of its kind in the display.
        let present = |id: SymbolId, other: &Entry| {
            let known = self.pool.is_some_and(|pool| pool.names.contains(&id));
            // An angle is not confused with a momentum or a length.
            let is_time = self.symbols.time.as_ref() == Some(&other.name);
            let fits = (other.slots.is_empty() || other.slots.len() == entry.slots.len())
                && (other.angle || !entry.angle || is_time);
            known && fits && (other.kind == entry.kind || letter(&other.name) == own)
        };
        let slip = |id: SymbolId, other: &Entry| match alike(other) || corrected(other) {
            true => Some(Slip::Symbol),
            false => present(id, other).then_some(Slip::Name),
        };
        // A name that is defined by its square stands for a square.
        let is_square = ["^2", "^{2}"].iter().any(|square| self.text[own_span(item).end..].starts_with(square));
        let others = self.symbols.iter().filter(|(_, other)| (!other.squared || is_square) && other.measure.is_none());
        others
            .filter(|(_, other)| other.name != entry.name && other.name != printed.name)
            .filter_map(|(id, other)| Some((id, slip(id, other)?)))
            .collect()
    }

    /// The names of the document that may be meant by an unknown name: those with its letter or its subscript.
    fn near(&self, name: &Name) -> Vec<Name> {
        // `\varphi` and `\phi` are one letter to many.
        let letter = |name: &Name| unaccented(name).base.replace("\\var", "\\");
        let own = letter(name);
        let alike = |other: &Name| {
            letter(other).eq_ignore_ascii_case(&own) || !name.subscript.is_empty() && other.subscript == name.subscript
        };
        let known = self.symbols.iter().map(|(_, entry)| &entry.name).filter(|other| alike(other)).cloned();
        // `\omega_z`, for a component of `\vec\Omega`.
        let has_component = |entry: &Entry| {
            entry.kind == Kind::Vector
                && entry.slots.len() + 1 == name.subscript.len()
                && letter(&entry.name).eq_ignore_ascii_case(&own)
        };
        let vectors = self.symbols.iter().filter(|(_, entry)| has_component(entry));
        let components = vectors.map(|(_, entry)| Name { base: unaccented(&entry.name).base, ..name.clone() });
        known.chain(components).collect()
    }

    /// One dot more, and one dot fewer, on a dotted name.
    fn dots(&mut self, item: &Item) {
        match &item.layout {
            Layout::Accent(command, inner) if self.inside(item, inner).is_some() => {
                let text = self.bare(inner).to_owned();
                match command.as_str() {
                    "\\dot" => {
                        self.edit(Slip::Dot, item.span, text.clone());
                        self.edit(Slip::Dot, item.span, format!("\\ddot{{{text}}}"));
                    }
                    "\\ddot" => self.edit(Slip::Dot, item.span, format!("\\dot{{{text}}}")),
                    _ => {}
                }
            }
            _ => {}
        }
    }

    /// A lost accent that is no dot: a bar, a hat or an arrow, the outer one or an inner one.
    fn accents(&mut self, item: &Item) {
        let (Layout::Accent(command, inner) | Layout::Style(command, inner)) = &item.layout else { return };
        if self.inside(item, inner).is_none() || command == "\\mathrm" {
            return;
        }
        if !matches!(command.as_str(), "\\dot" | "\\ddot" | "\\dddot") {
            let text = self.bare(inner).to_owned();
            self.edit(Slip::Accent, item.span, text);
        }
        if let (Some(_), "\\vec" | "\\hat") = (self.pool, command.as_str()) {
            let other = if command == "\\vec" { "\\hat" } else { "\\vec" };
            self.edit(Slip::Accent, item.span, format!("{other}{{{}}}", self.bare(inner)));
        }
        match &inner.layout {
            Layout::Group(items) => {
                if let [only] = items.as_slice() {
                    self.accents(only);
                }
            }
            _ => self.accents(inner),
        }
    }

    /// Another index, and two of them swapped.
    fn indices(&mut self, sub: &Item, is_known: bool) {
        let items = match &sub.layout {
            Layout::Group(items) => items.as_slice(),
            _ => std::slice::from_ref(sub),
        };
        if !is_known {
            return;
        }
        let token = |item: &Item| match &item.layout {
            Layout::Letter(c) => Some(c.to_string()),
            Layout::Number(digits) => Some(digits.clone()),
            _ => None,
        };
        // `I_{12}` has two indices, though its digits are read as one number.
        let apart = |(text, span): (String, Span)| {
            let axes = text.len() == 2 && span.end - span.start == 2 && text.bytes().all(|c| matches!(c, b'1'..=b'3'));
            match axes {
                true => text.chars().zip(span.start..).map(|(c, at)| (c.to_string(), Span::new(at, at + 1))).collect(),
                false => vec![(text, span)],
            }
        };
        let tokens: Vec<(String, Span)> =
            items.iter().filter_map(|item| Some((token(item)?, item.span))).flat_map(apart).collect();
        let letter = |token: &str| self.symbols.index(token);
        let in_place = |token: &str| letter(token).is_some() || matches!(token, "1" | "2" | "3" | "4");
        let mut others: Vec<(Span, String)> = Vec::new();
        for (text, span) in tokens.iter().filter(|(text, _)| in_place(text)) {
            let same =
                |other: &IndexId| letter(text).is_some_and(|own| own != *other && self.symbols.same_range(own, *other));
            let all = (0..self.symbols.indices.len()).map(IndexId);
            others.extend(all.filter(same).map(|other| (*span, self.symbols.indices[other.0].letter.clone())));
            let values = ["1", "2", "3"].into_iter().filter(|value| value != text && letter(text).is_none());
            others.extend(values.map(|value| (*span, value.to_owned())));
        }
        if self.pool.is_some() {
            for (text, span) in tokens.iter().filter(|(text, _)| letter(text).is_none()) {
                let letters = self.symbols.indices.iter().map(|index| index.letter.clone());
                others.extend(letters.filter(|letter| letter != text).map(|letter| (*span, letter)));
            }
        }
        for (span, other) in others {
            self.edit(Slip::Index, span, other);
        }
        if let [(a, first), (b, second)] = tokens.as_slice()
            && a != b
            && [a, b].into_iter().all(|token| in_place(token))
        {
            self.edit(Slip::Index, first.to(*second), format!("{b}{a}"));
        }
    }
}

/// Whether a numerator or denominator starts with the d of a derivative.
fn starts_with_d(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter('d') => true,
        Layout::Group(items) => items.first().is_some_and(starts_with_d),
        Layout::Scripts { nucleus, .. } => starts_with_d(nucleus),
        _ => false,
    }
}

/// Whether a superscript is a mark and no exponent: a transpose, a conjugate, a prime, degrees.
fn is_mark(sup: &[Item]) -> bool {
    let is_name = |item: &Item| names::printed(item, None).is_some();
    match sup {
        [only] => matches!(only.layout, Layout::Command(_) | Layout::Other('*')) && !is_name(only),
        _ => false,
    }
}

/// The number that an argument is, and where it stands.
fn number_of(item: &Item) -> Option<(&str, Span)> {
    match &item.layout {
        Layout::Number(digits) => Some((digits, item.span)),
        Layout::Group(items) => match items.as_slice() {
            [only] => number_of(only),
            _ => None,
        },
        _ => None,
    }
}

/// The bytes of a name without its power.
fn own_span(item: &Item) -> Span {
    match &item.layout {
        Layout::Scripts { nucleus, sub, sup: Some(_), primes: 0 } => match sub {
            Some(sub) => nucleus.span.to(sub.span),
            None => nucleus.span,
        },
        _ => item.span,
    }
}

/// The base of a name with scripts.
fn nucleus(item: &Item) -> &Item {
    match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    }
}

/// The LaTeX of a symbol with these indices and dots.
pub(super) fn spelled(entry: &Entry, indices: &[Index], dots: u8, symbols: &crate::formula::Symbols) -> Option<String> {
    let mut name = entry.name.clone();
    for ((at, _), index) in entry.slots.iter().zip(indices) {
        name.subscript[*at] = match index {
            Index::Letter(letter) => symbols.indices[letter.0].letter.clone(),
            Index::Fixed(value) => value.to_string(),
        };
    }
    names::with_dots(&name, dots).map(|name| name.to_string())
}
