//! Rates for the acceleration of the problem: `\ddot x` or `\dot v` where the problem says "the acceleration $a$" and nothing in it
//! moves.

use crate::latex::foreign;
use crate::latex::names;
use crate::notes::Notes;
use crate::source::Span;

use super::Written;
use super::single_letters::single;
use crate::check::mark::names::{Names, Role};

/// Words for an acceleration, and beginnings of such words, in some languages.
const ACCELERATION: [&str; 6] =
    ["acceleration", "beschleunigung", "accélération", "aceleración", "accelerazione", "przyspieszeni"];

/// What stands before them where they are those of an angle.
const OF_AN_ANGLE: [&str; 4] = ["angular ", "winkel", "angulaire", "angular"];

/// Lengths with a rate of second order, and speeds with one of first order.
const RATES: [(&str, &str); 8] = [
    ("\\ddot", "x"),
    ("\\ddot", "y"),
    ("\\ddot", "z"),
    ("\\ddot", "s"),
    ("\\ddot", "u"),
    ("\\dot", "v"),
    ("\\dot", "u"),
    ("\\dot", "w"),
];

/// Replaces rates by the letter that the problem has for the acceleration, where the hand-in has no other rates, and the length only
/// in its rate.
pub(in crate::check::mark) fn named(lines: &mut [Written], known: &Names, problem: &Notes) {
    let moves = known.names.iter().any(|(_, role, _)| *role == Role::Moving);
    let Some(letter) = the_acceleration(&problem.source.text, known).filter(|_| !moves) else { return };
    let found: Vec<Vec<Span>> = lines.iter().map(|line| rates(&line.text)).collect();
    let count = |text: &str, mark: &str| text.matches(mark).count();
    let has_others = lines.iter().zip(&found).any(|(line, own)| {
        count(&line.text, "\\dot") + count(&line.text, "\\ddot") + count(&line.text, "\\frac{d") > own.len()
    });
    let in_a_rate = |at: usize, span: Span| found[at].iter().any(|rate| rate.contains(span));
    let stands_alone = |(_, length): &(&str, &str)| {
        lines.iter().enumerate().any(|(at, line)| single(&line.text, length).iter().any(|span| !in_a_rate(at, *span)))
    };
    let is_used =
        |rate: &&(&str, &str)| rate.0 == "\\ddot" && lines.iter().any(|line| !rates_of(&line.text, rate).is_empty());
    if has_others || RATES.iter().filter(is_used).any(stands_alone) {
        return;
    }
    for (line, spans) in lines.iter_mut().zip(found) {
        line.edits.extend(spans.into_iter().map(|span| (span, format!("{{{letter}}}"))));
    }
}

/// The letter of the acceleration in the text of a problem.
fn the_acceleration(text: &str, known: &Names) -> Option<String> {
    let small = text.to_lowercase();
    let after = |word: &str| {
        small.match_indices(word).find_map(|(at, _)| {
            let is_of_angle = OF_AN_ANGLE.iter().any(|before| small[..at].ends_with(before));
            // In small letters a text may have another length.
            let rest = text.get(at + word.len()..)?;
            let rest = rest.trim_start_matches(|c: char| c.is_alphabetic()).trim_start().strip_prefix('$')?;
            let (name, _) = rest.split_once('$')?;
            let parsed = names::parse(name.trim())?.0;
            (!is_of_angle && known.fixed.contains(&parsed)).then(|| name.trim().to_owned())
        })
    };
    ACCELERATION.iter().find_map(|word| after(word))
}

/// The places of all rates in a text.
fn rates(text: &str) -> Vec<Span> {
    RATES.iter().flat_map(|rate| rates_of(text, rate)).collect()
}

/// The places of one rate, `\ddot x` or `\ddot{x}`, in a text.
fn rates_of(text: &str, (dots, length): &(&str, &str)) -> Vec<Span> {
    let place = |(at, _): (usize, &str)| {
        let rest = &text[at + dots.len()..];
        let is_command = rest.starts_with(|c: char| c.is_ascii_alphabetic());
        let end = foreign::quantity(text, at)?;
        let inside = text[at + dots.len()..end].trim().trim_start_matches('{').trim_end_matches('}').trim();
        (!is_command && inside == *length).then(|| Span::new(at, end))
    };
    text.match_indices(dots).filter_map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::rates;

    #[test]
    fn rates_of_lengths_and_speeds_are_found() {
        let of = |text: &str| rates(text).into_iter().map(|span| text[span.range()].to_owned()).collect::<Vec<_>>();
        assert_eq!(of(r"m\ddot x = F - m\dot{v}"), [r"\ddot x", r"\dot{v}"]);
        // The twins: a velocity, an angle, a name with a subscript.
        for text in [r"\dot x", r"\ddot\theta", r"\ddot{x_1}"] {
            assert!(of(text).is_empty(), "{text}");
        }
    }
}
