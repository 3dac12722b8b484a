//! How names stand in a display without declarations: as a factor, or with a power before a letter in parentheses.
//!
//! A letter that is a factor in one place is no function in another, unless a lone name or a list stands in the parenthesis.

use std::collections::HashSet;

use crate::formula::symbols::Name;
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents, latex};
use super::super::super::names::{self, Printed};
use super::super::super::rows::relation;
use super::super::items::{differential, function_head, joint, whole_number};

/// Fields that are taken at two places in one formula.
const SHIFTED: [&str; 9] = ["u", "w", "f", "V", "U", "G", "\\psi", "\\phi", "\\varphi"];

/// What a display shows about its names.
#[derive(Default)]
pub(in super::super::super) struct Uses {
    /// Names that are a factor or a term without a parenthesis after them.
    bare: HashSet<Name>,
    /// Names before a lone name, a 0 or a list in parentheses, or with a dot: what they are shows.
    sure: HashSet<Name>,
    /// The names in a list of several arguments.
    arguments: HashSet<Name>,
    /// Names with a power before a lone name in parentheses, `\lambda^2(t)`.
    powers: Vec<(Name, Span)>,
    /// The letters that stand above as `1 - x`, or above a number.
    pub(in super::super::super) exponents: HashSet<String>,
    /// The names with a dot.
    dotted: HashSet<Name>,
    /// Names of fields before a sum of two letters, and whether its sign is a minus: `u(x - a)`.
    shifted: Vec<(Name, [Name; 2], bool)>,
    /// The two names of a quotient in which both have the same parenthesis after them, `\frac{V(-l)}{I(-l)}`.
    quotients: Vec<Name>,
    /// The place of a g before a sum of which nothing says that it is a height or a mass.
    unclear_g: Option<Span>,
}

/// What some items show.
pub(in super::super::super) fn of(items: &[Item]) -> Uses {
    let mut found = Uses::default();
    found.list(items, false);
    found
}

impl Uses {
    /// The names that are factors, and nowhere functions.
    pub(in super::super::super) fn factors(&self) -> HashSet<Name> {
        self.bare.difference(&self.sure).cloned().collect()
    }

    /// The names that nobody takes for factors: a field at two places that differ in a sign, `u(x - a) + u(x + a)`, and both parts of a
    /// quotient that would have a common factor.
    pub(in super::super::super) fn functions(&self) -> Vec<Name> {
        let has_twin = |(name, letters, is_minus): &&(Name, [Name; 2], bool)| {
            self.shifted.contains(&(name.clone(), letters.clone(), !is_minus))
        };
        let names = self.shifted.iter().filter(has_twin).map(|(name, _, _)| name.clone());
        names.chain(self.quotients.iter().cloned()).filter(|name| !self.bare.contains(name)).collect()
    }

    /// Whether a letter has a dot somewhere.
    pub(in super::super::super) fn has_dot(&self, letter: &str) -> bool {
        self.dotted.contains(&Name::plain(letter))
    }

    /// Why a parenthesis after a name may be an argument as well as a factor.
    pub(in super::super::super) fn unclear(&self) -> Option<Fault> {
        let is_no_function =
            |name: &Name| !self.sure.contains(name) && (self.bare.contains(name) || self.arguments.contains(name));
        if let Some((name, span)) = self.powers.iter().find(|(name, _)| is_no_function(name)) {
            let what = format!("a parenthesis after a power of {name} may be an argument or a factor");
            return Some(
                Fault::ambiguous(*span, what)
                    .help("for a product, remove the parentheses; for a function, put the power after them, f(x)^2"),
            );
        }
        let g = Name::plain("g");
        let span = self.unclear_g.filter(|_| !self.sure.contains(&g) && !self.bare.contains(&g))?;
        Some(Fault::ambiguous(span, "g(…) may be a function or a product").help(
            "for a product, put a thin space \\, before the parenthesis; \
             for a function, declare it under \"functions\" in a claims file",
        ))
    }

