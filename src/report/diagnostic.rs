//! A message with the lines that it is about, in the look of rustc.

use annotate_snippets::{AnnotationKind, Group, Level, Patch, Renderer, Snippet};

use crate::Error;
use crate::check::{Finding, Fit, Misfit, Repair, Shared};
use crate::formula::text::plain;
use crate::source::{Fault, Source, Span};

/// Lines longer than this are not shown.
const LONGEST_LINE: usize = 400;
/// Spans of more lines than this are shown by their first line.
const MOST_LINES: usize = 12;

/// How diagnostics are drawn.
pub fn renderer(colour: bool) -> Renderer {
    if colour { Renderer::styled() } else { Renderer::plain() }
}

/// An error as a diagnostic.
pub fn error(error: &Error, colour: bool) -> String {
    let title = Level::ERROR.primary_title(error.message());
    let help = error.advice().map(|help| Level::HELP.message(help));
    match error.place().and_then(|(source, span)| Excerpt::of(source, span)) {
        Some(excerpt) => renderer(colour).render(&[title.element(excerpt.snippet("")).elements(help)]),
        None => {
            let place = error.place().map(|(source, span)| place(source, span));
            renderer(colour).render(&[title.elements(place).elements(help)])
        }
    }
}

/// A fault in a formula given on the command line.
pub fn fault(fault: &Fault, formula: &str, colour: bool) -> String {
    let title = Level::ERROR.primary_title(fault.message.as_str());
    let help = fault.help.as_deref().map(|help| Level::HELP.message(help));
    let source = Source::new("formula", formula);
    match Excerpt::of(&source, fault.span) {
        Some(excerpt) => renderer(colour).render(&[title.element(excerpt.snippet("")).elements(help)]),
        None => renderer(colour).render(&[title.elements(help)]),
    }
}

/// A verdict that was not expected.
pub fn verdict(title: &str, label: &str, source: &Source, finding: &Finding, colour: bool) -> String {
    let title = Level::ERROR.primary_title(title);
    let span = finding.span;
    let notes = evidence(finding).into_iter().map(|note| Level::NOTE.message(note));
    match Excerpt::of(source, span) {
        Some(excerpt) => renderer(colour).render(&[title.element(excerpt.snippet(label)).elements(notes)]),
        None => renderer(colour).render(&[title.element(place(source, span)).elements(notes)]),
    }
}

/// The terms that must change for an equation to hold, all at once, shown on their lines.
pub fn fit(fit: &Fit, source: &Source, colour: bool) -> String {
    let title = Level::HELP.secondary_title(match fit.terms.len() {
        0 => "terms are missing",
        1 => "this term does not fit",
        _ => "these terms do not fit",
    });
    let label = |misfit: &Misfit| match misfit.coefficient.numerator {
        0 => "this term is not in it".to_owned(),
        _ => format!("should be {} times as large", misfit.coefficient),
    };
    let missing: Vec<&str> = fit.missing.iter().map(|term| term.text.as_str()).collect();
    let missing = (!missing.is_empty()).then(|| format!("missing on the right side: {}", missing.join(" and ")));
    let notes = std::iter::once("with all of this changed, the equation passes".to_owned()).chain(missing);
    let notes = notes.collect::<Vec<_>>().into_iter().rev().map(|note| Level::NOTE.message(note));
    let all = fit.terms.iter().map(|misfit| misfit.span).reduce(Span::to);
    let excerpt =
        all.and_then(|all| Excerpt::of(source, all).filter(|shown| all.end <= shown.start + shown.lines.len()));
    match excerpt {
        Some(excerpt) => {
            let start = excerpt.start;
            let annotation = |misfit: &Misfit| {
                let span = misfit.span.start - start..misfit.span.end - start;
                AnnotationKind::Primary.span(span).label(label(misfit))
            };
            let snippet = Snippet::source(excerpt.lines).line_start(excerpt.first).path(excerpt.path).fold(false);
            let snippet = snippet.annotations(fit.terms.iter().map(annotation));
            renderer(colour).render(&[title.element(snippet).elements(notes)])
        }
        None => {
            let places = fit.terms.iter().map(|misfit| place(source, misfit.span));
            renderer(colour).render(&[title.elements(places).elements(notes)])
        }
    }
}

/// That an edit which was shown mends one more equation.
pub fn mended_as_well(shared: &Shared, colour: bool) -> String {
    let at = match shared.mends.first() {
        Some(first) if *first != shared.of => format!(" that is shown at ({first})"),
        _ => String::new(),
    };
    let title = format!("the edit of ({}){at} mends this as well", shared.of);
    renderer(colour).render(&[Group::with_title(Level::HELP.secondary_title(title))])
}

/// What the slip of an equation may be in instead.
pub fn elsewhere(id: &str, displays: &[String], colour: bool) -> String {
    let title = match displays {
        [own] if own == id => "nothing that holds uses what it introduces: either side may be wrong".to_owned(),
        displays => format!("nothing that holds stands on {}: the slip may be there", listed(displays)),
    };
    renderer(colour).render(&[Group::with_title(Level::NOTE.secondary_title(title))])
}

