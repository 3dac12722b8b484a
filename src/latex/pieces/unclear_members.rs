//! Members of a statement that have two meanings, where only their structure is read.

use crate::formula::symbols::Name;
use crate::formula::tree::Relation;
use crate::source::Fault;

use super::super::layout::{Delimiter, Item, Layout, contents, parts, typed};
use super::super::names;
use super::piece::{Link, Piece};

/// The fault of a statement with a colon after a member, or with a `d` that may be a factor: `H = :\phi^2:`, `r_i = di`.
///
/// What stands behind the `d` of a differential stands elsewhere in the display too: `u = x^2, \quad w = du`.
pub(super) fn unclear_member(pieces: &[Piece<'_>], at: usize) -> Option<Fault> {
    let piece = &pieces[at];
    if let Some(fault) = legend(piece).or_else(|| mean_value(piece)) {
        return Some(fault);
    }
    if piece.links.len() < 2 {
        return None;
    }
    if let Some(fault) = condition(piece).or_else(|| name_of_a_list(piece)) {
        return Some(fault);
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
        Fault::ambiguous(
            span,
            "d may be a differential or a factor, because no other side of the equation has a differential",
        )
        .help("write \\mathrm{d} for a differential, and \\cdot after the factor d")
    })
}

/// The fault of letters with their meanings behind a brace: `\begin{cases} x & \text{position} \\ …`.
fn legend(piece: &Piece<'_>) -> Option<Fault> {
    let [link] = piece.links.as_slice() else { return None };
    let [only] = link.items.iter().filter(is_solid).copied().collect::<Vec<_>>()[..] else { return None };
    let Layout::Environment(_, rows) = &only.layout else { return None };
    let is_text = |cell: &Vec<Item>| {
        let mut solid = cell.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        solid.next().is_some_and(|first| matches!(first.layout, Layout::Text(_))) && solid.next().is_none()
    };
    let is_legend = rows.len() > 1 && rows.iter().all(|row| row.len() == 2 && row.iter().any(is_text));
    is_legend.then(|| {
        Fault::unsupported(only.span, "a table that explains names in words is not supported")
            .help("write the explanation as text, outside of the formula")
    })
}

/// The fault of `<x> = …`: < and > before and after a formula are the brackets of a mean value.
fn mean_value(piece: &Piece<'_>) -> Option<Fault> {
    let relation = |link: &Link<'_>| link.relation.map(|(relation, _)| relation);
    let less = piece.links.iter().position(|link| relation(link) == Some(Relation::Less))?;
    let greater = piece.links.iter().position(|link| relation(link) == Some(Relation::Greater))?;
    let is_empty = |at: usize| !piece.links[at].items.iter().any(|item| is_solid(&item));
    let opens = less.checked_sub(1).is_none_or(is_empty);
    (less < greater && (opens || is_empty(greater))).then(|| {
        Fault::ambiguous(piece.span(), "< and > may be brackets or relations")
            .help("write \\langle and \\rangle for the brackets of a mean value")
    })
}

/// The fault of `X \mid z = k \sim N`: what stands behind the bar may be conditions, and the relation one of theirs.
fn condition(piece: &Piece<'_>) -> Option<Fault> {
    let is_bar = |item: &&&Item| matches!(&item.layout, Layout::Command(name) if name == "\\mid");
    let bar = piece.links.iter().flat_map(|link| &link.items).find(is_bar)?;
    let what = "the bar may begin conditions, or say that one number divides another";
    Some(Fault::ambiguous(bar.span, what).help("put the conditions in parentheses, as in P(X \\mid z)"))
}

/// The fault of `lsp = (n, F, G)`: a product equals no list, so that the letters are one name.
fn name_of_a_list(piece: &Piece<'_>) -> Option<Fault> {
    let solid =
        |link: &Link<'_>| -> Vec<Item> { link.items.iter().filter(is_solid).map(|item| (*item).clone()).collect() };
    let has_list = piece.links.iter().any(|link| {
        matches!(solid(link).first().map(|first| &first.layout), Some(Layout::Fence(Delimiter::Round, inside))
            if inside.iter().any(|item| item.layout == Layout::Other(',')))
    });
    let name = piece
        .links
        .iter()
        .map(solid)
        .find(|items| items.len() > 2 && items.iter().all(|item| matches!(item.layout, Layout::Letter(_))))?;
    let span = name.first()?.span.to(name.last()?.span);
    has_list.then(|| {
        let word = typed(&name);
        Fault::ambiguous(span, format!("{word} may be a name or a product"))
            .help(format!("write \\text{{{word}}}, or a letter with a subscript"))
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
