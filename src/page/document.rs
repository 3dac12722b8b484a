//! The page of one document: its text, each display typeset with its verdict, and the evidence behind it.

use maud::{Markup, html};

use super::corrections::{self, Correction};
use super::evidence;
use super::{badge, beside, chips, equation_anchor, graph, prose, tex_prose, tone, typeset};
use crate::check::{Document, Equation};
use crate::lecture::Beside;
use crate::notes::markdown::front_matter;
use crate::notes::{Display, Kind, MacroDefinition, Notes};
use crate::source::Span;

/// The displays of a document and the macros of its author.
pub(super) fn displays(document: &Document) -> (Vec<Display>, Vec<MacroDefinition>) {
    let notes = Notes::parse(document.source.clone(), kind(document));
    notes.map_or_else(|_| (Vec::new(), Vec::new()), |notes| (notes.equations, notes.macros))
}

/// The display of an equation.
pub(super) fn display_of<'d>(item: &Equation, displays: &'d [Display]) -> Option<&'d Display> {
    let is_it = |display: &&Display| display.line == item.line && display.id() == Some(item.id.as_str());
    // Without a claims file the equations have names that are not in the notes, and a display may have several.
    let is_there = |display: &&Display| {
        let lines = display.line..=display.line + display.text.matches('\n').count() + 2;
        lines.contains(&item.line) && display.text.contains(item.latex.trim())
    };
    let by_line = || displays.iter().find(|display| display.line == item.line);
    displays.iter().find(is_it).or_else(|| displays.iter().rfind(is_there)).or_else(by_line)
}

/// The part of a display that an equation prints, as a display.
fn part(item: &Equation, display: &Display) -> Display {
    let text = item.latex.trim();
    let is_it = |at: &usize| item.line <= display.line + display.text[..*at].matches('\n').count() + 1;
    let places: Vec<usize> = display.text.match_indices(text).map(|(at, _)| at).collect();
    let Some(at) = places.iter().copied().find(is_it).or(places.first().copied()) else { return display.clone() };
    let body = Span::new(at, at + text.len()).shifted(display.body.start);
    Display { body, text: text.to_owned(), ..display.clone() }
}

fn kind(document: &Document) -> Kind {
    Kind::of(std::path::Path::new(&document.path)).unwrap_or(Kind::Markdown)
}

/// The title of a document: that in its settings, its first heading, or else the name of its file.
pub(super) fn title(document: &Document) -> String {
    let text = &document.source.text;
    let heading = match kind(document) {
        Kind::Markdown => {
            let (settings, body) = text.split_at(front_matter(text));
            let set = settings.lines().find_map(|line| line.strip_prefix("title:"));
            let set = set.map(|title| title.trim().trim_matches(['"', '\'']));
            set.or_else(|| body.lines().find_map(|line| line.strip_prefix("# "))).map(str::to_owned)
        }
        _ => ["\\title{", "\\section{", "\\section*{"].iter().find_map(|command| {
            let (_, rest) = text.split_once(command)?;
            Some(rest.split_once('}')?.0.to_owned())
        }),
    };
    let stem = || std::path::Path::new(&document.path).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    heading.map(|title| title.trim().to_owned()).filter(|title| !title.is_empty()).or_else(stem).unwrap_or_default()
}

/// The page of a document; `prefix` stands before the anchors of its equations, and `after` follows its text.
pub(super) fn document(document: &Document, prefix: &str, derived: Option<&Beside>, after: &Markup) -> Markup {
    let kind = kind(document);
    let (displays, macros) = displays(document);
    let text = &document.source.text;
    let mut from = if kind == Kind::Markdown { front_matter(text) } else { 0 };
    // The title in the settings stands above the text, unless the text has its own.
    let has_heading = kind == Kind::Markdown && text[from..].lines().any(|line| line.starts_with("# "));
    let mut blocks = Vec::new();
    for display in &displays {
        blocks.push(words(text.get(from..display.span.start).unwrap_or_default(), kind, &macros));
        blocks.push(shown((document, derived), display, &displays, &macros, prefix));
        from = display.span.end + label_length(&text[display.span.end..]);
    }
    blocks.push(words(text.get(from..).unwrap_or_default(), kind, &macros));
    html! {
        header class="page" {
            p class="path" { (document.path) }
            @if !has_heading { h1 { (title(document)) } }
            (chips(document))
        }
        article { @for block in &blocks { (block) } }
        @if let Some(graph) = graph::graph(document, prefix) {
            section { h2 { "Which equation depends on which" } (graph) }
        }
        (after)
        @if !document.sentences.is_empty() {
            section {
                h2 { "Sentences that were checked" }
                @for sentence in &document.sentences { (equation(sentence, None, (document, None), &macros, prefix)) }
            }
        }
        @if !document.inferred.is_empty() {
            details { summary { "What was inferred" } ul { @for line in &document.inferred { li { (line) } } } }
        }
    }
}

/// The number of bytes of the label that Quarto writes after a display, as ` {#eq-energy}`. It is no prose.
fn label_length(after: &str) -> usize {
    let label = after.trim_start_matches(' ');
    let space = after.len() - label.len();
    label.strip_prefix("{#").and_then(|rest| rest.find('}')).map_or(0, |end| space + 2 + end + 1)
}

