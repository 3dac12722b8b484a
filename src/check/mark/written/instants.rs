//! Values at an instant: `y(0) = -x_0`, `q(t_h) = \frac12 Q_0`. In a hand-in the parenthesis after what moves says when.
//!
//! Each such value gets a name of its own before the line is read. Where the model solution prints the motion, the name is
//! replaced by the value there; else it is a quantity of the student's own.

use crate::formula::symbols::Name;
use crate::latex::foreign;
use crate::latex::names;
use crate::source::Span;

use super::Written;
use crate::check::mark::names::{Names, Role};

/// A value at an instant, as the student writes it.
#[derive(Clone, Debug)]
pub(in crate::check::mark) struct Instant {
    /// The name that stands for it.
    pub name: String,
    /// What has the value: a name, perhaps with dots.
    pub of: String,
    /// When.
    pub when: String,
}

/// The values at instants in the lines of a hand-in, which are replaced by names there.
pub(in crate::check::mark) fn named(lines: &mut [Written], known: &Names) -> Vec<Instant> {
    let mut found: Vec<Instant> = Vec::new();
    let functions: Vec<String> = lines.iter().flat_map(|line| functions(&line.text)).collect();
    for line in lines {
        for (span, of, when) in values(&line.text) {
            let name = names::parse(of).map(|(name, _)| name);
            let is_constant = |name: &Name| known.names.iter().any(|(k, role, _)| k == name && *role == Role::Constant);
            if name.as_ref().is_some_and(is_constant) || functions.iter().any(|function| function == of) {
                continue;
            }
            let is_it = |known: &&Instant| known.of == of && known.when == when;
            let name = found.iter().find(is_it).map(|known| known.name.clone()).unwrap_or_else(|| {
                let name = format!("\\mathcal{{I}}_{{{}}}", found.len() + 1);
                found.push(Instant { name: name.clone(), of: of.to_owned(), when: when.to_owned() });
                name
            });
            line.edits.push((span, format!("{{{name}}}")));
        }
    }
    found
}

/// Leaves out the unit Ω after numbers, where Ω is no quantity.
pub(in crate::check::mark) fn without_ohms(lines: &mut [Written], known: &Names) {
    let omega = names::parse("\\Omega").map(|(name, _)| name);
    let is_known = omega.is_some_and(|omega| known.symbols.find(&omega).is_some());
    let unit = |text: &str, at: usize| {
        let before = text[..at].trim_end();
        let number = ["\\,", "\\;", "\\ ", "~"].iter().find_map(|gap| before.strip_suffix(*gap))?.trim_end();
        let ends = number.ends_with(|c: char| c.is_ascii_digit() || c == '}');
        let is_last = !text[at + "\\Omega".len()..]
            .trim_start()
            .starts_with(|c: char| c.is_ascii_alphanumeric() || "_^".contains(c));
        (ends && is_last).then(|| (Span::new(number.len(), at + "\\Omega".len()), String::new()))
    };
    let places = |text: &str| -> Vec<usize> { text.match_indices("\\Omega").map(|(at, _)| at).collect() };
    let is_unit = |line: &Written| places(&line.text).into_iter().all(|at| unit(&line.text, at).is_some());
    if is_known || !lines.iter().all(is_unit) {
        return;
    }
    for line in lines {
        let edits = places(&line.text).into_iter().filter_map(|at| unit(&line.text, at));
        line.edits.extend(edits.collect::<Vec<_>>());
    }
}

/// Whether a name stands for a value at an instant.
pub(in crate::check::mark) fn is_instant(name: &Name) -> bool {
    name.base == "\\mathcal{I}" && !name.subscript.is_empty()
}

/// The values at instants in a text: where each stands, what has it, and when.
fn values(text: &str) -> Vec<(Span, &str, &str)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(step) = text[at..].chars().next().map(char::len_utf8) {
        let Some(end) = foreign::quantity(text, at) else {
            let command = text[at..]
                .strip_prefix('\\')
                .map_or(0, |rest| 1 + rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len()));
            at += command.max(step);
            continue;
        };
        let open = end + text[end..].len() - text[end..].trim_start().len();
        let when = text[open..].strip_prefix('(').and_then(|rest| rest.split_once(')')).map(|(inside, _)| inside);
        match when.and_then(|inside| Some((instant(inside)?, open + inside.len() + 2))) {
            Some((when, close)) => {
                found.push((Span::new(at, close), text[at..end].trim(), when));
                at = close;
            }
            None => at = end,
        }
    }
    found
}

/// The instant in a parenthesis: 0, a time with a subscript, or what is said to be the time.
fn instant(inside: &str) -> Option<&str> {
    let inside = inside.trim();
    if let Some(value) = inside.strip_prefix('t').and_then(|rest| rest.trim_start().strip_prefix('=')) {
        return Some(value.trim()).filter(|value| !value.is_empty());
    }
    let is_time = inside.strip_prefix("t_").is_some_and(|sub| !sub.is_empty() && !sub.contains(['+', '-', ',']));
    (inside == "0" || is_time).then_some(inside)
}

/// The names in a text that have another letter than the time in parentheses after them: functions of a place.
fn functions(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (open, _) in text.match_indices('(') {
        let inside = text[open + 1..].split(')').next().unwrap_or_default().trim();
        let is_letter = foreign::quantity(inside, 0) == Some(inside.len())
            && inside.trim_end_matches('\'') != "t"
            && instant(inside).is_none();
        let starts = text[..open].char_indices().map(|(at, _)| at);
        let name = starts.rev().take(20).filter(|at| foreign::quantity(text, *at) == Some(open)).last();
        if let Some(start) = name.filter(|_| is_letter) {
            found.push(text[start..open].trim_end_matches('\'').to_owned());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{functions, values};

    fn found(text: &str) -> Vec<(&str, &str)> {
        values(text).into_iter().map(|(_, of, when)| (of, when)).collect()
    }

    #[test]
    fn a_parenthesis_with_an_instant_after_a_quantity_says_when() {
        assert_eq!(found(r"y(0) = -x_0"), [("y", "0")]);
        assert_eq!(found(r"\dot y(0) = \ddot{x_1} (t = t_1)"), [(r"\dot y", "0"), (r"\ddot{x_1}", "t_1")]);
        assert_eq!(found(r"\varphi'(0) + q(t_{1/2})"), [(r"\varphi'", "0"), ("q", "t_{1/2}")]);
        // The twins: the time itself, a product, a function, a place.
        for text in ["x(t)", "m(a + b)", r"\sin(0)", "U(x_0)", "(0)", "2(0)"] {
            assert_eq!(found(text), [], "{text}");
        }
        assert_eq!(functions(r"U(x) = kx, y(t) = 1, f'(r_0) = U(0)"), ["U", "f"]);
    }
}
