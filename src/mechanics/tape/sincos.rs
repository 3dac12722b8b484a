//! Sine and cosine of many numbers at once, without branches.
//!
//! x = n π/2 + r with |r| ≤ π/4, after Cody and Waite: n π/2 is subtracted in three parts, the first two so short that their
//! products with n are exact. For the remainder r the Taylor series are exact to rounding. The lowest bits of n select
//! ±sin r or ±cos r. Both results are within two units in the last place of the true ones.

use fearless_simd::{Simd, SimdBase, SimdFloat};

/// The largest angle, in radians, for which the products of n with the parts are exact.
pub(super) const LARGEST: f64 = 1e6;

/// π/2 in three parts: 33 bits, the next 33, the next 53.
#[expect(clippy::excessive_precision, reason = "the digits of the parts, exactly")]
const PARTS: [f64; 3] =
    [1.570_796_326_734_125_614_17, 6.077_100_506_303_965_976_60e-11, 2.022_266_248_795_950_631_54e-21];

/// The number that, added to a number below 2⁵¹, leaves the nearest whole number in the lowest bits.
const ROUNDING: f64 = 1.5 * (1_u64 << 52) as f64;

/// (−1)ᵏ/(2k + 1)! from k = 1: sin r = r + r³ (…).
const SINE: [f64; 7] = reciprocal_factorials(3);
/// (−1)ᵏ/(2k)! from k = 2: cos r = 1 − r²/2 + r⁴ (…).
const COSINE: [f64; 7] = reciprocal_factorials(4);

/// 1/n!, 1/(n + 2)!, … with alternating signs; for odd n the first is negative.
const fn reciprocal_factorials(from: usize) -> [f64; 7] {
    let (mut series, mut factorial, mut n, mut k) = ([0.0; 7], 1.0, 1, 0);
    let mut sign = if from % 2 == 1 { -1.0 } else { 1.0 };
    while k < series.len() {
        while n < from + 2 * k {
            n += 1;
            factorial *= n as f64;
        }
        series[k] = sign / factorial;
        sign = -sign;
        k += 1;
    }
    series
}

// Functions and not closures, because code with vector instructions must be inlined into its caller.

#[inline(always)]
fn all<S: Simd>(simd: S, value: f64) -> S::f64s {
    S::f64s::splat(simd, value)
}

/// Σ cₖ xᵏ.
#[inline(always)]
fn series<S: Simd>(simd: S, x: S::f64s, coefficients: [f64; 7]) -> S::f64s {
    let mut sum = all(simd, coefficients[6]);
    for k in (0..6).rev() {
        sum = sum.mul_add(x, all(simd, coefficients[k]));
    }
    sum
}

/// Sine and cosine of numbers up to [`LARGEST`].
#[inline(always)]
pub(super) fn sin_cos<S: Simd>(simd: S, x: S::f64s) -> (S::f64s, S::f64s) {
    let shifted = x.mul_add(all(simd, std::f64::consts::FRAC_2_PI), all(simd, ROUNDING));
    let n = shifted - all(simd, ROUNDING);
    let quadrant = shifted.to_bits();
    let mut r = x;
    for part in PARTS {
        r = n.mul_add(all(simd, -part), r);
    }
    let square = r * r;
    let sine = (series(simd, square, SINE) * square).mul_add(r, r);
    // 1 − r²/2 is rounded; the rounding error is added again
    let half = square * all(simd, 0.5);
    let most = all(simd, 1.0) - half;
    let lost = (all(simd, 1.0) - most) - half;
    let cosine = most + (square * square).mul_add(series(simd, square, COSINE), lost);
    // an odd quadrant (all bits set by −1) exchanges the two; the second bit is the sign
    let odd = !(quadrant & 1) + 1;
    let exchange = (sine.to_bits() ^ cosine.to_bits()) & odd;
    let of_sine = sine.to_bits() ^ exchange ^ ((quadrant << 62) & (1 << 63));
    let of_cosine = cosine.to_bits() ^ exchange ^ (((quadrant + 1) << 62) & (1 << 63));
    (S::f64s::from_bits(of_sine), S::f64s::from_bits(of_cosine))
}

