//! Primes that mark another quantity: x′ in another frame, v₁′ after a collision, L′ beside L.
//!
//! A prime is a derivative as often, so each rule needs evidence that no derivative explains:
//!
//! | evidence | names with a prime |
//! | --- | --- |
//! | t′, the time itself has a prime; or x′^μ, an index of space and time | all |
//! | γ before a parenthesis with a sum, as in `\gamma(x - vt)` | all |
//! | two of them, beside a sine and a cosine: a rotation | all |
//! | L, H and calligraphic letters; λ, ν; a velocity, a momentum or an energy with a number below, at least two | these |
//!
//! Two primes anywhere are derivatives, and then nothing is inferred.

use crate::formula::symbols::Name;

use super::layout::{Delimiter, Item, Layout};
use super::names;

/// The names, without their primes, that stand with a prime for another quantity.
pub(super) fn letters(items: &[Item]) -> Vec<Name> {
    let mut found = Found::default();
    found.list(items);
    if found.has_second || found.primed.is_empty() {
        return Vec::new();
    }
    let unprimed = |name: &Name| Name { primes: 0, ..name.clone() };
    let is_rotation = found.primed.len() > 1 && found.has_sine && found.has_cosine;
    if found.has_time || found.has_index || found.has_lorentz || is_rotation {
        return found.primed.iter().map(unprimed).collect();
    }
    let of_particles: Vec<&Name> = found.primed.iter().filter(|name| is_of_a_particle(name)).collect();
    let several = of_particles.len() > 1;
    found.primed.iter().filter(|name| is_usual(name) || several && is_of_a_particle(name)).map(unprimed).collect()
}

/// A velocity, a momentum or an energy with a number below it, `v_1'`.
fn is_of_a_particle(name: &Name) -> bool {
    let is_number = |part: &String| part.chars().all(|c| c.is_ascii_digit());
    ["v", "u", "p", "P", "E"].contains(&name.base.as_str())
        && name.subscript.len() == 1
        && name.subscript.iter().all(is_number)
}

/// A quantity that nobody differentiates with a prime.
fn is_usual(name: &Name) -> bool {
    ["L", "H", "\\lambda", "\\nu"].contains(&name.base.as_str()) || name.base.starts_with("\\mathcal{")
}

#[derive(Default)]
struct Found {
    primed: Vec<Name>,
    has_second: bool,
    has_time: bool,
    has_index: bool,
    has_lorentz: bool,
    has_sine: bool,
    has_cosine: bool,
}

impl Found {
    fn list(&mut self, items: &[Item]) {
        for (at, item) in items.iter().enumerate() {
            let next = items[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
            self.one(item, next);
        }
    }

    fn one(&mut self, item: &Item, next: Option<&Item>) {
        if let Some(printed) = names::printed(item, None) {
            let name = printed.name;
            let is_sum =
                |inside: &[Item]| inside.iter().skip(1).any(|item| matches!(item.layout, Layout::Other('+' | '-')));
            self.has_lorentz |= name.base == "\\gamma"
                && matches!(next, Some(Item { layout: Layout::Fence(Delimiter::Round | Delimiter::Square, inside), .. })
                    if is_sum(inside));
            self.has_second |= name.primes > 1;
            if name.primes == 1 {
                self.has_time |= ["t", "\\Delta t"].contains(&name.base.as_str());
                self.has_index |= printed.sup.is_some_and(is_greek);
                if !self.primed.contains(&name) {
                    self.primed.push(name);
                }
            }
        }
        match &item.layout {
            Layout::Command(name) => {
                self.has_sine |= name == "\\sin" || name == "\\sinh";
                self.has_cosine |= name == "\\cos" || name == "\\cosh";
            }
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items),
            Layout::Fraction(a, b) => {
                self.list(super::reader::items::contents(a));
                self.list(super::reader::items::contents(b));
            }
            Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => {
                self.list(super::reader::items::contents(a));
            }
            Layout::Scripts { nucleus, sup, .. } => {
                if names::printed(item, None).is_none() {
                    self.one(nucleus, None);
                }
                if let Some(sup) = sup {
                    self.list(super::reader::items::contents(sup));
                }
            }
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell)),
            _ => {}
        }
    }
}

/// μ or ν above a letter.
fn is_greek(sup: &Item) -> bool {
    matches!(super::reader::items::contents(sup),
        [Item { layout: Layout::Command(name), .. }] if name == "\\mu" || name == "\\nu")
}
