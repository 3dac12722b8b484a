//! Separated differentials: `\frac{dq}{q} = -\frac{dt}{RC}` says what it says of rates, `\frac{\dot q}{q} = -\frac{1}{RC}`.

use crate::source::Span;

use super::slashes::factor;
use super::units::skipped;

/// The edits that make the differentials of an equality rates; none, where a derivative or an integral stands, or where a
/// term has no differential.
pub(super) fn rates(text: &str) -> Vec<(Span, String)> {
    let found = differentials(text);
    let is_other =
        ["\\int", "\\partial", "\\delta", "\\dot", "\\oint", "\\iint"].iter().any(|other| text.contains(other));
    let sides: Vec<&str> = text.split('=').collect();
    if is_other || sides.len() < 2 || found.len() < 2 || sides.len() > found.len() || is_derivative(text, &found) {
        return Vec::new();
    }
    let mut start = 0;
    for side in sides {
        let side = Span::new(start, start + side.len());
        start = side.end + 1;
        // One differential in each term.
        let terms = terms(text, side);
        let one = |term: &Span| found.iter().filter(|(place, _)| term.contains(*place)).count() == 1;
        if !terms.iter().all(one) {
            return Vec::new();
        }
    }
    found
        .into_iter()
        .map(|(place, of)| {
            let new = match &text[of.range()] {
                "t" if is_alone(text, place) => "1".to_owned(),
                "t" => String::new(),
                name => format!("\\dot{{{name}}}"),
            };
            (place, new)
        })
        .collect()
}

/// The differentials in a text, each with the name of which it is one.
fn differentials(text: &str) -> Vec<(Span, Span)> {
    let mut found: Vec<(Span, Span)> = Vec::new();
    let mut at = 0;
    while let Some(step) = text[at..].chars().next().map(char::len_utf8) {
        let sign = ["\\mathrm{d}", "\\mathrm d", "\\text{d}", "d"].iter().find(|sign| text[at..].starts_with(**sign));
        let before = &text[..at];
        let word = before.len() - before.trim_end_matches(|c: char| c.is_ascii_alphabetic()).len();
        let is_inside = before.ends_with('_')
            || before[..before.len() - word].ends_with('\\')
            || before.rfind("\\text{").is_some_and(|open| !before[open..].contains('}'));
        let name = sign.map(|sign| skipped(text, at + sign.len()));
        let is_letter = |at: &usize| !text[*at..].starts_with(|c: char| c.is_ascii_digit());
        match name.filter(is_letter).and_then(|name| Some((name, factor(text, name)?))) {
            Some((name, end)) if !is_inside => {
                found.push((Span::new(at, end), Span::new(name, end)));
                at = end;
            }
            _ => at += step,
        }
    }
    found
}

/// Whether a differential stands below a fraction line: then it is a part of a derivative.
fn is_derivative(text: &str, found: &[(Span, Span)]) -> bool {
    found.iter().any(|(place, _)| {
        let before = text[..place.start].trim_end();
        // `}{dt}` is below a line, and so is `/dt`.
        before.ends_with('/') || before.strip_suffix('{').is_some_and(|outer| outer.trim_end().ends_with('}'))
    })
}

/// Whether a differential is all of what stands in braces, or all of a side.
fn is_alone(text: &str, place: Span) -> bool {
    let (before, after) = (text[..place.start].trim_end(), text[place.end..].trim_start());
    let opens = before.is_empty() || before.ends_with(['{', '=', '+', '-', '(']);
    let closes = after.is_empty() || after.starts_with(['}', '=', '+', '-', ')', ',', '.']);
    opens && closes
}

/// The terms of a side: what stands between signs outside of braces and parentheses.
fn terms(text: &str, side: Span) -> Vec<Span> {
    let mut depth = 0i32;
    let (mut found, mut start) = (Vec::new(), side.start);
    for (at, c) in text[side.range()].char_indices() {
        let at = side.start + at;
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => depth -= 1,
            '+' | '-' if depth == 0 => {
                if !text[start..at].trim().is_empty() {
                    found.push(Span::new(start, at));
                }
                start = at + 1;
            }
            _ => {}
        }
    }
    found.push(Span::new(start, side.end));
    found
}

#[cfg(test)]
mod tests {
    use crate::latex::Macros;
    use crate::latex::rename::renamed;

    fn plain(text: &str) -> String {
        renamed(text, &Macros::default(), &std::collections::HashMap::new()).text
    }

    #[test]
    fn separated_differentials_are_rates() {
        assert_eq!(plain(r"\frac{dq}{q} = -\frac{dt}{RC}"), r"\frac{\dot{q}}{q} = -\frac{1}{RC}");
        assert_eq!(
            plain(r"\frac{\mathrm{d}Q_1}{C U_0 - Q_1} = \frac{\mathrm{d}t}{RC}"),
            r"\frac{\dot{Q_1}}{C U_0 - Q_1} = \frac{1}{RC}"
        );
        assert_eq!(plain(r"dW = R I^2\,dt"), r"\dot{W} = R I^2\,");
        // The twins: derivatives, integrals, a term without a differential, a subscript, one side alone.
        for text in [
            r"\frac{dq}{dt} = -\frac{q}{RC}",
            r"\int \frac{dq}{q} = -\int \frac{dt}{RC}",
            r"dq = a + b\,dt",
            r"x_d t = d t",
            r"dq + dt",
            r"\ddot x = d t",
        ] {
            assert_eq!(plain(text), text);
        }
    }
}