/// Sine and cosine of all of `x`. If a number is too large or not finite, the standard library computes both.
#[inline(always)]
pub(super) fn sin_cos_of_all<S: Simd>(simd: S, x: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    let lanes = S::f64s::LEN;
    let within = x.iter().fold(true, |within, x| within & (x.abs() <= LARGEST));
    if within {
        let places = sines.chunks_exact_mut(lanes).zip(cosines.chunks_exact_mut(lanes));
        for (x, (sines, cosines)) in x.chunks_exact(lanes).zip(places) {
            let (sine, cosine) = sin_cos(simd, S::f64s::from_slice(simd, x));
            sine.store_slice(sines);
            cosine.store_slice(cosines);
        }
    } else {
        for (x, (sine, cosine)) in x.iter().zip(sines.iter_mut().zip(cosines)) {
            (*sine, *cosine) = x.sin_cos();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::tape::blocks::tests::levels;
    use fearless_simd::dispatch;

    /// Angles over the whole range, and those nearest to the zeros of sine and cosine.
    fn angles() -> Vec<f64> {
        let evenly = (0..40_000).map(|i| (f64::from(i) * 0.618_033_988_749_895).fract() * 2.0 - 1.0);
        let near_zeros = (-5000..5000).map(|n| f64::from(n * 127) * std::f64::consts::FRAC_PI_2);
        let small = [0.0, 1e-300, -1e-9, 0.1, std::f64::consts::FRAC_PI_4, LARGEST];
        let mut angles: Vec<f64> =
            evenly.flat_map(|x| [x, x * 20.0, x * LARGEST]).chain(near_zeros).chain(small).collect();
        angles.truncate(angles.len() / 16 * 16);
        angles
    }

    /// The largest error of both against the standard library, in units in the last place.
    fn worst(angles: &[f64], sines: &[f64], cosines: &[f64]) -> f64 {
        let units = |a: f64, b: f64| if a == b { 0.0 } else { (a - b).abs() / (b.abs() * f64::EPSILON) };
        let each = angles.iter().zip(sines).zip(cosines);
        each.fold(0.0, |worst, ((x, &sine), &cosine)| worst.max(units(sine, x.sin())).max(units(cosine, x.cos())))
    }

    #[test]
    fn sine_and_cosine_are_those_of_the_library() {
        let angles = angles();
        for level in levels() {
            let (mut sines, mut cosines) = (vec![0.0; angles.len()], vec![0.0; angles.len()]);
            dispatch!(level, simd => sin_cos_of_all(simd, &angles, &mut sines, &mut cosines));
            let error = worst(&angles, &sines, &cosines);
            assert!(error <= 2.0, "{level:?}: {error}");
            // must-fail cases: one for the other, and one angle too far
            assert!(worst(&angles, &cosines, &sines) > 1e6);
            sines.rotate_left(1);
            assert!(worst(&angles, &sines, &cosines) > 1e6);
        }
    }

    #[test]
    fn what_is_too_large_or_no_number_is_left_to_the_library() {
        for strange in [1e7, -1e300, f64::INFINITY, f64::NAN] {
            let angles = [0.5, strange, 1.0, -2.0, 3.0, 0.0, 9.0, 1e5];
            for level in levels() {
                let (mut sines, mut cosines) = ([0.0; 8], [0.0; 8]);
                dispatch!(level, simd => sin_cos_of_all(simd, &angles, &mut sines, &mut cosines));
                assert_eq!(sines.map(f64::to_bits), angles.map(|x| x.sin().to_bits()));
                assert_eq!(cosines.map(f64::to_bits), angles.map(|x| x.cos().to_bits()));
            }
        }
    }
}
