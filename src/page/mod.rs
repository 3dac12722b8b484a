//! The report as pages to read in a browser: the author's text, every equation typeset with its verdict beside it, and
//! the evidence behind it.
//!
//! A page is plain HTML with MathML. It needs no script and loads nothing but its own style sheet. This folder decides
//! nothing; it shows what [`crate::check`] found. [`pages`] gives the texts, and `cli` writes them. It may know `check`,
//! `notes`, `report`, `formula` and level 0.
//!
//! Offers [`pages`], and `class_pages` for a marked class.

mod beside;
mod corrections;
mod derivation;
mod document;
mod evidence;
mod graph;
mod index;
mod math_marks;
mod mathml;
mod prose;
mod student;
mod style;
mod tex_prose;
mod typeset;

pub use student::class_pages;

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::check::{Document, Report, Verdict};
use crate::lecture::{Beside, Lecture};
use crate::plot::Picture;

/// A file of the report.
#[derive(Clone, Debug)]
pub struct Page {
    /// The name of the file.
    pub name: String,
    /// What is in it.
    pub text: String,
}

/// What follows from the system of some documents, to be shown beside them.
pub struct Exhibit {
    /// The derivation, line by line, where there is one.
    pub lecture: Option<Lecture>,
    /// The derived equations, to be held beside the printed ones.
    pub beside: Option<Beside>,
    /// The pictures of the system.
    pub pictures: Vec<Picture>,
    /// The paths of the documents.
    pub documents: Vec<String>,
}

/// The pages of a report: an index and a page for each document, or one page with all.
pub fn pages(report: &Report, exhibits: &[&Exhibit], single: bool) -> Vec<Page> {
    let names = names(report);
    let page = |name: &str, title: &str, body: &Markup| Page {
        name: name.to_owned(),
        text: framed(title, &way_back(name, "All documents"), body, single).into_string(),
    };
    let link = |at: usize| if single { format!("#{}", anchor(&names[at])) } else { names[at].clone() };
    let lectures = lectures(exhibits);
    let index = index::index(report, &lectures, &link, single);
    let exhibit = |at: usize| -> Option<&Exhibit> {
        let path = &report.documents[at].path;
        exhibits.iter().copied().find(|exhibit| exhibit.documents.contains(path))
    };
    let anchor_of = |exhibit: &Exhibit| {
        let own = exhibit.lecture.as_ref()?;
        lectures.iter().find(|(_, lecture)| lecture.notes == own.notes).map(|(anchor, _)| anchor.as_str())
    };
    let document = |at: usize, prefix: &str| {
        let after = html! { @if let Some(exhibit) = exhibit(at) { (beside::after(exhibit, anchor_of(exhibit), prefix, single)) } };
        document::document(
            &report.documents[at],
            prefix,
            exhibit(at).and_then(|exhibit| exhibit.beside.as_ref()),
            &after,
        )
    };
    // Each lecture once, with the pictures of the first exhibit that has it.
    let whole = |(anchor, _): &(String, &Lecture), prefix: &str| {
        let first = exhibits.iter().find(|exhibit| anchor_of(exhibit) == Some(anchor));
        html! { @if let Some(exhibit) = first { (whole(exhibit, prefix)) } }
    };
    if single {
        let body = html! {
            (index)
            @for (at, name) in names.iter().enumerate() {
                section id=(anchor(name)) { (document(at, &prefix(name))) }
            }
            @for lecture in &lectures {
                section id=(lecture.0) { (whole(lecture, &format!("{}-", lecture.0))) }
            }
        };
        return vec![page("index.html", "Checked equations", &body)];
    }
    let mut all = vec![page("index.html", "Checked equations", &index)];
    for (at, name) in names.iter().enumerate() {
        let beside = |at: usize| report.documents.get(at).map(|other| (document::title(other), names[at].as_str()));
        let body = html! {
            (document(at, ""))
            nav class="site" aria-label="Before and after" {
                @if let Some((title, name)) = at.checked_sub(1).and_then(beside) { a href=(name) rel="prev" { "← " (prose::inline(&title, &[])) } }
                @if let Some((title, name)) = beside(at + 1) { a href=(name) rel="next" { (prose::inline(&title, &[])) " →" } }
            }
        };
        all.push(page(name, &document::title(&report.documents[at]), &body));
    }
    for lecture in &lectures {
        all.push(page(&format!("{}.html", lecture.0), &derivation::title(lecture.1), &whole(lecture, "")));
    }
    all.push(Page { name: "style.css".to_owned(), text: style::STYLE.to_owned() });
    all
}

/// The line above a page: the program, and the way to the first page.
fn way_back(name: &str, all: &str) -> Markup {
    html! {
        b { "onshell" }
        @if name != "index.html" { a href="index.html" { (all) } }
    }
}

/// The page of a lecture by itself, with the pictures of its system and its style in it.
pub fn lecture(lecture: &Lecture, pictures: &[Picture]) -> String {
    let body = derivation::lecture(lecture, "", &beside::figures(pictures));
    framed(&derivation::title(lecture), &way_back("index.html", ""), &body, true).into_string()
}

