//! Words that stand between formulas, and which of them are no statements.

use super::super::layout::{Delimiter, Item, Layout, contents, latex};
use super::super::lexer::Space;
use super::super::reader::structure::is_prose;
use super::super::reader::words::is_power_in_a_program;
use super::super::rows::{is_operator, is_significant, relation};
use super::conditions::begins_condition;
use super::separators::{says_constant, separates};

/// Whether an item is words that stand between formulas, and no name: no operator or relation is beside it.
pub(super) fn is_remark(items: &[&Item], at: usize) -> bool {
    // `= 1.65\,\omega \ (\text{over the whole range})`
    if let Layout::Fence(Delimiter::Round, inside) = &items[at].layout {
        const LONG: usize = 10;
        let is_phrase = |item: &Item| matches!(&item.layout, Layout::Text(word) if !is_unit(word) && (word.len() >= LONG || is_prose(word)));
        let is_apart = at > 0 && matches!(items[at - 1].layout, Layout::Space(_));
        // `U = -\frac{k}{r} \; (\text{general})`, `(\mathrm{linear})`
        let is_word = |word: &str| word.len() > 2 && word.chars().all(char::is_alphabetic) && !is_unit(word);
        let is_note = is_aside(items, at)
            && match inside.as_slice() {
                [Item { layout: Layout::Text(word), .. }] => is_word(word),
                [Item { layout: Layout::Style(style, inner), .. }] if style == "\\mathrm" => {
                    let word = latex(contents(inner)).replace("\\,", "");
                    word.len() > 3 && is_word(&word)
                }
                _ => false,
            };
        return is_apart && (is_note || inside.iter().any(is_phrase));
    }
    // `\theta_r = \theta_i \quad [\text{law of reflection}]`; beside a factor `[\text{NaCl}]` is a concentration.
    if let Layout::Fence(Delimiter::Square, inside) = &items[at].layout {
        let is_apart = at > 0 && items[at - 1].layout == Layout::Space(Space::Wide);
        return is_apart && is_aside(items, at) && matches!(inside.as_slice(), [Item { layout: Layout::Text(_), .. }]);
    }
    let word = match &items[at].layout {
        _ if separates(items[at]) => return false,
        Layout::Text(word) => word.clone(),
        Layout::Style(style, inner) if style == "\\mathrm" => {
            let word = latex(contents(inner));
            if !is_prose(&word) {
                return false;
            }
            word
        }
        _ => return false,
    };
    // `\text{Tr}(A)` is a function, `\mathrm{SO}(3)` a group; `\text{rank}(A)^2` is a power of the value.
    let is_parenthesis = |item: &Item| match item.layout {
        Layout::Fence(Delimiter::Round, _) => true,
        // `\text{Tr}[A B]`
        Layout::Fence(Delimiter::Square, _) => !is_prose(&word),
        _ => false,
    };
    let is_function = match items.get(at + 1) {
        Some(Item { layout: Layout::Scripts { nucleus, .. }, .. }) => is_parenthesis(nucleus),
        next => next.is_some_and(|next| is_parenthesis(next)),
    };
    let is_capital = word.len() > 1 && word.chars().all(|c| c.is_ascii_uppercase());
    if is_function && (is_capital || !is_prose(&word)) {
        return false;
    }
    let number = items[..at].iter().rev().find(is_significant).is_some_and(|item| is_figure(item));
    if number && is_unit(&word) {
        return false;
    }
    // `10^5\text{ Dynes}`, `\frac{9H}{100}\ \text{g}`, `2\sin(\omega t)\,\text{A}`: a unit directly after a number, and after a
    // formula.
    let is_beside = at > 0 && items[at - 1].layout != Layout::Space(Space::Wide);
    let before = items[..at].iter().rev().find(is_significant);
    let is_formula = before.is_some_and(|item| !is_operator(item) && relation(item).is_none() && !separates(item));
    // `k\text{x}`, `p\,\text{dV}` and `8.62\text{e-5}` are parts of the formula.
    let is_letter = word.chars().count() == 1 && word.chars().all(char::is_alphabetic);
    let is_differential = word.len() == 2 && word.starts_with('d') && word != "do" && word.is_ascii();
    let is_power = number && is_power_in_a_program(&word);
    if is_beside && is_formula && (is_letter || is_differential || is_power) {
        return false;
    }
    if is_beside && (number && (names_a_unit(&word) || is_rate_of_units(&word)) || is_formula && is_unit(&word)) {
        return false;
    }
    let bound = |item: &&Item| is_operator(item) || relation(item).is_some();
    let beside = |mut near: std::iter::Skip<std::slice::Iter<'_, &Item>>| near.find(is_significant).is_some_and(bound);
    let before = items[..at].iter().rev().find(is_significant).is_some_and(bound);
    word.contains(char::is_alphanumeric)
        && says_constant(items[at]).is_none()
        && !begins_condition(items[at])
        && !before
        && !beside(items.iter().skip(at + 1))
}

