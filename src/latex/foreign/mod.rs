//! What people write by hand that is read only here, since there it has one sense: a function of a parenthesis with a power,
//! `\sin(x)^2`; functions of other languages; a number with a unit, `3\,\text{kg}`, or in degrees; a decimal comma; words
//! between statements; what a slash divides; separated differentials; and the sum of all forces.
//!
//! Offers `edits`, the changes of a text before it is read, and `quantity`, the length of a number with a unit. Knows names of LaTeX, and
//! no symbols.

mod differentials;
mod functions;
#[cfg(feature = "cli")]
mod italic;
mod slashes;
mod units;
mod words;

use crate::source::Span;

#[cfg(feature = "cli")]
pub use functions::WORDS as FUNCTION_WORDS;
pub use slashes::products_in_lines;
#[cfg(feature = "cli")]
pub use words::{says_or, separated};

use slashes::divided;
use units::{degrees, numbers, units};

/// The functions whose power may stand after the parenthesis.
const POWERED: [&str; 6] = ["\\sin", "\\cos", "\\tan", "\\cot", "\\sinh", "\\cosh"];

/// The edits of a text that make what is written by hand readable, in no order.
pub(super) fn edits(text: &str) -> Vec<(Span, String)> {
    let mut edits = Vec::new();
    edits.extend(functions::words(text));
    for function in POWERED {
        edits.extend(
            text.match_indices(function).filter_map(|(at, _)| power_moved(text, at + function.len())).flatten(),
        );
        edits.extend(text.match_indices(function).filter_map(|(at, _)| divided(text, at + function.len())).flatten());
    }
    edits.extend(slashes::time_in_exponents(text));
    edits.extend(differentials::rates(text));
    edits.extend(thousands(text));
    edits.extend(sums(text));
    edits.extend(slashes::colons(text));
    edits.extend(numbers(text).into_iter().filter_map(|number| {
        degrees(text, number).or_else(|| {
            let (end, size) = units(text, number.end)?;
            Some((Span::new(number.end, end), size.factor()))
        })
    }));
    edits.extend(units::groups(text).into_iter().filter_map(|group| {
        let (end, size) = units(text, group)?;
        Some((Span::new(group, end), size.factor()))
    }));
    edits
}

/// A text in which the letters of units after numbers, `4.2\,m/s^2`, stand upright; `None`, if there are none.
#[cfg(feature = "cli")]
pub fn with_upright_units(text: &str) -> Option<String> {
    let ends = numbers(text).into_iter().map(|number| number.end).chain(units::groups(text));
    let mut found: Vec<(Span, String)> = ends.filter_map(|end| italic::units_after(text, end)).collect();
    found.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    found.dedup();
    let mut new = text.to_owned();
    found.iter().for_each(|(span, upright)| new.replace_range(span.range(), upright));
    (!found.is_empty()).then_some(new)
}

/// Whether a text prints a number with decimals or with a unit, which somebody measured or computed.
#[cfg(feature = "cli")]
pub fn has_a_measured_number(text: &str) -> bool {
    units::is_measured(text)
}

/// The edits that make the sum of all of one kind a name: `\sum F = m a`, `\sum_k U_k = 0`.
fn sums(text: &str) -> Vec<(Span, String)> {
    let sum = |(at, _): (usize, &str)| {
        let mut start = units::skipped(text, at + "\\sum".len());
        let mut index = None;
        if let Some(below) = text[start..].strip_prefix('_') {
            let (inside, length) = match below.strip_prefix('{') {
                Some(inside) => units::braced(inside).map(|(inside, length)| (inside, length + 1))?,
                None => (&below[..below.chars().next()?.len_utf8()], below.chars().next()?.len_utf8()),
            };
            index = Some(inside.trim()).filter(|inside| inside.len() == 1);
            index?;
            start = units::skipped(text, start + 1 + length);
        }
        let end = slashes::factor(text, start).filter(|_| !text[start..].starts_with(|c: char| c.is_ascii_digit()))?;
        let after = text[units::skipped(text, end)..].trim_start();
        let is_all = after.is_empty() || after.starts_with(['=', '+', '-', '&', ',', '.', '<', '>']);
        let (base, sub) = text[start..end].split_once('_').unwrap_or((&text[start..end], ""));
        let sub = sub.trim_matches(['{', '}']);
        let is_indexed = index.is_none_or(|index| index == sub);
        let name = match sub {
            _ if index.is_some() => format!("{base}_{{sum}}"),
            "" => format!("{base}_{{sum}}"),
            sub => format!("{base}_{{sum,{sub}}}"),
        };
        (is_all && is_indexed).then(|| (Span::new(at, end), format!("{{{name}}}")))
    };
    text.match_indices("\\sum").filter_map(sum).collect()
}

