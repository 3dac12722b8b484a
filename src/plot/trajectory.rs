//! Motions of a traced system, integrated with error control.

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use num_dual::Dual;

use crate::formula::text::number;
use crate::mechanics::System;
use crate::{Error, Result};

/// The relative tolerance of an integration.
pub const TOLERANCE: f64 = 1e-11;

/// A state of a motion.
#[derive(Clone, Debug)]
pub struct Moment {
    /// The time.
    pub time: f64,
    /// The coordinates.
    pub q: Vec<f64>,
    /// The velocities.
    pub v: Vec<f64>,
}

struct Motion<'a> {
    system: &'a System,
    parameters: &'a [f64],
}

impl ODE<f64, Vec<f64>> for Motion<'_> {
    fn diff(&self, t: f64, y: &Vec<f64>, rate: &mut Vec<f64>) {
        let (q, v) = y.split_at(y.len() / 2);
        // where there are no accelerations, the step is not finite and is refused
        let a = self.system.accelerations(t, q, v, self.parameters).unwrap_or_else(|_| vec![f64::NAN; q.len()]);
        rate.clear();
        rate.extend(v.iter().chain(&a));
    }
}

/// The motion from a state, at even times from 0 to `end`.
///
/// # Errors
/// When the integration ends before, as at a collision.
pub fn motion(
    system: &System,
    start: (&[f64], &[f64]),
    parameters: &[f64],
    end: f64,
    tolerance: f64,
) -> Result<Vec<Moment>> {
    const POINTS: u32 = 600;
    let motion = Motion { system, parameters };
    let n = start.0.len();
    let lost = |(time, last): Timed| {
        let (q, v) = last.split_at(n);
        // At a place without accelerations the cause is known; otherwise the steps became too small or too many.
        let cause = match system.accelerations(time, q, v, parameters) {
            Err(error) => error.message().to_owned(),
            Ok(rates) if rates.iter().any(|rate| !rate.is_finite()) => {
                "the accelerations are not finite at this time".to_owned()
            }
            Ok(_) => "the numerical error of a step stayed too large".to_owned(),
        };
        Error::new(format!("the integration stopped at t = {}: {cause}", number(time, 4)))
            .help("choose another starting state with --set, or a shorter time with --until")
    };
    let states = integrated(&motion, [start.0, start.1].concat(), end, POINTS, tolerance).map_err(lost)?;
    let moment = |(time, y): Timed| Moment { time, q: y[..n].to_vec(), v: y[n..].to_vec() };
    Ok(states.into_iter().map(moment).collect())
}

/// A time, and the coordinates and their rates at it.
type Timed = (f64, Vec<f64>);

/// The states at even times. Each stretch ends where a step ends, since what is interpolated between steps is less
/// accurate than the steps.
///
/// # Errors
/// The last time and state, if the integration ends before.
fn integrated<E: ODE<f64, Vec<f64>>>(
    equation: &E,
    start: Vec<f64>,
    end: f64,
    points: u32,
    tolerance: f64,
) -> Result<Vec<Timed>, Timed> {
    let time = |k: u32| end * f64::from(k) / f64::from(points);
    let mut states = vec![(0.0, start)];
    for k in 0..points {
        let (from, state) = states[states.len() - 1].clone();
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
        let solution = IVP::ode(equation, from, time(k + 1), state.clone()).method(method).solve();
        let last = solution.ok().and_then(|solution| solution.y.last().cloned());
        match last.filter(|last| last.iter().all(|x| x.is_finite())) {
            Some(last) => states.push((time(k + 1), last)),
            None => return Err((from, state)),
        }
    }
    Ok(states)
}

/// ω along the axes of a free body, from a value on, at even times.
struct Turning<'a> {
    system: &'a System,
    parameters: &'a [f64],
    /// Takes ω along the body to the rates of the angles.
    rates: nalgebra::Matrix3<f64>,
}

/// An orientation at which the angles of a body are sound.
const SOUND: [f64; 3] = [0.0, std::f64::consts::FRAC_PI_2, 0.3];

impl<'a> Turning<'a> {
    fn new(system: &'a System, parameters: &'a [f64]) -> Option<Turning<'a>> {
        let mut columns = nalgebra::Matrix3::zeros();
        for i in 0..3 {
            let mut unit = [0.0; 3];
            unit[i] = 1.0;
            columns.set_column(i, &system.quantities(0.0, &SOUND, &unit, parameters).body_rates?);
        }
        Some(Turning { system, parameters, rates: columns.try_inverse()? })
    }

    /// The rate of ω: the body is looked at in an orientation at which its angles are sound.
    fn rate(&self, omega: &[f64]) -> Option<[f64; 3]> {
        let v = self.rates * nalgebra::Vector3::from_row_slice(omega);
        let a = self.system.accelerations(0.0, &SOUND, v.as_slice(), self.parameters).ok()?;
        let moving = |x: &[f64], rate: &[f64]| x.iter().zip(rate).map(|(&x, &r)| Dual::new(x, r)).collect::<Vec<_>>();
        let still = |x: &[f64]| x.iter().map(|&x| Dual::from_re(x)).collect::<Vec<_>>();
        let (q, v, p) = (moving(&SOUND, v.as_slice()), moving(v.as_slice(), &a), still(self.parameters));
        let along = self.system.quantities(Dual::from_re(0.0), &q, &v, &p).body_rates?;
        Some([along[0].eps, along[1].eps, along[2].eps])
    }
}

impl ODE<f64, Vec<f64>> for Turning<'_> {
    fn diff(&self, _: f64, y: &Vec<f64>, rate: &mut Vec<f64>) {
        rate.clear();
        rate.extend(self.rate(y).unwrap_or([f64::NAN; 3]));
    }
}

/// The angular velocity along the axes of a body without torque, from a value on.
///
/// # Errors
/// When the system has no orientation, or the integration ends before.
pub fn polhode(system: &System, parameters: &[f64], omega: [f64; 3], end: f64) -> Result<Vec<[f64; 3]>> {
    let lost = || {
        Error::new("the angular velocity cannot be integrated to the end")
            .help("this picture is drawn for free_rigid_body; choose other values with --set")
    };
    let turning = Turning::new(system, parameters).ok_or_else(lost)?;
    let states = integrated(&turning, omega.to_vec(), end, 160, 1e-9).map_err(|_| lost())?;
    Ok(states.iter().map(|(_, y)| [y[0], y[1], y[2]]).collect())
}
