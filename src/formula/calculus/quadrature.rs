//! Integrals over one variable by double-exponential quadrature (Takahasi and Mori 1974): tanh–sinh between two numbers,
//! exp–sinh to infinity, sinh–sinh over the whole line.
//!
//! The places are x(t) for t in equal steps, and the sum of f(x(t))·x′(t) converges exponentially as the step is halved.
//! Singular ends are allowed, as long as the terms fall towards them. The difference between the last two steps and the
//! last terms at both ends are the error, which the value carries. What does not converge is unknown.
//!
//! The places do not depend on where a state is, so a number that carries derivatives gives those of the integral.

use super::super::environment::{Differentiable, Unavailable};

/// The longest step in t.
const COARSEST: f64 = 0.25;

/// The places are not symmetric in t, so that a singularity in the middle is not met at every step.
const OFFSET: f64 = 0.07;

/// The number of times that the step is halved: no fewer and no more.
const FEWEST_HALVINGS: u32 = 2;
const MOST_HALVINGS: u32 = 4;

/// The error relative to the terms at which the step is not halved any more.
const FINE: f64 = 1e-13;

/// The largest error relative to the terms.
const COARSE: f64 = 1e-10;

/// The largest errors relative to the terms after two and three halvings, from which the next ones can reach that: each
/// halving squares the error.
const HOPEFUL: [f64; 2] = [1e-2, 1e-4];

/// Terms below this share of all are left out.
const NEGLIGIBLE: f64 = 1e-18;

/// The largest |t| between two numbers, and up to infinity: there x is nearest to the end that a double can be.
const FARTHEST: (f64, f64) = (6.1, 6.7);

/// An integrand at a place.
type Integrand<'f, D> = &'f mut dyn FnMut(D) -> Result<D, Unavailable>;

/// The integral of `f` between two ends; `None` is −∞ below and +∞ above. It is unknown where the sums do not converge.
///
/// # Errors
/// [`Unavailable`] where a symbol of the integrand has no value, and for numbers that must be exact.
pub fn integral<D: Differentiable>(ends: (Option<D>, Option<D>), f: Integrand<'_, D>) -> Result<D, Unavailable> {
    let exact = Unavailable::Operation("an integral without a known antiderivative");
    let unknown = D::uncertain(f64::INFINITY).ok_or(exact)?;
    let (farthest, count) = match ends {
        (Some(_), Some(_)) => (FARTHEST.0, (FARTHEST.0 / COARSEST) as i32),
        _ => (FARTHEST.1, (FARTHEST.1 / COARSEST) as i32),
    };
    let mut term = |t: f64| -> Result<Option<D>, Unavailable> {
        let (x, weight) = place(ends, t);
        let value = f(x)? * weight;
        Ok(value.re().is_finite().then_some(value))
    };
    let mut coarse = Vec::new();
    for k in -count..=count {
        let t = f64::from(k) * COARSEST + OFFSET;
        if t.abs() < farthest {
            coarse.push((t, term(t)?));
        }
    }
    let sizes: Vec<f64> = coarse.iter().map(|(_, term)| term.as_ref().map_or(f64::NAN, |x| x.re().abs())).collect();
    // The longest run of numbers around the largest of them.
    let largest = (0..sizes.len()).filter(|at| sizes[*at] > 0.0).max_by(|a, b| sizes[*a].total_cmp(&sizes[*b]));
    let Some(largest) = largest else { return Ok(unknown) };
    let first = (0..largest).rev().find(|at| sizes[*at].is_nan()).map_or(0, |at| at + 1);
    let last = (largest..sizes.len()).find(|at| sizes[*at].is_nan()).map_or(sizes.len() - 1, |at| at - 1);
    let scale: f64 = sizes[first..=last].iter().sum::<f64>() * COARSEST;
    let counts = |at: &usize| sizes[*at] > NEGLIGIBLE * scale;
    let from = (first..=largest).find(counts).unwrap_or(largest).saturating_sub(1).max(first);
    let to = (largest..=last).rev().find(counts).unwrap_or(largest).saturating_add(1).min(last);
    let tails = sizes[first] + sizes[last];
    if tails > COARSE * scale {
        return Ok(unknown);
    }
    let mut step = COARSEST;
    let mut sum = None;
    for (_, term) in &coarse[from..=to] {
        add(&mut sum, *term, NEGLIGIBLE * scale);
    }
    let mut before = known(sum, step);
    for halvings in 1..=MOST_HALVINGS {
        let (mut t, end) = (coarse[from].0 + step / 2.0, coarse[to].0);
        while t < end {
            add(&mut sum, term(t)?, NEGLIGIBLE * scale);
            t += step;
        }
        step /= 2.0;
        let now = known(sum, step);
        // The derivatives that the number carries must converge too.
        let change = before.iter().zip(&now).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let size = now.iter().skip(1).fold(scale, |most, x| most.max(x.abs()));
        let error = change + tails;
        let is_last = halvings == MOST_HALVINGS;
        if halvings >= FEWEST_HALVINGS && (error <= FINE * size || is_last && error <= COARSE * size) {
            let (sum, Some(error)) = (sum.unwrap_or(D::zero()), D::uncertain(error)) else { break };
            return Ok(sum * step + error);
        }
        let is_hopeless = halvings.checked_sub(FEWEST_HALVINGS).and_then(|at| HOPEFUL.get(at as usize));
        if is_hopeless.is_some_and(|most| error > most * size) {
            break;
        }
        before = now;
    }
    Ok(unknown)
}

