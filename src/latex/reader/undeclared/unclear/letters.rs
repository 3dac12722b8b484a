//! Letters that print as something else than factors: the name of a number without a unit, `Ma = v/c`; a word between two equations,
//! `a = b \quad e \quad c = d`; a name under an arrow, `\vec{P_Mec}`.

use crate::source::{Fault, Span};

use super::super::super::super::layout::{Item, Layout, contents, parts, typed};
use super::super::super::super::lexer::Space;
use super::super::super::super::rows::relation;
use super::super::super::words::run_of_letters;
use super::sides::{first_sides, statements};

/// Numbers without a unit that are names more often than products where they are a whole left side: Strouhal, capillary, Schmidt,
/// Euler, Womersley, Dean, Hartmann, Richardson.
const NUMBERS: [&str; 8] = ["St", "Ca", "Sc", "Eu", "Wo", "De", "Ha", "Ri"];

/// The fault of such letters in a display.
pub(super) fn unclear_letters(items: &[Item]) -> Option<Fault> {
    number_of_a_flow(items)
        .or_else(|| mach_number(items))
        .or_else(|| word_between(items))
        .or_else(|| under_arrow(items))
}

fn name_or_product(word: &str, span: Span) -> Fault {
    Fault::ambiguous(span, format!("{word} may be a name or a product"))
        .help(format!("write \\mathrm{{{word}}} for the name; for a product, put a space \\, between the letters"))
}

fn number_of_a_flow(items: &[Item]) -> Option<Fault> {
    statements(items).iter().find_map(|statement| {
        let (left, _) = first_sides(statement)?;
        let owned: Vec<Item> = left.iter().map(|item| (*item).clone()).collect();
        let (word, span, length) = run_of_letters(&owned, 0)?;
        (length == owned.len() && NUMBERS.contains(&word.as_str())).then(|| name_or_product(&word, span))
    })
}

/// M a is a product where a force is near it, and the Mach number elsewhere: `1 + \frac{\gamma - 1}{2} Ma^2`.
fn mach_number(items: &[Item]) -> Option<Fault> {
    let span = mach(items)?;
    let mut letters = Vec::new();
    items.iter().for_each(|item| names_in(item, &mut letters));
    let has = |names: &[&str]| letters.iter().any(|letter| names.contains(&letter.as_str()));
    let is_force = has(&["F", "N", "g", "f", "k", "\\mu", "\\sum", "\\dot", "\\ddot"])
        || has(&["T", "P", "W", "d"]) && !has(&["\\gamma", "\\kappa", "R"]);
    (!is_force).then(|| {
        Fault::ambiguous(span, "Ma may be the Mach number or a product")
            .help("write \\mathrm{Ma} for the number; for a product, put a space \\, between the letters")
    })
}

fn mach(items: &[Item]) -> Option<Span> {
    let mut at = 0;
    while at < items.len() {
        match run_of_letters(items, at) {
            Some((word, span, _)) if word == "Ma" => return Some(span),
            Some((_, _, length)) => at += length,
            // `\mathrm{Ma}` is a name.
            None if matches!(items[at].layout, Layout::Style(..)) => at += 1,
            None => {
                if let Some(found) = parts(&items[at]).into_iter().find_map(mach) {
                    return Some(found);
                }
                at += 1;
            }
        }
    }
    None
}

fn names_in(item: &Item, found: &mut Vec<String>) {
    match &item.layout {
        Layout::Letter(letter) => found.push(letter.to_string()),
        Layout::Command(name) => found.push(name.clone()),
        Layout::Accent(name, _) => found.push(name.clone()),
        _ => {}
    }
    parts(item).into_iter().flatten().for_each(|part| names_in(part, found));
}

/// A lone letter between two equations, with wide spaces around it.
fn word_between(items: &[Item]) -> Option<Fault> {
    let is_gap = |item: &Item| matches!(item.layout, Layout::Row | Layout::Space(Space::Wide));
    let pieces: Vec<Vec<&Item>> = items
        .split(is_gap)
        .map(|piece| piece.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Align)).collect())
        .filter(|piece: &Vec<&Item>| !piece.is_empty())
        .collect();
    let is_relation = |item: Option<&&Item>| item.is_some_and(|item| relation(item).is_some());
    // `a = \quad b` goes on behind the space.
    let is_equation = |piece: &[&Item]| {
        piece.iter().any(|item| relation(item).is_some()) && !is_relation(piece.first()) && !is_relation(piece.last())
    };
    let here = pieces.windows(3).find_map(|three| match three[1].as_slice() {
        [only] if matches!(only.layout, Layout::Letter(_)) && is_equation(&three[0]) && is_equation(&three[2]) => {
            Some(*only)
        }
        _ => None,
    });
    let found = here.map(|letter| {
        let shown = typed(std::slice::from_ref(letter));
        Fault::ambiguous(letter.span, format!("{shown} alone between two equations may be a word or a quantity"))
            .help(format!("write \\text{{{shown}}} for a word; write commas around a quantity"))
    });
    found.or_else(|| items.iter().find_map(|item| parts(item).into_iter().find_map(word_between)))
}

/// Several letters under an arrow, not all of them capitals: `\vec{P_Mec}`, where M alone is the subscript.
fn under_arrow(items: &[Item]) -> Option<Fault> {
    items.iter().find_map(|item| {
        if let Layout::Accent(accent, inner) = &item.layout
            && accent == "\\vec"
            && let [first, .., last] = contents(inner)
            && contents(inner).iter().all(is_letter)
            && contents(inner).windows(2).all(|pair| pair[0].span.end == pair[1].span.start)
            && contents(inner).iter().any(|item| !matches!(item.layout, Layout::Letter('A'..='Z')))
        {
            let shown = typed(contents(inner));
            let what = format!("{shown} under an arrow may be one name or a product");
            return Some(Fault::ambiguous(first.span.to(last.span), what).help(
                "write all letters of a subscript in braces, as in \\vec{P}_{kin}; write a factor before the arrow",
            ));
        }
        parts(item).into_iter().find_map(under_arrow)
    })
}

/// A letter, with a subscript perhaps.
fn is_letter(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter(_) => true,
        Layout::Scripts { nucleus, sub: Some(_), sup: None, primes: 0 } => matches!(nucleus.layout, Layout::Letter(_)),
        _ => false,
    }
}
