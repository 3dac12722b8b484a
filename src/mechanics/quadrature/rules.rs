//! Rules for integrals: nodes and weights in `f64`, exact for polynomials up to a degree.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

/// The n nodes and weights of Gauss and Legendre on [−1, 1], exact to degree 2n − 1: the roots of P_n by Newton's
/// method, and w = 2/((1 − x²) P_n′(x)²). The nodes descend, and are symmetric to the last bit.
pub(super) fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let mut rule = vec![(0.0, 0.0); n];
    for i in 0..n.div_ceil(2) {
        let middle = 2 * i + 1 == n;
        let mut x = if middle { 0.0 } else { (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos() };
        // the first guess is good to three digits: the fourth step has nothing left to do
        for _ in 0..if middle { 0 } else { 5 } {
            let (p, slope) = legendre(n, x);
            x -= p / slope;
        }
        let (_, slope) = legendre(n, x);
        let weight = 2.0 / ((1.0 - x * x) * slope * slope);
        rule[i] = (x, weight);
        rule[n - 1 - i] = (-x, weight);
    }
    rule
}

/// P_n(x) and P_n′(x) for |x| < 1, by the recursion of three terms.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut now) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        (before, now) = (now, ((2.0 * k + 1.0) * x * now - k * before) / (k + 1.0));
    }
    (now, n as f64 * (before - x * now) / (1.0 - x * x))
}

/// The rule of n nodes on [0, 1].
pub(super) fn interval(n: usize) -> Vec<(f64, f64)> {
    gauss_legendre(n).into_iter().map(|(x, w)| (0.5 * (x + 1.0), 0.5 * w)).collect()
}

/// Unit vectors n̂ and elements of area on the unit sphere, exact to a degree: Gauss in cos θ (all that is odd in sin θ
/// vanishes with the angle), equal steps in φ.
pub(super) fn sphere(degree: usize) -> Vec<(Vector3<f64>, f64)> {
    let turns = degree + 1;
    let (heights, step) = (gauss_legendre(degree / 2 + 1), TAU / turns as f64);
    let ring = |(z, w): (f64, f64)| {
        let radius = (1.0 - z * z).sqrt();
        (0..turns).map(move |j| {
            let (sine, cosine) = (step * j as f64).sin_cos();
            (Vector3::new(radius * cosine, radius * sine, z), w * step)
        })
    };
    heights.into_iter().flat_map(ring).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_is_exact_to_its_degree_and_no_further() {
        for n in 1..=12 {
            let miss = |power: usize| {
                let exact = if power.is_multiple_of(2) { 2.0 / (power as f64 + 1.0) } else { 0.0 };
                let sum: f64 = gauss_legendre(n).iter().map(|(x, w)| w * x.powi(power as i32)).sum();
                (sum - exact).abs()
            };
            for power in 0..2 * n {
                assert!(miss(power) < 1e-14, "{n} nodes, x^{power}");
            }
            // must-fail case: ∫ P_n² is what is missed, times the leading coefficient of P_n squared
            assert!(miss(2 * n) > 1e-8, "{n} nodes, x^{}", 2 * n);
        }
    }
}
