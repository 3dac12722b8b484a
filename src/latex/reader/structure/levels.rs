//! Numbers of steps above letters, as in `u_{i,j}^{n+1} = u_{i,j}^n + \Delta t\,f^n`: labels, and no powers.
//!
//! | evidence | what stands above |
//! | --- | --- |
//! | a letter above a name with a place on a grid below it, `u_{i,j}^n`, `u_{i+1}^n` | the number of a step |
//! | the same letter with and without + 1 above one name, beside a step, `\Delta t`, or as a difference divided by one, `(u^{n+1} - u^n)/h` | of all names that have the letter above |
//! | a letter with a number added above a vector or behind ∇, `\mathbf u^{n+1}`, `\nabla u^{n+1}` | the same |
//! | the same without a step, or half of one, `y^{n+1/2}` | may be the number of a step |
//!
//! A letter that is a factor or a term of its own, as in `x^{n+1}/(n + 1)`, is a power, and so are one below a Σ and one
//! above a name that also stands alone.

use std::collections::HashSet;

use crate::formula::symbols::Inferred;

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names;
use super::super::items::{is_big_product, is_big_sum};
use super::super::state::Reader;
use super::super::vector_names::is_vectorial;
use super::printed;

/// Letters that count steps.
const COUNTERS: [char; 8] = ['n', 'k', 'm', 'l', 'j', 'i', 's', 't'];

/// Letters that count places on a grid.
const PLACES: [&str; 7] = ["i", "j", "k", "l", "m", "n", "p"];

/// Records which letters above which names are numbers of steps, and which may be.
pub(in super::super::super) fn note_levels(items: &[Item], inferred: &mut Inferred) {
    let mut found = Found::default();
    found.list(items);
    let counters: HashSet<char> = found.above.iter().map(|above| above.counter).collect();
    for counter in counters.into_iter().filter(|counter| !found.factors.contains(counter)) {
        let all: Vec<&Above> = found.above.iter().filter(|above| above.counter == counter).collect();
        let advances =
            all.iter().any(|one| all.iter().any(|other| other.base == one.base && other.offset != one.offset));
        // `f(t^{n+1/2}, y^n)`: half a step.
        let is_halved = all.len() > 1 && all.iter().any(|one| one.offset.contains(['/', '\\']));
        for above in &all {
            let key = (above.base.clone(), counter);
            if above.is_on_a_grid || found.of_fields.contains(&counter) || advances && found.has_step {
                inferred.levels.insert(key);
            } else if (advances || is_halved) && !found.summed.contains(&counter) && !found.plain.contains(&above.base)
            {
                inferred.possible_levels.insert(key);
            }
        }
    }
}

impl Reader<'_> {
    /// Whether what stands above a name is the number of a step, or may be.
    pub(in super::super) fn is_level(&self, base: &str, sup: &Item) -> bool {
        let inferred = &self.symbols.inferred;
        counted(sup).is_some_and(|(counter, _)| {
            let key = (base.to_owned(), counter);
            inferred.levels.contains(&key) || inferred.possible_levels.contains(&key)
        })
    }

    /// Whether what stands above a name is the number of a step.
    pub(in super::super) fn is_certain_level(&self, base: &str, sup: &Item) -> bool {
        counted(sup).is_some_and(|(counter, _)| self.symbols.inferred.levels.contains(&(base.to_owned(), counter)))
    }
}

/// A counter above a name.
struct Above {
    base: String,
    counter: char,
    /// The number that is added to it, as it is printed.
    offset: String,
    /// Whether a place on a grid stands below the name.
    is_on_a_grid: bool,
}

#[derive(Default)]
struct Found {
    above: Vec<Above>,
    /// Counters that are factors or terms of their own.
    factors: HashSet<char>,
    /// Counters above vectors and behind ∇, with a number added: neither has such a power.
    of_fields: HashSet<char>,
    /// Names without anything above them: `x^{n+1} = x^n x` has powers of x.
    plain: HashSet<String>,
    /// Counters below a Σ or a Π, of which a power is a term of a series.
    summed: HashSet<char>,
    has_step: bool,
}

impl Found {
    fn list(&mut self, items: &[Item]) {
        let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        for (at, item) in solid.iter().enumerate() {
            self.plain
                .extend(names::printed(item, None).filter(|found| found.sup.is_none()).map(|found| found.name.base));
            let is_delta = matches!(&item.layout, Layout::Command(name) if name == "\\Delta");
            self.has_step |= is_delta && solid.get(at + 1).is_some_and(|next| names::printed(next, None).is_some());
            let is_behind_nabla = at > 0 && matches!(&solid[at - 1].layout, Layout::Command(name) if name == "\\nabla");
            if let Some((counter, offset)) = above(item)
                && !offset.is_empty()
                && (is_behind_nabla || base(item).is_some_and(|base| is_vectorial(&base)))
            {
                self.of_fields.insert(counter);
            }
            self.one(item);
        }
    }

