//! Letters that have another meaning in a line of a hand-in than everywhere else: t for an instant in a line about constants,
//! `v = a t`, and e for a charge.

use crate::formula::symbols::Name;
use crate::latex::foreign;
use crate::latex::{Macros, names};
use crate::notes::Display;
use crate::source::Span;

use crate::check::mark::names::Names;
use crate::check::unaided::guess::names::names_of;

use super::Written;

/// The name that stands for t where it is an instant.
const INSTANT: &str = "t_{\\star}";

/// The name that stands for e where it is no base of a power.
const CHARGE: &str = "e_{\\star}";

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

/// Gives e another name in a hand-in that has no power of it, as a charge: with a power it is Euler's number.
pub(in crate::check::mark) fn charges(lines: &mut [Written], known: &Names) {
    let is_power = |line: &Written| {
        single(&line.text, "e").iter().any(|span| line.text[span.end..].trim_start().starts_with(['^', '(']))
    };
    let is_known = names::parse("e").is_some_and(|(name, _)| known.symbols.find(&name).is_some());
    if is_known || lines.iter().any(is_power) {
        return;
    }
    for line in lines {
        let places = single(&line.text, "e");
        line.edits.extend(places.into_iter().map(|span| (span, format!("{{{CHARGE}}}"))));
    }
}

/// Whether a name stands for t where it is an instant.
pub(in crate::check::mark) fn is_instant(name: &Name) -> bool {
    names::parse(INSTANT).is_some_and(|(instant, _)| instant == *name)
}

/// A text with the letters that the student wrote.
pub(in crate::check::mark) fn as_written(text: &str) -> String {
    text.replace(INSTANT, "t").replace(CHARGE, "e").replace("t_\\star", "t").replace("e_\\star", "e")
}

/// Where a letter stands alone, without dots, subscript or primes.
fn single(text: &str, letter: &str) -> Vec<Span> {
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

fn as_display(line: &Written) -> Display {
    Display {
        span: line.body,
        body: line.body,
        parts: vec![line.body],
        text: line.text.clone(),
        number: None,
        labels: Vec::new(),
        automatic: Vec::new(),
        line: line.line,
    }
}

#[cfg(test)]
mod tests {
    use super::single;

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
