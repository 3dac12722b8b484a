//! The bound on the probability that a false identity is accepted (Schwartz and Zippel).
//!
//! A non-zero polynomial of total degree d vanishes at a point drawn uniformly from S^n with a probability of at most
//! d/|S|. Here |S| is the number of points of the unit circle that are drawn, the smallest set from which anything is
//! drawn. The degree is that of the numerator of the difference of the two sides, plus the degrees of all differences
//! that were tested for zero on the way.
//!
//! # How the bound is computed
//!
//! Each number carries the degree of its numerator, found in the very evaluation that is tested and not in a
//! simplified one. Denominators are remembered as factors, so that a sum over one denominator does not square it.
//! The sum of the magnitudes of the coefficients is carried too and must stay below p; otherwise a coefficient
//! could be a multiple of p. If it does not, a second prime is used, and the bound is the product of both.
//! Everything that was compared on the way is added to the degree. Up to 64 points are tried until no denominator
//! vanishes and every root exists, and the probability covers all of them.
//!
//! A value that equals a drawn number, a short quotient, 0 or 1 goes on as that. ω comes from R and Ṙ as
//! polynomials of thousands of terms, and is n φ̇. That the value is another one would be an accident, and is
//! counted as one.
//!
//! The sign of a root is free: half of the numbers have a square root, and neither of the two is the positive one.
//! An identity with roots must hold for all choices of signs; the degree is that of the product over all of them.
//! If it holds only for some, nothing is concluded. The square of a root needs neither its value nor its sign.

use super::comparisons::EvaluationRecord;
use super::denominators::degree_as_f64;
use super::modulus::Modulus;
use super::number::Modular;
use super::unit_circle::drawn_bits;

/// The bound on the probability that two different sides agree at a random point, as a power of two.
///
/// `differences` are left side minus right side, entry by entry; `attempts` is how many points could have been tried.
/// `None` where coefficients may have more than `most_bits` bits, those of the prime or of the product of several, so
/// that they could vanish without being zero; or where what was compared on the way has more than those of this prime.
pub fn false_accept_log2<F: Modulus>(
    differences: &[Modular<F>],
    record: &EvaluationRecord,
    attempts: u32,
    most_bits: f64,
) -> Option<f64> {
    if record.compared_bits >= Modular::<F>::most_bits() {
        return None;
    }
    let mut degree = 1.0_f64;
    for difference in differences {
        // with k roots of free sign the norm is a product of 2ᵏ conjugates
        let conjugates = f64::from(difference.roots.count_ones()).exp2();
        let bits = difference.size.norm.max(1.0).log2() * conjugates;
        if bits.is_nan() || bits >= most_bits {
            return None;
        }
        degree = degree.max(degree_as_f64(difference.size.degree) * conjugates);
    }
    let expected_accidents = (degree + record.coincidences) * f64::from(attempts.max(1));
    if !expected_accidents.is_finite() {
        return None;
    }
    Some((expected_accidents.log2() - f64::from(drawn_bits::<F>())).min(0.0))
}
