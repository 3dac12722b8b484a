//! Letters that have another meaning in a line of a hand-in than everywhere else: t for an instant in a line about constants,
//! `v = a t`, e for a charge, and d for a length.

use crate::formula::symbols::Name;
use crate::latex::foreign;
use crate::latex::{Macros, names};
use crate::notes::Display;
use crate::source::Span;

use crate::check::mark::names::Names;
use crate::check::usage::names_of;

use super::Written;

/// The name that stands for t where it is an instant.
const INSTANT: &str = "t_{\\star}";

/// The name that stands for e where it is no base of a power.
const CHARGE: &str = "e_{\\star}";

/// The name that stands for d where it is no differential.
const LENGTH: &str = "d_{\\star}";

/// Gives t another name in lines that say something of constants of the problem alone: there it is no running time. A value
/// of t alone is a condition, and keeps its letter.
pub(in crate::check::mark) fn instants(lines: &mut [Written], known: &Names, macros: &Macros) {
    let time = names::parse("t").map(|(name, _)| name);
    let is_known = |name: &Name| known.names.iter().any(|(own, ..)| own == name);
    let Some(time) = time.filter(|time| !is_known(time)) else { return };
    for line in lines {
        let places = single(&line.text, "t");
        if places.is_empty() || line.text.contains("\\int") || line.text.contains("\\lim") {
            continue;
        }
        let used = names_of(&[as_display(line)], macros);
        let others: Vec<&Name> = used.iter().map(|usage| &usage.name).filter(|name| **name != time).collect();
        if others.len() > 1 && others.iter().all(|name| known.fixed.contains(name)) {
            line.edits.extend(places.into_iter().map(|span| (span, format!("{{{INSTANT}}}"))));
        }
    }
}

/// Gives e another name, as a charge, in a hand-in where it is no base of an exponential. Beside an e that is a factor, `e^2`
/// is the square of the charge. Elsewhere an e that stands alone is Euler's number.
pub(in crate::check::mark) fn charges(lines: &mut [Written], known: &Names) {
    let is_known = names::parse("e").is_some_and(|(name, _)| known.symbols.find(&name).is_some());
    let after = |line: &Written, span: Span| line.text[span.end..].trim_start().to_owned();
    let all: Vec<String> =
        lines.iter().flat_map(|line| single(&line.text, "e").into_iter().map(move |span| after(line, span))).collect();
    let is_factor = |rest: &String| !rest.starts_with(['^', '(']);
    let is_exponential = |rest: &String| match rest.strip_prefix('^') {
        Some(power) => !is_figure(power) || !all.iter().any(is_factor),
        None => rest.starts_with('('),
    };
    if is_known {
        return;
    }
    // Beside an exponential, an e that stands alone is Euler's number: `v(\\tau) = v_0/e = v_0 e^{-1}`.
    let is_euler = all.iter().any(is_exponential);
    for line in lines {
        let places = single(&line.text, "e");
        if !is_euler {
            rename(line, places, CHARGE);
            continue;
        }
        let (alone, others): (Vec<Span>, Vec<Span>) =
            places.into_iter().partition(|span| is_factor(&after(line, *span)));
        rename(line, alone, "\\exp(1)");
        let powers: Vec<_> = others.into_iter().filter_map(|span| whole_power(&line.text, span)).collect();
        for (span, power) in powers {
            rename(line, vec![span], &format!("\\exp({power})"));
        }
    }
}

/// The place of an e with a whole number in braces as its power, and the number: `e^{-2}`.
fn whole_power(text: &str, e: Span) -> Option<(Span, String)> {
    let rest = text[e.end..].strip_prefix("^{")?;
    let (power, _) = rest.split_once('}')?;
    let digits = power.trim().trim_start_matches('-').trim();
    let is_whole = !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit());
    is_whole.then(|| (Span::new(e.start, e.end + "^{}".len() + power.len()), power.trim().to_owned()))
}

/// Whether a power begins a text that is a positive whole number: `2`, `{4}`.
fn is_figure(power: &str) -> bool {
    let power = power.trim_start();
    match power.strip_prefix('{') {
        Some(inside) => inside
            .split_once('}')
            .is_some_and(|(power, _)| !power.trim().is_empty() && power.trim().chars().all(|c| c.is_ascii_digit())),
        None => power.starts_with(|c: char| c.is_ascii_digit()),
    }
}