/// Equations by their numbers.
fn listed(ids: &[String]) -> String {
    let ids: Vec<String> = ids.iter().map(|id| format!("({id})")).collect();
    match ids.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

/// An edit that would make an equation pass, shown on its lines; `first` is the likeliest of several.
pub fn repair(repair: &Repair, first: bool, source: &Source, colour: bool) -> String {
    let (old, new) = (plain_space(source.slice(repair.span)), plain_space(&repair.replacement));
    let change = match (old.as_str(), new.as_str()) {
        ("", new) => format!("“{new}” put in"),
        (old, "") => format!("“{old}” left out"),
        (old, new) => format!("“{new}” for “{old}”"),
    };
    let asked = if first { "did you mean" } else { "or" };
    let then = match (&repair.shared, repair.step) {
        (Some(Shared { of, mends }), _) if mends.contains(of) => {
            format!("In ({of}); then {} hold", listed(mends))
        }
        (Some(Shared { of, mends }), _) => match mends.as_slice() {
            [one] => format!("In ({of}), on which ({one}) stands: it would be {}", repair.verdict),
            _ => format!("In ({of}), on which {} stand; all of them would hold", listed(mends)),
        },
        (None, true) => format!("This step would be {}, and the rest is left to mend", repair.verdict),
        (None, false) => format!("It would be {}", repair.verdict),
    };
    let title = Level::HELP.secondary_title(format!("{asked} {change}? {then}"));
    match Excerpt::of(source, repair.span) {
        Some(excerpt) => {
            let start = excerpt.start;
            let span = repair.span.start - start..repair.span.end - start;
            let patch = Patch::new(span, repair.replacement.as_str());
            let snippet = Snippet::source(excerpt.lines).line_start(excerpt.first).path(excerpt.path).patch(patch);
            renderer(colour).render(&[title.element(snippet)])
        }
        None => renderer(colour).render(&[title.element(place(source, repair.span))]),
    }
}

/// A text in one line.
fn plain_space(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A counterexample in words, and what the claim is off by.
pub fn evidence(finding: &Finding) -> Vec<String> {
    let Some(counterexample) = &finding.counterexample else { return Vec::new() };
    let state: Vec<String> =
        counterexample.state.iter().map(|(name, value)| format!("{} = {}", plain(name), short(*value, 5))).collect();
    let entry = counterexample.entry.as_ref().map(|entry| format!(" ({entry})")).unwrap_or_default();
    let mut notes = vec![
        format!("at {}", if state.is_empty() { "every state".to_owned() } else { state.join(", ") }),
        format!("left side {}, right side {}{entry}", short(counterexample.lhs, 7), short(counterexample.rhs, 7)),
    ];
    notes
        .extend(finding.difference.as_ref().map(|formula| format!("left side − right side = {}{entry}", formula.text)));
    notes.extend(finding.derived.as_ref().map(|formula| format!("derived: {}", formula.text)));
    notes
}

/// The place of something whose lines are too long to show.
fn place(source: &Source, span: Span) -> annotate_snippets::Message<'static> {
    let (line, column) = source.line_column(span.start);
    Level::NOTE.message(format!("at {}:{line}:{column}", source.path))
}

/// A number with so many significant digits.
fn short(value: f64, digits: usize) -> String {
    let magnitude = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if !value.is_finite() || value == 0.0 {
        value.to_string()
    } else if (-4.0..digits as f64).contains(&magnitude) {
        let decimals = (digits as f64 - 1.0 - magnitude).max(0.0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.*e}", digits - 1)
    }
}

/// The lines that a span touches, with the span relative to them.
struct Excerpt<'a> {
    path: &'a str,
    lines: &'a str,
    /// The byte of the text that the lines start at.
    start: usize,
    first: usize,
    span: std::ops::Range<usize>,
}

impl<'a> Excerpt<'a> {
    fn of(source: &'a Source, span: Span) -> Option<Excerpt<'a>> {
        let text = &source.text;
        let (mut from, mut to) = (span.start.min(text.len()), span.end.min(text.len()));
        while !text.is_char_boundary(from) {
            from -= 1;
        }
        while !text.is_char_boundary(to) {
            to += 1;
        }
        let trimmed = text[from..to.max(from)].trim();
        if !trimmed.is_empty() {
            from += text[from..to].len() - text[from..to].trim_start().len();
            to = from + trimmed.len();
        }
        if text[from..to].lines().count() > MOST_LINES {
            to = from + text[from..to].find('\n').unwrap_or(0);
        }
        let start = text[..from].rfind('\n').map_or(0, |at| at + 1);
        let end = text[to..].find('\n').map_or(text.len(), |at| to + at);
        let lines = &text[start..end];
        if lines.lines().any(|line| line.len() > LONGEST_LINE) {
            return None;
        }
        let (first, _) = source.line_column(start);
        Some(Excerpt { path: &source.path, lines, start, first, span: from - start..(to - start).max(from - start) })
    }

    fn snippet(self, label: &'a str) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
        let annotation = AnnotationKind::Primary.span(self.span);
        let annotation = if label.is_empty() { annotation } else { annotation.label(label) };
        Snippet::source(self.lines).line_start(self.first).path(self.path).fold(false).annotation(annotation)
    }
}
