//! The pages of a marked class: an index, and a page for each student with every line typeset and its mark beside it.

use maud::{Markup, html};

use super::corrections::Correction;
use super::evidence::capital;
use super::{Page, framed, style, typeset, way_back};
use crate::check::mark::{Derived, Line, Mark, Marked, Reached};
use crate::notes::{Kind, MacroDefinition, Notes};
use crate::report::marks::{Hints, called, correction, hint, number};

/// The pages of a class.
pub fn class_pages(problem: &str, class: &[Marked], hints: Hints) -> Vec<Page> {
    let names = names(class);
    let page = |name: &str, title: &str, body: &Markup| Page {
        name: name.to_owned(),
        text: framed(title, &way_back(name, "All students"), body, false).into_string(),
    };
    let mut all = vec![page("index.html", "Marks", &index(problem, class, &names))];
    for (marked, name) in class.iter().zip(&names) {
        all.push(page(name, &marked.student, &student(marked, hints)));
    }
    all.push(Page { name: "style.css".to_owned(), text: style::STYLE.to_owned() });
    all
}

fn names(class: &[Marked]) -> Vec<String> {
    let mut names: Vec<String> = vec!["index.html".to_owned()];
    for marked in class {
        let plain = |c: char| if c.is_alphanumeric() || c == '-' || c == '_' { c } else { '-' };
        let stem: String = marked.student.chars().map(plain).collect();
        let all = std::iter::once(format!("{stem}.html")).chain((2..).map(|n| format!("{stem}-{n}.html")));
        let name = all.into_iter().find(|name| !names.contains(name));
        names.extend(name);
    }
    names.remove(0);
    names
}

fn index(problem: &str, class: &[Marked], names: &[String]) -> Markup {
    html! {
        header {
            h1 { "Marks" }
            p { (class.len()) @if class.len() == 1 { " hand-in" } @else { " hand-ins" } ", marked by " (file_name(problem)) "." }
        }
        div class="wide" tabindex="0" role="group" aria-label="Students and their points" {
            table {
                thead { tr {
                    th scope="col" { "student" } th scope="col" { "points" } th scope="col" { "right" }
                    th scope="col" { "wrong" } th scope="col" { "carried" } th scope="col" { "missing" }
                    th scope="col" { "to look at" }
                } }
                tbody {
                    @for (marked, name) in class.iter().zip(names) {
                        tr {
                            th scope="row" { a href=(name) { (marked.student) } }
                            td { (number(marked.got())) "/" (number(marked.points())) }
                            td { (marked.count(Mark::Right)) } td { (marked.count(Mark::Wrong)) } td { (marked.count(Mark::Carried)) }
                            td { (marked.results.iter().filter(|result| result.reached == Reached::No).count()) }
                            td { (marked.count(Mark::Unread) + marked.count(Mark::Open) + usize::from(marked.fault.is_some())) }
                        }
                    }
                }
            }
        }
    }
}

fn student(marked: &Marked, hints: Hints) -> Markup {
    let kind = Kind::of(std::path::Path::new(&marked.source.path)).unwrap_or(Kind::Markdown);
    let notes = Notes::parse(marked.source.clone(), kind);
    let (displays, macros) = notes.map_or_else(|_| (Vec::new(), Vec::new()), |notes| (notes.equations, notes.macros));
    let text = &marked.source.text;
    let mut from = 0;
    let mut blocks = Vec::new();
    for display in &displays {
        blocks.push(super::document::words(text.get(from..display.span.start).unwrap_or_default(), kind, &macros));
        for (at, line) in marked.lines.iter().enumerate().filter(|(_, line)| display.span.contains(line.span)) {
            blocks.push(shown(marked, (at, line), &macros, hints));
        }
        from = display.span.end;
    }
    blocks.push(super::document::words(text.get(from..).unwrap_or_default(), kind, &macros));
    let inline: Vec<(usize, &Line)> = marked.lines.iter().enumerate().filter(|(_, line)| line.inline).collect();
    html! {
        header {
            h1 { (marked.student) }
            p class="path" { (file_name(&marked.source.path)) }
            p { (number(marked.got())) " of " (number(marked.points())) " points" }
        }
        @if let Some(fault) = &marked.fault { p { "This file could not be read: " (fault) "." } }
        @if hints.0 == 0 && marked.is_wrong() { p { "Something in this hand-in is wrong or missing." } }
        @if !marked.letters.is_empty() {
            p { "Letters: " @for (at, (own, other)) in marked.letters.iter().enumerate() {
                @if at > 0 { ", " } (typeset::inline(own, &macros)) " stands for " (typeset::inline(other, &macros))
            } "." }
        }
        // The table would say where something is wrong.
        @if hints.0 > 0 { (results(marked)) }
        article { @for block in &blocks { (block) } }
        @if !inline.is_empty() {
            section aria-labelledby="inline" {
                h2 id="inline" { "Equations inside the text" }
                @for (at, line) in inline { (shown(marked, (at, line), &macros, hints)) }
            }
        }
        @if hints.0 > 0 { (legend(marked)) }
    }
}

