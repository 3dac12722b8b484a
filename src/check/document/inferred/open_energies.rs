//! Energies whose formulas the notes do not print: `L = T - V` before L itself has a formula.
//!
//! Such a display names L and says nothing of it. With T and V as constants, every derivative of L would be 0. So another display
//! defines L, if there is one.

use crate::formula::symbols::Name;
use crate::latex::layout::{Item, Layout, typeset_items};
use crate::latex::{Macros, names};

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

/// A display that begins with a name and a relation.
struct Sum {
    /// The name.
    of: Name,
    /// The names of which the other side is the sum, if it is nothing else.
    terms: Option<Vec<Name>>,
}

impl Sum {
    fn of(text: &str, macros: &Macros) -> Option<Sum> {
        // Most displays need no further look.
        text.contains('=').then_some(())?;
        let items = typeset_items(text, macros).ok()?;
        let is_mark =
            |item: &&Item| !matches!(item.layout, Layout::Space(_) | Layout::Align | Layout::Other('.' | ',' | ';'));
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
        let terms = rest.split(is_sign).map(|term| match term {
            [only] => plain(only),
            _ => None,
        });
        Some(Sum { of, terms: terms.collect() })
    }
}
