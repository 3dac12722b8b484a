//! The places where units stand: after a number, after a closed group of numbers, in a fraction of such quantities.

use crate::formula::units::Unit;
use crate::source::{Fault, Span};

use super::super::super::lexer::Space;
use super::super::item::{Delimiter, Item, Layout, Units};
use super::exponent;

/// The same items, in which words that spell units are units where these can stand, and words elsewhere.
pub(in super::super) fn settled(items: Vec<Item>) -> Vec<Item> {
    if !items.iter().any(may_have_units) {
        return items;
    }
    let is_electric = |unit: &Unit| unit.exponents()[3] != 0;
    let settler = Settler { electric: any_unit(&items, &is_electric) };
    settler.list(&items, false)
}

/// The formulas inside an item.
fn inside(item: &Item) -> Vec<&Item> {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => items.iter().collect(),
        Layout::Fraction(a, b) => vec![a, b],
        Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => vec![a],
        Layout::Scripts { nucleus, sub, sup, .. } => {
            [Some(nucleus), sub.as_ref(), sup.as_ref()].into_iter().flatten().map(|part| &**part).collect()
        }
        Layout::Environment(_, rows) => rows.iter().flatten().flatten().collect(),
        _ => Vec::new(),
    }
}

fn may_have_units(item: &Item) -> bool {
    let is_ohm = matches!(&item.layout, Layout::Command(name) if name == "\\Omega");
    matches!(item.layout, Layout::Unit(_))
        || is_ohm
        || sign(item).is_some()
        || is_circle(item)
        || inside(item).into_iter().any(may_have_units)
}

fn any_unit(items: &[Item], is_it: &dyn Fn(&Unit) -> bool) -> bool {
    items.iter().any(|item| match &item.layout {
        Layout::Unit(units) => units.factors.iter().any(|(unit, _)| is_it(unit)),
        _ => inside(item).into_iter().any(|part| any_unit(std::slice::from_ref(part), is_it)),
    })
}

/// The unit that a sign is: `\%`, `°`.
fn sign(item: &Item) -> Option<Unit> {
    match &item.layout {
        Layout::Other('°') => Unit::degree(),
        Layout::Command(name) => match name.as_str() {
            "\\%" => Unit::named("%"),
            "\\degree" | "\\textdegree" => Unit::degree(),
            _ => None,
        },
        _ => None,
    }
}

/// The circle of a degree, `^\circ`.
fn is_circle(item: &Item) -> bool {
    let is_one = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\circ");
    match &item.layout {
        Layout::Group(items) => matches!(items.as_slice(), [only] if is_one(only)),
        _ => is_one(item),
    }
}

fn is_thin(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(Space::Thin))
}

fn is_times(item: &Item) -> bool {
    matches!(item.layout, Layout::Other('·' | '⋅')) || matches!(&item.layout, Layout::Command(name) if name == "\\cdot")
}

/// Whether an item is a number, or numbers that are enclosed.
fn is_quantity(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(_) => true,
        Layout::Scripts { nucleus, sub: None, primes: 0, .. } => is_quantity(nucleus),
        Layout::Fence(Delimiter::Round | Delimiter::Square, items) | Layout::Group(items) => is_closed(items),
        Layout::Fraction(a, b) => is_quantity(a) && is_quantity(b),
        Layout::Root(_, a) => is_quantity(a),
        Layout::Command(name) => name == "\\pi",
        _ => false,
    }
}

/// `10^{-3}`, behind which an upright letter is no name: `10^{-3}\mathrm{m}`.
fn is_power_of_ten(item: &Item) -> bool {
    matches!(&item.layout, Layout::Scripts { nucleus, sub: None, sup: Some(_), primes: 0 }
        if nucleus.layout == Layout::Number("10".to_owned()))
}

/// Whether items are numbers and units, joined by signs.
fn is_closed(items: &[Item]) -> bool {
    let joins = |item: &Item| match &item.layout {
        Layout::Unit(_) | Layout::Space(Space::Thin) => true,
        Layout::Other(c) => "+-·⋅×/".contains(*c),
        Layout::Command(name) => ["\\cdot", "\\times", "\\pm"].contains(&name.as_str()),
        _ => false,
    };
    items.iter().any(is_quantity) && items.iter().all(|item| is_quantity(item) || joins(item))
}

/// Whether a quantity has a unit.
fn has_unit(item: &Item) -> bool {
    any_unit(std::slice::from_ref(item), &|_| true)
}