/// The end of a letter, with its subscript, dots and primes, that stands at a place.
#[cfg(feature = "cli")]
pub fn quantity(text: &str, at: usize) -> Option<usize> {
    let dots = ["\\dot", "\\ddot"].iter().find_map(|dots| text[at..].strip_prefix(*dots));
    let Some(rest) = dots.filter(|rest| !rest.starts_with(|c: char| c.is_ascii_alphabetic())) else {
        let is_number = text[at..].starts_with(|c: char| c.is_ascii_digit());
        return slashes::factor(text, at).filter(|_| !is_number);
    };
    let inner = units::skipped(text, text.len() - rest.len());
    match text[inner..].strip_prefix('{') {
        Some(inside) => Some(inner + 1 + units::braced(inside)?.1),
        None => slashes::factor(text, inner),
    }
}

/// The edits that close the gap between groups of three digits, `10\,000`.
fn thousands(text: &str) -> Vec<(Span, String)> {
    let is_digit = |c: &u8| c.is_ascii_digit();
    let gap = |(at, mark): (usize, &str)| {
        let end = at + mark.len();
        let before = text.as_bytes()[..at].iter().rev().take_while(|c| is_digit(c)).count();
        let after = text.as_bytes()[end..].iter().take_while(|c| is_digit(c)).count();
        ((1..=3).contains(&before) && after == 3).then(|| (Span::new(at, end), String::new()))
    };
    text.match_indices("\\,").filter_map(gap).collect()
}

/// The edits that put the power after a parenthesis, `(x)^2`, before it; `from` is the end of the function.
fn power_moved(text: &str, from: usize) -> Option<[(Span, String); 2]> {
    let skipped = from + text[from..].len() - text[from..].trim_start().len();
    let rest = &text[skipped..];
    let rest_start = skipped + if rest.starts_with("\\left(") { "\\left".len() } else { 0 };
    if !text[rest_start..].starts_with('(') {
        return None;
    }
    let mut depth = 0i32;
    let mut close = None;
    for (at, c) in text[rest_start..].char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        if depth == 0 {
            close = Some(rest_start + at + 1);
            break;
        }
    }
    let after = &text[close?..];
    let start = close? + after.len() - after.trim_start().len();
    let power = text[start..].strip_prefix('^')?;
    let length = match power.starts_with('{') {
        true => power.find('}')? + 1,
        false => power.chars().next().filter(char::is_ascii_digit)?.len_utf8(),
    };
    let span = Span::new(start, start + 1 + length);
    Some([(Span::new(from, from), text[span.range()].to_owned()), (span, String::new())])
}

#[cfg(test)]
mod tests {
    use crate::latex::Macros;
    use crate::latex::rename::renamed;

    fn plain(text: &str) -> String {
        renamed(text, &Macros::default(), &std::collections::HashMap::new()).text
    }

    #[test]
    fn the_sum_of_all_forces_is_a_name() {
        assert_eq!(plain(r"\sum F = m a"), "{F_{sum}} = m a");
        assert_eq!(plain(r"\sum_k U_k = 0"), "{U_{sum}} = 0");
        assert_eq!(plain(r"\sum F_x = 0"), "{F_{sum,x}} = 0");
        // The twins: a sum with limits, of a product, over another index.
        for text in [r"\sum_{k=1}^{3} x_k = 0", r"\sum_i m_i x_i = 0", r"\sum_i F_k = 0"] {
            assert_eq!(plain(text), text);
        }
    }

    #[test]
    fn a_gap_between_groups_of_three_digits_is_closed() {
        assert_eq!(plain(r"R = 10\,000"), "R = 10000");
        for text in [r"R = 10\,00", r"R = 1000\,000", r"2\,x"] {
            assert_eq!(plain(text), text);
        }
    }

    #[test]
    fn a_power_after_the_parenthesis_of_a_function_belongs_to_the_function() {
        assert_eq!(plain(r"\sin(x)^2 + \cos\left(x\right)^{2}"), r"\sin^2(x) + \cos^{2}\left(x\right)");
        assert_eq!(plain(r"\sin(x^2) (y)^2"), r"\sin(x^2) (y)^2");
    }
}
