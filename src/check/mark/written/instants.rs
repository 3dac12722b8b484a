//! Values at an instant: `y(0) = -x_0`, `q(t_h) = \frac12 Q_0`. In a hand-in the parenthesis after what moves says when. And what
//! has come together up to the time: `\int_0^t I(t')\,dt'`.
//!
//! Each such value gets a name of its own before the line is read. Where the model solution prints the motion, the name is
//! replaced by the value there; else it is a quantity of the student's own.

use crate::formula::symbols::Name;
use crate::latex::foreign;
use crate::latex::names;
use crate::source::Span;

use super::Written;
use crate::check::mark::names::{Names, Role};

/// What kind of value it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::check::mark) enum Kind {
    /// The value at an instant.
    At,
    /// The value of a function of another letter.
    Of(String),
    /// The integral from 0 to the time.
    Whole,
}

/// A value at an instant, as the student writes it.
#[derive(Clone, Debug)]
pub(in crate::check::mark) struct Instant {
    /// The name that stands for it.
    pub name: String,
    /// What has the value: a name, perhaps with dots.
    pub of: String,
    /// When.
    pub when: String,
    /// What kind of value it is.
    pub kind: Kind,
}

/// The name of a value, which is added to those that are known if it is a new one.
pub(super) fn name_of(values: &mut Vec<Instant>, value: Instant) -> String {
    let is_it = |known: &&Instant| (&known.of, &known.when, &known.kind) == (&value.of, &value.when, &value.kind);
    values.iter().find(is_it).map(|known| known.name.clone()).unwrap_or_else(|| {
        let name = format!("\\mathcal{{I}}_{{{}}}", values.len() + 1);
        values.push(Instant { name: name.clone(), ..value });
        name
    })
}

