//! The report: the findings of equations and sentences, of documents, and of a run.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::source::Source;

use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;

/// One statement of an equation, or one more thing that is claimed of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The source of the statement, exactly as it stands in the notes.
    pub latex: String,
    /// How it was read.
    pub reading: String,
    /// The worst finding of it.
    pub finding: Finding,
    /// Whether the verdict is what was expected.
    pub ok: bool,
}

/// An equation of a document, or a sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The printed number (`6.73`), the label, or a name.
    pub id: String,
    /// The line on which it starts, from 1.
    pub line: usize,
    /// The source, exactly as it stands in the notes.
    pub latex: String,
    /// How it was read.
    pub reading: String,
    /// The worst finding of its parts.
    pub finding: Finding,
    /// Whether the verdict is what was expected.
    pub ok: bool,
    /// Why another verdict than a pass is expected, if one is.
    pub because: Option<String>,
    /// Its statements and what else is claimed of it, where there are several.
    pub parts: Vec<Part>,
    /// Where it does not pass: the single edits with which it would, the likeliest first.
    pub repairs: Vec<Repair>,
    /// What it stands on, and nothing that holds does, by what it is called: the slip may be there.
    pub elsewhere: Vec<String>,
}

/// What was found in one document.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The notes file, relative to where the command was started.
    pub path: String,
    /// The claims file; none, where there is none.
    pub claims: Option<String>,
    /// The notes as read.
    pub source: Arc<Source>,
    /// The numbered equations in order.
    pub equations: Vec<Equation>,
    /// The sentences that the claims file turned into tests.
    pub sentences: Vec<Equation>,
    /// How many displays have neither a number nor a claim, and were not checked.
    pub unnumbered: usize,
    /// What was inferred: how the symbols were mapped, what was taken for granted.
    pub inferred: Vec<String>,
}

/// What was found in all documents of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The documents in the order of their paths.
    pub documents: Vec<Document>,
}

impl Report {
    /// Equations and sentences together.
    pub fn items(&self) -> impl Iterator<Item = &Equation> {
        self.documents.iter().flat_map(|document| document.equations.iter().chain(&document.sentences))
    }

    /// How often each verdict was given to an equation or a sentence.
    pub fn counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        for item in self.items() {
            *counts.entry(item.finding.verdict.word()).or_insert(0) += 1;
        }
        counts
    }

    /// How many are not as expected.
    pub fn unexpected(&self) -> usize {
        self.items().filter(|item| !item.ok).count()
    }

    /// 0: all as expected; 1: something was found wrong; 2: something could not be checked, or there was nothing.
    pub fn exit_code(&self) -> u8 {
        let wrong = |item: &Equation| !item.ok && matches!(item.finding.verdict, Verdict::Refuted | Verdict::Domain);
        let passed_against_expectation = |item: &Equation| !item.ok && item.finding.verdict.passes();
        if self.items().any(|item| wrong(item) || passed_against_expectation(item)) {
            1
        } else if self.unexpected() > 0 || self.items().next().is_none() {
            2
        } else {
            0
        }
    }
}
