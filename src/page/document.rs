//! The page of one document: its text, each display typeset with its verdict, and the evidence behind it.

use maud::{Markup, html};

use super::{badge, counts, equation_anchor, prose, typeset};
use crate::check::{Document, Equation, Repair};
use crate::notes::{Display, Kind, MacroDefinition, Notes};
use crate::report::diagnostic::evidence;
use crate::source::{Source, Span};

/// The page of a document; `prefix` stands before the anchors of its equations.
pub(super) fn document(document: &Document, prefix: &str) -> Markup {
    let kind = Kind::of(std::path::Path::new(&document.path)).unwrap_or(Kind::Markdown);
    let notes = Notes::parse(document.source.clone(), kind);
    let (displays, macros) = notes.map_or_else(|_| (Vec::new(), Vec::new()), |notes| (notes.equations, notes.macros));
    let text = &document.source.text;
    let mut from = 0;
    let mut blocks = Vec::new();
    for display in &displays {
        blocks.push(prose::prose(text.get(from..display.span.start).unwrap_or_default(), kind, &macros));
        blocks.push(shown(document, display, &macros, prefix));
        from = display.span.end;
    }
    blocks.push(prose::prose(text.get(from..).unwrap_or_default(), kind, &macros));
    html! {
        header {
            p class="path" { (document.path) }
            p { (counts(document)) }
        }
        article { @for block in &blocks { (block) } }
        @if !document.sentences.is_empty() {
            section {
                h2 { "Sentences that were checked" }
                @for sentence in &document.sentences { (equation(sentence, None, document, &macros, prefix)) }
            }
        }
        @if !document.inferred.is_empty() {
            details { summary { "What was inferred" } ul { @for line in &document.inferred { li { (line) } } } }
        }
    }
}

fn shown(document: &Document, display: &Display, macros: &[MacroDefinition], prefix: &str) -> Markup {
    let is_it = |item: &&Equation| item.line == display.line && Some(item.id.as_str()) == display.id();
    let found = document.equations.iter().find(is_it);
    // Without a claims file the displays have names that are not in the notes.
    let found = found.or_else(|| document.equations.iter().find(|item| item.line == display.line));
    match found {
        Some(item) => equation(item, Some(display), document, macros, prefix),
        None => html! {
            div class="display" { (typeset::block(&display.text, macros)) }
        },
    }
}

fn equation(
    item: &Equation,
    display: Option<&Display>,
    document: &Document,
    macros: &[MacroDefinition],
    prefix: &str,
) -> Markup {
    let finding = &item.finding;
    let source = &document.source;
    html! {
        section class={ "equation " (finding.verdict.word()) } id=(equation_anchor(prefix, &item.id)) {
            div class="line" {
                div class="wide" tabindex="0" role="region" aria-label={ "Equation " (item.id) } {
                    @match display {
                        Some(display) => (typeset::block(&display.text, macros)),
                        None => q { (prose::inline(&item.latex, macros)) },
                    }
                }
                span class="number" { "(" (item.id) ")" }
                (badge(finding.verdict, item.ok))
            }
            details open[!item.ok] {
                summary { "Evidence for (" (item.id) ")" }
                p { (finding.message) }
                @if let Some(reason) = &item.because { p { "Expected, because: " (reason) } }
                @if !item.reading.is_empty() { p { "Read as " code { (item.reading) } } }
                @for part in &item.parts {
                    p { (badge(part.finding.verdict, part.ok)) " " code { (part.reading) } " " (part.finding.message) }
                }
                @if finding.points > 0 { p { "Tried at " (finding.points) " sampled states." } }
                @if let Some(power) = finding.false_accept_log2 {
                    p { "It is false with a probability below 2" sup { (format!("{:.0}", power.ceil())) } "." }
                }
                @if let Some(reason) = &finding.not_certified_because { p { "Not certified because of " (reason) "." } }
                @if let Some(found) = &finding.counterexample {
                    div class="wide" tabindex="0" role="region" aria-label="Counterexample" {
                        table class="state" {
                            caption { "A state at which it fails" }
                            tbody {
                                @for (name, value) in &found.state {
                                    tr { th scope="row" { (typeset::inline(name, macros)) } td { (format!("{value:.5}")) } }
                                }
                                tr { th scope="row" { "left side" } td { (format!("{:.7}", found.lhs)) } }
                                tr { th scope="row" { "right side" } td { (format!("{:.7}", found.rhs)) } }
                            }
                        }
                    }
                }
                @for note in evidence(finding).iter().filter(|note| !note.starts_with("at ") && !note.starts_with("left side ")) {
                    p { (note) }
                }
                @if !finding.verdict.passes() { (excerpt(source, finding.span, "the faulty part is marked")) }
                @for repair in &item.repairs { (correction(repair, display, source, macros)) }
            }
        }
    }
}

/// The corrected equation, and the edit.
fn correction(repair: &Repair, display: Option<&Display>, source: &Source, macros: &[MacroDefinition]) -> Markup {
    let corrected = display.filter(|display| display.body.contains(repair.span)).and_then(|display| {
        let mut text = display.text.clone();
        let range = repair.span.start - display.body.start..repair.span.end - display.body.start;
        text.get(range.clone())?;
        text.replace_range(range, &repair.replacement);
        Some(text)
    });
    let printed = source.slice(repair.span);
    html! {
        div class="repair" {
            p {
                "With this edit it would be " (repair.verdict.word()) ": "
                @if printed.is_empty() { "add " code { (repair.replacement) } }
                @else if repair.replacement.is_empty() { "leave out " code { (printed) } }
                @else { code { (repair.replacement) } " in place of " code { (printed) } }
            }
            @if let Some(text) = &corrected {
                div class="wide" tabindex="0" role="region" aria-label="The corrected equation" { (typeset::block(text, macros)) }
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
        pre class="wide" tabindex="0" aria-label={ "The source; " (label) } {
            code { (part(start, span.start)) mark { (part(span.start, span.end)) } (part(span.end, end)) }
        }
    }
}
