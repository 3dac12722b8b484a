//! Predicates on layout items: a number, an operator, a transpose mark, a differential, the head of a function.

use crate::formula::symbols::Name;
use crate::formula::tree::{Expr, Function, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::names;
use super::state::Read;

/// How factors are joined to those before them.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Joint {
    Beside,
    CDot,
    Times,
    Slash,
}

/// The bytes from the first item to the last.
pub(super) fn extent(items: &[Item]) -> Option<Span> {
    Some(items.first()?.span.to(items.last()?.span))
}

/// How an item joins the factors on both sides of it.
pub(super) fn joint(item: &Item) -> Option<Joint> {
    match &item.layout {
        Layout::Other('/') => Some(Joint::Slash),
        Layout::Other('*' | '·' | '⋅') => Some(Joint::CDot),
        Layout::Other('×') => Some(Joint::Times),
        Layout::Command(name) => match name.as_str() {
            "\\cdot" => Some(Joint::CDot),
            // ∧ is the product of vectors in France and in Italy.
            "\\times" | "\\wedge" => Some(Joint::Times),
            _ => None,
        },
        _ => None,
    }
}

/// The whole number that an item is.
pub(in super::super) fn whole_number(item: &Item) -> Option<u32> {
    match contents(item) {
        [Item { layout: Layout::Number(digits), .. }] => digits.parse().ok(),
        _ => None,
    }
}

/// `-1`, as the mark of an inverse.
pub(in super::super) fn is_minus_one(item: &Item) -> bool {
    matches!(contents(item), [Item { layout: Layout::Other('-'), .. }, one] if whole_number(one) == Some(1))
}

/// `T` or `\top`, as the mark of a transpose.
pub(in super::super) fn is_transpose(item: &Item) -> bool {
    match contents(item) {
        [Item { layout: Layout::Letter('T'), .. }] => true,
        [Item { layout: Layout::Command(name), .. }] => name == "\\top",
        [Item { layout: Layout::Style(_, inner), .. }] => is_transpose(inner),
        _ => false,
    }
}

/// `-T` or `-\top`, as the mark of the inverse of a transpose.
pub(in super::super) fn is_inverse_transpose(item: &Item) -> bool {
    let mut solid = contents(item).iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let is_minus = solid.next().is_some_and(|first| first.layout == Layout::Other('-'));
    is_minus && solid.next().is_some_and(is_transpose) && solid.next().is_none()
}

/// Whether a group holds numbers only.
pub(super) fn is_numeric(item: &Item) -> bool {
    contents(item).iter().all(|item| match &item.layout {
        Layout::Number(_) => true,
        Layout::Command(name) => name == "\\pi",
        _ => false,
    })
}

/// Whether an item is a number, with a power perhaps.
pub(super) fn is_number(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(_) => true,
        Layout::Scripts { nucleus, .. } => is_number(nucleus),
        _ => false,
    }
}

/// Whether an item is a fraction or root of numbers.
pub(super) fn is_numeric_item(item: &Item) -> bool {
    match &item.layout {
        Layout::Fraction(a, b) => is_numeric(a) && is_numeric(b),
        Layout::Root(_, a) => is_numeric(a),
        _ => false,
    }
}

/// Factors side by side as one formula.
pub(super) fn beside(mut factors: Vec<Expr>) -> Expr {
    if factors.len() == 1 {
        return factors.remove(0);
    }
    let span = match (factors.first(), factors.last()) {
        (Some(first), Some(last)) => first.span.to(last.span),
        _ => Span::default(),
    };
    Expr::new(Node::Product(factors), span)
}

/// `\sum`, with or without limits.
pub(super) fn is_big_sum(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\sum",
        Layout::Scripts { nucleus, .. } => matches!(&nucleus.layout, Layout::Command(name) if name == "\\sum"),
        _ => false,
    }
}

/// `\prod`, with or without limits.
pub(super) fn is_big_product(item: &Item) -> bool {
    is_big(item, "\\prod")
}

/// An integral of any dimension, with or without limits.
pub(super) fn is_any_integral(item: &Item) -> bool {
    ["\\int", "\\oint", "\\iint", "\\iiint", "\\oiint"].iter().any(|sign| is_big(item, sign))
}

/// `\int`, with or without limits.
pub(in super::super) fn is_integral(item: &Item) -> bool {
    is_big(item, "\\int")
}

/// `\lim`, with or without what tends to what.
pub(super) fn is_limit(item: &Item) -> bool {
    is_big(item, "\\lim")
}

fn is_big(item: &Item, command: &str) -> bool {
    match &item.layout {
        Layout::Command(name) => name == command,
        Layout::Scripts { nucleus, .. } => matches!(&nucleus.layout, Layout::Command(name) if name == command),
        _ => false,
    }
}

/// The order of a differential d, `d^2`, `\mathrm{d}`.
pub(in super::super) fn differential(item: &Item) -> Option<u32> {
    let is_d = |item: &Item| {
        item.layout == Layout::Letter('d')
            || matches!(&item.layout, Layout::Style(style, inner) if style == "\\mathrm"
                && matches!(contents(inner), [Item { layout: Layout::Letter('d'), .. }]))
    };
    match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } if is_d(nucleus) => whole_number(sup),
        _ if is_d(item) => Some(1),
        _ => None,
    }
}

