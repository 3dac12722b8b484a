//! The report: the findings of equations and sentences, of documents, and of a run.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::code::Code;
use crate::source::Source;

use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;

/// One statement of an equation, or a further claim about it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Part {
    /// The source of the statement, exactly as in the notes.
    pub latex: String,
    /// How it was read.
    pub reading: String,
    /// The worst finding on it.
    pub finding: Finding,
    /// Whether the verdict is what was expected.
    pub ok: bool,
}

impl Part {
    /// The worst verdict of some parts. A part that gives a name a formula says nothing of the others.
    pub(crate) fn worst(parts: &[Part]) -> Verdict {
        let all = || parts.iter().map(|part| part.finding.verdict);
        let worst = |verdicts: &mut dyn Iterator<Item = Verdict>| verdicts.max_by_key(|verdict| verdict.severity());
        let of_claims = worst(&mut all().filter(|verdict| *verdict != Verdict::Definition));
        of_claims.or_else(|| worst(&mut all())).unwrap_or(Verdict::Verified)
    }
}

/// An equation of a document, or a sentence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Equation {
    /// The printed number (`6.73`), the label, or a name.
    pub id: String,
    /// The line on which it starts, from 1.
    pub line: usize,
    /// The source, exactly as in the notes.
    pub latex: String,
    /// How it was read.
    pub reading: String,
    /// The worst finding of its parts.
    pub finding: Finding,
    /// Whether the verdict is what was expected.
    pub ok: bool,
    /// Why another verdict than a pass is expected, if one is.
    pub because: Option<String>,
    /// The edits that an erratum of the claims file makes, if the equation has one: what is printed, and what is to be read.
    pub errata: Vec<(String, String)>,
    /// The names of the displays on which it rests: they define a symbol in it, or its claim names them.
    pub rests_on: Vec<String>,
    /// Its statements and further claims, if there are several.
    pub parts: Vec<Part>,
    /// The single edits with which a failing equation would pass, the most likely first.
    pub repairs: Vec<Repair>,
    /// The names of the displays that it uses and that no passing equation uses: the mistake may be there.
    pub elsewhere: Vec<String>,
}

/// The findings on one document.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Document {
    /// The path of the notes file, relative to the working directory.
    pub path: String,
    /// The path of the claims file, if there is one.
    pub claims: Option<String>,
    /// Whether nobody has confirmed what the symbols mean: there is no claims file, or it has guesses.
    pub is_guessed: bool,
    /// The notes as read.
    pub source: Arc<Source>,
    /// The numbered equations in order.
    pub equations: Vec<Equation>,
    /// By the id of an equation, the numbers that LaTeX prints beside it by itself.
    pub automatic_numbers: BTreeMap<String, Vec<String>>,
    /// The sentences that the claims file turned into tests.
    pub sentences: Vec<Equation>,
    /// The number of displays without a number and without a claim, which were not checked.
    pub unnumbered: usize,
    /// What was inferred: how the symbols were mapped, and what was assumed.
    pub inferred: Vec<String>,
    /// The names that formulas define, each as an equation in LaTeX, `name = formula`.
    pub definitions: Vec<String>,
}

/// The findings on all documents of a run.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// The documents in the order of their paths.
    pub documents: Vec<Document>,
}

impl Equation {
    /// Speaks of another equation by another name: of an equality by that of its chain.
    pub(crate) fn rename_in_words(&mut self, from: &str, to: &str) {
        let rename = |finding: &mut Finding| {
            finding.message = finding.message.replace(&format!("({from})"), &format!("({to})"));
        };
        rename(&mut self.finding);
        self.parts.iter_mut().for_each(|part| rename(&mut part.finding));
        let shared = self.repairs.iter_mut().filter_map(|repair| repair.shared.as_mut());
        let names = shared.flat_map(|shared| std::iter::once(&mut shared.of).chain(&mut shared.mends));
        names.chain(&mut self.elsewhere).filter(|name| *name == from).for_each(|name| to.clone_into(name));
    }

    /// The equation with one proposal: where edits of the text are suggested, the message names no mutant, which may be
    /// another change.
    pub(crate) fn with_one_proposal(mut self) -> Equation {
        if !self.repairs.is_empty() || self.finding.fit.is_some() {
            self.finding.forget_mutant();
            self.parts.iter_mut().for_each(|part| part.finding.forget_mutant());
        }
        self
    }
}

impl Report {
    /// The report of these documents.
    pub fn new(documents: Vec<Document>) -> Report {
        Report { documents }
    }

    /// Equations and sentences together.
    pub fn items(&self) -> impl Iterator<Item = &Equation> {
        self.documents.iter().flat_map(|document| document.equations.iter().chain(&document.sentences))
    }

    /// The number of equations and sentences with each verdict.
    pub fn counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        for item in self.items() {
            *counts.entry(item.finding.verdict.word()).or_insert(0) += 1;
        }
        counts
    }

    /// The number of items that are not as expected.
    pub fn unexpected(&self) -> usize {
        self.items().filter(|item| !item.ok).count()
    }

    /// The exit code where nothing may stay open: as [`exit_code`](Report::exit_code), but 2 where something was not decided
    /// or not read and no reason is given for it, or a document has no claims file or one with guesses.
    pub fn strict_exit_code(&self) -> u8 {
        let is_open = |verdict: Verdict| matches!(verdict, Verdict::Undecided | Verdict::Unreadable | Verdict::Assumed);
        let undecided = self.items().any(|item| is_open(item.finding.verdict) && item.because.is_none());
        let unaided = self.documents.iter().any(|document| document.is_guessed);
        match self.exit_code() {
            0 if undecided || unaided => 2,
            code => code,
        }
    }

    /// The exit code. 0: all items are as expected. 1: an item is wrong. 2: an item could not be checked, or there is
    /// none.
    pub fn exit_code(&self) -> u8 {
        let is_wrong = |verdict| matches!(verdict, Verdict::Refuted | Verdict::Domain);
        let wrong =
            |item: &Equation| !item.ok && (is_wrong(item.finding.verdict) || item.finding.code == Code::Contradiction);
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
