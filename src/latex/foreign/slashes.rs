//! What a slash or a colon divides, where people mean one thing: `\sin\alpha/k` divides the sine.

use crate::latex::names::is_letter;
use crate::source::Span;

use super::units::{braced, skipped};

/// Letters that are angles: nobody means the sine of their quotient by a length.
const ANGLES: [&str; 14] = [
    "\\alpha",
    "\\beta",
    "\\gamma",
    "\\delta",
    "\\theta",
    "\\vartheta",
    "\\phi",
    "\\varphi",
    "\\psi",
    "\\chi",
    "\\eta",
    "\\epsilon",
    "\\varepsilon",
    "\\xi",
];

/// The edits that enclose the argument of a function which is divided by a parenthesis, by another function, or, if it is an
/// angle, by a letter: `\sin\alpha/(M+m)`, `\sin\alpha/k`. Nobody means the sine of that quotient. `from` is the end of the
/// function.
pub(super) fn divided(text: &str, from: usize) -> Option<[(Span, String); 2]> {
    let skip = |at: usize| at + text[at..].len() - text[at..].trim_start().len();
    let mut start = skip(from);
    if text[start..].starts_with('^') {
        let power = &text[start + 1..];
        let length = match power.starts_with('{') {
            true => power.find('}')? + 1,
            false => power.chars().next().filter(char::is_ascii_digit)?.len_utf8(),
        };
        start = skip(start + 1 + length);
    }
    let argument = text[start..].strip_prefix('\\').unwrap_or(&text[start..]);
    let is_command = argument.len() < text[start..].len();
    let letters = argument.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(argument.len());
    let length = if is_command { 1 + letters } else { letters.min(1) };
    let end = start + length;
    let after = text[skip(end)..].strip_prefix('/')?.trim_start();
    let is_enclosed = ["(", "\\left(", "\\sin", "\\cos", "\\tan"].iter().any(|below| after.starts_with(below));
    let is_angle = ANGLES.contains(&&text[start..end]) && after.starts_with(|c: char| c.is_ascii_alphabetic());
    (letters > 0 && (is_enclosed || is_angle))
        .then(|| [(Span::new(start, start), "(".to_owned()), (Span::new(end, end), ")".to_owned())])
}

/// The edits that put the time beside the quotient before it, where it is the last factor in an exponent: `e^{-k/m t}`. What
/// else stands below a slash in an exponent, the reader says for all texts.
pub(super) fn time_in_exponents(text: &str) -> Vec<(Span, String)> {
    let mut edits = Vec::new();
    for (at, _) in text.match_indices("^{") {
        let start = at + "^{".len();
        let Some((inside, length)) = braced(&text[start..]) else { continue };
        let end = start + length - "}".len();
        for (slash, _) in inside.match_indices('/') {
            let factors = factors(&text[..end], start + slash + 1);
            let [_, last] = factors.as_slice() else { continue };
            let rest = text[last.end..end].trim_start();
            if &text[last.range()] == "t" && (rest.is_empty() || rest.starts_with(['+', '-', ')', ']'])) {
                edits.push((Span::new(last.start, last.start), "\\cdot ".to_owned()));
            }
        }
    }
    edits
}

/// The edits that enclose the product directly after a slash: in a line of text `1/k_BT` has k_B T below the slash. Where a space
/// stands in the product, a number is over a number, as in `1/2mv^2`, or a variable is last, as in `k/mx`, there is none.
pub fn products_in_lines(text: &str) -> Vec<(Span, String)> {
    let mut edits = Vec::new();
    for (slash, _) in text.match_indices('/') {
        let start = slash + 1;
        let mut factors: Vec<Span> = Vec::new();
        let mut end = start;
        while let Some(next) = factor(text, end) {
            factors.push(Span::new(end, next));
            end = match &text[end..next] {
                command if command.starts_with('\\') && !command.contains('_') => skipped(text, next),
                _ => next,
            };
            end = power(text, end).unwrap_or(end);
        }
        let last = factors.last().map(|last| &text[last.range()]);
        let is_number = |c: char| c.is_ascii_digit();
        // A power, as in p^2/2m, is no number over a number.
        let above = text[..slash].trim_end_matches(is_number);
        let is_over_a_number = above.len() < slash && !above.ends_with('^');
        let divides_numbers = is_over_a_number && text[start..].starts_with(is_number);
        let names_a_variable = last.is_some_and(|last| ["t", "x", "y", "z"].contains(&last));
        let has_differential = factors.iter().any(|factor| ["d", "e"].contains(&&text[factor.range()]));
        let rest = &text[end..];
        let ends = rest.is_empty() || rest.starts_with([' ', '+', '-', ')', ']', '}', '=', ',', '.', ';']);
        if factors.len() > 1 && ends && !divides_numbers && !names_a_variable && !has_differential {
            edits.push((Span::new(start, start), "(".to_owned()));
            edits.push((Span::new(end, end), ")".to_owned()));
        }
    }
    edits
}