/// Adds a term, unless it is nothing beside the others.
fn add<D: Differentiable>(sum: &mut Option<D>, term: Option<D>, least: f64) {
    let Some(term) = term.filter(|term| term.re().abs() > least) else { return };
    *sum = Some(sum.map_or(term, |sum| sum + term));
}

/// The value and the known derivatives of a sum with this step.
fn known<D: Differentiable>(sum: Option<D>, step: f64) -> Vec<f64> {
    let mut all = Vec::new();
    let mut next = sum;
    while let Some(number) = next {
        all.push(number.re() * step);
        next = number.rate();
    }
    all
}

/// The place x(t), and x′(t).
fn place<D: Differentiable>(ends: (Option<D>, Option<D>), t: f64) -> (D, D) {
    use std::f64::consts::{FRAC_PI_2, PI};
    let exponential = (FRAC_PI_2 * t.sinh()).exp();
    let slope = FRAC_PI_2 * t.cosh();
    match ends {
        (Some(a), Some(b)) => {
            // From the nearer end: so the distance to it is exact.
            let q = (-PI * t.abs().sinh()).exp();
            let share = (b - a) * (q / (1.0 + q));
            let x = if t < 0.0 { a + share } else { b - share };
            (x, (b - a) * (PI * t.cosh() * q / ((1.0 + q) * (1.0 + q))))
        }
        (Some(a), None) => (a + exponential, D::from(slope * exponential)),
        (None, Some(b)) => (b - exponential, D::from(slope * exponential)),
        (None, None) => {
            let inverse = exponential.recip();
            (D::from((exponential - inverse) / 2.0), D::from(slope * (exponential + inverse) / 2.0))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::RunningError;
    use std::f64::consts::PI;

    fn of(ends: (Option<f64>, Option<f64>), f: impl Fn(RunningError) -> RunningError) -> Option<RunningError> {
        let ends = (ends.0.map(RunningError::new), ends.1.map(RunningError::new));
        integral(ends, &mut |x| Ok(f(x))).ok().filter(|found| !found.is_unknown())
    }

    fn one() -> RunningError {
        RunningError::new(1.0)
    }

    #[test]
    fn integrals_have_their_values() {
        use num_dual::DualNum;
        let cases = [
            (of((Some(0.0), None), |x| x.powi(3) / (x.exp() - 1.0)), PI.powi(4) / 15.0),
            (of((Some(0.0), None), |x| (x * x).exp().recip()), PI.sqrt() / 2.0),
            (of((None, None), |x| one() / (x.powi(4) + 1.0)), PI / 2f64.sqrt()),
            (of((Some(1.0), Some(0.0)), |x| x.sqrt()), -2.0 / 3.0),
            (of((None, Some(0.0)), |x| x.exp() * x), -1.0),
            (of((Some(0.0), Some(1.0)), |x| x.ln()), -1.0),
            (of((Some(0.0), Some(PI)), |x| one() / (x.cos() + 2.0)), PI / 3f64.sqrt()),
        ];
        for (found, value) in cases {
            let found = found.expect("a value");
            assert!((found.value - value).abs() < 1e-11 * value.abs(), "{found} {value}");
            // The error that the value carries covers the true one, and hides nothing that can be seen.
            assert!((found.value - value).abs() <= 8.0 * f64::EPSILON * found.magnitude, "{found} {value}");
            assert!(found.magnitude < 1e5 * value.abs(), "{found} {value}");
        }
    }

    #[test]
    fn what_has_no_value_is_unknown() {
        use num_dual::DualNum;
        // must-fail cases: a pole at an end, one inside, no decay, an oscillation that does not decay, a principal value
        assert!(of((Some(0.0), Some(1.0)), |x| one() / x).is_none());
        assert!(of((Some(-1.0), Some(2.0)), |x| one() / x).is_none());
        assert!(of((Some(-1.0), Some(1.0)), |x| one() / x).is_none());
        assert!(of((Some(-1.0), Some(2.0)), |x| (x * x).recip()).is_none());
        assert!(of((Some(0.0), None), |x| one() / (x + 1.0)).is_none());
        assert!(of((Some(0.0), None), |x| x.sin()).is_none());
        assert!(of((Some(0.0), None), |x| x.sin() / x).is_none());
        assert!(of((None, None), |x| x.cos()).is_none());
    }

    #[test]
    fn exact_numbers_have_no_quadrature() {
        use crate::scalar::Primal;
        use crate::scalar::enclosure::{Enclosure, evaluate_to};
        use num_dual::DualNum;
        let place = |x: f64| Some(Primal(Enclosure::exact(x)));
        let found = evaluate_to(100, 10_000, || integral((place(0.0), place(1.0)), &mut |x| Ok(x.exp())).is_ok());
        assert!(!found);
    }
}