/// The values at instants in the lines of a hand-in, which are replaced by names there.
pub(in crate::check::mark) fn named(lines: &mut [Written], known: &Names) -> Vec<Instant> {
    let mut found: Vec<Instant> = Vec::new();
    let functions: Vec<String> = lines.iter().flat_map(|line| functions(&line.text)).collect();
    for line in lines {
        for (span, of) in integrals(&line.text, known) {
            let name =
                name_of(&mut found, Instant { name: String::new(), of, when: "t".to_owned(), kind: Kind::Whole });
            line.edits.push((span, format!("{{{name}}}")));
        }
        let is_inside = |span: &Span, edits: &[(Span, String)]| edits.iter().any(|(whole, _)| whole.contains(*span));
        for (span, of, when) in values(&line.text) {
            if is_inside(&span, &line.edits) {
                continue;
            }
            let name = names::parse(of).map(|(name, _)| name);
            let is_constant = |name: &Name| known.names.iter().any(|(k, role, _)| k == name && *role == Role::Constant);
            if name.as_ref().is_some_and(is_constant) || functions.iter().any(|function| function == of) {
                continue;
            }
            let value = Instant { name: String::new(), of: of.to_owned(), when: when.to_owned(), kind: Kind::At };
            let name = name_of(&mut found, value);
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

/// The integrals of what moves from 0 to the time in a text, each with its integrand as a function of the time. The letter of
/// the integral stands after what moves, `I(t')`, or is left out there, `\int_0^t v\,dt`.
fn integrals(text: &str, known: &Names) -> Vec<(Span, String)> {
    let mut found = Vec::new();
    for sign in ["\\int_0^t", "\\int_{0}^{t}", "\\int_0^{t}", "\\int\\limits_0^t", "\\int\\limits_{0}^{t}"] {
        for (start, _) in text.match_indices(sign) {
            let from = start + sign.len();
            if let Some((end, integrand)) = integrand(text, from, known) {
                found.push((Span::new(start, end), integrand));
            }
        }
    }
    found
}

fn integrand(text: &str, from: usize, known: &Names) -> Option<(usize, String)> {
    let moves = |name: &str| {
        let name = names::parse(name).map(|(name, _)| name);
        name.is_some_and(|name| {
            known.symbols.find(&name).is_none()
                || known
                    .names
                    .iter()
                    .any(|(own, role, _)| *own == name && *role != Role::Constant && !known.fixed.contains(&name))
        })
    };
    let signs = ["\\mathrm{d}", "\\mathrm d", "\\text{d}", "d"];
    let ends = text[from..].char_indices().map(|(at, _)| from + at).find_map(|at| {
        let sign = signs.iter().find(|sign| text[at..].starts_with(**sign))?;
        let is_command = text[..at].trim_end_matches(|c: char| c.is_ascii_alphabetic()).ends_with('\\');
        let letter = at + sign.len() + text[at + sign.len()..].len() - text[at + sign.len()..].trim_start().len();
        let end = foreign::quantity(text, letter)?;
        (!is_command).then_some((at, letter, end))
    })?;
    let (body, letter) = (text.get(from..ends.0)?, &text[ends.1..ends.2]);
    let mut gaps = ["\\,", "\\;", "\\:", "\\ "].iter();
    let body = body.trim();
    let body = gaps.find_map(|gap| body.strip_suffix(gap)).unwrap_or(body).trim();
    let argument = format!("({letter})");
    let applied: Vec<&str> = body.match_indices(&argument).map(|(at, _)| body[..at].trim_end()).collect();
    let name_before = |before: &&str| {
        let starts = before.char_indices().map(|(at, _)| at).rev().take(20);
        let start = starts.filter(|at| foreign::quantity(before, *at) == Some(before.len())).last();
        start.is_some_and(|start| moves(&before[start..]))
    };
    let is_applied = !applied.is_empty() && applied.iter().all(name_before);
    let is_sloppy = applied.is_empty()
        && body.char_indices().any(|(at, _)| {
            foreign::quantity(body, at).is_some_and(|end| {
                let name = names::parse(&body[at..end]).map(|(name, _)| name);
                name.is_some_and(|name| known.symbols.find(&name).is_some()) && moves(&body[at..end])
            })
        });
    let plain = body.replace(&argument, "");
    let is_plain = letter == "t" || !plain.contains(letter);
    ((is_applied || is_sloppy) && is_plain && !plain.contains("\\int")).then_some((ends.2, plain))
}

/// The instant in a parenthesis: 0, a time with a subscript, or what is said to be the time.
fn instant(inside: &str) -> Option<&str> {
    let inside = inside.trim();
    if let Some(value) = inside.strip_prefix('t').and_then(|rest| rest.trim_start().strip_prefix('=')) {
        return Some(value.trim()).filter(|value| !value.is_empty());
    }
    let is_time = inside.strip_prefix("t_").is_some_and(|sub| !sub.is_empty() && !sub.contains(['+', '-', ',']));
    (inside == "0" || is_time || is_multiple_of_a_period(inside) || is_multiple_of_an_instant(inside)).then_some(inside)
}

/// Whether a text is a multiple of a time with a subscript: `2t_1`, `t_{1}/2`.
fn is_multiple_of_an_instant(text: &str) -> bool {
    let factor = text.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').trim_start();
    let Some(sub) = factor.strip_prefix("t_") else { return false };
    let rest = match sub.strip_prefix('{') {
        Some(inside) => inside.split_once('}').map(|(_, rest)| rest),
        None => sub.chars().next().filter(char::is_ascii_alphanumeric).map(|c| &sub[c.len_utf8()..]),
    };
    rest.is_some_and(|rest| match rest.trim().strip_prefix('/') {
        Some(below) => !below.is_empty() && below.chars().all(|c| c.is_ascii_digit()),
        None => rest.trim().is_empty(),
    })
}

/// Whether a text is a period or a time constant, or a multiple of one: `T`, `T/4`, `2\tau`.
fn is_multiple_of_a_period(text: &str) -> bool {
    let is_number = |c: char| c.is_ascii_digit() || c.is_whitespace() || "/{}.".contains(c);
    let plain = text.replace("\\frac", " ").replace("\\pi", " ");
    let (start, end) = (plain.trim_start_matches(is_number), plain.trim_end_matches(is_number));
    let letter = plain.get(plain.len() - start.len()..end.len()).unwrap_or_default();
    letter == "T" || letter == "\\tau"
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
    use super::{functions, integrals, values};
    use crate::check::mark::names::Names;
    use crate::formula::Symbols;

    #[test]
    fn a_period_is_an_instant() {
        assert_eq!(found(r"x(T/4) = v(2\tau) + q\left(\frac{T}{2}\right)"), [("x", "T/4"), ("v", r"2\tau")]);
        assert_eq!(found("x(2t_1) = y(t_{1}/2)"), [("x", "2t_1"), ("y", "t_{1}/2")]);
        for text in ["m(T - a)", "x(S)", "x(2)", "x(T_1 x)", "x(2t_1 + a)", "x(2 t)"] {
            assert_eq!(found(text), [], "{text}");
        }
    }

    #[test]
    fn an_integral_up_to_the_time_is_a_value() {
        let none = Names { symbols: Symbols::open(), names: Vec::new(), fixed: Vec::new() };
        let found = |text: &str| integrals(text, &none).into_iter().map(|(_, of)| of).collect::<Vec<_>>();
        assert_eq!(found(r"q(t) = \int_0^t I(t') \, dt'"), ["I"]);
        assert_eq!(found(r"x = \int_{0}^{t} 2 v(\tau) \mathrm{d}\tau + a"), ["2 v"]);
        // The twins: a letter that stands alone, other ends, no function.
        for text in [r"\int_0^t \tau v(\tau) d\tau", r"\int_0^{t_1} I(t') dt'", r"\int_0^t a \, ds"] {
            assert!(found(text).is_empty(), "{text}");
        }
    }

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
