//! Members of a statement that have two meanings, where only their structure is read.

use crate::formula::symbols::Name;
use crate::source::Fault;

use super::super::layout::{Item, Layout};
use super::super::names;
use super::super::reader::items::{contents, parts};
use super::piece::{Link, Piece};

/// The fault of a statement with a colon after a member, or with a `d` that may be a factor: `H = :\phi^2:`, `r_i = di`.
///
/// What stands behind the `d` of a differential stands elsewhere in the display too: `u = x^2, \quad w = du`.
pub(super) fn unclear_member(pieces: &[Piece<'_>], at: usize) -> Option<Fault> {
    let piece = &pieces[at];
    if piece.links.len() < 2 {
        return None;
    }
    if let Some(colon) = piece.links.iter().filter_map(last).find(|item| item.layout == Layout::Other(':')) {
        let what = "a colon after a formula may end the sentence, or put operators in normal order";
        return Some(Fault::ambiguous(colon.span, what).help("leave the colon out"));
    }
    let (differential, name) =
        piece.links.iter().skip(1).find_map(|link| Some((link, differential_of(&link.items)?)))?;
    let others = || piece.links.iter().filter(|link| !std::ptr::eq(*link, differential));
    let all = pieces.iter().flat_map(|piece| &piece.links).filter(|link| !std::ptr::eq(*link, differential));
    let is_elsewhere = all.flat_map(|link| &link.items).any(|item| mentions(item, &name));
    let is_alone = !is_elsewhere && !others().any(|link| link.items.iter().any(|item| has_differential(item)));
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

/// The name behind an italic d, where a member is nothing else.
fn differential_of(items: &[&Item]) -> Option<Name> {
    let solid: Vec<&&Item> = items.iter().filter(is_solid).collect();
    match solid.as_slice() {
        [d, name] if d.layout == Layout::Letter('d') => names::printed(name, None).map(|found| found.name),
        _ => None,
    }
}

/// Whether a name stands anywhere in an item as a letter of its own.
fn mentions(item: &Item, name: &Name) -> bool {
    names::printed(item, None).is_some_and(|found| found.name == *name)
        || parts(item).into_iter().flatten().any(|part| mentions(part, name))
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
