//! What stands in a parenthesis after a name, and which letters usually stand for functions.

use crate::formula::symbols::{Entry, Name};
use crate::formula::tree::Sign;
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::items::{differential, is_numeric_item, starts_differential};

/// Letters that stand for functions more often than for factors before a parenthesis.
const FUNCTIONS: [&str; 20] = [
    "f", "F", "h", "V", "W", "J", "Y", "O", "P", "U", "H", "D", "d", "\\Gamma", "\\Phi", "\\Psi", "\\psi", "\\Theta",
    "\\delta", "\\Delta",
];

/// Letters that usually depend on a place, `u(x + h)`.
pub(super) const FIELDS: [&str; 9] = ["y", "G", "u", "w", "\\phi", "\\varphi", "\\eta", "\\chi", "\\xi"];

/// A parenthesis, with a script perhaps, and what is in it without the spaces.
pub(super) fn parenthesis(item: &Item) -> Option<(&Item, Vec<&Item>)> {
    let fence = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    let Layout::Fence(Delimiter::Round | Delimiter::Square | Delimiter::Curly, inside) = &fence.layout else {
        return None;
    };
    Some((fence, inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect()))
}

/// Whether an item is a parenthesis with a list of names in it: the arguments of a function.
pub(in super::super) fn are_names(item: &Item, branch: Option<Sign>) -> bool {
    let Some((_, inside)) = parenthesis(item) else { return false };
    let is_name = |item: &Item| names::printed(item, branch).is_some_and(|printed| printed.sup.is_none());
    let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
    !inside.is_empty()
        && inside.iter().enumerate().all(|(at, item)| if at % 2 == 0 { is_name(item) } else { is_comma(item) })
}

/// Whether one term in a parenthesis may be the argument of a name before it, where only guesses say what the name is:
/// `F(1/u)`. What stands in the O of a remainder is one whatever it is.
pub(super) fn may_be_an_argument(entry: &Entry, inside: &[&Item], is_powered: bool) -> bool {
    let base = entry.name.base.as_str();
    let is_sign = |item: &&Item| matches!(item.layout, Layout::Other('+' | '-'));
    let is_term = !inside.iter().skip(1).any(is_sign);
    let is_letter = is_function(entry) || FIELDS.contains(&base);
    let is_product = is_powered || inside.iter().any(|item| has_rate(item)) || is_product_of_vectors(inside);
    let is_plain = entry.name.subscript.is_empty();
    ["O", "\\mathcal{O}"].contains(&base) || is_plain && is_letter && is_term && !is_product
}

/// Whether a name usually stands for a function.
pub(super) fn is_function(entry: &Entry) -> bool {
    let base = entry.name.base.as_str();
    let is_ornate =
        ["\\mathcal{", "\\mathscr{", "\\mathbb{", "\\mathfrak{"].iter().any(|style| base.starts_with(style));
    // `\bar V(p - q)` is a function as V is.
    let plain = names::unaccented(&entry.name);
    // `\delta_{ij}(a + b)`, `\Gamma^r_{tt}(\dot t)^2`: with two indices they are factors.
    if ["\\delta", "\\Gamma"].contains(&base) && entry.name.subscript.len() > 1 {
        return false;
    }
    entry.name.primes > 0 || FUNCTIONS.contains(&plain.base.as_str()) || is_ornate
}

/// Whether a name stands anywhere in an item as a letter of its own, and in no parentheses of a name.
pub(super) fn mentions(item: &Item, name: &Name) -> bool {
    if names::printed(item, None).is_some_and(|found| found.name == *name) {
        return true;
    }
    match &item.layout {
        Layout::Fraction(above, below) => mentions(above, name) || mentions(below, name),
        Layout::Group(items) | Layout::Fence(_, items) => items.iter().any(|item| mentions(item, name)),
        Layout::Scripts { nucleus, .. } | Layout::Root(_, nucleus) => mentions(nucleus, name),
        _ => false,
    }
}

/// The fault of i before a parenthesis in a sum over i: `\sum_i a_i e^{i(k x_i - \omega t)}`.
pub(super) fn may_be_an_index(name: &Name, bound: &[String], span: Span) -> Option<Fault> {
    let is_unit = ["i", "j"].contains(&name.base.as_str()) && name.subscript.is_empty();
    (is_unit && bound.contains(&name.base)).then(|| {
        Fault::ambiguous(span, format!("{name} may be √−1 or the index of this sum"))
            .help("write \\mathrm{i} for √−1, or another letter for the index of the sum")
    })
}

/// Whether a calligraphic letter before brackets with a sum may be a number of particles or another quantity,
/// `\mathcal{N}[a - \ln\rho]`; a transform is none.
pub(super) fn may_be_a_number(name: &Name, next: &Item) -> bool {
    const QUANTITIES: [&str; 6] = ["N", "V", "E", "Z", "P", "R"];
    let letter = name.base.strip_prefix("\\mathcal{").and_then(|base| base.strip_suffix('}'));
    let is_sum = |inside: &[Item]| inside.iter().any(|item| matches!(item.layout, Layout::Other('+' | '-')));
    letter.is_some_and(|letter| QUANTITIES.contains(&letter))
        && matches!(&next.layout, Layout::Fence(Delimiter::Square | Delimiter::Curly, inside) if is_sum(inside))
}

pub(super) fn relation_or_comma(item: &Item) -> bool {
    matches!(item.layout, Layout::Other(',' | ';' | '=' | '<' | '>' | ':' | '|'))
}

