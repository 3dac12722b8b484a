//! What stands beside a factor and is none: the change of a formula, `\delta\ln W`; a term with its sign in braces, `b {+c}`; words; the
//! mean value before what it averages, `\mathbb{E} X`; Euler's number behind 2π; the imaginary unit in `(-j)^n`.

use crate::formula::units;
use crate::source::Fault;

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::items::{differential, joint, whole_number};

/// The fault of δ, Δ or d before what is no letter: `\delta\ln W`, `d\ln T`; and of Δ² before a letter. `d\sin\theta` is a product as often.
pub(super) fn unclear_operator(before: &Item, item: &Item) -> Option<Fault> {
    let is_mark = matches!(&before.layout, Layout::Command(name) if name == "\\delta" || name == "\\Delta");
    let is_d = differential(before) == Some(1);
    let is_logarithm = matches!(&item.layout, Layout::Command(name) if name == "\\ln" || name == "\\log");
    let is_formula = match &item.layout {
        Layout::Command(name) => {
            ["\\ln", "\\log", "\\det", "\\exp", "\\sin", "\\cos", "\\tan", "\\sinh", "\\cosh", "\\tanh", "\\sum"]
                .contains(&name.as_str())
        }
        Layout::Fraction(..) | Layout::Fence(Delimiter::Angle | Delimiter::Bar | Delimiter::PlainBar, _) => true,
        Layout::Scripts { nucleus, .. } => nucleus.layout == Layout::Command("\\sum".to_owned()),
        _ => false,
    };
    // `\Delta^2 y_0`: the second difference, or the Laplacian of the Laplacian.
    let is_second = matches!(&before.layout, Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
        if nucleus.layout == Layout::Command("\\Delta".to_owned()) && whole_number(sup).is_some());
    let is_operation = is_second && names::printed(item, None).is_some();
    (is_mark && is_formula || is_d && is_logarithm || is_operation).then(|| {
        Fault::ambiguous(before.span.to(item.span), "Δ, δ or d may mean the change of what follows, or be a factor")
            .help("put parentheses around what changes, or write \\cdot for a product")
    })
}

/// The fault of a sign in braces after a factor, `b {+c}`, `T \underbrace{-V}_{p}`: braces do not print.
pub(super) fn signed_in_braces(before: &Item, item: &Item) -> Option<Fault> {
    let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
    let inside = match &nucleus.layout {
        Layout::Group(_) | Layout::Style(..) => contents(nucleus),
        Layout::Accent(_, inner) => contents(inner),
        _ => return None,
    };
    let has_sign = inside.len() > 1 && matches!(inside[0].layout, Layout::Other('+' | '-'));
    (has_sign && joint(before).is_none()).then(|| {
        Fault::ambiguous(item.span, "braces do not print, so a sign in braces may begin a further term or a factor")
            .help("write the sign before the braces, or parentheses for a factor")
    })
}

/// Whether an item is a word of the text, and no unit and no function.
pub(super) fn is_word(item: &Item) -> bool {
    const SHORT: [&str; 2] = ["odd", "for"];
    const FUNCTIONS: [&str; 12] =
        ["sinh", "cosh", "tanh", "sech", "coth", "sign", "sinc", "rank", "erfc", "diag", "prob", "grad"];
    let Layout::Text(word) = &item.layout else { return false };
    let is_long = word.len() > 3 && word.chars().all(|c| c.is_ascii_lowercase());
    (is_long || SHORT.contains(&word.as_str())) && !FUNCTIONS.contains(&word.as_str()) && units::parse(word).is_err()
}

/// Whether an item is `(-j)^{n}`: nobody raises the negative of a real letter.
pub(super) fn is_power_of_j(item: &Item) -> bool {
    let Layout::Scripts { nucleus, sub: None, sup: Some(_), primes: 0 } = &item.layout else { return false };
    let Layout::Fence(Delimiter::Round, inside) = &nucleus.layout else { return false };
    matches!(inside.as_slice(), [minus, j] if minus.layout == Layout::Other('-') && j.layout == Layout::Letter('j'))
}

/// Whether an item is the sign of a mean value, `\mathbb{E}_x`.
pub(super) fn is_expectation(item: &Item) -> bool {
    let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
    names::printed(nucleus, None).is_some_and(|found| found.name.base == "\\mathbb{E}")
}

/// Whether items end with 2π.
pub(super) fn is_twice_pi(items: &[Item]) -> bool {
    let mut solid = items.iter().rev().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let is_pi = solid.next().is_some_and(|pi| pi.layout == Layout::Command("\\pi".to_owned()));
    is_pi && solid.next().is_some_and(|two| two.layout == Layout::Number("2".to_owned()))
}

/// Whether an item is a parenthesis with numbers alone in it, `(1.6 \times 10^{-19})`, behind which a number in parentheses is a factor.
pub(super) fn are_numbers(item: &Item) -> bool {
    let is_number = |item: &Item| match &item.layout {
        Layout::Number(_) | Layout::Other('-') => true,
        Layout::Scripts { nucleus, sub: None, .. } => matches!(nucleus.layout, Layout::Number(_)),
        _ => joint(item).is_some(),
    };
    matches!(&item.layout, Layout::Fence(Delimiter::Round, inside) if inside.iter().all(is_number))
}
