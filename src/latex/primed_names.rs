//! Primes that mark another quantity: x′ in another frame, v₁′ after a collision, L′ beside L.
//!
//! A prime is a derivative as often, so each rule needs evidence that no derivative explains:
//!
//! | evidence | names with a prime |
//! | --- | --- |
//! | t′, the time itself has a prime; or x′^μ, an index of space and time | all |
//! | γ before a parenthesis with a sum, as in `\gamma(x - vt)`; Λ before a letter | all |
//! | a place that a product with the time is taken from, `x' = x - vt`; a bold letter with a prime and an index | all |
//! | an energy that is its unprimed one and more, `U' = U + ma x` | these |
//! | two of them, beside a sine and a cosine: a rotation | all |
//! | dots on a name with a prime, `\ddot y'`: the dots are the derivatives | all |
//! | two fractions whose denominators differ by the prime alone, `\frac1s + \frac1{s'} = \frac1f`, and whose numerators have neither name | all |
//! | a list in parentheses of names that all have primes, beside the same list without them, `Y(\theta', \phi')`, `Y(\theta, \phi)` | all |
//! | two of them in one product, which stands without primes too: `I\omega = I'\omega'` | all |
//! | ℓ, l, ω; a bold letter; under a bar, as the mean of a fluctuation | these |
//! | L, H and calligraphic letters; λ, ν; a velocity, a momentum or an energy with a number below, at least two | these |
//!
//! Two primes anywhere are derivatives, and then nothing is inferred.

use crate::formula::symbols::Name;

use super::layout::{Delimiter, Item, Layout, contents, latex};
use super::lexer::Space;
use super::names::{self, Printed};
use super::rows::relation;

/// Speeds of one frame in another.
const SPEEDS: [&str; 5] = ["v", "u", "V", "w", "\\beta"];

/// Energies, whose change is no derivative.
const ENERGIES: [&str; 6] = ["U", "T", "E", "K", "W", "Q"];

/// The names, without their primes, that stand with a prime for another quantity.
pub(super) fn letters(items: &[Item]) -> Vec<Name> {
    let mut found = Found::default();
    found.list(items);
    if found.has_second || found.primed.is_empty() {
        return Vec::new();
    }
    let unprimed = |name: &Name| Name { primes: 0, ..name.clone() };
    let is_rotation = found.primed.len() > 1 && found.has_sine && found.has_cosine;
    let is_twofold = found.has_twofold_product();
    if found.has_time
        || found.has_index
        || found.has_lorentz
        || found.has_frame
        || found.has_rate
        || is_rotation
        || is_twofold
        || found.has_conjugate()
        || found.has_other_place()
    {
        return found.primed.iter().map(unprimed).collect();
    }
    let of_particles: Vec<&Name> = found.primed.iter().filter(|name| is_of_a_particle(name)).collect();
    let several = of_particles.len() > 1;
    let is_other = |name: &&Name| {
        is_usual(name)
            || several && is_of_a_particle(name)
            || found.shifted.contains(name)
            || found.averaged.contains(name)
    };
    found.primed.iter().filter(is_other).map(unprimed).collect()
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
    ["L", "H", "\\lambda", "\\nu", "\\omega", "\\ell", "l"].contains(&name.base.as_str())
        || ["\\mathcal{", "\\mathbf{k", "\\mathbf{q", "\\mathbf{p"].iter().any(|style| name.base.starts_with(style))
}

#[derive(Default)]
struct Found {
    primed: Vec<Name>,
    has_second: bool,
    has_time: bool,
    has_index: bool,
    has_lorentz: bool,
    /// Whether a place is seen from another frame, or a vector has a prime and an index.
    has_frame: bool,
    /// Energies that are equal to a sum with the unprimed one in it.
    shifted: Vec<Name>,
    /// Names under a bar: what varies about a mean.
    averaged: Vec<Name>,
    has_sine: bool,
    has_cosine: bool,
    /// Whether dots stand on a name with a prime.
    has_rate: bool,
    /// The names in each term of a statement, with their primes.
    terms: Vec<Vec<Name>>,
    /// The names in each numerator, and the denominator below it.
    fractions: Vec<(Vec<Name>, Item)>,
    /// The names of each list in round parentheses.
    lists: Vec<Vec<Name>>,
}

