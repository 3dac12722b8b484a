//! Neighbours that print as something else than a product: letters that spell a function or a word, such as `sin x`, `log y`,
//! `KE`, `speed`, and numbers, `2 3`.
//!
//! In print these are upright or stand apart, and nobody means the product of their letters. So a run of letters
//! without a space between them is rejected if it has the name of a function in it. Without declarations, usual words are
//! rejected too. For a product, a space or `\,` between the letters is enough.

use crate::formula::symbols::Symbols;
use crate::formula::tree::Function;
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout, is_name_of_letters, typed};
use super::super::names;
use super::items::{is_number, is_numeric, is_numeric_item};
use super::state::{Read, Reader};

/// Functions that may stand anywhere in a run, `mgsin`.
const FUNCTIONS: [&str; 9] = ["sin", "cos", "tan", "cot", "sec", "csc", "exp", "log", "sqrt"];

/// Functions and operators that begin or end a run, `xmax`.
const OPERATORS: [&str; 14] =
    ["det", "max", "min", "arg", "sgn", "lim", "sup", "inf", "dim", "mod", "erf", "div", "rot", "curl"];

/// Functions that are a whole run.
const SHORT: [&str; 3] = ["ln", "lg", "tg"];

/// Numbers without a unit, which have two letters: Reynolds, Nusselt, Prandtl, …; and the parts of a complex number.
const NUMBERS: [&str; 18] =
    ["Re", "Im", "Nu", "Pr", "Gr", "Ra", "Fr", "Bo", "Bi", "Pe", "We", "Sh", "Kn", "Oh", "Ja", "Ro", "Ec", "Wi"];

/// The most letters beside the name of a function in a run of letters that may be a product.
const LONGEST_FACTORS: usize = 2;

/// Words that are a whole run.
const WORDS: [&str; 59] = [
    "and", "or", "of", "to", "so", "no", "for", "the", "with", "where", "if", "is", "in", "it", "not", "let", "then",
    "when", "else", "all", "any", "are", "from", "rad", "deg", "sum", "mol", "avg", "net", "tot", "kin", "pot", "vel",
    "pos", "acc", "old", "new", "out", "KE", "PE", "ME", "GPE", "EPE", "NTU", "FWHM", "RMS", "SNR", "COP", "EMF", "SG",
    "CoV", "MSE", "DOF", "GWP", "MTF", "SFC", "LHV", "emf", "pH",
];

/// Energies that are a whole run.
const ENERGIES: [&str; 5] = ["KE", "PE", "ME", "GPE", "EPE"];

/// Rejects runs of letters that spell a function or, without declarations, a word. In a display of operators, the name
/// of a number without a unit must be the whole run.
pub(super) fn are_no_words(items: &[Item], symbols: &Symbols) -> Read<()> {
    let mut at = 0;
    while at < items.len() {
        let Some((word, span, length)) = run_of_letters(items, at) else {
            at += 1;
            continue;
        };
        at += length - 1;
        // `tr(A)^2`: the trace, or t times r(A).
        let is_before_parenthesis = items.get(at + 1).is_some_and(|next| match &next.layout {
            Layout::Scripts { nucleus, .. } => is_parenthesis(nucleus),
            _ => is_parenthesis(next),
        });
        if symbols.open && is_before_parenthesis && ["tr", "Tr"].contains(&word.as_str()) {
            return Err(Fault::ambiguous(span, format!("{word} may be the trace or a product"))
                .help("write \\operatorname{tr} for the trace, and a space \\, between the letters of a product"));
        }
        let has_index = matches!(items[at].layout, Layout::Scripts { sub: Some(_), .. });
        // `A = USV^T`: what has a script is no letter of a word.
        let is_plain = matches!(items[at].layout, Layout::Letter(_));
        at += 1;
        // `ad_V` is the adjoint; `ad - bc` has no index.
        if symbols.open && has_index && (word == "ad" || word == "Ad") {
            return Err(Fault::ambiguous(span, format!("{word} may be the adjoint operator or a product")).help(
                format!(
                    "write \\operatorname{{{word}}} for the operator, and a space \\, between the letters of a product"
                ),
            ));
        }
        is_no_word(&word, span, symbols)?;
        if symbols.open && is_plain && is_short_form(&word) {
            return Err(name_or_product(&word, span));
        }
    }
    Ok(())
}

/// The letters that begin at an item with no space between them, their place, and the number of items.
pub(super) fn run_of_letters(items: &[Item], at: usize) -> Option<(String, Span, usize)> {
    let (mut word, mut span) = items.get(at).and_then(start)?;
    let mut last = at;
    while matches!(items[last].layout, Layout::Letter(_))
        && let Some((next, place)) = items.get(last + 1).and_then(start)
        && (place.start == span.end || place == span)
    {
        word.push_str(&next);
        span = span.to(place);
        last += 1;
    }
    Some((word, span, last + 1 - at))
}

