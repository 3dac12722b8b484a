//! Newton's method for gradient(x) = target, with the exact Hessian.

use nalgebra::DMatrix;

use super::linear_solver;
use crate::scalar::{Number, each, up_to};
use crate::{Error, Result};

/// Solves gradient(x) = target by Newton's method with the exact Hessian, damped while the residual does not shrink.
pub(super) fn invert<D: Number>(
    what: &str,
    start: Vec<D>,
    target: &[D],
    gradient: impl Fn(&[D]) -> Result<(Vec<D>, DMatrix<D>)>,
) -> Result<Vec<D>> {
    const STEPS: usize = 60;
    let nothing = || {
        Error::new("the Legendre transform found no solution: Newton's method did not converge")
            .help("choose momenta that are values of ∂L/∂q̇, and coordinates where the mass matrix is invertible")
    };
    let residual = |g: &[D]| up_to(g.len().min(target.len()), &mut |i| target[i] - g[i]);
    let size = |r: &[D]| each(r, &|r| r.re() * r.re()).into_iter().sum::<f64>();
    let mut x = start;
    let (mut slope, mut hessian) = gradient(&x)?;
    // once the value has converged, every step doubles the order to which its derivatives are right
    let mut polish = usize::BITS - D::NDERIV.leading_zeros();
    for _ in 0..STEPS {
        let left = residual(&slope);
        let step = linear_solver::solve(what, hessian.clone(), left.clone())?;
        let mut share = 1.0;
        let before = size(&left);
        let moved = loop {
            let trial = up_to(x.len().min(step.len()), &mut |i| x[i] + step[i] * share);
            let (g, h) = gradient(&trial)?;
            let after = size(&residual(&g));
            let (scale, tiny) = (size(&g) + size(target), f64::EPSILON * 16.0);
            if after <= scale * tiny * tiny {
                (x, slope, hessian) = (trial, g, h);
                if polish == 0 {
                    return Ok(x);
                }
                polish -= 1;
                break true;
            }
            if after < before {
                (x, slope, hessian) = (trial, g, h);
                break true;
            }
            share *= 0.5;
            if share < 1e-12 {
                break false;
            }
        };
        if !moved {
            // the last digits may never settle: what is left is rounding, or it is no solution
            return if before.sqrt() <= 1e-11 * (size(&slope) + size(target)).sqrt() { Ok(x) } else { Err(nothing()) };
        }
    }
    Err(nothing())
}