/// An item without units in it.
fn reverted(item: &Item) -> Item {
    let boxed = |item: &Item| Box::new(reverted(item));
    let all = |items: &[Item]| items.iter().map(reverted).collect::<Vec<Item>>();
    let layout = match &item.layout {
        Layout::Unit(units) => return units.plain.first().map_or_else(|| item.clone(), Item::clone),
        Layout::Group(items) => Layout::Group(all(items)),
        Layout::Fence(delimiter, items) => Layout::Fence(*delimiter, all(items)),
        Layout::Fraction(a, b) => Layout::Fraction(boxed(a), boxed(b)),
        Layout::Root(index, a) => Layout::Root(index.clone(), boxed(a)),
        Layout::Accent(name, a) => Layout::Accent(name.clone(), boxed(a)),
        Layout::Style(name, a) => Layout::Style(name.clone(), boxed(a)),
        Layout::Scripts { nucleus, sub, sup, primes } => Layout::Scripts {
            nucleus: boxed(nucleus),
            sub: sub.as_deref().map(boxed),
            sup: sup.as_deref().map(boxed),
            primes: *primes,
        },
        Layout::Environment(name, rows) => {
            let cells = |row: &Vec<Vec<Item>>| row.iter().map(|cell| all(cell)).collect();
            Layout::Environment(name.clone(), rows.iter().map(cells).collect())
        }
        other => other.clone(),
    };
    Item { layout, span: item.span }
}

struct Settler {
    /// Whether the display has another unit of electricity, so that `20\,\Omega` is a resistance.
    electric: bool,
}

impl Settler {
    fn list(&self, items: &[Item], mut follows_quantity: bool) -> Vec<Item> {
        let mut out: Vec<Item> = Vec::with_capacity(items.len());
        let mut at = 0;
        while at < items.len() {
            // `25°C`
            if follows_quantity && sign(&items[at]).is_some_and(|unit| unit.is_degree()) {
                let after = items[at + 1..].iter().find(|item| !is_thin(item));
                if after.is_some_and(is_scale) {
                    out.push(of_a_scale(items[at].span));
                    at += 1;
                    continue;
                }
            }
            if follows_quantity
                && let Some((units, next)) = self.run(items, at, false)
                && !is_applied(&items[next..])
            {
                at = next;
                attach(&mut out, units);
                follows_quantity = false;
                continue;
            }
            let item = self.inner(&items[at], items.get(at + 1));
            if !is_thin(&item) {
                follows_quantity = is_quantity(&item);
            }
            out.push(item);
            at += 1;
        }
        out
    }

    fn one(&self, item: &Item, follows_quantity: bool) -> Item {
        match &item.layout {
            Layout::Group(items) => Item { layout: Layout::Group(self.list(items, follows_quantity)), span: item.span },
            _ => match self.list(std::slice::from_ref(item), follows_quantity).as_slice() {
                [only] => only.clone(),
                all => Item { layout: Layout::Group(all.to_vec()), span: item.span },
            },
        }
    }

    /// An item with the units in it.
    fn inner(&self, item: &Item, next: Option<&Item>) -> Item {
        let boxed = |item: &Item| Box::new(self.one(item, false));
        let layout = match &item.layout {
            Layout::Unit(_) => return reverted(item),
            Layout::Group(items) => Layout::Group(self.list(items, false)),
            Layout::Fence(delimiter, items) => Layout::Fence(*delimiter, self.list(items, false)),
            Layout::Fraction(above, below) => {
                let above = self.one(above, false);
                let below = self.one(below, is_quantity(&above));
                Layout::Fraction(Box::new(above), Box::new(below))
            }
            Layout::Root(index, radicand) => Layout::Root(index.clone(), boxed(radicand)),
            Layout::Accent(name, under) => Layout::Accent(name.clone(), boxed(under)),
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
                if is_circle(sup) && is_quantity(nucleus) =>
            {
                return degrees(item, nucleus, sup, next);
            }
            // `25\,^\circ\text{C}`: the circle stands on the space.
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
                if is_circle(sup) && is_thin(nucleus) && next.is_some_and(is_scale) =>
            {
                return of_a_scale(item.span);
            }
            Layout::Scripts { nucleus, sub, sup, primes } => Layout::Scripts {
                nucleus: boxed(nucleus),
                sub: sub.as_deref().map(|sub| Box::new(reverted(sub))),
                sup: sup.as_deref().map(boxed),
                primes: *primes,
            },
            Layout::Environment(name, rows) => {
                let cells = |row: &Vec<Vec<Item>>| row.iter().map(|cell| self.list(cell, false)).collect();
                Layout::Environment(name.clone(), rows.iter().map(cells).collect())
            }
            other => other.clone(),
        };
        Item { layout, span: item.span }
    }

