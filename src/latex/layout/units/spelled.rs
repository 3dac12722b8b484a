//! The units that the letters of an upright word spell: `kg m/s^2`, `N·m`, `J/(kg K)`, `km`.

use crate::formula::units::Unit;
use crate::source::{Fault, Span};

use super::super::super::lexer::Space;
use super::super::item::{Delimiter, Item, Layout, Units};
use super::exponent;

/// The units that the argument of `\text` or `\mathrm` spells, if it spells nothing else. `is_text` says that it is `\text`.
pub(super) fn candidate(whole: &Item, argument: &Item, is_text: bool) -> Option<Units> {
    let items = match &argument.layout {
        Layout::Group(items) => items.as_slice(),
        _ => std::slice::from_ref(argument),
    };
    let mut units = product(items, argument.span)?;
    let letters = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).count();
    units.is_letter = !is_text && letters == 1;
    units.plain = vec![whole.clone()];
    Some(units)
}

/// A letter of a unit.
fn letter(item: &Item) -> Option<char> {
    match &item.layout {
        Layout::Letter(c) => Some(*c),
        Layout::Other(c @ ('µ' | '°' | 'Å' | '%')) => Some(*c),
        Layout::Other('Ω') => Some('Ω'),
        Layout::Command(name) => match name.as_str() {
            "\\mu" | "\\textmu" => Some('µ'),
            "\\Omega" | "\\textohm" => Some('Ω'),
            "\\AA" => Some('Å'),
            "\\%" => Some('%'),
            _ => None,
        },
        _ => None,
    }
}

/// The digit that a raised character is.
fn raised(item: &Item) -> Option<i32> {
    match item.layout {
        Layout::Other('¹') => Some(1),
        Layout::Other('²') => Some(2),
        Layout::Other('³') => Some(3),
        _ => None,
    }
}

/// A word, with the letters that may or may not touch, and its power.
struct Word {
    letters: String,
    /// Whether a macro wrote it, so that nobody knows where spaces are.
    is_unsure: bool,
    power: Option<i32>,
    span: Span,
}

fn product(items: &[Item], whole: Span) -> Option<Units> {
    let mut found = Units::none();
    let (mut at, mut by_slash) = (0, false);
    while at < items.len() {
        let item = &items[at];
        match &item.layout {
            Layout::Space(Space::Thin) | Layout::Other('$' | '·' | '⋅' | '*') => at += 1,
            Layout::Command(name) if name == "\\cdot" => at += 1,
            // The end of a sentence.
            Layout::Other('.') if at + 1 == items.len() && !found.factors.is_empty() => at += 1,
            Layout::Number(digits)
                if digits == "1"
                    && found.factors.is_empty()
                    && items.get(at + 1).is_some_and(|next| next.layout == Layout::Other('/')) =>
            {
                at += 1;
            }
            Layout::Other('/') if !by_slash => {
                by_slash = true;
                at += 1;
            }
            Layout::Fence(Delimiter::Round, inner) => {
                let inner = Units { divides: false, ..product(inner, item.span)? };
                found.join(inner, by_slash, whole);
                by_slash = false;
                at += 1;
            }
            _ => {
                let word = word(items, &mut at)?;
                found.join(unit(&word)?, by_slash, whole);
                by_slash = false;
            }
        }
    }
    (!found.factors.is_empty() && !by_slash).then_some(found)
}

/// Letters that touch, up to a power.
fn word(items: &[Item], at: &mut usize) -> Option<Word> {
    let mut word = Word { letters: String::new(), is_unsure: false, power: None, span: items[*at].span };
    let mut before: Option<&Item> = None;
    while let Some(item) = items.get(*at) {
        // `k$\Omega$`
        if item.layout == Layout::Other('$') && before.is_some_and(|before| before.span.end == item.span.start) {
            before = Some(item);
            *at += 1;
            continue;
        }
        let (nucleus, sup) = match &item.layout {
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => (&**nucleus, Some(sup)),
            _ => (item, None),
        };
        let Some(letter) = letter(nucleus) else { break };
        if let Some(before) = before {
            let is_after_command = matches!(before.layout, Layout::Command(_));
            let is_one_place = before.span == nucleus.span;
            if before.span.end != nucleus.span.start && !is_one_place && !is_after_command {
                break;
            }
            word.is_unsure |= is_one_place;
        }
        word.letters.push(letter);
        word.span = word.span.to(item.span);
        before = Some(nucleus);
        *at += 1;
        if let Some(sup) = sup {
            word.power = Some(exponent(sup)?);
            return Some(word);
        }
    }
    if let Some(power) = items.get(*at).and_then(raised).filter(|_| !word.letters.is_empty()) {
        word.power = Some(power);
        *at += 1;
    }
    (!word.letters.is_empty()).then_some(word)
}

fn unit(word: &Word) -> Option<Units> {
    let mut found = Units::none();
    found.factors.push((Unit::named(&word.letters)?, 1));
    let is_two = |at: usize| {
        let (first, second) = word.letters.split_at(at);
        Unit::named(first).is_some() && Unit::named(second).is_some()
    };
    if word.is_unsure && word.letters.char_indices().skip(1).any(|(at, _)| is_two(at)) {
        let message = format!("{} comes from a macro, and may be one unit or a product of two units", word.letters);
        found.fault =
            Some(Fault::ambiguous(word.span, message).help("in the macro, put \\, between the units of a product"));
    }
    if let Some(power) = word.power {
        found.raise(power, word.span);
    }
    Some(found)
}