/// Gives d another name, as a length, in a hand-in where it is nowhere a differential: d before the time, before what moves,
/// before what the problem does not have, or on each side directly before a letter.
pub(in crate::check::mark) fn lengths(lines: &mut [Written], known: &Names) {
    let is_known = names::parse("d").is_some_and(|(name, _)| known.symbols.find(&name).is_some());
    let is_fixed = |text: &str| names::parse(text).is_some_and(|(name, _)| known.fixed.contains(&name));
    let is_differential = |text: &str, span: &Span| {
        let rest = text[span.end..].trim_start();
        foreign::quantity(rest, 0).is_some_and(|end| !is_fixed(&rest[..end]))
    };
    // `dW = F\,dx`: on each side a d stands directly before a letter.
    let is_separated = |line: &Written| {
        let before_letter =
            |side: &str| single(side, "d").iter().any(|span| foreign::quantity(side, span.end).is_some());
        line.text.contains('=') && line.text.split('=').all(before_letter)
    };
    let is_any = |line: &Written| {
        let places = single(&line.text, "d");
        !places.is_empty() && line.text.contains("\\int")
            || is_separated(line)
            || places.iter().any(|span| is_differential(&line.text, span))
    };
    if is_known || lines.iter().any(is_any) {
        return;
    }
    for line in lines {
        let places = single(&line.text, "d");
        rename(line, places, LENGTH);
    }
}

/// Puts a name in the place of a letter, where no edit has taken it along.
pub(super) fn rename(line: &mut Written, mut places: Vec<Span>, name: &str) {
    places.retain(|span| line.edits.iter().all(|(taken, _)| !taken.contains(*span)));
    line.edits.extend(places.into_iter().map(|span| (span, format!("{{{name}}}"))));
}

/// Whether a name stands for t where it is an instant.
pub(in crate::check::mark) fn is_instant(name: &Name) -> bool {
    names::parse(INSTANT).is_some_and(|(instant, _)| instant == *name)
}

/// A text with the letters that the student wrote.
pub(in crate::check::mark) fn as_written(text: &str) -> String {
    let letters = ["t", "e", "d", "T", "K"].into_iter();
    letters.fold(text.to_owned(), |text, letter| {
        text.replace(&format!("{letter}_{{\\star}}"), letter).replace(&format!("{letter}_\\star"), letter)
    })
}

/// Where a letter stands alone, without dots, subscript or primes.
pub(super) fn single(text: &str, letter: &str) -> Vec<Span> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(step) = text[at..].chars().next().map(char::len_utf8) {
        if text[at..].starts_with('\\') {
            let rest = &text[at + 1..];
            let command = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
            // Words are no formulas.
            let word = ["text", "mathrm", "operatorname", "mbox", "begin", "end", "textrm", "tag", "label"];
            let words = word.contains(&&rest[..command]) && rest[command..].starts_with('{');
            let skipped = if words { rest.find('}').map_or(command, |close| close + 1) } else { command };
            at += 1 + skipped.max(rest.chars().next().map_or(0, char::len_utf8).min(usize::from(command == 0)));
            continue;
        }
        match foreign::quantity(text, at) {
            Some(end) => {
                if &text[at..end] == letter && !text[..at].ends_with(['_', '^', 'd']) {
                    found.push(Span::new(at, end));
                }
                at = end.max(at + step);
            }
            None => at += step,
        }
    }
    found
}

pub(super) fn as_display(line: &Written) -> Display {
    Display {
        span: line.body,
        body: line.body,
        parts: vec![line.body],
        text: line.text.clone(),
        number: None,
        labels: Vec::new(),
        automatic: Vec::new(),
        numbers_rows: false,
        line: line.line,
    }
}

#[cfg(test)]
mod tests {
    use super::{is_figure, single};

    #[test]
    fn a_figure_is_a_positive_whole_number() {
        assert!(is_figure("2 V") && is_figure("{4} x"));
        assert!(!is_figure("{-2}") && !is_figure("x") && !is_figure("{2x}") && !is_figure("{}"));
    }

    #[test]
    fn a_letter_stands_alone_without_subscript_and_outside_of_words() {
        let starts = |text: &str, letter: &str| single(text, letter).iter().map(|span| span.start).collect::<Vec<_>>();
        assert_eq!(starts(r"h = \frac12at^2", "t"), [12]);
        assert_eq!(starts(r"W = eV + \sqrt e", "e"), [4, 15]);
        // The twins: a subscript, a command, a word, a differential, a prime.
        for text in [r"t_1", r"\tau", r"\text{at rest}", r"x_t", "dt", "t'", r"\begin{aligned}"] {
            assert!(starts(text, "t").is_empty(), "{text}");
        }
    }
}