    /// The units that begin at a place, perhaps after thin spaces or with a slash, and where they end. `is_alone` says that
    /// nothing but units may stand there.
    fn run(&self, items: &[Item], from: usize, is_alone: bool) -> Option<(Units, usize)> {
        let mut found = Units::none();
        let mut end = from;
        loop {
            let mut at = end + items[end..].iter().take_while(|item| is_thin(item)).count();
            let is_apart =
                is_alone || at > end || from > 0 && (is_thin(&items[from - 1]) || is_power_of_ten(&items[from - 1]));
            let mut by_slash = false;
            match items.get(at).map(|item| &item.layout) {
                Some(Layout::Other('/')) => {
                    by_slash = true;
                    at += 1;
                }
                Some(_) if !found.factors.is_empty() && is_times(&items[at]) => at += 1,
                _ => {}
            }
            at += items[at..].iter().take_while(|item| is_thin(item)).count();
            let next = match items.get(at).map(|item| &item.layout) {
                Some(Layout::Fence(Delimiter::Round, inner)) if by_slash => {
                    self.whole(inner).map(|units| (Units { divides: false, ..units }, at + 1))
                }
                _ => self.element(items, at),
            };
            // One upright letter that touches a number may be a name: `2\mathrm{K}`.
            let next = next.filter(|(units, _)| !units.is_letter || is_apart || by_slash || !found.factors.is_empty());
            let Some((units, next)) = next else { break };
            let span = items[from].span.to(items[next - 1].span);
            found.join(units, by_slash, span);
            end = next;
        }
        if found.factors.is_empty() {
            return None;
        }
        found.plain = items[from..end].iter().map(reverted).collect();
        Some((found, end))
    }

    /// The units that are all of some items.
    fn whole(&self, items: &[Item]) -> Option<Units> {
        let (units, end) = self.run(items, 0, true)?;
        items[end..].iter().all(is_thin).then_some(units)
    }

    /// One word of units with its power, a fraction of units, `\mu\mathrm{F}`, `\text{k}\Omega`; and where it ends.
    fn element(&self, items: &[Item], at: usize) -> Option<(Units, usize)> {
        let item = items.get(at)?;
        let (nucleus, sup) = match &item.layout {
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => (&**nucleus, Some(sup)),
            _ => (item, None),
        };
        let units = match &nucleus.layout {
            Layout::Unit(units) => Some(units.clone()),
            Layout::Group(inner) => self.whole(inner),
            Layout::Fraction(above, below) => self.fraction(above, below),
            Layout::Command(name)
                if name == "\\Omega"
                    && (self.electric || is_before_a_unit(&items[at + 1..]))
                    && at > 0
                    && is_thin(&items[at - 1]) =>
            {
                one(Unit::named("Ω")?)
            }
            _ => sign(nucleus).and_then(one),
        };
        if let Some(mut units) = units {
            if let Some(sup) = sup {
                units.raise(exponent(sup)?, item.span);
            }
            return Some((units, at + 1));
        }
        let prefix = prefix(item)?;
        let next = items.get(at + 1).filter(|next| next.span.start == item.span.end)?;
        let (nucleus, sup) = match &next.layout {
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => (&**nucleus, Some(sup)),
            _ => (next, None),
        };
        let mut units = match &nucleus.layout {
            Layout::Command(name) if name == "\\Omega" && prefix != "µ" => one(Unit::named(&format!("{prefix}Ω"))?)?,
            Layout::Unit(units) if prefix == "µ" => {
                let mut units = units.clone();
                let (first, _) = units.factors.first_mut()?;
                *first = Unit::named(&format!("µ{}", first.symbol()))?;
                units
            }
            _ => return None,
        };
        if let Some(sup) = sup {
            units.raise(exponent(sup)?, next.span);
        }
        units.is_letter = false;
        Some((units, at + 2))
    }

    fn fraction(&self, above: &Item, below: &Item) -> Option<Units> {
        let contents = |item: &Item| match &item.layout {
            Layout::Group(items) => items.clone(),
            _ => vec![item.clone()],
        };
        let is_one =
            matches!(contents(above).as_slice(), [Item { layout: Layout::Number(digits), .. }] if digits == "1");
        let mut found = match is_one {
            true => Units::none(),
            false => Units { divides: false, ..self.whole(&contents(above))? },
        };
        let below = Units { divides: false, ..self.whole(&contents(below))? };
        found.join(below, true, above.span);
        found.divides = false;
        Some(found)
    }
}