impl Found {
    /// Whether a term has two names with a prime which stand without it too, and no term has both kinds: derivatives stand beside what
    /// they are taken of, as in (uv)′ = u′v + uv′.
    fn has_twofold_product(&self) -> bool {
        let is_known = |name: &Name| {
            let plain = Name { primes: 0, ..name.clone() };
            self.terms.iter().any(|term| term.contains(&plain))
        };
        let plain: Vec<Name> = self.primed.iter().map(|name| Name { primes: 0, ..name.clone() }).collect();
        let primes = |term: &[Name]| term.iter().filter(|name| name.primes == 1).count();
        let is_mixed = |term: &[Name]| primes(term) > 0 && term.iter().any(|name| plain.contains(name));
        self.terms.iter().any(|term| primes(term) > 1)
            && self.primed.iter().all(is_known)
            && !self.terms.iter().any(|term| is_mixed(term))
    }

    /// Whether two denominators differ by one prime alone: an object and its image. A quotient `y'/y` and one in which the
    /// numerators have primes may be made of derivatives; only an index of refraction has a prime above its own distance, `n'/s'`.
    fn has_conjugate(&self) -> bool {
        let printed = |item: &Item| latex(contents(item));
        self.fractions.iter().any(|(above, below)| {
            let names = names_of(&contents(below).iter().collect::<Vec<_>>());
            let [primed] = names.iter().filter(|name| name.primes > 0).collect::<Vec<_>>()[..] else { return false };
            let plain = Name { primes: 0, ..primed.clone() };
            let without = printed(below).replace('\'', "").replace("^{}", "");
            let is_free = |names: &[Name]| {
                !names.iter().any(|name| Name { primes: 0, ..name.clone() } == plain)
                    && names.iter().all(|name| name.primes == 0 || name.base == "n")
            };
            !names.contains(&plain)
                && is_free(above)
                && self.fractions.iter().any(|(other, twin)| printed(twin) == without && is_free(other))
        })
    }

    /// Whether a function is taken at a place and at the same one with primes.
    fn has_other_place(&self) -> bool {
        let plain =
            |list: &[Name]| -> Vec<Name> { list.iter().map(|name| Name { primes: 0, ..name.clone() }).collect() };
        self.lists.iter().any(|list| list.iter().all(|name| name.primes == 1) && self.lists.contains(&plain(list)))
    }

