//! The places where a formula of drawn numbers comes closest to zero, found by descent.
//!
//! `|sin x − 0.999999999|` changes its branch on an interval that is 10⁻⁴ wide, and a division of all ranges does not get
//! there within its budget. But the formula is smooth: from a sampled state it is followed downhill, one number after
//! another and then all together, to the bottom of a parabola. That takes a few dozen evaluations.

use crate::scalar::Interval;

use crate::check::search::interval_bounds::Ranges;

/// The largest number of rounds over all numbers.
const ROUNDS: usize = 60;

/// The first step, relative to a number.
const FIRST: f64 = 0.1;

/// The smallest step, relative to a number.
const LAST: f64 = 1e-9;

/// The formula's value as doubles bound it, with a sign such that it is positive where the descent starts.
pub(crate) type Height<'a> = dyn Fn(&[f64]) -> Interval + 'a;

/// The numbers at which the height is certainly negative, if a descent from a point comes to such a place.
pub(crate) fn below_zero(height: &Height<'_>, ranges: &Ranges<'_>, start: Vec<f64>) -> Option<Vec<f64>> {
    let value = |at: &[f64]| {
        let found = height(at);
        if found.is_empty() { f64::INFINITY } else { 0.5 * found.low + 0.5 * found.high }
    };
    let inside = |k: usize, x: f64| x.clamp(ranges.unknowns[k].range.low, ranges.unknowns[k].range.high);
    let (mut x, mut least) = (start.clone(), value(&start));
    let mut steps: Vec<f64> = x.iter().map(|x| FIRST * x.abs().max(FIRST)).collect();
    for _ in 0..ROUNDS {
        let before = x.clone();
        for k in (0..x.len()).filter(|k| !ranges.unknowns[*k].is_whole) {
            let moved = |to: f64| {
                let mut moved = x.clone();
                moved[k] = inside(k, to);
                let height = value(&moved);
                (height, moved)
            };
            let (above, under) = (moved(x[k] + steps[k]), moved(x[k] - steps[k]));
            let curvature = above.0 - 2.0 * least + under.0;
            let bottom = x[k] + 0.5 * steps[k] * (under.0 - above.0) / curvature;
            let bottom = (curvature > 0.0 && bottom.is_finite()).then(|| moved(bottom));
            let lowest = [above, under].into_iter().chain(bottom).filter(|(height, _)| *height < least);
            match lowest.min_by(|a, b| a.0.total_cmp(&b.0)) {
                Some((height, lower)) => {
                    let taken = (lower[k] - x[k]).abs();
                    steps[k] = if taken < 0.9 * steps[k] { taken.max(0.05 * steps[k]) } else { 2.0 * steps[k] };
                    (least, x) = (height, lower);
                }
                None => steps[k] *= 0.2,
            }
        }
        if least < 0.0 && height(&x).high < 0.0 {
            return Some(x);
        }
        // Along a narrow valley the numbers move together.
        let along: Vec<f64> = (0..x.len()).map(|k| inside(k, 2.0 * x[k] - before[k])).collect();
        let height = if before == x { f64::INFINITY } else { value(&along) };
        if height < least {
            (least, x) = (height, along);
        }
        if x.iter().zip(&steps).all(|(x, step)| *step < LAST * x.abs().max(LAST)) {
            break;
        }
    }
    None
}
