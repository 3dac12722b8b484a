//! What some letters mean in notes, by how they stand in all formulas: h beside ħ, i, and hats.

use crate::check::document::inferred::prose::body_of;
use crate::check::usage::Usage;
use crate::formula::symbols::Name;
use crate::latex::layout::typeset_items;
use crate::latex::{Macros, has_imaginary_unit};
use crate::notes::Notes;

/// Whether ħ and h stand in one display, and no display says what either of them is: then ħ is h/2π.
pub(super) fn has_both_constants_of_planck(notes: &Notes, usages: &[Usage]) -> bool {
    let is_given = |usage: &Usage| usage.given && ["h", "\\hbar"].contains(&usage.name.to_string().as_str());
    let has_h = |text: &str| {
        let is_letter = |c: Option<char>| c.is_some_and(|c| c.is_ascii_alphabetic() || c == '\\');
        text.match_indices('h').any(|(at, _)| {
            !is_letter(text[..at].chars().next_back())
                && !is_letter(text[at + 1..].chars().next().filter(|c| *c != '\\'))
        })
    };
    let has_both = |text: &str| text.contains("\\hbar") && has_h(text);
    !usages.iter().any(is_given) && notes.equations.iter().any(|display| has_both(&display.text))
}

/// Whether i is √−1 in notes: it must be in one formula, and is no quantity or index in another.
pub(super) fn means_root_of_minus_one(notes: &Notes, usages: &[Usage], macros: &Macros) -> bool {
    let is_i = |usage: &&Usage| usage.name == Name::plain("i");
    let is_quantity = |usage: &Usage| usage.given || !is_reserved(usage);
    let inline = notes.inline.iter().filter_map(|span| Some(notes.source.slice(body_of(notes, *span)?)));
    let is_evident =
        |text: &str| text.contains('i') && typeset_items(text, macros).is_ok_and(|items| has_imaginary_unit(&items));
    usages.iter().find(is_i).is_some_and(|usage| !is_quantity(usage))
        && (notes.equations.iter().any(|display| is_evident(&display.text)) || inline.into_iter().any(is_evident))
}

/// Whether a hat marks a direction in notes, and no operator.
pub(super) fn hats_are_directions(notes: &Notes) -> bool {
    let operators = ["\\hbar", "\\ket", "\\bra", "\\comm", "[\\hat", "\\rangle", "\\hat H", "\\hat{H}"];
    !notes.equations.iter().any(|display| operators.iter().any(|mark| display.text.contains(mark)))
}

/// Words for what keeps its value.
const CONSTANT: [&str; 6] = ["constant ", "uniform ", "konstante", "constante ", "costante ", "gleichmäßig"];

/// The most characters between such a word and the letter: "a constant deceleration of magnitude $a$".
const NEAR: usize = 40;

/// Whether a sentence says that a quantity is constant.
pub(super) fn is_said_to_be_constant(notes: &Notes, name: &Name) -> bool {
    let text = &notes.source.text;
    text.match_indices(&format!("${name}$")).any(|(at, _)| {
        let before: Vec<char> =
            text[..at].chars().rev().take(NEAR).take_while(|c| !matches!(c, '.' | '$' | ':' | ';')).collect();
        let before = before.into_iter().rev().collect::<String>().to_lowercase();
        let is_denied = ["not ", "no ", "non-", "nicht ", "pas "].iter().any(|word| before.contains(word));
        !is_denied && CONSTANT.iter().any(|word| before.contains(word))
    })
}

/// Whether a name is known without a declaration, and is not used as a quantity of the notes either.
pub(super) fn is_reserved(usage: &Usage) -> bool {
    let is_quantity = match usage.name.base.as_str() {
        // A current, or the inclination of an orbit in sin i.
        "i" => usage.moves || usage.arguments.is_some() || usage.angle,
        // An eccentricity, or the coefficient of restitution.
        "e" => !usage.exponential,
        "d" => usage.divides || !usage.precedes,
        _ => false,
    };
    is_reserved_name(&usage.name) && !is_quantity
}

/// Whether a name is known without a declaration, or cannot be declared.
pub(super) fn is_reserved_name(name: &Name) -> bool {
    const KNOWN: [&str; 9] = ["t", "e", "d", "i", "\\pi", "\\mathrm{d}", "\\mathrm{e}", "\\mathrm{i}", "\\mathrm{j}"];
    let alone = name.subscript.is_empty() && name.primes == 0;
    alone && KNOWN.contains(&name.base.as_str())
        || name.base.starts_with("\\hat{")
        || name.base.starts_with("\\mathrm{") && alone
}