    /// `is_part` says that even one name alone is a factor: in a fraction and below a root.
    fn list(&mut self, items: &[Item], is_part: bool) {
        for (at, item) in items.iter().enumerate() {
            if let Some(found) = names::printed(item, None) {
                let before = items[..at].iter().rev().find(|item| !is_space(item));
                if found.dots > 0 {
                    self.dotted.insert(found.name.clone());
                }
                match items.get(at + 1).and_then(parenthesis) {
                    Some((fence, inside)) => {
                        // `V = V(x_1 - x_2)`
                        let mut sides = items[..at].iter().rev().filter(|item| !is_space(item));
                        let is_defined = sides.next().is_some_and(|sign| relation(sign).is_some())
                            && sides.next().and_then(lone).is_some_and(|side| side.name == found.name);
                        if is_defined {
                            self.sure.insert(found.name.clone());
                        }
                        self.called(&found, item.span.to(fence.span), before, (fence, inside));
                    }
                    None => {
                        let after = items[at + 1..].iter().find(|item| !is_space(item));
                        self.alone(&found, before, after, is_part);
                    }
                }
            }
            self.inside(item);
        }
    }

    fn called(&mut self, found: &Printed<'_>, span: Span, before: Option<&Item>, (fence, inside): (&Item, &[Item])) {
        let name = Name { primes: 0, ..found.name.clone() };
        let solid: Vec<&Item> = inside.iter().filter(|item| !is_space(item)).collect();
        let is_lone = matches!(solid.as_slice(), [only] if lone(only).is_some() || whole_number(only) == Some(0));
        let is_comma = |item: &&&Item| matches!(item.layout, Layout::Other(',' | ';' | '|'));
        let is_list = solid.iter().any(|item| is_comma(&item));
        let power = found.sup.and_then(whole_number).filter(|power| *power > 1);
        if is_list {
            let listed = solid.split(|item| is_comma(&item)).filter_map(|part| match part {
                [only] => lone(only).filter(|found| found.dots == 0).map(|found| found.name),
                _ => None,
            });
            self.arguments.extend(listed);
        }
        if let [first, sign, second] = solid.as_slice()
            && let (Some(first), Some(second)) = (lone(first), lone(second))
            && matches!(sign.layout, Layout::Other('+' | '-'))
            && SHIFTED.contains(&name.base.as_str())
        {
            let is_minus = sign.layout == Layout::Other('-');
            self.shifted.push((name.clone(), [first.name, second.name], is_minus));
        }
        match power {
            Some(_)
                if is_lone && matches!(fence.layout, Layout::Fence(Delimiter::Round, _)) && name.base != "\\delta" =>
            {
                self.powers.push((name, span));
            }
            _ if is_lone || is_list || found.dots > 0 || found.name.primes > 0 => {
                self.sure.insert(name);
            }
            _ => {
                if found.sup.is_none() && name == Name::plain("g") && is_unclear_sum(before, fence, &solid) {
                    self.unclear_g.get_or_insert(span);
                }
            }
        }
    }

    fn alone(&mut self, found: &Printed<'_>, before: Option<&Item>, after: Option<&Item>, is_part: bool) {
        if found.dots > 0 || found.name.primes > 0 {
            self.sure.insert(Name { primes: 0, ..found.name.clone() });
            return;
        }
        let is_mark = |item: &Item| {
            differential(item).is_some()
                || matches!(&item.layout, Layout::Command(name) if ["\\partial", "\\delta", "\\Delta", "\\nabla"].contains(&name.as_str()))
        };
        let ends = |item: Option<&Item>| {
            item.is_none_or(|item| {
                relation(item).is_some()
                    || matches!(item.layout, Layout::Other(',' | ';' | '|' | '.') | Layout::Row | Layout::Align)
            })
        };
        let is_star = |sup: &Item| {
            contents(sup).iter().any(|item| {
                matches!(item.layout, Layout::Other('*' | '†'))
                    || matches!(&item.layout, Layout::Command(name) if ["\\ast", "\\star", "\\dagger"].contains(&name.as_str()))
            })
        };
        let is_side = ends(before) && ends(after) && !is_part;
        if !is_side && !before.is_some_and(is_mark) && !found.sup.is_some_and(is_star) {
            self.bare.insert(found.name.clone());
        }
    }