/// The lectures, each once, by name. Each has its anchor in a page with all documents, which is also the name of its own
/// page. No document has it, because the name of its page has no dot in it. Lectures on notes of the same name in two
/// folders have two anchors.
fn lectures<'e>(exhibits: &[&'e Exhibit]) -> Vec<(String, &'e Lecture)> {
    let plain = |c: char| if c.is_alphanumeric() || c == '_' { c } else { '-' };
    let mut all: Vec<(String, &Lecture)> = Vec::new();
    for lecture in exhibits.iter().filter_map(|exhibit| exhibit.lecture.as_ref()) {
        // Documents that are checked one by one may have the same system.
        if all.iter().any(|(_, other)| other.notes == lecture.notes) {
            continue;
        }
        let stem = format!("derivation.{}", lecture.name.chars().map(plain).collect::<String>());
        let names = std::iter::once(stem.clone()).chain((2..).map(|n| format!("{stem}-{n}")));
        let free = names.into_iter().find(|name| all.iter().all(|(other, _)| other != name));
        all.push((free.unwrap_or(stem), lecture));
    }
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all
}

fn whole(exhibit: &Exhibit, prefix: &str) -> Markup {
    let pictures = beside::pictures(exhibit);
    html! { @if let Some(lecture) = &exhibit.lecture { (derivation::lecture(lecture, prefix, &pictures)) } }
}

fn framed(title: &str, way: &Markup, body: &Markup, single: bool) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                @if single { style { (PreEscaped(style::STYLE)) } } @else { link rel="stylesheet" href="style.css"; }
            }
            body {
                a class="skip" href="#main" { "Skip to the text" }
                header { nav aria-label="Pages" class="site" { (way) } }
                main id="main" { (body) }
            }
        }
    }
}

/// A file name for each document, each once.
fn names(report: &Report) -> Vec<String> {
    let mut names: Vec<String> = vec!["index.html".to_owned()];
    for document in &report.documents {
        let stem = Path::new(&document.path).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let plain = |c: char| if c.is_alphanumeric() || c == '-' || c == '_' { c } else { '-' };
        let stem: String = stem.unwrap_or_default().chars().map(plain).collect();
        let numbered = (2..).map(|n| format!("{stem}-{n}.html"));
        let all = std::iter::once(format!("{stem}.html")).chain(numbered);
        let name = all.into_iter().find(|name| !names.contains(name));
        names.extend(name);
    }
    names.remove(0);
    names
}

/// The anchor of a document in a page with all of them.
fn anchor(name: &str) -> String {
    format!("document-{}", name.trim_end_matches(".html"))
}

/// What stands before the anchors of a document's equations in a page with all documents.
fn prefix(name: &str) -> String {
    format!("{}-", name.trim_end_matches(".html"))
}

/// The anchor of an equation.
fn equation_anchor(prefix: &str, id: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || matches!(c, '-' | '_' | '.') { c } else { '-' };
    format!("{prefix}eq-{}", id.chars().map(plain).collect::<String>())
}

/// The colour of a verdict: as it should be, a mistake that is known, or not as it should be.
fn tone(verdict: Verdict, ok: bool) -> &'static str {
    match (ok, verdict.passes()) {
        // What is taken for granted is neither right nor wrong.
        (true, true) if verdict == Verdict::Assumed => "plain",
        (true, true) => "good",
        (true, false) if matches!(verdict, Verdict::Refuted | Verdict::Domain) => "known",
        (false, _) if matches!(verdict, Verdict::Refuted | Verdict::Domain) || verdict.passes() => "bad",
        _ => "open",
    }
}

/// The mark and the word of a verdict, so that colour is never alone.
fn badge(verdict: Verdict, ok: bool) -> Markup {
    let mark = match (ok, verdict) {
        (true, Verdict::Refuted | Verdict::Domain) => "!",
        (true, Verdict::Assumed) => "·",
        (true, _) if verdict.passes() => "✓",
        (false, Verdict::Refuted | Verdict::Domain) => "✗",
        _ => "?",
    };
    let class = format!("badge {}", tone(verdict, ok));
    let word = match (verdict, ok) {
        // What the claims file expects to be refuted is a mistake of the notes that is known.
        (Verdict::Refuted, true) => "erratum",
        // As the summary in the terminal says.
        (Verdict::Assumed, _) => "taken for granted",
        _ => verdict.word(),
    };
    html! { span class=(class) { span aria-hidden="true" { (mark) " " } (word) } }
}

/// How many equations and sentences of a document have each verdict: `16 certified, 2 refuted`.
fn chips(document: &Document) -> Markup {
    let of = |verdict: &Verdict, ok: bool| {
        let items = document.equations.iter().chain(&document.sentences);
        items.filter(|item| item.finding.verdict == *verdict && item.ok == ok).count()
    };
    html! {
        ul class="chips" aria-label="Verdicts" {
            @for verdict in &Verdict::ALL {
                @for ok in [true, false] {
                    @let count = of(verdict, ok);
                    @if count > 0 { li { (count) " " (badge(*verdict, ok)) } }
                }
            }
        }
    }
}