/// Whether a word is the end of a number as programs write it: the `e-5` of `8.62e-5`.
pub(in super::super) fn is_power_in_a_program(word: &str) -> bool {
    let Some(power) = word.strip_prefix(['e', 'E']) else { return false };
    let digits = power.trim_start_matches(['-', '+', '−']);
    !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit())
}

/// The letter that an item is or begins with, and its place.
fn start(item: &Item) -> Option<(String, Span)> {
    match &item.layout {
        Layout::Letter(c) => Some((c.to_string(), item.span)),
        // The e of an exponential is no letter of a name: `Pe^{-i\omega t}`.
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
            if nucleus.layout == Layout::Letter('e') && !is_numeric(sup) =>
        {
            None
        }
        Layout::Scripts { nucleus, .. } => match nucleus.layout {
            Layout::Letter(c) => Some((c.to_string(), nucleus.span)),
            _ => None,
        },
        _ => None,
    }
}

fn is_no_word(word: &str, span: Span, symbols: &Symbols) -> Read<()> {
    let (open, is_abstract, is_guessed) = (symbols.open, symbols.is_abstract(), symbols.guessed);
    let apart = "for a product, put a space \\, between the letters";
    // `e^{it}`
    if word == "it" && symbols.imaginary_here {
        return Ok(());
    }
    if symbols.inferred.segments.contains(word) {
        return Err(Fault::ambiguous(span, format!("{word} may be the length between two points or a product"))
            .help(format!("write |\\overrightarrow{{{word}}}| for the length; {apart}")));
    }
    let function = FUNCTIONS.iter().find(|name| word.contains(**name));
    if let Some(name) = function.or(SHORT.iter().find(|name| word == **name)) {
        let help = match *name == "sqrt" || Function::named(name).is_some() {
            true => format!("write {} for the function; {apart}", command_of(word, name)),
            false => apart.to_owned(),
        };
        if word.len() > name.len() + LONGEST_FACTORS {
            return Err(Fault::ambiguous(span, format!("{word} may be a word of the text or a product"))
                .help(format!("end the formula before the word, or write \\text{{{word}}}; {apart}")));
        }
        return Err(Fault::ambiguous(span, format!("{word} may be a function or a product")).help(help));
    }
    if let Some(name) = OPERATORS.iter().find(|name| word.starts_with(**name) || word.ends_with(**name)) {
        return Err(Fault::ambiguous(span, format!("{word} may contain the operator {name} or be a product"))
            .help(format!("{name} is not supported; {apart}")));
    }
    // `HHV`, `ESS`: nobody multiplies a capital by itself without a power. `VSWR`: nor four different ones.
    let letters = word.as_bytes();
    let are_capitals = letters.len() > 2 && letters.iter().all(u8::is_ascii_uppercase);
    let has_capitals = are_capitals && (letters.len() > 3 || letters.windows(2).any(|pair| pair[0] == pair[1]));
    let is_lower = |c: char| c.is_ascii_lowercase();
    let is_long = word.len() >= 4
        && word.chars().skip(1).all(is_lower)
        && word.to_ascii_lowercase().contains(['a', 'e', 'i', 'o', 'u']);
    let has_number = NUMBERS.iter().any(|name| if is_abstract { word == *name } else { word.contains(name) });
    // Without a declaration that anybody confirmed, KE is the kinetic energy.
    let is_energy = is_guessed && ENERGIES.contains(&word);
    if is_energy || open && (is_long || has_capitals || has_number || WORDS.contains(&word) || is_name_of_letters(word))
    {
        if names::is_letter(&format!("\\{word}")) {
            return Err(Fault::ambiguous(span, format!("{word} may be the letter \\{word} or a product"))
                .help(format!("write \\{word} for the letter; {apart}")));
        }
        return Err(name_or_product(word, span));
    }
    Ok(())
}

fn name_or_product(word: &str, span: Span) -> Fault {
    Fault::ambiguous(span, format!("{word} may be a name or a product")).help(format!(
        "write a word as \\text{{{word}}}, and a name as a letter with a subscript, such as E_{{kin}}; for a product, put a space \\, \
         between the letters"
    ))
}

/// Whether three capitals are a short form more often than a product, `ROC`, `SOC`: they differ, and one of them hardly ever is a
/// factor among capitals. `BIL` and `PVT` are products.
fn is_short_form(word: &str) -> bool {
    let letters = word.as_bytes();
    let differ = letters.len() == 3 && letters[0] != letters[1] && letters[1] != letters[2] && letters[0] != letters[2];
    differ && letters.iter().all(u8::is_ascii_uppercase) && word.contains(['O', 'W', 'S', 'U', 'D'])
}

