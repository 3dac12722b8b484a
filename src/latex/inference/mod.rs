//! What a display shows about its letters before it is read: functions, differentials, variations, matrices.
//!
//! This is for formulas without declarations only. Each rule needs evidence that no other reading explains:
//!
//! | evidence | inferred |
//! | --- | --- |
//! | a name directly before a lone name, a 0 or a list in parentheses: `V(r)`, `x(0)`, `L(q, \dot q, t)` | a function |
//! | a prime before an argument, `V'(r)`; two primes anywhere, `y''` | a function |
//! | `d` before at least two names, and never alone; an upright d | differentials |
//! | `\delta` before a name that is neither a rate nor the time, and never alone | variations |
//! | `dr'`, `t'` and what [`super::primed_names`] lists | r′ is another letter |
//! | a bold letter with a transpose or an inverse, or two side by side | matrices, which are refused |
//!
//! A name that is a function in one place is one everywhere. Vectors are told by their markup alone.

mod marks;

use std::collections::HashSet;

use crate::formula::symbols::{Inferred, Name, Symbols};
use crate::formula::text;

use super::arguments::{
    distribution, fence, goes_on_with_a_parenthesis, has_dagger, is_comma, is_dimension, is_given, is_letter, is_step,
    is_unit_in_brackets, is_zero, item_has_comma, names_itself, starts_derivative, trimmed,
};
use super::layout::{Delimiter, Item, Layout, contents};
use super::names;
use super::primed_names;
use super::reader::algebra::evidence;
use super::reader::items::{differential, is_integral, is_minus_one, is_transpose, whole_number};
use super::reader::structure;
use super::reader::undeclared::{coefficient_d, current, uses, vectors};
use super::rows::relation;
use marks::Marks;

/// Records in an open symbol table what the items of a display show.
pub(super) fn infer(items: &[Item], symbols: &mut Symbols) {
    let is_abstract = symbols.inferred.abstractly;
    let found = uses::of(items);
    symbols.inferred.factors = found.factors();
    symbols.inferred.i_varies = found.has_dot("i") || current::is_a_quantity(items);
    let of_two_places: Vec<(Name, Option<String>)> = found.functions().into_iter().map(|name| (name, None)).collect();
    symbols.inferred.exponents = found.exponents;
    let factors = symbols.inferred.factors.clone();
    let mut evidence = Evidence { is_abstract, time: symbols.time.clone(), factors, ..Evidence::default() };
    evidence.list(items);
    evidence.at_the_same_place();
    evidence.functions.extend(of_two_places);
    let factors_d = coefficient_d::of(items);
    evidence.differentials.alone |= factors_d.is_in_a_function || factors_d.is_factor;
    let Evidence { mut functions, primed, letters, differentials, variations, matrices, .. } = evidence;
    symbols.inferred.letters.extend(letters);
    for name in
        primed_names::letters(items).into_iter().filter(|name| !functions.iter().any(|(known, _)| known == name))
    {
        if symbols.inferred.letters.insert(name.clone()) {
            let shown = text::plain(&Name { primes: 1, ..name }.to_string());
            symbols.inferred.said.push(format!("{shown} is another quantity, not a derivative"));
        }
    }
    functions.retain(|(name, _)| symbols.find(name).is_none());
    for (name, arguments) in functions {
        if let Some(arguments) = &arguments {
            let shown = text::plain(&name.to_string());
            symbols.inferred.said.push(format!("{shown} is a function of {}", text::plain(arguments)));
        }
        symbols.inferred.functions.insert(name, arguments);
    }
    for name in primed {
        let shown = text::plain(&name.to_string());
        if !symbols.inferred.functions.contains_key(&name) && symbols.find(&name).is_none() {
            symbols.inferred.said.push(format!("{shown} is a function, and a prime is its derivative"));
            symbols.inferred.functions.insert(name, None);
        }
    }
    symbols.inferred.has_factor_d = factors_d.is_factor && !factors_d.has_integral;
    if symbols.inferred.has_factor_d {
        symbols.inferred.said.push("d is a factor, not a differential".to_owned());
    }
    let Inferred { said, .. } = &mut symbols.inferred;
    if differentials.are_sure(if is_abstract { 1 } else { 2 }) {
        said.push("d before a letter is a differential".to_owned());
        symbols.inferred.differentials = true;
    }
    let are_variations = variations.are_sure(1) || is_abstract && !variations.names.is_empty();
    if are_variations && !symbols.inferred.has_coefficient {
        symbols.inferred.said.push("δ before a letter is a variation".to_owned());
        symbols.inferred.variations = true;
    }
    let crossed = evidence::crossed(items);
    symbols.inferred.matrices.extend(matrices.into_iter().filter(|name| !crossed.contains(name)));
    symbols.inferred.matrices.extend(vectors::matrices(items));
    if is_abstract {
        structure::note(items, &mut symbols.inferred);
        structure::note_acting(items, &mut symbols.inferred);
        structure::note_indices(items, &mut symbols.inferred);
    }
}

