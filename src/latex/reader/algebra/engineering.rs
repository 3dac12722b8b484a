//! Whether j is √−1 in a display, as engineers write it: before a frequency, `j\omega`, before ħ, before a sine.
//!
//! So it is before an impedance in a sum, `R + jX`, and before a Greek letter in an exponent of e, `e^{-j\beta z}`. It is a symbol where it is
//! an index, has one, has an accent or equals something, and where only another exponent of e has it.

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::is_integral;

/// Whether nothing else can be meant.
pub(super) fn is_imaginary(items: &[Item]) -> bool {
    is_evident(items) && !is_other(items)
}

fn is_j(item: &Item) -> bool {
    item.layout == Layout::Letter('j')
}

fn solid(items: &[Item]) -> Vec<&Item> {
    items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect()
}

/// Whether j stands before what only √−1 is a factor of.
fn is_evident(items: &[Item]) -> bool {
    let solid = solid(items);
    let after = |at: usize| solid[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Number(_)));
    let here = (0..solid.len()).any(|at| {
        let before_sine = || {
            let next = solid.get(at + 1);
            let rest = &solid[at + 1..];
            next.is_some_and(|next| is_command(next, "\\sin"))
                || next.is_some_and(|next| is_integral(next)) && rest.iter().any(|item| is_command(item, "\\sin"))
        };
        let is_term = at > 0 && matches!(solid[at - 1].layout, Layout::Other('+' | '-'));
        is_j(solid[at])
            && (after(at).is_some_and(|next| is_frequency(next))
                || is_term && solid.get(at + 1).is_some_and(|next| is_impedance(next))
                || is_term && solid[..at].iter().any(|item| is_command(item, "\\cos")) && before_sine())
    });
    let in_exponent = |item: &Item| match &item.layout {
        Layout::Scripts { nucleus, sup: Some(sup), .. } => {
            let is_e = nucleus.layout == Layout::Letter('e');
            is_evident(contents(sup)) || is_e && begins_with_a_phase(contents(sup))
        }
        _ => false,
    };
    here || items.iter().any(|item| in_exponent(item) || parts(item).into_iter().any(is_evident))
}

/// An angular frequency, ħ, or a parenthesis that begins with one.
fn is_frequency(item: &Item) -> bool {
    match &item.layout {
        Layout::Fence(_, inside) => inside.first().is_some_and(is_frequency),
        _ => names::printed(item, None)
            .is_some_and(|found| ["\\omega", "\\Omega", "\\hbar"].contains(&found.name.base.as_str())),
    }
}

/// An impedance or a reactance, of which a real part stands before j: `R + jX`, `Z_0 + jZ_L\tan\beta l`.
fn is_impedance(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| ["Z", "X"].contains(&found.name.base.as_str()))
}

/// The exponent of e in `e^{-j\beta z}`, `e^{j2\pi/3}`: j before a Greek letter, with a sign or a number perhaps.
fn begins_with_a_phase(items: &[Item]) -> bool {
    const PHASES: [&str; 8] = ["\\beta", "\\gamma", "\\theta", "\\phi", "\\varphi", "\\psi", "\\pi", "\\delta"];
    let is_factor = |item: &&Item| {
        !matches!(item.layout, Layout::Number(_) | Layout::Other('+' | '-')) && !matches!(item.layout, Layout::Space(_))
    };
    let mut factors = items.iter().filter(is_factor);
    factors.next().is_some_and(is_j)
        && factors.next().is_some_and(|next| match &next.layout {
            Layout::Command(name) => PHASES.contains(&name.as_str()),
            _ => names::printed(next, None).is_some_and(|found| PHASES.contains(&found.name.base.as_str())),
        })
}

fn is_command(item: &Item, command: &str) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == command)
}

/// Whether j is an index, has a subscript, an accent or a style, or equals something.
fn is_other(items: &[Item]) -> bool {
    let mentions = |item: &Item| contents(item).iter().any(|item| is_j(item) || parts(item).concat().iter().any(is_j));
    let here = |item: &Item| match &item.layout {
        Layout::Scripts { nucleus, sub, .. } => sub.as_deref().is_some_and(mentions) || is_j(nucleus) && sub.is_some(),
        Layout::Accent(_, inner) | Layout::Style(_, inner) => is_j(inner) || mentions(inner),
        _ => false,
    };
    let solid = solid(items);
    let is_value = solid.windows(2).enumerate().any(|(at, pair)| {
        let begins =
            at == 0 || matches!(solid[at - 1].layout, Layout::Other(',' | ';') | Layout::Row | Layout::Text(_));
        is_j(pair[0]) && relation(pair[1]).is_some() && begins
    });
    is_value || items.iter().any(|item| here(item) || parts(item).into_iter().any(is_other))
}
