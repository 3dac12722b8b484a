//! Members of a statement that have two meanings, where only their structure is read.

use crate::source::Fault;

use super::super::layout::{Item, Layout};
use super::super::names;
use super::super::reader::items::{contents, parts};
use super::piece::{Link, Piece};

/// The fault of a statement with a colon after a member, or with a `d` that may be a factor: `H = :\phi^2:`, `r_i = di`.
pub(super) fn unclear_member(piece: &Piece<'_>) -> Option<Fault> {
    if let Some(colon) = piece.links.iter().filter_map(last).find(|item| item.layout == Layout::Other(':')) {
        let what = "a colon after a formula may end the sentence, or put operators in normal order";
        return Some(Fault::ambiguous(colon.span, what).help("leave the colon out"));
    }
    let differential = piece.links.iter().find(|link| is_a_differential(&link.items))?;
    let others = || piece.links.iter().filter(|link| !std::ptr::eq(*link, differential));
    let is_alone = piece.links.len() > 1 && !others().any(|link| link.items.iter().any(|item| has_differential(item)));
    let span = piece.span();
    is_alone.then(|| {
        Fault::ambiguous(span, "the d may begin a differential or be a factor, since no other side has a differential")
            .help("write \\mathrm{d} for a differential, and \\cdot after the factor d")
    })
}

fn last<'a>(link: &Link<'a>) -> Option<&'a Item> {
    link.items.iter().rev().find(is_solid).copied()
}

fn is_solid(item: &&&Item) -> bool {
    !matches!(item.layout, Layout::Space(_))
}

/// Whether a member is an italic d before one letter.
fn is_a_differential(items: &[&Item]) -> bool {
    let solid: Vec<&&Item> = items.iter().filter(is_solid).collect();
    matches!(solid.as_slice(), [d, name] if d.layout == Layout::Letter('d') && names::printed(name, None).is_some())
}

/// Whether a sign of a small quantity stands anywhere in an item: d, δ, ∂, Δ.
fn has_differential(item: &Item) -> bool {
    let is_sign = |name: &str| ["\\delta", "\\partial", "\\Delta", "\\int"].contains(&name);
    match &item.layout {
        Layout::Letter('d') => true,
        Layout::Command(name) => is_sign(name),
        Layout::Accent(_, inner) | Layout::Style(_, inner) => contents(inner).iter().any(has_differential),
        _ => parts(item).into_iter().flatten().any(has_differential),
    }
}
