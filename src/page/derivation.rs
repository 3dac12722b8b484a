//! A lecture as a page: headings and sentences, each line typeset with its certificate and its value.

use maud::{Markup, html};

use super::{badge, equation_anchor, prose, tone, typeset};
use crate::check::Equation;
use crate::formula::text::number;
use crate::lecture::text::drawn;
use crate::lecture::{Lecture, Line, Passage};

/// The system of a lecture in words.
pub(super) fn title(lecture: &Lecture) -> String {
    let words = lecture.name.replace('_', " ");
    let mut letters = words.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}", letters.as_str())
}

/// The lecture; `prefix` stands before the anchors of its lines.
pub(super) fn lecture(lecture: &Lecture, prefix: &str, pictures: &Markup) -> Markup {
    let headings = lecture.passages.iter().filter_map(|passage| match passage {
        Passage::Heading(text) => Some(text),
        _ => None,
    });
    html! {
        header class="page" {
            p class="path" { (lecture.name) }
            h1 { (title(lecture)) ": from the parts to the equations of motion" }
            p {
                "The program derived and typeset each line below. Then it checked the lines as it checks any notes: \
                 each line is "
                "taken for granted, or certified against the lines before it."
            }
            details {
                summary { "The sampled state at which the lines are evaluated" }
                p { (drawn(lecture)) "." }
            }
            nav aria-label="Sections" {
                ol class="chips" {
                    @for (at, heading) in headings.enumerate() {
                        li { a href={ "#" (prefix) "section-" (at) } { (prose::inline(heading, &[])) } }
                    }
                }
            }
        }
        article { (passages(lecture, prefix)) }
        (pictures)
    }
}

/// The passages of a lecture without its title.
pub(super) fn passages(lecture: &Lecture, prefix: &str) -> Markup {
    let mut section = 0..;
    html! {
        @for passage in &lecture.passages {
            @match passage {
                Passage::Heading(text) => {
                    @if let Some(at) = section.next() { h2 id={ (prefix) "section-" (at) } { (prose::inline(text, &[])) } }
                }
                Passage::Sentence(text) => p { (prose::inline(text, &[])) },
                Passage::Line(line) => (shown(lecture, line, prefix)),
            }
        }
    }
}

fn shown(lecture: &Lecture, line: &Line, prefix: &str) -> Markup {
    let Some(equation) = lecture.equation(line) else { return html! {} };
    let verdict = equation.finding.verdict;
    // What is taken for granted has no verdict to show.
    let class = match line.from.is_empty() {
        true => "equation given".to_owned(),
        false => format!("equation {} {}", verdict.word(), tone(verdict, equation.ok)),
    };
    html! {
        section class=(class) id=(equation_anchor(prefix, &line.number)) {
            div class="wide" tabindex="0" role="group" aria-label={ "Equation (" (line.number) ")" } {
                (typeset::block(&untagged(&equation.latex), &[]))
            }
            p class="note" {
                span class="number" { "(" (line.number) ")" } " "
                @if line.from.is_empty() { "taken for granted" } @else {
                    (badge(verdict, equation.ok)) " from "
                    @for (at, number) in line.from.iter().enumerate() {
                        @if at > 0 { ", " }
                        a href={ "#" (equation_anchor(prefix, number)) } { "(" (number) ")" }
                    }
                }
                @if !equation.ok { " · " (equation.finding.message) }
            }
            @if !line.from.is_empty() { (evidence(line, equation)) }
        }
    }
}

/// What the verdict rests on, folded away.
fn evidence(line: &Line, equation: &Equation) -> Markup {
    let values: Vec<String> = line.values.iter().map(|value| number(*value, 5)).collect();
    html! {
        details class="note" {
            summary { "Evidence" }
            p { (bound(equation)) @if !values.is_empty() { " At this state the value is " (values.join(", ")) "." } }
        }
    }
}

/// The bound of a certificate, or why there is none.
fn bound(equation: &Equation) -> Markup {
    let finding = &equation.finding;
    html! {
        @match (finding.false_accept_log2, &finding.not_certified_because) {
            (Some(power), _) => { "It is false with a probability below 2" sup { (format!("{:.0}", power.ceil())) } "." }
            (None, Some(reason)) => { "It was tested at sampled states and is not certified, because exact arithmetic \
                                       does not decide " (reason) "." }
            (None, None) => {}
        }
    }
}

/// The LaTeX of a display without its number.
fn untagged(latex: &str) -> String {
    match latex.find("\\tag{") {
        Some(at) => latex[..at].to_owned(),
        None => latex.to_owned(),
    }
}