/// Whether words directly behind a number may be its unit, `14.0 \text{ billion years}`, and no remark.
pub(super) fn may_be_a_unit(items: &[&Item], at: usize) -> bool {
    // Spaces are left out of a text.
    const REMARKS: [&str; 12] = [
        "over",
        "because",
        "since",
        "which",
        "asexpected",
        "asrequired",
        "assuming",
        "(",
        "as",
        "regardless",
        "exactly",
        "approximately",
    ];
    let Layout::Text(word) = &items[at].layout else { return false };
    let is_beside = at > 0 && items[at - 1].layout != Layout::Space(Space::Wide);
    let is_after_number = items[..at].iter().rev().find(is_significant).is_some_and(|item| is_figure(item));
    let is_phrase = REMARKS.iter().any(|first| word.starts_with(first)) || is_aside(items, at);
    is_beside && is_after_number && !is_phrase && word.starts_with(|c: char| c.is_alphabetic())
}

/// The number of items at the beginning of a row that name it: `\text{Mass:}`, `\text{Momentum-}x\text{:}`, `\text{Energy} \quad`.
///
/// Words that say that the row is assumed, or does not hold, are no name.
pub(super) fn name_of_the_row(items: &[&Item]) -> usize {
    // Spaces are left out of a text.
    const SUPPOSITIONS: [&str; 13] = [
        "let", "letus", "if", "for", "not", "notthat", "either", "suppos", "assum", "unless", "except", "wrong",
        "false",
    ];
    let supposes = |word: &str| {
        let word = word.trim_end_matches([':', ',', '.']);
        SUPPOSITIONS.iter().any(|supposed| word == *supposed || supposed.len() > 4 && word.contains(supposed))
    };
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let Some(first) = items.iter().position(|item| !is_space(item)) else { return 0 };
    let Layout::Text(word) = &items[first].layout else { return 0 };
    let word = word.to_lowercase();
    if separates(items[first]) || begins_condition(items[first]) || is_prose(&word) || supposes(&word) {
        return 0;
    }
    // `\text{Mode 0} &: P = a`
    let ends = |item: &Item| {
        item.layout == Layout::Other(':') || matches!(&item.layout, Layout::Text(word) if word.ends_with(':'))
    };
    let is_part = |item: &Item| {
        relation(item).is_none() && !separates(item) && !is_operator(item) && !matches!(item.layout, Layout::Fence(..))
    };
    let length = items[first..].iter().take_while(|item| is_part(item)).position(|item| ends(item)).map(|at| at + 1);
    let is_apart = matches!(items.get(first + 1).map(|next| &next.layout), Some(Layout::Space(Space::Wide)));
    let end = first + length.unwrap_or(usize::from(is_apart));
    let states = items[end..].iter().any(|item| relation(item).is_some());
    if end > first && states { end } else { 0 }
}