pub(super) fn is_zero(item: &Item) -> bool {
    matches!(&item.layout, Layout::Number(digits) if digits == "0")
}

/// Whether an item is a part of a number: digits, π, a sign, a fraction of numbers.
pub(super) fn is_value(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(_) => true,
        Layout::Other(c) => matches!(c, '+' | '-' | '/'),
        Layout::Command(name) => name == "\\pi",
        _ => is_numeric_item(item),
    }
}

/// Whether an exponent is a fraction of numbers or has decimals: `3/2`, `0.5`.
pub(super) fn is_fractional(sup: &Item) -> bool {
    let is_number = |item: &Item| matches!(item.layout, Layout::Number(_));
    match contents(sup) {
        [Item { layout: Layout::Number(digits), .. }] => digits.contains('.'),
        [Item { layout: Layout::Fraction(a, b), .. }] => [a, b].iter().all(|part| contents(part).iter().all(is_number)),
        [a, slash, b] => is_number(a) && slash.layout == Layout::Other('/') && is_number(b),
        _ => false,
    }
}

/// `\theta(t - t')`: the step of Heaviside, of the difference of two values of one quantity.
pub(super) fn is_step_function(entry: &Entry, inside: &[Item]) -> bool {
    let base =
        |item: &Item| names::printed(item, None).filter(|found| found.sup.is_none()).map(|found| found.name.base);
    let is_step = ["\\theta", "\\Theta"].contains(&entry.name.base.as_str()) && entry.name.subscript.is_empty();
    let solid: Vec<&Item> = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let [first, minus, second] = solid.as_slice() else { return false };
    is_step && minus.layout == Layout::Other('-') && base(first).is_some() && base(first) == base(second)
}

/// Whether a name may stand in its own argument, `f(f(x))`. A volume, a pressure or an energy does not.
pub(super) fn may_contain_itself(entry: &Entry) -> bool {
    is_function(entry) && !["V", "P", "U", "W"].contains(&entry.name.base.as_str())
}

/// Whether a name with an order below is a polynomial of a cosine, `P_l^m(\cos\theta)`, or a Bessel function, `J_m(k r)`.
pub(super) fn is_special_function(name: &Name, inside: &[&Item]) -> bool {
    let is_order = |part: &String| {
        ["l", "\\ell", "m", "n", "\\nu", "k"].contains(&part.as_str()) || part.chars().all(|c| c.is_ascii_digit())
    };
    let has_order = !name.subscript.is_empty() && name.subscript.iter().all(is_order);
    let is_cosine = matches!(inside.first().map(|item| &item.layout),
        Some(Layout::Command(command)) if command == "\\cos" || command == "\\sin");
    let is_product = inside.len() == 2 && inside.iter().all(|item| names::printed(item, None).is_some());
    has_order
        && (["P", "T", "U", "Q", "L", "H"].contains(&name.base.as_str()) && is_cosine
            || ["J", "Y", "j", "N", "I", "K"].contains(&name.base.as_str()) && (is_cosine || is_product))
}

/// Whether ∇, or a derivative of nothing, stands in a parenthesis: an operator, or what it makes of a field, is no argument of a letter.
pub(super) fn has_nabla<'i>(inside: impl IntoIterator<Item = &'i Item>) -> bool {
    let is_d = |item: &Item| {
        differential(item).is_some() || matches!(&item.layout, Layout::Command(name) if name == "\\partial")
    };
    let is_bare = |above: &Item| match contents(above) {
        [only] => is_d(only) || matches!(&only.layout, Layout::Scripts { nucleus, .. } if is_d(nucleus)),
        _ => false,
    };
    inside.into_iter().any(|item| match &item.layout {
        Layout::Command(name) => name == "\\nabla",
        Layout::Fraction(above, below) => is_bare(above) && starts_differential(below),
        Layout::Scripts { nucleus, .. } => has_nabla([&**nucleus]),
        Layout::Group(items) | Layout::Fence(_, items) => has_nabla(items),
        _ => false,
    })
}

/// Whether a dotted symbol or a derivative stands anywhere in an item.
pub(super) fn has_rate(item: &Item) -> bool {
    match &item.layout {
        Layout::Accent(command, inner) => super::super::super::overdots::order(command).is_some() || has_rate(inner),
        Layout::Fraction(above, below) => {
            starts_differential(below) && differential_above(above) || has_rate(above) || has_rate(below)
        }
        Layout::Group(items) | Layout::Fence(_, items) => items.iter().any(has_rate),
        Layout::Scripts { nucleus, .. } | Layout::Style(_, nucleus) | Layout::Root(_, nucleus) => has_rate(nucleus),
        _ => false,
    }
}

pub(super) fn differential_above(above: &Item) -> bool {
    contents(above).first().is_some_and(|first| differential(first).is_some())
}

/// Whether a product with × or · of names with an arrow or in bold stands in a parenthesis.
pub(super) fn is_product_of_vectors(inside: &[&Item]) -> bool {
    let is_operator = |item: &Item| matches!(&item.layout, Layout::Command(name) if ["\\times", "\\wedge", "\\cdot"].contains(&name.as_str()));
    let is_vector = |item: &Item| {
        names::printed(item, None).is_some_and(|printed| {
            ["\\vec{", "\\mathbf{", "\\hat{"].iter().any(|mark| printed.name.base.contains(mark))
        })
    };
    inside.iter().any(|item| is_operator(item)) && inside.iter().filter(|item| is_vector(item)).count() > 1
}
