//! An error, or an equation that is not as expected, with the lines that it is about, in the look of rustc.

use annotate_snippets::{Element, Group, Level, Title};

use crate::Error;
use crate::check::verdict::finding::Compared;
use crate::check::{Counterexample, Document, Equation, Finding, Part};
use crate::code::Code;
use crate::formula::text::{number, plain};

use super::code;
use super::excerpt::{Excerpt, alone};
use super::headline::{headline, outcome, said};
use super::style::Style;
use super::suggestion;
use super::wrap::{titled, wrap};

/// The columns of `note: ` and `help: ` with the sign before them and the widest line number.
const BESIDE_A_NOTE: usize = 16;

/// An error as a diagnostic.
pub fn error(error: &Error, style: Style) -> String {
    let code = code::of_error(error);
    let message = titled("error", code, error.message(), style);
    let title = Level::ERROR.primary_title(message).id(code);
    let help: Vec<Element<'_>> = error.advice().map(|help| below(Level::HELP, help, style)).into_iter().collect();
    match error.place() {
        Some((source, span)) => Excerpt::of(source, span).marked(title, help, style),
        None if help.is_empty() => alone(Group::with_title(title), style),
        None => alone(title.elements(help), style),
    }
}

/// An equation that is not as expected: its first part that is not in full, the others as notes, and what is suggested.
pub(super) fn unexpected(document: &Document, item: &Equation, style: Style) -> String {
    let source = &document.source;
    let of_its_own = |part: &&Part| !part.ok && part.finding.follows_from.is_none();
    let finding = code::first_unexpected(item);
    let is_other = |part: &Part| !std::ptr::eq(&part.finding, finding);
    let wrong = item.parts.iter().enumerate().filter(|(_, part)| of_its_own(part) && is_other(part));
    let mut notes = evidence(finding);
    notes.extend(wrong.map(|(at, part)| another(document, item, at, &part.finding, finding)));
    notes.extend(item.because.as_ref().map(|because| match finding.verdict.passes() {
        true => format!(
            "the claims file gives this reason: {because}; if the equation is correct now, remove \"expect\" and \
             \"because\""
        ),
        false => format!("the claims file expects another verdict, for this reason: {because}"),
    }));
    let message = match (&item.because, finding.verdict.passes()) {
        (Some(_), true) => {
            format!("({}) is {}, but the claims file expects that it does not pass", item.id, finding.verdict)
        }
        _ => headline(item, finding),
    };
    let code = code::of_finding(finding);
    // What the author leaves out is no mistake; it is as expected only if the claims file says so.
    let (level, word) = match finding.code {
        Code::Skipped => (Level::WARNING, "warning"),
        _ => (Level::ERROR, "error"),
    };
    if finding.code == Code::Skipped && item.because.is_none() {
        notes.push(
            "to leave it out without this warning, add \"expect\": \"unclaimed\" and \"because\" beside \"skip\""
                .to_owned(),
        );
    }
    let title: Title<'_> = level.primary_title(titled(word, code, &message, style)).id(code);
    let notes = notes.iter().map(|note| below(Level::NOTE, note, style)).collect();
    let first = Excerpt::of(source, finding.span).marked(title, notes, style);
    std::iter::once(first).chain(suggestion::all(document, item, style)).collect::<Vec<_>>().join("\n\n")
}

/// What passes and should be looked at: a definition that no other display tests.
pub(super) fn warning(document: &Document, item: &Equation, style: Style) -> Option<String> {
    let parts = item.parts.iter().map(|part| &part.finding);
    let finding = parts.chain([&item.finding]).find(|finding| finding.is_untested_definition())?;
    let code = code::of_finding(finding);
    let message = format!("({}) {}", item.id, finding.message);
    let title = Level::WARNING.primary_title(titled("warning", code, &message, style)).id(code);
    Some(Excerpt::of(&document.source, finding.span).marked(title, Vec::new(), style))
}

/// One more part of an equation that is not as expected.
fn another(document: &Document, item: &Equation, at: usize, finding: &Finding, first: &Finding) -> String {
    let (line, column) = document.source.line_column(finding.span.start);
    let name = format!("part {} of {}, at {line}:{column},", at + 1, item.parts.len());
    match finding.message == first.message {
        true => format!("{name} {} too", outcome(item, finding)),
        false => format!("{name} {}", said(item, finding)),
    }
}

/// A note or advice below the lines of a file.
fn below<'a>(level: Level<'a>, text: &str, style: Style) -> Element<'a> {
    level.message(wrap("", text, 2, style.inside(BESIDE_A_NOTE).width)).into()
}

/// The counterexample of a finding in words, what its two sides differ by, and what was derived; one line each.
///
/// No-break spaces hold each symbol and its value together.
pub fn evidence(finding: &Finding) -> Vec<String> {
    let mut notes = values(finding);
    notes.extend(remarks(finding));
    notes
}

