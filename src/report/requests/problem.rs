//! What is not as expected in a report, one [`Problem`] for each: what the formats for other programs print.

use crate::Error;
use crate::check::{Document, Equation, Report, Verdict};
use crate::code::Code;
use crate::source::{FileEdit, Place};

use super::super::code;
use super::super::headline::headline;

/// An equation, a sentence or an error that a report is about.
pub(super) struct Problem<'a> {
    pub code: Code,
    /// What is wrong: a sentence without its full stop.
    pub message: String,
    /// Where, if it is in a file.
    pub place: Option<Place<'a>>,
    /// Edits of a file with which it would pass, each with its verdict.
    pub edits: Vec<(FileEdit<'a>, Verdict)>,
    /// What to do next.
    pub help: Option<&'a str>,
}

/// All that is not as expected, in order.
pub(super) fn all<'a>(report: &'a Report, errors: &'a [Error]) -> Vec<Problem<'a>> {
    let items = report.documents.iter().flat_map(|document| {
        let items = document.equations.iter().chain(&document.sentences).filter(|item| !item.ok);
        items.map(move |item| problem(document, item))
    });
    let errors = errors.iter().map(|error| Problem {
        code: error.code(),
        message: error.message().to_owned(),
        place: error.place().map(|(source, span)| source.place(span)),
        edits: Vec::new(),
        help: error.advice(),
    });
    items.chain(errors).collect()
}

/// What is not as expected of an equation.
pub(super) fn problem<'a>(document: &'a Document, item: &'a Equation) -> Problem<'a> {
    let finding = code::first_unexpected(item);
    let edits = item.repairs.iter().filter_map(|repair| {
        let edit = document.source.edit(repair.span, &repair.replacement).ok()?;
        Some((edit, repair.verdict))
    });
    Problem {
        code: finding.code,
        message: headline(item, finding),
        place: Some(document.source.place(finding.span)),
        edits: edits.collect(),
        help: None,
    }
}
