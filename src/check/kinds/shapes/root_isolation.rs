//! Root isolation: how many real roots a function of one variable has in a range.

use std::cmp::Ordering;

use crate::notes::claims::Range;

use crate::check::sample::sampler::contains;

/// The decades that are searched for roots, in both directions from 1.
const DECADES: i32 = 7;

/// The grid points in one decade.
const PER_DECADE: i32 = 8;

/// The depth of a dip, relative to its edges, below which doubles do not know whether it reaches zero.
const CLOSE: f64 = 1e-9;

/// The number of real roots of a function in a range: the changes of sign on a logarithmic grid of both signs, and the
/// pairs of changes between two points of the grid, which show as a dip towards zero. How deep a dip goes is decided by
/// `sign_at_extremum`, the sign of the function where its slope vanishes near a point, if that is known.
pub fn count_roots_on_grid(
    range: &Range,
    mut value_at: impl FnMut(f64) -> f64,
    sign_at_extremum: impl Fn(f64) -> Option<Ordering>,
) -> usize {
    let exponents = -DECADES * PER_DECADE..=DECADES * PER_DECADE;
    // Examples have their roots at round numbers, so the grid avoids these.
    let positive: Vec<f64> = exponents.map(|k| 1.0123 * 10f64.powf(f64::from(k) / f64::from(PER_DECADE))).collect();
    let grid = positive.iter().rev().map(|x| -x).chain([0.0]).chain(positive.iter().copied());
    let grid = grid.filter(|x| contains(range, *x));
    let points: Vec<(f64, f64)> = grid.map(|x| (x, value_at(x))).filter(|(_, value)| value.is_finite()).collect();
    let changes = points.windows(2).filter(|pair| pair[0].1 * pair[1].1 < 0.0).count();
    let zeros = points.iter().filter(|(_, value)| *value == 0.0).count();
    let is_dip = |triple: &&[(f64, f64)]| {
        let [a, b, c] = [triple[0].1, triple[1].1, triple[2].1];
        a * b > 0.0 && b * c > 0.0 && b.abs() <= a.abs() && b.abs() <= c.abs()
    };
    let dips: Vec<[f64; 3]> =
        points.windows(3).filter(is_dip).map(|triple| [triple[0].0, triple[2].0, triple[1].1.signum()]).collect();
    let twice = dips.into_iter().map(|[low, high, sign]| {
        let scale = (sign * value_at(low)).max(sign * value_at(high));
        let (least, at) = minimum(low, high, |x| sign * value_at(x));
        let known = if least.abs() <= CLOSE * scale { sign_at_extremum(at) } else { None };
        // The function touches zero once, or crosses it twice.
        match known {
            Some(Ordering::Equal) => 1,
            Some(found) => {
                if (found == Ordering::Greater) == (sign > 0.0) {
                    0
                } else {
                    2
                }
            }
            None if least < -1e-13 * scale => 2,
            None => usize::from(least <= 1e-13 * scale),
        }
    });
    changes + zeros + twice.sum::<usize>()
}

/// The minimum of a function between two points, and where it is, by golden-section search; the search stops below zero.
pub fn minimum(mut low: f64, mut high: f64, mut value_at: impl FnMut(f64) -> f64) -> (f64, f64) {
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let mut best = (f64::INFINITY, low);
    for _ in 0..80 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        let (at_a, at_b) = (value_at(a), value_at(b));
        for found in [(at_a, a), (at_b, b)] {
            if found.0 < best.0 {
                best = found;
            }
        }
        if best.0 < 0.0 {
            break;
        }
        if at_a < at_b {
            high = b;
        } else {
            low = a;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_counted_far_apart_and_close_together() {
        let between = |a: f64, b: f64| count_roots_on_grid(&Range::Any, |x| (x - a) * (x - b), |_| None);
        assert_eq!(between(1.0, 1000.0), 2);
        assert_eq!(between(1.0, 1.0001), 2);
        assert_eq!(between(-3.0, 0.02), 2);
        assert_eq!(count_roots_on_grid(&Range::Any, |x| (x - 2.0) * (x - 2.0), |_| None), 1);
        assert_eq!(count_roots_on_grid(&Range::Any, |x| x * x + 1e-6, |_| None), 0);
        assert_eq!(count_roots_on_grid(&Range::Any, |x| (x - 2.0) * (x - 2.0) + 1e-9, |_| None), 0);
        assert_eq!(count_roots_on_grid(&Range::Any, |x| 3.0 * x - 1.0, |_| None), 1);
    }
}