/// `d^n`, `d^{3N}`: a differential of so many dimensions.
pub(super) fn differential_of_many(item: &Item) -> Option<String> {
    let Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } = &item.layout else { return None };
    let is_dimension = |item: &Item| {
        matches!(item.layout, Layout::Number(_))
            || ["n", "N", "d", "D", "k"].iter().any(|c| item.layout == Layout::Letter(c.chars().next().unwrap_or(' ')))
    };
    let letters = contents(sup);
    (differential(nucleus) == Some(1)
        && !letters.is_empty()
        && letters.iter().all(is_dimension)
        && whole_number(sup).is_none())
    .then(|| format!("d^{{{}}}", super::super::layout::latex(letters)))
}

/// Whether a sign stands second, so that the d before it is a letter, `\frac{d-2}{d-1}`.
pub(super) fn has_sign_second(items: &[Item]) -> bool {
    matches!(items.get(1).map(|item| &item.layout), Some(Layout::Other('+' | '-')))
}

/// Whether a numerator or denominator begins with a d and goes on: `dx`, `\partial L`.
pub(super) fn starts_differential(item: &Item) -> bool {
    match contents(item) {
        [first, second, ..] => {
            let partial = matches!(&first.layout, Layout::Command(name) if name == "\\partial");
            partial || differential(first).is_some() && names::printed(second, None).is_some()
        }
        _ => false,
    }
}

/// The function whose reciprocal a word names: coth is 1/tanh.
pub(super) fn reciprocal(word: &str) -> Option<Function> {
    match word {
        "coth" => Some(Function::Tanh),
        "sech" => Some(Function::Cosh),
        "csch" => Some(Function::Sinh),
        _ => None,
    }
}

/// The hyperbolic function whose inverse a word names; it is made of the logarithm.
pub(super) fn area_function(word: &str) -> Option<Function> {
    match word {
        "arsinh" | "arcsinh" | "asinh" => Some(Function::Sinh),
        "arcosh" | "arccosh" | "acosh" => Some(Function::Cosh),
        "artanh" | "arctanh" | "atanh" => Some(Function::Tanh),
        _ => None,
    }
}

/// The word of a function's head, without its power and its backslash.
pub(super) fn head_word(item: &Item) -> Option<String> {
    let nucleus = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    match &nucleus.layout {
        Layout::Command(name) => name.strip_prefix('\\').map(str::to_owned),
        Layout::Style(style, inner) if style == "\\mathrm" => {
            Some(contents(inner).iter().map(|item| if let Layout::Letter(c) = item.layout { c } else { ' ' }).collect())
        }
        _ => None,
    }
}

/// The base of `\log_{10}`, if it is a whole number. Without a base \log may be the natural logarithm or the decimal one.
pub(super) fn log_base(head: &Item) -> Option<u32> {
    let Layout::Scripts { nucleus, sub: Some(base), primes: 0, .. } = &head.layout else { return None };
    let is_log = matches!(&nucleus.layout, Layout::Command(name) if name == "\\log");
    let [Item { layout: Layout::Number(digits), .. }] = contents(base) else { return None };
    digits.parse().ok().filter(|base| is_log && *base > 1)
}

/// A function's command with the power on it.
pub(super) fn function_head(item: &Item) -> Read<Option<(Function, Option<&Item>)>> {
    let named = |item: &Item| {
        let is_bare = !matches!(item.layout, Layout::Scripts { .. });
        let word = head_word(item).filter(|_| is_bare)?;
        let of_command = || reciprocal(&word).filter(|_| matches!(item.layout, Layout::Command(_)));
        of_command().or_else(|| area_function(&word).map(|_| Function::Ln)).or_else(|| Function::named(&word))
    };
    if let Some(function) = named(item) {
        return Ok(Some((function, None)));
    }
    let Layout::Scripts { nucleus, sub, sup, primes } = &item.layout else {
        return Ok(None);
    };
    if log_base(item).is_some() {
        return Ok(Some((Function::Ln, sup.as_deref())));
    }
    let Some(function) = named(nucleus) else {
        return Ok(None);
    };
    if sub.is_some() || *primes > 0 {
        return Err(Fault::unsupported(item.span, "a subscript or prime on a function such as \\sin is not supported")
            .help("write a derivative as \\frac{d}{dx} \\sin x, and put a subscript on the argument"));
    }
    match sup.as_deref() {
        // The usual name of the inverse function.
        Some(sup) if is_minus_one(sup) && function.inverse().is_some() => {
            Ok(function.inverse().map(|inverse| (inverse, None)))
        }
        Some(sup) if contents(sup).first().is_some_and(|item| item.layout == Layout::Other('-')) => {
            let name = function.name();
            Err(Fault::ambiguous(item.span, format!("\\{name}^{{-1}} x may be the inverse function or 1/\\{name} x"))
                .help(format!(
                    "write the inverse function as \\arctan or \\ln, for example, or write \\frac{{1}}{{\\{name} x}}"
                )))
        }
        sup => Ok(Some((function, sup))),
    }
}

/// Whether a parenthesis holds this name and nothing else.
pub(super) fn is_lone(item: &Item, name: &Name) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    let mut inside = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let (Some(only), None) = (inside.next(), inside.next()) else { return false };
    names::printed(only, None).is_some_and(|p| p.dots == 0 && p.sup.is_none() && p.name == *name)
}

/// Whether a subscript of ∂ is a usual index, and no variable.
pub(super) fn is_usual_index(sub: &Item) -> bool {
    let letters =
        ["\\mu", "\\nu", "\\rho", "\\sigma", "\\lambda", "\\alpha", "\\beta", "\\kappa", "i", "j", "k", "a", "b"];
    match contents(sub) {
        [Item { layout: Layout::Number(_), .. }] => true,
        [only] => names::printed(only, None).is_some_and(|found| letters.contains(&found.name.base.as_str())),
        _ => false,
    }
}
