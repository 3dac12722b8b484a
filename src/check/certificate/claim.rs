//! Claims that a prime field can decide, and the decision: a certificate or the reason why there is none.

use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::formula::{IndexId, text};
use crate::scalar::Modular;
use crate::scalar::prime_field::Modulus;

use crate::check::certificate::negligible_terms;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The decision of a prime field on a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Certificate {
    /// An identity; the base-2 logarithm of the probability that this is wrong.
    Identity(f64),
    /// Not decided, for this reason: a noun phrase.
    Open(String),
    /// Not decided, because coefficients may be larger than the prime.
    LargeCoefficients,
    /// Not decided, and this term is too small for floating-point numbers to test.
    NegligibleTerm(String),
    /// Not an identity, although floating-point numbers do not show the difference.
    Differs,
    /// Not an identity for families with this number of members.
    DiffersFor(u32),
}

impl Certificate {
    /// The finding on a claim that passed by numbers, changed by this decision.
    pub fn stamp(self, finding: Finding) -> Finding {
        match self {
            Certificate::Identity(log2) => {
                Finding { verdict: Verdict::Certified, false_accept_log2: Some(log2), ..finding }
            }
            Certificate::Open(reason) => Finding { not_certified_because: Some(reason), ..finding },
            Certificate::LargeCoefficients => {
                let reason = "coefficients that may be very large".to_owned();
                Finding { not_certified_because: Some(reason), ..finding }
            }
            Certificate::NegligibleTerm(term) => {
                finding.replaced(Code::TermTooSmall, Verdict::Undecided, negligible_terms::message(&term))
            }
            Certificate::Differs => {
                let message = "the two sides differ by less than rounding error; exact arithmetic shows the difference";
                finding.replaced(Code::DiffersAsIdentity, Verdict::Refuted, message)
            }
            Certificate::DiffersFor(size) => {
                let message = format!(
                    "this is false for a family of {size} members, as exact arithmetic shows; check the limits of the \
                     sums"
                );
                finding.replaced(Code::FailsForFamilySize, Verdict::Refuted, message)
            }
        }
    }
}

/// The differences at a point of the field, all of which must vanish; or the reason why there are none.
pub(crate) type Differences<F> = Result<Vec<Modular<F>>, String>;

/// A claim as differences that must vanish, over any field.
pub(crate) trait Claim {
    /// The differences at a state.
    fn differences<F: Modulus>(&self, state: &mut SampledState<'_, Modular<F>>) -> Differences<F>;

    /// The free letters, if the differences are those of the decided formulas one by one.
    fn free(&self) -> Option<&[IndexId]> {
        None
    }
}

impl Claim for Link {
    /// Left side minus right side, entry by entry, for all values of the free indices.
    fn differences<F: Modulus>(&self, state: &mut SampledState<'_, Modular<F>>) -> Differences<F> {
        let mut indices: Vec<(IndexId, u8)> = self.free.iter().map(|id| (*id, 1)).collect();
        let mut all = Vec::new();
        let reason = |reason: Unavailable| unavailable(&reason, state.model());
        loop {
            let lhs = state.now(&self.lhs, &indices).map_err(reason)?;
            let rhs = state.now(&self.rhs, &indices).map_err(reason)?;
            let (a, b) = residual::pair(lhs, rhs);
            all.extend(a.into_iter().zip(b).map(|(a, b)| a - b));
            if !residual::advance(&mut indices, state).map_err(reason)? {
                return Ok(all);
            }
        }
    }

    fn free(&self) -> Option<&[IndexId]> {
        Some(&self.free)
    }
}

pub(crate) fn unavailable(reason: &Unavailable, model: &Model) -> String {
    match reason {
        Unavailable::Symbol(id) => format!("{}, which has no exact value", text::plain(&model.name(*id))),
        Unavailable::Derivative(_) => "a derivative that is not known".to_owned(),
        Unavailable::Operation(what) => (*what).to_owned(),
    }
}
