//! Special cases that a sentence states: "Let $I_1 = I_2$. Then", "For a massless pulley, $I = 0$, this becomes", "with $R_2 = -R$".
//!
//! Such a formula sets a constant of the displays before to another one, to its opposite, or to zero. It is a premise of what comes
//! directly after. A value at a place or at an instant ("at the top $v = 0$") is none.

use crate::check::document::inferred::prose::{sentence_start, words_between};
use crate::check::usage::Usage;
use crate::formula::symbols::Name;
use crate::latex::names;
use crate::notes::{Display, Notes};

/// Words that state a case.
const CASES: [&str; 29] = [
    "let", "for", "if", "when", "where", "with", "set", "setting", "take", "taking", "choose", "choosing", "put",
    "putting", "assume", "assuming", "suppose", "case", "since", "as", "has", "have", "because", "equal", "equals",
    "balance", "balances", "für", "pour",
];

/// Words for a place or an instant, at which other things hold than elsewhere.
const PLACES: [&str; 23] = [
    "at",
    "near",
    "until",
    "initially",
    "initial",
    "instant",
    "moment",
    "rest",
    "start",
    "starts",
    "begins",
    "released",
    "top",
    "bottom",
    "point",
    "there",
    "origin",
    "surface",
    "boundary",
    "end",
    "lim",
    "limit",
    "maximum",
];

/// Whether a formula in a sentence states a special case of the displays before the one at `authors`.
pub(super) fn is_one(notes: &Notes, display: &Display, (usages, authors): (&[Usage], usize)) -> bool {
    let words = words_between(notes, sentence_start(notes, display.span.start), display.span.start);
    let says = |list: &[&str]| words.iter().any(|word| list.contains(&word.as_str()));
    if !says(&CASES) || says(&PLACES) {
        return false;
    }
    let members: Vec<&str> = display.text.split('=').map(str::trim).collect();
    let name_of = |text: &str| names::parse(text).filter(|(_, dots)| *dots == 0).map(|(name, _)| name);
    let is_constant = |name: &Name| {
        let usage = usages.iter().find(|usage| usage.name == *name);
        usage.is_none_or(|usage| !usage.moves && !usage.follows) && *name != Name::plain("t")
    };
    let is_used = |name: &Name| usages.iter().any(|usage| usage.name == *name && usage.first < authors);
    let [first, others @ ..] = members.as_slice() else { return false };
    let is_value = |text: &&str| {
        let text = text.strip_prefix('-').unwrap_or(text).trim();
        text == "0" || name_of(text).is_some_and(|name| is_constant(&name))
    };
    name_of(first).is_some_and(|name| is_used(&name) && is_constant(&name))
        && !others.is_empty()
        && others.iter().all(is_value)
}