    fn one(&mut self, item: &Item) {
        match &item.layout {
            Layout::Letter(letter) if COUNTERS.contains(letter) => {
                self.factors.insert(*letter);
            }
            Layout::Scripts { nucleus, sub: Some(sub), .. } if is_big_sum(nucleus) || is_big_product(nucleus) => {
                let letter = |item: &Item| if let Layout::Letter(letter) = item.layout { Some(letter) } else { None };
                self.summed.extend(contents(sub).iter().filter_map(letter));
            }
            Layout::Scripts { nucleus, sub, sup, primes: 0 } => {
                let found = sup.as_deref().and_then(counted).zip(base(item));
                if let Some(((counter, offset), base)) = found {
                    let is_on_a_grid = sub.as_deref().is_some_and(is_place);
                    self.above.push(Above { base, counter, offset, is_on_a_grid });
                } else if let Some(sup) = sup {
                    self.list(contents(sup));
                }
                match nucleus.layout {
                    Layout::Letter(letter) if found_nothing(sup.as_deref()) && sub.is_none() => {
                        self.factors.extend(COUNTERS.contains(&letter).then_some(letter));
                    }
                    Layout::Letter(_) => {}
                    _ => self.one(nucleus),
                }
            }
            _ => {
                self.has_step |= is_difference_by_a_step(item);
                parts(item).into_iter().for_each(|part| self.list(part));
            }
        }
    }
}

/// What is counted above a name.
fn above(item: &Item) -> Option<(char, String)> {
    let Layout::Scripts { sup: Some(sup), primes: 0, .. } = &item.layout else { return None };
    counted(sup)
}

/// `\frac{u^{n+1} - u^n}{h}`: a difference of one name above a step.
fn is_difference_by_a_step(item: &Item) -> bool {
    const STEPS: [&str; 5] = ["h", "k", "\\tau", "dt", "\\delta t"];
    let Layout::Fraction(numerator, step) = &item.layout else { return false };
    let solid: Vec<&Item> =
        contents(numerator).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let [first, Item { layout: Layout::Other('-'), .. }, second] = solid.as_slice() else { return false };
    let is_difference = base(first).is_some() && base(first) == base(second) && above(first).is_some();
    is_difference && STEPS.contains(&printed(contents(step)).replace("\\mathrm{d}", "d").as_str())
}

/// Whether nothing stands above, or no counter.
fn found_nothing(sup: Option<&Item>) -> bool {
    sup.is_none_or(|sup| counted(sup).is_none())
}

/// The letter of a name with something above it; the e of an exponential, d and ∂ are no names.
fn base(item: &Item) -> Option<String> {
    let Layout::Scripts { nucleus, sup: Some(_), .. } = &item.layout else { return None };
    let base = names::printed(nucleus, None).filter(|found| found.sup.is_none())?.name.base;
    (!["e", "\\mathrm{e}", "d", "\\mathrm{d}"].contains(&base.as_str())).then_some(base)
}

/// A counter, and the number that is added: `n`, `n+1`, `k-\frac12`.
fn counted(sup: &Item) -> Option<(char, String)> {
    let solid: Vec<&Item> = contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_figure = |item: &Item| matches!(item.layout, Layout::Number(_) | Layout::Fraction(..));
    let counter = |item: &Item| match item.layout {
        Layout::Letter(letter) if COUNTERS.contains(&letter) => Some(letter),
        _ => None,
    };
    match solid.as_slice() {
        [only] => counter(only).map(|letter| (letter, String::new())),
        [first, Item { layout: Layout::Other('+' | '-'), .. }, rest @ ..]
            if !rest.is_empty() && rest.iter().all(|item| is_figure(item) || item.layout == Layout::Other('/')) =>
        {
            counter(first).map(|letter| (letter, printed(&contents(sup)[1..])))
        }
        _ => None,
    }
}

/// Whether a subscript is a place on a grid: two counters, or one with a number added.
fn is_place(sub: &Item) -> bool {
    let solid: Vec<&Item> = contents(sub).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_letter =
        |item: &Item| names::printed(item, None).is_some_and(|found| PLACES.contains(&found.name.base.as_str()));
    let is_sign = |item: &Item| {
        matches!(item.layout, Layout::Other('+' | '-'))
            || matches!(&item.layout, Layout::Command(name) if name == "\\pm" || name == "\\mp")
    };
    let is_part = |item: &Item| {
        is_letter(item)
            || is_sign(item)
            || matches!(item.layout, Layout::Number(_) | Layout::Other(',' | '/') | Layout::Fraction(..))
    };
    let is_moved = solid.iter().any(|item| is_sign(item));
    let letters = solid.iter().filter(|item| is_letter(item)).count();
    let has_comma = solid.iter().any(|item| item.layout == Layout::Other(','));
    solid.iter().all(|item| is_part(item)) && (letters > 1 && has_comma || letters > 0 && is_moved)
}