/// Whether an upright unit follows, after a space or a dot perhaps: `\Omega\,\mathrm{m}` is an ohm metre.
fn is_before_a_unit(rest: &[Item]) -> bool {
    let next = rest.iter().find(|item| !is_thin(item) && !is_times(item));
    next.is_some_and(|next| matches!(next.layout, Layout::Unit(_)))
}

fn one(unit: Unit) -> Option<Units> {
    Some(Units { factors: vec![(unit, 1)], ..Units::none() })
}

/// The prefix that an upright letter, or `\mu`, is.
fn prefix(item: &Item) -> Option<String> {
    match &item.layout {
        Layout::Command(name) if name == "\\mu" => Some("µ".to_owned()),
        Layout::Other('µ') => Some("µ".to_owned()),
        Layout::Text(word) => Some(word.clone()),
        Layout::Unit(units) => units.plain.first().and_then(prefix),
        Layout::Style(style, inner) if style == "\\mathrm" => match &inner.layout {
            Layout::Letter(c) => Some(c.to_string()),
            Layout::Group(items) => match items.as_slice() {
                [Item { layout: Layout::Letter(c), .. }] => Some(c.to_string()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

/// Whether a parenthesis with more than numbers follows at once, as after the name of a function.
fn is_applied(rest: &[Item]) -> bool {
    rest.first().is_some_and(|next| match &next.layout {
        Layout::Fence(_, items) => !is_closed(items),
        _ => false,
    })
}

/// Whether an item is the letter of a scale of temperature.
fn is_scale(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter(c) => "CFRK".contains(*c),
        Layout::Unit(units) => {
            units.plain.first().is_some_and(|plain| letter_of(plain).is_some_and(|c| "CFRK".contains(c)))
        }
        _ => letter_of(item).is_some_and(|c| "CFRK".contains(c)),
    }
}

/// A temperature in degrees.
fn of_a_scale(span: Span) -> Item {
    let message = "a temperature in degrees is not supported, because its zero is not that of the kelvin";
    let fault = Fault::unsupported(span, message).help("write the temperature in kelvin, \\text{K}");
    Item { layout: Layout::Fault(fault), span }
}

/// A number in degrees. Degrees of a temperature are another scale.
fn degrees(whole: &Item, number: &Item, circle: &Item, next: Option<&Item>) -> Item {
    if next.is_some_and(is_scale) {
        return of_a_scale(whole.span);
    }
    let Some(mut units) = Unit::degree().and_then(one) else { return whole.clone() };
    units.plain = vec![circle.clone()];
    let unit = Item { layout: Layout::Unit(units), span: circle.span };
    Item { layout: Layout::Group(vec![number.clone(), unit]), span: whole.span }
}

/// The one letter of an upright word.
fn letter_of(item: &Item) -> Option<char> {
    match &item.layout {
        Layout::Text(word) => word.chars().next().filter(|_| word.chars().count() == 1),
        _ => prefix(item)?.chars().next(),
    }
}

/// Puts units after the number before them. After a slash that stands behind a unit, both are one factor:
/// `10\,\text{m}/2\,\text{s}`. So are a number and its sign, as in `\sin 30°`.
fn attach(out: &mut Vec<Item>, mut units: Units) {
    let span = match (units.plain.first(), units.plain.last()) {
        (Some(first), Some(last)) => first.span.to(last.span),
        _ => Span::default(),
    };
    let is_sign = matches!(units.factors.as_slice(), [(unit, 1)] if unit.is_degree());
    let significant: Vec<usize> = (0..out.len()).filter(|at| !is_thin(&out[*at])).collect();
    if let [.., before, number] = significant.as_slice()
        && matches!(out[*before].layout, Layout::Unit(_))
    {
        let place = out[*number].span.to(span);
        units.fault = Some(
            Fault::ambiguous(place, "two quantities side by side, as in 5 min 30 s, may be a sum or a product")
                .help("write + or \\cdot between them"),
        );
    }
    let unit = Item { layout: Layout::Unit(units), span };
    let is_divided = matches!(significant.as_slice(), [.., before, slash, _]
        if out[*slash].layout == Layout::Other('/') && has_unit(&out[*before]));
    match significant.last() {
        Some(number) if is_divided || is_sign => {
            let span = out[*number].span.to(span);
            let mut inner = out.split_off(*number);
            inner.push(unit);
            out.push(Item { layout: Layout::Group(inner), span });
        }
        _ => out.push(unit),
    }
}
