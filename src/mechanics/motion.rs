//! Along a motion: the time derivative of any function of the state, and the motion itself as a Taylor series.

use num_dual::{Dual, DualNum};

use super::euler_lagrange::accelerations;
use super::{Lagrangian, State};
use crate::scalar::{Number, Series, TERMS, each, up_to};
use crate::{Error, Result};

/// A function of the state over any number: a momentum, an energy, a quantity whose conservation is to be tested.
pub trait Observable<const N: usize, const P: usize> {
    /// Its value.
    fn value<D: Number>(&self, at: &State<D, N, P>) -> D;
}

/// d/dt of `f` at `at` with the given accelerations: off shell they are arbitrary.
pub fn time_derivative<F, D, const N: usize, const P: usize>(f: &F, at: &State<D, N, P>, accelerations: &[D; N]) -> D
where
    F: Observable<N, P>,
    D: Number,
{
    let mut along = at.moving();
    for (v, &a) in along.v.iter_mut().zip(accelerations) {
        v.eps = a;
    }
    let value: Dual<D> = f.value(&along);
    value.eps
}

/// d/dt of `f` along the motion that obeys the Euler–Lagrange equations of `l`.
///
/// # Errors
/// When the mass matrix is singular.
pub fn time_derivative_on_shell<L, F, D, const N: usize, const P: usize>(l: &L, f: &F, at: &State<D, N, P>) -> Result<D>
where
    L: Lagrangian<N, P>,
    F: Observable<N, P>,
    D: Number,
{
    Ok(time_derivative(f, at, &accelerations(l, at)?))
}

/// The motion through `at` on shell: each coordinate with its time derivatives up to `order`.
///
/// # Errors
/// When the mass matrix is singular, or `order` is beyond what a [`Series`] holds.
pub fn motion<L, D, const N: usize, const P: usize>(l: &L, at: &State<D, N, P>, order: usize) -> Result<[Series<D>; N]>
where
    L: Lagrangian<N, P>,
    D: Number,
{
    let q = complete(&at.q, &at.v, order, |q, v, _| {
        let state = State {
            time: Series::time(at.time),
            q: std::array::from_fn(|i| q[i]),
            v: std::array::from_fn(|i| v[i]),
            parameters: at.parameters.map(Series::from_re),
        };
        Ok(accelerations(l, &state)?.to_vec())
    })?;
    Ok(std::array::from_fn(|i| q[i]))
}

/// Taylor's recursion: what is known of q and q̇ gives one more order of q̈, hence of q, until `order` is reached. The
/// accelerations are told how many derivatives of q are known; their values are always the same.
pub(super) fn complete<D: Number>(
    q: &[D],
    v: &[D],
    order: usize,
    accelerations: impl Fn(&[Series<D>], &[Series<D>], usize) -> Result<Vec<Series<D>>>,
) -> Result<Vec<Series<D>>> {
    if order >= TERMS {
        let most = TERMS - 1;
        return Err(Error::new(format!("time derivatives of order {order} are not supported"))
            .help(format!("use time derivatives up to order {most}")));
    }
    let mut derivatives: Vec<Vec<D>> = up_to(q.len().min(v.len()), &mut |i| vec![q[i], v[i]]);
    for known in 2..=order {
        let q = each(&derivatives, &|known| Series::from_derivatives(known));
        let v = each(&q, &Series::derivative);
        // q̈ can be known to one order less than q̇: spare the rest
        let q = each(&q, &|q| q.truncated(known - 1));
        for (known_so_far, a) in derivatives.iter_mut().zip(accelerations(&q, &v, known)?) {
            known_so_far.push(a.nth_derivative_value(known - 2).unwrap_or(D::from(f64::NAN)));
        }
    }
    Ok(each(&derivatives, &|known| Series::from_derivatives(&known[..=order])))
}
