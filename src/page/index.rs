//! The first page: what onshell is, the documents with their verdicts, and what was found.

use maud::{Markup, html};

use super::{badge, counts, equation_anchor, lecture_anchor, prefix};
use crate::check::{Equation, Report};
use crate::lecture::Lecture;

/// The index. `link` gives the address of each document.
pub(super) fn index(report: &Report, lectures: &[Lecture], link: &dyn Fn(usize) -> String, single: bool) -> Markup {
    let equations: usize = report.documents.iter().map(|document| document.equations.len()).sum();
    let sentences: usize = report.documents.iter().map(|document| document.sentences.len()).sum();
    let is_found = |item: &&Equation| !item.ok || !item.finding.verdict.passes();
    let address = |at: usize, item: &Equation| {
        let before =
            if single { prefix(&format!("{}.html", link(at).trim_start_matches("#document-"))) } else { String::new() };
        let page = if single { String::new() } else { link(at) };
        format!("{page}#{}", equation_anchor(&before, &item.id))
    };
    html! {
        header {
            h1 { "Checked equations" }
            p {
                "onshell checks the equations in physics notes, one by one. It reads the LaTeX of the notes and compares each "
                "equation with an independent derivation: from a Lagrangian, by automatic differentiation, or from laws. An "
                "equation is " b { "certified" } " if it was decided exactly, " b { "verified" } " if it holds at every state "
                "that was tried, and " b { "refuted" } " if it fails at a state, which is then given."
            }
            p { (equations) " equations and " (sentences) " sentences in " (report.documents.len()) " documents." }
        }
        section aria-labelledby="documents" {
            h2 id="documents" { "Documents" }
            div class="wide" tabindex="0" role="region" aria-label="Documents and their verdicts" {
                table {
                    thead { tr { th scope="col" { "document" } th scope="col" { "verdicts" } } }
                    tbody {
                        @for (at, document) in report.documents.iter().enumerate() {
                            tr { td { a href=(link(at)) { (document.path) } } td { (counts(document)) } }
                        }
                    }
                }
            }
        }
        @if !lectures.is_empty() {
            section aria-labelledby="derivations" {
                h2 id="derivations" { "Derivations" }
                p { "The way from the parts of a system to its equations of motion, each line certified:" }
                ul {
                    @for lecture in lectures {
                        @let name = lecture_anchor(lecture);
                        @let address = if single { format!("#{name}") } else { format!("{name}.html") };
                        li { a href=(address) { (lecture.name) } ", " (lecture.lines().count()) " lines" }
                    }
                }
            }
        }
        section aria-labelledby="found" {
            h2 id="found" { "What was found" }
            @if !report.items().any(|item| is_found(&item)) { p { "Nothing is wrong or open." } }
            ul class="found" {
                @for (at, document) in report.documents.iter().enumerate() {
                    @for item in document.equations.iter().chain(&document.sentences).filter(is_found) {
                        li {
                            (badge(item.finding.verdict, item.ok)) " "
                            a href=(address(at, item)) { "(" (item.id) ")" }
                            " in " (document.path) ": "
                            @match &item.because { Some(reason) => { (reason) } None => { (item.finding.message) } }
                        }
                    }
                }
            }
        }
    }
}
