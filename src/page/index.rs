//! The first page: what onshell is, every equation with its verdict, and beside them what is wrong and how it should read.

use maud::{Markup, html};

use super::document::{display_of, displays, title};
use super::{badge, chips, corrections, derivation, equation_anchor, prefix, prose, tone, typeset};
use crate::check::{Document, Equation, Report, Verdict};
use crate::lecture::Lecture;

/// The index. `link` gives the address of each document.
pub(super) fn index(
    report: &Report,
    lectures: &[(String, &Lecture)],
    link: &dyn Fn(usize) -> String,
    single: bool,
) -> Markup {
    let is_found = |item: &&Equation| !item.ok || !item.finding.verdict.passes();
    let address = |at: usize, item: &Equation| {
        let before =
            if single { prefix(&format!("{}.html", link(at).trim_start_matches("#document-"))) } else { String::new() };
        let page = if single { String::new() } else { link(at) };
        format!("{page}#{}", equation_anchor(&before, &item.id))
    };
    html! {
        (introduction(report))
        div class="gallery" {
            section class="equations" aria-labelledby="equations" {
                h2 id="equations" { "The equations" }
                @for (at, document) in report.documents.iter().enumerate() {
                    @let (displays, macros) = displays(document);
                    section {
                        h3 { a href=(link(at)) { (prose::inline(&title(document), &macros)) } }
                        p class="path" { (document.path) }
                        (chips(document))
                        ul class="list" {
                            @for item in &document.equations {
                                li class=(tone(item.finding.verdict, item.ok)) {
                                    div class="head" {
                                        a href=(address(at, item)) { "(" (item.id) ")" } " "
                                        (badge(item.finding.verdict, item.ok))
                                    }
                                    div class="wide" tabindex="0" role="group" aria-label={ "Equation (" (item.id) ")" } {
                                        @match display_of(item, &displays) {
                                            Some(display) => (super::document::printed(item, display, &macros)),
                                            None => (typeset::block(&item.latex, &macros)),
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
            }
            aside aria-labelledby="found" {
                h2 id="found" { "What was found" }
                @if !report.items().any(|item| is_found(&item)) { p { "Nothing is wrong, and nothing was left \
                                                                       undecided." } }
                ul class="found" {
                    @for (at, document) in report.documents.iter().enumerate() {
                        @let (displays, macros) = displays(document);
                        @for item in document.equations.iter().chain(&document.sentences).filter(is_found) {
                            li class=(tone(item.finding.verdict, item.ok)) {
                                div class="head" { a href=(address(at, item)) { "(" (item.id) ")" } " " (badge(item.finding.verdict, item.ok)) }
                                (found(item, document, &displays, &macros))
                            }
                        }
                    }
                }
            }
        }
        @if !lectures.is_empty() {
            section aria-labelledby="derivations" {
                h2 id="derivations" { "Derivations, line by line" }
                p { "From the parts of a system to its equations of motion. The program derives and typesets each line, and certifies it against the lines before it." }
                ul {
                    @for (name, lecture) in lectures {
                        @let address = if single { format!("#{name}") } else { format!("{name}.html") };
                        li { a href=(address) { (derivation::title(lecture)) } ", " (lecture.lines().count()) " lines" }
                    }
                }
            }
        }
    }
}

/// What onshell is, how many equations there are, and what the verdicts mean.
fn introduction(report: &Report) -> Markup {
    let equations: usize = report.documents.iter().map(|document| document.equations.len()).sum();
    let sentences: usize = report.documents.iter().map(|document| document.sentences.len()).sum();
    let errata = report.items().filter(|item| item.ok && item.finding.verdict == Verdict::Refuted).count();
    let wrong = report.unexpected();
    // These are rare, and are explained where they occur.
    let occurs = |verdict: Verdict| {
        !matches!(verdict, Verdict::Law | Verdict::Assumed | Verdict::Unreadable)
            || report.items().any(|item| item.finding.verdict == verdict)
    };
    let plural =
        |count: usize, one: &str| if count == 1 { format!("{count} {one}") } else { format!("{count} {one}s") };
    html! {
        header class="page front" {
            h1 { "Checked equations" }
            p class="lead" {
                "onshell reads the equations in physics notes. It derives independently what is true, from a \
                 Lagrangian by automatic "
                "differentiation, or from laws. Each equation gets a verdict with its evidence."
            }
            p class="figures" {
                span { b { (equations) } " " (if equations == 1 { "equation" } else { "equations" }) } " "
                span { b { (sentences) } " " (if sentences == 1 { "sentence" } else { "sentences" }) } " "
                span { b { (errata) } " " (if errata == 1 { "erratum" } else { "errata" }) } " "
                span { b { (wrong) } " not as expected" }
            }
            p class="visually-hidden" { (plural(equations, "equation")) " and " (plural(sentences, "sentence")) " in " (plural(report.documents.len(), "document")) "." }
            dl class="legend" {
                @for (verdict, ok, meaning) in [
                    (Verdict::Certified, true, "holds, and exact arithmetic confirms it; the probability of an error is given"),
                    (Verdict::Verified, true, "holds at every sampled state"),
                    (Verdict::Definition, true, "defines a name, and other equations test it"),
                    (Verdict::Law, true, "a law that the claims file names; it is taken for granted and not checked"),
                    (Verdict::Assumed, true, "no derivation from the other displays was found, so it is taken for granted"),
                    (Verdict::Refuted, false, "wrong: it fails at a sampled state, which is shown; a correction is shown where one was found"),
                    (Verdict::Refuted, true, "a known mistake: it is wrong, as the claims file expects"),
                    (Verdict::Undecided, false, "not decided; the reason is given"),
                    (Verdict::Unreadable, false, "not read, or not supported; the reason is given"),
                ].into_iter().filter(|(verdict, ..)| occurs(*verdict)) {
                    div { dt { (badge(verdict, ok)) } dd { (meaning) } }
                }
            }
        }
    }
}

/// A finding in a few lines: the equation corrected, or the reason.
fn found(
    item: &Equation,
    document: &Document,
    displays: &[crate::notes::Display],
    macros: &[crate::notes::MacroDefinition],
) -> Markup {
    let display = display_of(item, displays).filter(|display| display.body.contains(item.finding.span));
    let correction = display.and_then(|display| {
        let repair =
            item.repairs.first().map(|repair| corrections::repair(repair, Some(display), printed(repair, display)));
        corrections::errata(item, display).or(repair)
    });
    html! {
        @if display.is_none() { blockquote { (prose::inline(super::document::quoted(item, document).trim(), macros)) } }
        @match (&correction, &item.because) {
            (Some(correction), _) => (super::document::corrected(correction, "Corrected", macros)),
            (None, Some(reason)) => p { (prose::inline(reason, macros)) },
            (None, None) => p { (item.finding.message) },
        }
    }
}

fn printed<'d>(repair: &crate::check::Repair, display: &'d crate::notes::Display) -> &'d str {
    let range =
        repair.span.start.saturating_sub(display.body.start)..repair.span.end.saturating_sub(display.body.start);
    display.text.get(range).unwrap_or_default()
}
