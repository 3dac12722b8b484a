//! The finding on one claim: its verdict with the evidence, or the counterexample.

use std::fmt;

use crate::code::Code;
use crate::source::Span;

use crate::check::verdict::Verdict;

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

/// The verdict on one claim, with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The class of the message: its stable name.
    pub code: Code,
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
    pub fn new(code: Code, verdict: Verdict, span: Span, message: impl Into<String>) -> Self {
        Finding {
            verdict,
            code,
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

/// The equations that a false one follows from, by what they are called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inherited {
    /// The one that it follows from.
    pub from: String,
    /// The one that this in turn follows from, and that follows from none: where the slip is.
    pub root: String,
}