    fn list(&mut self, items: &[Item]) {
        self.statements(items);
        for (at, item) in items.iter().enumerate() {
            let next = items[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
            self.one(item, next);
        }
    }

    /// A primed name alone before a relation, after which the unprimed name stands as a term.
    fn statements(&mut self, items: &[Item]) {
        let ends =
            |item: &Item| matches!(item.layout, Layout::Row | Layout::Other(',' | ';') | Layout::Space(Space::Wide));
        let is_blank = |item: &&Item| !matches!(item.layout, Layout::Space(_) | Layout::Align | Layout::Other('.'));
        for statement in items.split(ends) {
            let solid: Vec<&Item> = statement.iter().filter(is_blank).collect();
            let is_sign = |item: &&Item| matches!(item.layout, Layout::Other('+' | '-')) || relation(item).is_some();
            self.terms.extend(solid.split(is_sign).map(names_of));
            let [first, equal, right @ ..] = solid.as_slice() else { continue };
            let Some(Printed { name, dots: 0, sup: None }) = names::printed(first, None) else { continue };
            // `\vec p = \vec p' + M\vec V`: a vector is seen from another frame.
            let other = Name { primes: 1, ..name.clone() };
            let is_seen = |term: &[&Item]| matches!(term, [only] if names::printed(only, None).is_some_and(|found| found.name == other));
            self.has_frame |= is_vector(&name) && name.primes == 0 && right.split(is_sign).any(is_seen);
            if name.primes != 1 || relation(equal).is_none() {
                continue;
            }
            let plain = Name { primes: 0, ..name.clone() };
            let terms: Vec<&[&Item]> = right.split(is_sign).collect();
            let named =
                |item: &Item| names::printed(item, None).filter(|found| found.sup.is_none()).map(|found| found.name);
            let is_itself = |term: &&[&Item]| matches!(term, [only] if named(only).is_some_and(|found| found == plain));
            if terms.len() < 2 || !terms.iter().any(is_itself) {
                continue;
            }
            let is_way = |term: &&[&Item]| match term {
                [speed, time] => {
                    let base = |item: &Item| named(item).map(|found| found.base);
                    base(time).as_deref() == Some("t")
                        && base(speed).is_some_and(|base| {
                            SPEEDS.iter().any(|speed| base == *speed || base.ends_with(&format!("{{{speed}}}")))
                        })
                }
                _ => false,
            };
            self.has_frame |= terms.iter().any(is_way);
            if ENERGIES.contains(&name.base.as_str()) {
                self.shifted.push(name);
            }
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
            self.has_frame |= is_vector(&name) && name.primes == 1 && name.subscript.len() == 1;
            // `\Lambda_0{}^\mu F_{\mu\nu}` has an empty group below its upper index.
            let is_index_of_it =
                |next: &Item| matches!(&next.layout, Layout::Scripts { nucleus, .. } if contents(nucleus).is_empty());
            self.has_frame |= name.base == "\\Lambda"
                && next.is_some_and(|next| names::printed(next, None).is_some() || is_index_of_it(next));
            self.has_second |= name.primes > 1;
            if name.primes == 1 {
                self.has_rate |= printed.dots > 0;
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
            Layout::Group(items) | Layout::Fence(_, items) => {
                let parts: Vec<&[Item]> = items.split(|item| item.layout == Layout::Other(',')).collect();
                let name = |part: &[Item]| {
                    let mut solid = part.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
                    let only = solid.next().filter(|_| solid.next().is_none())?;
                    names::printed(only, None).filter(|found| found.sup.is_none()).map(|found| found.name)
                };
                let list: Option<Vec<Name>> = parts.iter().map(|part| name(part)).collect();
                self.lists.extend(list.filter(|list| list.len() > 1));
                self.list(items);
            }
            Layout::Fraction(a, b) => {
                let above = names_of(&contents(a).iter().collect::<Vec<_>>());
                self.fractions.push((above, (**b).clone()));
                self.list(contents(a));
                self.list(contents(b));
            }
            Layout::Accent(bar, a) if bar == "\\overline" || bar == "\\bar" => {
                let inside = contents(a);
                self.list(inside);
                let names = inside.iter().filter_map(|item| names::printed(item, None)).map(|found| found.name);
                self.averaged.extend(names.filter(|name| name.primes == 1));
            }
            Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => {
                self.list(contents(a));
            }
            Layout::Scripts { nucleus, sup, .. } => {
                if names::printed(item, None).is_none() {
                    self.one(nucleus, None);
                }
                // `\left(x'\right)^\mu`
                if let Layout::Fence(Delimiter::Round, inside) = &nucleus.layout
                    && let [only] = inside.as_slice()
                {
                    let is_primed = names::printed(only, None).is_some_and(|found| found.name.primes == 1);
                    self.has_index |= is_primed && sup.as_deref().is_some_and(is_greek);
                }
                if let Some(sup) = sup {
                    self.list(contents(sup));
                }
            }
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell)),
            _ => {}
        }
    }
}

/// μ or ν above a letter.
fn is_greek(sup: &Item) -> bool {
    matches!(contents(sup),
        [Item { layout: Layout::Command(name), .. }] if name == "\\mu" || name == "\\nu")
}

fn is_vector(name: &Name) -> bool {
    ["\\mathbf{", "\\vec{", "\\hat{"].iter().any(|mark| name.base.starts_with(mark))
}

/// The names in a term, those in its fractions, functions and roots too.
fn names_of(term: &[&Item]) -> Vec<Name> {
    let of = |item: &&Item| -> Vec<Name> {
        match names::printed(item, None) {
            Some(found) => vec![found.name],
            None => {
                let inside = crate::latex::layout::parts(item).into_iter();
                inside.flat_map(|part| names_of(&part.iter().collect::<Vec<&Item>>())).collect()
            }
        }
    };
    term.iter().flat_map(of).collect()
}
