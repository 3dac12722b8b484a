//! Verdicts, their evidence, and the report of a document: what `check` gives and `report` prints.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use crate::latex::slips::Slip;
use crate::source::{Source, Span};

/// What is said of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Verdict {
    /// Decided over a prime field, up to a stated probability.
    Certified,
    /// Agrees at every usable sampled state.
    Verified,
    /// Introduces a symbol that later, checked equations stand on.
    Definition,
    /// A hypothesis, by the claims file's word.
    Law,
    /// A counterexample is given.
    Refuted,
    /// Agrees wherever both sides are defined, but one is defined where the other is not.
    Domain,
    /// Too few usable states, or states that cannot tell.
    Undecided,
    /// Could not be parsed or typed.
    Unreadable,
    /// Numbered, but nothing says what it should mean.
    Unclaimed,
}

impl Verdict {
    /// Every verdict, from the best to the worst; of several parts the worst counts.
    pub const ALL: [Verdict; 9] = [
        Verdict::Certified,
        Verdict::Verified,
        Verdict::Definition,
        Verdict::Law,
        Verdict::Unclaimed,
        Verdict::Undecided,
        Verdict::Domain,
        Verdict::Unreadable,
        Verdict::Refuted,
    ];

    /// Whether this verdict is a pass where nothing else is expected.
    pub fn passes(self) -> bool {
        matches!(self, Verdict::Certified | Verdict::Verified | Verdict::Definition | Verdict::Law)
    }

    /// Whether a claim was tested and found to hold.
    pub fn holds(self) -> bool {
        matches!(self, Verdict::Certified | Verdict::Verified)
    }

    /// How bad it is: its place in [`Verdict::ALL`].
    pub fn severity(self) -> usize {
        Verdict::ALL.iter().position(|verdict| *verdict == self).unwrap_or(0)
    }

    /// The word for it, as claims files and reports spell it.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Certified => "certified",
            Verdict::Verified => "verified",
            Verdict::Definition => "definition",
            Verdict::Law => "law",
            Verdict::Refuted => "refuted",
            Verdict::Domain => "domain",
            Verdict::Undecided => "undecided",
            Verdict::Unreadable => "unreadable",
            Verdict::Unclaimed => "unclaimed",
        }
    }

    /// The verdict that a word names.
    pub fn named(word: &str) -> Option<Verdict> {
        Verdict::ALL.into_iter().find(|verdict| verdict.word() == word)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// A state at which a claim fails, and what its two sides are there.
#[derive(Clone, Debug, PartialEq)]
pub struct Counterexample {
    /// The symbols of the claim with their values, as LaTeX names with overdots.
    pub state: Vec<(String, f64)>,
    /// The value of the left side.
    pub lhs: f64,
    /// The value of the right side.
    pub rhs: f64,
    /// Which component or entry, of a vector, a matrix or a family.
    pub entry: Option<String>,
}

/// A formula to be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// As LaTeX.
    pub latex: String,
    /// In plain text.
    pub text: String,
}

/// A small fraction in lowest terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// Above, with the sign.
    pub numerator: i32,
    /// Below, positive.
    pub denominator: i32,
}

impl Fraction {
    /// 1.
    pub const ONE: Fraction = Fraction { numerator: 1, denominator: 1 };

    /// Its value.
    pub fn value(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => write!(f, "{}", self.numerator),
            below => write!(f, "{}/{below}", self.numerator),
        }
    }
}

/// A printed term that should be another multiple of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// The bytes of the notes, with the printed sign.
    pub span: Span,
    /// So many times as large it should be; 0, where it has no partner among the derived terms.
    pub coefficient: Fraction,
}

/// Several changes of terms with which, all at once, a refuted equality holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fit {
    /// The printed terms that do not fit.
    pub terms: Vec<Misfit>,
    /// The derived terms that are not printed, with their signs as on the right side.
    pub missing: Vec<Formula>,
}

/// An edit of the notes with which an equation passes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repair {
    /// The bytes of the notes that go.
    pub span: Span,
    /// What comes in their place.
    pub replacement: String,
    /// The slip that it undoes.
    pub slip: Slip,
    /// The verdict on the equation then; on the step, where it mends no more than that.
    pub verdict: Verdict,
    /// Whether it mends a step of a chain and not yet the rest, which carries the slip on or has another.
    pub step: bool,
    /// Whether a side is then zero whatever its symbols mean: offered where nothing else is, and for its author to make.
    pub idle: bool,
    /// Where it changes another display, on which several wrong equations stand.
    pub shared: Option<Shared>,
}

impl Repair {
    /// Whether it changes what stands in the notes, or puts in what stands there already, or a number; else the factor or
    /// the term was put together from what is true.
    pub fn is_in_the_notes(&self, notes: &str) -> bool {
        if !matches!(self.slip, Slip::Factor | Slip::Term) {
            return true;
        }
        let put_in = self.replacement.trim().trim_end_matches(r"\,").trim().trim_start_matches(['+', '-']).trim();
        let is_number = put_in.replace(r"\frac", "").chars().all(|c| c.is_ascii_digit() || "{} /".contains(c));
        is_number || notes.contains(put_in)
    }
}

/// What one edit of a display mends beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shared {
    /// The display that is changed, by its number.
    pub of: String,
    /// The equations that hold then, by their numbers.
    pub mends: Vec<String>,
}

/// The verdict on one claim, with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// What was found, in a sentence.
    pub message: String,
    /// The states that were used.
    pub points: usize,
    /// The states that were tried.
    pub tried: usize,
    /// The largest residual relative to the terms that met in it, where residuals were taken.
    pub max_residual: Option<f64>,
    /// Of what is certified: the probability that it is false nevertheless, as a power of two.
    pub false_accept_log2: Option<f64>,
    /// Of an equality that is verified and not certified: what a field cannot decide.
    pub not_certified_because: Option<String>,
    /// Where it fails.
    pub counterexample: Option<Counterexample>,
    /// Of an equality that is refuted: its left side minus its right side, where that is short.
    pub difference: Option<Formula>,
    /// Of one about an acceleration: the Euler–Lagrange equation that was derived for it.
    pub derived: Option<Formula>,
    /// Of a chain with a wrong member: how many of the members after it follow from it.
    pub carried: usize,
    /// Of a step that is false: the false one before it that it follows from.
    pub follows_from: Option<Inherited>,
    /// Of an equality that is refuted, and that no single edit mends: the changes of its terms with which it holds.
    pub fit: Option<Fit>,
    /// The bytes of the notes that the finding is about.
    pub span: Span,
}

impl Finding {
    /// A finding without numbers.
    pub fn new(verdict: Verdict, span: Span, message: impl Into<String>) -> Self {
        Finding {
            verdict,
            message: message.into(),
            points: 0,
            tried: 0,
            max_residual: None,
            false_accept_log2: None,
            not_certified_because: None,
            counterexample: None,
            difference: None,
            derived: None,
            carried: 0,
            follows_from: None,
            fit: None,
            span,
        }
    }
}

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

/// The equations that a false one follows from, by what they are called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inherited {
    /// The one that it follows from.
    pub from: String,
    /// The one that this in turn follows from, and that follows from none: where the slip is.
    pub root: String,
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