/// Whether a remark only explains: words in parentheses, or words at the end of a row that restrict nothing.
pub(super) fn is_aside(items: &[&Item], at: usize) -> bool {
    if at == 0 {
        return false;
    }
    let is_last = items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('.' | ',')));
    match &items[at].layout {
        Layout::Fence(..) => is_last,
        // `\text{ by hypothesis}`, `\text{using the chain rule}`; spaces are left out of a text.
        Layout::Text(word) => {
            // `q = h A \Delta T \quad \text{W}` names the unit of the result.
            let is_apart = items[at - 1].layout == Layout::Space(Space::Wide);
            is_last && is_apart && is_unit(word)
                || is_last
                    && ["by", "using", "from", "since"]
                        .iter()
                        .any(|first| word.len() > first.len() + 3 && word.starts_with(first))
        }
        _ => false,
    }
}

/// A number, or a power of one.
fn is_figure(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(digits) => digits != "0",
        Layout::Scripts { nucleus, sub: None, sup: Some(_), .. } => matches!(nucleus.layout, Layout::Number(_)),
        _ => false,
    }
}

/// Whether a word is the name of a unit: `Dynes`, `turns`.
fn names_a_unit(word: &str) -> bool {
    const NAMES: [&str; 60] = [
        "db",
        "dba",
        "dbm",
        "dbi",
        "dbc",
        "dbv",
        "dbu",
        "dbfs",
        "np",
        "ft",
        "feet",
        "lb",
        "lbf",
        "oz",
        "gal",
        "btu",
        "mmhg",
        "torr",
        "mph",
        "fpm",
        "cfm",
        "bit",
        "byte",
        "photon",
        "count",
        "dollar",
        "dyne",
        "joule",
        "newton",
        "watt",
        "volt",
        "ohm",
        "amp",
        "ampere",
        "kelvin",
        "tesla",
        "gauss",
        "pascal",
        "meter",
        "metre",
        "hertz",
        "coulomb",
        "farad",
        "henry",
        "mole",
        "gram",
        "kilogram",
        "turn",
        "turns/m",
        "revolution",
        "cycle",
        "hp",
        "psi",
        "knot",
        "mile",
        "inch",
        "liter",
        "litre",
        "radian",
        "degree",
    ];
    let word = word.trim_end_matches(['.', ',', ';']).to_lowercase();
    NAMES
        .iter()
        .any(|name| word == *name || word.strip_suffix('s') == Some(name) || word.strip_suffix("es") == Some(name))
}

/// Whether a word is a quotient of short words, of which the first may be a unit: `J/bit`, `counts/s`.
fn is_rate_of_units(word: &str) -> bool {
    const LONGEST: usize = 10;
    let is_word = |part: &str| (1..=LONGEST).contains(&part.len()) && part.chars().all(char::is_alphabetic);
    let parts: Vec<&str> = word.trim_end_matches(['.', ',', ';']).split('/').collect();
    parts.len() == 2 && parts.iter().all(|part| is_word(part) && !is_prose(part))
}

/// Whether a word after a number is a unit, and no remark: `m/s`, `eV`, `days`.
fn is_unit(word: &str) -> bool {
    const UNITS: [&str; 64] = [
        "dB", "dBA", "dBm", "dBi", "dBc", "m", "cm", "mm", "km", "nm", "fm", "pm", "s", "ms", "ns", "min", "h", "kg",
        "g", "mg", "N", "kN", "J", "kJ", "MJ", "W", "kW", "MW", "eV", "keV", "MeV", "GeV", "TeV", "K", "Pa", "kPa",
        "MPa", "bar", "atm", "Hz", "kHz", "MHz", "GHz", "V", "kV", "A", "mA", "T", "C", "mol", "rad", "sr", "deg",
        "days", "day", "years", "year", "yr", "hours", "seconds", "rpm", "RPM", "Nm", "Js",
    ];
    let word = word.trim_end_matches(['.', ',', ';']);
    let is_one = |part: &str| {
        let unit =
            part.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, '^' | '-' | '−' | '²' | '³' | '{' | '}'));
        UNITS.contains(&unit)
    };
    !word.is_empty() && word.split(['/', '·', '*', '(', ')', '\u{a0}']).filter(|part| !part.is_empty()).all(is_one)
}