#[derive(Default)]
struct Evidence {
    is_abstract: bool,
    time: Option<Name>,
    /// The names that are factors somewhere, and so no functions by a guess.
    factors: HashSet<Name>,
    /// The functions, each with its arguments as they are printed where they are names.
    functions: Vec<(Name, Option<String>)>,
    primed: Vec<Name>,
    /// Names before a parenthesis, whether they usually are functions there, and the names in it.
    possible: Vec<(Name, bool, Vec<String>)>,
    letters: Vec<Name>,
    differentials: Marks,
    variations: Marks,
    matrices: Vec<String>,
    /// Names before a number in brackets, `x[0]`.
    numbered: Vec<Name>,
    /// Whether brackets stand around one name and after no other, `[X] = K[A][B]`: concentrations.
    has_concentrations: bool,
}

impl Evidence {
    /// `f(x - ct)` beside `u(x, t)`: what stands in the parenthesis is the argument of another function. `S_2(E - E_1)` beside
    /// `S_1(E_1)`: the letter is one of a function, and the place is its own.
    fn at_the_same_place(&mut self) {
        let mut places: Vec<String> = Vec::new();
        for arguments in self.functions.iter().filter_map(|(_, arguments)| arguments.as_ref()) {
            places.extend(arguments.split(", ").map(str::to_owned));
        }
        let possible = std::mem::take(&mut self.possible);
        for (name, is_usual, inside) in possible.clone() {
            let is_new = self.functions.iter().all(|(known, _)| *known != name);
            let is_another = || {
                let is_it = |(known, _): &(Name, _)| known.base == name.base && !known.subscript.is_empty();
                !name.subscript.is_empty() && self.functions.iter().any(is_it)
            };
            if is_new && inside.iter().any(|letter| places.contains(letter)) && (is_usual || is_another()) {
                if let Some(twin) = self.twin(&name, &inside, &possible) {
                    self.functions.push((twin, None));
                }
                self.functions.push((name, None));
            }
        }
    }

    /// The g of `f(x - ct) + g(x + ct)`: the letter after f, before a sum of the same letters.
    fn twin(&self, name: &Name, inside: &[String], possible: &[(Name, bool, Vec<String>)]) -> Option<Name> {
        let twin = Name { base: if name.base == "f" { "g" } else { "G" }.to_owned(), ..name.clone() };
        let is_new = self.functions.iter().all(|(known, _)| *known != twin);
        let is_same = |(other, _, letters): &(Name, bool, Vec<String>)| *other == twin && letters == inside;
        (["f", "F"].contains(&name.base.as_str()) && is_new && possible.iter().any(is_same)).then_some(twin)
    }

