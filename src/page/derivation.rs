//! A lecture as a page: headings and sentences, each line typeset with its certificate and its value.

use maud::{Markup, html};

use super::{badge, equation_anchor, prose, typeset};
use crate::lecture::text::{drawn, evidence};
use crate::lecture::{Lecture, Line, Passage};

/// The lecture; `prefix` stands before the anchors of its lines.
pub(super) fn lecture(lecture: &Lecture, prefix: &str) -> Markup {
    html! {
        header {
            p class="path" { (lecture.name) }
            h1 { "From the parts to the equations of motion" }
            p {
                "Each line below was derived by the program and typeset by it. Then the page was checked as any other notes "
                "are: a line is taken for granted, or it is certified against the lines before it. The bound is on the "
                "probability that a certified line is false. The values are those at one state: " (drawn(lecture)) "."
            }
        }
        article {
            @for passage in &lecture.passages {
                @match passage {
                    Passage::Heading(text) => h2 { (prose::inline(text, &[])) },
                    Passage::Sentence(text) => p { (prose::inline(text, &[])) },
                    Passage::Line(line) => (shown(lecture, line, prefix)),
                }
            }
        }
    }
}

fn shown(lecture: &Lecture, line: &Line, prefix: &str) -> Markup {
    let Some(equation) = lecture.equation(line) else { return html! {} };
    let verdict = equation.finding.verdict;
    html! {
        section class={ "equation " (verdict.word()) } id=(equation_anchor(prefix, &line.number)) {
            div class="line" {
                div class="wide" tabindex="0" role="region" aria-label={ "Equation " (line.number) } {
                    (typeset::block(&untagged(&equation.latex), &[]))
                }
                span class="number" { "(" (line.number) ")" }
                (badge(verdict, equation.ok))
            }
            p class="path" {
                (evidence(line, equation))
                @if !line.from.is_empty() {
                    " · see "
                    @for number in &line.from { a href={ "#" (equation_anchor(prefix, number)) } { "(" (number) ")" } " " }
                }
            }
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
