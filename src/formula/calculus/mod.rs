//! Definite integrals and sums of formulas as formulas without ∫ and Σ.
//!
//! What is not of a known form has no value here, and the caller refuses it. Each rule is exact: it holds for all real
//! values of the other letters at which its result is a number. Where an integral has no value, or its rule does not
//! apply, the result has none: a condition in the form of `cases` sees to that.
//!
//! | file | content |
//! | --- | --- |
//! | [`any_function`] | functions without a formula, at any arguments |
//! | `build` | sums, products and quotients without zeros and ones |
//! | [`expansion`] | a formula as a sum of terms c·xⁿ·e^{γx²+αx+β}·sin(ωx+φ) |
//! | [`definite`] | definite integrals |
//! | `algebraic` | integrals of powers of linear and quadratic formulas |
//! | `quadrature` | integrals without a known antiderivative, as numbers |
//! | [`places`] | the ends of an interval, and the value of a formula at a place |
//! | [`series`] | sums over a whole number up to a letter, or to infinity |
//!
//! Offers `definite` and `series`, the formulas of an integral and of a sum, and what they share. Knows the tree and the symbols of
//! `formula`, and numbers.

mod algebraic;
pub mod any_function;
mod build;
pub mod definite;
pub mod expansion;
pub mod places;
#[cfg(feature = "notes")]
pub mod quadrature;
pub mod series;

/// Why an integral or a sum has no formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFormula {
    /// No rule fits.
    Unknown,
    /// It has no finite value.
    Diverges,
}