/// The results that are wanted, with what is reached of them.
fn results(marked: &Marked) -> Markup {
    html! {
        section aria-labelledby="results" {
            h2 id="results" { "Results" }
            div class="wide" tabindex="0" role="group" aria-label="Results and their points" {
                table {
                    thead { tr { th scope="col" { "result" } th scope="col" { "reached" } th scope="col" { "points" } } }
                    tbody {
                        @for result in &marked.results {
                            tr {
                                th scope="row" { (called(result)) }
                                td {
                                    (result.reached.word())
                                    @if let Some(line) = result.line {
                                        ", " a href={ "#line-" (line) } { (marked.lines[line].name) }
                                    }
                                }
                                td { (number(result.got)) " of " (number(result.points)) }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// What the marks on the page mean, as far as they occur.
fn legend(marked: &Marked) -> Markup {
    let all = [
        (Mark::Right, "It follows from the problem."),
        (Mark::Wrong, "It is false, and follows from no line before it."),
        (
            Mark::Carried,
            "It is false, but the step is right: it follows from a false line before it. A mistake costs points only once.",
        ),
        (Mark::Given, "It gives a name, a condition or a value, and needs no proof."),
        (Mark::Open, "It was not decided. Your teacher looks at it."),
        (Mark::Unread, "It was not read. Your teacher looks at it."),
    ];
    html! {
        section aria-labelledby="legend" {
            h2 id="legend" { "What the marks mean" }
            dl class="legend" {
                @for (mark, meaning) in all.iter().filter(|(mark, _)| marked.count(*mark) > 0) {
                    div { dt { span class={ "badge " (tone(*mark)) } { (mark.sign()) " " (mark.word()) } } dd { (meaning) } }
                }
            }
        }
    }
}

/// A path without its folders, which say nothing to a student.
fn file_name(path: &str) -> &str {
    std::path::Path::new(path).file_name().and_then(|name| name.to_str()).unwrap_or(path)
}

/// The tone of a mark.
fn tone(mark: Mark) -> &'static str {
    match mark {
        Mark::Right => "good",
        Mark::Given => "given",
        Mark::Wrong => "bad",
        Mark::Carried => "known",
        Mark::Open | Mark::Unread => "open",
    }
}

/// What is said to the student of a line: what only a teacher can change is not told.
fn said(line: &Line) -> String {
    match line.mark {
        Mark::Open => "This line was not decided here. Your teacher looks at it".to_owned(),
        Mark::Unread => "This line was not read here. Your teacher looks at it".to_owned(),
        _ => format!("This line {}", line.because),
    }
}

/// What to do with a wrong line.
fn advice(marked: &Marked, at: usize) -> &'static str {
    let is_sound = |line: &Line| matches!(line.mark, Mark::Right | Mark::Given);
    let before = &marked.lines[..at];
    match (before.iter().any(|line| line.mark == Mark::Right), before.iter().all(is_sound)) {
        (false, true) => "Check this line",
        (_, true) => "Check this step: the lines before it are right",
        (_, false) => "Check this step",
    }
}

fn shown(marked: &Marked, (at, line): (usize, &Line), macros: &[MacroDefinition], hints: Hints) -> Markup {
    let tone = tone(line.mark);
    let class = if hints.0 == 0 { "given" } else { tone };
    html! {
        section class={ "equation " (class) } id={ "line-" (at) } aria-label=(line.name) {
            div class="line" {
                div class="wide" tabindex="0" role="group" aria-label={ "The equation of " (line.name) } {
                    (typeset::block(&line.statement, macros))
                }
                span class="number" { (line.id.as_deref().unwrap_or(&line.name)) } " "
                @if hints.0 > 0 { span class={ "badge " (tone) } { (line.mark.sign()) " " (line.mark.word()) } }
            }
            @if hints.0 > 0 {
                p {
                    (said(line))
                    @let is_named = |from: &usize| line.because.to_string().contains(&marked.lines[*from].name);
                    @if let Some(from) = line.follows_from.filter(|from| line.mark == Mark::Carried && !is_named(from)) { " (" a href={ "#line-" (from) } { (marked.lines[from].name) } ")" }
                    "."
                    @for result in marked.results.iter().filter(|result| result.line == Some(at)) {
                        " Result " (called(result)) ": " (number(result.got)) " of " (number(result.points)) " points."
                    }
                }
                @if line.mark == Mark::Wrong {
                    @match (line.derived.as_ref(), corrected(marked, line)) {
                        (_, Some(correction)) if hints.0 >= 3 => {
                            p { (capital(&hint(marked, line, Hints(2)))) "." }
                            (super::document::corrected(&correction, "Correction", macros))
                        }
                        (Some(derived), None) if hints.0 >= 3 => {
                            @let (lead, label, formula) = match derived {
                                Derived::Instead(formula) => ("The derived equation is:", "Derived equation", formula),
                                Derived::Difference(formula) => ("Left side − right side is not 0:", "Left side minus right side", formula),
                            };
                            p { (capital(&hint(marked, line, Hints(2)))) ". " (lead) }
                            div class="wide" tabindex="0" role="group" aria-label=(label) { (typeset::block(formula, macros)) }
                        }
                        _ if hints.0 == 1 => p { (advice(marked, at)) "." },
                        _ => p { (capital(&hint(marked, line, hints))) "." },
                    }
                }
            }
        }
    }
}

/// The edit that corrects a wrong line, and the line with it.
fn corrected(marked: &Marked, line: &Line) -> Option<Correction> {
    let (printed, read) = correction(marked, line)?;
    let slip = line.slip.as_ref().filter(|slip| line.span.contains(slip.span))?;
    let mut text = marked.source.slice(line.span).to_owned();
    let start = slip.span.start - line.span.start;
    text.replace_range(start..slip.span.end - line.span.start, &format!(" {read} "));
    let new = (!read.is_empty()).then(|| (start + 1..start + 1 + read.len(), super::math_marks::Mark::Correction));
    Some(Correction { printed, read, corrected: Some((text, new.into_iter().collect())) })
}