/// The command of a function that is written as a word: `asin` is the inverse of the sine.
fn command_of(word: &str, name: &str) -> String {
    let inverse = word.strip_prefix("arc").or_else(|| word.strip_prefix('a')).filter(|rest| *rest == name);
    match inverse {
        Some(rest) if ["sin", "cos", "tan"].contains(&rest) => format!("\\arc{rest}"),
        _ if name == "sqrt" => "\\sqrt{…}".to_owned(),
        _ => format!("\\{name}"),
    }
}

/// The advice for a number that stands after a symbol.
pub(super) fn after_a_symbol(number: &Item) -> String {
    let digits = typed(std::slice::from_ref(number));
    let digits = digits.trim_matches(['{', '}', ' ']);
    format!("write x_{digits}, x^{digits} or {digits}x; write \\cdot for the product of two numbers")
}

impl Reader<'_> {
    /// Rejects neighbouring factors that print as something else: `2 3`, `2\frac12`, `|a|b|c|`.
    pub(super) fn run_together(&self, items: &[Item], at: usize) -> Read<()> {
        let before = items[..at].iter().rev().find(|item| !matches!(item.layout, Layout::Space(_)));
        let Some(before) = before else { return Ok(()) };
        let item = &items[at];
        let span = before.span.to(item.span);
        // `2\sqrt{3}` is a product, and no mixed number.
        let is_fraction = is_numeric_item(item) && !matches!(item.layout, Layout::Root(..));
        if matches!(before.layout, Layout::Number(_)) && (is_fraction || is_number(item)) {
            return Err(two_numbers(before, item, is_fraction));
        }
        let touches = !matches!(items[at - 1].layout, Layout::Space(_));
        // A solid angle, `(a + b)4\pi r^2`, is a factor.
        // So is `m 4\pi r^2` with a space.
        let is_pi = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\pi");
        let is_apart = item.span.start > before.span.end && items.get(at + 1).is_some_and(is_pi);
        let is_factor = is_apart || is_parenthesis(before) && items.get(at + 1).is_some_and(is_numeric);
        let is_name = || names::printed(before, self.branch).is_some();
        if touches && is_number(item) && !is_factor && (is_name() || is_parenthesis(before)) {
            return Err(Fault::ambiguous(span, "a number after a symbol may be a subscript, a power or a factor")
                .help(after_a_symbol(item)));
        }
        if touches && is_uncertainty(before, item) {
            return Err(Fault::ambiguous(
                span,
                "a number in parentheses may be a factor, or how far the last digits are uncertain",
            )
            .help("write \\cdot for a product, or leave the uncertainty out"));
        }
        let is_bar = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::PlainBar, _));
        if is_bar(item) && !is_bar(before) && items[..at].iter().any(is_bar) {
            return Err(
                Fault::ambiguous(span, "|a|b|c| may be |a|·b·|c| or |a·|b|·c|").help("use \\left| and \\right|")
            );
        }
        Ok(())
    }
}

/// The fault of two numbers side by side: `2 3`, `2\frac12`, `1.2.3`.
fn two_numbers(before: &Item, item: &Item, is_fraction: bool) -> Fault {
    let span = before.span.to(item.span);
    let (first, second) = (typed(std::slice::from_ref(before)), typed(std::slice::from_ref(item)));
    if second.starts_with('.') && before.span.end == item.span.start {
        return Fault::new(span, format!("{first}{second} is not a number"))
            .help("write one decimal point in a number");
    }
    match is_fraction {
        true => Fault::ambiguous(
            span,
            format!("{first}{second} may be the product {first}·{second} or the sum {first} + {second}"),
        )
        .help("write \\cdot or + between them"),
        false => Fault::ambiguous(
            span,
            format!("{first} {second} may be the product {first}·{second} or the number {first}{second}"),
        )
        .help("write \\cdot between them"),
    }
}

fn is_parenthesis(item: &Item) -> bool {
    matches!(item.layout, Layout::Fence(Delimiter::Round | Delimiter::Square | Delimiter::Curly, _))
}

/// Whether these are a number with decimals and a whole number in parentheses, as 9.81(2).
fn is_uncertainty(number: &Item, item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    let digits = |item: &Item| match &item.layout {
        Layout::Number(digits) => Some(digits.contains('.')),
        _ => None,
    };
    digits(number) == Some(true) && matches!(inside.as_slice(), [only] if digits(only) == Some(false))
}
