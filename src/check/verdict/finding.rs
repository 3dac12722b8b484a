//! The finding on one claim: its verdict with the evidence, or the counterexample.

use std::fmt;

use crate::code::Code;
use crate::source::Span;

use crate::check::verdict::Verdict;

/// What the two numbers of a counterexample are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Compared {
    /// The values of the two sides of a relation.
    #[default]
    Sides,
    /// How many of these were found, and how many are claimed.
    Counts(&'static str),
    /// What a function has at a place, and what it should have.
    AtAPlace,
    /// Nothing: the message says all.
    Nothing,
}

/// A counterexample: a state at which a claim fails, with the values of its two sides.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Counterexample {
    /// The symbols of the claim with their values, as LaTeX names with overdots.
    pub state: Vec<(String, f64)>,
    /// The value of the left side.
    pub lhs: f64,
    /// The value of the right side.
    pub rhs: f64,
    /// The component or entry that fails, for a vector, a matrix or a family.
    pub entry: Option<String>,
    /// What the two values are.
    pub(crate) compared: Compared,
}

/// A formula for display.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Formula {
    /// As LaTeX.
    pub latex: String,
    /// In plain text.
    pub text: String,
}

/// A small fraction in lowest terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// The numerator, with the sign.
    pub numerator: i32,
    /// The denominator, positive.
    pub denominator: i32,
}

impl Fraction {
    /// 1.
    pub const ONE: Fraction = Fraction { numerator: 1, denominator: 1 };

    /// The value.
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

/// A printed term with a wrong coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Misfit {
    /// The bytes of the term in the notes, with the printed sign.
    pub span: Span,
    /// The factor by which the term must be multiplied; 0 if no derived term corresponds to it.
    pub coefficient: Fraction,
}

/// Changes of several terms with which, made together, a refuted equality holds.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Fit {
    /// The printed terms with wrong coefficients.
    pub terms: Vec<Misfit>,
    /// The derived terms that are not printed, with their signs as on the right side.
    pub missing: Vec<Formula>,
}

/// The verdict on one claim, with its evidence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The class of the message: its stable name.
    pub code: Code,
    /// What was found: one or more clauses, separated by semicolons.
    pub message: String,
    /// The number of states that decided.
    pub points: usize,
    /// The number of states that were tried.
    pub tried: usize,
    /// The largest residual relative to the terms in it, if residuals were taken.
    pub max_residual: Option<f64>,
    /// The base-2 logarithm of the probability that a certified claim is false.
    pub false_accept_log2: Option<f64>,
    /// The reason why a verified equality is not certified: a noun phrase.
    pub not_certified_because: Option<String>,
    /// The state at which the claim fails.
    pub counterexample: Option<Counterexample>,
    /// The left side minus the right side of a refuted equality, if that is short.
    pub difference: Option<Formula>,
    /// The derived Euler–Lagrange equation, for a refuted equality about an acceleration.
    pub derived: Option<Formula>,
    /// The number of members of a chain that follow from a wrong member before them.
    pub carried: usize,
    /// The false step before it from which a false step follows.
    pub follows_from: Option<Inherited>,
    /// The changes of terms with which a refuted equality holds, if no single edit corrects it.
    pub fit: Option<Fit>,
    /// The name that is defined, where a definition is not tested.
    pub(crate) defines: Option<String>,
    /// The clause of the message that names a mutant which holds.
    pub(crate) mutant: Option<String>,
    /// The bytes of the notes that the finding is about.
    pub span: Span,
}

impl Finding {
    /// Whether it is about a definition that no other display tests, and nothing fails for it.
    pub(crate) fn is_untested_definition(&self) -> bool {
        matches!(self.code, Code::DefinitionUnused | Code::DefinitionNotTested)
    }

    /// Whether it is about a definition that is not tested, or not in full.
    pub(crate) fn leaves_a_definition_open(&self) -> bool {
        self.is_untested_definition() || matches!(self.code, Code::DefinitionUsersFail | Code::DefinitionUpToSign)
    }

    /// Adds to the message that the claim would hold with the change of a mutant.
    pub(crate) fn would_hold_with(&mut self, change: &str) {
        let clause = format!("; it would hold with {change}");
        self.message.push_str(&clause);
        self.mutant = Some(clause);
    }

    /// Takes the mutant that would hold out of the message.
    pub(crate) fn forget_mutant(&mut self) {
        if let Some(clause) = self.mutant.take() {
            self.message = self.message.replacen(&clause, "", 1);
        }
    }

    /// This finding as one about the definition of a name, which is not tested.
    #[must_use]
    pub(crate) fn defining(self, name: &str) -> Self {
        Finding { defines: Some(name.to_owned()), ..self }
    }

    /// A finding without evidence.
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
            defines: None,
            mutant: None,
            span,
        }
    }

    /// This finding with another verdict: its code and its message change with it, and the evidence stays.
    #[must_use]
    pub fn replaced(self, code: Code, verdict: Verdict, message: impl Into<String>) -> Self {
        Finding { code, verdict, message: message.into(), ..self }
    }
}

/// The names of the equations from which a false one follows.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Inherited {
    /// The equation from which it follows directly.
    pub from: String,
    /// The first false equation of this chain, where the mistake is.
    pub root: String,
}
