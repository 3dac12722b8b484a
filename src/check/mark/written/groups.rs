//! Primes behind parentheses, `(x_1 + x_2)''`, as rates of what stands inside.

use super::Written;
use crate::source::Span;

/// Writes such rates as derivatives by the time.
pub(in crate::check::mark) fn with_rates(lines: &mut [Written]) {
    for line in lines {
        for (open, primes, order) in primed_groups(&line.text) {
            let by_time = if order == 1 { "\\frac{d}{dt}" } else { "\\frac{d^2}{dt^2}" };
            line.edits.push((Span::new(open, open), by_time.to_owned()));
            line.edits.push((primes, String::new()));
        }
    }
}

/// The place before each group with one or two primes, the place of the primes, and their number. What stands behind a letter is an
/// argument, and no group.
fn primed_groups(text: &str) -> Vec<(usize, Span, usize)> {
    let mut found = Vec::new();
    let mut opened: Vec<usize> = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '(' => opened.push(at),
            ')' => {
                let Some(open) = opened.pop() else { continue };
                let order = text[at + 1..].len() - text[at + 1..].trim_start_matches('\'').len();
                let before = text[..open].strip_suffix("\\left").unwrap_or(&text[..open]);
                let is_sized = before.len() < open;
                let is_argument = before.trim_end().ends_with(|c: char| c.is_alphabetic() || "}])'".contains(c));
                let is_closed_so = text[..at].ends_with("\\right") == is_sized;
                if (1..=2).contains(&order) && !is_argument && is_closed_so {
                    found.push((before.len(), Span::new(at + 1, at + 1 + order), order));
                }
            }
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::primed_groups;

    #[test]
    fn groups_with_primes_are_found() {
        let of = |text: &str| primed_groups(text).into_iter().map(|(open, _, order)| (open, order)).collect::<Vec<_>>();
        assert_eq!(of("(x + y)'' = 0"), [(0, 2)]);
        assert_eq!(of(r"2 \left(x + y\right)' = 0"), [(2, 1)]);
        // The twins: an argument, a group without primes, three primes.
        for text in ["f(x)' = 0", r"\sin(x)'", "(x + y) = x'", "(x)'''"] {
            assert!(of(text).is_empty(), "{text}");
        }
    }
}