    fn inside(&mut self, item: &Item) {
        match &item.layout {
            Layout::Fence(Delimiter::Ket | Delimiter::Bra, _) => {}
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items, false),
            Layout::Fraction(above, below) => {
                let begins = |part: &Item| {
                    contents(part).first().is_some_and(|first| {
                        let nucleus = if let Layout::Scripts { nucleus, .. } = &first.layout { nucleus } else { first };
                        differential(first).is_some() || nucleus.layout == Layout::Command("\\partial".to_owned())
                    })
                };
                if let ([first, place], [second, other]) = (contents(above), contents(below))
                    && let (Some(first), Some(second)) = (lone(first), lone(second))
                    && let (Some((_, place)), Some((_, other))) = (parenthesis(place), parenthesis(other))
                    && first.name != second.name
                    && latex(place) == latex(other)
                {
                    self.quotients.extend([first.name, second.name]);
                }
                if !begins(below) {
                    self.list(contents(above), true);
                    self.list(contents(below), true);
                }
            }
            Layout::Root(_, inner) => self.list(contents(inner), true),
            Layout::Scripts { nucleus, sup, .. } => {
                if names::printed(nucleus, None).is_none() {
                    self.inside(nucleus);
                }
                if let Some(sup) = sup {
                    self.exponents.extend(rest_of_one(sup));
                    if matches!(nucleus.layout, Layout::Number(_)) {
                        self.exponents.extend(lone_exponent(sup));
                    }
                    self.list(contents(sup), false);
                }
            }
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell, false)),
            _ => {}
        }
    }
}

/// Whether a parenthesis after g holds a sum of letters that are places as a rule, and no factor stands before g:
/// `g(a + (b - a)u)`. In `mg(h - x)` and `g(\sin\theta - \mu)` g is the acceleration of a fall.
fn is_unclear_sum(before: Option<&Item>, fence: &Item, solid: &[&Item]) -> bool {
    const PLACES: [&str; 14] = ["a", "b", "c", "x", "y", "z", "s", "t", "u", "U", "X", "Y", "n", "k"];
    let is_plain = matches!(fence.layout, Layout::Fence(Delimiter::Round, _));
    let is_sum = solid.iter().skip(1).any(|item| matches!(item.layout, Layout::Other('+' | '-')));
    let is_factor = |item: &Item| {
        names::printed(item, None).is_some()
            || joint(item).is_some()
            || matches!(item.layout, Layout::Number(_) | Layout::Fraction(..))
    };
    is_plain && is_sum && !before.is_some_and(is_factor) && solid.iter().all(|item| is_of_places(item, &PLACES))
}

fn is_of_places(item: &Item, places: &[&str]) -> bool {
    match &item.layout {
        Layout::Other('+' | '-') | Layout::Space(_) => true,
        Layout::Fence(Delimiter::Round, inside) => inside.iter().all(|item| is_of_places(item, places)),
        _ if matches!(function_head(item), Ok(Some(_))) => false,
        _ => names::printed(item, None)
            .is_some_and(|found| found.dots == 0 && places.contains(&found.name.base.as_str())),
    }
}

/// The x of `1 - x`.
fn rest_of_one(sup: &Item) -> Option<String> {
    let solid: Vec<&Item> = contents(sup).iter().filter(|item| !is_space(item)).collect();
    let [one, minus, letter] = solid.as_slice() else { return None };
    let is_rest = whole_number(one) == Some(1) && minus.layout == Layout::Other('-');
    lone(letter).filter(|found| is_rest && found.name.subscript.is_empty()).map(|found| found.name.base)
}

/// The a of `6^{-a}`: an exponent of a number. i and j count too often.
fn lone_exponent(sup: &Item) -> Option<String> {
    let solid: Vec<&Item> = contents(sup).iter().filter(|item| !is_space(item)).collect();
    let letter = match solid.as_slice() {
        [minus, letter] if minus.layout == Layout::Other('-') => letter,
        [letter] => letter,
        _ => return None,
    };
    let found = lone(letter).filter(|found| found.name.subscript.is_empty())?;
    // The o of `90^o` is a degree.
    matches!(found.name.base.as_bytes(), [b'a'..=b'h' | b'k'..=b'n' | b'p'..=b'z']).then_some(found.name.base)
}

fn is_space(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(_))
}

/// A parenthesis, with a script perhaps, and what is in it.
fn parenthesis(item: &Item) -> Option<(&Item, &[Item])> {
    let fence = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    match &fence.layout {
        Layout::Fence(Delimiter::Round | Delimiter::Square, inside) => Some((item, inside)),
        _ => None,
    }
}

/// A name without a power.
fn lone(item: &Item) -> Option<Printed<'_>> {
    names::printed(item, None).filter(|found| found.sup.is_none())
}
