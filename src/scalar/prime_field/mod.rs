//! A prime field as a number, for polynomial identity testing: identities are decided exactly, not to rounding.
//!
//! A false rational identity holds at a random point of a large field with a tiny probability, which its degree bounds
//! (Schwartz 1980, Zippel 1979; for formulas with functions, Gonnet 1984). [`Modular`] is a full [`num_dual::DualNum`]
//! over the field of p = 861·2¹¹⁷ − 1 elements, so that printed formulas and Lagrangians in Rust run over it unchanged.
//! The bound on the probability that a false identity is accepted is computed in [`false_accept_log2`].
//!
//! A number carries
//!
//! - its value;
//! - as an *angle* a label on the unit circle over the field, which has a cyclic group of 2¹¹⁷ points. Sines and
//!   cosines of
//!   sums, halves and multiples of angles, and shifts by fractions of a turn, are exact;
//! - a bound on itself: the degree of its numerator, were it written as one fraction, and the sum of the magnitudes of
//!   the numerator's coefficients. That sum must stay below p, or a coefficient could vanish in the field. Sine and cosine
//!   count as the Laurent polynomials in e^{iθ} that they are.
//!
//! Exponentials and logarithms are independent numbers that are related as their arguments are.
//!
//! A field has no signs, no order and no inverse trigonometric functions. Where one is asked for, that is noted in the
//! [`EvaluationRecord`], and nothing is concluded. A square root exists at half of the points and has two signs, so an
//! identity with roots must hold for all signs. Neither matters until more than the square of the root is needed.
//!
//! Numbers live within [`evaluate_at_point`] only, on one thread. This folder knows the numeric traits and rational
//! constants of `scalar`, and nothing of formulas or mechanics. Its files import in this order: `residue`,
//! `unit_circle`, `modulus`, `denominators`, `angle`, `number`, `comparisons`, `square_roots` and `simple_numbers`,
//! `evaluation`, then `operations`, `arithmetic`, `exponentials` and `false_accept_bound`.
//!
//! Offers [`Modular`], [`evaluate_at_point`] and [`false_accept_log2`].

mod angle;
mod arithmetic;
mod comparisons;
mod denominators;
mod evaluation;
mod exponentials;
mod false_accept_bound;
mod modulus;
mod number;
mod operations;
mod residue;
mod simple_numbers;
mod square_roots;
mod unit_circle;

pub use comparisons::EvaluationRecord;
pub use evaluation::evaluate_at_point;
pub use false_accept_bound::false_accept_log2;
pub use modulus::{FirstPrime, Modulus, SecondPrime};
pub use number::Modular;
pub use residue::Prime;

#[cfg(test)]
mod tests;