    /// Looks at neighbours, then inside of each.
    fn list(&mut self, items: &[Item]) {
        let mut in_integral = false;
        self.has_concentrations |= items.iter().enumerate().any(|(at, item)| {
            let is_name = at > 0 && names::printed(&items[at - 1], None).is_some();
            let inside = fence(item).filter(|(delimiter, _)| *delimiter == Delimiter::Square).map(|(_, inside)| inside);
            let is_capital = |item: &Item| {
                names::printed(item, None).is_some_and(|found| found.name.base.starts_with(|c: char| c.is_uppercase()))
            };
            !is_name && matches!(inside, Some([only]) if is_capital(only))
        });
        for (at, item) in items.iter().enumerate() {
            let next = items.get(at + 1);
            in_integral |= is_integral(item);
            let is_side = at == 0
                && items[1..]
                    .iter()
                    .skip(1)
                    .find(|item| !matches!(item.layout, Layout::Space(_)))
                    .is_some_and(|item| relation(item).is_some());
            // `2\pi(a, b)` is a list of components with a factor.
            let is_turn = item.layout == Layout::Command("\\pi".to_owned());
            let is_multiple = is_turn && at > 0 && matches!(items[at - 1].layout, Layout::Number(_));
            if !(is_multiple || goes_on_with_a_parenthesis(&items[at + 1..])) {
                self.application(item, next, is_side);
            }
            // `(uv)' = u'v + uv'`: the prime of a product is a derivative, and those of its factors too.
            if let Layout::Scripts { nucleus, primes: 1.., .. } = &item.layout
                && let Layout::Fence(Delimiter::Round, inside) = &nucleus.layout
                && inside.len() > 1
            {
                let names = inside.iter().filter_map(|item| names::printed(item, None)).map(|found| found.name);
                self.primed.extend(names.filter(|name| name.primes == 0));
            }
            // `p(x, x')`: the prime names another value of x.
            if let Layout::Fence(Delimiter::Round, inside) = &item.layout {
                let inside = || inside.iter().filter_map(|item| names::printed(item, None)).map(|found| found.name);
                let is_listed = |name: &Name| inside().any(|other| other == *name);
                let twins = inside().filter(|name| name.primes > 0).map(|name| Name { primes: 0, ..name });
                if item_has_comma(item) {
                    self.letters.extend(twins.filter(is_listed));
                }
            }
            if differential(item).is_some()
                && let Some(found) =
                    next.and_then(|next| names::printed(next, None)).filter(|found| found.name.primes > 0)
            {
                self.letters.push(Name { primes: 0, ..found.name });
            }
            let d = matches!(&item.layout, Layout::Letter('d'));
            let upright = matches!(item.layout, Layout::Style(..)) && differential(item) == Some(1);
            if (d || upright) && (!in_integral || self.is_abstract) {
                let rest = items[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
                self.differentials.upright |= upright;
                let is_alone = rest.and_then(|item| names::printed(item, None)).is_none();
                let is_logarithm =
                    |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\ln" || name == "\\log");
                let before_parenthesis = rest.is_some_and(|item| matches!(item.layout, Layout::Fence(..)));
                if rest.is_some_and(is_logarithm) {
                    self.differentials.logarithms += 1;
                } else if !(is_alone && (upright || before_parenthesis)) {
                    self.differentials.note(rest.and_then(|item| names::printed(item, None)).map(|found| found.name));
                }
            }
            if matches!(&item.layout, Layout::Command(name) if name == "\\delta") {
                let rest = items[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
                let found = rest.and_then(|item| names::printed(item, None));
                let is_rate =
                    found.as_ref().is_some_and(|found| found.dots > 0 || Some(&found.name) == self.time.as_ref());
                if !is_rate {
                    let before_integral = rest.is_some_and(is_integral);
                    match found {
                        None if before_integral => {}
                        found => self.variations.note(found.map(|found| found.name)),
                    }
                }
            }
            self.matrix(item, next);
            self.inside(item);
        }
    }

    fn inside(&mut self, item: &Item) {
        match &item.layout {
            // The label of a state.
            Layout::Fence(Delimiter::Ket | Delimiter::Bra, _) => {}
            Layout::Fence(Delimiter::Angle, inside) if inside.iter().any(|item| item.layout == Layout::Other('|')) => {}
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items),
            Layout::Fraction(above, below) => {
                for part in [above, below] {
                    // The d of a derivative says nothing about differentials elsewhere.
                    let part = crate::latex::layout::contents(part);
                    // `\frac{\partial g(a + t)}{\partial t}`
                    if let [mark, name, arguments] = part
                        && self.is_abstract
                        && (differential(mark).is_some() || mark.layout == Layout::Command("\\partial".to_owned()))
                        && fence(arguments).is_some_and(|(delimiter, _)| delimiter == Delimiter::Round)
                        && let Some(found) = names::printed(name, None).filter(|found| found.sup.is_none())
                        && self.functions.iter().all(|(known, _)| *known != found.name)
                    {
                        self.functions.push((Name { primes: 0, ..found.name }, None));
                    }
                    match part.first().is_some_and(|first| differential(first).is_some())
                        && starts_derivative(above, below)
                    {
                        true => self.list(&part[1..]),
                        false => self.list(part),
                    }
                }
            }
            Layout::Root(_, inner) => self.inside_of(inner),
            Layout::Scripts { nucleus, sup, .. } => {
                self.inside(nucleus);
                if let Some(sup) = sup {
                    self.inside_of(sup);
                }
            }
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell)),
            _ => {}
        }
    }

    fn inside_of(&mut self, item: &Item) {
        self.list(crate::latex::layout::contents(item));
    }

    /// A name, and what follows it at once.
    fn application(&mut self, item: &Item, next: Option<&Item>, is_side: bool) {
        let Some(mut found) = names::printed(item, None) else { return };
        if let Some(name) = distribution(&found, next) {
            found = names::Printed { name, dots: 0, sup: None };
        }
        let primes = found.name.primes;
        let name = Name { primes: 0, ..found.name };
        // Two primes on a vector name another one as often.
        let is_vector = ["\\vec{", "\\mathbf{", "\\hat{"].iter().any(|mark| name.base.contains(mark));
        // `q''_s`, `\dot q''`: a flux per area.
        let is_flux = ["q", "m", "Q"].contains(&name.base.as_str()) && (found.dots > 0 || !name.subscript.is_empty());
        if primes > 1 && !is_vector && !is_flux && !self.primed.contains(&name) {
            self.primed.push(name.clone());
        }
        let Some((delimiter, inside)) = next.filter(|next| !is_unit_in_brackets(next)).and_then(fence) else { return };
        let is_usual = ["f", "G", "u", "\\psi", "\\Psi", "\\Omega"].contains(&name.base.as_str());
        // `F (x_2 - x_1)`: where a space stands before the parenthesis of a sum, the letter may be a factor.
        let is_apart = next.is_some_and(|next| item.span.end < next.span.start) && !name.base.starts_with('\\');
        let is_factor = is_apart || self.factors.contains(&name);
        // `V_m(1 - t)`: what has an index is a value there, and no function of a number.
        let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
        let is_number = |item: &Item| matches!(item.layout, Layout::Number(_));
        let is_value = !name.subscript.is_empty() && inside.iter().any(is_number) && inside.iter().any(is_sign)
            || name.subscript == ["0"] && !inside.iter().skip(1).any(is_sign);
        if delimiter == Delimiter::Round && !is_value && !is_factor {
            let inside =
                inside.iter().filter_map(|item| names::printed(item, None)).map(|found| found.name.to_string());
            self.possible.push((name.clone(), is_usual, inside.collect()));
        }
        // `m(\ddot x)`: an acceleration is no argument. `\gamma(c, v)`, `E(1, 0, 0, 1)`: a factor of a list of components.
        let is_acceleration =
            matches!(inside, [only] if names::printed(only, None).is_some_and(|found| found.dots > 1));
        let numbers = inside.split(is_comma).filter(|part| matches!(part, [only] if is_number(only))).count();
        let is_circular = |part: &[Item]| {
            part.iter().any(|item| matches!(&item.layout, Layout::Command(name) if name == "\\cos" || name == "\\sin"))
        };
        let is_tuple = inside.iter().any(is_comma)
            && (name.base == "\\gamma"
                || numbers > 2
                || inside.split(is_comma).filter(|part| is_circular(part)).count() > 1);
        // `\psi^* (T + V) \psi`
        let is_star = |sup: &Item| contents(sup).iter().any(|item| item.layout == Layout::Other('*'));
        let is_wave = ["\\psi", "\\Psi", "\\phi", "\\varphi"].contains(&name.base.as_str());
        let is_of_states =
            is_wave && found.sup.is_some_and(is_star) && inside.len() > 1 && !inside.iter().any(is_comma);
        if is_acceleration || is_tuple || is_of_states {
            return;
        }
        // `\Gamma(a^\dagger b + b^\dagger a)`, `J(J + 1)`
        if has_dagger(inside) || names_itself(inside, &name) {
            return;
        }
        // `\mathbf{x}^T (A) \mathbf{x}` is a product.
        if found.sup.is_some_and(is_transpose) {
            return;
        }
        let arguments: Vec<&[Item]> = inside.split(is_comma).collect();
        let never = ["\\pi", "\\hbar", "\\Delta", "\\delta", "d", "\\mathrm{d}", "e", "\\mathrm{e}", "\\epsilon"];
        // `\pi(t, x)` is a momentum, `\delta^3(r - r')` a distribution.
        let is_list = ["\\pi", "\\epsilon"].contains(&name.base.as_str()) && arguments.len() > 1;
        let is_distribution =
            name.base.starts_with("\\delta^{(") || name.base == "\\delta" && found.sup.is_some_and(is_dimension);
        // `e(t) = r(t) - y(t)`: the error of a control. Nobody multiplies Euler's number by the time in this way.
        let is_signal = name.base == "e"
            && found.sup.is_none()
            && matches!(arguments.as_slice(), [only] if self.plain(only) == self.time.as_ref().map(ToString::to_string));
        let may_be = is_signal || is_list || is_distribution && delimiter == Delimiter::Round;
        if never.contains(&name.base.as_str()) && !may_be {
            return;
        }
        let plain: Option<Vec<String>> = arguments.iter().map(|argument| self.plain(argument)).collect();
        // Numbers are put in for letters too, `y = k(0) + c`; after these letters a 0 is no instant and no place.
        let is_constant = ["k", "c", "b", "l"].contains(&name.base.as_str()) && delimiter == Delimiter::Round;
        let is_zero = matches!(arguments.as_slice(), [only] if matches!(trimmed(only), [zero] if is_zero(zero) && !is_constant))
            // `c(\infty)`: infinity is no factor.
            || matches!(arguments.as_slice(), [only] if matches!(trimmed(only), [Item { layout: Layout::Command(sign), .. }] if sign == "\\infty"));
        let indexed = match arguments.as_slice() {
            [only] if self.is_abstract => match trimmed(only) {
                [name] => names::printed(name, None)
                    .filter(|found| found.sup.is_some_and(is_letter))
                    .map(|found| vec![found.name.to_string()]),
                _ => None,
            },
            _ => None,
        };
        // A function by its letter, whatever stands in the parenthesis.
        let is_powered = found.sup.is_some_and(|sup| whole_number(sup).is_some()) && !is_distribution;
        let is_usual = self.is_abstract
            && structure::is_function_letter(&name, inside)
            && delimiter == Delimiter::Round
            && !is_factor
            && !is_powered;
        let is_remainder = is_usual || is_distribution || ["O", "\\mathcal{O}"].contains(&name.base.as_str());
        // `r(t + \Delta t) = …`: a whole side that is taken at another time.
        let is_moved = is_side
            && arguments.len() == 1
            && trimmed(inside)
                .first()
                .and_then(|first| names::printed(first, None))
                .is_some_and(|found| Some(&found.name) == self.time.as_ref())
            && inside.iter().any(|item| matches!(item.layout, Layout::Other('+' | '-')))
            && inside.iter().any(|item| matches!(&item.layout, Layout::Command(name) if name == "\\Delta"));
        let is_call = match delimiter {
            Delimiter::Round => {
                is_moved
                    || plain.is_some()
                    || is_zero
                    || arguments.len() > 1
                    || is_remainder
                    || inside.iter().any(is_given)
            }
            // `S[q]`, the value of a functional; `S[q^i]`.
            Delimiter::Square => {
                let plain = plain.as_ref().or(indexed.as_ref());
                let letter = name.base.trim_start_matches('\\');
                let is_greek = letter.len() < name.base.len() && letter.starts_with(|c: char| c.is_uppercase());
                // `x[n+1] = x[n]`, `x[0]`: a signal at a step. `\lambda[z] = …`: what is a whole side is no product.
                let are_steps = arguments.iter().all(|part| is_step(trimmed(part)));
                let is_step = are_steps && arguments.len() == 1;
                // One number in brackets may be a factor; of one name, two numbers are steps.
                let is_number = matches!(arguments.as_slice(), [only] if matches!(trimmed(only), [only] if whole_number(only).is_some()));
                if is_number && !self.numbered.contains(&name) {
                    self.numbered.push(name);
                    return;
                }
                let is_small = letter.chars().all(|c| c.is_lowercase() || !c.is_alphabetic());
                if self.has_concentrations && !is_step {
                    return;
                }
                // A commutator has two parts.
                is_small && is_step
                    // `r[m, n]`: numbers of steps have no commutator.
                    || are_steps && arguments.len() > 1 && name.base != "i"
                    || is_side && arguments.len() == 1 && plain.is_some()
                    || arguments.len() != 2
                        && plain.is_some()
                        && (is_greek || letter.chars().all(|c| c.is_uppercase() || !c.is_alphabetic()))
                    || name.base.starts_with("\\mathcal") && plain.is_some()
                    || ["\\phi", "\\varphi"].contains(&name.base.as_str())
                        && name.subscript.is_empty()
                        && plain.as_ref().is_some_and(|plain| plain.concat().chars().all(char::is_uppercase))
            }
            _ => false,
        };
        if !is_call {
            return;
        }
        let time = self.time.as_ref().map(ToString::to_string);
        let shown = plain.map(|plain| plain.join(", ")).filter(|_| !is_remainder);
        match self.functions.iter_mut().find(|(known, _)| *known == name) {
            Some((_, known)) if known.is_none() || shown == time && shown.is_some() => *known = shown.or(known.take()),
            Some(_) => {}
            None => self.functions.push((name, shown)),
        }
    }

    /// An argument that is one name, with the time after it perhaps, as it is printed.
    fn plain(&self, argument: &[Item]) -> Option<String> {
        let (only, rest) = trimmed(argument).split_first()?;
        let follows = match rest {
            [] => true,
            [next] => fence(next).is_some_and(|(delimiter, inside)| {
                delimiter == Delimiter::Round && inside.split(is_comma).all(|argument| self.plain(argument).is_some())
            }),
            _ => false,
        };
        if let (Layout::Fence(Delimiter::Bar | Delimiter::PlainBar, inside), true) = (&only.layout, follows) {
            let names: Vec<String> = inside
                .iter()
                .filter_map(|item| names::printed(item, None))
                .map(|found| found.name.to_string())
                .collect();
            return (!names.is_empty()).then(|| format!("|{}|", names.join(" − ")));
        }
        if let (Layout::Command(name), true) = (&only.layout, rest.is_empty())
            && ["\\dots", "\\cdot"].contains(&name.as_str())
        {
            return Some(name.clone());
        }
        // `R(x^*)` is the value at the place x*.
        let is_star = |sup: &Item| matches!(contents(sup), [Item { layout: Layout::Other('*'), .. }]);
        let is_name = |sup: Option<&Item>| sup.is_none_or(|sup| self.is_abstract && is_star(sup));
        let found = names::printed(only, None).filter(|found| is_name(found.sup) && follows)?;
        names::with_dots(&found.name, found.dots).map(|name| name.to_string())
    }

    /// A bold letter that is a matrix.
    fn matrix(&mut self, item: &Item, next: Option<&Item>) {
        let Some(found) = names::printed(item, None).filter(|found| found.name.base.contains("\\mathbf{")) else {
            return;
        };
        let above = found.sup.is_some_and(|sup| is_transpose(sup) || is_minus_one(sup));
        let beside = next
            .and_then(|next| names::printed(next, None))
            .is_some_and(|next| next.name.base.contains("\\mathbf{") || next.name.base.contains("\\vec{"));
        if above || beside {
            self.matrices.push(found.name.base);
        }
    }
}