/// The end of a power with a number, `^2` or `^{2}`.
fn power(text: &str, at: usize) -> Option<usize> {
    let script = text[at..].strip_prefix('^')?;
    match script.strip_prefix('{') {
        Some(_) => {
            braced(script).filter(|(inside, _)| inside.chars().all(|c| c.is_ascii_digit())).map(|(_, n)| at + 1 + n)
        }
        None => script.starts_with(|c: char| c.is_ascii_digit()).then_some(at + 2),
    }
}

/// The edits that make a colon between two quantities a slash: `r = V_1 : V_2`.
pub(super) fn colons(text: &str) -> Vec<(Span, String)> {
    let divides = |at: &usize| {
        let (before, after) = (text[..*at].trim_end(), skipped(text, at + 1));
        let starts = before.char_indices().map(|(start, _)| start).rev().take(20);
        let is_quantity = starts.filter(|start| factor(text, *start) == Some(before.len())).last();
        let is_after_equality = is_quantity.is_some_and(|start| before[..start].trim_end().ends_with('='));
        is_after_equality && factor(text, after).is_some_and(|end| text[skipped(text, end)..].trim().is_empty())
    };
    let places = text.match_indices(':').map(|(at, _)| at);
    places.filter(divides).map(|at| (Span::new(at, at + 1), "/".to_owned())).collect()
}

/// The plain factors that stand side by side from a place on: letters with their subscripts, and numbers. None, if something
/// else, as a parenthesis, stands among them.
fn factors(text: &str, from: usize) -> Vec<Span> {
    let mut found = Vec::new();
    let mut at = skipped(text, from);
    while let Some(end) = factor(text, at) {
        found.push(Span::new(at, end));
        at = skipped(text, end);
    }
    found
}

/// The end of a letter with its subscript, or of a number.
pub(super) fn factor(text: &str, at: usize) -> Option<usize> {
    let rest = &text[at..];
    let first = rest.chars().next()?;
    if first.is_ascii_digit() {
        return Some(at + rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len()));
    }
    let mut end = match (first, rest.strip_prefix('\\')) {
        (_, Some(command)) => {
            let letters = command.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(command.len());
            if letters == 0 || !is_letter(&format!("\\{}", &command[..letters])) {
                return None;
            }
            at + 1 + letters
        }
        (first, None) if first.is_ascii_alphabetic() => at + 1,
        _ => return None,
    };
    if let Some(sub) = text[end..].strip_prefix('_') {
        end += 1 + match sub.strip_prefix('{') {
            Some(inside) => 1 + braced(inside)?.1,
            None if sub.starts_with('\\') => {
                1 + sub[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(sub.len() - 1)
            }
            None => sub.chars().next()?.len_utf8(),
        };
    }
    while text[end..].starts_with('\'') {
        end += 1;
    }
    Some(end)
}

#[cfg(test)]
mod tests {
    use crate::latex::Macros;
    use crate::latex::rename::renamed;

    fn plain(text: &str) -> String {
        renamed(text, &Macros::default(), &std::collections::HashMap::new()).text
    }

    #[test]
    fn the_time_after_a_quotient_in_an_exponent_stands_beside_it() {
        assert_eq!(plain(r"e^{-k/m t}"), r"e^{-k/m \cdot t}");
        // The twins: the time above, one factor, three factors, no exponent.
        for text in [r"e^{-t/RC}", r"e^{-t/\tau}", r"e^{-k/m l t}", r"k/m t", r"e^{-x/l \cos x}"] {
            assert_eq!(plain(text), text);
        }
    }

    #[test]
    fn a_colon_between_two_quantities_divides() {
        assert_eq!(plain(r"r = V_1 : V_2"), r"r = V_1 / V_2");
        // The twins: a definition, a colon after a condition, a map.
        for text in ["r := V_1", "x = 0: y = 1", "f : a"] {
            assert_eq!(plain(text), text);
        }
    }

    #[test]
    fn a_slash_after_the_sine_of_an_angle_divides_the_sine() {
        assert_eq!(plain(r"mg\sin\alpha / k"), r"mg\sin(\alpha) / k");
        // The twins: half of an angle, and a length in units of another one.
        for text in [r"\sin\alpha/2", r"\sin x/L", r"\cos\omega/n"] {
            assert_eq!(plain(text), text);
        }
    }

    #[test]
    fn a_slash_in_a_line_of_text_divides_by_what_stands_directly_after_it() {
        let enclosed = |text: &str| {
            let mut edits = super::products_in_lines(text);
            edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
            edits.into_iter().fold(text.to_owned(), |mut text, (span, new)| {
                text.replace_range(span.range(), &new);
                text
            })
        };
        assert_eq!(enclosed(r"\beta = 1/k_BT"), r"\beta = 1/(k_BT)");
        assert_eq!(enclosed(r"E = p^2/2m"), r"E = p^2/(2m)");
        assert_eq!(enclosed(r"k = q/4\pi r^2 + 1"), r"k = q/(4\pi r^2) + 1");
        // The twins: one factor, a half, a space, a variable, a root.
        for text in ["1/T", "1/2mv^2", "k/m x", "k/mx", r"1/2\pi\sqrt{LC}", "a/b^{n}c", "dx/dt"] {
            assert_eq!(enclosed(text), text);
        }
    }
}
