//! What stands behind a verdict: how an equation was read, on what it rests, the bound, or the counterexample.

use maud::{Markup, html};

use super::{badge, equation_anchor, typeset};
use crate::check::verdict::finding::Compared;
use crate::check::{Document, Equation, Verdict};
use crate::formula::text::number;
use crate::notes::{Display, MacroDefinition};
use crate::report::diagnostic;
use crate::source::{Source, Span};

/// The most symbols of a counterexample that is told in a sentence.
const IN_A_SENTENCE: usize = 8;

/// The evidence in a few words, for the line under an equation.
pub(super) fn short(item: &Equation) -> Markup {
    let finding = &item.finding;
    html! {
        @match (finding.verdict, finding.false_accept_log2) {
            (Verdict::Certified, Some(power)) => { "false with probability below 2" sup { (format!("{:.0}", power.ceil())) } },
            (Verdict::Certified, None) => "decided exactly",
            (Verdict::Verified, _) if finding.points > 1 => { "holds at " (finding.points) " sampled states" },
            (Verdict::Definition, _) => "defines a symbol",
            (Verdict::Refuted, _) if item.ok => "refuted, as the claims file expects",
            (Verdict::Law, _) => "taken for granted",
            (Verdict::Assumed, _) => "not checked",
            _ => {}
        }
    }
}

/// The evidence as paragraphs.
pub(super) fn evidence(
    item: &Equation,
    document: &Document,
    display: Option<&Display>,
    macros: &[MacroDefinition],
    prefix: &str,
) -> Markup {
    let finding = &item.finding;
    let notes = diagnostic::remarks(finding);
    html! {
        p { (capital(&finding.message)) "." }
        (rests_on(item, document, prefix))
        @if !item.reading.is_empty() { p { "Read as " span class="reading" { (item.reading) } } }
        @if !item.parts.is_empty() {
            ol class="parts" {
                @for part in &item.parts {
                    li { (badge(part.finding.verdict, part.ok)) " " code { (part.reading) } " — " (part.finding.message) }
                }
            }
        }
        @match finding.points {
            0 => {}
            1 => { p { "Tested at 1 sampled state." } }
            points => { p { "Tested at " (points) " sampled states." } }
        }
        @if let Some(power) = finding.false_accept_log2 {
            p {
                "Confirmed by exact arithmetic: the equation is false with a probability below 2"
                sup { (format!("{:.0}", power.ceil())) } "."
            }
        }
        @if let Some(reason) = &finding.not_certified_because { p { "Not certified, because exact arithmetic does not \
                                                                     decide " (reason) "." } }
        @if let Some(reason) = &item.because { p { "Expected, because: " (reason) } }
        (counterexample(item, macros))
        @for note in notes { p { (note) } }
        @if !finding.verdict.passes() {
            (excerpt(&document.source, finding.span, display.map_or("The sentence in the notes", |_| "The source of the part that fails")))
        }
    }
}

/// Links to the equations that this one rests on, and to those that rest on it.
fn rests_on(item: &Equation, document: &Document, prefix: &str) -> Markup {
    let is_there = |id: &&String| document.equations.iter().any(|other| other.id == **id);
    let below: Vec<&String> = item.rests_on.iter().filter(is_there).collect();
    let above: Vec<&String> =
        document.equations.iter().filter(|other| other.rests_on.contains(&item.id)).map(|other| &other.id).collect();
    let links = |ids: &[&String]| {
        html! {
            @for (at, id) in ids.iter().enumerate() {
                @if at > 0 { ", " }
                a href={ "#" (equation_anchor(prefix, id)) } { "(" (id) ")" }
            }
        }
    };
    html! {
        @if !below.is_empty() { p { "Depends on " (links(&below)) "." } }
        @if !above.is_empty() { p { "Used by " (links(&above)) "." } }
    }
}

/// The counterexample in words, and as a table if it has many symbols.
fn counterexample(item: &Equation, macros: &[MacroDefinition]) -> Markup {
    let Some(found) = &item.finding.counterexample else { return html! {} };
    let is_short = found.state.len() <= IN_A_SENTENCE;
    let side = |value: f64| if value.is_nan() { "no real number".to_owned() } else { number(value, 7) };
    html! {
        p class="counterexample" {
            b { "A counterexample: " }
            @match (is_short, found.state.is_empty()) {
                (_, true) if found.compared != Compared::Sides => {}
                (_, true) => { "at every state" }
                (true, false) => {
                    "at "
                    @for (at, (name, value)) in found.state.iter().enumerate() {
                        @if at > 0 { ", " }
                        span class="value" { (typeset::inline(name, macros)) " = " (number(*value, 5)) }
                    }
                }
                (false, false) => { "at the state below" }
            }
            @match found.compared {
                Compared::Sides => {
                    " the left side is " (side(found.lhs)) " and the right side is " (side(found.rhs))
                    @if let Some(entry) = &found.entry { " (" (entry) ")" }
                }
                _ => { @if let Some(said) = diagnostic::compared(found) { " " (said) } }
            }
            "."
        }
        @if !is_short {
            details {
                summary { "The state, " (found.state.len()) " values" }
                div class="wide" tabindex="0" role="group" aria-label="The state of the counterexample" {
                    table class="state" {
                        caption { "A state at which it fails" }
                        thead { tr { th scope="col" { "symbol" } th scope="col" { "value" } } }
                        tbody { @for (name, value) in &found.state {
                            tr { td { (typeset::inline(name, macros)) } td { (number(*value, 5)) } }
                        } }
                    }
                }
            }
        }
    }
}

/// The lines of the notes around a span, which is marked.
fn excerpt(source: &Source, span: Span, label: &str) -> Markup {
    let text = &source.text;
    let start = text.get(..span.start).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let end = text.get(span.end..).and_then(|after| after.find('\n')).map_or(text.len(), |at| span.end + at);
    let part = |from: usize, to: usize| text.get(from..to).unwrap_or_default();
    html! {
        pre class="wide" tabindex="0" role="group" aria-label=(label) {
            code { (part(start, span.start)) mark { (part(span.start, span.end)) } (part(span.end, end)) }
        }
    }
}

/// A message as a sentence.
pub(super) fn capital(message: &str) -> String {
    let message = message.trim_end_matches('.');
    // A word of letters alone begins with a capital; a formula stays as it is.
    let first = message.split(' ').next().unwrap_or_default();
    let is_word = first.len() > 1 && first.chars().all(|c| c.is_ascii_lowercase());
    match (is_word, message.chars().next()) {
        (true, Some(c)) => c.to_uppercase().chain(message.chars().skip(1)).collect(),
        _ => message.to_owned(),
    }
}
