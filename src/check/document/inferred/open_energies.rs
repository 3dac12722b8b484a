//! Energies whose formulas the notes do not print: `L = T - V` before L itself has a formula.
//!
//! Such a display names L and says nothing of it. With T and V as constants, every derivative of L would be 0. So another display
//! defines L, if there is one. In a chain, `L = T - V = \frac12 m\dot x^2 - …`, the names are left out.

use std::borrow::Cow;

use crate::formula::symbols::Name;
use crate::latex::layout::{Item, Layout, typeset_items};
use crate::latex::{Macros, name_search, names};
use crate::notes::Notes;
use crate::source::Span;

/// The letters of energies.
const ENERGIES: [&str; 13] =
    ["T", "V", "U", "K", "E", "W", "L", "H", "\\mathcal{L}", "\\mathcal{H}", "\\mathscr{L}", "\\mathscr{H}", "\\Phi"];

/// Whether a name is that of an energy.
pub(crate) fn is_energy(name: &Name) -> bool {
    ENERGIES.contains(&name.base.as_str())
}

/// The places of the displays that give an energy as a sum of others for which no display has a formula.
pub(crate) fn only_named<'t>(texts: impl Iterator<Item = &'t str>, macros: &Macros) -> Vec<usize> {
    let read: Vec<Option<Sum>> = texts.map(|text| Sum::of(text, macros)).collect();
    let given: Vec<&Name> = read.iter().flatten().map(|sum| &sum.of).collect();
    let is_open =
        |terms: &Vec<Name>| !terms.is_empty() && terms.iter().all(|term| is_energy(term) && !given.contains(&term));
    let open = read.iter().enumerate().filter(|(_, sum)| {
        sum.as_ref().is_some_and(|sum| is_energy(&sum.of) && sum.terms.as_ref().is_some_and(is_open))
    });
    open.map(|(at, _)| at).collect()
}

/// The notes, in which each chain `L = T - V = …` is `L = …`, if no display or sentence has a formula for T and V and nothing declares
/// them: T and V say nothing there. With a claims file, `is_guessed` is false, and one of them without a formula is enough: nothing may be
/// guessed of it.
pub(crate) fn without_names<'n>(
    notes: &'n Notes,
    macros: &Macros,
    is_guessed: bool,
    is_declared: &dyn Fn(&Name) -> bool,
) -> Cow<'n, Notes> {
    if !notes.equations.iter().any(|display| display.text.matches('=').count() > 1) {
        return Cow::Borrowed(notes);
    }
    let read: Vec<Option<Sum>> = notes.equations.iter().map(|display| Sum::of(&display.text, macros)).collect();
    let sentences = notes.inline.iter().filter_map(|span| {
        let text = notes.source.slice(*span).trim_matches('$');
        Sum::of(text, macros).map(|sum| sum.of)
    });
    let given: Vec<Name> = read.iter().flatten().map(|sum| sum.of.clone()).chain(sentences).collect();
    // A second statement of a display may give it a formula.
    let has_formula = |name: &Name| {
        let name = name.to_string();
        !is_guessed && notes.equations.iter().any(|display| name_search::is_a_side(&display.text, &name, macros))
    };
    let is_open = |name: &Name| is_energy(name) && !given.contains(name) && !is_declared(name) && !has_formula(name);
    let mut found = Cow::Borrowed(notes);
    for (at, sum) in read.iter().enumerate() {
        let named = sum.as_ref().filter(|sum| is_energy(&sum.of)).and_then(|sum| sum.named.as_ref());
        let Some((names, span)) = named else { continue };
        let is_left_out = match is_guessed {
            true => names.iter().all(is_open),
            false => names.iter().all(is_energy) && names.iter().any(is_open),
        };
        if is_left_out {
            found.to_mut().equations[at].text.replace_range(span.range(), &" ".repeat(span.end - span.start));
        }
    }
    found
}

/// What was left out of each display, in words.
pub(crate) fn left_out(printed: &Notes, read: &Notes) -> Vec<String> {
    let pairs = printed.equations.iter().zip(&read.equations).filter(|(before, after)| before.text != after.text);
    let said = pairs.filter_map(|(before, after)| {
        let start = before.text.bytes().zip(after.text.bytes()).position(|(a, b)| a != b)?;
        let end = before.text.bytes().zip(after.text.bytes()).rposition(|(a, b)| a != b)? + 1;
        let names = before.text.get(start..end)?.trim_matches(['=', '&', ' ', '\\', '\n']);
        let shown = before.id().map_or_else(|| format!("line {}", before.line), |id| format!("({id})"));
        Some(format!("{names} in {shown} was left out, because no display says what these energies are"))
    });
    said.collect()
}

/// A display that begins with a name and a relation.
struct Sum {
    /// The name.
    of: Name,
    /// The names of which the other side is the sum, if it is nothing else.
    terms: Option<Vec<Name>>,
    /// The names of which the member before a second relation is the sum, if it is nothing else, with its place and that of the relation
    /// before it.
    named: Option<(Vec<Name>, Span)>,
}

impl Sum {
    fn of(text: &str, macros: &Macros) -> Option<Sum> {
        // Most displays need no further look.
        text.contains('=').then_some(())?;
        let items = typeset_items(text, macros).ok()?;
        let is_mark = |item: &&Item| {
            !matches!(item.layout, Layout::Space(_) | Layout::Align | Layout::Other('.' | ',' | ';' | ':'))
        };
        let mut items = items.iter().filter(is_mark);
        let of = names::printed(items.next()?, None).filter(|printed| printed.dots == 0)?.name;
        // `V(x) = …` gives V a formula.
        let rest: Vec<&Item> = items.skip_while(|item| matches!(item.layout, Layout::Fence(..))).collect();
        let [equals, rest @ ..] = rest.as_slice() else { return None };
        if !matches!(equals.layout, Layout::Other('=')) {
            return None;
        }
        let plain = |item: &&Item| {
            names::printed(item, None).filter(|printed| printed.dots == 0 && printed.sup.is_none()).map(|p| p.name)
        };
        let is_sign = |item: &&Item| matches!(item.layout, Layout::Other('+' | '-'));
        let names_in = |side: &[&Item]| -> Option<Vec<Name>> {
            let terms = side.split(is_sign).map(|term| match term {
                [only] => plain(only),
                _ => None,
            });
            terms.collect()
        };
        let named = rest.iter().position(|item| matches!(item.layout, Layout::Other('='))).and_then(|end| {
            let names = names_in(&rest[..end])?;
            (names.len() > 1).then(|| (names, Span::new(equals.span.start, rest[end].span.start)))
        });
        Some(Sum { of, terms: names_in(rest), named })
    }
}