/// A part of the text between two displays.
pub(super) fn words(text: &str, kind: Kind, macros: &[MacroDefinition]) -> Markup {
    match kind {
        Kind::Markdown => prose::markdown(text, macros),
        _ => tex_prose::prose(text, macros),
    }
}

fn shown(
    (document, derived): (&Document, Option<&Beside>),
    display: &Display,
    displays: &[Display],
    macros: &[MacroDefinition],
    prefix: &str,
) -> Markup {
    let is_it = |item: &&Equation| display_of(item, displays).is_some_and(|found| found.span == display.span);
    let items: Vec<&Equation> = document.equations.iter().filter(is_it).collect();
    match items.as_slice() {
        [item] => equation(item, Some(display), (document, derived), macros, prefix),
        [_, _, ..] => html! {
            @for item in items { (equation(item, Some(&part(item, display)), (document, derived), macros, prefix)) }
        },
        [] => html! {
            div class="display wide" tabindex="0" role="group" aria-label="A display that was not checked" {
                (typeset::block(&display.text, macros))
            }
        },
    }
}

/// An equation or a sentence with its verdict, its correction if it is wrong, and its evidence.
fn equation(
    item: &Equation,
    display: Option<&Display>,
    (document, derived): (&Document, Option<&Beside>),
    macros: &[MacroDefinition],
    prefix: &str,
) -> Markup {
    let verdict = item.finding.verdict;
    let anchor = equation_anchor(prefix, &item.id);
    html! {
        section class={ "equation " (verdict.word()) " " (tone(verdict, item.ok)) } id=(anchor) {
            @match display {
                Some(display) => {
                    div class="wide" tabindex="0" role="group" aria-label={ "Equation (" (item.id) ")" } {
                        (printed(item, display, macros))
                    }
                }
                None => blockquote { (prose::inline(&quoted(item, document), macros)) },
            }
            details open[!item.ok] {
                summary {
                    span class="number" { "(" (item.id) ")" } " " (badge(verdict, item.ok))
                    span class="hint" { (evidence::short(item)) }
                }
                div class="evidence" {
                    (evidence::evidence(item, document, display, macros, prefix))
                    (beside::lineup(item, display, derived, &document.definitions))
                    (beside::sides(item, display, derived, &document.definitions))
                }
            }
            @if let Some(found) = display.and_then(|display| corrections::errata(item, display)) {
                (corrected(&found, "Corrected", macros))
            } @else if let Some(reason) = item.because.as_ref().filter(|_| !verdict.passes()) {
                p class="correction" { b { "Known: " } (prose::inline(reason, macros)) }
            }
            @for repair in &item.repairs {
                (corrected(
                    &corrections::repair(repair, display, document.source.slice(repair.span)),
                    &format!("With this edit the verdict would be {}", repair.verdict.word()),
                    macros,
                ))
            }
        }
    }
}

/// A sentence as it is quoted, with the dollar signs of the formulas in which it begins and ends.
pub(super) fn quoted(item: &Equation, document: &Document) -> String {
    let (text, span) = (&document.source.text, item.finding.span);
    if text.get(span.start..span.end) != Some(item.latex.as_str()) {
        return item.latex.clone();
    }
    let before = text.get(..span.start).unwrap_or_default();
    let paragraph = before.rfind("\n\n").map_or(before, |at| before.get(at..).unwrap_or_default());
    let opened = if paragraph.matches('$').count() % 2 == 1 { "$" } else { "" };
    let quote = format!("{opened}{}", item.latex);
    let closed = if quote.matches('$').count() % 2 == 1 { "$" } else { "" };
    quote + closed
}

/// The display as it is printed, with the wrong part marked.
pub(super) fn printed(item: &Equation, display: &Display, macros: &[MacroDefinition]) -> Markup {
    let faults = corrections::faults(item, display);
    let marked = (!faults.is_empty()).then(|| typeset::marked(&display.text, macros, &faults)).flatten();
    marked.unwrap_or_else(|| typeset::block(&display.text, macros))
}

/// The corrected equation with the new part marked, and the edit in words.
pub(super) fn corrected(correction: &Correction, title: &str, macros: &[MacroDefinition]) -> Markup {
    let part = |latex: &str| html! { span class="part" tabindex="0" role="group" aria-label="Formula" { (typeset::inline(latex.trim(), macros)) } };
    html! {
        div class="correction" {
            p {
                b { (title) ": " }
                @match (correction.printed.trim().is_empty(), correction.read.trim().is_empty()) {
                    (true, true) => {}
                    (true, false) => { "add " (part(&correction.read)) }
                    (false, true) => { "leave out " (part(&correction.printed)) }
                    (false, false) => { "for " (part(&correction.printed)) " read " (part(&correction.read)) }
                }
            }
            @if let Some((text, parts)) = &correction.corrected {
                div class="wide" tabindex="0" role="group" aria-label="The corrected equation" {
                    (typeset::marked(text, macros, parts).unwrap_or_else(|| typeset::block(text, macros)))
                }
            }
        }
    }
}