/// The state of a counterexample, and the values there.
fn values(finding: &Finding) -> Vec<String> {
    let Some(counterexample) = &finding.counterexample else { return Vec::new() };
    let state = counterexample.state.iter();
    let state: Vec<String> =
        state.map(|(name, value)| format!("{}\u{a0}=\u{a0}{}", plain(name), number(*value, 5))).collect();
    let mut notes = match (state.is_empty(), counterexample.compared) {
        (true, Compared::Sides) => vec!["at every state".to_owned()],
        (true, _) => Vec::new(),
        (false, _) => vec![format!("at {}", state.join(", "))],
    };
    // The message of what is not conserved gives its rate.
    if finding.code != Code::NotConserved {
        notes.extend(compared(counterexample));
    }
    notes
}

/// The two values of a counterexample in words.
pub fn compared(counterexample: &Counterexample) -> Option<String> {
    let Counterexample { lhs, rhs, .. } = counterexample;
    let entry = counterexample.entry.as_ref().map(|entry| format!(" ({entry})")).unwrap_or_default();
    match counterexample.compared {
        Compared::Sides => Some(format!("{}{entry}", sides(*lhs, *rhs))),
        Compared::Counts(what) => Some(format!("{what}: {lhs} found, {rhs} claimed")),
        Compared::AtAPlace => Some(format!("found {}, compared with {}", number(*lhs, 7), number(*rhs, 7))),
        Compared::Nothing => None,
    }
}

/// What the two sides of a finding differ by, and what was derived; one line each.
pub fn remarks(finding: &Finding) -> Vec<String> {
    let Some(counterexample) = &finding.counterexample else { return Vec::new() };
    let entry = counterexample.entry.as_ref().map(|entry| format!(" ({entry})")).unwrap_or_default();
    let mut notes: Vec<String> = Vec::new();
    notes
        .extend(finding.difference.as_ref().map(|formula| format!("left side − right side = {}{entry}", formula.text)));
    notes.extend(finding.derived.as_ref().map(|formula| format!("derived: {}", formula.text)));
    notes
}

/// The values of both sides. Two that differ late have so many digits that they differ, and their difference is given.
fn sides(lhs: f64, rhs: f64) -> String {
    const USUAL: usize = 7;
    const MOST: usize = 17;
    let differs = |digits: &usize| number(lhs, *digits) != number(rhs, *digits);
    let (digits, difference) = match (USUAL..=MOST).find(differs) {
        _ if lhs == rhs => (USUAL, String::new()),
        Some(digits) if number(lhs, USUAL - 3) != number(rhs, USUAL - 3) => (digits, String::new()),
        Some(digits) => (MOST.min(digits + 1), format!(", difference {}", number(lhs - rhs, 3))),
        None => (USUAL, String::new()),
    };
    let side = |name: &str, value: f64| match value.is_nan() {
        true => format!("the {name} side is not a real number"),
        false => format!("{name} side {}", number(value, digits)),
    };
    format!("{}, {}{difference}", side("left", lhs), side("right", rhs))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    #[test]
    fn two_sides_that_differ_are_seen_to_differ() {
        assert_eq!(sides(1.0, 2.0), "left side 1.000000, right side 2.000000");
        let close = sides(1.000000012345, 1.0000000);
        assert_eq!(close, "left side 1.000000012, right side 1.000000000, difference 1.23e-8");
        assert!(sides(1.0, f64::EPSILON + 1.0).contains("difference -2.22e-16"));
        // Equal sides have no difference to show: `≠` fails there.
        assert_eq!(sides(1.0, 1.0), "left side 1.000000, right side 1.000000");
        assert_eq!(sides(f64::NAN, 1.0), "the left side is not a real number, right side 1.000000");
        assert!(sides(f64::INFINITY, 0.0).starts_with("left side +∞"));
    }

    use super::super::style::columns;
    use super::*;
    use crate::source::{Source, Span};

    #[test]
    fn an_error_names_its_code_its_place_and_its_advice_in_lines_that_fit() {
        let source = Arc::new(Source::new("notes.md", "a = b\n".repeat(200)));
        let message = "this is a long message about something that is wrong in many ways ".repeat(3);
        let found =
            Error::at(&source, Span::new(4, 5), message).help("do this and that, and then some more ".repeat(3));
        let text = error(&found, Style::PLAIN);
        assert!(text.starts_with("error[") && text.contains("--> notes.md:1:5"), "{text}");
        assert!(text.lines().all(|line| columns(line) <= 80), "{text}");
        let text = error(&Error::new("nothing is there").help("look elsewhere"), Style::PLAIN);
        assert!(text.contains("]: nothing is there\n") && text.ends_with("help: look elsewhere"), "{text}");
    }
}
